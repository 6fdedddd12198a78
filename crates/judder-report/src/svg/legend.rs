//! Legends as drawings.

use super::document::{SvgDocument, rectangle};
use super::layers::{line_attributes, marker_path};
use super::text::{Anchor, Text};
use super::written::number;
use crate::figure::Panel;
use crate::layout::{DrawnPanel, Frame};
use crate::legend::{INSET, LegendEntry, ROW, SAMPLE, SAMPLE_GAP, entries};
use crate::palette::{GROUND, QUIET, Role, Style};
use crate::typeface::SMALL_SIZE;

/// Draws the legend of a panel, where it stands inside the frame.
pub(super) fn draw_inside(document: &mut SvgDocument, panel: &Panel, drawn: &DrawnPanel) {
    let Some(place) = drawn.legend else { return };
    let (x, y) = (drawn.frame.x + place.x, drawn.frame.y + place.y);
    let ground = Frame { x, y, width: place.width, height: place.height };
    document.put(format_args!("{}", rectangle(ground, &format!("fill=\"{GROUND}\" fill-opacity=\"0.88\""))));
    for (index, entry) in entries(panel).iter().enumerate() {
        draw_entry(document, entry, x + INSET, y + INSET - 1.0 + index as f64 * ROW);
    }
}

/// Draws an entry whose row begins at (`x`, `y`).
pub(super) fn draw_entry(document: &mut SvgDocument, entry: &LegendEntry, x: f64, y: f64) {
    let middle = y + ROW / 2.0;
    if let Some(role) = entry.area {
        draw_swatch(document, role, x, middle);
    }
    if let Some(style) = entry.line {
        let attributes = line_attributes(&style);
        let (from, to, y) = (number(x), number(x + SAMPLE), number(middle));
        document.put(format_args!("<path d=\"M{from} {y}H{to}\" {attributes}/>"));
    }
    if let Some(style) = entry.marker {
        let alone = Style { crowded: false, ..style };
        let place = [((x + SAMPLE / 2.0, middle), 1.0)];
        document.put(format_args!("{}", marker_path(&alone, false, place.into_iter())));
    }
    let text = Text::new(&entry.label, SMALL_SIZE).anchored(Anchor::Start);
    document.text(&text, x + SAMPLE + SAMPLE_GAP, middle + 0.36 * SMALL_SIZE);
}

fn draw_swatch(document: &mut SvgDocument, role: Role, x: f64, middle: f64) {
    let fill = document.area_fill(role);
    document.put(format_args!(
        "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"8\" fill=\"{fill}\" stroke=\"{QUIET}\" stroke-width=\"0.4\"/>",
        number(x + 4.0),
        number(middle - 4.0),
        number(SAMPLE - 4.0),
    ));
}
