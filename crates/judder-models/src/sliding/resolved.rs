//! The sliding case.

use serde_json::{Value as Json, json};

use crate::sliding::case::SlidingCase;
use crate::sliding::case::structure::SlidingStructure;
use crate::structure::case::StructureSource;
use crate::structure::resolved::{body, matrices, parameters};
use judder_keys::declared::Setting;
use judder_study::case::resolved::analyses;

pub(super) fn case(case: &SlidingCase) -> Json {
    json!({
        "model": "sliding",
        "title": case.title,
        "parameters": parameters(&case.parameters),
        "structure": case.structures.iter().map(structure).collect::<Vec<_>>(),
        "contact": Setting::write(&case.contact, &()),
        "motion": Setting::write(&case.motion, &()),
        "observe": { "points": case.points.iter().map(|point| point.write(&())).collect::<Vec<_>>() },
        "analysis": analyses(&case.analyses, |kind, json| kind.write(json)),
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
