//! What the claims of the beams paper are measured on: summaries and signals of a study folder.

use crate::error::StudyError;
use crate::pictures::reals;
use crate::reproduce::is_done;
use judder_store::{Dataset, StudyFolder, Summary};
use serde_json::{Map, Value};
use std::collections::BTreeMap;

/// Stored results of the reproduction.
pub(super) struct Found {
    results: BTreeMap<String, Map<String, Value>>,
    ensubs: Option<Dataset>,
    film: Option<Dataset>,
}

/// An unstable zone of a locus.
#[derive(Debug, Clone, Copy)]
pub(super) struct Zone {
    pub(super) from: f64,
    pub(super) to: f64,
    pub(super) frequency: f64,
    pub(super) growth: f64,
}

/// A burst of a march.
#[derive(Debug, Clone, Copy)]
pub(super) struct Burst {
    pub(super) position: f64,
    pub(super) frequency: f64,
    pub(super) peak: f64,
    /// ln(peak/level before), and what the zone promises; NaN where there is none.
    pub(super) measured: f64,
    pub(super) expected: f64,
}

impl Found {
    /// From a study folder.
    pub(super) fn stored(store: &StudyFolder, summary: &Summary) -> Result<Self, StudyError> {
        let read = |name: &str| is_done(summary, name).then(|| store.read_dataset(name)).transpose();
        Ok(Self { results: summary.results.clone(), ensubs: read("ensubs")?, film: read("film")? })
    }

    /// A value of an analysis, by a path of keys; null where there is none.
    fn value(&self, analysis: &str, path: &[&str]) -> &Value {
        let own = self.results.get(analysis).and_then(|own| own.get(*path.first()?));
        path.iter().skip(1).fold(own.unwrap_or(&Value::Null), |value, key| &value[*key])
    }

    /// A number of an analysis; NaN where there is none.
    pub(super) fn number(&self, analysis: &str, path: &[&str]) -> f64 {
        self.value(analysis, path).as_f64().unwrap_or(f64::NAN)
    }

    /// The unstable zones of a locus.
    pub(super) fn zones(&self, locus: &str) -> Vec<Zone> {
        let of = |zone: &Value| {
            let number = |key: &str| zone[key].as_f64().unwrap_or(f64::NAN);
            Zone {
                from: number("from_m"),
                to: number("to_m"),
                frequency: number("frequency_hz"),
                growth: number("max_growth_rate"),
            }
        };
        self.value(locus, &["unstable"]).as_array().into_iter().flatten().map(of).collect()
    }

    /// The bursts of a march.
    pub(super) fn bursts(&self, march: &str) -> Vec<Burst> {
        let of = |burst: &Value| {
            let number = |key: &str| burst[key].as_f64().unwrap_or(f64::NAN);
            Burst {
                position: number("position_m"),
                frequency: number("frequency_hz"),
                peak: number("peak"),
                measured: number("measured_amplification"),
                expected: number("expected_amplification"),
            }
        };
        self.value(march, &["bursts"]).as_array().into_iter().flatten().map(of).collect()
    }

    /// Growth rates in marches with the contact held: name, measured, predicted.
    pub(super) fn growths(&self, method: &str) -> Vec<(f64, f64)> {
        let prefix = format!("growth-{method}-");
        let names = self.results.keys().filter(|name| name.starts_with(&prefix));
        names.map(|name| (self.number(name, &["measured"]), self.number(name, &["predicted"]))).collect()
    }

    /// By how much the acceleration of T differs between EnSubs and FiLM after the ramps, rms over rms; NaN where one is missing.
    pub(super) fn difference(&self) -> f64 {
        let settled = self.number("ensubs", &["settled_s"]);
        let signal = |dataset: &Option<Dataset>| -> Option<Vec<f64>> {
            let dataset = dataset.as_ref()?;
            let (time, values) = (reals(dataset, "time")?, reals(dataset, "T.y")?);
            Some(
                time.iter()
                    .zip(values)
                    .filter(|(time, _)| **time > settled)
                    .map(|(_, value)| *value)
                    .collect(),
            )
        };
        let (Some(a), Some(b)) = (signal(&self.ensubs), signal(&self.film)) else { return f64::NAN };
        let square = |values: &mut dyn Iterator<Item = f64>| values.map(|v| v * v).sum::<f64>();
        (square(&mut a.iter().zip(&b).map(|(a, b)| a - b)) / square(&mut a.iter().copied())).sqrt()
    }
}
