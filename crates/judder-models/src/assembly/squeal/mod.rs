//! `squeal`: the cycles of all modes of a band that grow, ranked by how loud they are.
//!
//! - `cycle`: the cycle of a mode. `run`, `told`: what is computed and told of all of them. `figure`, `tables`: how it is shown.

mod cycle;
mod figure;
mod run;
pub(super) mod tables;
mod told;

use super::AssemblySubject;
use super::eigen::BAND;
use super::limit_cycle::settings::CycleSolver;
use crate::assembly::case::AssemblyCase;
use crate::assembly::case::problem::AssemblyProblem;
use crate::error::ModelError;
use judder_keys::Settings;
use judder_keys::declared::Settings;
use judder_store::{Declared, Results};
use judder_study::case::analysis::{Kind, Picture};
use judder_study::model::{Analysis, Refusal, Task};
use judder_study::outcome::Outcome;
use judder_study::text::short;
use serde_json::{Map, Value as Json};
use std::f64::consts::TAU;
use std::sync::Arc;
use told::ToldSqueal;

/// The cycles of all modes that grow.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct AssemblySqueal {
    /// Between which frequencies modes are sought that grow, by less than half a radian a radian.
    #[key(rule = BAND, symbol = "ω")]
    pub band: [f64; 2],
    /// How their cycles are computed.
    #[key(flatten)]
    pub solver: CycleSolver,
}

/// The kind.
pub(crate) const KIND: Kind<Option<AssemblyCase>, Arc<dyn Analysis<AssemblyCase>>> = Kind {
    name: "squeal",
    doc: "the limit cycle of every mode of a band that grows, ranked by loudness and by growth rate",
    declared: AssemblySqueal::declarations,
    read: |_, section| Ok(Arc::new(AssemblySqueal::read_table(section)?)),
    picture: Some(Picture {
        draw: figure::squeal,
        caption: "How loud the limit cycle of each mode that grows is at the observed point that is loudest, and how fast the mode grows about steady sliding. No motion comes to an unstable \
        cycle. Modes of which no cycle was found have a growth rate alone.",
    }),
};

impl Analysis<AssemblyCase> for AssemblySqueal {
    fn fits(&self, of: &AssemblySubject<'_>) -> Result<Result<(), Refusal>, ModelError> {
        if let Err(refusal) = self.solver.fits(of)? {
            return Ok(Err(refusal));
        }
        let reason = "modes are ranked by the level of observed points: give the case [observe] points = [{ name, structure, set }]";
        Ok(match of.built.watched.is_empty() {
            true => Err(Refusal::key("", AssemblyProblem::Refused { reason: reason.to_owned() })),
            false => Ok(()),
        })
    }

    fn run(&self, of: &AssemblySubject<'_>, task: Task<'_>) -> Result<Outcome, ModelError> {
        run::run(of, self, task.progress)
    }

    fn summary_keys(&self) -> Vec<Declared> {
        ToldSqueal::declared()
    }

    fn estimate(&self, of: &AssemblySubject<'_>) -> Result<String, ModelError> {
        let points: usize = of.built.nodes.iter().map(Vec::len).sum();
        let [from, to] = self.band.map(|omega| short(omega / TAU));
        Ok(format!(
            "the limit cycles of the modes from {from} to {to} Hz that grow, with {points} contact points"
        ))
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.write_table(json);
    }
}
