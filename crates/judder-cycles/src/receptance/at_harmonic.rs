//! Bodies under harmonic forces.

use super::{HarmonicBodies, HarmonicMatrices};
use crate::CyclesError;
use faer::{Mat, c64};
use judder_dense::general::solve_complex;
use judder_dense::product::product;
use judder_nonsmooth::bodies::FreeModes;

/// The bodies at one harmonic.
#[derive(Debug, Clone, Default)]
pub struct AtHarmonic {
    /// x of the coordinates.
    pub coordinates: Vec<c64>,
    /// y = Γ λ + R D⁻¹ f.
    pub motion: Vec<c64>,
}

/// How the bodies follow from forces, s and σ at one harmonic.
#[derive(Debug, Clone)]
pub struct HarmonicSlopes {
    /// Γ.
    pub receptance: Mat<c64>,
    /// ∂y/∂s.
    pub by_s: Vec<c64>,
    /// ∂y/∂σ.
    pub by_growth: Vec<c64>,
}

impl HarmonicBodies {
    /// Γ(s) with the growth σ taken off.
    ///
    /// # Errors
    /// [`CyclesError::Singular`] at an undamped resonance.
    pub fn receptance(&self, s: c64, growth: f64) -> Result<Mat<c64>, CyclesError> {
        self.seen_of(s, &self.yielding(s, growth, Vec::new())?, self.components())
    }

    /// D⁻¹ Pᵀ, and beside it D⁻¹ of further columns: real and imaginary parts.
    fn yielding(&self, s: c64, growth: f64, further: Vec<Vec<c64>>) -> Result<[Mat<f64>; 2], CyclesError> {
        let (size, coordinates) = (self.rows.nrows(), self.rows.ncols());
        let acting = |k: usize, column: usize| match column.checked_sub(size) {
            None => c64::new(self.rows[(column, k)], 0.0),
            Some(own) => further[own][k],
        };
        let columns = size + further.len();
        let parts = |of: &dyn Fn(usize, usize) -> c64| {
            let mut parts = [Mat::zeros(coordinates, columns), Mat::zeros(coordinates, columns)];
            for column in 0..columns {
                for k in 0..coordinates {
                    let own = of(k, column);
                    (parts[0][(k, column)], parts[1][(k, column)]) = (own.re, own.im);
                }
            }
            parts
        };
        Ok(match self.kind.as_ref() {
            HarmonicMatrices::Modes(modes) => {
                let weights: Vec<c64> = (0..coordinates).map(|k| yielding(modes, k, s, growth)).collect();
                parts(&|k, column| weights[k] * acting(k, column))
            }
            HarmonicMatrices::Whole(matrices) => {
                let mut right = Mat::from_fn(coordinates, columns, acting);
                solve_complex(dynamic_stiffness(matrices, s, growth), &mut right)
                    .ok_or(CyclesError::Singular)?;
                parts(&|k, column| right[(k, column)])
            }
        })
    }

    /// y = R(s) x of the first columns of real and imaginary parts of x.
    fn seen_of(&self, s: c64, [re, im]: &[Mat<f64>; 2], columns: usize) -> Result<Mat<c64>, CyclesError> {
        let size = self.rows.nrows();
        let displaced = [re, im].map(|part| product(self.rows.as_ref(), part.subcols(0, columns)));
        let mut out = Mat::from_fn(size, columns, |i, j| {
            let value = c64::new(displaced[0][(i, j)], displaced[1][(i, j)]);
            if self.is_velocity(i) { s * value } else { value }
        });
        for (component, row) in &self.convected {
            for column in 0..columns {
                let of = |part: &Mat<f64>| -> f64 {
                    row.iter().zip(part.col_as_slice(column)).map(|(share, own)| share * own).sum()
                };
                out[(*component, column)] -= c64::new(of(re), of(im));
            }
        }
        if out.is_all_finite() { Ok(out) } else { Err(CyclesError::Singular) }
    }

    /// The bodies under forces λ at the points and `load` on the coordinates, at s with the growth σ taken off, in place of what they were.
    ///
    /// # Errors
    /// [`CyclesError::Singular`] at an undamped resonance.
    pub fn at(
        &self,
        s: c64,
        growth: f64,
        forces: &[c64],
        load: Option<&[c64]>,
        out: &mut AtHarmonic,
    ) -> Result<(), CyclesError> {
        let acting = |k: usize| {
            let own: c64 =
                forces.iter().zip(self.rows.col_as_slice(k)).map(|(force, share)| force * *share).sum();
            own + load.map_or(c64::ZERO, |load| load[k])
        };
        out.coordinates.clear();
        match self.kind.as_ref() {
            HarmonicMatrices::Modes(modes) => {
                let x = (0..self.coordinates()).map(|k| yielding(modes, k, s, growth) * acting(k));
                out.coordinates.extend(x);
            }
            HarmonicMatrices::Whole(matrices) => {
                let mut right = Mat::from_fn(self.coordinates(), 1, |k, _| acting(k));
                solve_complex(dynamic_stiffness(matrices, s, growth), &mut right)
                    .ok_or(CyclesError::Singular)?;
                out.coordinates.extend_from_slice(right.col_as_slice(0));
            }
        }
        self.seen_into(s, &out.coordinates, &mut out.motion);
        let finite = out.motion.iter().all(|own| own.re.is_finite() && own.im.is_finite());
        if finite { Ok(()) } else { Err(CyclesError::Singular) }
    }

    /// How bodies that move with x follow from the forces, s and σ.
    ///
    /// # Errors
    /// [`CyclesError::Singular`] at an undamped resonance.
    pub fn slopes(&self, s: c64, growth: f64, x: &[c64]) -> Result<HarmonicSlopes, CyclesError> {
        // −D′ x = −(2 s M + C + 2 σ M) x, and −2 s M x
        let acting = match self.kind.as_ref() {
            HarmonicMatrices::Modes(modes) => {
                let slope = |k: usize| -(2.0 * s + (modes.damping[k] + 2.0 * growth)) * x[k];
                vec![(0..x.len()).map(slope).collect(), x.iter().map(|own| -2.0 * s * own).collect()]
            }
            HarmonicMatrices::Whole(matrices) => {
                let [mass, damping, _] = matrices.as_ref();
                let times = |matrix: &Mat<f64>| -> Vec<c64> {
                    let of = |i: usize| x.iter().enumerate().map(|(j, own)| own * matrix[(i, j)]).sum();
                    (0..x.len()).map(of).collect()
                };
                let (by_mass, by_damping) = (times(mass), times(damping));
                let slope = |k: usize| -((2.0 * s + 2.0 * growth) * by_mass[k] + by_damping[k]);
                vec![(0..x.len()).map(slope).collect(), by_mass.iter().map(|own| -2.0 * s * own).collect()]
            }
        };
        let size = self.components();
        let yielding = self.yielding(s, growth, acting)?;
        let seen = self.seen_of(s, &yielding, size + 2)?;
        let mut by_s = seen.col_as_slice(size).to_vec();
        // R itself follows s
        for (component, own) in by_s.iter_mut().enumerate() {
            if self.is_velocity(component) {
                *own += self.displaced(component, x);
            }
        }
        let by_growth = seen.col_as_slice(size + 1).to_vec();
        Ok(HarmonicSlopes { receptance: seen.subcols(0, size).to_owned(), by_s, by_growth })
    }
}

/// 1/(s² + s (d + 2 σ) + λ) of a mode.
fn yielding(modes: &FreeModes, mode: usize, s: c64, growth: f64) -> c64 {
    (s * s + s * (modes.damping[mode] + 2.0 * growth) + modes.eigenvalues[mode]).inv()
}

/// s² M + s (C + 2 σ M) + K.
fn dynamic_stiffness([mass, damping, stiffness]: &[Mat<f64>; 3], s: c64, growth: f64) -> Mat<c64> {
    Mat::from_fn(mass.nrows(), mass.ncols(), |i, j| {
        (s * s + 2.0 * growth * s) * mass[(i, j)] + s * damping[(i, j)] + stiffness[(i, j)]
    })
}
