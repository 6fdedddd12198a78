//! A figure for the browser: the JSON that plotly.js draws, with hover values and zoom.

mod arrange;
mod marks;
mod traces;

use crate::error::ReportError;
use crate::figure::Figure;
use crate::layout::layout;
use crate::validate;
use serde_json::{Value, json};

/// The figure as `{ "data", "layout", "narrow" }` for plotly.js.
///
/// `narrow` is the layout for a small screen, with the panels in one column. Numbers are typed arrays
/// (`{ dtype, bdata, shape }`, little-endian base64); `{ same: [trace, key] }` is the array of an earlier trace. A class
/// map holds the codes of its cells as `z`, in runs (`{ runs, shape }`, base64 of three bytes each: a code, and how often it
/// follows), and the names of its classes as `meta.classes`; the page makes codes and hover `text` of them. Values on a
/// swinging line has the real and imaginary parts of its amplitude as `meta.swing`; the page makes frames of them. Values on a
/// symmetric log axis are stretched as the axis is; their own values are in `customdata`, in pairs where both axes are.
///
/// # Errors
/// As [`crate::svg`].
pub fn plotly(figure: &Figure) -> Result<Value, ReportError> {
    validate::check(figure)?;
    let drawn = layout(figure).panels;
    let wide = figure.columns.min(figure.panels.len()).max(1);
    Ok(json!({
        "data": traces::of_figure(figure),
        "layout": arrange::layout(figure, &drawn, wide, false),
        "narrow": arrange::layout(figure, &drawn, 1, true),
    }))
}

/// What plotly appends to `x` and `y` to name the axes of a panel.
fn suffix(panel: usize) -> String {
    if panel == 0 { String::new() } else { (panel + 1).to_string() }
}
