//! A figure as SVG: texts stay texts, maps are embedded pictures, one unit is a point (1/72 inch).

mod axes;
mod document;
mod layers;
mod legend;
mod path;
mod text;
mod written;

use crate::error::ReportError;
use crate::figure::{Figure, Layer, Panel};
use crate::layout::{DrawnPanel, layout};
use crate::validate;
use document::SvgDocument;

/// The figure as an SVG document, the same bytes for the same figure.
///
/// Sizes are in points; the typeface is named by family (`Noto Sans` first), not embedded.
///
/// # Errors
/// What [`ReportError`] says of a figure: its name, a range, or arrays that do not fit together.
pub fn svg(figure: &Figure) -> Result<String, ReportError> {
    validate::check(figure)?;
    let layout = layout(figure);
    let mut document = SvgDocument::open(figure, &layout);
    for (index, (panel, drawn)) in figure.panels.iter().zip(&layout.panels).enumerate() {
        draw_panel(&mut document, panel, drawn, index);
    }
    for (entry, x, y) in &layout.legend {
        legend::draw_entry(&mut document, entry, *x, *y);
    }
    Ok(document.close())
}

/// Maps and regions at the back, then curves, then the frame with its ticks, then what explains them.
fn draw_panel(document: &mut SvgDocument, panel: &Panel, drawn: &DrawnPanel, index: usize) {
    document.open_clip(drawn.frame, index);
    let is_ground = |layer: &&Layer| matches!(layer, Layer::Classes(_) | Layer::Values(_) | Layer::Region(_));
    let on_map = panel.layers.iter().any(|layer| is_ground(&layer));
    for layer in panel.layers.iter().filter(is_ground) {
        layers::draw_ground(document, layer, drawn);
    }
    // all rims before all curves: no rim cuts a curve
    let name = |layer: usize| format!("curve-{index}-{layer}");
    for (number, layer) in panel.layers.iter().enumerate().filter(|_| on_map) {
        layers::draw_rim(document, layer, drawn, &name(number));
    }
    let has_curves = panel.layers.iter().any(|layer| matches!(layer, Layer::Line(_)));
    for (number, layer) in panel.layers.iter().enumerate() {
        match layer {
            Layer::Line(line) if on_map => layers::draw_over_rim(document, line, drawn, &name(number)),
            _ => layers::draw_curve(document, layer, drawn, has_curves),
        }
    }
    document.close_group();
    axes::draw(document, drawn, index);
    if let Some(Layer::Values(map)) = panel.layers.iter().find(|layer| matches!(layer, Layer::Values(_))) {
        axes::draw_bar(document, map, drawn);
    }
    for layer in &panel.layers {
        layers::draw_text(document, layer, drawn);
    }
    legend::draw_inside(document, panel, drawn);
}
