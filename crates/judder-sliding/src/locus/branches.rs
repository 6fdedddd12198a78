//! Which of the lowest eigenvalues at one value of a parameter goes on as which at the next.

use crate::spectrum::Spectrum;
use crate::tracking::{Tracker, reach};
use crate::zones::SpectrumSample;
use judder_numerics::order::{sort_by_number, sort_by_numbers};
use num_complex::Complex64;

/// Eigenvalues by branch, with how far each may be off.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct LocusBranches {
    /// For each spectrum one a branch, NaN where the branch is not among the lowest.
    pub(super) eigenvalues: Vec<Vec<Complex64>>,
    pub(super) errors: Vec<Vec<f64>>,
}

impl LocusBranches {
    /// Those of the `count` lowest eigenvalues of each spectrum, in the order in which they are first among them, then by frequency.
    ///
    /// They are tracked over the samples between the spectra as well.
    pub(super) fn new(shown: Vec<(f64, Spectrum)>, samples: Vec<SpectrumSample>, count: usize) -> Self {
        let mut all: Vec<(SpectrumSample, Option<Vec<f64>>)> =
            samples.into_iter().map(|sample| (sample, None)).collect();
        all.extend(shown.into_iter().map(|(at, spectrum)| sample_of(at, spectrum)));
        sort_by_numbers(&mut all, |own| [own.0.at, f64::from(own.1.is_some())]);
        let mut tracker = Tracker::default();
        let mut columns: Vec<usize> = Vec::new();
        let mut rows = Vec::new();
        for (SpectrumSample { at, eigenvalues, limit }, errors) in all {
            let numbers = tracker.step(at, &eigenvalues, limit);
            let Some(errors) = errors else { continue };
            let mut lowest: Vec<usize> = (0..count.min(numbers.len())).collect();
            sort_by_number(&mut lowest, |own| eigenvalues[*own].im);
            let mut row = Vec::with_capacity(lowest.len());
            for rank in lowest {
                let column = columns.iter().position(|own| *own == numbers[rank]).unwrap_or_else(|| {
                    columns.push(numbers[rank]);
                    columns.len() - 1
                });
                row.push((column, eigenvalues[rank], errors[rank]));
            }
            rows.push(row);
        }
        Self::of_rows(&rows, columns.len())
    }

    fn of_rows(rows: &[Vec<(usize, Complex64, f64)>], columns: usize) -> Self {
        let mut branches = Self::default();
        for row in rows {
            let none = Complex64::new(f64::NAN, f64::NAN);
            let (mut values, mut errors) = (vec![none; columns], vec![f64::NAN; columns]);
            for (column, value, error) in row {
                (values[*column], errors[*column]) = (*value, *error);
            }
            branches.eigenvalues.push(values);
            branches.errors.push(errors);
        }
        branches
    }
}

/// A spectrum as a sample, the lowest first, with how far each eigenvalue may be off.
fn sample_of(at: f64, spectrum: Spectrum) -> (SpectrumSample, Option<Vec<f64>>) {
    let Spectrum { eigenvalues, errors, limit } = spectrum;
    let mut both: Vec<(Complex64, f64)> = eigenvalues.into_iter().zip(errors).collect();
    sort_by_number(&mut both, |own| reach(own.0));
    let (eigenvalues, errors) = both.into_iter().unzip();
    (SpectrumSample { at, eigenvalues, limit }, Some(errors))
}
