//! Values of a swept key as tables and figures show them: in the unit in which the case has them.

use crate::labels::with_unit;
use crate::pictures::text;
use crate::report_tables::{short, uncertainty};
use judder_keys::dimension::Dimension;
use judder_keys::quantity::WrittenUnit;
use judder_store::Variable;
use serde_json::{Value as Json, json};

/// The key under which a summary and an array say in which unit their values are shown.
pub const SHOWN_UNIT: &str = "shown_unit";

/// The unit of values that are kept in SI units.
#[derive(Debug, Clone, PartialEq)]
pub struct ShownValues(WrittenUnit);

impl ShownValues {
    /// In the unit of this name, of a result that names none as they are kept.
    #[must_use]
    pub fn called(name: Option<&str>) -> Self {
        Self(name.and_then(WrittenUnit::called).unwrap_or_else(|| WrittenUnit::si(Dimension::NUMBER)))
    }

    /// As a table or an entry of a summary says.
    #[must_use]
    pub fn of(told: &Json) -> Self {
        Self::called(told[SHOWN_UNIT].as_str())
    }

    /// As an array says.
    #[must_use]
    pub fn of_variable(variable: &Variable) -> Self {
        Self::called(text(variable, SHOWN_UNIT))
    }

    /// The name of the unit; `None` of plain numbers and of values that are shown as they are kept.
    #[must_use]
    pub fn unit(&self) -> Option<&str> {
        Some(self.0.name.as_str()).filter(|name| !["", "1"].contains(name))
    }

    /// A value.
    #[must_use]
    pub fn number(&self, own: f64) -> f64 {
        self.0.value(own)
    }

    /// A value of a summary.
    #[must_use]
    pub fn value(&self, own: &Json) -> String {
        short(&own.as_f64().map_or(Json::Null, |own| json!(self.0.value(own))))
    }

    /// By how much a value of a summary may be off.
    #[must_use]
    pub fn error(&self, own: &Json) -> String {
        uncertainty(&own.as_f64().map_or(Json::Null, |own| json!(self.0.difference(own))))
    }

    /// The values of an array.
    #[must_use]
    pub fn values(&self, own: &[f64]) -> Vec<f64> {
        own.iter().map(|own| self.0.value(*own)).collect()
    }

    /// A key with the unit, a dash of plain numbers; of values that are shown as they are kept alone.
    #[must_use]
    pub fn head(&self, key: &str) -> String {
        with_unit(key, &self.0.name)
    }

    /// The label of an axis, which ends in the unit in which values are kept.
    #[must_use]
    pub fn label(&self, kept: &str) -> String {
        match (self.unit(), kept.rsplit_once(" (")) {
            (Some(_), Some((name, _))) => self.head(name),
            _ => kept.to_owned(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_and_values_have_the_unit_of_the_case() {
        let shown = ShownValues::called(Some("GPa"));
        assert_eq!((shown.label("modulus (Pa)"), shown.number(2e9)), ("modulus (GPa)".to_owned(), 2.0));
        let kept = ShownValues::called(None);
        assert_eq!((kept.label("Speed (mm/s)"), kept.number(0.03)), ("Speed (mm/s)".to_owned(), 0.03));
        assert_eq!(ShownValues::called(Some("1")).label("factor (−)"), "factor (−)");
        assert_eq!(ShownValues::called(Some("1")).head("factor"), "factor (−)");
    }
}
