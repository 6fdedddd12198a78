//! The levels of a stored signal.

#![deny(clippy::indexing_slicing, reason = "stored arrays may be of any length")]

use super::settings::SpectrumSettings;
use crate::error::ModelError;
use judder_numerics::signal::spectrogram::{self as levels, SpectrogramSettings};
use judder_numerics::words::plain;
use judder_store::{Dataset, Results, Variable};
use judder_study::StudyError;
use judder_study::kept::StudyPlace;
use judder_study::pictures::{StoredArrays, reals};
use serde_json::{Value, json};

/// A spectrogram that is asked for.
pub(crate) struct AskedLevels<'a> {
    /// The name of the analysis.
    pub(crate) name: &'a str,
    /// The array of the signal, and what it is called.
    pub(crate) signal: [&'a str; 2],
    pub(crate) asked: &'a SpectrumSettings,
}

/// What is told of a spectrogram.
#[derive(Results)]
pub(crate) struct ToldSpectrogram {
    /// the march
    of: String,
    windows: usize,
    /// what levels refer to
    reference: String,
    resolution_hz: Option<f64>,
    peak_level_db: Option<f64>,
    peak_time_s: Option<f64>,
    /// where the contact was, of a march along a path
    #[result(optional)]
    peak_position_m: Option<Option<f64>>,
    peak_frequency_hz: Option<f64>,
}

impl AskedLevels<'_> {
    /// The study in which the march and what else is taken lie, as they are asked for now.
    pub(crate) fn place<'p>(
        &self,
        place: Option<StudyPlace<'p>>,
        others: &[&str],
    ) -> Result<StudyPlace<'p>, ModelError> {
        let needs = |analysis: &str| {
            let (analysis, by) = (analysis.to_owned(), self.name.to_owned());
            ModelError::NotDone { analysis, by }
        };
        let place = place.ok_or_else(|| needs(&self.asked.of))?;
        for other in [self.asked.of.as_str()].iter().chain(others) {
            let hash = place.all.iter().find(|(name, _)| name == other).map_or("", |(_, hash)| hash);
            if !place.study.is_done(other, hash)? {
                return Err(needs(other));
            }
        }
        Ok(place)
    }

    /// The levels of the signal that the march has stored.
    pub(crate) fn shown(&self, place: &StudyPlace<'_>) -> Result<ShownLevels, ModelError> {
        let march = place.study.read_dataset(&self.asked.of)?;
        let [signal, called] = self.signal;
        let arrays = StoredArrays::of(&march);
        let history = arrays.settled(StoredHistory::new(&arrays, signal));
        let history =
            history.map_err(|wrong| StudyError::from(wrong.in_study(place.study.path(), &self.asked.of)))?;
        let history = history.ok_or_else(|| ModelError::NotRecorded {
            march: self.asked.of.clone(),
            signal: called.to_owned(),
        })?;
        let settings = SpectrogramSettings {
            start: history.times.first().copied().unwrap_or(0.0),
            window: self.asked.pieces.window.window(),
            length: self.asked.pieces.samples(history.sample_rate),
            overlap: self.asked.pieces.overlap,
            reference: self.asked.reference.0.number,
            ..SpectrogramSettings::new(history.sample_rate)
        };
        let found = levels::spectrogram(history.values, &settings)?;
        let unit = march.variable(signal).map_or("", |variable| variable.units.as_str());
        let reference = format!("{} {unit}", plain(self.asked.reference.0.number));
        Ok(ShownLevels::new(&history, found, reference))
    }
}

/// The stored history of a signal, as far as it is finite.
struct StoredHistory<'a> {
    times: &'a [f64],
    /// Where the contact was, of a march along a path.
    positions: Option<&'a [f64]>,
    values: &'a [f64],
    sample_rate: f64,
    pass_band: f64,
}

impl<'a> StoredHistory<'a> {
    fn new(march: &StoredArrays<'a>, signal: &str) -> Option<Self> {
        for name in ["time", "position", signal] {
            march.over(name, &["time"])?;
        }
        let values = reals(march, signal)?;
        let finite = values.iter().position(|value| !value.is_finite()).unwrap_or(values.len());
        let number = |name: &str| march.attributes().get(name).and_then(Value::as_f64);
        Some(Self {
            times: reals(march, "time")?,
            positions: reals(march, "position"),
            values: values.get(..finite)?,
            sample_rate: number("sample_rate_hz")?,
            pass_band: number("pass_band_hz")?,
        })
    }

    fn position(&self, positions: &[f64], time: f64) -> f64 {
        let last = self.times.len().saturating_sub(1);
        let index = self.times.partition_point(|own| *own < time).min(last);
        positions.get(index).copied().unwrap_or(f64::NAN)
    }
}

/// Levels up to the end of the pass band, beyond which the march has kept nothing.
pub(crate) struct ShownLevels {
    times: Vec<f64>,
    positions: Option<Vec<f64>>,
    frequencies: Vec<f64>,
    levels: Vec<f64>,
    reference: String,
}

impl ShownLevels {
    fn new(history: &StoredHistory<'_>, found: levels::Spectrogram, reference: String) -> Self {
        let all = found.frequencies.len();
        let lines = found.frequencies.partition_point(|frequency| *frequency <= history.pass_band).max(1);
        let rows = found.levels.chunks(all.max(1));
        let times = || found.times.iter();
        Self {
            positions: history
                .positions
                .map(|positions| times().map(|time| history.position(positions, *time)).collect()),
            levels: rows.flat_map(|row| row.iter().take(lines).copied()).collect(),
            frequencies: found.frequencies.iter().take(lines).copied().collect(),
            times: found.times,
            reference,
        }
    }

    /// What is told of them.
    pub(crate) fn told(&self, asked: &AskedLevels<'_>) -> ToldSpectrogram {
        let loudest = |best: (usize, f64), own: (usize, f64)| if own.1 > best.1 { own } else { best };
        let all = self.levels.iter().copied().enumerate();
        let at = all.clone().next().map_or(0, |first| all.fold(first, loudest).0);
        let lines = self.frequencies.len().max(1);
        let (row, line) = (at / lines, at % lines);
        ToldSpectrogram {
            of: asked.asked.of.clone(),
            windows: self.times.len(),
            reference: self.reference.clone(),
            resolution_hz: self
                .frequencies
                .first()
                .zip(self.frequencies.get(1))
                .map(|(first, second)| second - first),
            peak_level_db: self.levels.get(at).copied(),
            peak_time_s: self.times.get(row).copied(),
            peak_position_m: self.positions.as_ref().map(|positions| positions.get(row).copied()),
            peak_frequency_hz: self.frequencies.get(line).copied(),
        }
    }

    /// The arrays, with what is asked of their drawing and the name of a locus whose zones are laid over.
    pub(crate) fn dataset(
        &self,
        asked: &AskedLevels<'_>,
        locus: Option<&str>,
    ) -> Result<Dataset, ModelError> {
        let coordinate = |name: &str, values: &[f64], unit: &str, label: &str| {
            Variable::coordinate(name, values.to_vec()).units(unit).attribute("label", label)
        };
        let ([signal, _], reference) = (asked.signal, &self.reference);
        let shape = [self.times.len(), self.frequencies.len()];
        let level = Variable::new("level", &["time", "frequency"], &shape, self.levels.clone())
            .units("dB")
            .long_name(&format!("level of {signal}, amplitude in dB of {reference}"))
            .attribute("label", format!("Level (dB re {})", reference.replace("^2", "^{2}")));
        let mut dataset = Dataset::new().with(
            coordinate("time", &self.times, "s", "Time $t$ (s)").long_name("time of the middle of a window"),
        )?;
        if let Some(positions) = &self.positions {
            let words = "distance of the contact point from the first node of the track at that time";
            let position = Variable::new("position", &["time"], &[positions.len()], positions.clone());
            dataset = dataset.with(position.as_coordinate().units("m").long_name(words))?;
        }
        dataset = dataset
            .with(coordinate("frequency", &self.frequencies, "Hz", "Frequency (Hz)").long_name("frequency"))?
            .with(level)?
            .attribute("of", asked.asked.of.as_str())?
            .attribute("signal", signal)?
            .attribute("window", asked.asked.pieces.window.name())?
            .attribute("reference", reference.clone())?;
        if let Some(locus) = locus {
            dataset = dataset.attribute("locus", locus)?;
        }
        if let Some(range) = asked.asked.drawn.range {
            dataset = dataset.attribute("range_db", json!(range))?;
        }
        match asked.asked.drawn.waterfall {
            Some(spectra) => Ok(dataset.attribute("waterfall", spectra)?),
            None => Ok(dataset),
        }
    }
}
