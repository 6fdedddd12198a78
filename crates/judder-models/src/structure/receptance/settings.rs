//! What a case says of a receptance.

use crate::structure::case::reduction::KeptNodes;
use crate::structure::case::scope::StructureScope;
use crate::structure::modes::BAND;
use judder_keys::Settings;
use judder_keys::declared::{Settings, Whole, both};
use judder_keys::error::Fault;
use judder_keys::problem::Problem;
use judder_keys::section::Section;
use judder_structure::freedom::Direction;
use thiserror::Error;

/// The receptance between two points: the displacement of one by a unit force at the other.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct ReceptanceAnalysis {
    /// Where the force acts.
    #[key(
        example = "{ set = \"end-upper\", direction = \"y\" }, of matrices { nodes = [17], direction = \"y\" }"
    )]
    pub excited: FreedomPlace,
    /// Where the displacement is told.
    #[key(
        example = "{ set = \"end-upper\", direction = \"y\" }, of matrices { nodes = [17], direction = \"y\" }"
    )]
    pub observed: FreedomPlace,
    /// Frequencies, from and to.
    #[key(rule = BAND, symbol = "ω", example = "[\"10 Hz\", \"5 kHz\"], from and to")]
    pub band: [f64; 2],
    /// How many frequencies, evenly spaced, both ends included.
    #[key(rule = Whole { from: 2, to: 100_000 }, default = 1000)]
    pub points: usize,
}

/// A degree of freedom of a structure.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct FreedomPlace {
    /// The node: all nodes that are named must have one degree of freedom in common.
    #[key(flatten)]
    pub nodes: KeptNodes,
    /// The direction.
    pub direction: Direction,
}

impl ReceptanceAnalysis {
    /// Reads it, of nodes as the structure has them.
    pub(super) fn read(scope: &StructureScope, section: &Section<'_>) -> Result<Self, Fault> {
        let ((), settings) = both(scope.check_factors(section), Self::read_table(section))?;
        let admitted = |key: &str| match (section.inner(key)?, &scope.source) {
            (Some(place), Some(source)) => KeptNodes::admit(&place, source),
            _ => Ok(()),
        };
        both(admitted("excited"), admitted("observed")).map(|_| settings)
    }

    /// Its angular frequencies, rad/s.
    pub(super) fn frequencies(&self) -> Vec<f64> {
        let ([from, to], last) = (self.band, self.points.saturating_sub(1).max(1));
        (0..self.points).map(|k| from + (to - from) * k as f64 / last as f64).collect()
    }
}

/// A place that is no single degree of freedom.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("`{key}` names {found} degrees of freedom along {along}, but must name one")]
pub struct NotOneFreedom {
    /// The key.
    pub key: &'static str,
    /// The direction.
    pub along: Direction,
    /// How many there are.
    pub found: usize,
}

impl Problem for NotOneFreedom {
    fn kind(&self) -> &'static str {
        "Structure"
    }

    fn label(&self) -> &'static str {
        "not one"
    }

    fn help(&self) -> Option<String> {
        let help = match self.found {
            0 => "name a node and a direction that are free",
            _ => {
                "name one node: of a beam, `end-upper` or another corner is a set of one node; of matrices, nodes = [17]"
            }
        };
        Some(help.to_owned())
    }
}
