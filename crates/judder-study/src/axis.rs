//! Swept quantities as axes of arrays.

use crate::case::scale::Spacing;
use crate::labels::{SweptQuantity, plain};
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
}

impl SweptAxis {
    /// The coordinate variable; `label` and `scale` let the figures be drawn again from the arrays alone.
    pub fn coordinate(&self) -> Variable {
        coordinate(&self.quantity, self.values.clone()).attribute("scale", self.scale.name())
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
