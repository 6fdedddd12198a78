//! The analyses of motion, which the oscillator and the mass on a belt share.

use crate::read_sweep::{SWEEP, same_form};
use crate::sweep::Sweep;
use crate::swept_keys::SweptKeys;
use judder_keys::cause::Cause;
use judder_keys::declared::{Declaration, Number, Pair, Scaled, Settings, Whole, both};
use judder_keys::dimension::Dimension;
use judder_keys::error::Fault;
use judder_keys::numeric_key::{Range, Value};
use judder_keys::section::Section;
use judder_keys::{Choice, Settings};
use judder_study::case::analysis::Kind;
use judder_study::case::study_sweep::SEEDS;
use serde_json::{Map, Value as Json};

/// What an analysis of motion computes.
#[derive(Debug, Clone, PartialEq)]
pub enum MotionAnalysis<K> {
    /// `motion`: the history of one motion.
    History(History),
    /// `limit-cycle`: the cycle that a motion settles to, made exact.
    LimitCycle(LimitCycle),
    /// `bifurcation`: what the motion settles to along one key, up and down.
    Bifurcation(Bifurcation<K>),
    /// `basin`: the share of starts from which steady sliding is reached.
    Basin(Basin),
}

/// The history of one motion.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(check = History::complete)]
pub struct History {
    /// Where the motion starts.
    #[key(default = MotionStart::USUAL)]
    pub start: MotionStart,
    /// Time that the motion is followed.
    #[key(rule = DURATION, symbol = "t", default = Value::group(2000.0))]
    pub duration: Value,
    /// First part of the duration, which averages leave out; half of it by default.
    #[key(rule = TRANSIENT, symbol = "t", default = Value::group(1000.0))]
    pub transient: Value,
    /// Points of the uniform grid of time that is kept.
    #[key(rule = Whole { from: 16, to: 1 << 22 }, default = 4096)]
    pub points: usize,
    /// Local error of a step, relative to the magnitudes of steady sliding.
    #[key(rule = TOLERANCE, symbol = "ε", default = 1e-8)]
    pub tolerance: f64,
    /// The most steps of one motion.
    #[key(rule = STEPS, default = MOTION_STEPS)]
    pub steps: usize,
}

/// The cycle that a motion settles to.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct LimitCycle {
    /// Where the motion starts.
    #[key(default = MotionStart::USUAL)]
    pub start: MotionStart,
    /// Time within which the motion settles.
    #[key(rule = DURATION, symbol = "t", default = SETTLING_DURATION)]
    pub duration: Value,
    /// Local error of a step, relative to the magnitudes of steady sliding.
    #[key(rule = TOLERANCE, symbol = "ε", default = CYCLE_TOLERANCE)]
    pub tolerance: f64,
    /// The most steps of one motion.
    #[key(rule = STEPS, default = MOTION_STEPS)]
    pub steps: usize,
}

/// What the motion settles to along one key.
#[derive(Debug, Clone, PartialEq)]
pub struct Bifurcation<K> {
    /// The swept key.
    pub sweep: Sweep<K>,
    /// How it is followed.
    pub diagram: Diagram,
}

/// How a bifurcation diagram is followed: each motion starts where the one before has ended.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(check = Diagram::complete)]
pub struct Diagram {
    /// Which way the key is followed.
    #[key(default = SweepDirection::Both)]
    pub direction: SweepDirection,
    /// Where the motion at the first value starts.
    #[key(default = MotionStart::USUAL)]
    pub start: MotionStart,
    /// Time within which each motion settles.
    #[key(rule = DURATION, symbol = "t", default = Value::group(5000.0))]
    pub duration: Value,
    /// First part of the duration, which the averages of an irregular motion leave out; half of it by default.
    #[key(rule = TRANSIENT, symbol = "t", default = Value::group(2500.0))]
    pub transient: Value,
    /// Local error of a step, relative to the magnitudes of steady sliding.
    #[key(rule = TOLERANCE, symbol = "ε", default = 1e-6)]
    pub tolerance: f64,
    /// The most steps of one motion.
    #[key(rule = STEPS, default = MOTION_STEPS)]
    pub steps: usize,
    /// Follow the [branches of cycles](theory/motion.md#branches-through-a-diagram), stable and unstable, through the diagram: a cascade of cycles that stick and lift off takes minutes.
    #[key(default = false)]
    pub branches: bool,
}

/// The share of starts from which steady sliding is reached.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct Basin {
    /// The ranges from which starts are drawn, evenly and independently.
    #[key(example = "{ x = [from, to], velocity_x = [from, to] }, the ranges of the starts")]
    pub within: StartRanges,
    /// Number of starts.
    #[key(rule = Whole { from: 1, to: 10_000_000 }, default = 1000)]
    pub samples: usize,
    /// Which starts are drawn; the n-th depends on the seed and on n alone.
    #[key(rule = SEEDS, default = 1)]
    pub seed: usize,
    /// Time within which each motion settles.
    #[key(rule = DURATION, symbol = "t", default = SETTLING_DURATION)]
    pub duration: Value,
    /// Local error of a step, relative to the magnitudes of steady sliding.
    #[key(rule = TOLERANCE, symbol = "ε", default = 1e-6)]
    pub tolerance: f64,
    /// The most steps of one motion.
    #[key(rule = STEPS, default = MOTION_STEPS)]
    pub steps: usize,
}

/// Where a motion starts.
#[derive(Debug, Clone, Copy, PartialEq, Settings)]
pub enum MotionStart {
    /// Steady sliding with x moved by this share of its magnitude, or of the scale of a motion where steady sliding has no x.
    #[key(rule = ANY, example = "0.2, or x = …, the coordinates of the start")]
    Disturbance(f64),
    /// A state: what is left out stands as in steady sliding.
    State {
        /// Displacement, in units of x0 = F_n/k_x for the oscillator.
        #[key(rule = ANY, omitted)]
        x: Option<f64>,
        /// Normal displacement, in units of x0; in the air where it is not above zero.
        #[key(rule = ANY, omitted)]
        y: Option<f64>,
        /// Velocity along x, in these units and those of ω_nx.
        #[key(rule = ANY, omitted)]
        velocity_x: Option<f64>,
        /// Velocity along y.
        #[key(rule = ANY, omitted)]
        velocity_y: Option<f64>,
    },
}

/// The range of each coordinate of a start; what is left out stands as in steady sliding.
#[derive(Debug, Clone, Copy, PartialEq, Settings)]
#[settings(check = StartRanges::says_one)]
pub struct StartRanges {
    /// Of the displacement.
    #[key(rule = RANGE, omitted)]
    pub x: Option<[f64; 2]>,
    /// Of the normal displacement.
    #[key(rule = RANGE, omitted)]
    pub y: Option<[f64; 2]>,
    /// Of the velocity along x.
    #[key(rule = RANGE, omitted)]
    pub velocity_x: Option<[f64; 2]>,
    /// Of the velocity along y.
    #[key(rule = RANGE, omitted)]
    pub velocity_y: Option<[f64; 2]>,
}

/// Which way a bifurcation diagram is followed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Choice)]
#[choice(what = "direction")]
pub enum SweepDirection {
    /// Both ways.
    Both,
    /// From the first value to the last.
    Forward,
    /// From the last value to the first.
    Backward,
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

const ANY: Number = Number::any(Dimension::NUMBER);
const RANGE: Pair = Pair { of: ANY, what: "two numbers, [from, to]", is_ascending: true };
pub(crate) const DURATION: Scaled = Scaled::positive(Dimension::TIME, "ω_nx t");
const TRANSIENT: Scaled = Scaled { range: Range::NonNegative, ..DURATION };
pub(crate) const TOLERANCE: Number =
    Number { dimension: Dimension::NUMBER, range: Range::Interval { above: 1e-14, up_to: 1e-2 } };
pub(crate) const STEPS: Whole = Whole { from: 1, to: 1_000_000_000_000 };

/// The time within which a motion settles where the case does not say, ω_nx t.
pub(crate) const SETTLING_DURATION: Value = Value::group(2e4);
/// The tolerance of cycles where the case does not say.
pub(crate) const CYCLE_TOLERANCE: f64 = 1e-10;
/// The steps of a motion where the case does not say.
pub(crate) const MOTION_STEPS: usize = 10_000_000;

/// Settings that say how a motion is followed.
macro_rules! followed {
    ($($settings:ty),*) => {
        $(impl $settings {
            /// How a motion is followed.
            pub fn following(&self) -> Following {
                Following { duration: self.duration, tolerance: self.tolerance, steps: self.steps }
            }
        })*
    };
}

followed!(History, LimitCycle, Diagram, Basin, crate::oscillator::engines::settings::EnginesSettings);

impl SweepDirection {
    /// The single sweeps that it takes.
    pub fn sweeps(self) -> &'static [Self] {
        match self {
            Self::Both => &[Self::Forward, Self::Backward],
            Self::Forward => &[Self::Forward],
            Self::Backward => &[Self::Backward],
        }
    }
}

impl MotionStart {
    /// Where a motion starts where the case does not say.
    pub const USUAL: Self = Self::Disturbance(0.2);

    /// What is given of the coordinates of a state: displacements, then their velocities.
    pub fn state<const N: usize>(&self) -> [Option<f64>; N] {
        match *self {
            Self::Disturbance(_) => [None; N],
            Self::State { x, y, velocity_x, velocity_y } => in_order([x, y], [velocity_x, velocity_y]),
        }
    }
}

impl StartRanges {
    /// The ranges in the order of a state: displacements, then their velocities.
    pub fn state<const N: usize>(&self) -> [Option<[f64; 2]>; N] {
        in_order([self.x, self.y], [self.velocity_x, self.velocity_y])
    }

    fn says_one(&mut self, section: &Section<'_>) -> Result<(), Fault> {
        if !section.is_empty() {
            return Ok(());
        }
        Err(section.missing("x", "x = [from, to], the range of a coordinate"))
    }
}

/// What is given of the coordinates of a state, half of which are displacements.
fn in_order<T: Copy, const N: usize>(
    displacements: [Option<T>; 2],
    velocities: [Option<T>; 2],
) -> [Option<T>; N] {
    std::array::from_fn(|k| {
        let (given, k) = if k < N / 2 { (displacements, k) } else { (velocities, k - N / 2) };
        given.get(k).copied().flatten()
    })
}

impl History {
    fn complete(&mut self, section: &Section<'_>) -> Result<(), Fault> {
        leave_some(&mut self.transient, self.duration, section)
    }
}

impl Diagram {
    fn complete(&mut self, section: &Section<'_>) -> Result<(), Fault> {
        leave_some(&mut self.transient, self.duration, section)
    }
}

/// Refuses a transient that leaves nothing of the duration; it is half of it where the case does not say.
fn leave_some(transient: &mut Value, duration: Value, section: &Section<'_>) -> Result<(), Fault> {
    let Some(node) = section.get("transient") else {
        *transient = Value { number: 0.5 * duration.number, ..duration };
        return Ok(());
    };
    same_form("`duration` and `transient`".to_owned(), duration.form, transient.form, node.place)?;
    if transient.number < duration.number {
        return Ok(());
    }
    let (transient, duration) = (transient.number, duration.number);
    Err(Cause::NothingMeasured { transient, duration }.at(node.place))
}

/// A model with motion.
pub(crate) trait MotionModel: SweptKeys {
    /// The analyses of its cases.
    type Analysis;

    /// One of motion among them.
    fn of_motion(analysis: MotionAnalysis<Self::Key>) -> Self::Analysis;

    /// What it has of the settings of an analysis of motion.
    fn own(declared: Vec<Declaration>) -> Vec<Declaration> {
        declared
    }

    /// Refuses what it does not have.
    fn refuse_others(_: &Section<'_>, _: &[Declaration]) -> Result<(), Fault> {
        Ok(())
    }
}

/// The kinds of analyses of motion of a model.
pub(crate) struct MotionKinds<S>(std::marker::PhantomData<S>);

impl<S: MotionModel> MotionKinds<S> {
    pub(crate) const HISTORY: Kind<S, S::Analysis> = Kind {
        name: "motion",
        doc: "the history of one motion: stick, slip, lift-off, its averages, its energy",
        declared: declared::<S, History>,
        read: |_, section| read::<S, History>(section).map(|own| S::of_motion(MotionAnalysis::History(own))),
        picture: Some(super::history::PICTURE),
    };
    pub(crate) const LIMIT_CYCLE: Kind<S, S::Analysis> = Kind {
        name: "limit-cycle",
        doc: "the cycle that a motion settles to, with its Floquet multipliers",
        declared: declared::<S, LimitCycle>,
        read: |_, section| {
            read::<S, LimitCycle>(section).map(|own| S::of_motion(MotionAnalysis::LimitCycle(own)))
        },
        picture: Some(super::limit_cycle::PICTURE),
    };
    pub(crate) const BIFURCATION: Kind<S, S::Analysis> = Kind {
        name: "bifurcation",
        doc: "what the motion settles to along one key, each motion from the end of the one before",
        declared: || [vec![SWEEP.declaration::<S>()], declared::<S, Diagram>()].concat(),
        read: |keys, section| {
            let (sweep, diagram) = both(SWEEP.read_alone(keys, section), read::<S, Diagram>(section))?;
            Ok(S::of_motion(MotionAnalysis::Bifurcation(Bifurcation { sweep, diagram })))
        },
        picture: Some(super::bifurcation::PICTURE),
    };
    pub(crate) const BASIN: Kind<S, S::Analysis> = Kind {
        name: "basin",
        doc: "the share of starts, drawn evenly, from which steady sliding is reached",
        declared: declared::<S, Basin>,
        read: |_, section| read::<S, Basin>(section).map(|own| S::of_motion(MotionAnalysis::Basin(own))),
        picture: Some(super::basin::PICTURE),
    };
}

fn declared<S: MotionModel, T: Settings>() -> Vec<Declaration> {
    S::own(T::declarations())
}

fn read<S: MotionModel, T: Settings>(section: &Section<'_>) -> Result<T, Fault> {
    S::refuse_others(section, &declared::<S, T>())?;
    T::read_table(section)
}

impl<K: Copy> MotionAnalysis<K> {
    /// Puts the settings into a canonical form.
    pub(crate) fn write_table<S: SweptKeys<Key = K>>(&self, json: &mut Map<String, Json>) {
        match self {
            Self::History(own) => own.write_table(json),
            Self::LimitCycle(own) => own.write_table(json),
            Self::Bifurcation(own) => {
                SWEEP.write::<S>(&own.sweep, json);
                own.diagram.write_table(json);
            }
            Self::Basin(own) => own.write_table(json),
        }
    }
}
