//! How loud the observed points are, octave by octave.

use super::blocks::OngoingMotion;
use crate::assembly::AssemblySubject;
use crate::error::ModelError;
use crate::spectrogram::settings::decibel_reference;
use judder_keys::dimension::Dimension;
use judder_numerics::signal::octave::octave_bands;
use judder_store::{Results, Variable};

/// The level of an acceleration by its mean square in m²/s⁴, in dB re 1 µm/s².
pub(in crate::assembly) fn level(mean_square: f64) -> f64 {
    10.0 * libm::log10(mean_square / decibel_reference(Dimension::ACCELERATION).powi(2))
}

/// The levels of an observed point along a direction after the transient, in octave bands.
#[derive(Results)]
pub(super) struct OctaveLevels {
    /// midband frequencies, in Hz
    band_hz: Vec<f64>,
    /// the level of the acceleration in each, in dB re 1 µm/s²; none of a band beyond what the signal passes or its duration tells
    level_db: Vec<Option<f64>>,
}

impl OngoingMotion<'_, '_> {
    /// The levels of each observed point along each direction.
    pub(super) fn levels(
        &self,
        of: &AssemblySubject<'_>,
        transient: f64,
    ) -> Result<Vec<(String, OctaveLevels)>, ModelError> {
        let watched = &of.built.watched;
        let time = if watched.is_empty() { Vec::new() } else { self.samples.values("time")? };
        let first = time.partition_point(|time| *time <= transient);
        let [rate, pass_band] = [self.recorded.rate(), self.recorded.pass_band()];
        let told = watched.iter().map(|own| {
            let acceleration = self.samples.values(&own.name)?;
            let settled = acceleration.get(first..).unwrap_or_default();
            // of a motion that leaves the numbers no level is known
            let settled = if settled.iter().all(|own| own.is_finite()) { settled } else { &[] };
            let bands = octave_bands(settled, rate, pass_band)?;
            let levels = OctaveLevels {
                band_hz: bands.iter().map(|band| band.centre).collect(),
                level_db: bands
                    .iter()
                    .map(|band| band.mean_square.map(level).filter(|level| level.is_finite()))
                    .collect(),
            };
            Ok((own.name.clone(), levels))
        });
        told.collect()
    }
}

/// The levels over their bands.
pub(super) fn variables(levels: &[(String, OctaveLevels)]) -> Vec<Variable> {
    let bands = levels.first().map(|(_, first)| {
        let bands = Variable::coordinate("octave_band", first.band_hz.clone()).units("Hz");
        bands.long_name("midband frequency of an octave").attribute("label", "Midband frequency (Hz)")
    });
    let own = levels.iter().map(|(name, own)| {
        let values: Vec<f64> = own.level_db.iter().map(|level| level.unwrap_or(f64::NAN)).collect();
        let words = format!("level of the acceleration of {name} in octaves, re 1 µm/s²");
        let level = Variable::new(&format!("{name}.level"), &["octave_band"], &[values.len()], values);
        level.units("dB").long_name(&words).attribute("label", "Level (dB re 1 µm/s^{2})")
    });
    bands.into_iter().chain(own).collect()
}
