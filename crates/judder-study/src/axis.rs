//! Swept quantities as axes of arrays.

use crate::case::scale::Spacing;
use crate::labels::{SweptQuantity, plain};
use crate::shown::SHOWN_UNIT;
use judder_keys::quantity::WrittenUnit;
use judder_store::Variable;

/// A swept quantity with its values: a coordinate of arrays, an axis of figures.
#[derive(Debug, Clone)]
pub struct SweptAxis {
    /// How it is called.
    pub quantity: SweptQuantity,
    /// Its values.
    pub values: Vec<f64>,
    /// How they are spaced.
    pub scale: Spacing,
    /// In which unit the case has them, and figures and messages show them; none where that is the one of the quantity.
    pub shown: Option<WrittenUnit>,
}

impl SweptAxis {
    /// The coordinate variable; `label`, `scale` and `shown_unit` let the figures be drawn again from the arrays alone.
    pub fn coordinate(&self) -> Variable {
        let own = coordinate(&self.quantity, self.values.clone()).attribute("scale", self.scale.name());
        match self.shown_unit() {
            Some(unit) => own.attribute(SHOWN_UNIT, unit),
            None => own,
        }
    }

    /// The name of the unit in which values are shown, where they are shown in another than they are kept; `1` of plain numbers.
    pub fn shown_unit(&self) -> Option<String> {
        let name = self.shown.as_ref().map(|unit| unit.name.clone());
        name.map(|name| if name.is_empty() { "1".to_owned() } else { name })
    }

    /// A value in words, with its unit where it has one.
    pub fn text(&self, value: f64) -> String {
        match (&self.shown, self.quantity.unit.as_str()) {
            (Some(shown), _) => shown.text(value),
            (None, "1") => value.to_string(),
            (None, unit) => format!("{value} {unit}"),
        }
    }

    /// The name of the quantity.
    pub fn name(&self) -> &str {
        &self.quantity.name
    }
}

/// The coordinate variable of a quantity with these values.
pub fn coordinate(quantity: &SweptQuantity, values: Vec<f64>) -> Variable {
    Variable::coordinate(&quantity.name, values)
        .units(&quantity.unit)
        .long_name(&plain(&quantity.label))
        .attribute("label", quantity.label.clone())
        .attribute("symbol", quantity.symbol.clone())
}
