//! A figure as data: panels, axes and layers, without any drawing.
//!
//! Texts (titles, labels, captions) take a small markup: `_{…}` and `^{…}` lower and raise, `$…$` sets symbols (letters
//! italic, digits and signs upright, subscripts of several letters upright); everything else is Unicode:
//! `"Shear strength $τ̃_{0,crit}$"`, `"10^{−3}"`, `"Speed (m s^{−1})"`.

use crate::axis::Axis;
use crate::palette::{ColourMap, Role, Style};
use serde::Serialize;

/// A figure of one or more panels on a grid, all frames of the same size.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Figure {
    /// File stem (`"fig-9a"` becomes `figures/fig-9a.svg`): letters, digits, `-`, `_` and `.`.
    pub name: String,
    /// What the figure shows, in a few words; a heading on the page, the accessible name of the picture.
    pub title: String,
    /// The text under the figure.
    pub caption: String,
    /// Panels in a row; at least 1.
    pub columns: usize,
    /// The panels, row by row. Two or more are lettered (a), (b), ….
    pub panels: Vec<Panel>,
}

impl Figure {
    /// A figure of `panels`, in one column when there is one panel and in two otherwise.
    pub fn new(name: impl Into<String>, title: impl Into<String>, panels: Vec<Panel>) -> Self {
        let columns = panels.len().clamp(1, 2);
        Self { name: name.into(), title: title.into(), caption: String::new(), columns, panels }
    }

    /// The same figure with the text that stands under it.
    #[must_use]
    pub fn with_caption(self, caption: impl Into<String>) -> Self {
        Self { caption: caption.into(), ..self }
    }

    /// The same figure with `columns` panels in a row.
    #[must_use]
    pub fn with_columns(self, columns: usize) -> Self {
        Self { columns, ..self }
    }
}

/// One frame with its axes and what is drawn in it, the first layer at the bottom.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Panel {
    /// Stands above the frame; may be empty.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub title: String,
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
    /// What is drawn, from the back to the front.
    pub layers: Vec<Layer>,
    /// Where the labels of the layers are explained.
    pub legend: Legend,
    /// What else belongs to the abscissae, along the upper side of the frame.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub second: Option<SecondAxis>,
}

impl Panel {
    /// A panel without a title; its legend stands below the figure if it has a class map, which would be covered,
    /// and otherwise inside, where the data leave room.
    pub fn new(x: Axis, y: Axis, layers: Vec<Layer>) -> Self {
        let has_map = layers.iter().any(|layer| matches!(layer, Layer::Classes(_)));
        let legend = if has_map { Legend::Below } else { Legend::Inside };
        Self { title: String::new(), x, y, layers, legend, second: None }
    }

    /// The same panel under a title.
    #[must_use]
    pub fn with_title(self, title: impl Into<String>) -> Self {
        Self { title: title.into(), ..self }
    }

    /// The same panel with its legend at another place.
    #[must_use]
    pub fn with_legend(self, legend: Legend) -> Self {
        Self { legend, ..self }
    }

    /// The same panel with a second scale along its upper side.
    #[must_use]
    pub fn with_second_axis(self, second: SecondAxis) -> Self {
        Self { second: Some(second), ..self }
    }
}

/// A second quantity along the horizontal axis, such as the place that belongs to each time: straight between its points.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SecondAxis {
    /// Quantity, symbol and unit.
    pub label: String,
    /// Abscissae, strictly ascending.
    pub x: Vec<f64>,
    /// The value above each of them: rising throughout or falling throughout, but it may stand still.
    pub value: Vec<f64>,
}

/// Where the legend of a panel stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Legend {
    /// In a corner of the frame where it hides nothing; below, with those of the other panels, where there is none.
    #[default]
    Inside,
    /// In this corner of the frame.
    At(Corner),
    /// Under the whole figure, together with the entries of the other panels, each once.
    Below,
    /// Nowhere.
    Hidden,
}

/// A corner of a frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[allow(missing_docs)]
#[serde(rename_all = "kebab-case")]
pub enum Corner {
    TopLeft,
    TopRight,
    BottomLeft,
    BottomRight,
}

/// One thing drawn in a panel.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Layer {
    /// Points joined by straight segments.
    Line(Line),
    /// Single points, each with a marker.
    Points(Line),
    /// A map of a few named classes (a stability map).
    Classes(ClassMap),
    /// A map of values with a colour bar.
    Values(ValueMap),
    /// A horizontal or vertical reference line across the frame.
    Rule(Rule),
    /// A shaded rectangle or band.
    Region(ShadedRegion),
    /// A short text at a place.
    Note(Note),
}

impl Layer {
    /// A line through (`x[i]`, `y[i]`); a NaN is a gap. An empty label keeps it out of the legend.
    pub fn line(label: impl Into<String>, x: Vec<f64>, y: Vec<f64>, style: impl Into<Style>) -> Self {
        Self::Line(Line { label: label.into(), x, y, style: style.into(), swing: None, sizes: None })
    }

    /// A line that swings about its place: drawn at phase zero, moving on the page.
    pub fn swinging(
        label: impl Into<String>,
        x: Vec<f64>,
        y: Vec<f64>,
        swing: Swing,
        style: impl Into<Style>,
    ) -> Self {
        Self::Line(Line {
            label: label.into(),
            x,
            y,
            style: style.into(),
            swing: Some(Box::new(swing)),
            sizes: None,
        })
    }

    /// Markers at (`x[i]`, `y[i]`).
    pub fn points(label: impl Into<String>, x: Vec<f64>, y: Vec<f64>, style: impl Into<Style>) -> Self {
        Self::Points(Line { label: label.into(), x, y, style: style.into(), swing: None, sizes: None })
    }

    /// Markers of sizes of their own: `sizes[i]` times the usual diameter.
    pub fn bubbles(
        label: impl Into<String>,
        x: Vec<f64>,
        y: Vec<f64>,
        sizes: Vec<f64>,
        style: impl Into<Style>,
    ) -> Self {
        Self::Points(Line { label: label.into(), x, y, style: style.into(), swing: None, sizes: Some(sizes) })
    }

    /// A legend entry with a line sample and no data, to explain a dash or a colour once.
    pub fn key(label: impl Into<String>, style: impl Into<Style>) -> Self {
        Self::line(label, Vec::new(), Vec::new(), style)
    }

    /// A thin vertical line at `x = value`.
    pub fn vertical_rule(value: f64, label: impl Into<String>) -> Self {
        Self::Rule(Rule { direction: RuleDirection::Vertical, value, label: label.into() })
    }

    /// A thin horizontal line at `y = value`.
    pub fn horizontal_rule(value: f64, label: impl Into<String>) -> Self {
        Self::Rule(Rule { direction: RuleDirection::Horizontal, value, label: label.into() })
    }

    /// A short text whose left end stands at (`x`, `y`).
    pub fn note(x: f64, y: f64, text: impl Into<String>) -> Self {
        Self::Note(Note { x, y, text: text.into() })
    }
}

/// A curve or a set of points.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Line {
    /// Legend text; empty for none.
    pub label: String,
    /// Abscissae.
    pub x: Vec<f64>,
    /// Ordinates, as many as abscissae; what is not finite (or has no place on a log axis) is a gap.
    pub y: Vec<f64>,
    /// Colour, dash, marker.
    pub style: Style,
    /// How it moves on the page, where it does.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub swing: Option<Box<Swing>>,
    /// Diameters of the markers over the usual one, one a point; all of the usual one where there are none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sizes: Option<Vec<f64>>,
}

/// A harmonic motion of the points of a line about their rest: at the phase φ they stand at rest + Re((a + i b) e^{iφ}), and the line
/// as it is drawn is that of φ = 0, rest + a.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Swing {
    /// a and b along x, one a point.
    pub x: [Vec<f64>; 2],
    /// a and b along y, one a point.
    pub y: [Vec<f64>; 2],
}

/// A map whose cells belong to one of a few named classes.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ClassMap {
    /// Centres of the columns, strictly ascending, positive on a log axis.
    pub x: Vec<f64>,
    /// Centres of the rows, strictly ascending, positive on a log axis.
    pub y: Vec<f64>,
    /// Index into `classes` of every cell, row-major: `codes[row * x.len() + column]`.
    pub codes: Vec<u8>,
    /// The classes, at most 256.
    pub classes: Vec<Class>,
}

/// A class of a map.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Class {
    /// Legend text.
    pub label: String,
    /// Colour by meaning; [`Role::Unresolved`] is hatched.
    pub role: Role,
}

impl Class {
    /// A class of this name and colour role.
    pub fn new(label: impl Into<String>, role: Role) -> Self {
        Self { label: label.into(), role }
    }
}

/// A map of values, with a colour bar to the right of its frame.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ValueMap {
    /// Centres of the columns, strictly ascending, positive on a log axis.
    pub x: Vec<f64>,
    /// Centres of the rows, strictly ascending, positive on a log axis.
    pub y: Vec<f64>,
    /// Values, row-major: `z[row * x.len() + column]`; what is not finite is drawn as unresolved.
    pub z: Vec<f64>,
    /// Quantity, symbol and unit, scale and range of the colour bar.
    pub bar: Axis,
    /// The colours, from the smallest to the largest value.
    pub colours: ColourMap,
}

/// The direction of a reference line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[allow(missing_docs)]
#[serde(rename_all = "kebab-case")]
pub enum RuleDirection {
    Horizontal,
    Vertical,
}

/// A reference line across the frame.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Rule {
    /// Which way it runs.
    pub direction: RuleDirection,
    /// Where it crosses the other axis.
    pub value: f64,
    /// Text along the line; may be empty.
    pub label: String,
}

/// A shaded band or rectangle.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ShadedRegion {
    /// Legend text; empty for none.
    pub label: String,
    /// From and to along x; `None` for the whole width.
    pub x: Option<(f64, f64)>,
    /// From and to along y; `None` for the whole height.
    pub y: Option<(f64, f64)>,
    /// Colour by meaning.
    pub role: Role,
}

/// A text at a place of the panel.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Note {
    /// Abscissa of its left end.
    pub x: f64,
    /// Ordinate of its middle.
    pub y: f64,
    /// The text.
    pub text: String,
}
