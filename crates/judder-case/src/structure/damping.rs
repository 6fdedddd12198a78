//! `[damping]`: the damping of a body.

use super::lists::quantity;
use super::problem::StructureProblem;
use crate::cause::Cause;
use crate::document::Node;
use crate::error::Fault;
use crate::section::{Section, list};
use crate::structure_keys::StructureKey;

/// The damping of a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Damping {
    /// C = 0.
    None,
    /// C = α M + β K.
    Rayleigh {
        /// α, 1/s.
        alpha: f64,
        /// β, s.
        beta: f64,
    },
    /// C = η K/ω_r, which meets structural damping K (1 + iη) at one frequency.
    Structural {
        /// η.
        loss_factor: f64,
        /// ω_r, rad/s.
        reference_frequency: f64,
    },
}

/// The keys of a damping.
pub(crate) const KEYS: [&str; 2] = ["rayleigh", "structural"];

/// Reads the damping that `section` describes.
pub(crate) fn read_damping(section: &Section<'_>) -> Result<Damping, Fault> {
    match (section.get("rayleigh"), section.get("structural")) {
        (None, None) => Ok(Damping::None),
        (Some(_), Some(node)) => {
            let (first, second) = (section.path("rayleigh"), section.path("structural"));
            Err(Cause::Conflict { first, second }.at(node.place))
        }
        (Some(node), None) => read_rayleigh(section, node),
        (None, Some(node)) => {
            let table = section.table("structural", node, &["loss_factor", "reference_frequency"])?;
            Ok(Damping::Structural {
                loss_factor: quantity(&table, StructureKey::LossFactor)?,
                reference_frequency: quantity(&table, StructureKey::ReferenceFrequency)?,
            })
        }
    }
}

/// α and β, given or from two damping ratios ζ = α/(2ω) + βω/2.
fn read_rayleigh(section: &Section<'_>, node: &Node) -> Result<Damping, Fault> {
    let table = section.table("rayleigh", node, &["alpha", "beta", "ratios"])?;
    let Some(node) = table.get("ratios") else {
        return Ok(Damping::Rayleigh {
            alpha: quantity(&table, StructureKey::MassProportional)?,
            beta: quantity(&table, StructureKey::StiffnessProportional)?,
        });
    };
    for key in ["alpha", "beta"] {
        if table.get(key).is_some() {
            return Err(
                Cause::Conflict { first: table.path(key), second: table.path("ratios") }.at(node.place)
            );
        }
    }
    let nodes = list(&table.path("ratios"), node)?;
    let [first, second] = nodes else {
        let (key, expected, found) = (table.path("ratios"), "two pairs of frequency and ratio", nodes.len());
        return Err(StructureProblem::Length { key, expected, found }.at(node.place));
    };
    let path = table.path("ratios");
    let mut pairs = [read_pair(&path, first)?, read_pair(&path, second)?];
    pairs.sort_by(|a, b| a.0.total_cmp(&b.0));
    let [(first_frequency, first), (second_frequency, second)] = pairs;
    if first_frequency == second_frequency {
        return Err(Cause::EmptyRange { from: first_frequency }.at(node.place));
    }
    // from ζ₁ = α/(2ω₁) + βω₁/2 and ζ₂ = α/(2ω₂) + βω₂/2
    let spread = (second_frequency - first_frequency) * (second_frequency + first_frequency);
    let alpha =
        2.0 * first_frequency * second_frequency * (first * second_frequency - second * first_frequency)
            / spread;
    let beta = 2.0 * (second * second_frequency - first * first_frequency) / spread;
    if alpha >= 0.0 && beta >= 0.0 {
        return Ok(Damping::Rayleigh { alpha, beta });
    }
    Err(StructureProblem::NegativeDamping { first, first_frequency, second, second_frequency }.at(node.place))
}

fn read_pair(path: &str, node: &Node) -> Result<(f64, f64), Fault> {
    let table = Section::open(node, path, &format!("an entry of `{path}`"), &["frequency", "ratio"])?;
    Ok((quantity(&table, StructureKey::RatioFrequency)?, quantity(&table, StructureKey::Ratio)?))
}
