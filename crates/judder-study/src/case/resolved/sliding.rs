//! The sliding case.

use serde_json::{Value as Json, json};

use super::structure::{body, matrices, parameters};
use super::{declared, named};
use crate::models::sliding::case::SlidingCase;
use crate::models::sliding::case::analysis::SlidingAnalysis;
use crate::models::sliding::case::march::MarchWord;
use crate::models::sliding::case::structure::SlidingStructure;
use crate::models::structure::case::StructureSource;
use judder_keys::declared::Setting;

pub(super) fn case(case: &SlidingCase) -> Json {
    json!({
        "model": "sliding",
        "title": case.title,
        "parameters": parameters(&case.parameters),
        "structure": case.structures.iter().map(structure).collect::<Vec<_>>(),
        "contact": Setting::write(&case.contact, &()),
        "motion": Setting::write(&case.motion, &()),
        "observe": { "points": case.points.iter().map(|point| point.write(&())).collect::<Vec<_>>() },
        "analysis": case.analyses.iter().map(|own| named(own, analysis)).collect::<Vec<_>>(),
    })
}

fn structure(structure: &SlidingStructure) -> Json {
    let mut json = match &structure.source {
        StructureSource::Body(source) => {
            let mut json = body(source);
            json["damping"] = Setting::write(&structure.damping, &());
            json
        }
        StructureSource::Matrices(sums) => json!({ "matrices": matrices(sums) }),
    };
    json["name"] = json!(*structure.name);
    json["reduction"] = Setting::write(&structure.reduction, &());
    json
}

fn analysis(kind: &SlidingAnalysis) -> Json {
    match kind {
        SlidingAnalysis::Modes(settings) => declared("modes", settings),
        SlidingAnalysis::Locus(settings) => declared("locus", settings),
        SlidingAnalysis::March(settings) => declared("march", settings),
        SlidingAnalysis::Spectrogram(settings) => declared("spectrogram", settings),
        SlidingAnalysis::Growth(settings) => {
            let mut json = declared("growth", settings);
            // what a march by this method has besides
            if settings.word == MarchWord::Subs {
                json["slope"] = json!("none");
            }
            json
        }
    }
}
