//! Whether a symmetric matrix is positive: how many of its eigenvalues lie below zero, and how many are zero to rounding.

use faer::sparse::Triplet;
use judder_structure::StructureError;
use judder_structure::assembly::Sparse;
use judder_structure::factor::FactorPattern;

/// An eigenvalue of the matrix with a diagonal of ones that is zero to rounding.
const ROUNDING: f64 = 1e-12;
/// Multiplications of a factorisation up to which a matrix is looked at: about a second.
const MOST_OPERATIONS: f64 = 5e9;

/// Eigenvalues of a symmetric matrix by their sign, those of D A D with D so that its diagonal is of ones: by Sylvester's law of inertia the
/// signs are the same, and what is zero does not depend on the units of the freedoms.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Definiteness {
    /// Below zero.
    pub(super) negative: usize,
    /// Zero to rounding.
    pub(super) zero: usize,
    /// All.
    pub(super) size: usize,
}

impl Definiteness {
    /// Of a symmetric matrix; `None` where it is too large to be looked at beside.
    ///
    /// # Errors
    /// Too little memory.
    pub(super) fn of(matrix: &Sparse) -> Result<Option<Self>, StructureError> {
        let low = shifted(matrix, ROUNDING)?;
        let pattern = FactorPattern::new(&low)?;
        if pattern.operations() > MOST_OPERATIONS {
            return Ok(None);
        }
        let negative = pattern.negative_eigenvalues(&low)?;
        let not_positive = pattern.negative_eigenvalues(&shifted(matrix, -ROUNDING)?)?;
        Ok(Some(Self { negative, zero: not_positive.saturating_sub(negative), size: matrix.nrows() }))
    }

    /// What has to be known of a matrix of this name in words.
    pub(super) fn warnings(self, name: &str, of_negative: &str, of_zero: &str) -> Vec<String> {
        let Self { negative, zero, size } = self;
        let told = |count: usize, are: &str, what: &str| {
            (count > 0).then(|| format!("the {name} is {are} of its {size} eigenvalues: {what}"))
        };
        let indefinite = told(negative, &format!("indefinite, negative in {negative}"), of_negative);
        let singular = told(zero, &format!("singular, zero to rounding in {zero}"), of_zero);
        indefinite.into_iter().chain(singular).collect()
    }
}

/// D A D + s I, with D so that the diagonal of D A D is of ones; rows whose diagonal is zero are scaled by the largest entry.
fn shifted(matrix: &Sparse, shift: f64) -> Result<Sparse, StructureError> {
    let size = matrix.nrows();
    let largest = matrix.val().iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
    let scale = |k: usize| {
        let own = matrix.get(k, k).map_or(0.0, |value| value.abs());
        let own = if own > 0.0 { own } else { largest };
        if own > 0.0 { own.sqrt().recip() } else { 1.0 }
    };
    let scales: Vec<f64> = (0..size).map(scale).collect();
    let mut entries: Vec<_> = (0..size).map(|k| Triplet::new(k, k, shift)).collect();
    for column in 0..size {
        for (row, value) in matrix.row_idx_of_col(column).zip(matrix.val_of_col(column)) {
            entries.push(Triplet::new(row, column, scales[row] * value * scales[column]));
        }
    }
    Sparse::try_new_from_triplets(size, size, &entries)
        .map_err(|_| StructureError::OutOfMemory { rows: size })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A matrix of rows.
    fn of(rows: &[&[f64]]) -> Definiteness {
        let entry = |(row, values): (usize, &&[f64])| {
            let of_row = values.iter().enumerate().filter(|(_, value)| **value != 0.0);
            of_row.map(move |(column, value)| Triplet::new(row, column, *value)).collect::<Vec<_>>()
        };
        let entries: Vec<_> = rows.iter().enumerate().flat_map(entry).collect();
        let matrix = Sparse::try_new_from_triplets(rows.len(), rows.len(), &entries).unwrap();
        Definiteness::of(&matrix).unwrap().unwrap()
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
        let words = found.warnings("mass", "so", "thus");
        assert_eq!(words[0], "the mass is indefinite, negative in 1 of its 3 eigenvalues: so");
        assert_eq!(words[1], "the mass is singular, zero to rounding in 1 of its 3 eigenvalues: thus");
    }
}
