//! The three-field form with full matrices, and its two assemblies: the check of everything faster.
//!
//! J. Brunetti, W. D'Ambrogio, A. Fregolent (2020), equations (3) to (8):
//!
//! - M ü + C u̇ + K u = f + g, B_C u = 0, L_Eᵀ g = 0 are the three fields;
//! - g = −B_Eᵀ λ satisfies the equilibrium for any λ, as L_Eᵀ B_Eᵀ = 0: the dual form keeps λ;
//! - u = L_C v with B_C L_C = 0, weighed by L_Eᵀ, drops λ: the primal form L_Eᵀ (M, C, K) L_C.

use crate::SlidingError;
use crate::coupling::Coupling;
use faer::Mat;
use judder_dense::general::{real_eigenvalues, solve as solved_in_place};
use judder_numerics::order::{sort_by_number, sort_by_numbers};
use num_complex::Complex64;

/// The matrices of two structures, n × n, and the rows that couple them, 1 × n, in any coordinates.
#[derive(Debug, Clone, PartialEq)]
pub struct ThreeField {
    /// M.
    pub mass: Mat<f64>,
    /// C, with forces that follow velocities.
    pub damping: Mat<f64>,
    /// K, with forces that follow displacements.
    pub stiffness: Mat<f64>,
    /// B_C.
    pub compatibility: Mat<f64>,
    /// B_E.
    pub equilibrium: Mat<f64>,
}

impl ThreeField {
    /// In modal coordinates: M = I, C = diag(d) − Σ b r, K = diag(λ) − Σ b r, B_C = c, B_E = −eᵀ; λ in 1/s², d in 1/s.
    ///
    /// # Errors
    /// [`SlidingError::Length`] for lists that differ in length.
    pub fn new(coupling: &Coupling, eigenvalues: &[f64], damping: &[f64]) -> Result<Self, SlidingError> {
        crate::characteristic::check_sizes(coupling, eigenvalues, damping)?;
        let modes = eigenvalues.len();
        let followed = |i: usize, j: usize, follows_velocity: bool| -> f64 {
            let terms = coupling.feedback.iter().filter(|term| term.follows_velocity == follows_velocity);
            terms.map(|term| term.column[i] * term.row[j]).sum()
        };
        let matrix = |diagonal: &[f64], follows_velocity: bool| {
            Mat::from_fn(modes, modes, |i, j| {
                (if i == j { diagonal[i] } else { 0.0 }) - followed(i, j, follows_velocity)
            })
        };
        Ok(Self {
            mass: Mat::identity(modes, modes),
            damping: matrix(damping, true),
            stiffness: matrix(eigenvalues, false),
            compatibility: Mat::from_fn(1, modes, |_, j| coupling.compatibility[j]),
            equilibrium: Mat::from_fn(1, modes, |_, j| -coupling.equilibrium[j]),
        })
    }

    /// The same in other coordinates v with u = T v, T being n × n.
    #[must_use]
    pub fn transformed(&self, basis: &Mat<f64>) -> Self {
        let turned = |matrix: &Mat<f64>| basis.transpose() * matrix * basis;
        Self {
            mass: turned(&self.mass),
            damping: turned(&self.damping),
            stiffness: turned(&self.stiffness),
            compatibility: &self.compatibility * basis,
            equilibrium: &self.equilibrium * basis,
        }
    }

    /// L_C, n × (n − 1): an orthonormal basis of all compatible displacements, B_C L_C = 0.
    #[must_use]
    pub fn compatible_basis(&self) -> Mat<f64> {
        null_space(&self.compatibility)
    }

    /// L_E, n × (n − 1): an orthonormal basis with L_Eᵀ B_Eᵀ = 0.
    #[must_use]
    pub fn equilibrium_basis(&self) -> Mat<f64> {
        null_space(&self.equilibrium)
    }

    /// The eigenvalues of the primal form, by imaginary, then real part; those near `shift` (real, 1/s) come out best.
    ///
    /// # Errors
    /// [`SlidingError::DenseFailure`] where a matrix is singular at the shift or the iteration does not end.
    pub fn primal_spectrum(&self, shift: f64) -> Result<Vec<Complex64>, SlidingError> {
        let (left, right) = (self.equilibrium_basis(), self.compatible_basis());
        let project = |matrix: &Mat<f64>| left.transpose() * matrix * &right;
        let [mass, damping, stiffness] = [&self.mass, &self.damping, &self.stiffness].map(project);
        let (stiffness, damping) = shifted(&mass, &damping, &stiffness, shift);
        let size = mass.nrows();
        let by_mass = solve(stiffness.clone(), mass)?;
        let by_damping = solve(stiffness, damping)?;
        spectrum_of_inverse(&by_mass, &by_damping, shift, 2 * size)
    }

    /// The eigenvalues of the dual form, likewise: the multiplier stays, as a row and a column beside K.
    ///
    /// # Errors
    /// [`SlidingError::DenseFailure`].
    pub fn dual_spectrum(&self, shift: f64) -> Result<Vec<Complex64>, SlidingError> {
        let size = self.mass.nrows();
        let (stiffness, damping) = shifted(&self.mass, &self.damping, &self.stiffness, shift);
        let bordered = Mat::from_fn(size + 1, size + 1, |i, j| match (i < size, j < size) {
            (true, true) => stiffness[(i, j)],
            (true, false) => self.equilibrium[(0, i)],
            (false, true) => self.compatibility[(0, j)],
            (false, false) => 0.0,
        });
        let flexible = |matrix: &Mat<f64>| -> Result<Mat<f64>, SlidingError> {
            let right = Mat::from_fn(size + 1, size, |i, j| if i < size { matrix[(i, j)] } else { 0.0 });
            let solved = solve(bordered.clone(), right)?;
            Ok(solved.submatrix(0, 0, size, size).to_owned())
        };
        let (by_mass, by_damping) = (flexible(&self.mass)?, flexible(&damping)?);
        spectrum_of_inverse(&by_mass, &by_damping, shift, 2 * (size - 1))
    }
}

/// K and C of s = θ + σ: K + θ C + θ² M and C + 2 θ M.
fn shifted(mass: &Mat<f64>, damping: &Mat<f64>, stiffness: &Mat<f64>, shift: f64) -> (Mat<f64>, Mat<f64>) {
    let size = mass.nrows();
    let stiffness =
        Mat::from_fn(size, size, |i, j| stiffness[(i, j)] + shift * (damping[(i, j)] + shift * mass[(i, j)]));
    let damping = Mat::from_fn(size, size, |i, j| damping[(i, j)] + 2.0 * shift * mass[(i, j)]);
    (stiffness, damping)
}

/// θ + 1/ν of the `count` largest ν of ν u = −(K⁻¹C u + K⁻¹M w), ν w = u; what is left out is ν = 0, of the constraint.
fn spectrum_of_inverse(
    by_mass: &Mat<f64>,
    by_damping: &Mat<f64>,
    shift: f64,
    count: usize,
) -> Result<Vec<Complex64>, SlidingError> {
    let size = by_mass.nrows();
    // in a unit of time in which both blocks weigh alike
    let unit = by_mass.norm_max().sqrt();
    if !(unit.is_finite() && unit > 0.0) {
        return Err(SlidingError::DenseFailure { reason: "a matrix is singular at the shift" });
    }
    let matrix = Mat::from_fn(2 * size, 2 * size, |i, j| match (i < size, j < size) {
        (true, true) => -by_damping[(i, j)] / unit,
        (true, false) => -by_mass[(i, j - size)] / (unit * unit),
        (false, true) => f64::from(u8::from(i - size == j)),
        (false, false) => 0.0,
    });
    let failure = SlidingError::DenseFailure { reason: "the iteration for the eigenvalues did not end" };
    let mut inverses = real_eigenvalues(&matrix).ok_or(failure)?;
    sort_by_number(&mut inverses, |own| -own.norm_sqr());
    let mut values: Vec<Complex64> =
        inverses.iter().take(count).map(|inverse| shift + 1.0 / (unit * inverse)).collect();
    sort_by_numbers(&mut values, |own| [own.im, own.re]);
    Ok(values)
}

/// All columns but the first of the reflection that turns a row, 1 × n, into its first entry.
fn null_space(row: &Mat<f64>) -> Mat<f64> {
    let size = row.ncols();
    let length = row.norm_l2();
    let sign = if row[(0, 0)] < 0.0 { -1.0 } else { 1.0 };
    let mirror = |k: usize| row[(0, k)] + if k == 0 { sign * length } else { 0.0 };
    let half_square = length * (length + row[(0, 0)].abs());
    Mat::from_fn(size, size.saturating_sub(1), |i, j| {
        let identity = if i == j + 1 { 1.0 } else { 0.0 };
        identity - mirror(i) * mirror(j + 1) / half_square
    })
}

/// X with A X = B.
fn solve(matrix: Mat<f64>, mut right: Mat<f64>) -> Result<Mat<f64>, SlidingError> {
    let failure = SlidingError::DenseFailure { reason: "a matrix is singular at the shift" };
    solved_in_place(matrix, &mut right).ok_or(failure).map(|()| right)
}

#[cfg(test)]
mod tests {
    use super::*;
    use judder_numerics::counter::uniform;

    fn random() -> ThreeField {
        let list = |seed: u64| (0..8).map(|k| uniform(seed, k) - 0.4).collect::<Vec<_>>();
        let coupling = Coupling { compatibility: list(1), equilibrium: list(2), feedback: Vec::new() };
        let eigenvalues: Vec<f64> = (0..8).map(|k| f64::from(k * k)).collect();
        ThreeField::new(&coupling, &eigenvalues, &[0.01; 8]).unwrap()
    }

    /// Equations (4) to (7): B_C L_C = 0 and L_Eᵀ B_Eᵀ = 0, both bases being orthonormal, hence complete.
    #[test]
    fn the_bases_span_what_compatibility_and_equilibrium_leave() {
        let fields = random();
        let (compatible, equilibrium) = (fields.compatible_basis(), fields.equilibrium_basis());
        assert!((&fields.compatibility * &compatible).norm_max() < 1e-15);
        assert!((equilibrium.transpose() * fields.equilibrium.transpose()).norm_max() < 1e-15);
        for basis in [compatible, equilibrium] {
            let square = basis.transpose() * &basis;
            assert!((square - Mat::<f64>::identity(7, 7)).norm_max() < 1e-15);
        }
    }

    /// Both assemblies, in modal and in any other coordinates, have the same 2 (n − 1) eigenvalues.
    #[test]
    fn both_forms_agree_in_any_coordinates() {
        let fields = random();
        let basis = Mat::from_fn(8, 8, |i, j| uniform(7, (8 * i + j) as u64) - 0.5);
        let expected = fields.primal_spectrum(0.3).unwrap();
        assert_eq!(expected.len(), 14);
        let other = fields.transformed(&basis);
        for found in [fields.dual_spectrum(0.3), other.primal_spectrum(0.3), other.dual_spectrum(0.3)] {
            let found = found.unwrap();
            assert_eq!(found.len(), 14);
            // a flutter pair has one imaginary part, whose rounding decides their order
            for expected in &expected {
                let nearest =
                    found.iter().map(|value| (value - expected).norm()).fold(f64::INFINITY, f64::min);
                assert!(nearest < 1e-9, "{expected}: {nearest:e}");
            }
        }
    }
}
