//! What grows from a Hopf point: the first Lyapunov coefficient, and the amplitude of the cycles next to it.
//!
//! On the plane of the critical mode the motion is ż = (σ + iω) z + c₁ z |z|² + …, and u = u_e + z q + c. c. A cycle has
//! |z|² = −σ/Re c₁. With Re c₁ < 0 it lives where steady sliding is unstable and is stable itself (supercritical); with
//! Re c₁ > 0 it lives beside stable steady sliding, unstable, and bounds the disturbances that this survives (subcritical).
//!
//! Y. A. Kuznetsov, *Elements of Applied Bifurcation Theory*, 3rd ed., section 5.4, eq. (5.39).

use crate::cycle::CycleError;
use crate::motion::{ContactState, SlidingSystem};
use judder_numerics::dense::{Triangles, eigenvalues};
use judder_numerics::piecewise::tangent::SquareMatrix;
use num_complex::Complex64;
use std::array::from_fn;

type ComplexVector<const N: usize> = [Complex64; N];

/// The critical mode of steady sliding and what the nonlinear terms do to it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HopfPoint<const N: usize> {
    /// σ, the growth rate: zero at the Hopf point itself.
    pub growth_rate: f64,
    /// ω, per unit of the oscillator's time.
    pub frequency: f64,
    /// Re c₁ for a mode with |q_x| = 1: the growth rate per squared |z|.
    pub coefficient: f64,
    /// q, with q_x = 1 where the mode moves along x.
    pub mode: ComplexVector<N>,
}

impl<const N: usize> HopfPoint<N> {
    /// Whether the cycles next to it are unstable and live beside stable steady sliding.
    #[must_use]
    pub fn is_subcritical(&self) -> bool {
        self.coefficient > 0.0
    }

    /// Whether terms up to the third order say nothing of the cycles next to it, as on a straight piece of a friction table.
    #[must_use]
    pub fn is_degenerate(&self) -> bool {
        self.coefficient == 0.0
    }

    /// The rms of x on the cycle that the amplitude law √(−2σ/Re c₁) predicts for a growth rate of steady sliding near
    /// the point; `None` where there is none.
    #[must_use]
    pub fn rms(&self, growth_rate: f64) -> Option<f64> {
        let squared = -2.0 * growth_rate / self.coefficient;
        (squared >= 0.0 && !self.is_degenerate()).then(|| squared.sqrt())
    }

    /// d(rms²)/dp = −2σ′/Re c₁: near a threshold p_c the cycles have an rms of x of √(factor·(p − p_c)). Positive where they
    /// live above the threshold, negative where below. `growth_slope` is σ′ = dσ/dp.
    #[must_use]
    pub fn amplitude_factor(&self, growth_slope: f64) -> f64 {
        -2.0 * growth_slope / self.coefficient
    }

    /// The state u_e + z q + c. c. on a cycle of a given rms of x, where x is largest.
    #[must_use]
    pub fn state_on_cycle(&self, steady_sliding: &[f64; N], rms: f64) -> [f64; N] {
        // x = 2|z| cos φ with an rms of √2 |z|, and x' = 0 at φ = 0 to first order
        let z = rms / std::f64::consts::SQRT_2;
        from_fn(|i| if i == N / 2 { 0.0 } else { steady_sliding[i] + 2.0 * z * self.mode[i].re })
    }
}

/// The Hopf point of an oscillator whose steady sliding is about to change its stability.
///
/// The second and third derivatives of the field are differences, extrapolated, of its exact Jacobian; a computed law has
/// continuous second derivatives only, and its coefficient is as good as its table.
///
/// # Errors
/// Eigenvalues that did not come out, or a critical mode that does not oscillate ([`CycleError::Singular`]).
pub fn hopf_point<const N: usize>(system: &impl SlidingSystem<N>) -> Result<HopfPoint<N>, CycleError> {
    let scales = system.scales();
    let place = system.steady_sliding();
    let mode = system.mode(ContactState::SlipBehind, &place);
    // in scaled components, so that one difference fits all
    let jacobian = |moved: &[f64; N]| -> SquareMatrix<N> {
        let state = from_fn(|i| place[i] + scales[i] * moved[i]);
        let raw = system.jacobian(mode, &state);
        from_fn(|i| from_fn(|j| raw[i][j] * scales[j] / scales[i]))
    };
    let matrix = jacobian(&[0.0; N]);
    let critical = eigenvalues(&matrix)?
        .into_iter()
        .filter(|value| value.im > 0.0)
        .max_by(|a, b| a.re.total_cmp(&b.re))
        .ok_or(CycleError::Singular)?;
    let frequency = critical.im;
    let mode = null_vector(&matrix, critical)?;
    let transposed: SquareMatrix<N> = from_fn(|i| from_fn(|j| matrix[j][i]));
    let left = null_vector(&transposed, critical)?;
    let mode = mode.map(|q| q / mode[0]);
    let cubic = cubic_coefficient(&jacobian, &matrix, frequency, &mode, &left)?;
    // from scaled components to those of the state: |q_x| = 1 there too
    Ok(HopfPoint {
        growth_rate: critical.re,
        frequency,
        coefficient: cubic.re / (scales[0] * scales[0]),
        mode: from_fn(|i| mode[i] * scales[i] / scales[0]),
    })
}

/// σ, the largest real part of the eigenvalues of steady sliding, per unit of the oscillator's time.
///
/// # Errors
/// Eigenvalues that did not come out.
pub fn growth_rate<const N: usize>(system: &impl SlidingSystem<N>) -> Result<f64, CycleError> {
    let scales = system.scales();
    let place = system.steady_sliding();
    let raw = system.jacobian(system.mode(ContactState::SlipBehind, &place), &place);
    let scaled: SquareMatrix<N> = from_fn(|i| from_fn(|j| raw[i][j] * scales[j] / scales[i]));
    Ok(eigenvalues(&scaled)?.iter().fold(f64::NEG_INFINITY, |largest, value| largest.max(value.re)))
}

/// σ′ = dσ/dp of a growth rate that is known as a function of the parameter p, at a threshold.
///
/// Central differences over ever shorter steps, from a thousandth of `scale` on: of the two neighbours that agree best the
/// shorter one counts, for a growth rate can bend sharply where two modes meet. `None` where it is not known on both sides.
#[must_use]
pub fn growth_slope(growth_rate_at: impl Fn(f64) -> Option<f64>, threshold: f64, scale: f64) -> Option<f64> {
    const STEPS: [f64; 5] = [1e-3, 1e-4, 1e-5, 1e-6, 1e-7];
    let slope = |step: &f64| {
        let step = step * scale;
        Some((growth_rate_at(threshold + step)? - growth_rate_at(threshold - step)?) / (2.0 * step))
    };
    let slopes: Vec<f64> = STEPS.iter().filter_map(slope).collect();
    let apart = |pair: &[f64]| (pair[0] - pair[1]).abs() / (pair[0].abs() + pair[1].abs());
    slopes.windows(2).min_by(|a, b| apart(a).total_cmp(&apart(b))).map(|pair| pair[1])
}

/// c₁ = ½ ⟨p, C(q, q, q̄) − 2 B(q, A⁻¹ B(q, q̄)) + B(q̄, (2iω − A)⁻¹ B(q, q))⟩/⟨p, q⟩, with pᵀ for the left vector.
fn cubic_coefficient<const N: usize>(
    jacobian: &impl Fn(&[f64; N]) -> SquareMatrix<N>,
    matrix: &SquareMatrix<N>,
    frequency: f64,
    mode: &ComplexVector<N>,
    left: &ComplexVector<N>,
) -> Result<Complex64, CycleError> {
    let (real, imaginary) = (mode.map(|q| q.re), mode.map(|q| q.im));
    let (first_real, second_real) = directional_derivatives(jacobian, matrix, &real);
    let (first_imaginary, second_imaginary) = directional_derivatives(jacobian, matrix, &imaginary);
    // B(q, ·) and B(q̄, ·)
    let second_order = |sign: f64, v: &ComplexVector<N>| -> ComplexVector<N> {
        from_fn(|i| {
            (0..N).map(|j| Complex64::new(first_real[i][j], sign * first_imaginary[i][j]) * v[j]).sum()
        })
    };
    // C(q, q̄, ·) = C(r, r, ·) + C(s, s, ·)
    let third_order: ComplexVector<N> =
        from_fn(|i| (0..N).map(|j| (second_real[i][j] + second_imaginary[i][j]) * mode[j]).sum());
    let conjugate = mode.map(|q| q.conj());
    let mean_shift = solve(matrix, Complex64::ZERO, &second_order(1.0, &conjugate))?;
    // (A − 2iω)⁻¹ is minus the inverse in the formula
    let second_harmonic =
        solve(matrix, Complex64::new(0.0, 2.0 * frequency), &second_order(1.0, mode))?.map(|v| -v);
    let shift = second_order(1.0, &mean_shift);
    let harmonic = second_order(-1.0, &second_harmonic);
    let (projected, norm) = (0..N).fold((Complex64::ZERO, Complex64::ZERO), |(sum, norm), i| {
        (sum + left[i] * (third_order[i] - 2.0 * shift[i] + harmonic[i]), norm + left[i] * mode[i])
    });
    Ok(0.5 * projected / norm)
}

/// First and second derivative of the Jacobian along a real direction, by central differences extrapolated twice.
fn directional_derivatives<const N: usize>(
    jacobian: &impl Fn(&[f64; N]) -> SquareMatrix<N>,
    here: &SquareMatrix<N>,
    direction: &[f64; N],
) -> (SquareMatrix<N>, SquareMatrix<N>) {
    /// Of the scales: a few thousandths move the law smoothly and keep nine digits of its differences.
    const WIDEST: f64 = 8e-3;
    let size = direction.iter().fold(0.0, |largest: f64, d| largest.max(d.abs()));
    if size == 0.0 {
        return ([[0.0; N]; N], [[0.0; N]; N]);
    }
    let at = |width: f64| {
        let width = width / size;
        let above = jacobian(&direction.map(|d| width * d));
        let below = jacobian(&direction.map(|d| -width * d));
        let first: SquareMatrix<N> = from_fn(|i| from_fn(|j| (above[i][j] - below[i][j]) / (2.0 * width)));
        let second: SquareMatrix<N> =
            from_fn(|i| from_fn(|j| (above[i][j] - 2.0 * here[i][j] + below[i][j]) / (width * width)));
        (first, second)
    };
    let [wide, middle, narrow] = [at(WIDEST), at(0.5 * WIDEST), at(0.25 * WIDEST)];
    let extrapolate = |wide: f64, middle: f64, narrow: f64| {
        let (coarse, fine) = ((4.0 * middle - wide) / 3.0, (4.0 * narrow - middle) / 3.0);
        (16.0 * fine - coarse) / 15.0
    };
    (
        from_fn(|i| from_fn(|j| extrapolate(wide.0[i][j], middle.0[i][j], narrow.0[i][j]))),
        from_fn(|i| from_fn(|j| extrapolate(wide.1[i][j], middle.1[i][j], narrow.1[i][j]))),
    )
}

/// The solution of (A − λ) v = right.
fn solve<const N: usize>(
    matrix: &SquareMatrix<N>,
    shift: Complex64,
    right: &ComplexVector<N>,
) -> Result<ComplexVector<N>, CycleError> {
    let size = 2 * N;
    let entries = (0..size * size)
        .map(|k| {
            let (row, column) = (k / size, k % size);
            let is_diagonal = row % N == column % N;
            match (row / N, column / N) {
                (0, 1) => {
                    if is_diagonal {
                        shift.im
                    } else {
                        0.0
                    }
                }
                (1, 0) => {
                    if is_diagonal {
                        -shift.im
                    } else {
                        0.0
                    }
                }
                _ => matrix[row % N][column % N] - if is_diagonal { shift.re } else { 0.0 },
            }
        })
        .collect();
    let triangles = Triangles::new(size, entries).ok_or(CycleError::Singular)?;
    let mut solution: Vec<f64> = right.iter().map(|v| v.re).chain(right.iter().map(|v| v.im)).collect();
    triangles.solve(&mut solution);
    Ok(from_fn(|i| Complex64::new(solution[i], solution[N + i])))
}

/// The vector that A − λ nearly annihilates, by inverse iteration.
fn null_vector<const N: usize>(
    matrix: &SquareMatrix<N>,
    eigenvalue: Complex64,
) -> Result<ComplexVector<N>, CycleError> {
    let beside = eigenvalue * (1.0 + 1e-9) + 1e-12;
    let mut vector: ComplexVector<N> = from_fn(|i| Complex64::new(1.0, 0.1 * i as f64));
    for _ in 0..4 {
        vector = solve(matrix, beside, &vector)?;
        let length = vector.iter().fold(0.0, |sum, v| sum + v.norm_sqr()).sqrt();
        vector = vector.map(|v| v / length);
    }
    Ok(vector)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::{BeltOscillator, FallingFriction};

    #[test]
    fn the_belts_coefficient_is_that_of_averaging() {
        // ẍ + x = ε with ε = −2ξẋ + N μ(v − ẋ) about rest: averaging gives ż = σz + (N μ'''/16)·… of the odd part of μ(v − ẋ)
        let (fall, decay, velocity) = (0.5, 0.5, 0.5 * 10.0_f64.ln());
        let belt = BeltOscillator::new(0.05, 1.0, velocity, FallingFriction::exponential([1.0, 0.5], decay))
            .unwrap();
        let hopf = hopf_point(&belt).unwrap();
        assert!(hopf.growth_rate.abs() < 1e-15 && (hopf.frequency - 1.0).abs() < 1e-14);
        // for ẍ + x = a ẋ + b ẋ² + c ẋ³ with a → 0: amplitude Ȧ = (3/8) c A³ (b alone gives none); c = fall e^{−v/v0}/(6 v0³)
        let cubic = fall * (-velocity / decay).exp() / (6.0 * decay.powi(3));
        // A = 2|z|: ż = Re c₁ |z|² z means Re c₁ = (3/2) c
        assert!(
            (hopf.coefficient / (1.5 * cubic) - 1.0).abs() < 1e-7,
            "{} {}",
            hopf.coefficient,
            1.5 * cubic
        );
        assert!(hopf.is_subcritical());
    }
}
