//! The plotly JSON holds the figure's numbers: typed arrays decode to them, shapes and names are right.

use crate::samples::{HOSTILE, every_layer, one_line};
use base64::{Engine, engine::general_purpose::STANDARD};
use judder_report::{Axis, Figure, Layer, Panel, Role, Scale, Swing, plotly};
use serde_json::{Value, json};

pub(crate) fn base64_bytes(text: &str) -> Vec<u8> {
    STANDARD.decode(text).unwrap()
}

fn floats(array: &Value) -> Vec<f64> {
    assert_eq!(array["dtype"], "f8");
    let bytes = base64_bytes(array["bdata"].as_str().unwrap());
    bytes.chunks_exact(8).map(|chunk| f64::from_le_bytes(chunk.try_into().unwrap())).collect()
}

#[test]
fn curves_keep_every_digit_and_their_gaps() {
    let x = vec![1e-8, 0.1 + 0.2, f64::NAN, 1e300];
    let chart = plotly(&one_line(Scale::Log, x.clone(), x.clone())).unwrap();
    let back = floats(&chart["data"][0]["x"]);
    assert_eq!(back[..2], x[..2]);
    assert!(back[2].is_nan());
    assert_eq!(chart["layout"]["xaxis"]["type"], "log");
}

/// Straight from 10 at 1 to 90 at 5: 20 a unit, so 50 stands above 3.
#[test]
fn a_second_axis_stands_where_its_values_are() {
    let chart = plotly(&every_layer("$s$")).unwrap();
    let axis = &chart["layout"]["xaxis6"];
    assert_eq!(
        (&axis["overlaying"], &axis["side"], &axis["matches"]),
        (&json!("x3"), &json!("top"), &json!("x3"))
    );
    // from 10 at 1 to 90 at 5
    let (labels, places) = (axis["ticktext"].as_array().unwrap(), axis["tickvals"].as_array().unwrap());
    assert!(labels.len() > 2, "{labels:?}");
    for (label, place) in labels.iter().zip(places) {
        let value: f64 = label.as_str().unwrap().parse().unwrap();
        assert!(
            (place.as_f64().unwrap() - (1.0 + (value - 10.0) / 20.0)).abs() < 1e-12,
            "{label} at {place}"
        );
    }
    assert!(
        chart["data"]
            .as_array()
            .unwrap()
            .iter()
            .any(|trace| trace["xaxis"] == "x6" && trace["yaxis"] == "y3")
    );
}

#[test]
fn class_maps_carry_codes_shape_and_names() {
    let chart = plotly(&every_layer("$τ̃_{0}$")).unwrap();
    let traces = chart["data"].as_array().unwrap();
    let map =
        traces.iter().find(|trace| trace["type"] == "heatmap" && trace["z"]["runs"].is_string()).unwrap();
    let runs = base64_bytes(map["z"]["runs"].as_str().unwrap());
    let codes =
        runs.chunks_exact(3).flat_map(|run| vec![run[0]; usize::from(u16::from_le_bytes([run[1], run[2]]))]);
    assert_eq!(codes.collect::<Vec<u8>>(), [0, 1, 2, 2, 1, 0]);
    assert_eq!(runs.len(), 3 * 5, "the two cells of one code are one run");
    assert_eq!(map["z"]["shape"], "2, 3");
    assert_eq!(map["meta"]["classes"], json!(["<i>τ̃</i><sub>0</sub>", "flutter", "unresolved"]));
}

#[test]
fn value_maps_show_their_own_values() {
    let chart = plotly(&every_layer("z")).unwrap();
    let traces = chart["data"].as_array().unwrap();
    let map = traces.iter().find(|trace| trace["coloraxis"].is_string()).unwrap();
    assert_eq!(floats(&map["customdata"])[..3], [1.0, 2.0, 3.0]);
    assert_eq!(floats(&map["z"])[0], 0.0, "log colours are handed over as logarithms");
    assert!(chart["layout"][map["coloraxis"].as_str().unwrap()]["colorbar"].is_object());
}

#[test]
fn symmetric_log_axes_show_their_own_values() {
    let chart =
        plotly(&one_line(Scale::SymmetricLog { linear: 0.1 }, vec![-10.0, 0.05], vec![0.0, 1.0])).unwrap();
    let trace = &chart["data"][0];
    assert_eq!(floats(&trace["x"]), [-3.0, 0.5]);
    let hover = trace["hovertemplate"].as_str().unwrap();
    assert!(hover.contains("%{customdata[0]:") && hover.contains("%{customdata[1]:"));
    assert_eq!(trace["customdata"]["shape"], "2, 2");
    assert_eq!(floats(&trace["customdata"]), [-10.0, 0.0, 0.05, 1.0]);
}

#[test]
fn an_array_of_several_curves_stands_once() {
    let x: Vec<f64> = (0..20).map(f64::from).collect();
    let mut figure = one_line(Scale::Linear, x.clone(), x.iter().map(|x| x * x).collect());
    let again = figure.panels[0].layers[0].clone();
    figure.panels[0].layers.push(again);
    let chart = plotly(&figure).unwrap();
    assert_eq!(floats(&chart["data"][0]["x"]), x);
    assert_eq!(chart["data"][1]["x"], json!({ "same": [0, "x"] }));
    assert_eq!(chart["data"][1]["y"], json!({ "same": [0, "y"] }));
}

#[test]
fn a_label_has_one_legend_entry() {
    let chart = plotly(&every_layer("same")).unwrap();
    let shown = chart["data"].as_array().unwrap().iter().filter(|trace| trace["showlegend"] == true);
    let names: Vec<&Value> = shown.map(|trace| &trace["name"]).collect();
    let distinct: std::collections::BTreeSet<String> = names.iter().map(ToString::to_string).collect();
    assert_eq!(names.len(), distinct.len(), "{names:?}");
}

#[test]
fn small_screens_get_one_column() {
    let chart = plotly(&every_layer("")).unwrap();
    assert_eq!(chart["narrow"]["xaxis2"]["domain"][0], 0.0);
    assert_ne!(chart["layout"]["xaxis2"]["domain"][0], 0.0);
}

#[test]
fn hostile_texts_are_escaped_and_bytes_repeat() {
    let figure = every_layer(HOSTILE);
    let text = plotly(&figure).unwrap().to_string();
    assert!(!text.contains("</script>"));
    assert_eq!(text, plotly(&figure).unwrap().to_string());
}

#[test]
fn swinging_lines_carry_their_amplitudes() {
    let swing = Swing { x: [vec![0.0, 0.5], vec![0.0; 2]], y: [vec![1.0, 0.0], vec![0.0, 3.0]] };
    let line = Layer::swinging("mode", vec![0.0, 1.0], vec![1.0, 0.0], swing, Role::Series(0));
    let panel = |layer| vec![Panel::new(Axis::linear("x"), Axis::linear("y"), vec![layer])];
    let chart = plotly(&Figure::new("mode", "A mode", panel(line.clone()))).unwrap();
    let meta = &chart["data"][0]["meta"]["swing"];
    assert_eq!(floats(&meta["y"][1]), [0.0, 3.0]);
    // the frame holds the whole swing: from −3 to 3
    let range: Vec<f64> = serde_json::from_value(chart["layout"]["yaxis"]["range"].clone()).unwrap();
    assert!(range[0] <= -3.0 && range[1] >= 3.0, "{range:?}");
}
