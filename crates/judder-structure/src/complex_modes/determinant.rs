//! Determinants by elimination.

use crate::StructureError;
use crate::quadratic::Quadratic;
use faer::{Mat, c64};
use judder_dense::general::pivots;
use judder_numerics::complex::ElementaryComplex;

/// ln det Q(z), its phase up to turns; −∞ where the matrix is singular.
///
/// # Errors
/// [`StructureError::OutOfMemory`].
pub(super) fn log_determinant(problem: &Quadratic, place: c64) -> Result<c64, StructureError> {
    let mut matrix = problem.at(place)?.to_dense();
    let scales = equilibrate(&mut matrix);
    let out_of_memory = StructureError::OutOfMemory { rows: problem.size() };
    let (pivots, odd) = pivots(&mut matrix).ok_or(out_of_memory)?;
    let turned = if odd { std::f64::consts::PI } else { 0.0 };
    Ok(pivots.iter().map(|pivot| pivot.logarithm()).sum::<c64>() + c64::new(scales, turned))
}

/// Divides every row by its largest entry, then every column; gives the sum of the logarithms.
fn equilibrate(matrix: &mut Mat<c64>) -> f64 {
    let size = matrix.nrows();
    let mut scales = 0.0;
    for row in 0..size {
        let largest = (0..size).map(|k| matrix[(row, k)].modulus()).fold(0.0, f64::max);
        if largest > 0.0 {
            (0..size).for_each(|k| matrix[(row, k)] /= largest);
            scales += libm::log(largest);
        }
    }
    for column in 0..size {
        let largest = (0..size).map(|k| matrix[(k, column)].modulus()).fold(0.0, f64::max);
        if largest > 0.0 {
            (0..size).for_each(|k| matrix[(k, column)] /= largest);
            scales += libm::log(largest);
        }
    }
    scales
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assembly::Sparse;
    use faer::sparse::Triplet;

    fn matrix(entries: &[(usize, usize, f64)]) -> Sparse {
        let triplets: Vec<_> = entries.iter().map(|(i, j, v)| Triplet::new(*i, *j, *v)).collect();
        Sparse::try_new_from_triplets(3, 3, &triplets).unwrap()
    }

    /// Of a cyclic matrix with the entries a, b, c the determinant is their product.
    #[test]
    fn a_determinant_has_its_size_and_its_sign() {
        let problem = Quadratic::new(
            matrix(&[(0, 1, 2.0)]),
            matrix(&[(1, 2, 1e-9)]),
            matrix(&[(0, 1, 1.0), (2, 0, -4e8)]),
        )
        .unwrap();
        let z = c64::new(0.3, 1.2);
        let expected = (z * z * 2.0 + 1.0) * (z * 1e-9) * -4e8;
        let found = log_determinant(&problem, z).unwrap().exp();
        assert!((found - expected).norm() <= 1e-14 * expected.norm(), "{found} {expected}");
    }
}
