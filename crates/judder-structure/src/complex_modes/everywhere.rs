//! The complex modes of a small problem at all frequencies, in a region that provably has every eigenvalue.

use super::whole::LARGEST;
use super::{ComplexModeSettings, ComplexModes, complex_modes};
use crate::StructureError;
use crate::assembly::Sparse;
use crate::quadratic::{Quadratic, Region};
use faer::Mat;
use judder_dense::general::solve;

/// All complex modes that do not oscillate backwards, Im λ ≥ 0, at whatever frequency; none where the problem is too large to be solved whole, or its mass has no inverse.
///
/// From x with its largest entry 1, |λ|² ≤ ‖M⁻¹C‖ |λ| + ‖M⁻¹K‖ with the largest sums of absolute entries of a row, so that no eigenvalue is larger than the root of that.
///
/// # Errors
/// What [`complex_modes`] says.
pub fn all_complex_modes(
    problem: &Quadratic,
    settings: &ComplexModeSettings,
) -> Result<Option<ComplexModes>, StructureError> {
    match largest(problem).filter(|_| problem.size() <= LARGEST) {
        Some(most) if most > 0.0 => {
            let region = Region { re: [-most, most], im: [0.0, most] };
            complex_modes(problem, &region, settings).map(Some)
        }
        _ => Ok(None),
    }
}

/// What no |λ| is above.
fn largest(problem: &Quadratic) -> Option<f64> {
    if problem.size() > LARGEST {
        return None;
    }
    let norm = |matrix: &Sparse| -> Option<f64> {
        let mut by_mass = matrix.to_dense();
        solve(problem.mass().to_dense(), &mut by_mass)?;
        Some(largest_row(&by_mass))
    };
    let [half, stiffness] = [0.5 * norm(problem.damping())?, norm(problem.stiffness())?];
    Some(half + (half * half + stiffness).sqrt()).filter(|most| most.is_finite())
}

fn largest_row(matrix: &Mat<f64>) -> f64 {
    let of_row = |row: usize| (0..matrix.ncols()).map(|column| matrix[(row, column)].abs()).sum::<f64>();
    (0..matrix.nrows()).map(of_row).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use faer::sparse::Triplet;

    fn diagonal(values: &[f64]) -> Sparse {
        let entries: Vec<_> = values.iter().enumerate().map(|(k, own)| Triplet::new(k, k, *own)).collect();
        Sparse::try_new_from_triplets(values.len(), values.len(), &entries).unwrap()
    }

    /// Of uncoupled oscillators 2 λ = −c ± √(c² − 4 k): one that creeps, one that grows at a frequency far above the others, one that decays.
    #[test]
    fn modes_of_all_frequencies_are_found() {
        let problem = Quadratic::new(
            diagonal(&[1.0, 1.0, 1.0]),
            diagonal(&[5.0, -2.0, 0.2]),
            diagonal(&[4.0, 1e8, 9.0]),
        )
        .unwrap();
        let all = all_complex_modes(&problem, &ComplexModeSettings::default()).unwrap().unwrap();
        assert!(all.complete(), "{:?}", all.gaps);
        let mut rates: Vec<f64> = all.modes.iter().map(|own| own.eigenvalue.value.re).collect();
        rates.sort_by(f64::total_cmp);
        let known = [-4.0, -1.0, -0.1, 1.0];
        assert!(rates.len() == 4 && rates.iter().zip(known).all(|(a, b)| (a - b).abs() < 1e-6), "{rates:?}");
    }

    #[test]
    fn without_an_inverse_of_the_mass_and_of_large_problems_nothing_is_told() {
        let massless = Quadratic::new(diagonal(&[1.0, 0.0]), diagonal(&[0.0; 2]), diagonal(&[1.0; 2]));
        let large = LARGEST + 1;
        let large = Quadratic::new(
            diagonal(&vec![1.0; large]),
            diagonal(&vec![0.0; large]),
            diagonal(&vec![1.0; large]),
        );
        for problem in [massless, large] {
            let found = all_complex_modes(&problem.unwrap(), &ComplexModeSettings::default()).unwrap();
            assert!(found.is_none());
        }
    }
}
