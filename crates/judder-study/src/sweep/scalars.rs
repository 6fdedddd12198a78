//! A number out of what an analysis leaves in `summary.json`, by its path.

use crate::case::study_sweep::quantity_path::{ListReduction, QuantityStep};
use serde_json::{Map, Value};

/// The number at the end of a path through the scalars of an analysis. A name goes into an object, and over the items of a list of
/// objects; a number picks an item; at the end, a [`ListReduction`] makes one number of a list. A list without items has no number, which is an
/// answer: NaN.
///
/// # Errors
/// The step that leads nowhere, with what there is; a path that ends at something else than a number.
pub(super) fn number_at(scalars: &Map<String, Value>, path: &[QuantityStep]) -> Result<f64, String> {
    let mut found = FoundScalar::Object(scalars);
    for (depth, step) in path.iter().enumerate() {
        found = match step {
            QuantityStep::Item(index) => found.item(*index),
            QuantityStep::Name(name) => found.named(name, depth + 1 == path.len()),
        }
        .map_err(|there| format!("there is no `{}`; there is {there}", shown(step)))?;
    }
    found.number().ok_or_else(|| format!("it ends at no number but at {}", found.told()))
}

fn shown(step: &QuantityStep) -> String {
    match step {
        QuantityStep::Name(name) => name.clone(),
        QuantityStep::Item(index) => index.to_string(),
    }
}

/// What a path has led to.
enum FoundScalar<'a> {
    Object(&'a Map<String, Value>),
    Value(&'a Value),
    /// The same field of every item of a list.
    Items(Vec<&'a Value>),
    Number(f64),
}

impl<'a> FoundScalar<'a> {
    /// The items, where it is a list; otherwise what it is, in words.
    fn items(self) -> Result<Vec<&'a Value>, String> {
        match self {
            Self::Value(Value::Array(items)) => Ok(items.iter().collect()),
            Self::Items(items) => Ok(items),
            other => Err(other.told()),
        }
    }

    fn is_missing(&self) -> bool {
        matches!(self, Self::Value(Value::Null))
    }

    /// A list that is shorter at this point has no such number.
    fn item(self, index: usize) -> Result<Self, String> {
        if self.is_missing() {
            return Ok(Self::Number(f64::NAN));
        }
        Ok(self.items()?.get(index).map_or(Self::Number(f64::NAN), |value| Self::Value(value)))
    }

    fn named(self, name: &str, is_last: bool) -> Result<Self, String> {
        match self {
            Self::Object(object) | Self::Value(Value::Object(object)) => {
                return object.get(name).map(Self::Value).ok_or_else(|| keys(object));
            }
            // what has no value has none of its parts either
            Self::Number(number) if number.is_nan() => return Ok(self),
            _ if self.is_missing() => return Ok(Self::Number(f64::NAN)),
            _ => {}
        }
        let items = self.items()?;
        if let (true, Some(reduction)) = (is_last, ListReduction::from_name(name)) {
            return reduced(&items, reduction).map(Self::Number).ok_or_else(|| list(items.len()));
        }
        let fields: Option<Vec<&Value>> = items.iter().map(|item| item.get(name)).collect();
        fields.map(Self::Items).ok_or_else(|| list(items.len()))
    }

    fn number(&self) -> Option<f64> {
        match self {
            Self::Number(number) => Some(*number),
            Self::Value(value) => plain(value),
            Self::Object(_) | Self::Items(_) => None,
        }
    }

    /// What it is, in words.
    fn told(&self) -> String {
        match self {
            Self::Object(object) => keys(object),
            Self::Value(Value::Object(object)) => keys(object),
            Self::Value(Value::Array(items)) => list(items.len()),
            Self::Items(items) => list(items.len()),
            Self::Value(Value::String(text)) => format!("the word `{text}`"),
            Self::Value(_) | Self::Number(_) => "a number".to_owned(),
        }
    }
}

fn keys(object: &Map<String, Value>) -> String {
    let keys: Vec<String> = object.keys().map(|key| format!("`{key}`")).collect();
    keys.join(", ")
}

fn list(length: usize) -> String {
    let reductions = ListReduction::ALL.map(|(name, _)| name).join(", ");
    format!("a list of {length}, which takes the number of an item from 0, or one of {reductions}")
}

/// One number of a list; `None` where an item that counts is none.
fn reduced(items: &[&Value], reduction: ListReduction) -> Option<f64> {
    if reduction == ListReduction::Count {
        return Some(items.len() as f64);
    }
    let numbers: Vec<f64> = items.iter().map(|item| plain(item)).collect::<Option<_>>()?;
    let number = match reduction {
        ListReduction::Min => numbers.iter().copied().reduce(f64::min),
        ListReduction::Max => numbers.iter().copied().reduce(f64::max),
        ListReduction::First => numbers.first().copied(),
        ListReduction::Last | ListReduction::Count => numbers.last().copied(),
    };
    Some(number.unwrap_or(f64::NAN))
}

/// A value as a number: `null` is one that is not finite, a truth is 1 or 0.
fn plain(value: &Value) -> Option<f64> {
    match value {
        Value::Number(number) => number.as_f64(),
        Value::Bool(truth) => Some(f64::from(u8::from(*truth))),
        Value::Null => Some(f64::NAN),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn at(path: &str) -> Result<f64, String> {
        let scalars = json!({
            "rms": 0.5, "none": null, "stable": true, "name": "film",
            "full": [[0.1, 0.4], []],
            "unstable": [{"from_m": 0.1, "growth": 3.0}, {"from_m": 0.2, "growth": 7.0}],
            "range": {"min": -1.0, "max": 2.0},
            "bursts": [],
        });
        let Value::Object(scalars) = scalars else { unreachable!() };
        let step = |step: &str| match step.parse() {
            Ok(item) => QuantityStep::Item(item),
            Err(_) => QuantityStep::Name(step.to_owned()),
        };
        number_at(&scalars, &path.split('.').map(step).collect::<Vec<_>>())
    }

    #[test]
    fn paths_lead_to_numbers() {
        assert_eq!(at("rms"), Ok(0.5));
        assert_eq!(at("stable"), Ok(1.0));
        assert_eq!(at("full.0.1"), Ok(0.4));
        assert_eq!(at("full.0.min"), Ok(0.1));
        assert_eq!(at("full.count"), Ok(2.0));
        assert_eq!(at("unstable.growth.max"), Ok(7.0));
        assert_eq!(at("unstable.1.from_m"), Ok(0.2));
        assert_eq!(at("range.min"), Ok(-1.0), "the key of an object goes before the reduction");
        assert_eq!(at("bursts.count"), Ok(0.0));
    }

    #[test]
    fn an_answer_without_a_number_is_not_a_number() {
        for path in ["none", "full.1.min", "full.1.0", "bursts.peak.max", "bursts.3.peak", "full.7"] {
            assert!(at(path).is_ok_and(f64::is_nan), "{path}: {:?}", at(path));
        }
    }

    #[test]
    fn a_path_that_leads_nowhere_says_what_there_is() {
        assert!(at("rmss").is_err_and(|told| told.contains("`rmss`") && told.contains("`rms`, ")));
        assert!(at("unstable").is_err_and(|told| told.contains("a list of 2")));
        assert!(at("unstable.growths.max").is_err_and(|told| told.contains("`growths`")));
        assert!(at("name").is_err_and(|told| told.contains("the word `film`")));
        assert!(at("rms.max").is_err_and(|told| told.contains("a number")));
        assert!(at("range").is_err_and(|told| told.contains("`min`, `max`")));
    }
}
