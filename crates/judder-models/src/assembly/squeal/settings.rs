//! `squeal`: which modes, how their cycles are computed, what is asked of them besides.

use super::cures::around;
use crate::assembly::case::AssemblyCase;
use crate::assembly::case::problem::AssemblyProblem;
use crate::assembly::eigen::BAND;
use crate::assembly::limit_cycle::settings::CycleSolver;
use crate::assembly::march::settings::check_steps;
use crate::assembly::swept::{ALL_FRICTION, SWEPT};
use crate::key_sweep::{KeySweep, KeySweepProblem, SweptSections};
use judder_keys::Settings;
use judder_keys::cause::Cause;
use judder_keys::declared::{Allowed, Number, NumberPair, Setting, Settings as _, Several, Whole, all, both};
use judder_keys::dimension::Dimension;
use judder_keys::document::{Data, Node};
use judder_keys::error::Fault;
use judder_keys::problem::Placed;
use judder_keys::quantity::WrittenUnit;
use judder_keys::section::{Section, list, wrong_type};
use judder_study::case::scale::Spacing;
use judder_study::case::study_sweep::SEEDS;
use judder_study::text::short;
use serde_json::{Value as Json, json};
use std::f64::consts::TAU;

/// The cycles of all modes that grow.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(check = AssemblySqueal::check)]
pub struct AssemblySqueal {
    /// Between which frequencies modes are sought that grow, by less than half a radian a radian.
    #[key(rule = BAND, symbol = "ω")]
    pub band: [f64; 2],
    /// How their cycles are computed.
    #[key(flatten)]
    pub solver: CycleSolver,
    /// Along what global margins are sought, how far beyond the onset of each mode its cycles reach: any number of the case over a range, `key = "friction"` for a factor on the friction
    /// of all contacts; `true` for that from 0 to 1.
    #[key(
        example = "true, or { key = \"contact.NAME.friction_coefficient\", from = 0.1, to = 0.6, points = 26 }",
        omitted
    )]
    pub margin: Option<MarginSweep>,
    /// How many harmonics the cycles of a margin have.
    #[key(rule = HARMONICS, usual = USUAL_HARMONICS, omitted)]
    pub margin_harmonics: Option<usize>,
    /// Knocks from steady sliding, of which it is told how many keep vibrating.
    #[key(
        example = "{ at = \"POINT.y\", impulse = [\"0 N s\", \"0.01 N s\"], step = \"1 us\", duration = \"50 ms\" }",
        omitted
    )]
    pub knocks: Option<Knocks>,
    /// Numbers of the case by which the growth rate of the mode that leads the ranking is differentiated, by their dotted paths; `true` for all dampings, moduli and stiffnesses of the
    /// case.
    #[key(example = "true, or [\"structure.NAME.damping.rayleigh.beta\"]", omitted)]
    pub cures: Option<AskedCures>,
}

/// Impulses at an observed point.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct Knocks {
    /// Where and along which direction: an observed point as signals call it, such as `back.y`.
    #[key(example = "\"POINT.y\"")]
    pub at: String,
    /// Between which sizes impulses are drawn, evenly and of either sign.
    #[key(rule = IMPULSES, symbol = "p")]
    pub impulse: [f64; 2],
    /// Number of knocks.
    #[key(rule = Whole { from: 1, to: 1_000_000 }, default = 100)]
    pub samples: usize,
    /// Which knocks are drawn; the n-th depends on the seed and on n alone.
    #[key(rule = SEEDS, default = 1)]
    pub seed: usize,
    /// The time step of the implicit march.
    #[key(rule = Number::positive(Dimension::TIME), symbol = "h")]
    pub step: f64,
    /// How long each motion is followed.
    #[key(rule = Number::positive(Dimension::TIME))]
    pub duration: f64,
}

const IMPULSES: NumberPair = NumberPair {
    of: Number::non_negative(Dimension::new(1, 1, -1, 0)),
    what: "two impulses, [from, to]",
    is_ascending: true,
};

/// By which numbers a growth rate is differentiated.
#[derive(Debug, Clone, PartialEq)]
pub enum AskedCures {
    /// All dampings, moduli and stiffnesses.
    Usual,
    /// These.
    Keys(Vec<String>),
}

impl AskedCures {
    /// Whether any are asked for.
    pub(super) fn asks(&self) -> bool {
        !matches!(self, Self::Keys(paths) if paths.is_empty())
    }
}

impl Setting for AskedCures {
    type Rule = ();

    fn form((): &()) -> Allowed {
        Allowed::Either(vec![Allowed::Flag, <Vec<String> as Setting>::form(&PATHS)])
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        match node.data {
            Data::Boolean(true) => Ok(Self::Usual),
            Data::Boolean(false) => Ok(Self::Keys(Vec::new())),
            Data::List(_) => Vec::read(section, key, node, &PATHS).map(Self::Keys),
            _ => {
                let expected = "true, or a list of dotted paths of numbers of the case";
                Err(wrong_type(&section.path(key), expected, node))
            }
        }
    }

    fn write(&self, (): &()) -> Json {
        match self {
            Self::Usual => json!(true),
            Self::Keys(paths) => json!(paths),
        }
    }
}

const PATHS: Several<()> = Several { of: (), length: [0, usize::MAX] };

const HARMONICS: Whole = Whole { from: 1, to: 500 };
/// Harmonics of the cycles of a margin where the case does not say.
const USUAL_HARMONICS: usize = 7;
/// Steps of a knock in a period of the upper end of the band, at least.
const STEPS_A_PERIOD: f64 = 20.0;
/// Which part of the duration of a knock has its energy compared with that of the part before, and periods of the lower end of the band in it, at least.
const WINDOW: f64 = 0.2;
const PERIODS_A_WINDOW: f64 = 5.0;
/// Values of a factor on all friction.
const FACTORS: usize = 41;

/// What margins are along.
const MARGIN: SweptSections = SweptSections {
    names: &["parameters", "structure", "contact", "spring", "load", "substrate", ALL_FRICTION],
    ..SWEPT
};

/// A number of the case over a range, or a factor on the friction of all contacts; nothing where none is asked for.
#[derive(Debug, Clone, PartialEq)]
pub struct MarginSweep(pub Option<KeySweep>);

impl Setting for MarginSweep {
    type Rule = ();

    fn form((): &()) -> Allowed {
        Allowed::Either(vec![Allowed::Flag, KeySweep::form(&MARGIN)])
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        Ok(Self(match node.data {
            Data::Boolean(false) => None,
            Data::Boolean(true) => Some(KeySweep {
                path: ALL_FRICTION.to_owned(),
                values: (0..FACTORS).map(|k| k as f64 / (FACTORS - 1) as f64).collect(),
                dimension: Dimension::NUMBER,
                scale: Spacing::Linear,
                unit: WrittenUnit::si(Dimension::NUMBER),
            }),
            Data::Table(_) => Some(KeySweep::read(section, key, node, &MARGIN)?),
            _ => {
                let expected = "true, or a table { key, from, to, points } whose key is a number of the case or \"friction\"";
                return Err(wrong_type(&section.path(key), expected, node));
            }
        }))
    }

    fn write(&self, (): &()) -> Json {
        self.0.as_ref().map_or(json!(false), |own| own.write(&MARGIN))
    }
}

impl AssemblySqueal {
    fn check(&mut self, section: &Section<'_>) -> Result<(), Fault> {
        self.check_knocks(section)?;
        self.check_factors(section)?;
        match section.get("margin_harmonics") {
            Some(node) if self.margin.is_none() => {
                let with = "no `margin`".to_owned();
                Err(Cause::Meaningless { key: "margin_harmonics", with }.at(node.place))
            }
            _ => Ok(()),
        }
    }

    /// Refuses knocks whose steps do not follow the band, or that are not followed long enough to tell.
    fn check_knocks(&self, section: &Section<'_>) -> Result<(), Fault> {
        let (Some(knocks), Some(node)) = (&self.knocks, section.get("knocks")) else { return Ok(()) };
        let [longest, shortest] = self.band.map(|omega| TAU / omega);
        let refuse = |key: &str, reason: String| {
            let place = node.entry(key).unwrap_or(node).place;
            Err(AssemblyProblem::Refused { reason }.at(place))
        };
        if !longest.is_finite() {
            let reason = "a knock is followed over periods of the lower end of `band`, which is zero: give a band that begins above it";
            return refuse("duration", reason.to_owned());
        }
        if let Err(reason) = check_steps(knocks.step, knocks.duration) {
            return refuse("step", reason);
        }
        let largest = shortest / STEPS_A_PERIOD;
        if knocks.step > largest * (1.0 + 1e-9) {
            let (own, largest, upper) = (short(knocks.step), short(largest), short(1.0 / shortest));
            let reason = format!(
                "a step of {own} s does not follow {upper} Hz, the upper end of `band`: give at most {largest} s, or a narrower band"
            );
            return refuse("step", reason);
        }
        let least = PERIODS_A_WINDOW * longest / WINDOW;
        if knocks.duration < least * (1.0 - 1e-9) {
            let (own, least, lower) = (short(knocks.duration), short(least), short(1.0 / longest));
            let reason = format!(
                "in a fifth of {own} s there are no {PERIODS_A_WINDOW} periods of {lower} Hz, the lower end of `band`, whose energies are compared: give at least {least} s, or a narrower band"
            );
            return refuse("duration", reason);
        }
        Ok(())
    }

    /// Refuses factors on friction below zero, which would have it drive.
    fn check_factors(&self, section: &Section<'_>) -> Result<(), Fault> {
        match (self.margin_sweep(), section.get("margin")) {
            (Some(sweep), Some(node))
                if sweep.path == ALL_FRICTION && sweep.values.iter().any(|factor| *factor < 0.0) =>
            {
                let reason = "a factor on all friction is zero or positive".to_owned();
                Err(AssemblyProblem::Refused { reason }.at(node.place))
            }
            _ => Ok(()),
        }
    }

    /// The number along which margins are sought.
    pub(super) fn margin_sweep(&self) -> Option<&KeySweep> {
        self.margin.as_ref()?.0.as_ref()
    }

    /// How many harmonics the cycles of a margin have.
    pub(super) fn margin_harmonics(&self) -> usize {
        self.margin_harmonics.unwrap_or(USUAL_HARMONICS)
    }

    /// Reads one of a case, whose keys are known where it is.
    pub(super) fn of(case: Option<&AssemblyCase>, section: &Section<'_>) -> Result<Self, Fault> {
        let own = Self::read_table(section)?;
        if let Some(case) = case {
            both(own.admit_margin(case, section), own.admit_cures(case, section))?;
        }
        Ok(own)
    }

    fn admit_margin(&self, case: &AssemblyCase, section: &Section<'_>) -> Result<(), Fault> {
        match (self.margin_sweep(), section.get("margin")) {
            (Some(sweep), Some(node)) if sweep.path != ALL_FRICTION => {
                sweep.admit(node, |value| case.at(&[(sweep, value)]))?;
                sweep.admit_between(node, |value| case.at(&[(sweep, value)]))?;
                given(case, &sweep.path, node)
            }
            _ => Ok(()),
        }
    }

    fn admit_cures(&self, case: &AssemblyCase, section: &Section<'_>) -> Result<(), Fault> {
        let (Some(AskedCures::Keys(paths)), Some(node)) = (&self.cures, section.get("cures")) else {
            return Ok(());
        };
        if paths.is_empty() {
            return Ok(());
        }
        let nodes = list("cures", node)?;
        all(paths.iter().zip(nodes).enumerate().map(|(k, (path, node))| match paths[..k].contains(path) {
            true => {
                let reason = format!("`{path}` is named twice among the cures: name it once");
                Err(AssemblyProblem::Refused { reason }.at(node.place))
            }
            false => has_derivative(case, path, node),
        }))
        .map(drop)
    }
}

/// Refuses a cure that is no number of the case, or one that changes in steps.
fn has_derivative(case: &AssemblyCase, path: &str, node: &Node) -> Result<(), Fault> {
    let is_of = SWEPT.names.iter().any(|section| path.split('.').next() == Some(section));
    let refused = |reason: String| Err(AssemblyProblem::Refused { reason }.at(node.place));
    let Some((value, dimension)) = case.number(path).filter(|_| is_of) else {
        return refused(format!(
            "`{path}`, named among the cures, is no number that the case gives: `cures` takes numbers of the case by their dotted paths, such as `{}`",
            SWEPT.example
        ));
    };
    let sweep = around(case, path, (value, dimension));
    let changed = sweep.values.iter().try_for_each(|near| case.at(&[(&sweep, *near)]).map(drop));
    match changed {
        Err(problem) if value != 0.0 => {
            refused(format!("`{path}`, named among the cures, has no derivative: {problem}"))
        }
        _ => Ok(()),
    }
}

/// Refuses a path at which the case gives no number.
fn given(case: &AssemblyCase, path: &str, node: &Node) -> Result<(), Fault> {
    let is_of = SWEPT.names.iter().any(|section| path.split('.').next() == Some(section));
    if is_of && case.number(path).is_some() {
        return Ok(());
    }
    let key = path.to_owned();
    let reason = "the case does not give it as a number".to_owned();
    let advice = format!("give it in the case, or name another number of it: {}", SWEPT.example);
    Err(KeySweepProblem::SweptKey { key, reason, advice }.at(node.place))
}
