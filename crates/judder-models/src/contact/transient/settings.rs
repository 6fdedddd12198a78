//! The settings of a contact that is followed in time.

use crate::contact::settings::{ContactScope, FREQUENCY, INDENTATION, LOAD, LoadingSettings, VELOCITY};
use judder_keys::cause::Cause;
use judder_keys::declared::{Scaled, Settings, Whole, all, both};
use judder_keys::dimension::Dimension;
use judder_keys::error::Fault;
use judder_keys::memory::Memory;
use judder_keys::numeric_key::{Form, Range, Value};
use judder_keys::section::Section;
use judder_keys::{Choice, Settings};

/// A contact that is followed in time.
#[derive(Debug, Clone, Copy, PartialEq, Settings)]
pub struct TransientSettings {
    /// How the indenter moves along the surface.
    #[key(name = "motion", example = "\"start\", \"reciprocation\" or \"rest\"")]
    pub word: MotionWord,
    /// Sliding speed of a start.
    #[key(rule = Scaled { range: Range::NonNegative, ..VELOCITY }, symbol = "v", omitted)]
    velocity: Option<Value>,
    /// Amplitude of the position of a reciprocation.
    #[key(rule = AMPLITUDE, symbol = "a", omitted)]
    amplitude: Option<Value>,
    /// Angular frequency of a reciprocation.
    #[key(rule = FREQUENCY, symbol = "ω", omitted)]
    frequency: Option<Value>,
    /// Indentation, on average.
    #[key(rule = INDENTATION, symbol = "δ", omitted)]
    indentation: Option<Value>,
    /// Normal load, in place of the indentation.
    #[key(rule = LOAD, symbol = "F", omitted)]
    load: Option<Value>,
    /// How the indentation oscillates about its mean, at rest or after a start.
    pub oscillation: Option<OscillationSettings>,
    /// How long the contact is followed.
    #[key(rule = Scaled::positive(Dimension::TIME, "t/τ"), symbol = "t", example = "5 (t/τ), or \"50 ms\"")]
    pub duration: Value,
    /// Cells a side of the window that moves with the indenter.
    #[key(rule = Whole { from: STEPPING_CELLS[0], to: STEPPING_CELLS[1] }, default = TRANSIENT_CELLS)]
    pub cells: usize,
    /// What window and remembered strip may take; as much as the case says where left out.
    #[key(name = "memory_limit")]
    pub memory: Memory,
}

/// How an indenter moves along the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum IndenterMotion {
    /// Not at all.
    Rest,
    /// At time 0 suddenly at this speed, as v τ/R or in m/s.
    Start(Value),
    /// To and fro, x = amplitude · sin ωt.
    Reciprocation(OscillationSettings),
}

/// amplitude · sin ωt.
#[derive(Debug, Clone, Copy, PartialEq, Settings)]
pub struct OscillationSettings {
    /// Amplitude.
    #[key(rule = AMPLITUDE, symbol = "a", example = "1e-2 (over R), or \"0.1 mm\"")]
    pub amplitude: Value,
    /// Angular frequency.
    #[key(rule = FREQUENCY, symbol = "ω", example = "0.4 (ω τ), or \"20 Hz\"")]
    pub frequency: Value,
}

/// The word of a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Choice)]
#[choice(what = "motion")]
pub enum MotionWord {
    /// At time 0 suddenly at a speed.
    Start,
    /// To and fro.
    Reciprocation,
    /// Not at all.
    Rest,
}

const AMPLITUDE: Scaled = Scaled::positive(Dimension::LENGTH, "a/R");

/// The cells a side that a transient contact may be given: it is stepped on one grid.
pub const STEPPING_CELLS: [usize; 2] = [8, 4096];

/// The default number of cells a side.
pub const TRANSIENT_CELLS: usize = 64;

impl TransientSettings {
    /// Reads them for an indenter.
    pub(crate) fn of(scope: Option<&ContactScope>, section: &Section<'_>) -> Result<Self, Fault> {
        let is_round = scope.map_or(Ok(()), |scope| scope.is_round("transient", section));
        let word = section.choice("motion", "motion", &MotionWord::ALL).ok().flatten();
        let fits = word.map_or(Ok(()), |word| word.fits(section));
        let own = both(Self::read_table(section), LoadingSettings::is_one(section, false, false));
        let (((), ()), (settings, ())) = both(both(is_round, fits), own)?;
        if settings.word == MotionWord::Reciprocation {
            OscillationSettings::read_table(section)?;
        }
        let memory = scope.map_or(settings.memory, |scope| scope.memory_limit(section, settings.memory));
        Ok(Self { memory, ..settings })
    }

    /// How the indenter moves along the surface.
    pub fn motion(&self) -> IndenterMotion {
        match (self.word, self.velocity, self.amplitude, self.frequency) {
            (MotionWord::Start, Some(velocity), ..) => IndenterMotion::Start(velocity),
            (MotionWord::Reciprocation, _, Some(amplitude), Some(frequency)) => {
                IndenterMotion::Reciprocation(OscillationSettings { amplitude, frequency })
            }
            _ => IndenterMotion::Rest,
        }
    }

    /// Whether speed, stroke, depth or load are written in SI.
    pub(crate) fn is_in_si(&self) -> bool {
        let given = [self.velocity, self.amplitude, self.indentation, self.load];
        given.into_iter().flatten().any(|own| own.form == Form::Si)
    }

    /// What presses the indenter down, on average.
    pub fn loading(&self) -> LoadingSettings {
        LoadingSettings::of(self.indentation, self.load)
    }
}

impl MotionWord {
    /// Refuses keys that mean nothing to it or to the loading, and asks for what it needs.
    fn fits(self, section: &Section<'_>) -> Result<(), Fault> {
        let known: &[&str] = match self {
            Self::Rest => &["oscillation"],
            Self::Start => &["velocity", "oscillation"],
            Self::Reciprocation => &["amplitude", "frequency"],
        };
        let others = ["velocity", "amplitude", "frequency", "oscillation"];
        let others = others.into_iter().filter(|key| !known.contains(key));
        let with = format!("motion = \"{}\"", self.name());
        let refused = all(others.map(|key| refuse(section, key, &with)));
        let refused = refused.and_then(|_| match section.get("load") {
            Some(_) => refuse(section, "oscillation", "`load`: it is one of the indentation"),
            None => Ok(()),
        });
        let needed = match self {
            Self::Start => section.required("velocity", "velocity = 1e-2 (v τ/R), or \"30 mm/s\"").map(drop),
            Self::Reciprocation if known.iter().all(|key| section.get(key).is_none()) => {
                OscillationSettings::read_table(section).map(drop)
            }
            Self::Rest | Self::Reciprocation => Ok(()),
        };
        both(refused, needed).map(drop)
    }
}

fn refuse(section: &Section<'_>, key: &'static str, with: &str) -> Result<(), Fault> {
    match section.get(key) {
        Some(node) => {
            let problem = Cause::Meaningless { key, with: with.to_owned() };
            Err(problem.at(node.place))
        }
        None => Ok(()),
    }
}
