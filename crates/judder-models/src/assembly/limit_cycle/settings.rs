//! `limit-cycle`: which mode, and how its cycle is computed.

use super::start::CycleStart;
use crate::assembly::AssemblySubject;
use crate::assembly::case::AssemblyCase;
use crate::assembly::periodic::{PeriodicSize, admits_periodic, most_harmonics};
use judder_cycles::backbone::BackboneSettings;
use judder_cycles::cycle::{CycleSettings, HarmonicCount};
use judder_keys::cause::Cause;
use judder_keys::declared::{Number, Settings as _, Whole};
use judder_keys::dimension::Dimension;
use judder_keys::error::Fault;
use judder_keys::numeric_key::Range;
use judder_keys::section::Section;
use judder_keys::{Choice, Settings};
use judder_study::model::Refusal;

/// The limit cycle of a mode.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(check = ModeCycle::check)]
pub struct ModeCycle {
    /// Frequency near which the mode lies; where left out, the fastest growing of the lowest modes is meant.
    #[key(rule = Number::positive(Dimension::ANGULAR_FREQUENCY), symbol = "ω", omitted)]
    pub frequency: Option<f64>,
    /// Where no frequency is given: how many of the lowest modes there are to choose from.
    #[key(rule = MODES, usual = LOWEST, omitted)]
    pub modes: Option<usize>,
    /// Where the cycle is sought in place of along the motions of a mode: a cycle that no mode leads to as well.
    #[key(omitted)]
    pub start: Option<CycleStart>,
    /// How it is computed.
    #[key(default = CycleMethod::HarmonicBalance)]
    pub method: CycleMethod,
    /// Of `method = "shooting"`: steps of a period.
    #[key(rule = STEPS, usual = USUAL_STEPS, omitted)]
    pub steps: Option<usize>,
    /// How the cycle is found.
    #[key(flatten)]
    pub solver: CycleSolver,
}

const STEPS: Whole = Whole { from: 16, to: 10_000_000 };
/// Steps of a period where the case does not say.
pub(super) const USUAL_STEPS: usize = 2048;

pub(in crate::assembly) const MODES: Whole = Whole { from: 1, to: 2000 };
/// Modes to choose from where the case does not say.
pub(in crate::assembly) const LOWEST: usize = 20;

/// The word of a method.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Choice)]
#[choice(what = "method")]
pub enum CycleMethod {
    /// Forces of the contact points as harmonics, stick, slip and lift-off at instants of a period.
    HarmonicBalance,
    /// The same, and from there a march that comes back to where it begins, which what is told of the cycle is then taken from.
    Shooting,
}

/// How limit cycles are computed.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(check = CycleSolver::check)]
pub struct CycleSolver {
    /// How many harmonics there are; where left out, as many as `left_out` asks for.
    #[key(rule = HARMONICS, symbol = "H", omitted)]
    pub harmonics: Option<usize>,
    /// The share of the swing of the contact forces that harmonics may leave out, where their number is not given; no more than 40 are taken.
    #[key(rule = LEFT_OUT, usual = SHARE, omitted)]
    pub left_out: Option<f64>,
    /// Instants of a period a harmonic at which points stick, slide or lift off.
    #[key(rule = SAMPLES, default = 16)]
    pub samples: usize,
    /// How far motions of the mode are followed: amplitude over that at which the contact first changes its state.
    #[key(rule = Number::positive(Dimension::NUMBER), default = 1000.0)]
    pub largest_amplitude: f64,
    /// Whether Floquet multipliers say if motions nearby are drawn to the cycle.
    #[key(default = true)]
    pub stability: bool,
}

const HARMONICS: Whole = Whole { from: 1, to: 500 };
const SAMPLES: Whole = Whole { from: 4, to: 1024 };
const LEFT_OUT: Number =
    Number { dimension: Dimension::NUMBER, range: Range::Interval { above: 0.0, up_to: 0.5 } };
/// What may be left out where the case does not say.
const SHARE: f64 = 0.01;

impl ModeCycle {
    /// Reads a cycle of a case, whose folder is known where it is.
    pub(super) fn of(case: Option<&AssemblyCase>, section: &Section<'_>) -> Result<Self, Fault> {
        let mut own = Self::read_table(section)?;
        own.start.as_mut().map_or(Ok(()), |start| start.find(section, case))?;
        Ok(own)
    }

    fn check(&mut self, section: &Section<'_>) -> Result<(), Fault> {
        no_mode_is_meant(section, self.start.as_ref())?;
        meaningless(section, "modes", self.frequency.is_some(), "frequency")?;
        meaningless(section, "largest_amplitude", self.start.is_some(), "start")?;
        let by_harmonics = self.method == CycleMethod::HarmonicBalance;
        match section.get("steps") {
            Some(node) if by_harmonics => {
                let with = "method = \"harmonic-balance\"".to_owned();
                Err(Cause::Meaningless { key: "steps", with }.at(node.place))
            }
            _ => Ok(()),
        }
    }
}

impl CycleSolver {
    fn check(&mut self, section: &Section<'_>) -> Result<(), Fault> {
        meaningless(section, "left_out", self.harmonics.is_some(), "harmonics")
    }

    /// How cycles of an assembly with so many components of contact points are sought.
    pub(in crate::assembly) fn settings(&self, components: usize) -> CycleSettings {
        let harmonics = match self.harmonics {
            Some(count) => HarmonicCount::Fixed(count),
            None => HarmonicCount::Adaptive {
                left_out: self.left_out.unwrap_or(SHARE),
                most: most_harmonics(components),
            },
        };
        let backbone = BackboneSettings { largest: self.largest_amplitude, ..BackboneSettings::default() };
        CycleSettings { harmonics, samples: self.samples, backbone }
    }

    /// With what cycles are solved.
    pub(in crate::assembly) fn size(&self) -> PeriodicSize {
        let Self { harmonics, samples, stability, .. } = *self;
        PeriodicSize { harmonics, samples, stability, folds: false }
    }
}

/// Refuses what has no cycle.
pub(in crate::assembly) fn admits_cycles(of: &AssemblySubject<'_>) -> Result<(), Refusal> {
    of.touches()?;
    of.slides()?;
    admits_periodic(of)
}

/// Refuses keys that say which mode is meant where none is.
pub(in crate::assembly) fn no_mode_is_meant(
    section: &Section<'_>,
    start: Option<&CycleStart>,
) -> Result<(), Fault> {
    ["frequency", "modes"].into_iter().try_for_each(|key| meaningless(section, key, start.is_some(), "start"))
}

/// Refuses a key that another makes meaningless.
fn meaningless(
    section: &Section<'_>,
    key: &'static str,
    is_meaningless: bool,
    beside: &str,
) -> Result<(), Fault> {
    match section.get(key) {
        Some(node) if is_meaningless => {
            Err(Cause::Meaningless { key, with: format!("`{beside}`") }.at(node.place))
        }
        _ => Ok(()),
    }
}
