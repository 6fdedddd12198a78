//! The plotly layout: axes, where panels stand, reference lines, regions and notes.

use super::suffix;
use crate::figure::{Direction, Figure, Layer, Panel, Scale};
use crate::layout::{DrawnAxis, DrawnPanel};
use crate::markup::html;
use crate::palette::{INK, QUIET};
use crate::scale::stretch;
use crate::typeface::FAMILIES;
use serde_json::{Value, json};

/// Sizes in CSS pixels.
const PANEL_HEIGHT: f64 = 290.0;
const ROW_GAP: f64 = 84.0;
const TOP: f64 = 40.0;
const BOTTOM: f64 = 58.0;
const LEGEND_ROOM: f64 = 64.0;

/// The layout with `columns` panels in a row.
pub(super) fn layout(figure: &Figure, drawn: &[DrawnPanel], columns: usize) -> Value {
    let rows = drawn.len().div_ceil(columns).max(1) as f64;
    let plot_height = rows * PANEL_HEIGHT + (rows - 1.0) * ROW_GAP;
    let bottom = BOTTOM + LEGEND_ROOM;
    let mut layout = json!({
        "height": TOP + plot_height + bottom,
        "margin": { "l": 66, "r": 16, "t": TOP, "b": bottom, "pad": 0 },
        "font": { "family": FAMILIES, "size": 12.5, "color": INK.to_string() },
        "paper_bgcolor": "#ffffff", "plot_bgcolor": "#ffffff",
        "hovermode": "closest", "dragmode": "zoom",
        "legend": {
            "orientation": "h", "x": 0, "xanchor": "left", "y": -(BOTTOM - 4.0) / plot_height, "yanchor": "top",
        },
        "shapes": [], "annotations": [],
    });
    let mut shapes = Vec::new();
    let mut notes = Vec::new();
    for (index, (panel, drawn)) in figure.panels.iter().zip(drawn).enumerate() {
        let place = place(index, columns, plot_height, drawn.bar.is_some());
        let name = suffix(index);
        layout[format!("xaxis{name}")] = axis(&drawn.x, place.across, &format!("y{name}"));
        layout[format!("yaxis{name}")] = axis(&drawn.y, place.up, &format!("x{name}"));
        notes.extend(heading(drawn, &place));
        for layer in &panel.layers {
            shapes.extend(shape(layer, panel, &name));
            notes.extend(note(layer, panel, &name));
        }
    }
    layout["shapes"] = json!(shapes);
    layout["annotations"] = json!(notes);
    layout
}

/// Where a panel stands, as fractions of the plotting area.
struct Place {
    across: (f64, f64),
    up: (f64, f64),
}

fn place(index: usize, columns: usize, plot_height: f64, has_bar: bool) -> Place {
    const COLUMN_GAP: f64 = 0.12;
    const BAR_ROOM: f64 = 0.14;
    let (column, row) = ((index % columns) as f64, (index / columns) as f64);
    let share = (1.0 - COLUMN_GAP * (columns as f64 - 1.0)) / columns as f64;
    let left = column * (share + COLUMN_GAP);
    let width = if has_bar { share * (1.0 - BAR_ROOM) } else { share };
    let top = 1.0 - row * (PANEL_HEIGHT + ROW_GAP) / plot_height;
    Place { across: (left, left + width), up: ((top - PANEL_HEIGHT / plot_height).max(0.0), top) }
}

fn axis(drawn: &DrawnAxis, domain: (f64, f64), anchor: &str) -> Value {
    let scale = drawn.placed.scale;
    let mut axis = json!({
        "domain": [domain.0, domain.1], "anchor": anchor,
        "range": [stretch(scale, drawn.placed.from), stretch(scale, drawn.placed.to)],
        "title": { "text": html(&drawn.source_label), "standoff": 8 },
        "showline": true, "mirror": "ticks", "linecolor": INK.to_string(), "linewidth": 1,
        "ticks": "inside", "ticklen": 5, "tickcolor": INK.to_string(),
        "minor": { "ticks": "inside", "ticklen": 3, "tickcolor": INK.to_string() },
        "showgrid": false, "zeroline": false, "exponentformat": "power", "minexponent": 4,
        "automargin": true,
    });
    match scale {
        Scale::Linear => axis["type"] = json!("linear"),
        Scale::Log => axis["type"] = json!("log"),
        Scale::SymmetricLog { .. } => {
            let ticks = drawn.ticks.major.iter();
            axis["type"] = json!("linear");
            axis["tickvals"] = ticks.clone().map(|tick| stretch(scale, tick.value)).collect();
            axis["ticktext"] = ticks.map(|tick| html(&tick.label)).collect();
            axis["minor"]["tickvals"] =
                drawn.ticks.minor.iter().map(|value| stretch(scale, *value)).collect();
        }
    }
    axis
}

/// Letter and title above a panel.
fn heading(drawn: &DrawnPanel, place: &Place) -> Option<Value> {
    let letter = if drawn.letter.is_empty() { String::new() } else { format!("<b>{}</b>  ", drawn.letter) };
    let text = letter + &html(&drawn.title);
    (!text.is_empty()).then(|| {
        json!({
            "text": text, "showarrow": false, "xref": "paper", "yref": "paper",
            "x": place.across.0, "y": place.up.1, "xanchor": "left", "yanchor": "bottom", "yshift": 3,
            "font": { "size": 13.5 },
        })
    })
}

/// Reference lines and regions.
fn shape(layer: &Layer, panel: &Panel, name: &str) -> Option<Value> {
    let (x, y) = (panel.x.scale, panel.y.scale);
    match layer {
        Layer::Rule(rule) => {
            let dotted = json!({ "color": QUIET.to_string(), "width": 1, "dash": "dot" });
            let label = |position: &str| {
                json!({
                    "text": html(&rule.label), "textposition": position, "textangle": 0,
                    "font": { "color": QUIET.to_string(), "size": 11.5 },
                })
            };
            Some(match rule.direction {
                Direction::Vertical => json!({
                    "type": "line", "xref": format!("x{name}"), "yref": format!("y{name} domain"),
                    "x0": shape_value(x, rule.value)?, "x1": shape_value(x, rule.value)?, "y0": 0, "y1": 1,
                    "line": dotted, "label": label("end"),
                }),
                Direction::Horizontal => json!({
                    "type": "line", "xref": format!("x{name} domain"), "yref": format!("y{name}"),
                    "x0": 0, "x1": 1, "y0": shape_value(y, rule.value)?, "y1": shape_value(y, rule.value)?,
                    "line": dotted, "label": label("start"),
                }),
            })
        }
        Layer::Region(region) => {
            let reference =
                |axis: &str, bounded: bool| format!("{axis}{name}{}", if bounded { "" } else { " domain" });
            let ends = |span: Option<(f64, f64)>, scale: Scale| match span {
                Some((from, to)) => Some((shape_value(scale, from)?, shape_value(scale, to)?)),
                None => Some((0.0, 1.0)),
            };
            let ((x0, x1), (y0, y1)) = (ends(region.x, x)?, ends(region.y, y)?);
            Some(json!({
                "type": "rect", "layer": "below", "line": { "width": 0 },
                "fillcolor": region.role.colour().to_string(),
                "xref": reference("x", region.x.is_some()), "yref": reference("y", region.y.is_some()),
                "x0": x0, "x1": x1, "y0": y0, "y1": y1,
            }))
        }
        _ => None,
    }
}

/// Shapes take a log axis's own values, but those of a symmetric log axis as they are stretched.
fn shape_value(scale: Scale, value: f64) -> Option<f64> {
    let value = if matches!(scale, Scale::SymmetricLog { .. }) { stretch(scale, value) } else { value };
    value.is_finite().then_some(value)
}

fn note(layer: &Layer, panel: &Panel, name: &str) -> Option<Value> {
    let Layer::Note(note) = layer else { return None };
    let (x, y) = (stretch(panel.x.scale, note.x), stretch(panel.y.scale, note.y));
    (x.is_finite() && y.is_finite()).then(|| {
        json!({
            "text": html(&note.text), "showarrow": false, "xanchor": "left",
            "xref": format!("x{name}"), "yref": format!("y{name}"), "x": x, "y": y,
            "font": { "color": QUIET.to_string(), "size": 11.5 }, "bgcolor": "rgba(255,255,255,0.7)",
        })
    })
}
