//! Figures from stored arrays: everything that is drawn can be drawn again without computing anything.

#![deny(clippy::indexing_slicing, reason = "stored arrays may be of any length")]

mod stored;
pub(crate) mod sweep;

pub use stored::{ArraySource, StoredArrays, at, codes, complexes, middle, picked, reals, wholes, words};

use crate::case::analysis::Picture;
use crate::error::WrongArray;
use crate::registry::ModelKind;
use crate::shown::ShownValues;
use judder_numerics::order::sort_by_number;
use judder_report::{Axis, Figure, Panel, Role};
use judder_store::{Dataset, Variable, VariableValues};
use std::borrow::Cow;

/// Width over height of the frame of a panel: lengths along x and y shall look alike.
pub const FRAME: f64 = 206.0 / 152.0;

impl ModelKind {
    /// The figure of an analysis; `None` where its result is not a picture.
    ///
    /// # Errors
    /// [`WrongArray`] for an array that is not what judder writes.
    pub fn figure(&self, name: &str, title: &str, dataset: &Dataset) -> Result<Option<Figure>, WrongArray> {
        let panels = self.panels(dataset)?;
        let is_drawn = !panels.is_empty();
        Ok(is_drawn.then(|| Figure::new(name, title, panels).with_caption(self.caption(dataset))))
    }

    /// The panels of an analysis, to be put together with those of others.
    ///
    /// # Errors
    /// As of [`figure`](Self::figure).
    pub fn panels(&self, dataset: &Dataset) -> Result<Vec<Panel>, WrongArray> {
        let arrays = StoredArrays::of(dataset);
        arrays.settled(self.panels_of(&arrays))
    }

    /// The same of arrays that whoever draws asks at the end whether they are what judder writes.
    #[must_use]
    pub fn panels_of(&self, arrays: &StoredArrays<'_>) -> Vec<Panel> {
        self.picture(arrays.dataset()).and_then(|own| (own.draw)(arrays)).unwrap_or_default()
    }

    /// What stands under the figure of a kind.
    #[must_use]
    pub fn caption(&self, dataset: &Dataset) -> &'static str {
        self.picture(dataset).map_or("", |own| own.caption)
    }

    fn picture(&self, dataset: &Dataset) -> Option<&'static Picture> {
        let kind = dataset.attributes().get("kind")?.as_str()?;
        (self.kinds)().into_iter().find(|own| own.name == kind)?.picture
    }
}

/// Points along each side of a drawn map: more than a panel has pixels would only make the page heavy.
pub(crate) const DRAWN_SIDE: usize = 400;

/// Which of these coordinates are drawn, in ascending order, whichever way they were swept.
pub fn ascending_order(values: &[f64]) -> Vec<usize> {
    let mut indices: Vec<usize> = (0..values.len()).collect();
    sort_by_number(&mut indices, |own| at(values, *own));
    let drawn = indices.len().min(DRAWN_SIDE);
    let last = indices.len().saturating_sub(1);
    (0..drawn).filter_map(|k| indices.get(k * last / (drawn - 1).max(1)).copied()).collect()
}

/// A text that is an attribute of an array.
pub fn text<'a>(variable: &'a Variable, attribute: &str) -> Option<&'a str> {
    variable.attributes.get(attribute)?.as_str()
}

/// The values of a coordinate as they are shown.
pub fn shown<'a>(coordinate: &Variable, values: &'a [f64]) -> Cow<'a, [f64]> {
    let unit = ShownValues::of_variable(coordinate);
    if unit.unit().is_some() { unit.values(values).into() } else { values.into() }
}

/// The axis of a swept quantity; values that a logarithm does not have, of a range below zero, stand on a linear one.
pub fn axis(coordinate: &Variable) -> Axis {
    let label = text(coordinate, "label").unwrap_or(&coordinate.long_name);
    let label = ShownValues::of_variable(coordinate).label(label);
    let has_logarithms =
        !matches!(&coordinate.data, VariableValues::F64(values) if values.iter().any(|value| *value <= 0.0));
    let is_log = text(coordinate, "scale") == Some("log") && has_logarithms;
    if is_log { Axis::log(label) } else { Axis::linear(label) }
}

/// The coordinate along the last named dimension that has one, and that of the family before it.
pub struct SweptCoordinates<'a> {
    /// The coordinate.
    pub axis: &'a Variable,
    /// Its values, as they are shown.
    pub values: Cow<'a, [f64]>,
    /// The coordinate of the family, and its values; none where there is no family.
    pub family: Option<(&'a Variable, &'a [f64])>,
}

impl<'a> SweptCoordinates<'a> {
    /// The swept quantities of an array: its dimensions that have coordinates, one or two, before those of what each point has.
    pub fn of(dataset: &StoredArrays<'a>, array: &str, of_a_point: usize) -> Option<Self> {
        let own = dataset.variable(array)?;
        let swept = own.dimensions.len().saturating_sub(of_a_point);
        let coordinate = |name: &String| Some((dataset.variable(name)?, reals(dataset, name)?));
        let known: Vec<_> =
            own.dimensions.iter().take(swept).map(coordinate).collect::<Option<_>>().unwrap_or_default();
        match known.as_slice() {
            [(axis, values)] => Some(Self { axis, values: shown(axis, values), family: None }),
            [first, (axis, values)] => Some(Self { axis, values: shown(axis, values), family: Some(*first) }),
            _ => {
                let expected =
                    format!("one over one or two swept quantities and {of_a_point} further dimensions");
                dataset.refuse_as(own, expected)?;
                None
            }
        }
    }

    /// How many curves there are.
    pub fn curves(&self) -> usize {
        self.family.map_or(1, |(_, values)| values.len())
    }

    /// The legend of a curve of the family: symbol = value; `alone` where there is no family.
    pub fn label(&self, curve: usize, alone: &str) -> String {
        let Some((variable, values)) = self.family else { return alone.to_owned() };
        let symbol = text(variable, "symbol").unwrap_or(&variable.name);
        let unit = if variable.units == "1" { String::new() } else { format!(" {}", variable.units) };
        format!("{symbol} = {}{unit}", crate::labels::short_number(at(values, curve)))
    }

    /// The role of a curve of the family.
    pub fn role(&self, curve: usize) -> Role {
        match self.family {
            Some(_) => Role::Graded { index: curve, count: self.curves() },
            None => Role::FullBoundary,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use judder_report::Scale;

    #[test]
    fn values_below_zero_stand_on_a_linear_axis() {
        let scale = |values: [f64; 2]| {
            let coordinate = Variable::new("value", &["value"], &[2], values.to_vec());
            axis(&coordinate.attribute("scale", "log")).scale
        };
        assert!(matches!(scale([-1.2e-4, -8e-5]), Scale::Linear));
        assert!(matches!(scale([8e-5, 1.2e-4]), Scale::Log));
    }
}
