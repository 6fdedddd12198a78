//! The layers of a figure as plotly traces.

use super::suffix;
use crate::figure::{ClassMap, Figure, Layer, Line, Panel, Scale, Swing, ValueMap};
use crate::legend::{Entry, entries};
use crate::markup::html;
use crate::palette::{Marker, QUIET, Role};
use crate::scale::stretch;
use base64::{Engine, engine::general_purpose::STANDARD};
use serde_json::{Value, json};
use std::collections::BTreeMap;

/// Arrays no longer than this, as text, are not worth sharing.
const SHARED: usize = 64;

/// The traces of all panels; those that share a label share one legend entry and are shown or hidden together.
pub(super) fn of_figure(figure: &Figure) -> Vec<Value> {
    let mut explained: Vec<String> = Vec::new();
    let mut traces = Vec::new();
    for (index, panel) in figure.panels.iter().enumerate() {
        let mut of_panel: Vec<Value> = entries(panel).iter().filter_map(area_key).collect();
        of_panel.extend(panel.layers.iter().filter_map(|layer| trace(layer, panel, index)));
        for mut trace in of_panel {
            let label = trace["name"].as_str().unwrap_or_default().to_owned();
            let known = explained.contains(&label);
            trace["xaxis"] = json!(format!("x{}", suffix(index)));
            trace["yaxis"] = json!(format!("y{}", suffix(index)));
            trace["showlegend"] = json!(!label.is_empty() && !known);
            trace["legendgroup"] = json!(label);
            explained.push(label);
            traces.push(trace);
        }
        traces.extend(panel.second.as_ref().map(|_| second_key(figure.panels.len() + index, index)));
    }
    share_arrays(&mut traces);
    traces
}

/// Nothing to be seen, without which plotly would not draw the second axis of a panel.
fn second_key(axis: usize, panel: usize) -> Value {
    json!({
        "type": "scatter", "mode": "markers", "x": [null], "y": [null], "hoverinfo": "skip", "showlegend": false,
        "xaxis": format!("x{}", suffix(axis)), "yaxis": format!("y{}", suffix(panel)),
    })
}

/// Leaves every array in the first trace that has it; others say `[trace, key]` of that one.
fn share_arrays(traces: &mut [Value]) {
    let mut known: BTreeMap<String, (usize, &str)> = BTreeMap::new();
    for (index, trace) in traces.iter_mut().enumerate() {
        for key in ["x", "y", "customdata"] {
            let Some(data) = trace[key]["bdata"].as_str().filter(|data| data.len() > SHARED) else {
                continue;
            };
            match known.get(data) {
                Some((first, name)) => trace[key] = json!({ "same": [first, name] }),
                None => drop(known.insert(data.to_owned(), (index, key))),
            }
        }
    }
}

/// A legend entry for a coloured area, which plotly has none for.
fn area_key(entry: &Entry) -> Option<Value> {
    let role = entry.area?;
    let symbol = if role == Role::Unresolved { "square-x-open" } else { "square" };
    Some(json!({
        "type": "scatter", "mode": "markers", "name": html(&entry.label), "x": [null], "y": [null],
        "marker": {
            "symbol": symbol, "size": 13, "color": role.colour().to_string(),
            "line": { "width": 0.7, "color": QUIET.to_string() },
        },
        "hoverinfo": "skip",
    }))
}

fn trace(layer: &Layer, panel: &Panel, index: usize) -> Option<Value> {
    match layer {
        Layer::Line(line) => {
            let mut trace = curve(line, panel);
            trace["mode"] = json!("lines");
            trace["line"] = json!({
                "color": line.style.role.colour().to_string(),
                "width": 1.5 * line.style.width,
                "dash": line.style.dash.plotly(),
                "simplify": false,
            });
            Some(trace)
        }
        Layer::Points(points) => {
            let mut trace = curve(points, panel);
            let usual = if points.style.crowded { 3.0 } else { 7.0 };
            let size = match &points.sizes {
                Some(sizes) => sizes.iter().map(|size| usual * size).collect(),
                None => json!(usual),
            };
            // a cross is all rim
            let has_rim = !points.style.crowded || points.style.marker == Marker::Cross;
            trace["mode"] = json!("markers");
            trace["marker"] = json!({
                "color": points.style.role.colour().to_string(),
                "symbol": points.style.marker.plotly(),
                "size": size,
                "line": { "width": if has_rim { 0.7 } else { 0.0 }, "color": "#ffffff" },
            });
            Some(trace)
        }
        Layer::Classes(map) => Some(class_map(map, panel)),
        Layer::Values(map) => Some(value_map(map, panel, index)),
        Layer::Rule(_) | Layer::Region(_) | Layer::Note(_) => None,
    }
}

/// The amplitudes of a line that swings.
fn swing(swing: &Swing) -> Value {
    let parts = |parts: &[Vec<f64>; 2]| parts.each_ref().map(|part| floats(part, None));
    json!({ "swing": { "x": parts(&swing.x), "y": parts(&swing.y) } })
}

/// What lines and points have in common.
fn curve(line: &Line, panel: &Panel) -> Value {
    let (x, y) = (panel.x.scale, panel.y.scale);
    let both = stretched(x) && stretched(y);
    let name =
        if line.label.is_empty() { String::new() } else { format!("<b>{}</b><br>", html(&line.label)) };
    let mut trace = json!({
        "type": "scatter",
        "name": html(&line.label),
        "x": floats(&at_least_a_gap(placed(x, &line.x)), None),
        "y": floats(&at_least_a_gap(placed(y, &line.y)), None),
        "connectgaps": false,
        "hovertemplate": format!(
            "{name}{}: {}<br>{}: {}<extra></extra>",
            html(&panel.x.label), hover_value("x", if both { "customdata[0]" } else { "customdata" }, x),
            html(&panel.y.label), hover_value("y", if both { "customdata[1]" } else { "customdata" }, y),
        ),
    });
    if let Some(own) = &line.swing {
        trace["meta"] = swing(own);
    }
    match (stretched(x), stretched(y)) {
        (false, false) => {}
        (true, false) => trace["customdata"] = floats(&line.x, None),
        (false, true) => trace["customdata"] = floats(&line.y, None),
        (true, true) => {
            let pairs: Vec<f64> = line.x.iter().zip(&line.y).flat_map(|(x, y)| [*x, *y]).collect();
            trace["customdata"] = floats(&pairs, Some(&format!("{}, 2", line.x.len())));
        }
    }
    trace
}

/// Plotly keeps no legend entry for an empty curve; one gap is drawn alike and keeps it.
fn at_least_a_gap(values: Vec<f64>) -> Vec<f64> {
    if values.is_empty() { vec![f64::NAN] } else { values }
}

/// Whether values are handed over as the axis stretches them, because plotly lacks such an axis.
fn stretched(scale: Scale) -> bool {
    matches!(scale, Scale::SymmetricLog { .. })
}

/// Values as they are handed over.
fn placed(scale: Scale, values: &[f64]) -> Vec<f64> {
    values.iter().map(|value| if stretched(scale) { stretch(scale, *value) } else { *value }).collect()
}

fn hover_value(own: &str, custom: &str, scale: Scale) -> String {
    format!("%{{{}:.5~g}}", if stretched(scale) { custom } else { own })
}

fn class_map(map: &ClassMap, panel: &Panel) -> Value {
    let count = map.classes.len().max(1) as f64;
    let colours: Vec<Value> = map
        .classes
        .iter()
        .enumerate()
        .flat_map(|(index, class)| {
            let colour = match class.role {
                Role::Unresolved => "rgba(255,255,255,0)".to_owned(),
                role => role.colour().to_string(),
            };
            let (from, to) = (index as f64 / count, (index + 1) as f64 / count);
            [json!([from, colour]), json!([to, colour])]
        })
        .collect();
    let classes: Vec<String> = map.classes.iter().map(|class| html(&class.label)).collect();
    let mut trace = json!({
        "type": "heatmap", "name": "",
        "x": floats(&placed(panel.x.scale, &map.x), None),
        "y": floats(&placed(panel.y.scale, &map.y), None),
        "z": { "runs": STANDARD.encode(runs(&map.codes)), "shape": shape(&map.x, &map.y) },
        "zmin": -0.5, "zmax": count - 0.5, "showscale": false,
        "meta": { "classes": classes },
        "hovertemplate": format!("<b>%{{text}}</b><br>{}: %{{x:.4~g}}<br>{}: %{{y:.4~g}}<extra></extra>", html(&panel.x.label), html(&panel.y.label)),
    });
    if !colours.is_empty() {
        trace["colorscale"] = json!(colours);
    }
    trace
}

/// Codes as runs: a code, and in two bytes, the lower first, how often it follows.
fn runs(codes: &[u8]) -> Vec<u8> {
    let most = usize::from(u16::MAX);
    let same = codes.chunk_by(|a, b| a == b).flat_map(|run| run.chunks(most));
    same.flat_map(|run| {
        let [low, high] = (run.len() as u16).to_le_bytes();
        [run[0], low, high]
    })
    .collect()
}

fn value_map(map: &ValueMap, panel: &Panel, index: usize) -> Value {
    let scale = map.bar.scale;
    let z: Vec<f64> = map.z.iter().map(|z| stretch(scale, *z)).collect();
    let shape = shape(&map.x, &map.y);
    let own = if scale == Scale::Linear { "z" } else { "customdata" };
    let mut trace = json!({
        "type": "heatmap", "name": "",
        "x": floats(&placed(panel.x.scale, &map.x), None),
        "y": floats(&placed(panel.y.scale, &map.y), None),
        "z": floats(&z, Some(&shape)),
        "coloraxis": format!("coloraxis{}", suffix(index)),
        "hovertemplate": format!(
            "{}: %{{x:.4~g}}<br>{}: %{{y:.4~g}}<br>{}: %{{{own}:.5~g}}<extra></extra>",
            html(&panel.x.label), html(&panel.y.label), html(&map.bar.label),
        ),
    });
    if scale != Scale::Linear {
        trace["customdata"] = floats(&map.z, Some(&shape));
    }
    trace
}

/// Rows and columns, as plotly reads them.
fn shape(x: &[f64], y: &[f64]) -> String {
    format!("{}, {}", y.len(), x.len())
}

/// A typed array, which is shorter than digits and knows NaN.
fn floats(values: &[f64], shape: Option<&str>) -> Value {
    let bytes: Vec<u8> = values.iter().flat_map(|value| value.to_le_bytes()).collect();
    let mut array = json!({ "dtype": "f8", "bdata": STANDARD.encode(bytes) });
    if let Some(shape) = shape {
        array["shape"] = json!(shape);
    }
    array
}
