//! What a march tells: scalars, bursts, warnings.

use super::Marched;
use super::blocks::Way;
use super::expected;
use super::loudness::{Loudness, PlacedBurst};
use super::signals::{unit, variable_name};
use crate::error::ModelError;
use crate::sliding::case::observe::{PointQuantity, Signal};
use crate::sliding::march::settings::MarchMethod;
use crate::sliding::system::Step;
use judder_numerics::signal::extremes::Extremes;
use judder_sliding::SlidingError;
use judder_sliding::amplification::Amplification;
use judder_sliding::coupling::Sliding;
use judder_sliding::recorder::Tally;
use judder_sliding::statics::PairEquilibrium;
use judder_store::{Dataset, Table, Variable};
use serde_json::{Map, Value, json};
use std::f64::consts::TAU;

/// A march that has ended, and what was found in it.
pub(super) struct Told<'a> {
    pub(super) of: &'a Marched<'a>,
    pub(super) chosen: Step,
    /// Steps done.
    pub(super) steps: u64,
    pub(super) way: &'a Way,
    pub(super) tally: &'a Tally,
    pub(super) loud: &'a Loudness,
    pub(super) zones: &'a Result<Vec<Amplification>, SlidingError>,
}

impl Told<'_> {
    /// What `summary.json` shows.
    pub(super) fn scalars(&self) -> Map<String, Value> {
        let asked = self.of.march;
        let Tally { normal_force, sliding_velocity, slip_steps, stick_steps, open_steps, reversed_steps } =
            self.tally;
        let (peak, position) = self.loud.peak.unzip();
        let mut scalars = json!({
            "method": asked.method().name(), "steps": self.steps, "step_s": self.chosen.step,
            "step_limit_s": self.chosen.limit, "seconds": self.way.seconds, "settled_s": self.of.motion.settled(),
            "signal": asked.signal.name(self.of.points), "signal_unit": unit(*asked.signal),
            "peak_position_m": position, "bursts": self.loud.bursts.iter().map(|own| self.burst(own)).collect::<Vec<_>>(),
            "normal_force": span(normal_force), "sliding_velocity": span(sliding_velocity),
            "slip_steps": slip_steps, "stick_steps": stick_steps, "open_steps": open_steps, "reversed_steps": reversed_steps,
        });
        scalars[peak_key(*asked.signal)] = json!(peak);
        if let Some(predictor) = asked.predictor {
            scalars["predictor"] = json!(predictor.name());
        }
        if let Ok(zones) = self.zones {
            scalars["zones"] = zones.iter().map(expected::told).collect();
        }
        if let Some(ended) = &self.way.ended {
            scalars["ended"] =
                json!({ "time_s": ended.time, "position_m": ended.position, "reason": ended.reason });
        }
        match scalars {
            Value::Object(map) => map,
            _ => Map::new(),
        }
    }

    /// A burst of the whole signal, with the growth in nepers of the mode of the zone that was passed.
    fn burst(&self, own: &PlacedBurst) -> Value {
        let PlacedBurst { burst, position, level_before, growth } = own;
        json!({
            "position_m": position, "time_s": burst.peak_time, "frequency_hz": burst.frequency, "peak": burst.peak,
            "duration_s": burst.duration, "level_before": level_before,
            "measured_amplification": growth.and_then(|own| own.measured),
            "expected_amplification": growth.map(|own| own.expected),
        })
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
            .attribute("kind", "march")?
            .attribute("method", asked.method().name())?
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
        let sliding = Sliding::at(self.of.pair.friction(), motion.velocity);
        let at_rest = PairEquilibrium::new(self.of.pair, motion.end, motion.load, sliding);
        if let (Ok(_), Err(error @ SlidingError::NoEquilibrium { .. })) = (self.zones, at_rest) {
            warnings.push(format!("{error}: the contact opens"));
        }
        let knows_sliding_alone = asked.method() != MarchMethod::Film;
        let Tally { reversed_steps, open_steps, .. } = self.tally;
        if knows_sliding_alone && *reversed_steps > 0 {
            warnings.push(format!(
                "in {reversed_steps} steps the contact slid backwards, which `{}` takes for sliding ahead; `film` knows stick and both directions",
                asked.method().name()
            ));
        }
        if *open_steps > 0 {
            let shares = 100.0 * *open_steps as f64 / self.steps.max(1) as f64;
            warnings.push(format!("in {open_steps} steps ({shares:.2} % of all) the contact was open"));
        }
        warnings
    }
}

/// The key of the peak: that of an acceleration says so.
fn peak_key(signal: Signal) -> &'static str {
    match signal {
        Signal::Point { quantity: PointQuantity::Acceleration, .. } => "peak_acceleration",
        _ => "peak",
    }
}

fn span(extremes: &Extremes) -> Value {
    json!({ "min": extremes.minimum().map(|(_, value)| value), "max": extremes.maximum().map(|(_, value)| value) })
}
