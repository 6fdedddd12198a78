//! Whether a path leads to a number among the results that an analysis declares.

use super::problem::SweepProblem;
use super::quantity_path::{ListReduction, QuantityStep};
use judder_store::{Declared, ValueKind};

/// The unit of the number that a path through results with these keys leads to, empty where none is declared.
pub(super) fn unit(path: &str, steps: &[QuantityStep], keys: Vec<Declared>) -> Result<String, SweepProblem> {
    let no_number = |reason, advice: String| {
        let path = path.to_owned();
        Err(SweepProblem::NoNumber { path, reason, advice })
    };
    let (mut at, mut unit) = (ValueKind::Object(keys), String::new());
    let mut enter = |name: &str, keys: &[Declared]| {
        let key = named(path, name, keys)?;
        unit.clone_from(&key.unit);
        Ok(key.kind.clone())
    };
    for (depth, step) in steps.iter().enumerate() {
        let is_last = depth + 1 == steps.len();
        at = match (at, step) {
            (ValueKind::Object(keys), QuantityStep::Name(name)) => enter(name, &keys)?,
            (ValueKind::ByName(own), QuantityStep::Name(_))
            | (ValueKind::List(own), QuantityStep::Item(_)) => *own,
            (ValueKind::List(own), QuantityStep::Name(name)) => {
                match (*own, ListReduction::from_name(name)) {
                    (_, Some(ListReduction::Count)) if is_last => ValueKind::Count,
                    (own, Some(_)) if is_last && is_number(&own) => own,
                    (ValueKind::Object(keys), _) => enter(name, &keys)?.list(),
                    (_, Some(_)) if is_last => {
                        return no_number("it reduces a list that is not one of numbers", of_list());
                    }
                    _ => return no_number("it goes on by a name behind a list without names", of_list()),
                }
            }
            (ValueKind::Object(keys), QuantityStep::Item(_)) => {
                return no_number("it goes on by a number where there are names", of_names(&keys));
            }
            (ValueKind::ByName(_), QuantityStep::Item(_)) => {
                return no_number("it goes on by a number where there are names", "give a name".to_owned());
            }
            (own, _) if is_number(&own) => {
                let end = before(path, steps.len() - depth);
                return no_number("it goes on behind a number", format!("end it at `{end}`"));
            }
            _ => return no_number("it goes on behind a word", OF_WORD.to_owned()),
        };
    }
    match at {
        ValueKind::Count => Ok("1".to_owned()),
        ValueKind::Number | ValueKind::Truth => Ok(unit),
        ValueKind::Word => no_number("it ends at a word", OF_WORD.to_owned()),
        ValueKind::List(_) => no_number("it ends at a list", of_list()),
        ValueKind::Object(keys) => no_number("it ends where there are names", of_names(&keys)),
        ValueKind::ByName(_) => no_number("it ends where there are names", "add a name".to_owned()),
    }
}

fn is_number(kind: &ValueKind) -> bool {
    matches!(kind, ValueKind::Number | ValueKind::Count | ValueKind::Truth)
}

/// What would be right in the place of a word.
const OF_WORD: &str = "ask for a number";

fn of_list() -> String {
    let reductions = ListReduction::ALL.map(|(name, _)| name).join(", ");
    format!("add the number of an item, from 0, or one of {reductions}")
}

fn of_names(keys: &[Declared]) -> String {
    format!("add one of {}", names(keys).join(", "))
}

fn names(keys: &[Declared]) -> Vec<String> {
    keys.iter().map(|key| key.name.clone()).collect()
}

/// What stands under a name.
fn named<'a>(path: &str, name: &str, keys: &'a [Declared]) -> Result<&'a Declared, SweepProblem> {
    let found = keys.iter().find(|key| key.name == name);
    found.ok_or_else(|| SweepProblem::UnknownResult {
        path: path.to_owned(),
        name: name.to_owned(),
        known: names(keys),
    })
}

/// A path without its last steps.
fn before(path: &str, steps: usize) -> &str {
    path.rsplitn(steps + 1, '.').last().unwrap_or(path)
}
