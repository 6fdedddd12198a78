//! What the claims of the beams paper are measured on: summaries and signals of a study folder.

use super::figures::SIGNAL;
use super::passage::{Passage, PassedZone, passages};
use crate::summary::is_done;
use judder_models::band::Band;
use judder_store::{Dataset, StudyFolder, Summary};
use judder_study::StudyError;
use judder_study::pictures::{StoredArrays, reals};
use serde_json::{Map, Value};
use std::collections::BTreeMap;

/// Stored results of the reproduction.
pub(super) struct StoredResults {
    results: BTreeMap<String, Map<String, Value>>,
    ensubs: Option<Dataset>,
    film: Option<Dataset>,
    residual: Option<Dataset>,
    locus: Option<Dataset>,
}

/// Between two places at which amplitudes are compared, s.
const BETWEEN: f64 = 1e-3;
/// Of the largest amplitude, what is worth a comparison.
const LOUD: f64 = 0.1;

/// A burst of a march.
#[derive(Debug, Clone, Copy)]
pub(super) struct StoredBurst {
    pub(super) position: f64,
    pub(super) frequency: f64,
    pub(super) peak: f64,
}

impl StoredResults {
    /// From a study folder.
    pub(super) fn stored(store: &StudyFolder, summary: &Summary) -> Result<Self, StudyError> {
        let read = |name: &str| is_done(summary, name).then(|| store.read_dataset(name)).transpose();
        Ok(Self {
            results: summary.results.clone(),
            ensubs: read("ensubs")?,
            film: read("film")?,
            residual: read("residual-flexibility")?,
            locus: read("locus-deformed")?,
        })
    }

    /// Results alone, without any signal.
    #[cfg(test)]
    pub(super) fn of_results(results: BTreeMap<String, Map<String, Value>>) -> Self {
        Self { results, ensubs: None, film: None, residual: None, locus: None }
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

    /// The largest magnitude of the acceleration of T in a march, m/s².
    pub(super) fn peak(&self, march: &str) -> f64 {
        self.number(march, &["peak_acceleration"])
    }

    /// The unstable zones of a locus.
    pub(super) fn zones(&self, locus: &str) -> Vec<PassedZone> {
        Self::zones_of(&self.results, locus, "unstable")
    }

    /// The zones that the result of an analysis lists under a key.
    pub(super) fn zones_of(
        results: &BTreeMap<String, Map<String, Value>>,
        analysis: &str,
        key: &str,
    ) -> Vec<PassedZone> {
        let of = |zone: &Value| {
            let number = |key: &str| zone[key].as_f64().unwrap_or(f64::NAN);
            PassedZone {
                from: number("from_m"),
                to: number("to_m"),
                peak: number("peak_m"),
                frequency: number("frequency_hz"),
                growth: number("max_growth_rate"),
                nepers: number("expected_amplification"),
            }
        };
        let listed = results.get(analysis).and_then(|own| own.get(key)?.as_array());
        listed.into_iter().flatten().map(of).collect()
    }

    /// The zones that EnSubs has passed.
    pub(super) fn passages(&self) -> Vec<Passage> {
        let zones = Self::zones_of(&self.results, "ensubs", "zones");
        let locus = self.locus.as_ref().map(StoredArrays::of);
        let of = |ensubs: &Dataset| passages(&StoredArrays::of(ensubs), SIGNAL, &zones, locus.as_ref());
        self.ensubs.as_ref().map(of).unwrap_or_default()
    }

    /// The bursts of a march.
    pub(super) fn bursts(&self, march: &str) -> Vec<StoredBurst> {
        let of = |burst: &Value| {
            let number = |key: &str| burst[key].as_f64().unwrap_or(f64::NAN);
            StoredBurst {
                position: number("position_m"),
                frequency: number("frequency_hz"),
                peak: number("peak"),
            }
        };
        self.value(march, &["bursts"]).as_array().into_iter().flatten().map(of).collect()
    }

    /// The burst of a march with the highest peak.
    pub(super) fn loudest(&self, march: &str) -> Option<StoredBurst> {
        self.bursts(march).into_iter().max_by(|a, b| a.peak.total_cmp(&b.peak))
    }

    /// The largest relative difference of the amplitude in the band of a frequency between the march with residual flexibility and EnSubs,
    /// where that of EnSubs is a tenth of its largest or more, after the ramps; NaN where one is missing.
    pub(super) fn difference_of_envelopes(&self, frequency: f64) -> f64 {
        let settled = self.number("ensubs", &["settled_s"]);
        let envelope = |march: &Option<Dataset>| -> Option<Vec<f64>> {
            let march = march.as_ref()?;
            let (time, values) = (reals(march, "time")?, reals(march, SIGNAL)?);
            let band = Band::new(frequency, time.get(1)? - time.first()?);
            let count = ((time.last()? - settled) / BETWEEN) as usize;
            let at = |k: usize| time.partition_point(|own| *own < settled + k as f64 * BETWEEN);
            Some((0..count).map(|k| band.amplitude(values, at(k))).collect())
        };
        let (Some(ours), Some(theirs)) = (envelope(&self.residual), envelope(&self.ensubs)) else {
            return f64::NAN;
        };
        let largest = theirs.iter().copied().fold(0.0, f64::max);
        let loud =
            ours.iter().zip(&theirs).filter(|(own, other)| **other >= LOUD * largest && own.is_finite());
        loud.map(|(own, other)| (own / other - 1.0).abs()).fold(0.0, f64::max)
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
            let (time, values) = (reals(dataset, "time")?, reals(dataset, SIGNAL)?);
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
