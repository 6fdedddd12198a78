//! Whether a symmetric matrix is positive: how many of its eigenvalues lie below zero, and how many are zero to rounding.

mod clearly;

use crate::StructureError;
use crate::assembly::Sparse;
use crate::factor::FactorPattern;
use clearly::is_clearly_positive;
use faer::sparse::Triplet;

/// An eigenvalue of the matrix with a diagonal of ones that is zero to rounding.
const ROUNDING: f64 = 1e-12;
/// Such an eigenvalue of a mass below which it is refused: what a file of seven digits makes of one that is singular, as of a weight on an arm, hurts no modes.
const DIGITS: f64 = 1e-7;

/// Eigenvalues of a symmetric matrix by their sign, those of D A D with D so that its diagonal is of ones: by Sylvester's law of inertia the
/// signs are the same, and what is zero does not depend on the units of the freedoms.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Definiteness {
    /// Below zero.
    pub negative: usize,
    /// Zero to rounding.
    pub zero: usize,
    /// All.
    pub size: usize,
}

impl Definiteness {
    /// Of a symmetric matrix with both triangles; `None` where it takes more multiplications than so many.
    ///
    /// # Errors
    /// [`StructureError::OutOfMemory`].
    pub fn of(matrix: &Sparse, most_operations: f64) -> Result<Option<Self>, StructureError> {
        let size = matrix.nrows();
        let scaled = scaled(matrix)?;
        if is_clearly_positive(&scaled) {
            return Ok(Some(Self { negative: 0, zero: 0, size }));
        }
        let pattern = FactorPattern::new(&scaled)?;
        if pattern.operations() > most_operations {
            return Ok(None);
        }
        let below = |value: f64| pattern.negative_eigenvalues(&shifted(&scaled, -value));
        let negative = below(-ROUNDING)?;
        Ok(Some(Self { negative, zero: below(ROUNDING)?.saturating_sub(negative), size }))
    }
}

/// Refuses a mass with which some motion has less than no kinetic energy; where a factorisation that would tell takes more multiplications than so many, nothing.
///
/// # Errors
/// [`StructureError::IndefiniteMass`], [`StructureError::OutOfMemory`].
pub(crate) fn admit_mass(mass: &Sparse, most_operations: f64) -> Result<(), StructureError> {
    let scaled = scaled(mass)?;
    if is_clearly_positive(&scaled) {
        return Ok(());
    }
    let pattern = FactorPattern::new(&scaled)?;
    if pattern.operations() > most_operations {
        return Ok(());
    }
    match pattern.negative_eigenvalues(&shifted(&scaled, DIGITS))? {
        0 => Ok(()),
        negative => Err(StructureError::IndefiniteMass { negative, size: mass.nrows() }),
    }
}

/// D A D with a diagonal of ones in magnitude, all of it in its pattern; rows whose diagonal is zero are scaled by the largest entry.
fn scaled(matrix: &Sparse) -> Result<Sparse, StructureError> {
    let size = matrix.nrows();
    let largest = matrix.val().iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
    let scale = |k: usize| {
        let own = matrix.get(k, k).map_or(0.0, |value| value.abs());
        let own = if own > 0.0 { own } else { largest };
        if own > 0.0 { own.sqrt().recip() } else { 1.0 }
    };
    let scales: Vec<f64> = (0..size).map(scale).collect();
    let mut entries: Vec<_> = (0..size).map(|k| Triplet::new(k, k, 0.0)).collect();
    entries.reserve(matrix.val().len());
    for (column, of_column) in scales.iter().enumerate() {
        for (row, value) in matrix.row_idx_of_col(column).zip(matrix.val_of_col(column)) {
            entries.push(Triplet::new(row, column, scales[row] * value * of_column));
        }
    }
    Sparse::try_new_from_triplets(size, size, &entries)
        .map_err(|_| StructureError::OutOfMemory { rows: size })
}

/// A + s I of a matrix with all of its diagonal in its pattern.
fn shifted(matrix: &Sparse, shift: f64) -> Sparse {
    let mut shifted = matrix.clone();
    for k in 0..matrix.nrows() {
        if let Some(value) = shifted.get_mut(k, k) {
            *value += shift;
        }
    }
    shifted
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A matrix of rows.
    fn matrix(rows: &[&[f64]]) -> Sparse {
        let entry = |(row, values): (usize, &&[f64])| {
            let of_row = values.iter().enumerate().filter(|(_, value)| **value != 0.0);
            of_row.map(move |(column, value)| Triplet::new(row, column, *value)).collect::<Vec<_>>()
        };
        let entries: Vec<_> = rows.iter().enumerate().flat_map(entry).collect();
        Sparse::try_new_from_triplets(rows.len(), rows.len(), &entries).unwrap()
    }

    fn of(rows: &[&[f64]]) -> Definiteness {
        Definiteness::of(&matrix(rows), f64::INFINITY).unwrap().unwrap()
    }

    #[test]
    fn signs_are_counted_whatever_the_units() {
        let found = of(&[&[1.0, 0.0], &[0.0, 1e-20]]);
        assert_eq!(found, Definiteness { negative: 0, zero: 0, size: 2 });
        // [1 1; 1 1] has 0 and 2
        let found = of(&[&[1.0, 1.0, 0.0], &[1.0, 1.0, 0.0], &[0.0, 0.0, 1e9]]);
        assert_eq!(found, Definiteness { negative: 0, zero: 1, size: 3 });
        // [1 2; 2 1] has −1 and 3, a row of nothing 0
        let found = of(&[&[1.0, 2.0, 0.0], &[2.0, 1.0, 0.0], &[0.0, 0.0, 0.0]]);
        assert_eq!(found, Definiteness { negative: 1, zero: 1, size: 3 });
    }

    #[test]
    fn a_mass_is_refused_where_it_is_negative_beyond_the_digits_of_a_file() {
        let admitted = |rows: &[&[f64]]| admit_mass(&matrix(rows), f64::INFINITY);
        assert_eq!(admitted(&[&[1.0, 0.0], &[0.0, 0.0]]), Ok(()));
        assert_eq!(admitted(&[&[1.0, 1.0 + 1e-8], &[1.0 + 1e-8, 1.0]]), Ok(()));
        let refused = Err(StructureError::IndefiniteMass { negative: 1, size: 2 });
        assert_eq!(admitted(&[&[1.0, 0.0], &[0.0, -1e-9]]), refused);
        assert_eq!(admitted(&[&[1.0, 1.0 + 1e-6], &[1.0 + 1e-6, 1.0]]), refused);
        assert_eq!(admitted(&[&[1.0, 0.5], &[0.5, 0.0]]), refused);
        // nothing is told of what takes too long
        assert_eq!(admit_mass(&matrix(&[&[1.0, 0.0], &[0.0, -1.0]]), 0.0), Ok(()));
    }
}
