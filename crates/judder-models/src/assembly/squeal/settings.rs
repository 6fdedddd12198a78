//! `squeal`: which modes, how their cycles are computed, what is asked of them besides.

use crate::assembly::case::AssemblyCase;
use crate::assembly::eigen::BAND;
use crate::assembly::limit_cycle::settings::CycleSolver;
use crate::assembly::swept::{ALL_FRICTION, SWEPT};
use crate::key_sweep::{KeySweep, KeySweepProblem, SweptSections};
use judder_keys::Settings;
use judder_keys::cause::Cause;
use judder_keys::declared::{Allowed, Setting, Settings as _, Whole};
use judder_keys::dimension::Dimension;
use judder_keys::document::{Data, Node};
use judder_keys::error::Fault;
use judder_keys::problem::Placed;
use judder_keys::section::Section;
use judder_study::case::scale::Spacing;
use serde_json::{Value as Json, json};

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
}

const HARMONICS: Whole = Whole { from: 1, to: 500 };
/// Harmonics of the cycles of a margin where the case does not say.
const USUAL_HARMONICS: usize = 7;
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
            }),
            _ => Some(KeySweep::read(section, key, node, &MARGIN)?),
        }))
    }

    fn write(&self, (): &()) -> Json {
        self.0.as_ref().map_or(json!(false), |own| own.write(&MARGIN))
    }
}

impl AssemblySqueal {
    fn check(&mut self, section: &Section<'_>) -> Result<(), Fault> {
        match section.get("margin_harmonics") {
            Some(node) if self.margin.is_none() => {
                let with = "no `margin`".to_owned();
                Err(Cause::Meaningless { key: "margin_harmonics", with }.at(node.place))
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
        let (Some(case), Some(sweep), Some(node)) = (case, own.margin_sweep(), section.get("margin")) else {
            return Ok(own);
        };
        if sweep.path == ALL_FRICTION {
            return Ok(own);
        }
        sweep.admit(node, |value| case.at(&[(sweep, value)]))?;
        match case.number(&sweep.path) {
            Some(_) => Ok(own),
            None => {
                let key = sweep.path.clone();
                let reason = "the case does not give it as a number".to_owned();
                let advice =
                    "give it in the case: margins tell on which side of each onset the case is".to_owned();
                Err(KeySweepProblem::SweptKey { key, reason, advice }.at(node.place))
            }
        }
    }
}
