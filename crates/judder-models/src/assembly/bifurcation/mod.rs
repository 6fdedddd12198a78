//! `bifurcation`: limit cycles of a mode along any key, through folds, to where they shrink to steady sliding.
//!
//! - `run`: the first cycle, the branch through it both ways. `named`: its bifurcations, by name. `told`: what is told and stored of it. `figure`, `tables`: how it is shown.

mod figure;
mod named;
mod run;
pub(super) mod tables;
mod told;

use super::AssemblySubject;
use super::limit_cycle::settings::{LOWEST, MODES, admits_cycles, no_mode_is_meant};
use super::limit_cycle::stability::multipliers_estimated;
use super::limit_cycle::start::CycleStart;
use super::periodic::PeriodicSize;
use super::swept::SWEPT;
use crate::assembly::case::AssemblyCase;
use crate::error::ModelError;
use crate::key_sweep::KeySweep;
use crate::key_unit::{in_unit, unit_of_any};
use judder_cycles::fold::FOLD_REFINEMENT;
use judder_cycles::receptance::MOST_FREEDOMS;
use judder_keys::Settings;
use judder_keys::declared::{Number, Settings, Whole};
use judder_keys::dimension::Dimension;
use judder_keys::error::Fault;
use judder_keys::file_reference::FileReference;
use judder_keys::section::Section;
use judder_store::{Declared, Results};
use judder_study::case::analysis::{Kind, Picture};
use judder_study::model::{Analysis, NeededMemory, Refusal, Task};
use judder_study::outcome::Outcome;
use serde_json::{Map, Value as Json};
use std::sync::Arc;
use told::ToldCycleBranch;

/// Limit cycles along a key.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(check = CycleDiagram::check)]
pub struct CycleDiagram {
    /// Any number of `structure`, `contact`, `spring`, `load` or `parameters` over a range; the more values it has, the shorter the steps along the branch, which are even in the key's logarithm where its `scale` is `log`.
    #[key(rule = SWEPT, example = "…, `{ key, from, to, points, scale }`, or `{ key, values }`")]
    pub sweep: KeySweep,
    /// Frequency near which the mode lies; where left out, the fastest growing of the lowest modes is meant.
    #[key(rule = Number::positive(Dimension::ANGULAR_FREQUENCY), symbol = "ω", omitted)]
    pub frequency: Option<f64>,
    /// Where no frequency is given: how many of the lowest modes there are to choose from.
    #[key(rule = MODES, usual = LOWEST, omitted)]
    pub modes: Option<usize>,
    /// Where the first cycle is sought in place of along the motions of a mode: on a branch that no mode leads to as well.
    #[key(omitted)]
    pub start: Option<CycleStart>,
    /// How many harmonics the cycles have.
    #[key(rule = HARMONICS, symbol = "H", default = 9)]
    pub harmonics: usize,
    /// Instants of a period a harmonic at which points stick, slide or lift off.
    #[key(rule = SAMPLES, default = 16)]
    pub samples: usize,
    /// The most cycles each way from the first.
    #[key(rule = CYCLES, default = 300)]
    pub cycles: usize,
    /// Whether Floquet multipliers say of each cycle if motions nearby are drawn to it.
    #[key(default = true)]
    pub stability: bool,
}

const HARMONICS: Whole = Whole { from: 1, to: 500 };
const SAMPLES: Whole = Whole { from: 4, to: 1024 };
const CYCLES: Whole = Whole { from: 2, to: 10_000 };

impl CycleDiagram {
    fn check(&mut self, section: &Section<'_>) -> Result<(), Fault> {
        no_mode_is_meant(section, self.start.as_ref())
    }
}

/// The kind.
pub(crate) const KIND: Kind<Option<AssemblyCase>, Arc<dyn Analysis<AssemblyCase>>> = Kind {
    name: "bifurcation",
    doc: "limit cycles of a mode along any key, stable or not, through folds to where they shrink to steady sliding",
    declared: CycleDiagram::declarations,
    read: |case, section| {
        let mut own = CycleDiagram::read_table(section)?;
        own.start.as_mut().map_or(Ok(()), |start| start.find(section, case.as_ref()))?;
        if let (Some(case), Some(node)) = (case, section.get("sweep")) {
            own.sweep.admit(node, |value| case.at(&[(&own.sweep, value)]))?;
            own.sweep.admit_between(node, |value| case.at(&[(&own.sweep, value)]))?;
        }
        Ok(Arc::new(own))
    },
    picture: Some(Picture {
        draw: figure::bifurcation,
        caption: "Limit cycles along the key, by the root mean square of the velocities of the contact points along the slip, and their frequencies: stable ones solid, unstable ones dashed, as their Floquet multipliers say. \
        Marked are its bifurcations, by name; a change of stability of which the multipliers do not say how is called unknown. Where a branch shrinks to nothing steady sliding becomes unstable; where it folds, the cycle that motions are drawn to ends.",
    }),
};

impl Analysis<AssemblyCase> for CycleDiagram {
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
        let size = PeriodicSize {
            harmonics: Some(self.harmonics),
            samples: self.samples,
            stability: self.stability,
            folds: true,
        };
        size.memory(of)
    }

    fn files(&self) -> Vec<&FileReference> {
        self.start.iter().flat_map(CycleStart::files).collect()
    }

    fn run(&self, of: &AssemblySubject<'_>, task: Task<'_>) -> Result<Outcome, ModelError> {
        run::run(of, self, task.progress)
    }

    fn summary_keys(&self) -> Vec<Declared> {
        let of_key = ["value", "folds", "hopf_points", "error", "between"];
        in_unit(ToldCycleBranch::declared(), &unit_of_any(&self.sweep), &of_key)
    }

    fn estimate(&self, of: &AssemblySubject<'_>) -> Result<String, ModelError> {
        let path = &self.sweep.path;
        let harmonics = self.harmonics;
        let multipliers = match multipliers_estimated(of, self.stability, None) {
            words if words.is_empty() => words,
            words => format!("{words}, for each of up to {} cycles", 2 * self.cycles),
        };
        Ok(format!(
            "limit cycles along {path} with {harmonics} harmonics, and each of its folds once more with {}{multipliers}",
            FOLD_REFINEMENT * harmonics
        ))
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.write_table(json);
    }
}
