//! The units in which fields and histories of contacts are drawn.

#![deny(clippy::indexing_slicing, reason = "stored arrays may be of any length")]

use crate::array_in_si::ArrayInSi;
use judder_study::pictures::{StoredArrays, reals};
use judder_study::prefixed::PrefixedUnit;

/// How an array is drawn: in SI where it says what it is there, else over what makes the group.
pub(super) struct DrawnUnit {
    factor: f64,
    over: &'static str,
    unit: Option<String>,
}

impl DrawnUnit {
    /// That of a stored array, which is over `over`; none where there is no such array.
    pub(super) fn of(dataset: &StoredArrays<'_>, name: &str, over: &'static str) -> Option<Self> {
        let values = reals(dataset, name)?;
        let Some(ArrayInSi { factor, unit, .. }) = dataset.variable(name).and_then(ArrayInSi::of) else {
            return Some(Self { factor: 1.0, over, unit: None });
        };
        let finite = values.iter().filter(|own| own.is_finite());
        let shown = PrefixedUnit::of(unit, factor * finite.fold(0.0, |most: f64, own| most.max(own.abs())));
        Some(Self { factor: factor * shown.factor, over, unit: Some(shown.name) })
    }

    /// An array in it.
    pub(super) fn values(&self, own: &[f64]) -> Vec<f64> {
        own.iter().map(|own| self.factor * own).collect()
    }

    /// A quantity at an axis.
    pub(super) fn label(&self, quantity: &str) -> String {
        match &self.unit {
            Some(unit) => format!("{quantity} ({unit})"),
            None => format!("{quantity}/{} (−)", self.over),
        }
    }
}
