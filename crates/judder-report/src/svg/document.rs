//! The SVG document that is being written.

use super::text::Text;
use super::written::{append, number};
use crate::figure::{Figure, Layer};
use crate::layout::{Frame, Layout};
use crate::markup::{escape, plain_html};
use crate::palette::{AreaPattern, GROUND, INK, PATTERN_TILE, PATTERNED, QUIET, Role};
use crate::typeface::{FAMILIES, SMALL_SIZE};
use std::fmt::Arguments;

/// An SVG document up to the last element written.
pub(super) struct SvgDocument {
    out: String,
    /// Begins every id, so that several figures can stand in one page.
    name: String,
}

impl SvgDocument {
    /// Head, accessible name, hatch and white ground.
    pub(super) fn open(figure: &Figure, layout: &Layout) -> Self {
        let mut document = Self { out: String::new(), name: escape(&figure.name) };
        let (width, height) = (number(layout.width), number(layout.height));
        let name = document.name.clone();
        document.put(format_args!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}pt\" height=\"{height}pt\" \
             viewBox=\"0 0 {width} {height}\" font-family=\"{FAMILIES}\" fill=\"{INK}\" font-size=\"{}\" xml:space=\"preserve\" role=\"img\" \
             aria-labelledby=\"{name}-title {name}-caption\">",
            number(SMALL_SIZE)
        ));
        document.put(format_args!("<title id=\"{name}-title\">{}</title>", plain_html(&figure.title)));
        document.put(format_args!("<desc id=\"{name}-caption\">{}</desc>", plain_html(&figure.caption)));
        let hatch = Role::Unresolved.colour();
        document.put(format_args!(
            "<defs><pattern id=\"{name}-hatch\" width=\"4\" height=\"4\" patternUnits=\"userSpaceOnUse\" \
             patternTransform=\"rotate(45)\"><rect width=\"4\" height=\"4\" fill=\"{GROUND}\"/>\
             <rect width=\"1.2\" height=\"4\" fill=\"{hatch}\"/></pattern></defs>"
        ));
        for role in PATTERNED {
            if uses(figure, role) {
                document.define_pattern(role);
            }
        }
        document.put(format_args!("<rect width=\"{width}\" height=\"{height}\" fill=\"{GROUND}\"/>"));
        document
    }

    fn define_pattern(&mut self, role: Role) {
        let Some(AreaPattern { name, strokes, angle }) = role.pattern() else { return };
        let (document, tile) = (self.name.clone(), PATTERN_TILE);
        self.put(format_args!(
            "<defs><pattern id=\"{document}-{name}\" width=\"{tile}\" height=\"{tile}\" patternUnits=\"userSpaceOnUse\" \
             patternTransform=\"rotate({angle})\"><rect width=\"{tile}\" height=\"{tile}\" fill=\"{}\"/>\
             <path d=\"{strokes}\" fill=\"{QUIET}\"/></pattern></defs>",
            role.colour()
        ));
    }

    /// An id of this document.
    pub(super) fn id(&self, name: &str) -> String {
        format!("{}-{name}", self.name)
    }

    /// Adds an element and a line end.
    pub(super) fn put(&mut self, element: Arguments<'_>) {
        append(&mut self.out, format_args!("{element}\n"));
    }

    /// Adds a label whose anchor stands at (`x`, `y`) on its baseline.
    pub(super) fn text(&mut self, text: &Text, x: f64, y: f64) {
        if !text.is_empty() {
            self.put(format_args!("{}", text.element(x, y)));
        }
    }

    /// Opens a group that is cut at a frame.
    pub(super) fn open_clip(&mut self, frame: Frame, index: usize) {
        let name = self.name.clone();
        self.put(format_args!("<clipPath id=\"{name}-frame-{index}\">{}</clipPath>", rectangle(frame, "")));
        self.put(format_args!("<g clip-path=\"url(#{name}-frame-{index})\">"));
    }

    pub(super) fn close_group(&mut self) {
        self.put(format_args!("</g>"));
    }

    /// The fill of an area of this meaning.
    pub(super) fn area_fill(&self, role: Role) -> String {
        match role.pattern() {
            _ if role == Role::Unresolved => format!("url(#{}-hatch)", self.name),
            Some(pattern) => format!("url(#{}-{})", self.name, pattern.name),
            None => role.colour().to_string(),
        }
    }

    /// The finished document.
    pub(super) fn close(mut self) -> String {
        self.put(format_args!("</svg>"));
        self.out
    }
}

/// Whether a class of a figure has this meaning.
fn uses(figure: &Figure, role: Role) -> bool {
    let layers = figure.panels.iter().flat_map(|panel| &panel.layers);
    let classes =
        layers.filter_map(|layer| if let Layer::Classes(map) = layer { Some(&map.classes) } else { None });
    classes.flatten().any(|class| class.role == role)
}

/// A rectangle with further attributes.
pub(super) fn rectangle(frame: Frame, attributes: &str) -> String {
    format!(
        "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"{}{attributes}/>",
        number(frame.x),
        number(frame.y),
        number(frame.width.max(0.0)),
        number(frame.height.max(0.0)),
        if attributes.is_empty() { "" } else { " " },
    )
}
