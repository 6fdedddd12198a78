//! Ticks: where an axis is marked, and what stands at the marks.

use crate::axis::Scale;
use crate::scale::{PlacedAxis, stretch};

/// A long tick.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Tick {
    pub(crate) value: f64,
    /// Markup; empty for a decade that is marked but, for want of room, not labelled.
    pub(crate) label: String,
}

/// The marks of one axis, ascending and within its range.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Ticks {
    pub(crate) major: Vec<Tick>,
    pub(crate) minor: Vec<f64>,
    /// Power of ten that the labels leave out and the axis label has to name.
    pub(crate) exponent: Option<i32>,
}

/// The ticks of an axis with names: one each.
pub(crate) fn named(axis: &PlacedAxis, names: &[(f64, String)]) -> Ticks {
    let named = names.iter().map(|(value, label)| Tick { value: *value, label: label.clone() });
    let major = named.filter(|tick| axis.contains(tick.value)).collect();
    Ticks { major, minor: Vec::new(), exponent: None }
}

/// Ticks of an axis that has room for about `room` labels (at least 2).
pub(crate) fn ticks(axis: &PlacedAxis, room: usize) -> Ticks {
    let room = room.max(2);
    let shown = |mut ticks: Ticks| {
        ticks.major.retain(|tick| axis.contains(tick.value));
        ticks.minor.retain(|value| axis.contains(*value));
        ticks
    };
    let own = shown(match axis.scale {
        Scale::Linear => linear(axis.from, axis.to, room),
        Scale::Log => log(axis.from, axis.to, room),
        Scale::SymmetricLog { linear: part } => symmetric_log(axis.from, axis.to, part, room),
    });
    // between two decades there may be none
    let labels = own.major.iter().filter(|tick| !tick.label.is_empty()).count();
    if labels < 2 { shown(linear(axis.from, axis.to, room)) } else { own }
}

/// Multiples of 1, 2 or 5 times a power of ten, with fifths or quarters between them.
fn linear(from: f64, to: f64, room: usize) -> Ticks {
    // a single label does not tell the scale, so a step that allows no second one is refined
    let mut steps = (room..room + 4).map(|room| nice_step((to - from) / room as f64));
    let marks_two =
        |(leading, power): &(f64, i32)| multiples(from, to, leading * 10_f64.powi(*power)).count() > 1;
    let (leading, power) = steps.find(marks_two).unwrap_or_else(|| nice_step((to - from) / room as f64));
    let step = leading * 10_f64.powi(power);
    let parts = if leading == 2.0 { 4.0 } else { 5.0 };
    let largest = libm::log10(from.abs().max(to.abs())).floor() as i32;
    let exponent = (!(-2..=4).contains(&largest)).then_some(largest);
    let decimals = (exponent.unwrap_or(0) - power).max(0) as usize;
    let label = |value: f64| number(value / 10_f64.powi(exponent.unwrap_or(0)), decimals);
    let major = multiples(from, to, step).map(|value| Tick { value, label: label(value) }).collect();
    let minor = multiples(from, to, step / parts).collect();
    Ticks { major, minor, exponent }
}

/// The smallest of 1, 2, 5 times a power of ten that is not below `least`, as factor and power.
fn nice_step(least: f64) -> (f64, i32) {
    let power = libm::log10(least).floor() as i32;
    let mantissa = least / 10_f64.powi(power);
    match mantissa {
        _ if mantissa <= 1.0 => (1.0, power),
        _ if mantissa <= 2.0 => (2.0, power),
        _ if mantissa <= 5.0 => (5.0, power),
        _ => (1.0, power + 1),
    }
}

/// The multiples of `step` from `from` to `to`; none where the step drowns in rounding.
fn multiples(from: f64, to: f64, step: f64) -> impl Iterator<Item = f64> {
    let (first, last) = ((from / step - 1e-9).ceil(), (to / step + 1e-9).floor());
    let count = if (0.0..1000.0).contains(&(last - first)) { (last - first) as usize + 1 } else { 0 };
    (0..count).map(move |index| (first + index as f64) * step)
}

/// Decades, thinned to the room, with 2..9 between them; within one decade its own multiples.
fn log(from: f64, to: f64, room: usize) -> Ticks {
    let (first, last) = decades(from, to);
    if last - first < 1 {
        return within_a_decade(from, to, room);
    }
    let count = (last - first + 1) as usize;
    let stride = stride(count, room);
    let major = (first..=last).map(|power| decade(power, 1.0, stride)).collect();
    let minor =
        if count <= 3 * room { (first - 1..=last).flat_map(between_decades).collect() } else { Vec::new() };
    Ticks { major, minor, exponent: None }
}

/// First and last power of ten in a range (the last may be below the first).
fn decades(from: f64, to: f64) -> (i32, i32) {
    ((libm::log10(from) - 1e-9).ceil() as i32, (libm::log10(to) + 1e-9).floor() as i32)
}

/// Every how many decades there is room for a label: 1, 2, 3, 5, 10, 20, …
fn stride(count: usize, room: usize) -> i32 {
    let least = count.saturating_sub(1).div_ceil(room).max(1);
    [1, 2, 3, 5, 10, 20, 50, 100].into_iter().find(|stride| *stride >= least).unwrap_or(200) as i32
}

fn decade(power: i32, sign: f64, stride: i32) -> Tick {
    let label = match power.rem_euclid(stride) {
        0 => format!("{}10^{{{}}}", if sign < 0.0 { "−" } else { "" }, number(f64::from(power), 0)),
        _ => String::new(),
    };
    Tick { value: sign * 10_f64.powi(power), label }
}

fn between_decades(power: i32) -> impl Iterator<Item = f64> {
    (2..=9).map(move |factor| f64::from(factor) * 10_f64.powi(power))
}

/// A log range with fewer than two decades: the multiples of its powers of ten, or linear ticks where it is short.
fn within_a_decade(from: f64, to: f64, room: usize) -> Ticks {
    let power = libm::log10(from).floor() as i32;
    let all: Vec<(i32, f64)> = (power..=power + 2)
        .flat_map(|power| (1..=9).map(move |factor| (factor, f64::from(factor) * 10_f64.powi(power))))
        .filter(|(_, value)| (from..=to).contains(value))
        .collect();
    let labelled = |factor: i32| all.len() <= room || matches!(factor, 1 | 2 | 5);
    if all.iter().filter(|(factor, _)| labelled(*factor)).count() < 2 {
        return linear(from, to, room);
    }
    let major = all
        .iter()
        .filter(|(factor, _)| labelled(*factor))
        .map(|(_, value)| Tick { value: *value, label: scientific(*value) })
        .collect();
    Ticks { major, minor: all.iter().map(|(_, value)| *value).collect(), exponent: None }
}

/// Zero and the decades of both signs outside the linear part.
fn symmetric_log(from: f64, to: f64, part: f64, room: usize) -> Ticks {
    let lowest = (libm::log10(part) - 1e-9).ceil() as i32;
    let side = |end: f64| if end > 0.0 { decades(part, end).1 } else { lowest - 1 };
    let (up, down) = (side(to), side(-from));
    let count = (up - lowest + 1).max(0) as usize + (down - lowest + 1).max(0) as usize;
    if count == 0 {
        return linear(from, to, room);
    }
    let stride = stride(count + 1, room);
    let negative = (lowest..=down).rev().map(|power| decade(power, -1.0, stride));
    let positive = (lowest..=up).map(|power| decade(power, 1.0, stride));
    let zero = Tick { value: 0.0, label: "0".to_owned() };
    let minor = |powers: std::ops::RangeInclusive<i32>, sign: f64| {
        powers.flat_map(between_decades).filter(|value| *value > part).map(move |value| sign * value)
    };
    let mut minors: Vec<f64> = minor(lowest - 1..=down, -1.0).chain(minor(lowest - 1..=up, 1.0)).collect();
    minors.sort_by(f64::total_cmp);
    if count > 3 * room {
        minors.clear();
    }
    Ticks { major: negative.chain([zero]).chain(positive).collect(), minor: minors, exponent: None }
}

/// A number with a true minus sign; zero has none.
fn number(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    if text.trim_start_matches('-').chars().all(|c| matches!(c, '0' | '.')) {
        return text.trim_start_matches('-').to_owned();
    }
    text.replace('-', "−")
}

/// A value on its own: plain where it is short, otherwise with a power of ten.
fn scientific(value: f64) -> String {
    let power = libm::log10(value.abs()).floor() as i32;
    if (-3..=4).contains(&power) {
        return number(value, (-power).max(0) as usize);
    }
    format!("{}×10^{{{}}}", number(value / 10_f64.powi(power), 0), number(f64::from(power), 0))
}

/// Labels of neighbouring ticks need this share of the axis between them, or the later one goes.
pub(crate) fn thin_labels(axis: &PlacedAxis, ticks: &mut Ticks, share: f64) {
    let at = |value: f64| {
        let (first, last) = (stretch(axis.scale, axis.from), stretch(axis.scale, axis.to));
        (stretch(axis.scale, value) - first) / (last - first)
    };
    let zero = ticks.major.iter().find(|tick| tick.value == 0.0).map(|tick| at(tick.value));
    let mut taken = f64::NEG_INFINITY;
    for tick in ticks.major.iter_mut().filter(|tick| !tick.label.is_empty()) {
        let place = at(tick.value);
        let crowds_zero = tick.value != 0.0 && zero.is_some_and(|zero| (place - zero).abs() < share);
        if crowds_zero || place - taken < share {
            tick.label.clear();
        } else {
            taken = place;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::axis::Axis;
    use proptest::prelude::*;

    fn labels(axis: Axis, from: f64, to: f64, room: usize) -> Vec<String> {
        let placed = PlacedAxis::new(&axis.with_range(from, to), std::iter::empty(), 0.0);
        ticks(&placed, room).major.into_iter().map(|tick| tick.label).collect()
    }

    #[test]
    fn linear_ticks_are_round_and_have_true_minus_signs() {
        assert_eq!(labels(Axis::linear(""), -1.0, 1.0, 5), ["−1.0", "−0.5", "0.0", "0.5", "1.0"]);
        assert_eq!(labels(Axis::linear(""), 0.0, 400.0, 6), ["0", "100", "200", "300", "400"]);
        assert_eq!(labels(Axis::linear(""), 0.0, 3e-6, 4), ["0", "1", "2", "3"]);
    }

    #[test]
    fn decades_are_thinned_to_the_room() {
        assert_eq!(labels(Axis::log(""), 1e-2, 1e1, 6), ["10^{−2}", "10^{−1}", "10^{0}", "10^{1}"]);
        let thinned = labels(Axis::log(""), 1e-8, 1e2, 6);
        assert_eq!(thinned.iter().filter(|label| !label.is_empty()).count(), 6);
        assert_eq!(labels(Axis::log(""), 2.0, 6.0, 4), ["2", "5"]);
    }

    #[test]
    fn symmetric_log_ticks_have_both_signs_and_zero() {
        assert_eq!(
            labels(Axis::symmetric_log("", 1e-2), -0.1, 1.0, 9),
            ["−10^{−1}", "−10^{−2}", "0", "10^{−2}", "10^{−1}", "10^{0}"]
        );
    }

    #[test]
    fn names_stand_in_place_of_numbers() {
        let axis = Axis::named("key", ["velocity".to_owned(), "load".to_owned()]);
        let placed = PlacedAxis::new(&axis, std::iter::empty(), 0.0);
        assert_eq!((placed.from, placed.to), (-0.5, 1.5));
        let ticks = named(&placed, &axis.names);
        let shown: Vec<(f64, &str)> =
            ticks.major.iter().map(|tick| (tick.value, tick.label.as_str())).collect();
        assert_eq!(shown, [(0.0, "velocity"), (1.0, "load")]);
        assert!(
            Axis::named("", []).range.is_some_and(|(from, to)| from < to),
            "an axis of nothing can be drawn"
        );
    }

    proptest! {
        /// Whatever the range: ascending, inside, few, and never only one label on a linear axis.
        #[test]
        fn ticks_are_sorted_inside_and_few(
            from in -1e12..1e12_f64,
            exponent in -8.0..14.0_f64,
            part in -6..3_i32,
            kind in 0..3,
            room in 2..12_usize,
        ) {
            let axis = [Axis::linear(""), Axis::log(""), Axis::symmetric_log("", 10_f64.powi(part))][kind as usize].clone();
            let from = if kind == 1 { from.abs().max(1e-12) } else { from };
            let to = from + 10_f64.powf(exponent).max(1e-9 * from.abs());
            let placed = PlacedAxis::new(&axis.with_range(from, to), std::iter::empty(), 0.0);
            let ticks = ticks(&placed, room);
            let values: Vec<f64> = ticks.major.iter().map(|tick| tick.value).collect();
            prop_assert!(values.windows(2).all(|pair| pair[0] < pair[1]), "{:?}", values);
            prop_assert!(ticks.minor.windows(2).all(|pair| pair[0] < pair[1]), "{:?}", ticks.minor);
            prop_assert!(values.iter().chain(&ticks.minor).all(|value| placed.contains(*value)));
            let labels = ticks.major.iter().filter(|tick| !tick.label.is_empty()).count();
            prop_assert!(labels <= room + 4, "{} labels for {}", labels, room);
            prop_assert!(kind != 0 || labels >= 2);
        }
    }
}
