//! Schema and templates: what editors and `judder new` offer.

use serde_json::Value as Json;

use super::{help_of, parse};
use judder_keys::keys::Keys;
use judder_models::belt::case::BeltCase;
use judder_models::belt::inputs::BeltInputs;
use judder_models::contact::case::ContactCase;
use judder_models::oscillator::case::OscillatorCase;
use judder_models::oscillator::inputs::OscillatorInputs;
use judder_models::oscillator::keys::OscillatorKey;
use judder_models::schema;
use judder_models::template::{template, templates};

#[test]
fn every_template_is_a_valid_case() {
    for name in templates() {
        let text = template(name).unwrap();
        let case = parse(&text, &[]).unwrap_or_else(|error| panic!("{name}: {error}"));
        let commented = text.lines().filter(|line| line.contains("# ")).count();
        assert!(commented > 5, "{name} has comments");
        let oscillator = case.of::<OscillatorCase>().map(|case| &case.inputs);
        let contact = case.of::<ContactCase>().map(|case| &case.inputs);
        for inputs in oscillator.into_iter().chain(contact) {
            assert_eq!(*inputs, OscillatorInputs::default(), "{name}");
        }
        if let Some(case) = case.of::<BeltCase>() {
            assert_eq!(case.inputs, BeltInputs::default(), "{name}");
        }
    }
}

#[test]
fn the_template_of_the_oscillator_shows_every_key() {
    let text = template("oscillator").unwrap();
    for entry in OscillatorKey::ALL {
        let shown = |line: &&str| line.trim_start_matches("# ").starts_with(&format!("{} = ", entry.name()));
        assert_eq!(text.lines().filter(shown).count(), 1, "{}", entry.path);
    }
}

#[test]
fn an_unknown_template_names_the_known_ones() {
    let error = template("oscilator").unwrap_err();
    assert_eq!(error.to_string(), "there is no template `oscilator`");
    assert_eq!(
        help_of(&error),
        "did you mean `oscillator`? known: oscillator, contact, belt, two-degrees, structure, beams-paper, assembly"
    );
}

/// All keys but those of a sweep, which are those of every sweep, and those of a reduction.
#[test]
fn the_template_of_the_beams_paper_shows_every_key() {
    let (text, schema) = (template("beams-paper").unwrap(), schema());
    let models = schema["oneOf"].as_array().unwrap();
    let sliding = models.iter().find(|model| model["properties"]["model"]["const"] == "sliding").unwrap();
    let mut shown = 0;
    for table in ["contact", "motion", "observe", "analysis"] {
        visit(&sliding["properties"][table], &mut |object| {
            let Some(Json::Object(properties)) = object.get("properties") else { return };
            for key in properties.keys().filter(|key| !["scale", "values"].contains(&key.as_str())) {
                assert!(text.contains(&format!("{key} = ")), "{key}");
                shown += 1;
            }
        });
    }
    assert!(shown > 60, "{shown}");
}

/// Calls `visit` with every object of a JSON document.
fn visit(json: &Json, action: &mut impl FnMut(&serde_json::Map<String, Json>)) {
    match json {
        Json::Object(map) => {
            action(map);
            map.values().for_each(|value| visit(value, action));
        }
        Json::Array(list) => list.iter().for_each(|value| visit(value, action)),
        _ => (),
    }
}

#[test]
fn the_schema_knows_every_key_with_its_default_and_its_references_resolve() {
    let schema = schema();
    assert_eq!(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
    for entry in OscillatorKey::ALL {
        let definition = &schema["oneOf"][0]["properties"][entry.section()]["properties"][entry.name()];
        assert!(definition["description"].as_str().unwrap().contains(entry.doc), "{}", entry.path);
        assert_eq!(definition["default"].is_null(), entry.default.is_none(), "{}", entry.path);
    }
    visit(&schema, &mut |object| {
        if let Some(Json::String(reference)) = object.get("$ref") {
            let pointer = reference.strip_prefix('#').unwrap();
            assert!(schema.pointer(pointer).is_some(), "{reference}");
        }
    });
}

#[test]
fn what_the_schema_requires_is_among_its_properties() {
    visit(&schema(), &mut |object| {
        if let (Some(Json::Array(required)), Some(properties)) =
            (object.get("required"), object.get("properties"))
        {
            assert!(
                required.iter().all(|key| properties.get(key.as_str().unwrap()).is_some()),
                "{required:?}"
            );
        }
    });
}
