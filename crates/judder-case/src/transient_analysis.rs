//! The settings of a contact that is followed in time.

use crate::cause::Cause;
use crate::contact_analysis::{ContactScope, Loading};
use crate::contact_keys::ContactKey;
use crate::contact_problem::ContactProblem;
use crate::error::Fault;
use crate::keys::Value;
use crate::memory::{MEMORY_LIMIT, Memory};
use crate::section::Section;
use crate::shape::Shape;
use crate::swept_keys::read_value;

/// A contact that is followed in time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TransientSettings {
    /// How the indenter moves along the surface.
    pub motion: Motion,
    /// What presses the indenter down, on average.
    pub loading: Loading,
    /// How the indentation oscillates about its mean.
    pub oscillation: Option<Oscillation>,
    /// t, as t/τ or in s.
    pub duration: Value,
    /// Cells a side of the window that moves with the indenter.
    pub cells: usize,
    /// What window and remembered strip may take.
    pub memory: Memory,
}

/// How an indenter moves along the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Motion {
    /// Not at all.
    Rest,
    /// At time 0 suddenly at this speed, as v τ/R or in m/s.
    Start(Value),
    /// To and fro, x = amplitude · sin ωt.
    Reciprocation(Oscillation),
}

impl Motion {
    /// The name in a case file.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Rest => "rest",
            Self::Start(_) => "start",
            Self::Reciprocation(_) => "reciprocation",
        }
    }

    /// The keys that belong to it.
    fn keys(word: MotionWord) -> &'static [&'static str] {
        match word {
            MotionWord::Rest => &["oscillation"],
            MotionWord::Start => &["velocity", "oscillation"],
            MotionWord::Reciprocation => &["amplitude", "frequency"],
        }
    }
}

/// amplitude · sin ωt.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Oscillation {
    /// Amplitude over R, or in m.
    pub amplitude: Value,
    /// ω, as ω τ or in rad/s.
    pub frequency: Value,
}

/// The word of a motion, before its numbers are read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum MotionWord {
    Rest,
    Start,
    Reciprocation,
}

/// The motions by name.
const MOTIONS: [(&str, MotionWord); 3] =
    [("start", MotionWord::Start), ("reciprocation", MotionWord::Reciprocation), ("rest", MotionWord::Rest)];
/// The names of the motions.
pub(crate) const MOTION_NAMES: [&str; 3] = [MOTIONS[0].0, MOTIONS[1].0, MOTIONS[2].0];
/// The cells a side that a transient contact may be given: it is stepped on one grid.
pub const STEPPING_CELLS: [usize; 2] = [8, 4096];

/// The default number of cells a side.
pub const TRANSIENT_CELLS: usize = 64;
/// The keys of the kind.
pub(crate) const TRANSIENT_KEYS: &[&str] = &[
    "motion",
    "velocity",
    "amplitude",
    "frequency",
    "indentation",
    "load",
    "oscillation",
    "duration",
    "cells",
    MEMORY_LIMIT,
];

pub(crate) fn read_transient(
    scope: &ContactScope,
    section: &Section<'_>,
) -> Result<TransientSettings, Fault> {
    if !matches!(scope.shape, Shape::Paraboloid | Shape::Sphere) {
        let (kind, shapes, shape) = ("transient", "a paraboloid or a sphere", scope.shape.name());
        return Err(
            Cause::Contact { problem: ContactProblem::Shape { kind, shapes, shape } }.at(section.place)
        );
    }
    section.required("motion", "motion = \"start\", \"reciprocation\" or \"rest\"")?;
    let word = section.choice("motion", "motion", &MOTIONS)?.unwrap_or(MotionWord::Rest);
    let known = Motion::keys(word);
    for key in ["velocity", "amplitude", "frequency", "oscillation"] {
        if !known.contains(&key) {
            let with = MOTIONS.iter().find(|(_, other)| *other == word).map_or("", |(name, _)| name);
            refuse(section, key, &format!("motion = \"{with}\""))?;
        }
    }
    let motion = match word {
        MotionWord::Rest => Motion::Rest,
        MotionWord::Start => {
            let expected = "velocity = 1e-2 (v τ/R), or \"30 mm/s\"";
            Motion::Start(needed(section, ContactKey::Velocity, expected)?)
        }
        MotionWord::Reciprocation => Motion::Reciprocation(read_oscillation(section)?),
    };
    let loading = read_loading(section)?;
    let oscillation = match section.get("oscillation") {
        Some(_) if matches!(loading, Loading::Load(_)) => {
            refuse(section, "oscillation", "`load`: it is one of the indentation")?;
            None
        }
        Some(node) => {
            let keys = ["amplitude", "frequency"];
            Some(read_oscillation(&Section::open(node, "oscillation", "`oscillation`", &keys)?)?)
        }
        None => None,
    };
    let [fewest, most] = STEPPING_CELLS;
    Ok(TransientSettings {
        motion,
        loading,
        oscillation,
        duration: needed(section, ContactKey::Duration, "duration = 5 (t/τ), or \"50 ms\"")?,
        cells: section.whole("cells", fewest, most)?.unwrap_or(TRANSIENT_CELLS),
        memory: scope.memory_limit(section)?,
    })
}

fn read_oscillation(section: &Section<'_>) -> Result<Oscillation, Fault> {
    Ok(Oscillation {
        amplitude: needed(section, ContactKey::Amplitude, "amplitude = 1e-2 (over R), or \"0.1 mm\"")?,
        frequency: needed(section, ContactKey::Frequency, "frequency = 0.4 (ω τ), or \"20 Hz\"")?,
    })
}

/// The one of two that presses the indenter down.
fn read_loading(section: &Section<'_>) -> Result<Loading, Fault> {
    let value = |key: ContactKey| {
        let entry = key.entry();
        section.get(entry.name()).map(|node| read_value(entry, entry.name(), node)).transpose()
    };
    match (value(ContactKey::Indentation)?, value(ContactKey::Load)?) {
        (None, Some(load)) => Ok(Loading::Load(load)),
        (Some(_), Some(_)) => {
            let place = section.get("load").map_or(section.place, |node| node.place);
            let (first, second) = ("indentation".to_owned(), "load".to_owned());
            Err(Cause::Contact { problem: ContactProblem::OneOfTwo { first, second } }.at(place))
        }
        _ => {
            let expected = "indentation = 1e-2 (δ/R), or load = 1e-4 (F/(E0* R²))";
            Ok(Loading::Indentation(needed(section, ContactKey::Indentation, expected)?))
        }
    }
}

fn needed(section: &Section<'_>, key: ContactKey, expected: &str) -> Result<Value, Fault> {
    let entry = key.entry();
    read_value(entry, &section.path(entry.name()), section.required(entry.name(), expected)?)
}

fn refuse(section: &Section<'_>, key: &'static str, with: &str) -> Result<(), Fault> {
    match section.get(key) {
        Some(node) => {
            let problem = ContactProblem::Meaningless { key, with: with.to_owned() };
            Err(Cause::Contact { problem }.at(node.place))
        }
        None => Ok(()),
    }
}
