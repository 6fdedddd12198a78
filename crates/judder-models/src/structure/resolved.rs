//! The structure case.

use serde_json::{Map, Value as Json, json};

use crate::parameters::Parameter;
use crate::structure::case::body::{Body, Geometry, Material, PlaneSection};
use crate::structure::case::matrices::{MatrixSums, MatrixTerm};
use crate::structure::case::{StructureCase, StructureSource};
use judder_keys::declared::Setting;
use judder_keys::dimension::Dimension;
use judder_keys::numeric_key::Form;
use judder_study::case::resolved::{analyses, number};

pub(crate) fn case(case: &StructureCase) -> Json {
    let mut json = json!({
        "model": "structure",
        "title": case.title,
        "analysis": analyses(&case.analyses, |kind, json| kind.write(json)),
    });
    match &case.source {
        StructureSource::Body(source) => {
            json["structure"] = body(source);
            json["damping"] = Setting::write(&case.damping, &());
        }
        StructureSource::Matrices(sums) => {
            json["parameters"] = parameters(&case.parameters);
            json["matrices"] = matrices(sums);
        }
    }
    if let Some(kept) = &case.reduction {
        json["reduction"] = Setting::write(kept, &());
    }
    json
}

pub(crate) fn parameters(parameters: &[Parameter]) -> Json {
    parameters.iter().map(|parameter| json!([parameter.name, parameter.value])).collect()
}

pub(crate) fn si(value: f64, dimension: Dimension) -> Json {
    number(value, Form::Si, dimension)
}

pub(crate) fn body(body: &Body) -> Json {
    let material = |material: &Material| Setting::write(material, &());
    let mut json = json!({
        "material": body.material.as_ref().map(material),
        "materials": body.materials.iter().map(|(name, own)| (name.clone(), material(own))).collect::<Map<_, _>>(),
        "supports": body.supports.iter().map(|support| Setting::write(support, &())).collect::<Vec<_>>(),
    });
    let mut in_space = false;
    match &body.geometry {
        Geometry::Beam(beam) => json["beam"] = Setting::write(beam, &()),
        Geometry::Block(block) => {
            in_space = block.element().dimension() == 3;
            json["block"] = Setting::write(block, &());
        }
        Geometry::Mesh(file) => json["mesh"] = json!(file.given),
    }
    if !in_space {
        json["section"] = json!(body.section.map(PlaneSection::name));
        json["width"] = body.width.map_or(Json::Null, |width| si(width, Dimension::LENGTH));
    }
    json
}

pub(crate) fn matrices(sums: &MatrixSums) -> Json {
    let term = |term: &MatrixTerm| json!({ "file": term.file.given, "factor": term.factor.text, "triangle": term.triangle.name() });
    let mut json: Map<String, Json> = sums
        .sums()
        .iter()
        .map(|(name, terms)| ((*name).to_owned(), terms.iter().map(term).collect()))
        .collect();
    // the files stand for themselves, wherever their folder is
    json.insert("freedoms".to_owned(), json!(sums.freedoms.as_ref().map(|file| &file.given)));
    Json::Object(json)
}
