//! `eigen`: complex modes in a region of the plane.

mod diagnosis;
pub(crate) mod figure;
pub(crate) mod run;
pub(crate) mod tables;

use super::{StructureSubject, solved_size};
use crate::error::ModelError;
use crate::structure::case::StructureCase;
use crate::structure::case::scope::StructureScope;
use judder_keys::Settings;
use judder_keys::declared::{Settings, both};
use judder_store::{Declared, Results};
use judder_structure::asked_region::AskedRegion;
use judder_study::case::analysis::{Kind, Picture};
use judder_study::model::{Analysis, NeededMemory, Task};
use judder_study::outcome::Outcome;
use judder_study::text::short;
pub(crate) use run::ToldRegion;
use serde_json::{Map, Value as Json};
use std::f64::consts::TAU;
use std::sync::Arc;

/// Complex modes.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct EigenAnalysis {
    /// Which eigenvalues λ = re + i im are asked for: those of a rectangle, or of frequencies with damping ratios.
    #[key(
        example = "{ frequency = [\"0 Hz\", \"8 kHz\"], damping_ratio = [-0.1, 0.1] }, or { re = […], im = […] } in 1/s and rad/s"
    )]
    pub region: AskedRegion,
}

/// The kind.
pub(crate) const KIND: Kind<StructureScope, Arc<dyn Analysis<StructureCase>>> = Kind {
    name: "eigen",
    doc: "all complex modes in a region of the plane of growth rate and frequency, each with its error",
    declared: EigenAnalysis::declarations,
    read: |scope, section| {
        let ((), own) = both(scope.check_factors(section), EigenAnalysis::read_table(section))?;
        Ok(Arc::new(own))
    },
    picture: Some(Picture {
        draw: figure::eigen,
        caption: "All eigenvalues found in the region; the axis of growth rates is logarithmic on both sides of zero. Damping ratios $ζ = −$Re $λ/|λ|$: a \
        bubble's area is their magnitude. Shapes of the fastest growing modes, which swing on the page, and how alike any two shapes are.",
    }),
};

/// Where eigenvalues are sought, in words.
pub(crate) fn within(asked: &AskedRegion) -> String {
    match *asked {
        AskedRegion::Rectangle { re: [from, to], im: [low, high] } => {
            format!("Re from {from} to {to}, Im from {low} to {high}")
        }
        AskedRegion::Ratios { frequency, damping_ratio: [from, to] } => {
            let [low, high] = frequency.map(|omega| short(omega / TAU));
            format!("from {low} to {high} Hz, damping ratios from {from} to {to}")
        }
    }
}

impl Analysis<StructureCase> for EigenAnalysis {
    fn run(&self, of: &StructureSubject<'_>, _: Task<'_>) -> Result<Outcome, ModelError> {
        run::run(of.case, of.structure, of.name, &self.region)
    }

    fn summary_keys(&self) -> Vec<Declared> {
        ToldRegion::declared()
    }

    fn memory(&self, of: &StructureSubject<'_>) -> Result<NeededMemory, ModelError> {
        Ok(solved_size::complex_modes(of.structure))
    }

    fn estimate(&self, _: &StructureSubject<'_>) -> Result<String, ModelError> {
        Ok(format!("complex modes, {}", within(&self.region)))
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.write_table(json);
    }
}
