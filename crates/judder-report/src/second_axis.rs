//! A second scale along the upper side of a frame: its ticks, where they stand among the abscissae.

use crate::axis::Scale;
use crate::figure::SecondAxis;
use crate::scale::PlacedAxis;
use crate::ticks::{Tick, thin_labels, ticks};

/// A second scale with its ticks settled.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct DrawnSecond {
    /// Markup, with the power of ten that the tick labels leave out.
    pub(crate) label: String,
    /// Labels, and the abscissae above which they stand.
    pub(crate) major: Vec<Tick>,
    /// Abscissae of the short ticks.
    pub(crate) minor: Vec<f64>,
}

/// The ticks over the range of the axis below it, for so many labels that need this share of the width each.
pub(crate) fn drawn(second: &SecondAxis, below: &PlacedAxis, room: usize, share: f64) -> DrawnSecond {
    let [one, other] = [below.from, below.to].map(|x| interpolated(&second.x, &second.value, x));
    let (from, to) = (one.min(other), one.max(other));
    let none = DrawnSecond { label: second.label.clone(), major: Vec::new(), minor: Vec::new() };
    // what stands still has no scale
    if !from.is_finite() || to - from <= 1e-9 * from.abs().max(to.abs()) {
        return none;
    }
    let placed = PlacedAxis { scale: Scale::Linear, from, to };
    let mut marks = ticks(&placed, room);
    thin_labels(&placed, &mut marks, share);
    let abscissa = |value: f64| inverse(second, value).filter(|x| below.contains(*x));
    let tick = |tick: &Tick| Some(Tick { value: abscissa(tick.value)?, label: tick.label.clone() });
    let label = match marks.exponent {
        Some(power) => format!("{} (×10^{{{}}})", second.label, power.to_string().replace('-', "−")),
        None => second.label.clone(),
    };
    DrawnSecond {
        label,
        major: apart(marks.major.iter().filter_map(tick), below, share),
        minor: marks.minor.iter().filter_map(|value| abscissa(*value)).collect(),
    }
}

/// Takes the labels from ticks that stand too close, where the second scale runs slowly.
fn apart(ticks: impl Iterator<Item = Tick>, below: &PlacedAxis, share: f64) -> Vec<Tick> {
    let mut ticks: Vec<Tick> = ticks.collect();
    ticks.sort_by(|a, b| a.value.total_cmp(&b.value));
    let mut taken = f64::NEG_INFINITY;
    for tick in ticks.iter_mut().filter(|tick| !tick.label.is_empty()) {
        let place = below.fraction(tick.value).unwrap_or(f64::NEG_INFINITY);
        if place - taken < share { tick.label.clear() } else { taken = place }
    }
    ticks
}

/// The value at an abscissa, straight between points and held beyond them.
fn interpolated(x: &[f64], values: &[f64], at: f64) -> f64 {
    let after = x.partition_point(|x| *x <= at);
    let (Some(first), Some(last)) = (values.first(), values.last()) else { return f64::NAN };
    let before = after.checked_sub(1);
    match before.and_then(|k| x.get(k..)).zip(before.and_then(|k| values.get(k..))) {
        None => *first,
        Some(([x0, x1, ..], [v0, v1, ..])) => v0 + (v1 - v0) * (at - x0) / (x1 - x0),
        Some(_) => *last,
    }
}

/// The first abscissa with this value.
fn inverse(second: &SecondAxis, value: f64) -> Option<f64> {
    let SecondAxis { x, value: values, .. } = second;
    let mut steps = x.windows(2).zip(values.windows(2));
    steps.find_map(|step| match step {
        ([x0, x1], [v0, v1]) if (v0 - value) * (v1 - value) <= 0.0 && v0 != v1 => {
            Some(x0 + (x1 - x0) * (value - v0) / (v1 - v0))
        }
        _ => None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn second(x: Vec<f64>, value: Vec<f64>) -> SecondAxis {
        SecondAxis { label: "Position $s$ (mm)".to_owned(), x, value }
    }

    const BELOW: PlacedAxis = PlacedAxis { scale: Scale::Linear, from: 0.0, to: 2.0 };

    #[test]
    fn ticks_stand_where_the_values_are() {
        let axis = drawn(&second(vec![0.0, 1.0, 2.0], vec![10.0, 10.0, 40.0]), &BELOW, 5, 0.05);
        for tick in &axis.major {
            let value: f64 = tick.label.parse().unwrap();
            assert!((1.0 + (value - 10.0) / 30.0 - tick.value).abs() < 1e-12, "{tick:?}");
        }
        assert!(axis.major.len() >= 3, "{axis:?}");
    }

    #[test]
    fn a_scale_may_run_backwards_or_stand_still() {
        let axis = drawn(&second(vec![0.0, 2.0], vec![40.0, 10.0]), &BELOW, 5, 0.05);
        assert!(axis.major.len() >= 3 && axis.major.is_sorted_by(|a, b| a.value < b.value), "{axis:?}");
        assert!(drawn(&second(vec![0.0, 2.0], vec![5.0; 2]), &BELOW, 5, 0.05).major.is_empty());
        assert!(drawn(&second(Vec::new(), Vec::new()), &BELOW, 5, 0.05).major.is_empty());
    }
}
