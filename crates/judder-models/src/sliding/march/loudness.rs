//! Where a signal of a march is loud.

use super::expected::zone_of;
use super::signals::variable_name;
use crate::band::Sampled;
use crate::error::ModelError;
use crate::samples::Samples;
use crate::sliding::case::observe::{ObservedPoint, Signal};
use judder_numerics::signal::SignalError;
use judder_numerics::signal::bursts::{Burst, BurstSettings, bursts};
use judder_sliding::amplification::Amplification;

/// A burst with the place where the contact was at its peak.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct PlacedBurst {
    pub(super) burst: Burst,
    /// m.
    pub(super) position: f64,
    /// Level before it, in the unit of the signal: √2 times the rms of as long a stretch, or of what there is after the ramps.
    pub(super) level_before: Option<f64>,
    /// What its mode has done in the zone that it has passed.
    pub(super) growth: Option<ZoneGrowth>,
}

/// Growth of one mode through an unstable zone, in nepers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ZoneGrowth {
    /// ∫ max(σ, 0) dt.
    pub(super) expected: f64,
    /// ln of the amplitude at the frequency of the zone where the contact has left it, over that where it has entered; none where the
    /// signal does not reach beyond both.
    pub(super) measured: Option<f64>,
}

/// The peak of a signal and its bursts, after the ramps.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct SignalLoudness {
    /// The largest magnitude, and where the contact was, m.
    pub(super) peak: Option<(f64, f64)>,
    pub(super) bursts: Vec<PlacedBurst>,
}

/// The history of one signal after the ramps.
struct SignalHistory {
    times: Vec<f64>,
    positions: Vec<f64>,
    values: Vec<f64>,
}

impl SignalHistory {
    fn new(samples: &Samples<'_>, name: &str, settled: f64) -> Result<Self, ModelError> {
        let (times, positions) = (samples.values("time")?, samples.values("position")?);
        let values = samples.values(name)?;
        let first = times.partition_point(|time| *time <= settled);
        // a march that has grown without bound ends in what is no number
        let length = values[first..].iter().position(|value| !value.is_finite());
        let end = length.map_or(values.len(), |length| first + length);
        let cut = |values: Vec<f64>| values[first..end].to_vec();
        Ok(Self { times: cut(times), positions: cut(positions), values: cut(values) })
    }

    /// What the mode of a zone has done in it.
    fn growth(&self, Amplification { zone, nepers, .. }: &Amplification) -> ZoneGrowth {
        let sampled = Sampled { time: &self.times, position: &self.positions, values: &self.values };
        let passage = sampled.passage(zone.frequency_hz, [zone.from, zone.to]);
        let measured = passage.map(|[before, after]| libm::log(after / before));
        ZoneGrowth { expected: *nepers, measured: measured.filter(|own| own.is_finite()) }
    }

    fn index(&self, time: f64) -> usize {
        self.times.partition_point(|own| *own < time).min(self.times.len().saturating_sub(1))
    }

    fn position(&self, time: f64) -> f64 {
        self.positions.get(self.index(time)).copied().unwrap_or(f64::NAN)
    }

    /// √2 times the rms of as much as a burst lasts, right before it.
    fn level_before(&self, burst: &Burst) -> Option<f64> {
        let (first, end) = (self.index(burst.start - burst.duration.max(1e-3)), self.index(burst.start));
        let before = &self.values[first..end];
        let square = before.iter().map(|value| value * value).sum::<f64>() / before.len() as f64;
        (!before.is_empty() && square > 0.0).then(|| (2.0 * square).sqrt())
    }
}

/// The peak and the bursts of a signal after the ramps, which zones promise; `sample_rate` is that of the samples, Hz.
pub(super) fn loudness(
    samples: &Samples<'_>,
    signal: Signal,
    points: &[ObservedPoint],
    settled: f64,
    sample_rate: f64,
    zones: &[Amplification],
) -> Result<SignalLoudness, ModelError> {
    let history = SignalHistory::new(samples, &variable_name(signal, points), settled)?;
    let Some(start) = history.times.first() else { return Ok(SignalLoudness::default()) };
    let largest = |best: usize, k: usize| {
        if history.values[k].abs() > history.values[best].abs() { k } else { best }
    };
    let at = (0..history.values.len()).fold(0, largest);
    let peak = history.values.get(at).map(|value| (value.abs(), history.positions[at]));
    let settings = BurstSettings { start: *start, ..BurstSettings::new(sample_rate) };
    let found = match bursts(&history.values, &settings) {
        // too little of it to tell a burst from what is around it
        Err(SignalError::TooShort { .. }) => Vec::new(),
        found => found?,
    };
    let placed = |burst: Burst| {
        let (position, start) = (history.position(burst.peak_time), history.position(burst.start));
        let zone = zone_of(zones, burst.frequency, [start, position]);
        let growth = zone.map(|zone| history.growth(zone));
        PlacedBurst { burst, position, level_before: history.level_before(&burst), growth }
    };
    Ok(SignalLoudness { peak, bursts: found.into_iter().map(placed).collect() })
}
