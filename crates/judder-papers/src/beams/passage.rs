//! What an unstable zone does to the mode that it concerns, in a march that passes it.

use judder_models::band::Sampled;
use judder_models::sliding::locus::figure::zone_profiles;
use judder_report::figure::ShadedRegion;
use judder_report::{Axis, Layer, Legend, Panel, Role};
use judder_study::pictures::{StoredArrays, reals};
use serde_json::Value;

/// Zones that promise less, in nepers, drown in what the clicks at the nodes excite.
const WORTH: f64 = 1.0;
/// Positions at which the amplitude is taken, and how far they reach beyond the zone, over its width.
const PLACES: usize = 161;
const BEYOND: f64 = 0.75;

/// An unstable zone of a locus.
#[derive(Debug, Clone, Copy)]
pub(super) struct PassedZone {
    pub(super) from: f64,
    pub(super) to: f64,
    /// Where it grows fastest; NaN where that is not told.
    pub(super) peak: f64,
    pub(super) frequency: f64,
    pub(super) growth: f64,
    /// ∫ σ dt of a march through it; NaN where none was computed.
    pub(super) nepers: f64,
}

/// A zone that a march has passed, with the amplitude of its mode.
pub(super) struct Passage {
    /// The zone.
    pub(super) zone: PassedZone,
    /// Positions, m, and the amplitude of the signal in a band about the frequency of the zone.
    amplitudes: Vec<(f64, f64)>,
    /// ln of the amplitude at the end of the zone over that at its start.
    pub(super) measured: f64,
    /// Positions, m, and the amplitude that the eigenvalues promise from the start of the zone on.
    promised: Vec<(f64, f64)>,
}

/// The zones worth it that a march has passed whole after its ramps; `locus` has their growth rates.
pub(super) fn passages(
    march: &StoredArrays<'_>,
    signal: &str,
    zones: &[PassedZone],
    locus: Option<&StoredArrays<'_>>,
) -> Vec<Passage> {
    let profiles = locus.map(zone_profiles).unwrap_or_default();
    let worth = zones.iter().filter(|zone| zone.nepers >= WORTH);
    worth.filter_map(|zone| passage(march, signal, *zone, &profiles)).collect()
}

fn passage(
    march: &StoredArrays<'_>,
    signal: &str,
    zone: PassedZone,
    profiles: &[Vec<(f64, f64)>],
) -> Option<Passage> {
    march.over("position", &["time"])?;
    march.over(signal, &["time"])?;
    let (time, position, values) = (reals(march, "time")?, reals(march, "position")?, reals(march, signal)?);
    let settled = march.attributes().get("settled_s").and_then(Value::as_f64)?;
    let first = time.partition_point(|own| *own <= settled);
    let (time, position, values) = (time.get(first..)?, position.get(first..)?, values.get(first..)?);
    let sampled = Sampled { time, position, values };
    let [before, after] = sampled.passage(zone.frequency, [zone.from, zone.to])?;
    let band = sampled.band(zone.frequency)?;
    let amplitude = |at: f64| band.amplitude(sampled.values, sampled.sample(at));
    let width = zone.to - zone.from;
    let place =
        |k: usize| zone.from + width * ((1.0 + 2.0 * BEYOND) * k as f64 / (PLACES - 1) as f64 - BEYOND);
    let middle = 0.5 * (zone.from + zone.to);
    let holds = |profile: &&Vec<(f64, f64)>| {
        profile.first().is_some_and(|first| first.0 < middle)
            && profile.last().is_some_and(|last| last.0 > middle)
    };
    let own = profiles.iter().filter(holds).max_by(|a, b| integral(a).total_cmp(&integral(b)));
    Some(Passage {
        zone,
        amplitudes: (0..PLACES).map(|k| (place(k), amplitude(place(k)))).collect(),
        measured: libm::log(after / before),
        promised: own.map_or_else(Vec::new, |profile| promised(profile, zone.nepers, before)),
    })
}

/// Trapezoids under a curve.
fn integral(curve: &[(f64, f64)]) -> f64 {
    curve.windows(2).map(|p| 0.5 * (p[0].1 + p[1].1) * (p[1].0 - p[0].0)).sum()
}

/// Growth along a profile of growth rates that comes to so many nepers in all.
fn promised(profile: &[(f64, f64)], nepers: f64, before: f64) -> Vec<(f64, f64)> {
    let whole = integral(profile);
    let along = |k: usize| (profile[k].0, before * libm::exp(nepers * integral(&profile[..=k]) / whole));
    (0..profile.len()).map(along).collect()
}

impl Passage {
    /// How far behind the zone amplitudes were taken, m.
    pub(super) fn beyond(&self) -> f64 {
        BEYOND * (self.zone.to - self.zone.from)
    }

    /// The amplitude there over the largest; NaN where the march ended before.
    pub(super) fn left_behind(&self) -> f64 {
        let largest = self.amplitudes.iter().map(|own| own.1).fold(0.0, f64::max);
        self.amplitudes.last().map_or(f64::NAN, |last| last.1 / largest)
    }

    /// Measured and promised amplitude over the position.
    pub(super) fn panel(&self, quantity: &str) -> Panel {
        let lines = |points: &[(f64, f64)]| points.iter().map(|(at, value)| (1e3 * at, *value)).unzip();
        let PassedZone { from, to, frequency, nepers, .. } = self.zone;
        let (x, y): (Vec<f64>, Vec<f64>) = lines(&self.amplitudes);
        let (promised_x, promised_y) = lines(&self.promised);
        let zone = ShadedRegion {
            label: "unstable zone".to_owned(),
            x: Some((1e3 * from, 1e3 * to)),
            y: None,
            role: Role::UnstableZone,
        };
        let layers = vec![
            Layer::Region(zone),
            Layer::line("EnSubs, in a band about the frequency", x, y, Role::Series(0).solid()),
            Layer::line("promised: ∫ σ dt of the locus", promised_x, promised_y, Role::Series(1).dashed()),
        ];
        let across = Axis::linear("Contact position $s$ (mm)");
        let title =
            format!("{:.2} kHz: e^{{{:.2}}}, promised e^{{{nepers:.2}}}", 1e-3 * frequency, self.measured);
        Panel::new(across, Axis::log(quantity), layers).with_title(title).with_legend(Legend::Below)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use judder_store::{Dataset, Variable};
    use std::f64::consts::TAU;

    /// A sine that grows in a zone by a known number of nepers has grown by that, under clicks ten times as high as itself.
    #[test]
    fn growth_is_measured_under_clicks() {
        let (interval, speed) = (5e-6, 0.03);
        let zone = PassedZone {
            from: 3.6e-3,
            to: 5.1e-3,
            peak: 4.35e-3,
            frequency: 3.5e3,
            growth: 141.0,
            nepers: 4.5,
        };
        let times: Vec<f64> = (0..50_000).map(|k| f64::from(k) * interval).collect();
        let position: Vec<f64> = times.iter().map(|t| speed * t).collect();
        let value = |(k, t): (usize, &f64)| {
            let share = ((speed * t - zone.from) / (zone.to - zone.from)).clamp(0.0, 1.0);
            // the growth rate is half a sine along the zone
            let nepers = 0.5 * zone.nepers * (1.0 - (0.5 * TAU * share).cos());
            let click = if k % 6667 == 0 { 0.01 } else { 0.0 };
            1e-3 * nepers.exp() * (TAU * zone.frequency * t).cos() + click
        };
        let values: Vec<f64> = times.iter().enumerate().map(value).collect();
        let along = |name: &str, values: Vec<f64>| Variable::new(name, &["time"], &[values.len()], values);
        let march = Dataset::new()
            .attribute("settled_s", 0.02)
            .and_then(|own| own.with(along("time", times)))
            .and_then(|own| own.with(along("position", position)))
            .and_then(|own| own.with(along("T.y", values)))
            .unwrap();
        let march = StoredArrays::of(&march);
        let found = passages(&march, "T.y", &[zone], None);
        assert_eq!(found.len(), 1);
        assert!((found[0].measured - 4.5).abs() < 0.1, "{}", found[0].measured);
        let weak = PassedZone { nepers: 0.5, ..zone };
        let too_early = PassedZone { from: 0.6e-3, ..zone };
        assert!(passages(&march, "T.y", &[weak, too_early], None).is_empty());
    }
}
