//! Declared settings: everything that is wrong is told at once, and the schema says what reading asks for.

use super::parse;
use judder_keys::error::CaseError;
use judder_models::schema;
use serde_json::{Value, json};

const WRONG: &str = r#"
model = "structure"
[structure]
beam = { length = "1 s", thickness = 2, elements = [10, 2], start = "clampd" }
material = { youngs_modulus = "210 GPa", poisson_ratio = 0.7 }
"#;

/// The messages of all that is wrong.
fn told(error: CaseError) -> Vec<String> {
    let (first, others) = error.split();
    std::iter::once(first).chain(others).map(|error| error.to_string()).collect()
}

/// In the order of the text, each with its place.
#[test]
fn all_that_is_wrong_is_told() {
    let error = parse(WRONG, &[]).unwrap_err();
    assert_eq!(error.others().iter().map(CaseError::place).collect::<Vec<&str>>()[..2], ["2", "clampd"]);
    assert_eq!(
        told(error),
        [
            "`structure.beam.length` must be a length, but this is a time",
            "`structure.beam.thickness` needs a unit: it has no dimensionless form",
            "unknown end condition `clampd`",
            "`structure.material` lacks the key `density`",
            "`structure.material.poisson_ratio` must be above -1 and at most 0.499999, but is 0.7",
        ]
    );
}

/// Substrate, shape and analysis of a contact, each with all of its own.
#[test]
fn all_that_is_wrong_with_a_contact_is_told() {
    let of = |text: &str| told(parse(&format!("model = \"contact\"\n{text}"), &[]).unwrap_err());
    let analysis = of("[[analysis]]\nkind = \"contact\"\nvelocity = \"3 mm\"\naccuracy = 0.5\ncells = 65");
    assert_eq!(
        analysis,
        [
            "an analysis of kind `contact` lacks the key `indentation`",
            "`velocity` must be a speed, but this is a length",
            "`accuracy` must be above 0 and at most 0.2, but is 0.5",
            "`cells` must be a multiple of two from 64 to 4096, but is 65",
        ]
    );
    let substrate = of("[substrate]\npoisson_ratio = 2\ndma = { terms = 0 }\ntemperature = 3");
    for part in ["poisson_ratio", "lacks the key `file`", "dma.terms", "temperature"] {
        assert!(substrate.iter().any(|message| message.contains(part)), "{part}: {substrate:?}");
    }
    assert_eq!(of("indenter = { shape = { rough = { cells = 2 } } }").len(), 3);
}

/// Two analyses, each with what is wrong with it.
#[test]
fn one_analysis_does_not_hide_another() {
    let body =
        WRONG.replace("\"1 s\"", "\"1 m\"").replace("= 2,", "= \"1 cm\",").replace("clampd", "clamped");
    let body = body.replace("0.7", "0.3, density = \"7850 kg/m^3\"");
    let text = format!(
        "{body}[[analysis]]\nkind = \"modes\"\ncount = 0\n[[analysis]]\nkind = \"eigen\"\nregion = {{ re = [1.0, 0.0] }}\n"
    );
    let messages = told(parse(&text, &[]).unwrap_err());
    assert_eq!(messages.len(), 3, "{messages:?}");
    for part in ["`count` ", "backwards", "lacks the key `im`"] {
        assert!(messages.iter().any(|message| message.contains(part)), "{part}: {messages:?}");
    }
}

/// What a case must give is required, and what it may leave out has the default that it then gets.
#[test]
fn the_schema_asks_for_what_reading_asks_for() {
    let schema = schema();
    let structure = table_of(&schema, "one linear structure alone");
    let beam = &structure["properties"]["structure"]["properties"]["beam"];
    assert_eq!(beam["required"], json!(["length", "thickness", "elements"]));
    assert_eq!(beam["properties"]["angle"]["default"], "0 rad");
    assert_eq!(beam["properties"]["start"]["enum"], json!(["free", "clamped", "guided"]));
    let supports = &structure["properties"]["structure"]["properties"]["supports"];
    assert_eq!(supports["items"]["required"], json!(["set"]));
}

/// One of some alternatives must be given where the first of them has a key that must.
#[test]
fn the_schema_asks_for_one_of_the_alternatives() {
    let schema = schema();
    let sliding = table_of(&schema, "one structure slides along another");
    assert_eq!(sliding["required"], json!(["model", "structure", "contact", "motion"]));
    let slider = &sliding["properties"]["contact"]["properties"]["slider"];
    assert_eq!(slider["required"], json!(["structure"]));
    assert_eq!(slider["oneOf"], json!([{ "required": ["set"] }, { "required": ["nodes"] }]));
    let point = &sliding["properties"]["observe"]["properties"]["points"]["items"];
    assert_eq!(
        point["oneOf"],
        json!([{ "required": ["set"] }, { "required": ["nodes"] }, { "required": ["at"] }])
    );
    let assembly = table_of(&schema, "what acts on the nodes of a set");
    let one_of = |keys: &[&str]| {
        let each: Vec<Value> = keys.iter().map(|key| json!({ "required": [key] })).collect();
        json!({ "oneOf": each })
    };
    let expected = [one_of(&["set", "nodes"]), one_of(&["force", "pressure", "displacement"])];
    assert_eq!(assembly["allOf"], json!(expected));
    let locus = table_of(
        &schema,
        "complex eigenvalues against the position of the contact, or against any key, with located unstable zones",
    );
    assert_eq!((&locus["required"], locus.get("oneOf")), (&json!(["kind"]), None));
}

/// A disturbance, or a coordinate at least, and never both.
#[test]
fn the_schema_asks_for_one_start_of_a_motion() {
    let schema = schema();
    for (model, coordinates) in [
        ("the oscillator of the oscillator paper", &["x", "y", "velocity_x", "velocity_y"][..]),
        ("one mass on a moving belt, friction against the speed of sliding", &["x", "velocity_x"]),
    ] {
        let motion = "the history of one motion: stick, slip, lift-off, its averages, its energy";
        let start = &table_of(table_of(&schema, model), motion)["properties"]["start"];
        let state: Vec<Value> = coordinates.iter().map(|key| json!({ "required": [key] })).collect();
        assert_eq!(start["oneOf"], json!([{ "required": ["disturbance"] }, { "anyOf": state }]), "{model}");
        assert_eq!(start["default"], json!({ "disturbance": 0.2 }), "{model}");
    }
}

/// The table of the schema with this description.
fn table_of<'a>(json: &'a Value, description: &str) -> &'a Value {
    fn find<'a>(json: &'a Value, description: &str) -> Option<&'a Value> {
        if json["description"] == description && json["type"] == "object" {
            return Some(json);
        }
        match json {
            Value::Object(own) => own.values().find_map(|value| find(value, description)),
            Value::Array(own) => own.iter().find_map(|value| find(value, description)),
            _ => None,
        }
    }
    find(json, description).unwrap()
}

/// The analyses of an oscillator: what is wrong with one key does not hide what is wrong with another.
#[test]
fn all_that_is_wrong_with_an_analysis_of_motion_is_told() {
    let text = "model = \"oscillator\"\n[[analysis]]\nkind = \"bifurcation\"\nsweep = { key = \"operation.speed\", from = 1, to = 2, points = 3 }\n\
                start = { x = \"1\" }\nduration = 0\ntolerance = 1\nbranches = 1\n";
    let messages = told(parse(text, &[]).unwrap_err());
    assert_eq!(messages.len(), 5, "{messages:?}");
}

/// By its dotted path, with unit, group and range; the keys of analyses, and those that analyses vary.
#[test]
fn every_key_of_a_model_is_told_by_its_path() {
    let keys = judder_models::keys("oscillator").unwrap();
    let of_path = |path: &str| {
        let found = keys.as_array().unwrap().iter().find(|key| key["path"] == path);
        found.unwrap_or_else(|| panic!("{path}")).clone()
    };
    let velocity = of_path("operation.velocity");
    assert_eq!(
        (&velocity["varied"], &velocity["default"], &velocity["symbol"]),
        (&json!(true), &json!(1e-4), &json!("v_d"))
    );
    let form = json!({ "kind": "number", "group": "v_d τ/R", "unit": "m/s", "range": { "above": 0.0 } });
    assert_eq!(velocity["form"], form);
    assert_eq!(of_path("substrate.shift.wlf.c1")["varied"], false);
    assert_eq!(of_path("analysis.*.samples")["analysis"], "basin");
    assert!(judder_models::keys("oscilator").is_none());
}
