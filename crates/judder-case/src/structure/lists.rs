//! Lists of quantities, whole numbers and directions.

use super::problem::StructureProblem;
use crate::cause::Cause;
use crate::contact_problem::ContactProblem;
use crate::document::{Data, Node};
use crate::error::Fault;
use crate::keys::Key;
use crate::section::{Section, list};
use crate::swept_keys::read_value;

/// A number that may be left out where it has a default, in SI units.
pub(crate) fn number<K>(section: &Section<'_>, entry: &Key<K>) -> Result<f64, Fault> {
    match (section.get(entry.name()), entry.default) {
        (Some(node), _) => Ok(read_value(entry, &section.path(entry.name()), node)?.number),
        (None, Some((_, value))) => Ok(value.number),
        (None, None) => {
            let example = match entry.dimension.is_number() {
                true => format!("{} = …, {}", entry.name(), entry.doc),
                false => format!("{} = \"{}\"", entry.name(), entry.example()),
            };
            Err(section.missing(entry.name(), &example))
        }
    }
}

/// The quantities of a list, in SI units.
pub(crate) fn quantities<K>(section: &Section<'_>, entry: &Key<K>, node: &Node) -> Result<Vec<f64>, Fault> {
    let path = section.path(entry.name());
    list(&path, node)?.iter().map(|item| Ok(read_value(entry, &path, item)?.number)).collect()
}

/// The refusal of a list of the wrong length.
pub(crate) fn length(section: &Section<'_>, key: &str, expected: &'static str, node: &Node) -> Fault {
    let found = if let Data::List(items) = &node.data { items.len() } else { 0 };
    StructureProblem::Length { key: section.path(key), expected, found }.at(node.place)
}

/// Whole numbers of a list, each from `from` to `to`.
pub(crate) fn whole_numbers(
    section: &Section<'_>,
    key: &str,
    node: &Node,
    (from, to): (usize, usize),
) -> Result<Vec<usize>, Fault> {
    let path = section.path(key);
    let read = |item: &Node| {
        let Data::Number { whole: Some(found), .. } = item.data else {
            return Err(crate::section::wrong_type(&path, "a list of integers", item));
        };
        match usize::try_from(found) {
            Ok(count) if (from..=to).contains(&count) => Ok(count),
            _ => {
                let problem = ContactProblem::Count { key: path.clone(), from, to, found };
                Err(Cause::Contact { problem }.at(item.place))
            }
        }
    };
    list(&path, node)?.iter().map(read).collect()
}
