//! Any linear system of two degrees of freedom.

use crate::error::OscillatorError;

/// M q̈ + C q̇ + K q = 0 (18); M symmetric and positive definite, C and K of any kind. Matrices are row-major.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinearSystem {
    /// M.
    pub mass: [[f64; 2]; 2],
    /// C.
    pub damping: [[f64; 2]; 2],
    /// K.
    pub stiffness: [[f64; 2]; 2],
}

/// Refuses a matrix with an entry that is NaN or infinite.
fn check_finite(matrix: &'static str, entries: &[[f64; 2]; 2]) -> Result<(), OscillatorError> {
    for (row, values) in entries.iter().enumerate() {
        if let Some(column) = values.iter().position(|value| !value.is_finite()) {
            return Err(OscillatorError::NotFinite { matrix, row, column, value: values[column] });
        }
    }
    Ok(())
}

/// The product of two 2×2 matrices.
fn product(a: [[f64; 2]; 2], b: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
    std::array::from_fn(|i| std::array::from_fn(|j| a[i][0] * b[0][j] + a[i][1] * b[1][j]))
}

impl LinearSystem {
    /// The same system with M = I: (M⁻¹C, M⁻¹K).
    ///
    /// # Errors
    /// An entry that is not finite, or a mass matrix that is not symmetric and positive definite.
    pub fn reduced(&self) -> Result<ReducedSystem, OscillatorError> {
        check_finite("mass", &self.mass)?;
        check_finite("damping", &self.damping)?;
        check_finite("stiffness", &self.stiffness)?;
        let [[a, b], [c, d]] = self.mass;
        let determinant = a * d - b * c;
        if b != c || a <= 0.0 || determinant <= 0.0 {
            return Err(OscillatorError::InvalidMass { mass: self.mass });
        }
        let inverse = [[d / determinant, -b / determinant], [-c / determinant, a / determinant]];
        let reduced = ReducedSystem {
            damping: product(inverse, self.damping),
            stiffness: product(inverse, self.stiffness),
        };
        check_finite("damping", &reduced.damping)?;
        check_finite("stiffness", &reduced.stiffness)?;
        Ok(reduced)
    }
}

/// q̈ + C q̇ + K q = 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReducedSystem {
    /// M⁻¹C.
    pub damping: [[f64; 2]; 2],
    /// M⁻¹K.
    pub stiffness: [[f64; 2]; 2],
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mass_that_is_no_mass_is_refused() {
        let identity = [[1.0, 0.0], [0.0, 1.0]];
        for mass in [[[1.0, 0.5], [0.4, 1.0]], [[-1.0, 0.0], [0.0, 1.0]], [[1.0, 1.0], [1.0, 1.0]]] {
            let system = LinearSystem { mass, damping: identity, stiffness: identity };
            assert_eq!(system.reduced(), Err(OscillatorError::InvalidMass { mass }));
        }
        let system =
            LinearSystem { mass: identity, damping: identity, stiffness: [[1.0, f64::NAN], [0.0, 1.0]] };
        assert!(matches!(
            system.reduced(),
            Err(OscillatorError::NotFinite { matrix: "stiffness", row: 0, column: 1, .. })
        ));
    }
}
