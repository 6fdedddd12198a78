//! `march` and `growth`: explicit time integration of the coupled structures, along the path and with the contact held.

use super::SlidingCase;
use super::motion::check_course;
use super::observe::{PointQuantity, Signal, read_signal};
use super::problem::SlidingProblem;
use super::signals::{Sampling, Sound, read_signals, read_sound};
use crate::cause::Cause;
use crate::contact_problem::ContactProblem;
use crate::error::Fault;
use crate::section::Section;
use crate::sliding_keys::SlidingKey;
use crate::structure::lists::number;

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

impl MarchMethod {
    /// The names in a case file.
    pub const NAMES: [&'static str; 4] = ["subs", "ensubs", "film", "residual-flexibility"];

    /// The name in a case file.
    pub fn name(self) -> &'static str {
        match self {
            Self::Subs { .. } => "subs",
            Self::Ensubs => "ensubs",
            Self::Film => "film",
            Self::ResidualFlexibility { .. } => "residual-flexibility",
        }
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

/// A march with the contact held, against the eigenvalue there.
#[derive(Debug, Clone, PartialEq)]
pub struct Growth {
    /// How it integrates; `subs` means the undeformed configuration, the others the deformed one.
    pub method: MarchMethod,
    /// h, s; `None` where the method shall choose.
    pub step: Option<f64>,
    /// s, m.
    pub position: f64,
    /// Near which the mode lies that is meant, rad/s.
    pub frequency: f64,
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
/// The keys of a growth.
pub(super) const GROWTH_KEYS: &[&str] = &["method", "position", "frequency", "step", "cut_off"];

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

pub(super) fn read_growth(_: &SlidingCase, section: &Section<'_>) -> Result<Growth, Fault> {
    let method = read_method(section)?;
    Ok(Growth {
        method,
        step: read_step(section)?,
        position: number(section, SlidingKey::Position.entry())?,
        frequency: number(section, SlidingKey::Frequency.entry())?,
    })
}

/// The word of a method, before what belongs to it is read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Word {
    Subs,
    Ensubs,
    Film,
    ResidualFlexibility,
}

fn read_method(section: &Section<'_>) -> Result<MarchMethod, Fault> {
    const WORDS: [Word; 4] = [Word::Subs, Word::Ensubs, Word::Film, Word::ResidualFlexibility];
    section.required("method", &format!("method = \"…\", one of {}", MarchMethod::NAMES.join(", ")))?;
    let choices: [(&'static str, Word); 4] = std::array::from_fn(|k| (MarchMethod::NAMES[k], WORDS[k]));
    let word = section.choice("method", "method", &choices)?.unwrap_or(Word::Ensubs);
    let name = MarchMethod::NAMES[word as usize];
    let refuse = |key, own: Word| if word == own { Ok(()) } else { refuse_with(section, key, name) };
    refuse("slope", Word::Subs)?;
    refuse("cut_off", Word::ResidualFlexibility)?;
    Ok(match word {
        Word::Subs => {
            let choices = [("none", false), ("static", true)];
            let static_slope = section.choice("slope", "slope", &choices)?.unwrap_or(false);
            MarchMethod::Subs { static_slope }
        }
        Word::Ensubs => MarchMethod::Ensubs,
        Word::Film => MarchMethod::Film,
        Word::ResidualFlexibility => {
            MarchMethod::ResidualFlexibility { cut_off: number(section, SlidingKey::CutOff.entry())? }
        }
    })
}

/// Refuses a key that means nothing to a method.
fn refuse_with(section: &Section<'_>, key: &'static str, method: &str) -> Result<(), Fault> {
    let Some(node) = section.get(key) else { return Ok(()) };
    let with = format!("method = \"{method}\"");
    Err(Cause::Contact { problem: ContactProblem::Meaningless { key, with } }.at(node.place))
}

/// Subs knows the geometry beforehand; the march with residual flexibility comes to the force of the step itself.
fn read_predictor(section: &Section<'_>, method: MarchMethod) -> Result<Option<Predictor>, Fault> {
    match method {
        MarchMethod::Subs { .. } | MarchMethod::ResidualFlexibility { .. } => {
            refuse_with(section, "predictor", method.name()).map(|()| None)
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
