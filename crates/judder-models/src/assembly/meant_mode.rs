//! Which mode about steady sliding an analysis means.

use super::eigen::{band, lowest};
use crate::error::ModelError;
use crate::measured_growth::{FAR, MeantMode, SOUGHT, near};
use crate::structure::eigen::run::found;
use judder_assembly::linearised::Linearised;
use judder_structure::complex_modes::ComplexMode;
use judder_study::text::short;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// A mode that swings with so many Hz, in words.
pub(super) fn mode_at(hz: f64) -> String {
    format!("mode at {} Hz", short(hz))
}

/// The mode that is meant by a frequency in rad/s, in words.
pub(super) fn mode_near(frequency: f64) -> String {
    format!("mode near {} Hz", short(frequency / TAU))
}

/// The mode near a frequency in rad/s: of those close to it the one that grows fastest.
pub(super) fn near_frequency(about: &Linearised, frequency: f64) -> Result<ComplexMode, ModelError> {
    let region = band((1.0 - FAR) * frequency, SOUGHT * frequency);
    let mut modes = found(&about.problem, &region)?.modes;
    let values: Vec<Complex64> = modes.iter().map(|mode| mode.eigenvalue.value).collect();
    match near(&values, frequency) {
        Some(MeantMode::Found(place)) => Ok(modes.swap_remove(place)),
        Some(MeantMode::TooFar(_)) | None => {
            let [asked, from, to] = [frequency, region.im[0], region.im[1]].map(|omega| omega / TAU);
            Err(ModelError::Unsupported(format!(
                "there is no mode near {asked:.1} Hz, none between {from:.1} and {to:.1} Hz"
            )))
        }
    }
}

/// Of so many of the lowest modes that swing the one that grows fastest, or decays most slowly; and up to which frequency in rad/s there are no others.
pub(super) fn fastest(about: &Linearised, count: usize) -> Result<(ComplexMode, f64), ModelError> {
    let (region, found) = lowest(about, count)?;
    let swinging = found.modes.into_iter().filter(|mode| mode.eigenvalue.value.im > 0.0);
    let fastest =
        swinging.max_by(|a, b| a.eigenvalue.value.re.total_cmp(&b.eigenvalue.value.re)).ok_or_else(|| {
            ModelError::Unsupported("no mode about steady sliding swings: there is no cycle".to_owned())
        })?;
    Ok((fastest, region.im[1]))
}
