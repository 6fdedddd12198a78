//! The resolved case as canonical JSON: every key with the value in use, keys sorted, the same bytes each time.

mod sliding;
mod structure;
mod sweep;

use serde_json::{Map, Value as Json, json};

use crate::case::analysis::Planned;
use crate::case::file::Case;
use crate::model::Analysis;
use crate::models::belt::case::{BELT_KEYS, BeltCase};
use crate::models::contact::case::ContactCase;
use crate::models::oscillator::case::OscillatorCase;
use crate::models::oscillator::inputs::{LawName, TimeForm};
use crate::models::oscillator::keys::{KEYS, OscillatorKey};
use crate::models::substrate::{Substrate, SubstrateKeys};
use crate::models::two_degrees::case::TwoDegreesCase;
use judder_keys::declared::{Setting, Settings};
use judder_keys::dimension::Dimension;
use judder_keys::numeric_key::Form;

impl Case {
    /// The case with every default filled in, for the hash of a study and for its report.
    ///
    /// A group is a number; a quantity is `{"value": …, "unit": …}` in SI units.
    pub fn resolved(&self) -> Json {
        let mut json = match self {
            Self::Oscillator(case) => oscillator(case),
            Self::Contact(case) => contact(case),
            Self::Belt(case) => belt(case),
            Self::TwoDegrees(case) => two_degrees(case),
            Self::Structure(case) => structure::case(case),
            Self::Sliding(case) => sliding::case(case),
        };
        // another crate of the build may have switched serde_json to insertion order
        json.sort_all_objects();
        json
    }
}

fn oscillator(case: &OscillatorCase) -> Json {
    let mut json = json!({
        "model": "oscillator",
        "title": case.title,
        "contact": { "law": case.law.name(), "friction_load": case.friction_load.name() },
        "analysis": analyses(&case.analyses, |kind, json| kind.write(json)),
    });
    if let Some(file) = &case.law_file {
        json["contact"]["law"] = json!({ "file": file.given });
    }
    if case.law == LawName::Bem {
        json["contact"]["law"] = json!({ "computed": true, "accuracy": case.law_accuracy });
    }
    json["substrate"] = substrate(&case.substrate, case.inputs.time_form());
    for entry in KEYS.iter().filter(|entry| case.substrate.takes(entry.key)) {
        let value = case.inputs.get(entry.key);
        json[entry.section()][entry.name()] = number(value.number, value.form, entry.dimension);
    }
    json
}

fn contact(case: &ContactCase) -> Json {
    let mut json = json!({
        "model": "contact",
        "title": case.title,
        "indenter": { "shape": Setting::write(&case.shape, &()) },
        "analysis": analyses(&case.analyses, |kind, json| kind.write(json)),
    });
    json["substrate"] = substrate(&case.substrate, case.inputs.time_form());
    let keys = ContactCase::KEYS.into_iter().filter(|key| case.substrate.takes(*key));
    for entry in keys.map(OscillatorKey::entry) {
        let value = case.inputs.get(entry.key);
        json[entry.section()][entry.name()] = number(value.number, value.form, entry.dimension);
    }
    json
}

/// How the relaxation was given, and what a substrate has beside its numeric keys.
fn substrate(substrate: &Substrate, time_form: TimeForm) -> Json {
    let given_as = substrate.source.key().unwrap_or(time_form.name());
    let mut json = Map::from_iter([("given_as".to_owned(), json!(given_as))]);
    SubstrateKeys::from(substrate).write_table(&mut json);
    Json::Object(json)
}

fn belt(case: &BeltCase) -> Json {
    let mut json = json!({
        "model": "belt",
        "title": case.title,
        "analysis": analyses(&case.analyses, Analysis::write),
    });
    for entry in &BELT_KEYS {
        json[entry.section()][entry.name()] = json!(case.inputs.number(entry.key));
    }
    json
}

fn two_degrees(case: &TwoDegreesCase) -> Json {
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

/// The analyses of a case.
fn analyses<K>(analyses: &[Planned<K>], write: impl Fn(&K, &mut Map<String, Json>)) -> Json {
    let written = |planned: &Planned<K>| {
        let mut json = Map::new();
        write(&planned.kind, &mut json);
        json.insert("kind".to_owned(), json!(planned.kind_name));
        json.insert("name".to_owned(), json!(planned.name));
        Json::Object(json)
    };
    analyses.iter().map(written).collect()
}

fn number(number: f64, form: Form, dimension: Dimension) -> Json {
    match form {
        Form::Group => json!(number),
        Form::Si => json!({ "value": number, "unit": dimension.unit() }),
    }
}
