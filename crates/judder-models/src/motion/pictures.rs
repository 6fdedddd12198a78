//! Motions: histories, phase portraits, spectra, sections.
//!
//! - `diagrams`: what motions become, along a key and over their starts.

#![deny(clippy::indexing_slicing, reason = "stored arrays may be of any length")]

mod diagrams;

pub(crate) use diagrams::{basin, bifurcation};

use super::si;
use judder_numerics::complex::ElementaryComplex;
use judder_oscillator::motion::ContactState;
use judder_report::figure::ShadedRegion;
use judder_report::palette::Style;
use judder_report::{Axis, Layer, Legend, Panel, Role, Scale};
use judder_study::pictures::{FRAME, StoredArrays, at, axis, codes, complexes, picked, reals, text};
use std::f64::consts::TAU;

/// Oscillations that are shown at the end of a motion.
const SHOWN: f64 = 6.0;
/// Changes of the contact state that are shown at most.
const MOST_CHANGES: usize = 400;

/// The grounds of contact states; slip has none.
const GROUNDS: [(ContactState, Role); 3] = [
    (ContactState::Stick, Role::Stick),
    (ContactState::SlipAhead, Role::SlipAhead),
    (ContactState::LiftOff, Role::LiftOff),
];
const STICK: u8 = ContactState::Stick.number();
const LIFT_OFF: u8 = ContactState::LiftOff.number();

/// Whole motion, its end, phase portrait, spectrum, section; `frequency` stands at the axis of the spectrum.
pub(crate) fn motion(dataset: &StoredArrays<'_>, frequency: &str) -> Option<Vec<Panel>> {
    let shown = si::shown(dataset.dataset());
    let dataset = &dataset.replaced(&shown);
    let time = reals(dataset, "time")?;
    let shown = ShownHistory::end_of(dataset, SHOWN)?;
    let whole = vec![Layer::line("", time.to_vec(), reals(dataset, "x")?.to_vec(), Role::Series(0).solid())];
    let mut panels = vec![Panel::new(along_time(dataset)?, axis(dataset.variable("x")?), whole)];
    for name in ["x", "relative_velocity", "contact_area"] {
        panels.extend(shown.history(name));
    }
    panels.push(shown.portrait()?);
    panels.extend(spectrum(dataset, frequency));
    panels.extend(section(dataset));
    Some(panels)
}

/// The last oscillations of a motion: displacement, relative velocity and contact area over time, then the phase portrait.
pub fn ending(dataset: &StoredArrays<'_>, oscillations: f64) -> Option<Vec<Panel>> {
    let shown = si::shown(dataset.dataset());
    let dataset = &dataset.replaced(&shown);
    let shown = ShownHistory::end_of(dataset, oscillations)?;
    let histories = ["x", "relative_velocity", "contact_area"].into_iter().map(|name| shown.history(name));
    histories.chain([shown.portrait()]).collect()
}

/// One period, phase portrait, Floquet multipliers.
pub(crate) fn limit_cycle(dataset: &StoredArrays<'_>) -> Option<Vec<Panel>> {
    let shown = si::shown(dataset.dataset());
    let dataset = &dataset.replaced(&shown);
    let shown = ShownHistory::all_of(dataset)?;
    let mut panels = Vec::new();
    for name in ["x", "relative_velocity", "contact_area"] {
        panels.extend(shown.history(name));
    }
    panels.push(shown.portrait()?);
    panels.push(multipliers(dataset)?);
    Some(panels)
}

/// The Floquet multipliers of a cycle, beside the unit circle.
pub(crate) fn multipliers(dataset: &StoredArrays<'_>) -> Option<Panel> {
    dataset.over("floquet_multipliers", &["multiplier"])?;
    let multipliers = complexes(dataset, "floquet_multipliers")?;
    let circle: Vec<f64> = (0..=180).map(|k| TAU * f64::from(k) / 180.0).collect();
    let layers = vec![
        Layer::line(
            "unit circle",
            circle.iter().map(|a| libm::cos(*a)).collect(),
            circle.iter().map(|a| libm::sin(*a)).collect(),
            Role::Reference.solid(),
        ),
        Layer::points(
            "multipliers",
            multipliers.iter().map(|m| m.re).collect(),
            multipliers.iter().map(|m| m.im).collect(),
            Role::Series(1),
        ),
    ];
    let half = multipliers.iter().fold(1.1, |half: f64, m| half.max(1.1 * m.modulus()));
    Some(Panel::new(
        Axis::linear("Real part (−)").over(-half * FRAME, half * FRAME),
        Axis::linear("Imaginary part (−)").over(-half, half),
        layers,
    ))
}

/// The axis over values that have markers at both ends.
fn with_room(axis: Axis, from: f64, to: f64) -> Axis {
    const ROOM: f64 = 0.02;
    match axis.scale {
        Scale::Log => {
            let room = libm::pow(to / from, ROOM);
            axis.over(from / room, to * room)
        }
        _ => axis.over(from - ROOM * (to - from), to + ROOM * (to - from)),
    }
}

fn along_time(dataset: &StoredArrays<'_>) -> Option<Axis> {
    dataset.variable("time").map(axis)
}

/// Changes of the contact state of one kind: their name, whether one from a state to another is among them, their colour.
type EventKind = (&'static str, fn(u8, u8) -> bool, usize);

/// What motions have of every time of their grid, of every change of the contact state, of every point of their path, of every oscillation.
const OVER_TIME: [&str; 5] = ["x", "y", "velocity_x", "relative_velocity", "contact_area"];
const OVER_EVENTS: [&str; 5] = ["event_time", "event_from", "event_to", "event_x", "event_velocity_x"];
const OVER_PATH: [&str; 3] = ["path_time", "path_x", "path_velocity_x"];
const OVER_OSCILLATIONS: [&str; 5] =
    ["oscillation_time", "oscillation_period", "oscillation_amplitude", "section_x", "section_y"];

/// A part of a history.
struct ShownHistory<'a> {
    dataset: StoredArrays<'a>,
    /// The points of the grid that are shown.
    points: std::ops::Range<usize>,
    /// The changes of the contact state that are shown.
    events: std::ops::Range<usize>,
    /// From when to when.
    span: (f64, f64),
}

impl<'a> ShownHistory<'a> {
    fn all_of(dataset: &StoredArrays<'a>) -> Option<Self> {
        Self::since(dataset, *reals(dataset, "time")?.first()?)
    }

    /// A few oscillations at the end of a motion, fewer where they change too often to be told apart.
    fn end_of(dataset: &StoredArrays<'a>, oscillations: f64) -> Option<Self> {
        let (time, events) = (reals(dataset, "time")?, reals(dataset, "event_time")?);
        let end = *time.last()?;
        let usual = match reals(dataset, "oscillation_period")? {
            [] => 0.1 * end,
            periods => oscillations * periods.iter().sum::<f64>() / periods.len() as f64,
        };
        let crowded = events.len().checked_sub(MOST_CHANGES).map_or(0.0, |first| at(events, first));
        Self::since(dataset, (end - usual).max(crowded).max(0.0))
    }

    fn since(dataset: &StoredArrays<'a>, start: f64) -> Option<Self> {
        dataset.over("contact_state", &["time"])?;
        for name in OVER_TIME.into_iter().filter(|name| dataset.variable(name).is_some()) {
            dataset.over(name, &["time"])?;
            // an array that holds no numbers would keep the label of its group beside others in SI
            reals(dataset, name)?;
        }
        for own in [&OVER_EVENTS[..], &OVER_PATH, &OVER_OSCILLATIONS] {
            dataset.alike(own)?;
        }
        let (time, events) = (reals(dataset, "time")?, reals(dataset, "event_time")?);
        let from = |values: &[f64]| values.partition_point(|value| *value < start)..values.len();
        Some(Self {
            dataset: dataset.clone(),
            points: from(time),
            events: from(events),
            span: (start, *time.last()?),
        })
    }

    fn values(&self, name: &str) -> Option<Vec<f64>> {
        Some(reals(&self.dataset, name)?.get(self.points.clone())?.to_vec())
    }

    /// A quantity over time on the ground of the contact state.
    fn history(&self, name: &str) -> Option<Panel> {
        let line = Layer::line("", self.values("time")?, self.values(name)?, Role::FullBoundary.solid());
        let mut layers = self.grounds()?;
        layers.push(line);
        let across = along_time(&self.dataset)?.over(self.span.0, self.span.1);
        let up = axis(self.dataset.variable(name)?);
        Some(Panel::new(across, up, layers).with_legend(Legend::Below))
    }

    fn grounds(&self) -> Option<Vec<Layer>> {
        let times = reals(&self.dataset, "event_time")?.get(self.events.clone())?;
        let begins = codes(&self.dataset, "event_to")?.get(self.events.clone())?;
        let before = match codes(&self.dataset, "event_from")?.get(self.events.start) {
            Some(state) => *state,
            None => *codes(&self.dataset, "contact_state")?.last()?,
        };
        let starts = [self.span.0].into_iter().chain(times.iter().copied());
        let ends = times.iter().copied().chain([self.span.1]);
        let states = [before].into_iter().chain(begins.iter().copied());
        let region = |((from, to), state): ((f64, f64), u8)| {
            let (ground, role) = GROUNDS.into_iter().find(|(own, _)| own.number() == state)?;
            Some(Layer::Region(ShadedRegion {
                label: ground.name().to_owned(),
                x: Some((from, to)),
                y: None,
                role,
            }))
        };
        Some(starts.zip(ends).zip(states).filter_map(region).collect())
    }

    /// Velocity over displacement, with the changes of the contact state. The path knows the shape of a slip between two points
    /// of the grid.
    fn portrait(&self) -> Option<Panel> {
        let first = reals(&self.dataset, "path_time")?.partition_point(|time| *time < self.span.0);
        let path = |name: &str| Some(reals(&self.dataset, name)?.get(first..)?.to_vec());
        let style = Role::Series(0).solid();
        let mut layers = vec![Layer::line("", path("path_x")?, path("path_velocity_x")?, style)];
        let (from, to) = (codes(&self.dataset, "event_from")?, codes(&self.dataset, "event_to")?);
        let kinds: [EventKind; 4] = [
            ("stick begins", |_, to| to == STICK, 2),
            ("slip begins", |from, to| from == STICK && to != LIFT_OFF, 1),
            ("lift-off begins", |_, to| to == LIFT_OFF, 4),
            ("touch-down", |from, to| from == LIFT_OFF && to != STICK, 3),
        ];
        for (label, is_of_kind, series) in kinds {
            let is_of_it =
                |k: &usize| from.get(*k).zip(to.get(*k)).is_some_and(|(from, to)| is_of_kind(*from, *to));
            let events: Vec<usize> = self.events.clone().filter(is_of_it).collect();
            if events.is_empty() {
                continue;
            }
            let of = |name: &str| Some(picked(reals(&self.dataset, name)?, &events));
            layers.push(Layer::points(label, of("event_x")?, of("event_velocity_x")?, Role::Series(series)));
        }
        let along = |name: &str| self.dataset.variable(name).map(axis);
        Some(Panel::new(along("x")?, along("velocity_x")?, layers))
    }
}

/// The amplitude of every frequency, over as many decades as mean something.
fn spectrum(dataset: &StoredArrays<'_>, along: &str) -> Option<Panel> {
    const DECADES: f64 = 1e-6;
    dataset.over("amplitude", &["frequency"])?;
    let (frequency, amplitude) = (reals(dataset, "frequency")?, reals(dataset, "amplitude")?);
    let largest = amplitude.iter().copied().fold(0.0, f64::max);
    if largest <= 0.0 {
        return None;
    }
    let shown =
        amplitude.iter().map(|a| if *a < DECADES * largest { DECADES * largest } else { *a }).collect();
    let layer = Layer::line("", frequency.to_vec(), shown, Role::Series(0).solid());
    let label = |name: &str| text(dataset.variable(name)?, "label");
    let up = Axis::log(label("amplitude").unwrap_or("Amplitude of $x$ (−)"));
    Some(Panel::new(Axis::linear(label("frequency").unwrap_or(along)), up, vec![layer]))
}

/// Markers for so many points, small where they would hide each other.
fn markers(role: Role, points: usize) -> Style {
    const CROWD: usize = 60;
    if points > CROWD { role.crowded() } else { role.into() }
}

/// Markers of a direction: small ones on the way up, which the way down would hide.
fn of_direction(role: Role, direction: usize) -> Style {
    if direction == 0 { role.crowded() } else { role.into() }
}

/// The states where x is largest: y over x, or for a model without y the next x over x.
fn section(dataset: &StoredArrays<'_>) -> Option<Panel> {
    let x = reals(dataset, "section_x")?;
    let (along, in_x) = (axis(dataset.variable("section_x")?), swing(dataset, "x")?);
    let (points, up, upwards) = match dataset.variable("section_y") {
        Some(variable) => {
            let points = (x.to_vec(), reals(dataset, "section_y")?.to_vec());
            (points, axis(variable), swing(dataset, "y")?)
        }
        None => {
            let points =
                (x.iter().skip(1).zip(x).map(|(_, x)| *x).collect(), x.iter().skip(1).copied().collect());
            let next = along.label.replace("Displacement", "The next largest");
            (points, Axis::linear(next), in_x)
        }
    };
    if points.0.is_empty() {
        return None;
    }
    let (along, up) = (above_rounding(along, &points.0, in_x), above_rounding(up, &points.1, upwards));
    let style = markers(Role::Series(1), points.0.len());
    let layer = Layer::points("", points.0, points.1, style);
    Some(Panel::new(along, up, vec![layer]).with_title("Poincaré section"))
}

/// How far a coordinate goes in the second half of a motion.
fn swing(dataset: &StoredArrays<'_>, name: &str) -> Option<f64> {
    let values = reals(dataset, name)?;
    let (low, high) = ends(values.get(values.len() / 2..)?);
    Some(high - low)
}

/// The least and the largest of values.
fn ends(values: &[f64]) -> (f64, f64) {
    values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(*v), high.max(*v)))
}

/// An axis over values that spans no less than a hundredth of what they are a part of: the returns of a periodic motion differ by rounding alone.
fn above_rounding(axis: Axis, values: &[f64], whole: f64) -> Axis {
    const LEAST: f64 = 0.01;
    const ROOM: f64 = 1.1;
    let (low, high) = ends(values);
    let (middle, half) = (0.5 * (low + high), 0.5 * ROOM * (high - low).max(LEAST * whole));
    if half > 0.0 && half.is_finite() && middle.is_finite() {
        axis.over(middle - half, middle + half)
    } else {
        axis
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_is_not_drawn_as_a_shape() {
        let range = |values: &[f64]| above_rounding(Axis::linear(""), values, 2.0).range.unwrap();
        let (low, high) = range(&[1.0, 1.0 + 1e-12]);
        assert!((high - low - 0.022).abs() < 1e-9 && low < 1.0 && high > 1.0, "{low} {high}");
        let (low, high) = range(&[0.0, 1.0]);
        assert!((high - low - 1.1).abs() < 1e-12);
        assert!(above_rounding(Axis::linear(""), &[0.0], 0.0).range.is_none());
    }
}
