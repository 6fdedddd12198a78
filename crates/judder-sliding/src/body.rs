//! A structure in modal form, as the contact sees it.

use crate::SlidingError;
use crate::plane::PlaneVector;

/// A structure in its own modes: q̈ + (α + β λ) q̇ + λ q = Φᵀ f.
#[derive(Debug, Clone, PartialEq)]
pub struct Body {
    /// λ = ω² by rising size, 1/s²; exactly zero of rigid motions.
    pub eigenvalues: Vec<f64>,
    /// α of Rayleigh's damping, 1/s.
    pub alpha: f64,
    /// β of Rayleigh's damping, s.
    pub beta: f64,
}

/// A place of a structure with its displacements along x and y by mode, in 1/√kg; zero where it is held.
#[derive(Debug, Clone, PartialEq)]
pub struct ModalPoint {
    /// Where it lies undeformed, m.
    pub place: PlaneVector,
    /// Rows of Φ along x and y.
    pub rows: [Vec<f64>; 2],
}

impl Body {
    /// How many modes it has.
    #[must_use]
    pub fn modes(&self) -> usize {
        self.eigenvalues.len()
    }

    /// α + β λ of a mode, 1/s.
    #[must_use]
    pub fn damping(&self, mode: usize) -> f64 {
        self.alpha + self.beta * self.eigenvalues[mode]
    }

    pub(crate) fn check(&self, name: &str) -> Result<(), SlidingError> {
        if self.eigenvalues.is_empty() {
            return Err(SlidingError::Length { name: format!("the {name}'s modes"), found: 0, expected: 1 });
        }
        let eigenvalues = self.eigenvalues.iter().enumerate();
        let numbers = eigenvalues.map(|(k, value)| (format!("ω² of mode {} of the {name}", k + 1), *value));
        let own = [(format!("α of the {name}"), self.alpha), (format!("β of the {name}"), self.beta)];
        match numbers.chain(own).find(|(_, value)| !(value.is_finite() && *value >= 0.0)) {
            Some((name, value)) => {
                Err(SlidingError::InvalidNumber { name, value, requirement: "finite and not negative" })
            }
            None => Ok(()),
        }
    }
}

impl ModalPoint {
    /// Whether every mode has its two finite entries.
    pub(crate) fn check(&self, modes: usize, name: &str) -> Result<(), SlidingError> {
        if let Some(row) = self.rows.iter().find(|row| row.len() != modes) {
            return Err(SlidingError::Length {
                name: format!("a row of {name}"),
                found: row.len(),
                expected: modes,
            });
        }
        finite(self.place.iter(), &format!("the place of {name}"))?;
        let rows = self.rows.iter().zip(["x", "y"]);
        rows.into_iter().try_for_each(|(row, axis)| finite(row.iter(), &format!("the {axis} row of {name}")))
    }

    /// Its displacement where the modal coordinates are `q`, m.
    #[must_use]
    pub fn displacement(&self, q: &[f64]) -> PlaneVector {
        [0, 1].map(|k| self.rows[k].iter().zip(q).map(|(row, q)| row * q).sum())
    }
}

pub(crate) fn finite<'a>(values: impl Iterator<Item = &'a f64>, name: &str) -> Result<(), SlidingError> {
    match values.enumerate().find(|(_, value)| !value.is_finite()) {
        Some((k, value)) => Err(SlidingError::InvalidNumber {
            name: format!("entry {} of {name}", k + 1),
            value: *value,
            requirement: "finite",
        }),
        None => Ok(()),
    }
}
