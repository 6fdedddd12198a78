//! Figures from stored arrays: everything that is drawn can be drawn again without computing anything.

pub(crate) mod sweep;

use crate::case::analysis::Picture;
use crate::models::all_kinds;
use judder_report::{Axis, Figure, Panel, Role};
use judder_store::{Data, Dataset, Variable};
use num_complex::Complex64;

/// Width over height of the frame of a panel: lengths along x and y shall look alike.
pub(crate) const FRAME: f64 = 206.0 / 152.0;

/// The figure of an analysis; `None` where its result is not a picture.
#[must_use]
pub fn figure(name: &str, title: &str, dataset: &Dataset) -> Option<Figure> {
    let panels = panels(dataset);
    (!panels.is_empty()).then(|| Figure::new(name, title, panels).with_caption(caption(dataset)))
}

/// The kinds of analyses that have a figure.
pub fn kinds() -> impl Iterator<Item = &'static str> {
    all_kinds().filter_map(|(name, picture)| picture.map(|_| name))
}

/// The panels of an analysis, to be put together with those of others.
#[must_use]
pub fn panels(dataset: &Dataset) -> Vec<Panel> {
    own(dataset).and_then(|own| (own.draw)(dataset)).unwrap_or_default()
}

/// What stands under the figure of a kind.
pub fn caption(dataset: &Dataset) -> &'static str {
    own(dataset).map_or("", |own| own.caption)
}

fn own(dataset: &Dataset) -> Option<&'static Picture> {
    let kind = dataset.attributes().get("kind")?.as_str()?;
    all_kinds().find_map(|(name, picture)| picture.filter(|_| name == kind))
}

/// The real numbers of this array; none where there is no such array of them.
pub fn reals<'a>(dataset: &'a Dataset, name: &str) -> Option<&'a [f64]> {
    match &dataset.variable(name)?.data {
        Data::F64(values) => Some(values),
        _ => None,
    }
}

pub(crate) fn complexes<'a>(dataset: &'a Dataset, name: &str) -> Option<&'a [Complex64]> {
    match &dataset.variable(name)?.data {
        Data::Complex(values) => Some(values),
        _ => None,
    }
}

/// The codes of this array of classes; none where there is no such array of them.
pub fn codes<'a>(dataset: &'a Dataset, name: &str) -> Option<&'a [u8]> {
    match &dataset.variable(name)?.data {
        Data::U8(values) => Some(values),
        _ => None,
    }
}

pub(crate) fn words<'a>(dataset: &'a Dataset, name: &str) -> Option<&'a [String]> {
    match &dataset.variable(name)?.data {
        Data::Text(values) => Some(values),
        _ => None,
    }
}

pub(crate) fn text<'a>(variable: &'a Variable, attribute: &str) -> Option<&'a str> {
    variable.attributes.get(attribute)?.as_str()
}

/// The axis of a swept quantity.
pub fn axis(coordinate: &Variable) -> Axis {
    let label = text(coordinate, "label").unwrap_or(&coordinate.long_name);
    if text(coordinate, "scale") == Some("log") { Axis::log(label) } else { Axis::linear(label) }
}

/// The coordinate along the last named dimension that has one, and that of the family before it.
pub(crate) struct Swept<'a> {
    pub(crate) axis: &'a Variable,
    pub(crate) values: &'a [f64],
    pub(crate) family: Option<(&'a Variable, &'a [f64])>,
}

impl<'a> Swept<'a> {
    /// The swept quantities of an array: its dimensions that have coordinates.
    pub(crate) fn of(dataset: &'a Dataset, array: &str) -> Option<Self> {
        let mut coordinates = dataset
            .variable(array)?
            .dimensions
            .iter()
            .filter_map(|dimension| Some((dataset.variable(dimension)?, reals(dataset, dimension)?)));
        let first = coordinates.next()?;
        Some(match coordinates.next() {
            Some((axis, values)) => Self { axis, values, family: Some(first) },
            None => Self { axis: first.0, values: first.1, family: None },
        })
    }

    pub(crate) fn curves(&self) -> usize {
        self.family.map_or(1, |(_, values)| values.len())
    }

    /// The legend of a curve of the family: symbol = value; `alone` where there is no family.
    pub(crate) fn label(&self, curve: usize, alone: &str) -> String {
        let Some((variable, values)) = self.family else { return alone.to_owned() };
        let symbol = text(variable, "symbol").unwrap_or(&variable.name);
        let unit = if variable.units == "1" { String::new() } else { format!(" {}", variable.units) };
        format!("{symbol} = {}{unit}", crate::labels::short_number(values[curve]))
    }

    pub(crate) fn role(&self, curve: usize) -> Role {
        match self.family {
            Some(_) => Role::Graded { index: curve, count: self.curves() },
            None => Role::FullBoundary,
        }
    }
}
