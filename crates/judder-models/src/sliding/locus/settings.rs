//! `locus`: complex eigenvalues against the position of the contact, or against any key.

use crate::key_sweep::{KeySweep, SweptSections};
use crate::sliding::case::SlidingCase;

use crate::structure::modes::{MODES, MODES_LIMIT};
use judder_keys::Settings;
use judder_keys::cause::Cause;
use judder_keys::declared::{Number, Whole};
use judder_keys::dimension::Dimension;
use judder_keys::error::Fault;
use judder_keys::section::Section;
use judder_keys::span::ascending;
use judder_sliding::locus::Configuration;

/// Complex eigenvalues along an axis.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct LocusAnalysis {
    /// The configuration about which small motions are meant.
    #[key(default = Configuration::Undeformed)]
    pub configuration: Configuration,
    /// Whether the structures are damped.
    #[key(default = true)]
    pub damping: bool,
    /// How many eigenvalues at each value, from the lowest on, by the larger of imaginary and absolute real part.
    #[key(rule = Whole { from: 1, to: MODES_LIMIT }, default = MODES)]
    pub count: usize,
    /// What varies.
    #[key(flatten)]
    pub along: Along,
}

/// What varies along a locus.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(check = Along::one)]
pub enum Along {
    /// Positions of the contact, evenly spaced; the path of the motion where left out.
    #[key(default)]
    Positions(Positions),
    /// A key of the case, with the contact held.
    Key {
        /// Where the contact is while a key is swept.
        #[key(rule = POSITION, symbol = "s", example = "\"74 mm\", where the contact is held while the key is swept")]
        at: f64,
        /// Any number of `structure`, `contact`, `motion` or `parameters` over a range; each value is a case of its own.
        #[key(rule = SWEPT, example = "…, `{ key, from, to, points, scale }`, or `{ key, values }`")]
        sweep: KeySweep,
    },
}

/// Positions of the contact, evenly spaced.
#[derive(Debug, Clone, Copy, PartialEq, Settings)]
pub struct Positions {
    /// The first position; that of the motion where left out.
    #[key(rule = POSITION, symbol = "s", filled)]
    pub from: f64,
    /// The last position; that of the motion where left out.
    #[key(rule = POSITION, symbol = "s", filled)]
    pub to: f64,
    /// How many, both ends included.
    #[key(rule = Whole { from: 2, to: POSITIONS_LIMIT }, default = POSITIONS)]
    pub points: usize,
}

/// What can be swept: the sections whose numbers describe structures, contact and motion.
const SWEPT: SweptSections = SweptSections {
    names: &["parameters", "structure", "contact", "motion"],
    advice: "sweep a number of a structure, the contact, the motion or the parameters: structure.NAME.beam.angle, contact.friction_coefficient, \
        motion.load.force, parameters.NAME",
    example: "contact.friction_coefficient",
};

const POSITION: Number = Number::non_negative(Dimension::LENGTH);

/// The most positions.
pub const POSITIONS_LIMIT: usize = 1_000_000;

/// The number of positions where the case does not say.
pub const POSITIONS: usize = 1000;

impl LocusAnalysis {
    /// Tries a sweep on the case; positions that are left out are those of the path of its motion.
    pub(crate) fn admit(mut self, case: &SlidingCase, section: &Section<'_>) -> Result<Self, Fault> {
        match (&mut self.along, section.get("sweep")) {
            (Along::Positions(positions), _) => positions.admit(case, section.inner("positions")?)?,
            (Along::Key { sweep, .. }, Some(node)) => sweep.admit(node, |value| case.at(sweep, value))?,
            (Along::Key { .. }, None) => (),
        }
        Ok(self)
    }
}

impl Along {
    /// Refuses keys of both, and a place without a sweep.
    fn one(section: &Section<'_>) -> Result<(), Fault> {
        let (problem, node) = match (section.get("sweep"), section.get("positions"), section.get("at")) {
            (Some(_), Some(node), _) => {
                let (first, second) = ("sweep".to_owned(), "positions".to_owned());
                (Cause::OneOfTwo { first, second }, node)
            }
            (None, _, Some(node)) => {
                let with = "`positions`, without `sweep`".to_owned();
                (Cause::Meaningless { key: "at", with }, node)
            }
            _ => return Ok(()),
        };
        Err(problem.at(node.place))
    }
}

impl Positions {
    fn admit(&mut self, case: &SlidingCase, given: Option<Section<'_>>) -> Result<(), Fault> {
        let (start, end) = (case.motion.start, case.motion.end);
        let is_given = |key: &str| given.as_ref().is_some_and(|given| given.get(key).is_some());
        if !is_given("from") {
            self.from = start.min(end);
        }
        if !is_given("to") {
            self.to = start.max(end);
        }
        let Some(given) = given else { return Ok(()) };
        let ends = [("from", self.from), ("to", self.to)];
        let written = || ends.map(|(key, end)| given.written(key, end));
        ascending([self.from, self.to], written, given.place)
    }
}
