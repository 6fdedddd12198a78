//! The levels of a stored signal, with the zones of a stored locus.

use crate::error::ModelError;
use crate::sliding::case::observe::ObservedPoint;
use crate::sliding::march::variable_name;
use crate::sliding::spectrogram::settings::{SpectrogramAnalysis, SpectrogramWindow};
use judder_numerics::signal::spectrogram::{self as levels, SpectrogramSettings};
use judder_numerics::signal::window::Window;
use judder_store::{Dataset, Results, Variable};
use judder_study::kept::StudyPlace;
use judder_study::outcome::Outcome;
use judder_study::pictures::reals;
use serde_json::{Value, json};

/// Levels of a signal over time and frequency, with the unstable zones of a locus.
pub(crate) fn run(
    name: &str,
    asked: &SpectrogramAnalysis,
    points: &[ObservedPoint],
    place: Option<StudyPlace<'_>>,
) -> Result<Outcome, ModelError> {
    let needs = |analysis: &str| ModelError::NotDone { analysis: analysis.to_owned(), by: name.to_owned() };
    let place = place.ok_or_else(|| needs(&asked.of))?;
    let is_done = |analysis: &str| -> Result<bool, ModelError> {
        let hash = place.all.iter().find(|(other, _)| other == analysis).map_or("", |(_, hash)| hash);
        Ok(place.study.is_done(analysis, hash)?)
    };
    for other in [Some(&asked.of), asked.locus.as_ref()].into_iter().flatten() {
        if !is_done(other)? {
            return Err(needs(other));
        }
    }
    let march = place.study.read_dataset(&asked.of)?;
    let signal = variable_name(*asked.signal, points);
    let history = StoredHistory::new(&march, &signal).ok_or_else(|| ModelError::NotRecorded {
        march: asked.of.clone(),
        signal: asked.signal.name(points),
    })?;
    let found = levels::spectrogram(history.values, &history.settings(asked))?;
    let zones = match &asked.locus {
        Some(locus) => zones(&place, locus)?,
        None => Vec::new(),
    };
    let shown = ShownLevels::new(&history, found);
    let unit = march.variable(&signal).map_or("", |variable| variable.units.as_str());
    let reference = format!("{} {unit}", asked.reference.0.number);
    Ok(Outcome {
        scalars: shown.told(asked, &reference).scalars(),
        dataset: shown.dataset(asked, &signal, &reference, &zones)?,
        ..Outcome::default()
    })
}

/// What is told of a spectrogram.
#[derive(Results)]
pub(super) struct ToldSpectrogram {
    /// the march
    of: String,
    windows: usize,
    /// what levels refer to
    reference: String,
    resolution_hz: Option<f64>,
    peak_level_db: Option<f64>,
    peak_time_s: Option<f64>,
    peak_position_m: Option<f64>,
    peak_frequency_hz: Option<f64>,
}

/// The stored history of a signal, as far as it is finite.
struct StoredHistory<'a> {
    times: &'a [f64],
    positions: &'a [f64],
    values: &'a [f64],
    sample_rate: f64,
    pass_band: f64,
}

impl<'a> StoredHistory<'a> {
    fn new(march: &'a Dataset, signal: &str) -> Option<Self> {
        let values = reals(march, signal)?;
        let finite = values.iter().position(|value| !value.is_finite()).unwrap_or(values.len());
        let number = |name: &str| march.attributes().get(name).and_then(Value::as_f64);
        Some(Self {
            times: reals(march, "time")?,
            positions: reals(march, "position")?,
            values: &values[..finite],
            sample_rate: number("sample_rate_hz")?,
            pass_band: number("pass_band_hz")?,
        })
    }

    fn settings(&self, asked: &SpectrogramAnalysis) -> SpectrogramSettings {
        SpectrogramSettings {
            start: self.times.first().copied().unwrap_or(0.0),
            window: match asked.window {
                SpectrogramWindow::Hann => Window::Hann,
                SpectrogramWindow::Hamming => Window::Hamming,
                SpectrogramWindow::Blackman => Window::Blackman,
                SpectrogramWindow::Rectangular => Window::Rectangular,
            },
            length: (asked.length * self.sample_rate).round() as usize,
            overlap: asked.overlap,
            reference: asked.reference.0.number,
            ..SpectrogramSettings::new(self.sample_rate)
        }
    }

    fn position(&self, time: f64) -> f64 {
        let last = self.times.len().saturating_sub(1);
        let index = self.times.partition_point(|own| *own < time).min(last);
        self.positions.get(index).copied().unwrap_or(f64::NAN)
    }
}

/// Levels up to the end of the pass band, beyond which the march has kept nothing.
struct ShownLevels {
    times: Vec<f64>,
    positions: Vec<f64>,
    frequencies: Vec<f64>,
    levels: Vec<f64>,
}

impl ShownLevels {
    fn new(history: &StoredHistory<'_>, found: levels::Spectrogram) -> Self {
        let all = found.frequencies.len();
        let lines = found.frequencies.partition_point(|frequency| *frequency <= history.pass_band).max(1);
        let rows = found.levels.chunks(all);
        Self {
            positions: found.times.iter().map(|time| history.position(*time)).collect(),
            levels: rows.flat_map(|row| row[..lines].iter().copied()).collect(),
            times: found.times,
            frequencies: found.frequencies[..lines].to_vec(),
        }
    }

    fn told(&self, asked: &SpectrogramAnalysis, reference: &str) -> ToldSpectrogram {
        let loudest = |best: usize, k: usize| if self.levels[k] > self.levels[best] { k } else { best };
        let at = (0..self.levels.len()).fold(0, loudest);
        let (row, line) = (at / self.frequencies.len(), at % self.frequencies.len());
        ToldSpectrogram {
            of: asked.of.clone(),
            windows: self.times.len(),
            reference: reference.to_owned(),
            resolution_hz: self.frequencies.get(1).map(|second| second - self.frequencies[0]),
            peak_level_db: self.levels.get(at).copied(),
            peak_time_s: self.times.get(row).copied(),
            peak_position_m: self.positions.get(row).copied(),
            peak_frequency_hz: self.frequencies.get(line).copied(),
        }
    }

    fn dataset(
        &self,
        asked: &SpectrogramAnalysis,
        signal: &str,
        reference: &str,
        zones: &[LocusZone],
    ) -> Result<Dataset, ModelError> {
        let coordinate = |name: &str, values: &[f64], unit: &str, label: &str| {
            Variable::coordinate(name, values.to_vec()).units(unit).attribute("label", label)
        };
        let along_time = |name: &str, values: &[f64]| {
            Variable::new(name, &["time"], &[values.len()], values.to_vec()).as_coordinate()
        };
        let shape = [self.times.len(), self.frequencies.len()];
        let level = Variable::new("level", &["time", "frequency"], &shape, self.levels.clone())
            .units("dB")
            .long_name(&format!("level of {signal}, amplitude in dB of {reference}"))
            .attribute("label", format!("Level (dB re {})", reference.replace("^2", "^{2}")));
        let mut dataset = Dataset::new()
            .with(
                coordinate("time", &self.times, "s", "Time $t$ (s)")
                    .long_name("time of the middle of a window"),
            )?
            .with(
                along_time("position", &self.positions)
                    .units("m")
                    .long_name("distance of the contact point from the first node of the track at that time"),
            )?
            .with(coordinate("frequency", &self.frequencies, "Hz", "Frequency (Hz)").long_name("frequency"))?
            .with(level)?
            .attribute("of", asked.of.clone())?
            .attribute("signal", signal)?
            .attribute("window", asked.window.name())?
            .attribute("reference", reference)?;
        if let Some(locus) = &asked.locus {
            dataset = dataset.attribute("locus", locus.clone())?;
        }
        if let Some(range) = asked.range {
            dataset = dataset.attribute("range_db", json!(range))?;
        }
        if let Some(spectra) = asked.waterfall {
            dataset = dataset.attribute("waterfall", spectra)?;
        }
        for (name, unit, values) in [
            ("zone_from", "m", zones.iter().map(|zone| zone.from).collect::<Vec<_>>()),
            ("zone_to", "m", zones.iter().map(|zone| zone.to).collect()),
            ("zone_frequency", "Hz", zones.iter().map(|zone| zone.frequency).collect()),
            ("zone_growth_rate", "1/s", zones.iter().map(|zone| zone.growth_rate).collect()),
        ] {
            let what = format!("unstable zone of the locus, {}", name.replace('_', " "));
            let variable = Variable::new(name, &["zone"], &[values.len()], values);
            dataset = dataset.with(variable.units(unit).long_name(&what))?;
        }
        Ok(dataset)
    }
}

/// An unstable zone of a locus.
struct LocusZone {
    from: f64,
    to: f64,
    frequency: f64,
    growth_rate: f64,
}

/// The unstable zones that a locus has left in the summary.
fn zones(place: &StudyPlace<'_>, locus: &str) -> Result<Vec<LocusZone>, ModelError> {
    let summary = place.study.read_summary()?;
    let results = summary.as_ref().and_then(|summary| summary.results.get(locus));
    let listed = results.and_then(|results| results.get("unstable")).and_then(Value::as_array);
    let zone = |listed: &Value| {
        let number = |key: &str| listed.get(key).and_then(Value::as_f64);
        Some(LocusZone {
            from: number("from_m")?,
            to: number("to_m")?,
            frequency: number("frequency_hz")?,
            growth_rate: number("max_growth_rate")?,
        })
    };
    Ok(listed.into_iter().flatten().filter_map(zone).collect())
}
