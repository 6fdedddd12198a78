//! `squeal`: the cycles of all modes of a band that grow, ranked by how loud they are.
//!
//! - [`settings`]: the keys. `cycle`: the cycle of a mode. `margin`, `known_margin`, `margin_told`: how far beyond its onset cycles reach, `margin_stability`: whether motions are drawn to them. `knocks`: what becomes of impulses, `small_motions`: by what that is told.
//!   `cures`: what the growth rate follows, `at_change`: the modes with a number changed as far as a cure asks. `run`, `told`: what is computed and told of all of them. `figure`, `tables`: how it is shown.

mod at_change;
mod cures;
mod cycle;
mod figure;
mod knocks;
mod known_margin;
mod margin;
mod margin_stability;
mod margin_told;
mod run;
pub mod settings;
mod small_motions;
pub(super) mod tables;
mod told;

use super::AssemblySubject;
use crate::assembly::case::AssemblyCase;
use crate::assembly::case::problem::AssemblyProblem;
use crate::assembly::limit_cycle::settings::admits_cycles;
use crate::assembly::limit_cycle::stability::multipliers_estimated;
use crate::assembly::periodic::PeriodicSize;
use crate::error::ModelError;
use crate::key_unit::{in_unit, unit_of_any};
use cures::cures_estimated;
use judder_cycles::fold::FOLD_REFINEMENT;
use judder_cycles::receptance::MOST_FREEDOMS;
use judder_cycles::stability::HILL_ROWS;
use judder_keys::declared::Settings;
use judder_store::{Declared, Results};
use judder_study::case::analysis::{Kind, Picture};
use judder_study::model::{Analysis, NeededMemory, Refusal, Task};
use judder_study::outcome::Outcome;
use judder_study::text::short;
use margin_stability::LOOKED_AT;
use serde_json::{Map, Value as Json};
use settings::AssemblySqueal;
use std::f64::consts::TAU;
use std::sync::Arc;
use told::ToldSqueal;

/// The kind.
pub(crate) const KIND: Kind<Option<AssemblyCase>, Arc<dyn Analysis<AssemblyCase>>> = Kind {
    name: "squeal",
    doc: "the limit cycle of every mode of a band that grows, ranked by loudness and by growth rate",
    declared: AssemblySqueal::declarations,
    read: |case, section| Ok(Arc::new(AssemblySqueal::of(case.as_ref(), section)?)),
    picture: Some(Picture {
        draw: figure::squeal,
        caption: "Modes that grow about steady sliding, and the limit cycles to which they grow: each panel answers what stands above it. No motion comes to an unstable cycle, and of a mode of \
        which no cycle was found the growth alone is known.",
    }),
};

impl Analysis<AssemblyCase> for AssemblySqueal {
    fn most_freedoms(&self) -> Option<usize> {
        Some(MOST_FREEDOMS)
    }

    fn fits(&self, of: &AssemblySubject<'_>) -> Result<Result<(), Refusal>, ModelError> {
        if let Err(refusal) = admits_cycles(of) {
            return Ok(Err(refusal));
        }
        if let Some(knocks) = &self.knocks {
            let names: Vec<&str> = of.built.watched.iter().map(|own| own.name.as_str()).collect();
            if !names.is_empty() && !names.contains(&knocks.at.as_str()) {
                let reason =
                    format!("there is no observed point `{}`: there are {}", knocks.at, names.join(", "));
                return Ok(Err(Refusal::key("knocks", AssemblyProblem::Refused { reason })));
            }
        }
        let reason = "modes are ranked by the level of observed points: give the case [observe] points = [{ name, structure, set }]";
        Ok(match of.built.watched.is_empty() {
            true => Err(Refusal::key("", AssemblyProblem::Refused { reason: reason.to_owned() })),
            false => Ok(()),
        })
    }

    fn memory(&self, of: &AssemblySubject<'_>) -> Result<NeededMemory, ModelError> {
        let of_modes = self.solver.size().memory(of)?;
        if self.margin_sweep().is_none() {
            return Ok(of_modes);
        }
        let harmonics = Some(self.margin_harmonics());
        let branch = PeriodicSize { harmonics, folds: true, ..self.solver.size() }.memory(of)?;
        let keys: &'static [&'static str] = &["margin_harmonics", "margin"];
        let branch = NeededMemory { keys, ..branch };
        Ok(if branch.beside > of_modes.beside { branch } else { of_modes })
    }

    fn run(&self, of: &AssemblySubject<'_>, task: Task<'_>) -> Result<Outcome, ModelError> {
        run::run(of, self, task.own, task.progress)
    }

    fn summary_keys(&self) -> Vec<Declared> {
        let of_key = ["own", "onset", "onset_error", "fold", "fold_error", "reaches", "looked_at"];
        let unit = self.margin_sweep().map(unit_of_any).unwrap_or_default();
        in_unit(ToldSqueal::declared(), &unit, &of_key)
    }

    fn estimate(&self, of: &AssemblySubject<'_>) -> Result<String, ModelError> {
        let points: usize = of.built.nodes.iter().map(Vec::len).sum();
        let [from, to] = self.band.map(|omega| short(omega / TAU));
        let margins = self.margin_sweep().map_or_else(String::new, |sweep| {
            let (path, values) = (&sweep.path, sweep.values.len());
            let harmonics = self.margin_harmonics();
            let more = FOLD_REFINEMENT * harmonics;
            let looked_at = match self.solver.stability {
                true => format!(", multipliers of up to {} of its cycles", 2 * LOOKED_AT),
                false => String::new(),
            };
            format!(
                "; modes at {values} values of {path}, and a branch of cycles with {harmonics} harmonics from each onset, its fold once more with {more}{looked_at}"
            )
        });
        let knocks = self.knocks.as_ref().map_or_else(String::new, |own| {
            let steps = (own.duration / own.step).ceil();
            format!("; {} knocks of {steps} steps each", own.samples)
        });
        let cures = self.cures.as_ref().filter(|own| own.asks());
        let cures = cures.map_or_else(String::new, |own| cures_estimated(of, own));
        let multipliers = multipliers_estimated(of, self.solver.stability, Some(HILL_ROWS));
        Ok(format!(
            "the limit cycles of the modes from {from} to {to} Hz that grow, with {points} contact points{multipliers}{margins}{knocks}{cures}"
        ))
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.write_table(json);
    }
}
