//! `march`: explicit time integration of the coupled structures along the path.

use super::SlidingCase;
use super::motion::check_course;
use super::observe::{PointQuantity, Signal, read_signal};
use super::problem::SlidingProblem;
use super::signals::{Sampling, Sound, read_signals, read_sound};
use crate::cause::Cause;
use crate::contact_problem::ContactProblem;
use crate::declared::{Called, read_key};
use crate::error::Fault;
use crate::section::Section;
use crate::sliding_keys::SlidingKey;
use crate::structure::lists::number;
use judder_keys_derive::Choice;

/// How the coupled structures are integrated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MarchMethod {
    /// Couplings of the rigid, a-priori motion (section 2.2 of the beams paper).
    Subs {
        /// Whether the static slope of the deformed track is put in.
        static_slope: bool,
    },
    /// Couplings of the deformed structures (section 3).
    Ensubs,
    /// Forward increment Lagrange multipliers (section 2.1): stick, slip and separation.
    Film,
    /// The modal form integrated exactly between contacts.
    ResidualFlexibility {
        /// Modes above, rad/s, are replaced by their flexibility.
        cut_off: f64,
    },
}

/// The word of a method, before what belongs to it is read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Choice)]
#[choice(what = "method")]
pub enum MarchWord {
    /// Couplings of the rigid, a-priori motion.
    Subs,
    /// Couplings of the deformed structures.
    Ensubs,
    /// Forward increment Lagrange multipliers.
    Film,
    /// Exact between contacts.
    ResidualFlexibility,
}

impl MarchMethod {
    /// The word in a case file.
    pub fn word(self) -> MarchWord {
        match self {
            Self::Subs { .. } => MarchWord::Subs,
            Self::Ensubs => MarchWord::Ensubs,
            Self::Film => MarchWord::Film,
            Self::ResidualFlexibility { .. } => MarchWord::ResidualFlexibility,
        }
    }

    /// The name in a case file.
    pub fn name(self) -> &'static str {
        self.word().name()
    }
}

/// Which displacements of the next step the geometry of the contact is taken from, by EnSubs and FiLM.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Predictor {
    /// Those without the contact's force, as equation (16) of the beams paper has them.
    Printed,
    /// Those under the force of the last step.
    #[default]
    WithForce,
}

impl Predictor {
    /// The predictors with their names in a case file.
    pub const ALL: [(&'static str, Self); 2] = [("printed", Self::Printed), ("with-force", Self::WithForce)];

    /// The name in a case file.
    pub fn name(self) -> &'static str {
        Self::ALL[self as usize].0
    }
}

/// A march along the path, or along a part of it.
#[derive(Debug, Clone, PartialEq)]
pub struct March {
    /// How it integrates.
    pub method: MarchMethod,
    /// Where the geometry of the contact comes from; `None` for methods that take it from elsewhere.
    pub predictor: Option<Predictor>,
    /// h, s; `None` where the method shall choose.
    pub step: Option<f64>,
    /// s at its start, m; the ramps run from here.
    pub from: f64,
    /// s at its end, m; beyond `from` in the direction of the motion.
    pub to: f64,
    /// How signals are sampled.
    pub signals: Sampling,
    /// The signal whose peak and bursts are told.
    pub signal: Signal,
    /// What is kept of the motion of every observed point.
    pub quantities: Vec<PointQuantity>,
    /// Which signals are left as sound.
    pub sound: Sound,
    /// Steps between two states that an interrupted march can go on from.
    pub checkpoint_steps: usize,
}

/// Steps between two checkpoints where the case does not say.
pub const CHECKPOINT_STEPS: usize = 500_000;
/// The least and the most of them.
pub const CHECKPOINT_RANGE: [usize; 2] = [1000, 1_000_000_000];
/// The most steps of a march: weeks.
pub const STEPS: f64 = 1e12;

/// The keys of a march.
pub(super) const MARCH_KEYS: &[&str] = &[
    "method",
    "step",
    "from",
    "to",
    "signals",
    "signal",
    "cut_off",
    "slope",
    "predictor",
    "sound",
    "checkpoint_steps",
];
pub(super) fn read_march(case: &SlidingCase, section: &Section<'_>) -> Result<March, Fault> {
    let method = read_method(section)?;
    let step = read_step(section)?;
    let [from, to] = read_path(case, section)?;
    let motion = &case.motion;
    if let Some(step) = step {
        let steps = ((to - from) / motion.velocity + motion.ramps.velocity) / step;
        if steps > STEPS {
            let place = section.get("step").map_or(section.place, |node| node.place);
            return Err(SlidingProblem::TooManySteps { steps, limit: STEPS }.at(place));
        }
    }
    let (signals, quantities) = read_signals(section, step)?;
    let [fewest, most] = CHECKPOINT_RANGE;
    Ok(March {
        method,
        predictor: read_predictor(section, method)?,
        step,
        from,
        to,
        signals,
        signal: read_signal(section, "signal", &case.points)?,
        quantities,
        sound: read_sound(case, section)?,
        checkpoint_steps: section.whole("checkpoint_steps", fewest, most)?.unwrap_or(CHECKPOINT_STEPS),
    })
}

fn read_method(section: &Section<'_>) -> Result<MarchMethod, Fault> {
    let word: MarchWord = read_key(section, Called { key: "method", doc: "", example: None }, &(), || None)?;
    let refuse = |key, own: MarchWord| if word == own { Ok(()) } else { refuse_with(section, key, word) };
    refuse("slope", MarchWord::Subs)?;
    refuse("cut_off", MarchWord::ResidualFlexibility)?;
    Ok(match word {
        MarchWord::Subs => {
            let choices = [("none", false), ("static", true)];
            let static_slope = section.choice("slope", "slope", &choices)?.unwrap_or(false);
            MarchMethod::Subs { static_slope }
        }
        MarchWord::Ensubs => MarchMethod::Ensubs,
        MarchWord::Film => MarchMethod::Film,
        MarchWord::ResidualFlexibility => {
            MarchMethod::ResidualFlexibility { cut_off: number(section, SlidingKey::CutOff.entry())? }
        }
    })
}

/// Refuses a key that means nothing to a method.
pub(super) fn refuse_with(section: &Section<'_>, key: &'static str, method: MarchWord) -> Result<(), Fault> {
    let Some(node) = section.get(key) else { return Ok(()) };
    let with = format!("method = \"{}\"", method.name());
    Err(Cause::Contact { problem: ContactProblem::Meaningless { key, with } }.at(node.place))
}

/// Subs knows the geometry beforehand; the march with residual flexibility comes to the force of the step itself.
fn read_predictor(section: &Section<'_>, method: MarchMethod) -> Result<Option<Predictor>, Fault> {
    match method {
        MarchMethod::Subs { .. } | MarchMethod::ResidualFlexibility { .. } => {
            refuse_with(section, "predictor", method.word()).map(|()| None)
        }
        MarchMethod::Ensubs | MarchMethod::Film => {
            let predictor = section.choice("predictor", "predictor", &Predictor::ALL)?;
            Ok(Some(predictor.unwrap_or_default()))
        }
    }
}

fn read_step(section: &Section<'_>) -> Result<Option<f64>, Fault> {
    section.get("step").map(|_| number(section, SlidingKey::Step.entry())).transpose()
}

/// The part of the path that is marched.
fn read_path(case: &SlidingCase, section: &Section<'_>) -> Result<[f64; 2], Fault> {
    let [start, end] = [case.motion.start, case.motion.end];
    let position = |key: SlidingKey, usual: f64| {
        let entry = key.entry();
        let Some(node) = section.get(entry.name()) else { return Ok(usual) };
        let position = number(section, entry)?;
        if (start.min(end)..=start.max(end)).contains(&position) {
            return Ok(position);
        }
        let key = entry.name().to_owned();
        Err(SlidingProblem::OutsidePath { key, position, start, end }.at(node.place))
    };
    let [from, to] = [position(SlidingKey::From, start)?, position(SlidingKey::To, end)?];
    let place = section.get("to").or(section.get("from")).map_or(section.place, |node| node.place);
    check_course([from, to], case.motion.velocity).map_err(|problem| problem.at(place))?;
    Ok([from, to])
}
