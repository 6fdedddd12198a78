//! Labels as SVG text: one `text` element, a `tspan` for every change of slope, size or height.

use super::written::{append, number};
use crate::markup::{TextSpan, escape, parse};
use crate::palette::{Colour, GROUND};
use crate::typeface::{SMALL_SIZE, span_rise, span_size};

/// Which part of a label stands at its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

/// A label and how it is set.
pub(super) struct Text {
    spans: Vec<TextSpan>,
    size: f64,
    anchor: Anchor,
    bold: bool,
    upright: bool,
    halo: bool,
    colour: Option<Colour>,
}

impl Text {
    /// A centred label.
    pub(super) fn new(label: &str, size: f64) -> Self {
        Self {
            spans: parse(label),
            size,
            anchor: Anchor::Middle,
            bold: false,
            upright: false,
            halo: false,
            colour: None,
        }
    }

    pub(super) fn anchored(self, anchor: Anchor) -> Self {
        Self { anchor, ..self }
    }

    pub(super) fn bold(self) -> Self {
        Self { bold: true, ..self }
    }

    /// Runs from below to above, as the label of a vertical axis.
    pub(super) fn upright(self) -> Self {
        Self { upright: true, ..self }
    }

    /// With a white rim, to be read on a map.
    pub(super) fn with_halo(self) -> Self {
        Self { halo: true, ..self }
    }

    pub(super) fn coloured(self, colour: Colour) -> Self {
        Self { colour: Some(colour), ..self }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.spans.is_empty()
    }

    /// The `text` element with its anchor at (`x`, `y`).
    pub(super) fn element(&self, x: f64, y: f64) -> String {
        let mut attributes = String::new();
        if self.anchor != Anchor::Start {
            let name = if self.anchor == Anchor::Middle { "middle" } else { "end" };
            append(&mut attributes, format_args!(" text-anchor=\"{name}\""));
        }
        if self.bold {
            attributes.push_str(" font-weight=\"bold\"");
        }
        if let Some(colour) = self.colour {
            append(&mut attributes, format_args!(" fill=\"{colour}\""));
        }
        if self.halo {
            append(
                &mut attributes,
                format_args!(
                    " stroke=\"{GROUND}\" stroke-width=\"2.4\" stroke-linejoin=\"round\" paint-order=\"stroke\""
                ),
            );
        }
        let place = if self.upright {
            format!("transform=\"translate({} {}) rotate(-90)\"", number(x), number(y))
        } else {
            format!("x=\"{}\" y=\"{}\"", number(x), number(y))
        };
        // most texts are of the size of the document
        if self.size != SMALL_SIZE {
            append(&mut attributes, format_args!(" font-size=\"{}\"", number(self.size)));
        }
        format!("<text {place}{attributes}>{}</text>", self.content())
    }

    fn content(&self) -> String {
        let mut risen = 0.0;
        let mut content = String::new();
        for span in &self.spans {
            let rise = span_rise(span, self.size);
            let text = escape(&span.text);
            let (shift, slope) = (risen - rise, span.italic);
            risen = rise;
            if shift == 0.0 && span.level == 0 && !slope {
                content.push_str(&text);
                continue;
            }
            let shift = if shift == 0.0 { String::new() } else { format!(" dy=\"{}\"", number(shift)) };
            let slope = if slope { " font-style=\"italic\"" } else { "" };
            let size = match span.level {
                0 => String::new(),
                _ => format!(" font-size=\"{}\"", number(span_size(span, self.size))),
            };
            append(&mut content, format_args!("<tspan{shift}{size}{slope}>{text}</tspan>"));
        }
        content
    }
}
