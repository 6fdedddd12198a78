//! What an array of groups says of itself in SI, where its case is written there: attributes that readers go by, those of Python among them.

use judder_store::Variable;
use serde_json::Value;

/// What the array is multiplied by to be in SI.
pub(crate) const FACTOR: &str = "si_factor";
const UNIT: &str = "si_unit";
const WORDS: &str = "si_long_name";

/// An array in SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ArrayInSi<'a> {
    /// What it is multiplied by.
    pub(crate) factor: f64,
    /// The unit that it then has.
    pub(crate) unit: &'a str,
    /// What it then is.
    pub(crate) words: &'a str,
}

impl<'a> ArrayInSi<'a> {
    /// The attributes that say so.
    pub(crate) fn attributes(self) -> Vec<(&'static str, Value)> {
        vec![(UNIT, self.unit.into()), (FACTOR, self.factor.into()), (WORDS, self.words.into())]
    }

    /// What an array says; none of one that says nothing.
    pub(crate) fn of(variable: &'a Variable) -> Option<Self> {
        let text = |key: &str| variable.attributes.get(key)?.as_str();
        Some(Self {
            factor: variable.attributes.get(FACTOR)?.as_f64()?,
            unit: text(UNIT)?,
            words: text(WORDS)?,
        })
    }
}
