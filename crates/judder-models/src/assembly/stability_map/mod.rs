//! `stability-map`: where steady sliding is stable over two keys.

mod figure;
mod kept_point;
mod point;
mod run;

use super::AssemblySubject;
use super::linear_size::of_sweep;
use super::swept::{SWEPT, SoughtRegion};
use crate::assembly::case::AssemblyCase;
use crate::assembly::case::problem::AssemblyProblem;
use crate::error::ModelError;
use crate::key_sweep::KeySweep;
use judder_keys::Settings;
use judder_keys::declared::{Settings, both};
use judder_keys::problem::Placed;
use judder_store::{Declared, Results};
use judder_study::case::analysis::{Kind, Picture};
use judder_study::model::{Analysis, NeededMemory, Task};
use judder_study::outcome::Outcome;
use run::ToldMap;
use serde_json::{Map, Value as Json};
use std::sync::Arc;

/// Stability of steady sliding over two keys.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct AssemblyMap {
    /// What varies across: any number of `structure`, `contact`, `spring`, `load` or `parameters`; each point is a case of its own.
    #[key(rule = SWEPT, example = "…, `{ key, from, to, points, scale }`, or `{ key, values }`")]
    pub x: KeySweep,
    /// What varies upwards.
    #[key(rule = SWEPT, example = "…, `{ key, from, to, points, scale }`, or `{ key, values }`")]
    pub y: KeySweep,
    /// Where modes are sought.
    #[key(flatten)]
    pub sought: SoughtRegion,
    /// Whether structures are damped, and friction follows the velocity.
    #[key(default = true)]
    pub damping: bool,
    /// Whether the boundary of stability is located between neighbouring points.
    #[key(default = true)]
    pub boundaries: bool,
}

/// The most points of a map: each is a case of its own.
const MOST_POINTS: usize = 1_000_000;

impl AssemblyMap {
    /// Refuses one key for both axes, and more points than memory and patience hold.
    fn check(&self) -> Result<(), String> {
        if self.x.path == self.y.path {
            return Err(format!("`x` and `y` both vary `{}`: a map has two keys", self.x.path));
        }
        let points = self.x.values.len() * self.y.values.len();
        if points > MOST_POINTS {
            return Err(format!(
                "this map has {points} points, and {MOST_POINTS} are allowed: take fewer a side"
            ));
        }
        Ok(())
    }
}

/// The kind.
pub(crate) const KIND: Kind<Option<AssemblyCase>, Arc<dyn Analysis<AssemblyCase>>> = Kind {
    name: "stability-map",
    doc: "where steady sliding is stable over two keys, and what feeds the fastest growing mode",
    declared: AssemblyMap::declarations,
    read: |case, section| {
        let own = AssemblyMap::read_table(section)?;
        own.check().map_err(|reason| AssemblyProblem::Refused { reason }.at(section.place))?;
        if let Some(case) = case {
            let admitted = |key: &str, sweep: &KeySweep| match section.get(key) {
                Some(node) => sweep.admit(node, |value| case.at(&[(sweep, value)])),
                None => Ok(()),
            };
            both(admitted("x", &own.x), admitted("y", &own.y))?;
        }
        Ok(Arc::new(own))
    },
    picture: Some(Picture {
        draw: figure::stability_map,
        caption: "Stability of steady sliding, coloured by what feeds the fastest growing mode of the region most. Points of the boundary are located by roots \
        between neighbouring points of the map.",
    }),
};

impl Analysis<AssemblyCase> for AssemblyMap {
    fn steps(&self) -> usize {
        self.x.values.len() * self.y.values.len()
    }

    fn memory(&self, of: &AssemblySubject<'_>) -> Result<NeededMemory, ModelError> {
        Ok(of_sweep(of, self.steps(), &["x"]))
    }

    fn run(&self, of: &AssemblySubject<'_>, task: Task<'_>) -> Result<Outcome, ModelError> {
        run::run(of, self, task.own, task.progress)
    }

    fn summary_keys(&self) -> Vec<Declared> {
        ToldMap::declared()
    }

    fn estimate(&self, _: &AssemblySubject<'_>) -> Result<String, ModelError> {
        let (columns, rows) = (self.x.values.len(), self.y.values.len());
        Ok(format!("stability at {columns} values of {} times {rows} of {}", self.x.path, self.y.path))
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.write_table(json);
    }
}
