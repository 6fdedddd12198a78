//! What a march tells: scalars, bursts, warnings.

use super::Marched;
use super::blocks::OngoingMarch;
use super::expected::ToldAmplification;
use super::loudness::{PlacedBurst, SignalLoudness};
use super::signals::{unit, variable_name};
use super::sound::ToldSound;
use crate::error::ModelError;
use crate::sliding::case::observe::{PointQuantity, Signal};
use crate::sliding::march::settings::MarchAnalysis;
use crate::sliding::system::MarchStep;
use judder_numerics::signal::extremes::Extremes;
use judder_sliding::SlidingError;
use judder_sliding::amplification::Amplification;
use judder_sliding::coupling::SteadyFriction;
use judder_sliding::march::{ContactMethod, Predictor};
use judder_sliding::recorder::Tally;
use judder_sliding::statics::PairEquilibrium;
use judder_store::{Dataset, Declared, Results, Table, Variable};
use std::f64::consts::TAU;

/// A march that has ended, and what was found in it.
pub(super) struct EndedMarch<'a> {
    pub(super) of: &'a Marched<'a>,
    pub(super) chosen: MarchStep,
    /// Steps done.
    pub(super) steps: u64,
    pub(super) way: &'a OngoingMarch,
    pub(super) tally: &'a Tally,
    pub(super) loud: &'a SignalLoudness,
    pub(super) zones: &'a Result<Vec<Amplification>, SlidingError>,
}

impl EndedMarch<'_> {
    /// What `summary.json` shows.
    pub(super) fn told(&self, sound: Option<Vec<ToldSound>>) -> ToldMarch {
        let asked = self.of.march;
        let Tally { normal_force, sliding_velocity, slip_steps, stick_steps, open_steps, reversed_steps } =
            *self.tally;
        let (peak, position) = self.loud.peak.unzip();
        let (peak, peak_acceleration) =
            if is_acceleration(*asked.signal) { (None, Some(peak)) } else { (Some(peak), None) };
        ToldMarch {
            method: asked.word.name(),
            steps: self.steps,
            step_s: self.chosen.step,
            step_limit_s: self.chosen.limit,
            seconds: self.way.seconds,
            settled_s: self.of.motion.settled(),
            signal: asked.signal.name(self.of.points),
            signal_unit: unit(*asked.signal),
            peak_position_m: position,
            bursts: self.loud.bursts.iter().map(ToldBurst::new).collect(),
            normal_force: ValueSpan::of(&normal_force),
            sliding_velocity: ValueSpan::of(&sliding_velocity),
            slip_steps,
            stick_steps,
            open_steps,
            reversed_steps,
            peak,
            peak_acceleration,
            predictor: asked.predictor.map(Predictor::name),
            zones: self.zones.as_ref().ok().map(|zones| zones.iter().map(ToldAmplification::new).collect()),
            ended: self.way.ended.as_ref().map(|ended| ToldEnd {
                time_s: ended.time,
                position_m: ended.position,
                reason: ended.reason.clone(),
            }),
            sound,
        }
    }

    /// The bursts for a spreadsheet.
    pub(super) fn table(&self) -> Result<Table, ModelError> {
        let mut table = Table::new();
        for (name, unit, _, values) in self.burst_columns() {
            table = table.column(name, unit, values)?;
        }
        Ok(table)
    }

    /// What is stored beside the samples.
    pub(super) fn dataset(&self, sample_rate: f64) -> Result<Dataset, ModelError> {
        let asked = self.of.march;
        let mut dataset = Dataset::new()
            .attribute("kind", super::KIND.name)?
            .attribute("method", asked.word.name())?
            .attribute("signal", variable_name(*asked.signal, self.of.points))?
            .attribute("step_s", self.chosen.step)?
            .attribute("step_limit_s", self.chosen.limit)?
            .attribute("settled_s", self.of.motion.settled())?
            .attribute("sample_rate_hz", sample_rate)?
            .attribute("pass_band_hz", asked.signals.pass_band / TAU)?;
        if let Some(ended) = &self.way.ended {
            dataset = dataset.attribute("ended", ended.reason.clone())?;
        }
        for (name, unit, long_name, values) in self.burst_columns() {
            let variable = Variable::new(&format!("burst_{name}"), &["burst"], &[values.len()], values);
            dataset = dataset.with(variable.units(unit).long_name(long_name))?;
        }
        Ok(dataset)
    }

    /// Name, unit, meaning and values of what is known of each burst.
    fn burst_columns(&self) -> [(&'static str, &'static str, &'static str, Vec<f64>); 5] {
        let of = |value: &dyn Fn(&PlacedBurst) -> f64| self.loud.bursts.iter().map(value).collect::<Vec<_>>();
        [
            ("time", "s", "time of the peak of a burst", of(&|own| own.burst.peak_time)),
            ("position", "m", "position of the contact at that time", of(&|own| own.position)),
            ("frequency", "Hz", "frequency of a burst", of(&|own| own.burst.frequency.unwrap_or(f64::NAN))),
            ("peak", unit(*self.of.march.signal), "largest magnitude in a burst", of(&|own| own.burst.peak)),
            ("duration", "s", "duration of a burst", of(&|own| own.burst.duration)),
        ]
    }

    /// What to know before the numbers are trusted.
    pub(super) fn warnings(&self) -> Vec<String> {
        let mut warnings = Vec::new();
        let asked = self.of.march;
        if let Some(ended) = &self.way.ended {
            warnings.push(format!(
                "the march ended at {:.6} s, {:.4} mm, before the end of its path: {}; what it had computed until then is kept",
                ended.time,
                1e3 * ended.position,
                ended.reason
            ));
        }
        if self.loud.peak.is_none() {
            let settled = self.of.motion.settled();
            warnings.push(format!(
                "nothing is left of the march after its ramps, which end at {settled} s: no peak, no bursts"
            ));
        }
        if let Err(error) = self.zones {
            warnings.push(format!("no expected amplification beside the bursts: {error}"));
        }
        let motion = &self.of.motion;
        let sliding = SteadyFriction::at(self.of.pair.friction(), motion.velocity);
        let at_rest = PairEquilibrium::new(self.of.pair, motion.end, motion.load, sliding);
        if let (Ok(_), Err(error @ SlidingError::NoEquilibrium { .. })) = (self.zones, at_rest) {
            warnings.push(format!("{error}: the contact opens"));
        }
        let knows_sliding_alone = asked.method() != ContactMethod::Film;
        let Tally { reversed_steps, open_steps, .. } = self.tally;
        if knows_sliding_alone && *reversed_steps > 0 {
            warnings.push(format!(
                "in {reversed_steps} steps the contact slid backwards, which `{}` takes for sliding ahead; `film` knows stick and both directions",
                asked.word.name()
            ));
        }
        if *open_steps > 0 {
            let shares = 100.0 * *open_steps as f64 / self.steps.max(1) as f64;
            warnings.push(format!("in {open_steps} steps ({shares:.2} % of all) the contact was open"));
        }
        warnings
    }
}

/// What is told of a march.
#[derive(Results)]
pub(super) struct ToldMarch {
    method: &'static str,
    steps: u64,
    step_s: f64,
    /// the longest that the step may be
    step_limit_s: f64,
    /// by the clock on the wall
    seconds: f64,
    /// when the ramps are over
    settled_s: f64,
    signal: String,
    signal_unit: &'static str,
    peak_position_m: Option<f64>,
    bursts: Vec<ToldBurst>,
    normal_force: ValueSpan,
    sliding_velocity: ValueSpan,
    slip_steps: u64,
    stick_steps: u64,
    open_steps: u64,
    reversed_steps: u64,
    /// the largest magnitude of a signal that is no acceleration
    #[result(optional)]
    peak: Option<Option<f64>>,
    #[result(optional)]
    peak_acceleration: Option<Option<f64>>,
    #[result(optional)]
    predictor: Option<&'static str>,
    /// the unstable zones on the way
    #[result(optional)]
    zones: Option<Vec<ToldAmplification>>,
    /// why it ended early
    #[result(optional)]
    ended: Option<ToldEnd>,
    #[result(optional)]
    sound: Option<Vec<ToldSound>>,
}

/// A burst of the whole signal, with the growth in nepers of the mode of the zone that was passed.
#[derive(Results)]
struct ToldBurst {
    position_m: f64,
    time_s: f64,
    frequency_hz: Option<f64>,
    peak: f64,
    duration_s: f64,
    level_before: Option<f64>,
    #[result(unit = "1")]
    measured_amplification: Option<f64>,
    #[result(unit = "1")]
    expected_amplification: Option<f64>,
}

impl ToldBurst {
    fn new(own: &PlacedBurst) -> Self {
        let PlacedBurst { burst, position, level_before, growth } = own;
        Self {
            position_m: *position,
            time_s: burst.peak_time,
            frequency_hz: burst.frequency,
            peak: burst.peak,
            duration_s: burst.duration,
            level_before: *level_before,
            measured_amplification: growth.and_then(|own| own.measured),
            expected_amplification: growth.map(|own| own.expected),
        }
    }
}

/// Where and why a march ended before the end of its path.
#[derive(Results)]
struct ToldEnd {
    time_s: f64,
    position_m: f64,
    reason: String,
}

/// The smallest and the largest value.
#[derive(Results)]
struct ValueSpan {
    min: Option<f64>,
    max: Option<f64>,
}

impl ValueSpan {
    fn of(extremes: &Extremes) -> Self {
        let [min, max] = [extremes.minimum(), extremes.maximum()].map(|end| end.map(|(_, value)| value));
        Self { min, max }
    }
}

/// The keys of the summary of a march.
pub(super) fn summary_keys(asked: &MarchAnalysis) -> Vec<Declared> {
    let other_peak = if is_acceleration(*asked.signal) { "peak" } else { "peak_acceleration" };
    let mut keys = ToldMarch::declared();
    keys.retain(|key| key.name != other_peak);
    keys
}

/// Whether the largest magnitude of a signal is called that of an acceleration.
fn is_acceleration(signal: Signal) -> bool {
    matches!(signal, Signal::Point { quantity: PointQuantity::Acceleration, .. })
}
