//! Sweeps of the whole case: what is read, which points they have, and the case at a point.

use super::with_file;
use judder_keys::dimension::Dimension;
use judder_keys::keys::Keys;
use judder_keys::numeric_key::Form;
use judder_models::oscillator::case::OscillatorCase;
use judder_models::oscillator::keys::OscillatorKey;
use judder_models::schema;
use judder_models::template::template;
use judder_study::case::scale::Spacing;
use judder_study::case::study_sweep::quantity_path::QuantitySource;
use judder_study::case::study_sweep::{Design, StudySweep, SweptKey, SweptValues};
use proptest::prelude::*;

/// An oscillator case with a limit cycle named `cycle` and one sweep.
pub(crate) fn oscillator(sweep: &str) -> String {
    format!(
        "model = \"oscillator\"\n\n[[analysis]]\nname = \"cycle\"\nkind = \"limit-cycle\"\n\n\
         [[sweep]]\nname = \"robustness\"\n{sweep}\n"
    )
}

fn sweep(text: &str) -> StudySweep {
    with_file(&oscillator(text)).sweeps.remove(0)
}

const TWO_KEYS: &str = r#"over = [
  { key = "operation.velocity", from = "0.1 mm/s", to = "10 mm/s", scale = "log" },
  { key = "contact.shear_strength", from = 0.001, to = 0.1, scale = "log" },
]
quantities = ["growth_rate", "cycle.rms"]"#;

fn sobol(points: u64, more: &str) -> String {
    format!("method = \"sobol\"\npoints = {points}\n{TWO_KEYS}\n{more}")
}

#[test]
fn a_sobol_sweep_with_its_defaults() {
    let sweep = sweep(&sobol(16, ""));
    assert_eq!(sweep.method, Design::Sobol { points: 16, seed: 1 });
    assert_eq!((sweep.points(), sweep.shape(), sweep.row()), (16, &[16][..], 1));
    assert_eq!(sweep.dimensions(), ["sample"]);
    let velocity = &sweep.axes[0];
    assert_eq!((velocity.dimension, velocity.scale), (Dimension::SPEED, Spacing::Log));
    assert_eq!(velocity.values, SweptValues::Between { from: 1e-4, to: 0.01 });
    assert_eq!(key_of(velocity), (OscillatorKey::Velocity, Form::Si));
    assert_eq!(key_of(&sweep.axes[1]), (OscillatorKey::ShearStrength, Form::Group));
    assert!(sweep.is_set);
    assert_eq!((sweep.chunk, sweep.sensitivity), (None, None));
    let QuantitySource::Analysis { index: 0, name, .. } = &sweep.quantities[1].source else { panic!() };
    assert_eq!(name, "cycle");
}

/// Half of the points of a net of two lie in each half of each range, on its own scale.
#[test]
fn points_of_a_sobol_sweep_fill_the_ranges_on_their_scale() {
    let sweep = sweep(&sobol(64, "seed = 5"));
    for (k, middle) in [1e-3, 0.01].into_iter().enumerate() {
        let below = (0..64).filter(|index| sweep.values_of(*index)[k] < middle).count();
        assert_eq!(below, 32);
    }
    assert!(sweep.values_of(64).iter().all(|value| value.is_nan()));
}

#[test]
fn rows_of_sensitivity_mix_two_points() {
    let sweep = sweep(&sobol(8, "sensitivity = { confidence = 0.9 }"));
    assert_eq!((sweep.points(), sweep.row()), (32, 4));
    let sensitivity = sweep.sensitivity.unwrap();
    assert_eq!((sensitivity.confidence, sensitivity.resamples), (0.9, 1000));
    for row in 0..8 {
        let [a, ab_1, ab_2, b] = [0, 1, 2, 3].map(|member| sweep.values_of(4 * row + member));
        assert_eq!((ab_1[0], ab_1[1]), (b[0], a[1]));
        assert_eq!((ab_2[0], ab_2[1]), (a[0], b[1]));
        assert!(a[0] != b[0] && a[1] != b[1]);
    }
}

#[test]
fn a_grid_runs_over_its_last_key_fastest() {
    let sweep = sweep(
        r#"over = [
  { key = "operation.velocity", from = 1e-4, to = 1e-2, points = 3, scale = "log" },
  { key = "oscillator.coupling_angle", values = ["45 deg", "30 deg"] },
]
quantities = ["growth_rate"]"#,
    );
    assert_eq!((sweep.method, sweep.shape(), sweep.points()), (Design::Grid, &[3, 2][..], 6));
    assert_eq!(sweep.dimensions(), ["operation.velocity", "oscillator.coupling_angle"]);
    let [first, second] = [45.0_f64, 30.0].map(f64::to_radians);
    let expected =
        [[1e-4, first], [1e-4, second], [1e-3, first], [1e-3, second], [1e-2, first], [1e-2, second]];
    for (index, expected) in expected.into_iter().enumerate() {
        let found = sweep.values_of(index as u64);
        assert!(found.iter().zip(expected).all(|(x, y)| (x - y).abs() < 1e-15), "{found:?} {expected:?}");
    }
}

/// Keys with few values and with very many give theirs alike.
#[test]
fn the_points_of_a_large_grid_are_those_of_its_keys() {
    let sweep = sweep(
        r#"over = [
  { key = "operation.velocity", from = 1e-4, to = 1e-2, points = 70_001, scale = "log" },
  { key = "oscillator.damping_x", from = 0.1, to = 0.2, points = 11 },
]
quantities = ["growth_rate"]"#,
    );
    for index in [0, 10, 11, 345_678, sweep.points() - 1] {
        let expected = [sweep.axes[0].value(index / 11), sweep.axes[1].value(index % 11)];
        assert_eq!(sweep.values_of(index), expected);
    }
}

#[test]
fn a_list_takes_values_together() {
    let sweep = sweep(
        r#"method = "list"
over = [
  { key = "operation.velocity", values = [1e-4, 1e-2, 1e-2] },
  { key = "analysis.cycle.tolerance", values = [1e-8, 1e-8, 1e-9] },
]
quantities = ["cycle.rms"]
chunk = 2"#,
    );
    assert_eq!((sweep.shape(), sweep.values_of(2), sweep.chunk), (&[3][..], vec![1e-2, 1e-9], Some(2)));
    assert!(!sweep.is_set, "a key within an analysis is no key of the operating point");
}

/// The key of the oscillator at this path, and the form of its swept values.
fn key_of(axis: &SweptKey) -> (OscillatorKey, Form) {
    let key = OscillatorKey::from_path(&axis.path).expect("a key of an oscillator");
    (key, if axis.dimension.is_number() { Form::Group } else { Form::Si })
}

/// Setting the numeric keys of the oscillator and reading the case anew are one thing, units and derived times included.
#[test]
fn the_short_way_of_an_oscillator_gives_the_case_that_is_read() {
    let file = with_file(&oscillator(
        r#"method = "latin-hypercube"
points = 50
over = [
  { key = "operation.velocity", from = "0.1 mm/s", to = "10 mm/s", scale = "log" },
  { key = "substrate.glassy_modulus", from = "5 MPa", to = "500 MPa", scale = "log" },
  { key = "substrate.relaxation_time", from = "1 ms", to = "3 ms" },
  { key = "oscillator.damping_x", from = 0.0, to = 0.5 },
]
quantities = ["growth_rate"]"#,
    ));
    let base = file.case.of::<OscillatorCase>().unwrap();
    let sweep = &file.sweeps[0];
    assert!(sweep.is_set);
    for index in 0..sweep.points() {
        let values = sweep.values_of(index);
        let read = file.at(sweep, &values).unwrap().case.of::<OscillatorCase>().unwrap().clone();
        let mut inputs = base.inputs;
        for (axis, number) in sweep.axes.iter().zip(values) {
            let (key, form) = key_of(axis);
            inputs.set(key, judder_keys::numeric_key::Value { number, form });
        }
        assert_eq!(read.inputs, inputs, "point {index}");
    }
}

/// What the law is computed for does not follow by setting a key.
#[test]
fn moduli_of_a_computed_law_have_no_short_way() {
    let text = format!(
        "model = \"oscillator\"\n[contact]\nlaw = \"bem\"\n[[sweep]]\nname = \"s\"\nquantities = [\"growth_rate\"]\n{}",
        "over = [{ key = \"substrate.glassy_modulus\", from = \"5 MPa\", to = \"50 MPa\", points = 3 }]"
    );
    let file = with_file(&text);
    assert!(!file.sweeps[0].is_set);
    let case = file.at(&file.sweeps[0], &[2e7]).unwrap().case.of::<OscillatorCase>().unwrap().clone();
    assert_eq!(case.inputs.number(OscillatorKey::GlassyModulus), 2e7);
}

/// Two keys whose ranges exclude each other's value in the case: each is tried with the others at theirs.
#[test]
fn keys_that_go_together_are_tried_together() {
    let file = with_file(&oscillator(
        r#"over = [
  { key = "substrate.rubbery_modulus", from = "20 MPa", to = "50 MPa", points = 2 },
  { key = "substrate.glassy_modulus", from = "100 MPa", to = "500 MPa", points = 2 },
]
quantities = ["growth_rate"]"#,
    ));
    assert_eq!(file.sweeps[0].points(), 4);
}

#[test]
fn a_point_is_the_case_with_analyses_and_without_sweeps() {
    let file = with_file(&oscillator(&sobol(16, "")));
    let point = file.at(&file.sweeps[0], &[0.002, 0.05]).unwrap();
    assert!(point.sweeps.is_empty());
    assert_eq!((point.name.as_str(), point.case.analysis_names()), ("case", vec!["cycle"]));
    let case = point.case.of::<OscillatorCase>().unwrap();
    assert_eq!(case.inputs.number(OscillatorKey::Velocity), 0.002);
    assert_eq!(point.resolved().get("sweep"), None);
}

#[test]
fn options_reach_into_a_sweep_by_its_name() {
    let options = ["sweep.robustness.points = 128".to_owned(), "sweep.robustness.over.1.to = 0.2".to_owned()];
    let file = judder_models::parse("case.toml", &oscillator(&sobol(16, "")), &options).unwrap();
    assert_eq!(file.sweeps[0].points(), 128);
    assert_eq!(file.sweeps[0].axes[1].range(), [0.001, 0.2]);
}

#[test]
fn every_model_is_swept() {
    let cases = [
        ("oscillator", "oscillator.damping_x", "0.0", "0.1", "growth_rate"),
        ("contact", "substrate.poisson_ratio", "0.3", "0.45", "contact.force"),
        ("contact", "analysis.contact.velocity", "1e-3", "0.1", "contact.force"),
        ("belt", "friction.at_rest", "0.5", "1.5", "cycle.rms"),
        ("two-degrees", "parameters.mu", "0.0", "1.0", "onset.critical.first"),
        (
            "structure",
            "structure.material.density",
            "\"1000 kg/m^3\"",
            "\"2000 kg/m^3\"",
            "modes.frequencies_hz.0",
        ),
        ("structure", "structure.beam.elements.0", "51", "101", "modes.frequencies_hz.0"),
        ("beams-paper", "contact.friction_coefficient", "0.0", "0.9", "ensubs.steps"),
        ("beams-paper", "structure.oblique.beam.angle", "\"30 deg\"", "\"45 deg\"", "ensubs.steps"),
        ("beams-paper", "analysis.ensubs.step", "\"1e-7 s\"", "\"2e-7 s\"", "ensubs.steps"),
    ];
    for (name, key, from, to, quantity) in cases {
        // halfway between two odd counts lies a count
        let text = format!(
            "{}\n[[sweep]]\nname = \"all-of-it\"\nquantities = [\"{quantity}\"]\n\
             over = [{{ key = \"{key}\", from = {from}, to = {to}, points = 3 }}]\n",
            template(name).unwrap()
        );
        let file =
            judder_models::parse("case.toml", &text, &[]).unwrap_or_else(|error| panic!("{key}: {error}"));
        let sweep = &file.sweeps[0];
        let last = file.at(sweep, &sweep.values_of(sweep.points() - 1)).unwrap();
        assert_ne!(last.case.resolved(), file.case.resolved(), "{key} changes the case");
    }
}

#[test]
fn the_resolved_case_holds_the_sweep() {
    let file = with_file(&oscillator(&sobol(16, "sensitivity = true")));
    let resolved = file.resolved();
    assert_eq!(resolved["sweep"][0], file.sweeps[0].resolved());
    let expected = serde_json::json!({
        "name": "robustness", "method": "sobol", "points": 16, "seed": 1, "chunk": null,
        "quantities": ["growth_rate", "cycle.rms"], "sensitivity": { "confidence": 0.95, "resamples": 1000 },
        "over": [
            { "key": "operation.velocity", "from": { "value": 1e-4, "unit": "m/s" }, "to": { "value": 0.01, "unit": "m/s" }, "scale": "log" },
            { "key": "contact.shear_strength", "from": 0.001, "to": 0.1, "scale": "log" },
        ],
    });
    assert_eq!(resolved["sweep"][0], expected);
    let without = with_file("model = \"oscillator\"\n");
    assert_eq!(without.resolved(), without.case.resolved());
}

#[test]
fn the_schema_knows_the_sweeps_of_every_model() {
    let schema = schema();
    let models = schema["oneOf"].as_array().unwrap();
    assert!(models.iter().all(|model| model["properties"]["sweep"]["$ref"] == "#/$defs/sweeps"));
    let known = schema["$defs"]["sweeps"]["items"]["properties"].as_object().unwrap();
    let keys: Vec<&str> = known.keys().map(String::as_str).collect();
    let expected =
        ["chunk", "method", "name", "over", "points", "probabilities", "quantities", "seed", "sensitivity"];
    assert_eq!(keys, expected);
}

proptest! {
    /// Any point of any sweep lies in its range, and the point of an index does not depend on what was asked before.
    #[test]
    fn points_lie_in_their_ranges(seed in 0..1000_u32, points in 2..10_000_u64, log: bool, method in 0..2_usize, index: u64) {
        let scale = if log { "log" } else { "linear" };
        let method = ["sobol", "latin-hypercube"][method];
        let text = format!(
            "method = \"{method}\"\npoints = {points}\nseed = {seed}\nquantities = [\"growth_rate\"]\n\
             over = [{{ key = \"operation.velocity\", from = 10.0, to = 1e-9, scale = \"{scale}\" }}]"
        );
        let sweep = sweep(&text);
        let value = sweep.values_of(index % points)[0];
        prop_assert!((1e-9..=10.0).contains(&value));
        prop_assert_eq!(sweep.clone().values_of(index % points)[0], value);
    }
}

/// What only a continuous spectrum yields is a result of a case that has one.
#[test]
fn results_that_some_cases_have_are_asked_of_those() {
    let case = |substrate: &str| {
        format!(
            "model = \"contact\"\n[substrate]\n{substrate}\n[[analysis]]\nkind = \"contact\"\nvelocity = 1e-2\nindentation = 1e-2\n[[sweep]]\nname = \"s\"\nover = [{{ key = \"analysis.contact.velocity\", from = 1e-3, to = 1e-2, points = 2 }}]\nquantities = [\"contact.spectrum_terms\"]\n"
        )
    };
    let continuous = "rubbery_modulus = \"1 MPa\"\nglassy_modulus = \"9 MPa\"\ncontinuous = { log_normal = { median = \"10 ms\", width = 1.0 }, terms = 8 }";
    assert!(judder_models::parse("case.toml", &case(continuous), &[]).is_ok());
    let error = judder_models::parse("case.toml", &case(""), &[]).unwrap_err();
    assert_eq!(error.place(), "\"contact.spectrum_terms\"");
}
