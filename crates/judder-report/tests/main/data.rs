//! The JSON of a figure holds its numbers: arrays decode to them, each once, ranges are settled, texts are as they were.

use crate::samples::{HOSTILE, every_layer, one_line};
use base64::{Engine, engine::general_purpose::STANDARD};
use judder_report::{Axis, Figure, Layer, Panel, Role, Scale, Swing, json};
use miniz_oxide::inflate::decompress_to_vec;
use serde_json::{Value, json};
use std::path::Path;

pub(crate) fn base64_bytes(text: &str) -> Vec<u8> {
    STANDARD.decode(text).unwrap()
}

fn described(figure: &Figure) -> Value {
    serde_json::from_str(&json(figure).unwrap()).unwrap()
}

/// The kind and the numbers of an array of a figure's JSON.
fn numbers(figure: &Value, array: &Value) -> (String, Vec<f64>) {
    let Some(wanted) = array["array"].as_u64() else {
        let digits = array.as_array().unwrap().iter().map(|value| value.as_f64().unwrap_or(f64::NAN));
        return ("digits".to_owned(), digits.collect());
    };
    let bytes = decompress_to_vec(&base64_bytes(figure["bytes"].as_str().unwrap())).unwrap();
    let size = |about: &Value| match about[0].as_str().unwrap() {
        "u1" => 1,
        "f4" => 4,
        _ => 8,
    };
    let abouts = figure["arrays"].as_array().unwrap();
    let length = |about: &Value| about[1].as_u64().unwrap() as usize;
    let start: usize = abouts.iter().take(wanted as usize).map(|about| size(about) * length(about)).sum();
    let about = &abouts[wanted as usize];
    let read = |k: usize| {
        let own: Vec<u8> = (0..size(about)).map(|place| bytes[start + place * length(about) + k]).collect();
        match own.len() {
            1 => f64::from(own[0]),
            4 => f64::from(f32::from_le_bytes(own.try_into().unwrap())),
            _ => f64::from_le_bytes(own.try_into().unwrap()),
        }
    };
    (about[0].as_str().unwrap().to_owned(), (0..length(about)).map(read).collect())
}

fn x_of_line(x: &[f64]) -> (String, Vec<f64>) {
    let figure = described(&one_line(Scale::Linear, x.to_vec(), x.to_vec()));
    numbers(&figure, &figure["panels"][0]["layers"][0]["line"]["x"])
}

#[test]
fn curves_keep_what_is_drawn_of_them_and_their_gaps() {
    let few = [1e-8, 0.1 + 0.2, f64::NAN, 1e300];
    let (kind, back) = x_of_line(&few);
    assert_eq!((kind.as_str(), &back[..2], back[3]), ("digits", &few[..2], 1e300));
    assert!(back[2].is_nan());
    let many: Vec<f64> =
        (0..100).map(|k| if k == 50 { f64::NAN } else { 0.1 * f64::from(k) - 3.0 }).collect();
    let (kind, back) = x_of_line(&many);
    assert_eq!((kind.as_str(), back.len(), back[50].is_nan()), ("f4", 100, true));
    assert!(many.iter().zip(&back).all(|(own, back)| own.is_nan() || (own - back).abs() <= 1e-7 * own.abs()));
}

/// Single precision would move points by a tenth of what these span, or lose them.
#[test]
fn numbers_that_single_precision_would_displace_keep_every_digit() {
    let close: Vec<f64> = (0..100).map(|k| 1000.0 + 1e-5 * f64::from(k)).collect();
    assert_eq!(x_of_line(&close), ("f8".to_owned(), close));
    let wide: Vec<f64> = (0..100).map(|k| 10_f64.powi(3 * k - 150)).collect();
    assert_eq!(x_of_line(&wide), ("f8".to_owned(), wide));
}

#[test]
fn ranges_are_settled_and_values_are_their_own() {
    let figure = described(&one_line(Scale::SymmetricLog { linear: 0.1 }, vec![-10.0, 0.05], vec![0.0, 1.0]));
    let panel = &figure["panels"][0];
    assert_eq!(panel["x"]["scale"], json!({ "symmetric-log": { "linear": 0.1 } }));
    assert_eq!(panel["x"]["range"], json!([-10.0, 0.05]));
    assert!(panel["y"]["range"][1].as_f64().unwrap() >= 1.0);
    assert_eq!(numbers(&figure, &panel["layers"][0]["line"]["x"]).1, [-10.0, 0.05]);
    assert_eq!(
        described(&one_line(Scale::Log, vec![1.0, 2.0], vec![1.0, 2.0]))["panels"][0]["x"]["scale"],
        "log"
    );
}

#[test]
fn a_second_axis_has_its_values() {
    let figure = described(&every_layer("$s$"));
    let second = &figure["panels"][2]["second"];
    assert_eq!(second, &json!({ "label": "$s$", "x": [1.0, 5.0], "value": [10.0, 90.0] }));
}

#[test]
fn class_maps_carry_codes_and_names() {
    let figure = described(&every_layer("$τ̃_{0}$"));
    let map = &figure["panels"][0]["layers"][0]["classes"];
    assert_eq!(numbers(&figure, &map["codes"]).1, [0.0, 1.0, 2.0, 2.0, 1.0, 0.0]);
    assert_eq!(map["classes"][0], json!({ "label": "$τ̃_{0}$", "role": "stable" }));
    assert_eq!(map["classes"][2]["role"], "unresolved");
}

#[test]
fn value_maps_show_their_own_values() {
    let figure = described(&every_layer("z"));
    let map = &figure["panels"][1]["layers"][0]["values"];
    assert_eq!(numbers(&figure, &map["z"]).1[..3], [1.0, 2.0, 3.0]);
    assert!(map["z"][3].is_null(), "a cell without a value is a gap");
    assert_eq!((&map["bar"]["scale"], &map["bar"]["range"]), (&json!("log"), &json!([1e-3, 6.0])));
}

#[test]
fn an_array_of_several_curves_stands_once() {
    let x: Vec<f64> = (0..20).map(f64::from).collect();
    let mut figure = one_line(Scale::Linear, x.clone(), x.iter().map(|x| x * x).collect());
    let again = figure.panels[0].layers[0].clone();
    figure.panels[0].layers.push(again);
    let figure = described(&figure);
    let layers = &figure["panels"][0]["layers"];
    assert_eq!(numbers(&figure, &layers[0]["line"]["x"]).1, x);
    assert_eq!(layers[1]["line"]["x"], layers[0]["line"]["x"]);
    assert_ne!(layers[1]["line"]["y"], layers[1]["line"]["x"]);
    assert_eq!(figure["arrays"].as_array().unwrap().len(), 2);
}

#[test]
fn hostile_texts_come_back_and_bytes_repeat() {
    let figure = every_layer(HOSTILE);
    assert_eq!(described(&figure)["panels"][0]["title"], HOSTILE);
    assert_eq!(json(&figure), json(&figure.clone()));
}

#[test]
fn swinging_lines_carry_their_amplitudes() {
    let swing = Swing { x: [vec![0.0, 0.5], vec![0.0; 2]], y: [vec![1.0, 0.0], vec![0.0, 3.0]] };
    let line = Layer::swinging("mode", vec![0.0, 1.0], vec![1.0, 0.0], swing, Role::Series(0));
    let panel = Panel::new(Axis::linear("x"), Axis::linear("y"), vec![line]);
    let figure = described(&Figure::new("mode", "A mode", vec![panel]));
    let panel = &figure["panels"][0];
    assert_eq!(numbers(&figure, &panel["layers"][0]["line"]["swing"]["y"][1]).1, [0.0, 3.0]);
    // the frame holds the whole swing: from −3 to 3
    let range: Vec<f64> = serde_json::from_value(panel["y"]["range"].clone()).unwrap();
    assert!(range[0] <= -3.0 && range[1] >= 3.0, "{range:?}");
}

/// What the sources of the chart are tested with; `JUDDER_GOLDEN=write` writes it anew.
#[test]
fn the_golden_figure_with_which_the_chart_is_tested_is_this_one() {
    let mut figure = every_layer("$τ̃_{0}$ (N)");
    let x: Vec<f64> = (0..40).map(|k| 0.1 * f64::from(k)).collect();
    let part = |factor: f64| x.iter().map(|x| factor * libm::sin(*x)).collect::<Vec<f64>>();
    let swing = Swing { x: [part(0.0), part(0.0)], y: [part(1.0), part(0.5)] };
    let mode = Layer::swinging("mode", x.clone(), part(1.0), swing, Role::Mode(1));
    let bubbles = Layer::bubbles(
        "bubbles",
        vec![0.0, 1.0],
        vec![0.0, 0.5],
        vec![1.0, 3.0],
        Role::Graded { index: 1, count: 3 },
    );
    let names = Axis::named("key", ["velocity", "load", "mass", "time"].map(str::to_owned));
    figure.panels.push(Panel::new(names, Axis::linear("y"), vec![mode, bubbles]));
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../judder-explorer/web/tests/figure.json");
    let wanted = json(&figure).unwrap() + "\n";
    if std::env::var("JUDDER_GOLDEN").is_ok_and(|mode| mode == "write") {
        std::fs::write(&path, &wanted).unwrap();
    }
    assert!(
        std::fs::read_to_string(&path).unwrap() == wanted,
        "figure.json is not current: JUDDER_GOLDEN=write writes it"
    );
}
