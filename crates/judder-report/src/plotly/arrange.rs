//! The plotly layout: axes, where panels stand, colour bars, reference lines, regions and notes.

use super::{marks, suffix};
use crate::figure::{Figure, Layer, Scale, ValueMap};
use crate::layout::{DrawnAxis, DrawnPanel};
use crate::legend;
use crate::markup::html;
use crate::palette::{INK, QUIET};
use crate::scale::stretch;
use crate::second_axis::DrawnSecond;
use crate::ticks::{Ticks, ticks};
use crate::typeface::{FAMILIES, width};
use serde_json::{Value, json};

/// Sizes in CSS pixels.
const SINGLE_HEIGHT: f64 = 400.0;
const PANEL_HEIGHT: f64 = 285.0;
const ROW_GAP: f64 = 84.0;
const TOP: f64 = 34.0;
/// Room for ticks and label of a second axis.
const SECOND: f64 = 40.0;
const BOTTOM: f64 = 58.0;
const FONT_SIZE: f64 = 12.5;
/// Width for which legends are reckoned, on a large and on a small screen.
const WIDE: f64 = 800.0;
const NARROW: f64 = 290.0;
/// Labels for which a horizontal axis has room on a small screen.
const SMALL_ROOM: usize = 6;
/// What a colour bar takes from the width of its panel.
const BAR_ROOM: f64 = 0.14;

/// The layout with `columns` panels in a row, for a large or a small screen.
pub(super) fn layout(figure: &Figure, drawn: &[DrawnPanel], columns: usize, small: bool) -> Value {
    let rows = drawn.len().div_ceil(columns).max(1) as f64;
    let height = if columns == 1 && !small { SINGLE_HEIGHT } else { PANEL_HEIGHT };
    let top = if drawn.iter().any(|panel| panel.second.is_some()) { SECOND } else { 0.0 };
    let row_gap = ROW_GAP + top;
    let plot_height = rows * height + (rows - 1.0) * row_gap;
    let bottom = BOTTOM + legend_height(figure, if small { NARROW } else { WIDE });
    let mut layout = json!({
        "height": TOP + top + plot_height + bottom,
        "margin": { "l": 66, "r": 16, "t": TOP + top, "b": bottom, "pad": 0 },
        "font": { "family": FAMILIES, "size": FONT_SIZE, "color": INK.to_string() },
        "paper_bgcolor": "#ffffff", "plot_bgcolor": "#ffffff",
        "hovermode": "closest", "dragmode": "zoom",
        "hoverlabel": {
            "bgcolor": "#ffffff", "bordercolor": QUIET.to_string(), "align": "left",
            "font": { "family": FAMILIES, "size": 12, "color": INK.to_string() },
        },
        "legend": {
            "orientation": "h", "x": 0, "xanchor": "left", "y": -(BOTTOM - 4.0) / plot_height, "yanchor": "top",
        },
    });
    let (mut shapes, mut notes, mut images) = (Vec::new(), Vec::new(), Vec::new());
    for (index, (panel, drawn)) in figure.panels.iter().zip(drawn).enumerate() {
        let place = place((index, columns), (height, row_gap), plot_height, drawn.bar.is_some());
        let name = suffix(index);
        let x_ticks = if small && !drawn.x.is_named {
            ticks(&drawn.x.placed, SMALL_ROOM)
        } else {
            drawn.x.ticks.clone()
        };
        layout[format!("xaxis{name}")] = axis(&drawn.x, &x_ticks, place.across, &format!("y{name}"));
        layout[format!("yaxis{name}")] = axis(&drawn.y, &drawn.y.ticks, place.up, &format!("x{name}"));
        if let Some(second) = &drawn.second {
            // its upper side belongs to the second axis
            layout[format!("xaxis{name}")]["mirror"] = json!(true);
            layout[format!("xaxis{}", suffix(figure.panels.len() + index))] =
                second_axis(second, &layout[format!("xaxis{name}")], &name);
        }
        let rise = if drawn.second.is_some() { SECOND } else { 0.0 };
        notes.extend(marks::heading(drawn, (place.across.0, place.up.1), rise));
        for layer in &panel.layers {
            shapes.extend(marks::shape(layer, panel, &name));
            notes.extend(marks::note(layer, panel, &name));
            images.extend(marks::hatch(layer, &name));
            if let (Layer::Values(map), Some(bar)) = (layer, &drawn.bar) {
                layout[format!("coloraxis{name}")] = colour_axis(map, bar, &place);
            }
        }
    }
    layout["shapes"] = json!(shapes);
    layout["annotations"] = json!(notes);
    layout["images"] = json!(images);
    layout
}

/// Room for the rows of the legend, which plotly fills from the left.
fn legend_height(figure: &Figure, room: f64) -> f64 {
    const ROW: f64 = 24.0;
    const SAMPLE: f64 = 46.0;
    let entries = legend::merge(figure.panels.iter().flat_map(legend::entries));
    let widest = entries.iter().map(|entry| SAMPLE + width(&entry.label, FONT_SIZE)).fold(0.0, f64::max);
    let in_a_row = (room / widest.max(1.0)).floor().max(1.0);
    (entries.len() as f64 / in_a_row).ceil() * ROW
}

/// Where a panel stands, as fractions of the plotting area.
struct Place {
    across: (f64, f64),
    up: (f64, f64),
}

fn place(
    (index, columns): (usize, usize),
    (height, row_gap): (f64, f64),
    plot_height: f64,
    has_bar: bool,
) -> Place {
    const COLUMN_GAP: f64 = 0.12;
    let (column, row) = ((index % columns) as f64, (index / columns) as f64);
    let share = (1.0 - COLUMN_GAP * (columns as f64 - 1.0)) / columns as f64;
    let left = column * (share + COLUMN_GAP);
    let width = if has_bar { share * (1.0 - BAR_ROOM) } else { share };
    let top = 1.0 - row * (height + row_gap) / plot_height;
    Place { across: (left, left + width), up: ((top - height / plot_height).max(0.0), top) }
}

/// Colours and colour bar of a value map.
fn colour_axis(map: &ValueMap, bar: &DrawnAxis, place: &Place) -> Value {
    let scale = map.bar.scale;
    let shades = map.colours.stops();
    let colours: Vec<Value> = shades
        .iter()
        .enumerate()
        .map(|(index, colour)| json!([index as f64 / (shades.len() - 1) as f64, colour.to_string()]))
        .collect();
    let labelled = bar.ticks.major.iter().filter(|tick| !tick.label.is_empty());
    json!({
        "cmin": stretch(scale, bar.placed.from), "cmax": stretch(scale, bar.placed.to), "colorscale": colours,
        "colorbar": {
            "x": place.across.1 + 0.015, "xanchor": "left", "xpad": 0, "ypad": 0,
            "y": (place.up.0 + place.up.1) / 2.0, "yanchor": "middle", "len": place.up.1 - place.up.0,
            "thickness": 12, "outlinewidth": 0.7, "ticks": "inside",
            "title": { "text": html(&bar.label), "side": "right" },
            "tickvals": labelled.clone().map(|tick| stretch(scale, tick.value)).collect::<Vec<f64>>(),
            "ticktext": labelled.map(|tick| html(&tick.label)).collect::<Vec<String>>(),
        },
    })
}

fn axis(drawn: &DrawnAxis, ticks: &Ticks, domain: (f64, f64), anchor: &str) -> Value {
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
        Scale::Linear => {
            axis["type"] = json!("linear");
            if drawn.is_named {
                fix_ticks(&mut axis, ticks, |value| value);
            }
        }
        Scale::Log => {
            axis["type"] = json!("log");
            fix_ticks(&mut axis, ticks, |value| value);
        }
        Scale::SymmetricLog { .. } => {
            axis["type"] = json!("linear");
            fix_ticks(&mut axis, ticks, |value| stretch(scale, value));
        }
    }
    axis
}

/// An axis that lies over that of the abscissae, moves with it, and is labelled above.
fn second_axis(second: &DrawnSecond, below: &Value, name: &str) -> Value {
    let labelled = second.major.iter().filter(|tick| !tick.label.is_empty());
    json!({
        "overlaying": format!("x{name}"), "matches": format!("x{name}"), "anchor": format!("y{name}"), "side": "top",
        "type": below["type"], "range": below["range"],
        "title": { "text": html(&second.label), "standoff": 6 },
        "ticks": "inside", "ticklen": 5, "tickcolor": INK.to_string(), "tickmode": "array",
        "tickvals": labelled.clone().map(|tick| tick.value).collect::<Vec<f64>>(),
        "ticktext": labelled.map(|tick| html(&tick.label)).collect::<Vec<String>>(),
        "showgrid": false, "zeroline": false,
    })
}

/// Gives an axis the ticks of the drawing, which plotly's own would only resemble.
fn fix_ticks(axis: &mut Value, ticks: &Ticks, place: impl Fn(f64) -> f64) {
    axis["tickmode"] = json!("array");
    axis["tickvals"] = ticks.major.iter().map(|tick| place(tick.value)).collect();
    axis["ticktext"] = ticks.major.iter().map(|tick| html(&tick.label)).collect();
    axis["minor"]["tickmode"] = json!("array");
    axis["minor"]["tickvals"] = ticks.minor.iter().map(|value| place(*value)).collect();
}
