//! α and β of C = α M + β K.

use judder_case::structure::damping::Damping;
use judder_structure::assembly::Sparse;

/// By how much an imported C may differ from α M + β K, as a share of its largest entry.
const TOLERANCE: f64 = 1e-8;

/// α in 1/s and β in s of a structure: as the case has them, η/ω_r of structural damping, or those to which an imported matrix is
/// nearest.
///
/// # Errors
/// A matrix that is no αM + βK: then modes are coupled by damping, and the modal form is not diagonal.
pub(super) fn damping(
    own: &Damping,
    imported: &Sparse,
    [mass, stiffness]: [&Sparse; 2],
) -> Result<(f64, f64), String> {
    match *own {
        Damping::Rayleigh { alpha, beta } => Ok((alpha, beta)),
        Damping::Structural { loss_factor, reference_frequency } => {
            Ok((0.0, loss_factor / reference_frequency))
        }
        Damping::None => fitted(imported, mass, stiffness),
    }
}

/// The least squares of C = α M + β K over all entries, each matrix over its largest one.
fn fitted(damping: &Sparse, mass: &Sparse, stiffness: &Sparse) -> Result<(f64, f64), String> {
    let sizes = [damping, mass, stiffness].map(largest);
    let [of_damping, of_mass, of_stiffness] = sizes;
    if of_damping == 0.0 {
        return Ok((0.0, 0.0));
    }
    // M and K in units of their own
    let entries: Vec<[f64; 3]> = entries([damping, mass, stiffness])
        .into_iter()
        .map(|row| [row[0] / of_damping, row[1] / of_mass, row[2] / of_stiffness])
        .collect();
    let sum = |i: usize, j: usize| entries.iter().map(|row| row[i] * row[j]).sum::<f64>();
    let (mm, mk, kk, cm, ck) = (sum(1, 1), sum(1, 2), sum(2, 2), sum(0, 1), sum(0, 2));
    let determinant = mm * kk - mk * mk;
    let (alpha, beta) = ((cm * kk - ck * mk) / determinant, (ck * mm - cm * mk) / determinant);
    let departure = entries.iter().map(|[c, m, k]| (c - alpha * m - beta * k).abs()).fold(0.0, f64::max);
    if departure <= TOLERANCE {
        // what is rounding of a zero is one
        let clean = |share: f64| if share.abs() <= TOLERANCE { 0.0 } else { share };
        let (alpha, beta) = (clean(alpha) * of_damping / of_mass, clean(beta) * of_damping / of_stiffness);
        if alpha >= 0.0 && beta >= 0.0 {
            return Ok((alpha, beta));
        }
        return Err(format!(
            "the damping matrix is α M + β K with α = {alpha:.3e} 1/s and β = {beta:.3e} s: neither may be negative"
        ));
    }
    Err(format!(
        "the damping matrix is not α M + β K: at best {departure:.1e} of its largest entry is left, and at most {TOLERANCE:.0e} may \
         be; give such a matrix, or none"
    ))
}

fn largest(matrix: &Sparse) -> f64 {
    matrix.val().iter().fold(0.0, |largest, value| value.abs().max(largest))
}

/// The entries of three matrices at every place where any has one.
fn entries(matrices: [&Sparse; 3]) -> Vec<[f64; 3]> {
    let mut all = Vec::new();
    for column in 0..matrices[0].ncols() {
        let mut rows = std::collections::BTreeMap::<usize, [f64; 3]>::new();
        for (k, matrix) in matrices.iter().enumerate() {
            for (row, value) in matrix.row_idx_of_col(column).zip(matrix.val_of_col(column)) {
                rows.entry(row).or_default()[k] += value;
            }
        }
        all.extend(rows.into_values());
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use faer::sparse::Triplet;

    fn matrix(entries: &[(usize, usize, f64)]) -> Sparse {
        let triplets: Vec<_> = entries.iter().map(|(i, j, value)| Triplet::new(*i, *j, *value)).collect();
        Sparse::try_new_from_triplets(2, 2, &triplets).unwrap()
    }

    /// α and β of a sum come back; a dashpot between the two is refused.
    #[test]
    fn an_imported_matrix_is_told_apart() {
        let mass = matrix(&[(0, 0, 2.0), (1, 1, 1.0)]);
        let stiffness = matrix(&[(0, 0, 3e6), (0, 1, -1e6), (1, 0, -1e6), (1, 1, 1e6)]);
        let (alpha, beta) = (7.0, 2e-6);
        let sum = matrix(&[(0, 0, 14.0 + 6.0), (0, 1, -2.0), (1, 0, -2.0), (1, 1, 7.0 + 2.0)]);
        let found = damping(&Damping::None, &sum, [&mass, &stiffness]).unwrap();
        assert!((found.0 / alpha - 1.0).abs() < 1e-9 && (found.1 / beta - 1.0).abs() < 1e-9, "{found:?}");
        let dashpot = matrix(&[(0, 0, 5.0)]);
        assert!(damping(&Damping::None, &dashpot, [&mass, &stiffness]).is_err());
        assert_eq!(damping(&Damping::None, &matrix(&[]), [&mass, &stiffness]), Ok((0.0, 0.0)));
    }
}
