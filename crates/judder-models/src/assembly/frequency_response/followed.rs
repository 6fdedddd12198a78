//! An observed coordinate along a response.

use crate::assembly::build::WatchedRow;
use faer::Mat;
use judder_cycles::CyclesError;
use judder_cycles::balance::HarmonicBalance;
use judder_cycles::forced::ForcedResponse;
use judder_cycles::series::Series;
use num_complex::Complex64;

/// What is told of a coordinate in a motion, and how arrays and axes call it.
pub(super) const MEASURES: [(&str, &str, &str); 4] = [
    ("amplitude", "amplitude of the first harmonic", "Amplitude of the first harmonic (m)"),
    ("rms", "root mean square, with the mean", "Root mean square (m)"),
    ("rms_about_mean", "root mean square about the mean", "Root mean square about the mean (m)"),
    ("largest", "largest magnitude", "Largest magnitude (m)"),
];

/// How many times more instants are looked at for the largest magnitude than the motion was solved with.
const FINER: usize = 4;

/// A coordinate along a response.
pub(super) struct FollowedCoordinate {
    /// As arrays call it.
    pub(super) name: String,
    /// The measures of each motion, in m.
    pub(super) measures: Vec<[f64; MEASURES.len()]>,
}

impl FollowedCoordinate {
    /// All observed coordinates along a response.
    pub(super) fn all(
        watched: &[WatchedRow],
        balance: &HarmonicBalance<'_>,
        found: &ForcedResponse,
    ) -> Result<Vec<Self>, CyclesError> {
        let rows: Vec<Vec<f64>> =
            watched.iter().map(|own| balance.bodies().on_coordinates(&own.row)).collect();
        let series = balance.series();
        let finer = Series::new(series.harmonics(), FINER * series.samples());
        let mut all: Vec<Self> =
            watched.iter().map(|own| Self { name: own.name.clone(), measures: Vec::new() }).collect();
        for motion in &found.motions {
            let (mean, harmonics) = balance.coordinates(&motion.unknown, motion.turning)?;
            for (own, row) in all.iter_mut().zip(&rows) {
                let mut coefficients = vec![row.iter().zip(&mean).map(|(a, b)| a * b).sum::<f64>()];
                for harmonic in &harmonics {
                    let sum: Complex64 = row.iter().zip(harmonic).map(|(a, b)| b * *a).sum();
                    coefficients.extend([sum.re, -sum.im]);
                }
                own.measures.push(measures(&coefficients, &finer));
            }
        }
        Ok(all)
    }
}

/// The measures of a periodic signal.
fn measures(coefficients: &[f64], series: &Series) -> [f64; MEASURES.len()] {
    let mean = coefficients[0];
    let swing = 0.5 * coefficients[1..].iter().map(|own| own * own).sum::<f64>();
    let column = Mat::from_fn(coefficients.len(), 1, |k, _| coefficients[k]);
    let values = series.values(column.as_ref());
    let largest = values.col_as_slice(0).iter().fold(0.0_f64, |most, own| most.max(own.abs()));
    [libm::hypot(coefficients[1], coefficients[2]), (mean * mean + swing).sqrt(), swing.sqrt(), largest]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_swing_about_a_mean() {
        let [amplitude, rms, about, largest] = measures(&[2.0, 3.0, 4.0], &Series::new(1, 400));
        assert!((amplitude - 5.0).abs() < 1e-12);
        assert!((rms - 16.5_f64.sqrt()).abs() < 1e-12 && (about - 12.5_f64.sqrt()).abs() < 1e-12);
        assert!((largest - 7.0).abs() < 1e-3);
    }
}
