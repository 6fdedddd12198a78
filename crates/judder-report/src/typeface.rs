//! The bundled typeface: its files, and how wide a label is when set in it.
//!
//! Noto Sans with the mathematical signs of Noto Sans Math (SIL Open Font License, see `assets/fonts`): it places
//! hats, tildes and dots over Latin and Greek letters, which most system fonts do not.

use crate::markup::{self, TextSpan};
use skrifa::instance::{LocationRef, Size};
use skrifa::{FontRef, MetadataProvider};

pub(crate) const REGULAR: &[u8] = include_bytes!("../assets/fonts/NotoSans-Regular.ttf");
pub(crate) const ITALIC: &[u8] = include_bytes!("../assets/fonts/NotoSans-Italic.ttf");
pub(crate) const BOLD: &[u8] = include_bytes!("../assets/fonts/NotoSans-Bold.ttf");
/// The same fonts for a browser.
pub(crate) const REGULAR_WEB: &[u8] = include_bytes!("../assets/fonts/NotoSans-Regular.woff2");
pub(crate) const BOLD_WEB: &[u8] = include_bytes!("../assets/fonts/NotoSans-Bold.woff2");
pub(crate) const ITALIC_WEB: &[u8] = include_bytes!("../assets/fonts/NotoSans-Italic.woff2");

/// The bundled font of this file name as a browser reads it (WOFF 2), none for other names.
pub fn web_font(name: &str) -> Option<&'static [u8]> {
    match name {
        "NotoSans-Regular.woff2" => Some(REGULAR_WEB),
        "NotoSans-Bold.woff2" => Some(BOLD_WEB),
        "NotoSans-Italic.woff2" => Some(ITALIC_WEB),
        _ => None,
    }
}

/// Families to ask for where the bundled files are not at hand, the most alike first.
pub(crate) const FAMILIES: &str = "Noto Sans, Open Sans, Segoe UI, DejaVu Sans, Arial, sans-serif";

/// Size of axis labels and panel titles, in points.
pub(crate) const LABEL_SIZE: f64 = 9.0;
/// Size of tick labels, legends and notes, in points.
pub(crate) const SMALL_SIZE: f64 = 8.0;

/// Size of a sub- or superscript relative to the text around it.
pub(crate) const SCRIPT: f64 = 0.72;
/// Rise of a superscript and fall of a subscript, relative to the text around it.
pub(crate) const RISE: f64 = 0.38;
/// See [`RISE`].
pub(crate) const FALL: f64 = 0.22;

/// Size of a span in a label of this size.
pub(crate) fn span_size(span: &TextSpan, size: f64) -> f64 {
    size * SCRIPT.powi(i32::from(span.level.unsigned_abs()))
}

/// Height of a span's baseline above that of a label of this size.
pub(crate) fn span_rise(span: &TextSpan, size: f64) -> f64 {
    let shift = if span.level < 0 { -FALL } else { RISE };
    (0..i32::from(span.level.unsigned_abs())).map(|depth| shift * size * SCRIPT.powi(depth)).sum()
}

/// Width of a label set at `size`, in the unit of `size`.
pub(crate) fn width(label: &str, size: f64) -> f64 {
    markup::parse(label).iter().map(|span| span_width(span, span_size(span, size))).sum()
}

/// Width of a span; the font is opened each time because that only reads its table directory.
fn span_width(span: &TextSpan, size: f64) -> f64 {
    // what an average letter takes, for the case that a glyph is missing
    const AVERAGE: f64 = 0.55;
    let Ok(font) = FontRef::new(if span.italic { ITALIC } else { REGULAR }) else {
        return AVERAGE * size * span.text.chars().count() as f64;
    };
    let metrics = font.glyph_metrics(Size::new(1000.0), LocationRef::default());
    let characters = font.charmap();
    span.text
        .chars()
        .map(|character| {
            let advance = characters.map(character).and_then(|glyph| metrics.advance_width(glyph));
            size * advance.map_or(AVERAGE, |advance| f64::from(advance) / 1000.0)
        })
        .sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn widths_follow_the_glyphs() {
        assert!(width("iii", 10.0) < width("MMM", 10.0));
        assert!((width("aa", 20.0) - 4.0 * width("a", 10.0)).abs() < 1e-9);
        assert!(width("10^{−3}", 10.0) < width("10−3", 10.0));
        assert_eq!(width("ŷ", 10.0), width("y\u{302}", 10.0), "a combining hat takes no room");
    }
}
