//! `steady-sliding`: forces and gaps of all contact points under loads that rest.

mod faces;
mod figure;
mod filled;
mod run;
pub(super) mod tables;
mod uniqueness;

use super::AssemblySubject;
use super::linear_size::of_steady_sliding;
use crate::assembly::case::AssemblyCase;
use crate::error::ModelError;
use judder_keys::Settings;
use judder_keys::declared::Settings;
use judder_store::{Declared, Results};
use judder_study::case::analysis::{Kind, Picture};
use judder_study::model::{Analysis, NeededMemory, Refusal, Task};
use judder_study::outcome::Outcome;
use run::{SphereResults, SteadyResults};
use serde_json::{Map, Value as Json};
use std::sync::Arc;
use uniqueness::ToldUniqueness;

/// Steady sliding.
#[derive(Debug, Clone, Copy, PartialEq, Settings)]
pub struct SteadySlidingAnalysis {}

/// The kind.
pub(crate) const KIND: Kind<Option<AssemblyCase>, Arc<dyn Analysis<AssemblyCase>>> = Kind {
    name: "steady-sliding",
    doc: "steady sliding: forces, gaps, pressure, which contact points are closed",
    declared: SteadySlidingAnalysis::declarations,
    read: |_, section| Ok(Arc::new(SteadySlidingAnalysis::read_table(section)?)),
    picture: Some(Picture {
        draw: figure::steady_sliding,
        caption: "The contact points of each interface: what presses there, and where it is open; of surfaces in space the pressure on their faces, hatched where the surface does not reach. Then the bodies, and how steady sliding moves them, enlarged.",
    }),
};

impl Analysis<AssemblyCase> for SteadySlidingAnalysis {
    fn fits(&self, of: &AssemblySubject<'_>) -> Result<Result<(), Refusal>, ModelError> {
        Ok(of.touches().and_then(|()| of.slides()))
    }

    fn memory(&self, of: &AssemblySubject<'_>) -> Result<NeededMemory, ModelError> {
        Ok(of_steady_sliding(of))
    }

    fn admit(&self, of: &AssemblySubject<'_>) -> Result<(), ModelError> {
        of.admit_steady()
    }

    fn run(&self, of: &AssemblySubject<'_>, _: Task<'_>) -> Result<Outcome, ModelError> {
        run::run(of)
    }

    fn summary_keys(&self) -> Vec<Declared> {
        [SteadyResults::declared(), ToldUniqueness::declared(), Option::<SphereResults>::declared()].concat()
    }

    fn estimate(&self, of: &AssemblySubject<'_>) -> Result<String, ModelError> {
        let points: usize = of.built.nodes.iter().map(Vec::len).sum();
        Ok(format!("steady sliding of {points} contact points"))
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.write_table(json);
    }
}
