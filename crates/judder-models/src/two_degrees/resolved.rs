//! The canonical form of a two-degrees case.

use super::case::TwoDegreesCase;
use judder_study::case::resolved::analyses;
use judder_study::model::Analysis;
use serde_json::{Map, Value as Json, json};

pub(super) fn case(case: &TwoDegreesCase) -> Json {
    let parameters = case.parameters.iter().map(|parameter| json!([parameter.name, parameter.value]));
    let matrices: Map<_, _> =
        case.expressions().into_iter().map(|(name, texts)| (name.to_owned(), json!(texts))).collect();
    json!({
        "model": "two-degrees",
        "title": case.title,
        "parameters": parameters.collect::<Vec<_>>(),
        "matrices": matrices,
        "analysis": analyses(&case.analyses, Analysis::write),
    })
}
