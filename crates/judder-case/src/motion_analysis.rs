//! The analyses of motion, which the oscillator and the mass on a belt share.

use crate::analysis::Kind;
use crate::cause::Cause;
use crate::dimension::Dimension;
use crate::document::Node;
use crate::error::Fault;
use crate::keys::{Key, Range, Value, number};
use crate::read_sweep::{read_checked_sweep, same_form};
use crate::section::{Section, finite_number, list, wrong_type};
use crate::sweep::Sweep;
use crate::swept_keys::{SweptKeys, read_value};

/// What an analysis of motion computes.
#[derive(Debug, Clone, PartialEq)]
pub enum MotionAnalysis<K> {
    /// `motion`: the history of one motion.
    History {
        /// Where it starts.
        start: MotionStart,
        /// How it is followed: for its whole duration.
        following: Following,
        /// The first part of the time, which averages leave out; of the form of the duration.
        transient: Value,
        /// Points of the uniform grid of time that is kept.
        points: usize,
    },
    /// `limit-cycle`: the cycle that a motion settles to, made exact.
    LimitCycle {
        /// Where the motion starts.
        start: MotionStart,
        /// How it is followed: at most for its duration.
        following: Following,
    },
    /// `bifurcation`: what the motion settles to along one key, up and down.
    Bifurcation {
        /// The swept key.
        sweep: Sweep<K>,
        /// Which way the key goes.
        direction: SweepDirection,
        /// Where the motion at the first value starts.
        start: MotionStart,
        /// How each motion is followed: at most for its duration.
        following: Following,
        /// The first part of the time, which the averages of an irregular motion leave out; of the form of the duration.
        transient: Value,
        /// Whether the branches of cycles, stable and unstable, are followed through the diagram as well.
        branches: bool,
    },
    /// `basin`: the share of starts from which steady sliding is reached.
    Basin {
        /// The range of each coordinate from which starts are drawn, evenly; `None` leaves it at steady sliding.
        within: Vec<Option<(f64, f64)>>,
        /// How many starts.
        samples: usize,
        /// Which starts.
        seed: u64,
        /// How each motion is followed: at most for its duration.
        following: Following,
    },
}

/// How a motion is followed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Following {
    /// How long, as ω_nx t or in s.
    pub duration: Value,
    /// Local error of a step, relative to the magnitudes of steady sliding.
    pub tolerance: f64,
    /// The most steps of one motion.
    pub steps: usize,
}

/// Where a motion starts.
#[derive(Debug, Clone, PartialEq)]
pub enum MotionStart {
    /// Steady sliding with x moved by this share of |x_e|.
    Disturbance(f64),
    /// These coordinates, in the model's own order and units; what is left out stands as in steady sliding.
    State(Vec<Option<f64>>),
}

/// Which way a bifurcation diagram is followed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum SweepDirection {
    /// Both ways.
    Both,
    /// From the first value to the last.
    Forward,
    /// From the last value to the first.
    Backward,
}

impl SweepDirection {
    /// The directions with their names in a case file.
    pub const ALL: [(&'static str, Self); 3] =
        [("both", Self::Both), ("forward", Self::Forward), ("backward", Self::Backward)];

    /// The name in a case file.
    pub fn name(self) -> &'static str {
        Self::ALL[self as usize].0
    }

    /// The single sweeps that it takes.
    pub fn sweeps(self) -> &'static [Self] {
        match self {
            Self::Both => &[Self::Forward, Self::Backward],
            Self::Forward => &[Self::Forward],
            Self::Backward => &[Self::Backward],
        }
    }
}

/// x over |x_e| − 1 from which a motion starts where the case says nothing else.
pub const DISTURBANCE: f64 = 0.2;
/// The default duration of a history.
pub const HISTORY_DURATION: f64 = 2000.0;
/// The default time within which a motion settles.
pub const SETTLING_DURATION: f64 = 2e4;
/// The same along a diagram, where each motion starts near to where it ends.
pub const DIAGRAM_DURATION: f64 = 5000.0;
/// The share of the duration that averages leave out by default.
pub const TRANSIENT_SHARE: f64 = 0.5;
/// Whether a diagram has its branches where the case says nothing: a cascade of cycles with sticks and lift-offs takes minutes.
pub const BRANCHES: bool = false;
/// The default points of a history, and their limits.
pub const HISTORY_POINTS: usize = 4096;
pub(crate) const HISTORY_POINTS_LIMITS: [usize; 2] = [16, 1 << 22];
/// The default samples of a basin, and their limits.
pub const BASIN_SAMPLES: usize = 1000;
pub(crate) const SAMPLES_LIMITS: [usize; 2] = [1, 10_000_000];
/// The default seed of a basin, and its limits: whole numbers that every reader of JSON keeps.
pub const BASIN_SEED: usize = 1;
pub(crate) const SEED_LIMITS: [usize; 2] = [0, (1 << 53) - 1];
/// The default budget of steps of a motion, and its limits.
pub const MOTION_STEPS: usize = 10_000_000;
pub(crate) const STEPS_LIMITS: [usize; 2] = [1, 1_000_000_000_000];
/// The tolerances that a motion may be given.
pub(crate) const TOLERANCE_RANGE: Range = Range::Interval { above: 1e-14, up_to: 1e-2 };

/// A time of an analysis of motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TimeKey;

/// The time of the oscillator.
pub(crate) static TIME_OF_OSCILLATOR: Key<TimeKey> = Key {
    dimension: Dimension::TIME,
    group: Some("ω_nx t"),
    default: None,
    ..number(TimeKey, "duration", "t", Range::Positive, ("", 0.0), "time that a motion is followed")
};

/// The time of the mass on a belt.
pub(crate) static TIME_OF_BELT: Key<TimeKey> = Key {
    default: None,
    ..number(TimeKey, "duration", "t", Range::Positive, ("", 0.0), "time that a motion is followed")
};

/// What the analyses of motion need to know of a model beside its swept keys.
pub(crate) trait MotionKeys: SweptKeys {
    /// The coordinates of a state, in order: displacements, then their velocities.
    const COORDINATES: &'static [&'static str];

    /// How a time is given.
    fn time() -> &'static Key<TimeKey>;
}

/// Name, keys and meaning of a kind, whichever model it belongs to.
pub(crate) struct MotionKind {
    pub(crate) name: &'static str,
    pub(crate) keys: &'static [&'static str],
    pub(crate) doc: &'static str,
    /// The default tolerance.
    pub(crate) tolerance: f64,
    /// The default duration.
    pub(crate) duration: f64,
}

impl MotionKind {
    /// The kind with its reader.
    pub(crate) const fn kind<S, T>(&self, read: fn(&S, &Section<'_>) -> Result<T, Fault>) -> Kind<S, T> {
        Kind { name: self.name, keys: self.keys, declared: None, doc: self.doc, read }
    }
}

pub(crate) const HISTORY: MotionKind = MotionKind {
    name: "motion",
    keys: &["start", "duration", "transient", "points", "tolerance", "steps"],
    doc: "the history of one motion: stick, slip, lift-off, its averages, its energy",
    tolerance: 1e-8,
    duration: HISTORY_DURATION,
};

pub(crate) const LIMIT_CYCLE: MotionKind = MotionKind {
    name: "limit-cycle",
    keys: &["start", "duration", "tolerance", "steps"],
    doc: "the cycle that a motion settles to, with its Floquet multipliers",
    tolerance: 1e-10,
    duration: SETTLING_DURATION,
};

pub(crate) const BIFURCATION: MotionKind = MotionKind {
    name: "bifurcation",
    keys: &["sweep", "direction", "start", "duration", "transient", "tolerance", "steps", "branches"],
    doc: "what the motion settles to along one key, each motion from the end of the one before",
    tolerance: 1e-6,
    duration: DIAGRAM_DURATION,
};

pub(crate) const BASIN: MotionKind = MotionKind {
    name: "basin",
    keys: &["within", "samples", "seed", "duration", "tolerance", "steps"],
    doc: "the share of starts, drawn evenly, from which steady sliding is reached",
    tolerance: 1e-6,
    duration: SETTLING_DURATION,
};

pub(crate) fn read_history<S: MotionKeys>(
    _: &S,
    section: &Section<'_>,
) -> Result<MotionAnalysis<S::Key>, Fault> {
    let following = read_following::<S>(section, &HISTORY)?;
    let [fewest, most] = HISTORY_POINTS_LIMITS;
    Ok(MotionAnalysis::History {
        start: read_start::<S>(section)?,
        following,
        transient: read_transient::<S>(section, following.duration)?,
        points: section.whole("points", fewest, most)?.unwrap_or(HISTORY_POINTS),
    })
}

pub(crate) fn read_limit_cycle<S: MotionKeys>(
    _: &S,
    section: &Section<'_>,
) -> Result<MotionAnalysis<S::Key>, Fault> {
    Ok(MotionAnalysis::LimitCycle {
        start: read_start::<S>(section)?,
        following: read_following::<S>(section, &LIMIT_CYCLE)?,
    })
}

pub(crate) fn read_bifurcation<S: MotionKeys>(
    keys: &S,
    section: &Section<'_>,
) -> Result<MotionAnalysis<S::Key>, Fault> {
    let following = read_following::<S>(section, &BIFURCATION)?;
    Ok(MotionAnalysis::Bifurcation {
        sweep: read_checked_sweep(keys, section)?,
        direction: section
            .choice("direction", "direction", &SweepDirection::ALL)?
            .unwrap_or(SweepDirection::Both),
        start: read_start::<S>(section)?,
        following,
        transient: read_transient::<S>(section, following.duration)?,
        branches: section.boolean("branches")?.unwrap_or(BRANCHES),
    })
}

pub(crate) fn read_basin<S: MotionKeys>(
    _: &S,
    section: &Section<'_>,
) -> Result<MotionAnalysis<S::Key>, Fault> {
    let [fewest, most] = SAMPLES_LIMITS;
    let [first, last] = SEED_LIMITS;
    Ok(MotionAnalysis::Basin {
        within: read_ranges::<S>(section)?,
        samples: section.whole("samples", fewest, most)?.unwrap_or(BASIN_SAMPLES),
        seed: section.whole("seed", first, last)?.unwrap_or(BASIN_SEED) as u64,
        following: read_following::<S>(section, &BASIN)?,
    })
}

pub(crate) fn read_following<S: MotionKeys>(
    section: &Section<'_>,
    kind: &MotionKind,
) -> Result<Following, Fault> {
    let duration = section.get("duration").map(|node| read_value(S::time(), "duration", node)).transpose()?;
    let [fewest, most] = STEPS_LIMITS;
    Ok(Following {
        duration: duration.unwrap_or(Value::group(kind.duration)),
        tolerance: read_tolerance(section)?.unwrap_or(kind.tolerance),
        steps: section.whole("steps", fewest, most)?.unwrap_or(MOTION_STEPS),
    })
}

fn read_tolerance(section: &Section<'_>) -> Result<Option<f64>, Fault> {
    let Some(node) = section.get("tolerance") else { return Ok(None) };
    let number = finite_number("tolerance", node)?;
    if TOLERANCE_RANGE.contains(number) {
        return Ok(Some(number));
    }
    Err(Cause::OutOfRange { key: "tolerance".to_owned(), number, range: TOLERANCE_RANGE }.at(node.place))
}

/// The time that averages leave out; half the duration where the case says nothing.
fn read_transient<S: MotionKeys>(section: &Section<'_>, duration: Value) -> Result<Value, Fault> {
    let Some(node) = section.get("transient") else {
        return Ok(Value { number: TRANSIENT_SHARE * duration.number, form: duration.form });
    };
    let entry = Key { range: Range::NonNegative, key: TimeKey, ..*S::time() };
    let transient = read_value(&entry, "transient", node)?;
    same_form("`duration` and `transient`".to_owned(), duration.form, transient.form, node.place)?;
    if transient.number >= duration.number {
        let (transient, duration) = (transient.number, duration.number);
        return Err(Cause::NothingMeasured { transient, duration }.at(node.place));
    }
    Ok(transient)
}

pub(crate) fn read_start<S: MotionKeys>(section: &Section<'_>) -> Result<MotionStart, Fault> {
    let Some(node) = section.get("start") else { return Ok(MotionStart::Disturbance(DISTURBANCE)) };
    let known: Vec<&str> = S::COORDINATES.iter().copied().chain(["disturbance"]).collect();
    let table = Section::open(node, "start", "`start`", &known)?;
    if let Some(disturbance) = table.get("disturbance") {
        if let Some(other) = S::COORDINATES.iter().find(|name| table.get(name).is_some()) {
            let (first, second) = ("start.disturbance".to_owned(), table.path(other));
            return Err(
                Cause::Conflict { first, second }.at(table.get(other).map_or(table.place, |n| n.place))
            );
        }
        return finite_number("start.disturbance", disturbance).map(MotionStart::Disturbance);
    }
    let coordinate =
        |name: &&str| table.get(name).map(|node| finite_number(&table.path(name), node)).transpose();
    let state: Vec<Option<f64>> = S::COORDINATES.iter().map(coordinate).collect::<Result<_, _>>()?;
    if state.iter().all(Option::is_none) {
        table.required("disturbance", "disturbance = 0.2, or x = …, the coordinates of the start")?;
    }
    Ok(MotionStart::State(state))
}

fn read_ranges<S: MotionKeys>(section: &Section<'_>) -> Result<Vec<Option<(f64, f64)>>, Fault> {
    let expected = "within = { x = [from, to], velocity_x = [from, to] }, the ranges of the starts";
    let node = section.required("within", expected)?;
    let table = Section::open(node, "within", "`within`", S::COORDINATES)?;
    let range = |name: &&str| table.get(name).map(|node| read_range(&table.path(name), node)).transpose();
    let ranges: Vec<_> = S::COORDINATES.iter().map(range).collect::<Result<_, _>>()?;
    if ranges.iter().all(Option::is_none) {
        table.required("x", "x = [from, to], the range of a coordinate")?;
    }
    Ok(ranges)
}

/// `[from, to]`, ascending.
fn read_range(key: &str, node: &Node) -> Result<(f64, f64), Fault> {
    let [from, to] = list(key, node)? else {
        return Err(wrong_type(key, "a list of two numbers, [from, to]", node));
    };
    let (from, to) = (finite_number(key, from)?, finite_number(key, to)?);
    if from < to {
        Ok((from, to))
    } else if from == to {
        Err(Cause::EmptyRange { from }.at(node.place))
    } else {
        Err(Cause::Backwards { from, to }.at(node.place))
    }
}
