//! `march`: the motion through stick, slip and lift-off at every contact point.

pub(super) mod arrays;
#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod beams;
mod blocks;
mod content;
pub mod driven;
pub mod field;
pub(super) mod figure;
pub(super) mod levels;
pub(super) mod recorded;
mod run;
pub mod settings;
pub(super) mod size;
pub(super) mod start;
pub(super) mod tables;
mod told;

use super::AssemblySubject;
use super::linear_size::of_motion;
use crate::assembly::build::TrackEnd;
use crate::assembly::case::AssemblyCase;
use crate::assembly::case::problem::AssemblyProblem;
use crate::error::ModelError;
use driven::MotionDrive;
use judder_keys::declared::Settings;
use judder_keys::file_reference::FileReference;
use judder_numerics::words::plain;
use judder_store::{Declared, Results};
use judder_study::case::analysis::{Kind, Picture};
use judder_study::model::{Analysis, NeededMemory, Refusal, Task};
use judder_study::outcome::Outcome;
use serde_json::{Map, Value as Json};
use settings::AssemblyMarch;
pub(super) use size::MarchedSize;
use std::sync::Arc;
use told::ToldAssemblyMotion;

/// The kind.
pub(crate) const KIND: Kind<Option<AssemblyCase>, Arc<dyn Analysis<AssemblyCase>>> = Kind {
    name: "march",
    doc: "the motion through stick, slip and lift-off at every contact point, with its balance of energy",
    declared: AssemblyMarch::declarations,
    read: |case, section| Ok(Arc::new(AssemblyMarch::of(case.as_ref(), section)?)),
    picture: Some(Picture {
        draw: figure::march,
        caption: "Forces of each contact over time: each line fills the space between the smallest and the largest sample of a column. What each contact point does, \
        in the order of its points, over the whole motion and at its end. Accelerations of the observed points, and their levels in octaves after the transient; what the signal does not tell is left out.",
    }),
};

impl Analysis<AssemblyCase> for AssemblyMarch {
    fn fits(&self, of: &AssemblySubject<'_>) -> Result<Result<(), Refusal>, ModelError> {
        let drive = match MotionDrive::new(of, self) {
            Ok(drive) => drive,
            Err(undriven) => return undriven.refusal().map(Err),
        };
        // at full speed
        let [back, ahead] = drive.course.speed.integral().extent(self.duration);
        let left = |TrackEnd { contact, ways, speed }: TrackEnd| {
            [-back, ahead]
                .into_iter()
                .zip(ways)
                .find(|(time, way)| speed * time > *way)
                .map(|(_, way)| (contact, way, speed))
        };
        let Some((contact, way, speed)) = of.built.track_ends().find_map(left) else {
            return Ok(Ok(()));
        };
        let after = match drive.course.speed.is_one() {
            true => format!(", after {} s", plain(way / speed)),
            false => String::new(),
        };
        let reason = format!(
            "the contact `{}` travels {} m and then runs off its track{after}: shorten the duration, or begin farther from that end",
            of.case.contacts[contact].name,
            plain(way.max(0.0)),
        );
        Ok(Err(Refusal::key("duration", AssemblyProblem::Refused { reason })))
    }

    fn memory(&self, of: &AssemblySubject<'_>) -> Result<NeededMemory, ModelError> {
        Ok(of_motion(of, MarchedSize::new(of, self).memory()))
    }

    fn files(&self) -> Vec<&FileReference> {
        self.driven.files()
    }

    fn run(&self, of: &AssemblySubject<'_>, task: Task<'_>) -> Result<Outcome, ModelError> {
        run::run(of, self, task)
    }

    fn summary_keys(&self) -> Vec<Declared> {
        ToldAssemblyMotion::declared()
    }

    fn estimate(&self, of: &AssemblySubject<'_>) -> Result<String, ModelError> {
        let points: usize = of.built.nodes.iter().map(Vec::len).sum();
        let [steps, _] = self.steps();
        Ok(format!("{steps} steps with {points} contact points"))
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.write_table(json);
    }
}
