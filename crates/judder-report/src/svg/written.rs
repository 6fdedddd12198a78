//! How numbers and pieces are written.

use std::fmt::{Arguments, Write};

/// Adds a piece to a text.
pub(super) fn append(out: &mut String, piece: Arguments<'_>) {
    // writing to a String cannot fail
    let _ = out.write_fmt(piece);
}

/// A coordinate to a hundredth of a point, as short as it goes.
pub(super) fn number(value: f64) -> String {
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}
