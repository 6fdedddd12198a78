//! `locus`: complex eigenvalues against the position of the contact, or against any key.

use super::SlidingCase;
use super::sweep::{KeySweep, read_key_sweep};
use crate::cause::Cause;
use crate::contact_problem::ContactProblem;
use crate::error::Fault;
use crate::section::Section;
use crate::sliding_keys::SlidingKey;
use crate::structure::analysis::{MODES, MODES_LIMIT, ascending};
use crate::structure::lists::number;
use crate::swept_keys::read_value;

/// Complex eigenvalues along an axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Locus {
    /// The configuration about which they are taken.
    pub configuration: Configuration,
    /// Whether the structures are damped.
    pub damping: bool,
    /// How many eigenvalues at each value, from the lowest frequency on.
    pub count: usize,
    /// What varies.
    pub along: Along,
}

/// The configuration about which small motions are meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Configuration {
    /// As drawn.
    Undeformed,
    /// Under load and friction of steady sliding.
    Deformed,
}

impl Configuration {
    /// The configurations with their names in a case file.
    pub const ALL: [(&'static str, Self); 2] =
        [("undeformed", Self::Undeformed), ("deformed", Self::Deformed)];

    /// The name in a case file.
    pub fn name(self) -> &'static str {
        Self::ALL[self as usize].0
    }
}

/// What varies along a locus.
#[derive(Debug, Clone, PartialEq)]
pub enum Along {
    /// The position of the contact.
    Positions(Positions),
    /// A key of the case, with the contact held.
    Key {
        /// s, m.
        at: f64,
        /// The key and its values.
        sweep: KeySweep,
    },
}

/// Positions of the contact, evenly spaced.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Positions {
    /// The first, m.
    pub from: f64,
    /// The last, m; beyond the first.
    pub to: f64,
    /// How many, both ends included.
    pub points: usize,
}

/// The most positions.
pub const POSITIONS_LIMIT: usize = 1_000_000;

/// The number of positions where the case does not say.
pub const POSITIONS: usize = 1000;

/// The keys of the kind.
pub(super) const KEYS: &[&str] = &["configuration", "damping", "count", "positions", "at", "sweep"];

pub(super) fn read_locus(case: &SlidingCase, section: &Section<'_>) -> Result<Locus, Fault> {
    let configuration = section.choice("configuration", "configuration", &Configuration::ALL)?;
    Ok(Locus {
        configuration: configuration.unwrap_or(Configuration::Undeformed),
        damping: section.boolean("damping")?.unwrap_or(true),
        count: section.whole("count", 1, MODES_LIMIT)?.unwrap_or(MODES),
        along: read_along(case, section)?,
    })
}

fn read_along(case: &SlidingCase, section: &Section<'_>) -> Result<Along, Fault> {
    let Some(node) = section.get("sweep") else {
        if let Some(node) = section.get("at") {
            let problem =
                ContactProblem::Meaningless { key: "at", with: "`positions`, without `sweep`".to_owned() };
            return Err(Cause::Contact { problem }.at(node.place));
        }
        return read_positions(case, section).map(Along::Positions);
    };
    if let Some(node) = section.get("positions") {
        let (first, second) = ("sweep".to_owned(), "positions".to_owned());
        return Err(Cause::Contact { problem: ContactProblem::OneOfTwo { first, second } }.at(node.place));
    }
    let entry = SlidingKey::At.entry();
    let at = section.required("at", "at = \"74 mm\", where the contact is held while the key is swept")?;
    Ok(Along::Key { at: read_value(entry, "at", at)?.number, sweep: read_key_sweep(case, node)? })
}

/// Positions along the path of the motion, or a part of the track of the case's own.
fn read_positions(case: &SlidingCase, section: &Section<'_>) -> Result<Positions, Fault> {
    let path = [case.motion.start.min(case.motion.end), case.motion.start.max(case.motion.end)];
    let Some(node) = section.get("positions") else {
        return Ok(Positions { from: path[0], to: path[1], points: POSITIONS });
    };
    let table = section.table("positions", node, &["from", "to", "points"])?;
    let end = |key: SlidingKey, usual: f64| match table.get(key.entry().name()) {
        Some(_) => number(&table, key.entry()),
        None => Ok(usual),
    };
    let (from, to) = (end(SlidingKey::PositionsFrom, path[0])?, end(SlidingKey::PositionsTo, path[1])?);
    ascending(from, to, node)?;
    Ok(Positions { from, to, points: table.whole("points", 2, POSITIONS_LIMIT)?.unwrap_or(POSITIONS) })
}
