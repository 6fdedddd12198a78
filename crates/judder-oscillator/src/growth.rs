//! Which force feeds the growth: shares of the growth rate, and sensitivities.
//!
//! For an eigenvalue λ = σ + iω with right vector x, x̄ᵀ(λ² M + λ C + K) x = 0. Its imaginary part is the balance of work
//! per cycle along the mode. With m = x̄ᵀ M x (real, M symmetric) it reads
//!
//! 2 σ ω m + Im(λ x̄ᵀ C x) + Im(x̄ᵀ K x) = 0,
//!
//! so each entry feeds −Im(λ c_ij x̄_i x_j)/(2ωm) or −Im(k_ij x̄_i x_j)/(2ωm) into σ, and these sum to σ. A symmetric K feeds nothing
//! in sum. For a real eigenvalue the imaginary part is empty; there the power balance λ = −(x̄ᵀCx + x̄ᵀKx/λ)/m is shared out.

use crate::linear_system::LinearSystem;
use crate::spectrum::EigenMode;
use num_complex::Complex64;

/// What each matrix entry adds to the growth rate of a mode; all entries together sum to it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EntryShares {
    /// By the entries of C.
    pub damping: [[f64; 2]; 2],
    /// By the entries of K.
    pub stiffness: [[f64; 2]; 2],
}

impl EntryShares {
    /// The sum of all shares: the growth rate σ of the mode.
    #[must_use]
    pub fn sum(&self) -> f64 {
        self.damping.iter().chain(&self.stiffness).flatten().sum()
    }
}

/// ∂λ by the entries of C and K.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sensitivities {
    /// ∂λ/∂c_ij.
    pub damping: [[Complex64; 2]; 2],
    /// ∂λ/∂k_ij.
    pub stiffness: [[Complex64; 2]; 2],
}

/// A 2×2 array from its entries.
fn entries<T>(entry: impl Fn(usize, usize) -> T) -> [[T; 2]; 2] {
    std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))
}

/// Σ_ij a_ij u_i v_j.
fn form(a: &[[f64; 2]; 2], u: &[Complex64; 2], v: &[Complex64; 2]) -> Complex64 {
    (0..2).flat_map(|i| (0..2).map(move |j| (i, j))).map(|(i, j)| u[i] * v[j] * a[i][j]).sum()
}

/// The shares of the growth rate (see the module's text for the equation).
#[must_use]
pub fn growth_shares(system: &LinearSystem, mode: &EigenMode) -> EntryShares {
    let EigenMode { eigenvalue, right: x, .. } = mode;
    let conjugate = [x[0].conj(), x[1].conj()];
    let mass = form(&system.mass, &conjugate, x).re;
    let weight = |i: usize, j: usize| conjugate[i] * x[j];
    if eigenvalue.im == 0.0 {
        return EntryShares {
            damping: entries(|i, j| -system.damping[i][j] * weight(i, j).re / mass),
            stiffness: entries(|i, j| -system.stiffness[i][j] * weight(i, j).re / (mass * eigenvalue.re)),
        };
    }
    let scale = -1.0 / (2.0 * eigenvalue.im * mass);
    EntryShares {
        damping: entries(|i, j| scale * system.damping[i][j] * (eigenvalue * weight(i, j)).im),
        stiffness: entries(|i, j| scale * system.stiffness[i][j] * weight(i, j).im),
    }
}

/// ∂λ/∂c_ij = −λ y_i x_j/N and ∂λ/∂k_ij = −y_i x_j/N with N = yᵀ(2λM + C)x; infinite where eigenvalues coincide.
#[must_use]
pub fn sensitivities(system: &LinearSystem, mode: &EigenMode) -> Sensitivities {
    let EigenMode { eigenvalue, right: x, left: y } = mode;
    let norm = 2.0 * eigenvalue * form(&system.mass, y, x) + form(&system.damping, y, x);
    Sensitivities {
        damping: entries(|i, j| -eigenvalue * y[i] * x[j] / norm),
        stiffness: entries(|i, j| -y[i] * x[j] / norm),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spectrum::{eigenvalues, leading, mode};
    use proptest::prelude::*;

    fn any_system() -> impl Strategy<Value = LinearSystem> {
        let entry = -2.0..2.0_f64;
        prop::array::uniform8(entry).prop_map(|e| LinearSystem {
            mass: [[1.5, 0.2], [0.2, 1.0]],
            damping: [[e[0], e[1]], [e[2], e[3]]],
            stiffness: [[3.0 + e[4], e[5]], [e[6], 3.0 + e[7]]],
        })
    }

    proptest! {
        #[test]
        fn shares_sum_to_the_growth_rate(system in any_system()) {
            for value in eigenvalues(&system.reduced().unwrap()).unwrap() {
                // near a double real root the imaginary part is rounding, and so are its shares
                prop_assume!(value.im == 0.0 || value.im.abs() > 1e-3);
                let shares = growth_shares(&system, &mode(&system, value));
                prop_assert!((shares.sum() - value.re).abs() < 1e-9, "{} against {}", shares.sum(), value.re);
            }
        }

        #[test]
        fn sensitivities_are_derivatives(system in any_system(), i in 0..2_usize, j in 0..2_usize) {
            let values = eigenvalues(&system.reduced().unwrap()).unwrap();
            let gap = |a: usize| (0..4).filter(|b| *b != a).map(|b| (values[a] - values[b]).norm()).fold(9.0, f64::min);
            prop_assume!((0..4).all(|a| gap(a) > 0.1));
            let value = leading(&values);
            let s = sensitivities(&system, &mode(&system, value));
            let step = 1e-6;
            let moved = |change: f64, damping: bool| {
                let mut other = system;
                if damping { other.damping[i][j] += change } else { other.stiffness[i][j] += change }
                let values = eigenvalues(&other.reduced().unwrap()).unwrap();
                values.into_iter().min_by(|a, b| (a - value).norm().total_cmp(&(b - value).norm())).unwrap()
            };
            for (damping, exact) in [(true, s.damping[i][j]), (false, s.stiffness[i][j])] {
                let slope = (moved(step, damping) - moved(-step, damping)) / (2.0 * step);
                prop_assert!((slope - exact).norm() < 1e-6 * (1.0 + exact.norm()), "{slope} against {exact}");
            }
        }
    }
}
