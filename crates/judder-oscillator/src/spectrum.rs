//! Eigenvalues and eigenvectors of λ² M + λ C + K.

use crate::characteristic::Characteristic;
use crate::error::OscillatorError;
use crate::linear_system::{LinearSystem, ReducedSystem};
use judder_numerics::polynomial::real_polynomial_roots;
use num_complex::Complex64;

/// The four eigenvalues of the state matrix (22), sorted by imaginary, then real part; conjugates are exact.
///
/// They are the roots of (21), found together and each polished to the accuracy that the coefficients allow.
///
/// # Errors
/// Non-finite entries, or an iteration that did not settle.
pub fn eigenvalues(system: &ReducedSystem) -> Result<[Complex64; 4], OscillatorError> {
    let undamped = system.damping.iter().flatten().all(|c| *c == 0.0);
    let values = if undamped {
        crate::conservative::conservative_eigenvalues(&system.stiffness)
    } else {
        let roots = real_polynomial_roots(&Characteristic::new(system).coefficients())?;
        [roots[0], roots[1], roots[2], roots[3]]
    };
    if values.iter().all(|value| value.is_finite()) {
        return Ok(values);
    }
    let entries = system.damping.iter().chain(&system.stiffness).flatten();
    Err(OscillatorError::Overflow { largest: entries.fold(0.0, |largest, entry| entry.abs().max(largest)) })
}

/// The growth rate: the largest real part.
#[must_use]
pub fn growth_rate(eigenvalues: &[Complex64; 4]) -> f64 {
    eigenvalues.iter().map(|l| l.re).fold(f64::NEG_INFINITY, f64::max)
}

/// The eigenvalue of largest real part; of a conjugate pair the one with the positive imaginary part.
#[must_use]
pub fn leading(eigenvalues: &[Complex64; 4]) -> Complex64 {
    let growth = growth_rate(eigenvalues);
    eigenvalues.iter().rev().copied().find(|l| l.re == growth).unwrap_or(eigenvalues[3])
}

/// An eigenvalue with its right and left vectors: D x = 0, yᵀ D = 0 for D = λ² M + λ C + K, both of unit length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EigenMode {
    /// λ.
    pub eigenvalue: Complex64,
    /// x.
    pub right: [Complex64; 2],
    /// y.
    pub left: [Complex64; 2],
}

/// The null vector of the 2×2 matrix with these rows, from its larger row.
fn null_vector(rows: [[Complex64; 2]; 2]) -> [Complex64; 2] {
    let size = |row: &[Complex64; 2]| row[0].norm_sqr() + row[1].norm_sqr();
    let row = if size(&rows[0]) >= size(&rows[1]) { rows[0] } else { rows[1] };
    let length = size(&row).sqrt();
    if length == 0.0 {
        return [Complex64::ONE, Complex64::ZERO];
    }
    [-row[1] / length, row[0] / length]
}

/// The vectors that belong to an eigenvalue.
#[must_use]
pub fn mode(system: &LinearSystem, eigenvalue: Complex64) -> EigenMode {
    let LinearSystem { mass: m, damping: c, stiffness: k } = system;
    let entry = |i: usize, j: usize| (eigenvalue * m[i][j] + c[i][j]) * eigenvalue + k[i][j];
    let d = [[entry(0, 0), entry(0, 1)], [entry(1, 0), entry(1, 1)]];
    EigenMode {
        eigenvalue,
        right: null_vector(d),
        left: null_vector([[d[0][0], d[1][0]], [d[0][1], d[1][1]]]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn vectors_annihilate_the_matrix() {
        let system = LinearSystem {
            mass: [[2.0, 0.3], [0.3, 1.0]],
            damping: [[0.1, 0.02], [-0.3, 0.05]],
            stiffness: [[2.0, -1.0], [1.0, 3.0]],
        };
        let values = eigenvalues(&system.reduced().unwrap()).unwrap();
        for value in values {
            let EigenMode { right: x, left: y, .. } = mode(&system, value);
            for i in 0..2 {
                let d = |i: usize, j: usize| {
                    (value * system.mass[i][j] + system.damping[i][j]) * value + system.stiffness[i][j]
                };
                assert!((d(i, 0) * x[0] + d(i, 1) * x[1]).norm() < 1e-13);
                assert!((d(0, i) * y[0] + d(1, i) * y[1]).norm() < 1e-13);
            }
        }
    }
}
