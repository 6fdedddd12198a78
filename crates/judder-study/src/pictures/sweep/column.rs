//! A quantity of a sweep with its label, its colours and its values.

use crate::labels::with_unit;
use crate::pictures::{StoredArrays, words};
use crate::registry::ModelKind;
use judder_numerics::decade::power_of_ten;
use judder_numerics::order::sort_numbers;
use judder_report::figure::Class;
use judder_report::{Axis, Role};
use serde_json::Value;

/// A swept key.
pub(super) struct KeyColumn {
    /// Its dotted path.
    pub(super) path: String,
    /// Quantity, symbol and unit.
    pub(super) label: String,
    pub(super) is_log: bool,
    /// Its values at the points; of a grid, which has them as coordinates, none.
    pub(super) values: Vec<f64>,
}

impl KeyColumn {
    pub(super) fn axis(&self) -> Axis {
        if self.is_log { Axis::log(&self.label) } else { Axis::linear(&self.label) }
    }
}

/// A quantity at the points.
pub(super) struct PointColumn {
    /// Its name in the case.
    pub(super) name: String,
    /// Quantity, symbol and unit.
    pub(super) label: String,
    /// What the codes mean; empty for numbers.
    pub(super) classes: Vec<Class>,
    /// Row-major.
    pub(super) values: Vec<f64>,
}

/// The keys of a sweep, without values.
pub(super) fn keys(dataset: &StoredArrays<'_>) -> Option<Vec<KeyColumn>> {
    let list = |name: &str| dataset.attributes().get(name)?.as_array();
    let text = |value: &Value| value.as_str().unwrap_or_default().to_owned();
    let (paths, scales) = (list("keys")?, list("scales")?);
    let label =
        |k: usize, path: &Value| list("key_labels").and_then(|labels| labels.get(k)).map_or(text(path), text);
    let key = |(k, (path, scale)): (usize, (&Value, &Value))| KeyColumn {
        path: text(path),
        label: label(k, path),
        is_log: scale.as_str() == Some("log"),
        values: Vec::new(),
    };
    Some(paths.iter().zip(scales).enumerate().map(key).collect())
}

/// All columns of a sweep over a case of this model; `values` are its stored ones, quantities fastest.
pub(super) fn columns(
    model: Option<&ModelKind>,
    dataset: &StoredArrays<'_>,
    values: &[f64],
) -> Option<Vec<PointColumn>> {
    let (names, units) = (words(dataset, "quantity")?, words(dataset, "quantity_units")?);
    let long_names = words(dataset, "quantity_long_name")?;
    let meanings = words(dataset, "quantity_flag_meanings");
    dataset.over("quantity", &["quantity"])?;
    dataset.alike(&["quantity", "quantity_units", "quantity_long_name", "quantity_flag_meanings"])?;
    let column = |(k, name): (usize, &String)| {
        let flags = meanings.and_then(|meanings| meanings.get(k)).map_or("", String::as_str);
        let classes = flags.split_whitespace().map(|meaning| class(&meaning.replace('_', " ")));
        PointColumn {
            name: name.clone(),
            label: label(
                model,
                name,
                long_names.get(k).map_or("", String::as_str),
                units.get(k).map_or("", String::as_str),
            ),
            classes: classes.collect(),
            values: values.iter().skip(k).step_by(names.len()).copied().collect(),
        }
    };
    Some(names.iter().enumerate().map(column).collect())
}

fn label(model: Option<&ModelKind>, name: &str, long_name: &str, units: &str) -> String {
    if let Some(label) = model.and_then(|model| model.operating_label(name)) {
        return label.to_owned();
    }
    // of an analysis: its path says more than any words made of it
    with_unit(if name.contains('.') || units.is_empty() { name } else { long_name }, units)
}

/// Legend and colour of a class by its meaning: those of stability maps, and of eigenvalues for verdicts.
fn class(meaning: &str) -> Class {
    let (label, role) = match meaning {
        "none" | "stable" => ("stable", Role::Stable),
        "marginal" => ("marginal", Role::Reference),
        "unstable" => ("unstable", Role::Series(1)),
        "flutter" => ("flutter", Role::Flutter),
        "negative-damping" => ("negative damping", Role::NegativeDamping),
        "both" => ("both", Role::Both),
        "normal-force-coupling" => ("normal-force coupling", Role::NormalForceCoupling),
        "one-way-coupling" => ("one-way coupling by speed", Role::NormalForceCoupling),
        "destabilised-by-damping" => ("destabilised by damping", Role::DestabilisedByDamping),
        other => (other, Role::Unresolved),
    };
    Class::new(label, role)
}

impl PointColumn {
    pub(super) fn is_number(&self) -> bool {
        self.classes.is_empty()
    }

    /// The class of a point; the number of classes where it has none.
    pub(super) fn class_at(&self, point: usize) -> usize {
        match self.values.get(point) {
            Some(code) if *code >= 0.0 && *code < self.classes.len() as f64 => *code as usize,
            _ => self.classes.len(),
        }
    }

    /// An axis for its values: logarithmic where they span decades, on both sides of zero where they have both signs.
    pub(super) fn axis(&self) -> Axis {
        /// Largest over small values from which decades are spanned; of both signs and of one.
        const DECADES: (f64, f64) = (20.0, 100.0);
        /// The even part about zero, at least, over the largest value.
        const EVEN: f64 = 1e-4;
        let mut sizes: Vec<f64> = self
            .values
            .iter()
            .map(|value| value.abs())
            .filter(|size| size.is_finite() && *size > 0.0)
            .collect();
        sort_numbers(&mut sizes);
        let (Some(small), Some(large)) = (sizes.get(sizes.len() / 20), sizes.last()) else {
            return Axis::linear(&self.label);
        };
        let decades = if self.has_both_signs() { DECADES.0 } else { DECADES.1 };
        let even = power_of_ten(libm::log10(small.max(EVEN * large)).floor());
        match large / small {
            ratio if !(ratio.is_finite() && ratio > decades && even > 1e-280) => Axis::linear(&self.label),
            _ if self.values.iter().all(|value| value.is_nan() || *value > 0.0) => Axis::log(&self.label),
            _ => Axis::symmetric_log(&self.label, even),
        }
    }

    pub(super) fn has_both_signs(&self) -> bool {
        self.values.iter().any(|value| *value < 0.0) && self.values.iter().any(|value| *value > 0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use judder_report::Scale;

    fn scale(values: &[f64]) -> Scale {
        let (name, label) = (String::new(), String::new());
        PointColumn { name, label, classes: Vec::new(), values: values.to_vec() }.axis().scale
    }

    #[test]
    fn scales_follow_the_values() {
        assert_eq!(scale(&[1.0, 2.0, 50.0]), Scale::Linear);
        assert_eq!(scale(&[1e-3, 1.0, f64::NAN]), Scale::Log);
        assert_eq!(scale(&[-1e-3, 1.0]), Scale::SymmetricLog { linear: 1e-3 });
        assert_eq!(scale(&[-1e-9, 1.0]), Scale::SymmetricLog { linear: 1e-4 });
        assert_eq!(scale(&[-0.1, 1.0]), Scale::Linear);
        assert_eq!(scale(&[0.0, 0.0]), Scale::Linear);
        assert_eq!(scale(&[f64::NAN, f64::INFINITY]), Scale::Linear);
        assert_eq!(scale(&[1e-300, 1.0, 1e-300]), Scale::Log);
    }
}
