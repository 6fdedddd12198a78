//! `limit-cycle`: the periodic motion that an unstable mode grows to.
//!
//! - [`settings`]: the keys. `start`: where no mode leads, `stored`: at the cycle of another study. `search`: the cycles of a mode, and in words why there is none. `stability`: whether motions nearby are drawn to one.
//! - `run`, `told`, `arrays`: what is computed, told and stored. `checks`: what is checked. `contributions`: of which modes a cycle is made up. `figure`, `tables`: how it is shown.

mod arrays;
pub(super) mod checks;
mod contributions;
mod figure;
mod run;
pub(super) mod search;
pub mod settings;
pub(super) mod stability;
pub mod start;
mod stored;
pub(super) mod tables;
pub(super) mod told;

use super::AssemblySubject;
use crate::assembly::case::AssemblyCase;
use crate::assembly::meant_mode::mode_near;
use crate::error::ModelError;
use judder_cycles::receptance::MOST_FREEDOMS;
use judder_cycles::stability::HILL_ROWS;
use judder_keys::declared::Settings;
use judder_keys::file_reference::FileReference;
use judder_store::Declared;
use judder_study::case::analysis::{Kind, Picture};
use judder_study::model::{Analysis, NeededMemory, Refusal, Task};
use judder_study::outcome::Outcome;
use serde_json::{Map, Value as Json};
use settings::{LOWEST, ModeCycle, admits_cycles};
use stability::multipliers_estimated;
use start::CycleStart;
use std::sync::Arc;

/// The kind.
pub(crate) const KIND: Kind<Option<AssemblyCase>, Arc<dyn Analysis<AssemblyCase>>> = Kind {
    name: "limit-cycle",
    doc: "the periodic motion through stick, slip and lift-off that a mode grows to, without a march",
    declared: ModeCycle::declarations,
    read: |case, section| Ok(Arc::new(ModeCycle::of(case.as_ref(), section)?)),
    picture: Some(Picture {
        draw: figure::limit_cycle,
        caption: "How fast the periodic motions of the mode would grow, over their amplitude: where that passes through zero is the limit cycle. Over one period of it forces of each contact, \
        what each contact point does, in the order of its points, and accelerations of the observed points; the portrait of the contact point that moves most; the modes of frictionless contact of which the cycle is made up, by their shares in the kinetic energy of its swing. The cycle is stable where all Floquet multipliers but the one at 1 lie within the unit circle.",
    }),
};

impl Analysis<AssemblyCase> for ModeCycle {
    fn most_freedoms(&self) -> Option<usize> {
        Some(MOST_FREEDOMS)
    }

    fn fits(&self, of: &AssemblySubject<'_>) -> Result<Result<(), Refusal>, ModelError> {
        match admits_cycles(of) {
            Ok(()) => self.start.as_ref().map_or(Ok(Ok(())), |start| start.fits(of)),
            Err(refusal) => Ok(Err(refusal)),
        }
    }

    fn memory(&self, of: &AssemblySubject<'_>) -> Result<NeededMemory, ModelError> {
        self.solver.size().memory(of)
    }

    fn files(&self) -> Vec<&FileReference> {
        self.start.iter().flat_map(CycleStart::files).collect()
    }

    fn admit(&self, of: &AssemblySubject<'_>) -> Result<(), ModelError> {
        of.admit_steady()
    }

    fn run(&self, of: &AssemblySubject<'_>, task: Task<'_>) -> Result<Outcome, ModelError> {
        run::run(of, self, task.progress)
    }

    fn summary_keys(&self) -> Vec<Declared> {
        told::summary_keys()
    }

    fn estimate(&self, of: &AssemblySubject<'_>) -> Result<String, ModelError> {
        let points: usize = of.built.nodes.iter().map(Vec::len).sum();
        let multipliers = multipliers_estimated(of, self.solver.stability, Some(HILL_ROWS));
        if let Some(start) = &self.start {
            let words = start.words();
            return Ok(format!("the limit cycle {words} with {points} contact points{multipliers}"));
        }
        let mode = match self.frequency {
            Some(frequency) => format!("the {}", mode_near(frequency)),
            None => format!("the fastest growing of the lowest {} modes", self.modes.unwrap_or(LOWEST)),
        };
        Ok(format!("the limit cycle of {mode} with {points} contact points{multipliers}"))
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.write_table(json);
    }
}
