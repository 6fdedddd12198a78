//! What stands in a plotly layout besides axes: headings, reference lines, regions, notes and hatches.

use crate::figure::{Direction, Layer, Panel, Scale};
use crate::layout::DrawnPanel;
use crate::markup::html;
use crate::palette::{QUIET, Role};
use crate::scale::stretch;
use base64::{Engine, engine::general_purpose::STANDARD};
use serde_json::{Value, json};

/// The hatch under a map whose cells without an answer are clear.
pub(super) fn hatch(layer: &Layer, name: &str) -> Option<Value> {
    let open = match layer {
        Layer::Classes(map) => map.classes.iter().any(|class| class.role == Role::Unresolved),
        Layer::Values(map) => map.z.iter().any(|z| !z.is_finite()),
        _ => false,
    };
    let drawing = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"800\" height=\"600\"><defs><pattern id=\"h\" width=\"7\" \
         height=\"7\" patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(45)\"><rect width=\"2\" height=\"7\" \
         fill=\"{}\"/></pattern></defs><rect width=\"800\" height=\"600\" fill=\"url(#h)\"/></svg>",
        Role::Unresolved.colour()
    );
    open.then(|| {
        json!({
            "source": format!("data:image/svg+xml;base64,{}", STANDARD.encode(drawing)),
            "xref": format!("x{name} domain"), "yref": format!("y{name} domain"), "layer": "below",
            "x": 0, "y": 1, "sizex": 1, "sizey": 1, "sizing": "fill",
        })
    })
}

/// Letter and title, so far above a panel whose upper left corner stands here.
pub(super) fn heading(drawn: &DrawnPanel, corner: (f64, f64), rise: f64) -> Option<Value> {
    let letter = if drawn.letter.is_empty() { String::new() } else { format!("<b>{}</b>  ", drawn.letter) };
    let text = letter + &html(&drawn.title);
    (!text.is_empty()).then(|| {
        json!({
            "text": text, "showarrow": false, "xref": "paper", "yref": "paper",
            "x": corner.0, "y": corner.1, "xanchor": "left", "yanchor": "bottom", "yshift": 3.0 + rise,
            "font": { "size": 13.5 },
        })
    })
}

/// Reference lines and regions.
pub(super) fn shape(layer: &Layer, panel: &Panel, name: &str) -> Option<Value> {
    let (x, y) = (panel.x.scale, panel.y.scale);
    match layer {
        Layer::Rule(rule) => {
            let dotted = json!({ "color": QUIET.to_string(), "width": 1, "dash": "dot" });
            let label = |position: &str, anchor: &str| {
                json!({
                    "text": html(&rule.label), "textposition": position, "textangle": 0, "padding": 4,
                    "xanchor": "left", "yanchor": anchor,
                    "font": { "color": QUIET.to_string(), "size": 11.5 },
                })
            };
            Some(match rule.direction {
                Direction::Vertical => json!({
                    "type": "line", "xref": format!("x{name}"), "yref": format!("y{name} domain"),
                    "x0": shape_value(x, rule.value)?, "x1": shape_value(x, rule.value)?, "y0": 0, "y1": 1,
                    "line": dotted, "label": label("end", "top"),
                }),
                Direction::Horizontal => json!({
                    "type": "line", "xref": format!("x{name} domain"), "yref": format!("y{name}"),
                    "x0": 0, "x1": 1, "y0": shape_value(y, rule.value)?, "y1": shape_value(y, rule.value)?,
                    "line": dotted, "label": label("start", "bottom"),
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

/// A text at a place.
pub(super) fn note(layer: &Layer, panel: &Panel, name: &str) -> Option<Value> {
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
