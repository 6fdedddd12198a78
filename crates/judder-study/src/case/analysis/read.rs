//! Reading of `[[analysis]]`.

use super::{Kind, Kinds, Planned, is_file_name};
use crate::registry::Registry;
use judder_keys::cause::Cause;
use judder_keys::declared::{all, both};
use judder_keys::document::{Data, Node};
use judder_keys::error::Fault;
use judder_keys::section::{Section, text, wrong_type};

/// Reads `[[analysis]]`: each kind is looked up among `kinds`, and reads its own keys. The registry tells kinds of other models from
/// what is no kind at all.
pub fn read_analyses<S, T>(
    root: &Section<'_>,
    keys: &S,
    kinds: &Kinds<S, T>,
    registry: Registry,
) -> Result<Vec<Planned<T>>, Fault> {
    let Some(node) = root.get("analysis") else { return Ok(Vec::new()) };
    let Data::List(nodes) = &node.data else {
        return Err(wrong_type("analysis", "a list, each item headed [[analysis]]", node));
    };
    let mut names = Vec::new();
    all(nodes.iter().map(|node| read_analysis(node, keys, find_kind(node, kinds, registry)?, &mut names)))
}

/// Reads one analysis, whose name joins those of the ones before.
fn read_analysis<S, T>(
    node: &Node,
    keys: &S,
    (kind, known): (&Kind<S, T>, &[&'static str]),
    before: &mut Vec<String>,
) -> Result<Planned<T>, Fault> {
    let section = Section::of_table(node, "", &format!("an analysis of kind `{}`", kind.name))?;
    let named = both(section.refuse_others(known), read_name(&section, kind.name, before));
    let (((), name), settings) = both(named, (kind.read)(keys, &section))?;
    Ok(Planned { name, kind_name: kind.name, kind: settings })
}

/// Reads the name of an analysis, its kind where it gives none.
fn read_name(section: &Section<'_>, kind: &str, before: &mut Vec<String>) -> Result<String, Fault> {
    let name = section.text("name")?.unwrap_or(kind).to_owned();
    let place = section.place_of(&["name"]);
    if !is_file_name(&name) {
        return Err(Cause::BadName { name }.at(place));
    }
    if before.iter().any(|other| other.eq_ignore_ascii_case(&name)) {
        return Err(Cause::DuplicateName { name }.at(place));
    }
    before.push(name.clone());
    Ok(name)
}

/// The kind of one analysis; it decides which keys the analysis may have.
fn find_kind<'k, S, T>(
    node: &Node,
    kinds: &'k Kinds<S, T>,
    registry: Registry,
) -> Result<(&'k Kind<S, T>, &'k [&'static str]), Fault> {
    let Data::Table(table) = &node.data else { return Err(wrong_type("analysis", "a table", node)) };
    let known: Vec<_> = kinds.kinds.iter().map(|kind| kind.name.to_owned()).collect();
    let Some(entry) = table.get("kind") else {
        let expected = format!("kind = \"…\", one of {}", known.join(", "));
        let (key, section) = ("kind".to_owned(), "this analysis".to_owned());
        return Err(Cause::MissingKey { key, section, expected }.at(node.place));
    };
    let name = text("kind", &entry.node)?;
    if let Some(found) = kinds.find(name) {
        return Ok(found);
    }
    let (what, place) = ("analysis kind", entry.node.part(0..name.len()));
    let name = name.to_owned();
    Err(if registry.kinds().any(|kind| kind.name == name) {
        Cause::OtherModel { name, known }
    } else {
        Cause::UnknownName { what, name, known }
    }
    .at(place))
}
