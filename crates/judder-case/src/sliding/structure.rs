//! `[[structure]]`: the two structures of a sliding case.

use std::path::Path;

use super::problem::SlidingProblem;
use crate::cause::Cause;
use crate::contact_problem::ContactProblem;
use crate::declared::{Setting, Settings, both};
use crate::document::Node;
use crate::error::Fault;
use crate::section::{Section, list, text};
use crate::structure::StructureSource;
use crate::structure::body::{BodyKeys, read_body};
use crate::structure::damping::Damping;
use crate::structure::matrices::{self, read_matrices};
use crate::structure::reduction::{self, FIXED_MODES, FixedModes, Reduction, read_reduction};

/// One of the two structures.
#[derive(Debug, Clone)]
pub struct SlidingStructure {
    /// Its name, of letters, digits, `_` and `-`.
    pub name: String,
    /// Where it comes from.
    pub source: StructureSource,
    /// Its own damping; matrices have theirs.
    pub damping: Damping,
    /// The modes that its reduction keeps, and what freedoms it keeps beside those that contact, load and observed points need.
    pub reduction: Reduction,
}

/// The keys of a structure beside those of a body.
pub(crate) const OWN_KEYS: [&str; 4] = ["name", "matrices", "damping", "reduction"];

/// Reads `[[structure]]`: two tables; factors of matrices are expressions of `parameters`.
pub(super) fn read_structures(
    root: &Section<'_>,
    parameters: &[String],
    folder: &Path,
) -> Result<[SlidingStructure; 2], Fault> {
    let node = root.required("structure", "[[structure]], one table for each of the two structures")?;
    let nodes = list("structure", node)?;
    let [first, second] = nodes else {
        return Err(SlidingProblem::StructureCount { found: nodes.len() }.at(node.place));
    };
    let read = |node: &Node| read_structure(node, parameters, folder);
    let (first_structure, second_structure) = both(read(first), read(second))?;
    let structures = [first_structure, second_structure];
    if structures[0].name == structures[1].name {
        let (what, name) = ("structure", structures[1].name.clone());
        return Err(SlidingProblem::NameTwice { what, name }.at(second.place));
    }
    Ok(structures)
}

fn read_structure(node: &Node, parameters: &[String], folder: &Path) -> Result<SlidingStructure, Fault> {
    let known: Vec<&str> = OWN_KEYS.iter().chain(BodyKeys::KEYS).copied().collect();
    let section = Section::open(node, "structure", "a structure", &known)?;
    let name = read_name(&section, "structure")?;
    let section =
        Section::open(node, &format!("structure.{name}"), &format!("the structure `{name}`"), &known)?;
    let damping = section.get("damping").map(|node| Setting::read(&section, "damping", node, &()));
    let damping = damping.unwrap_or_else(|| Ok(Damping::default()));
    let (source, damping) = both(read_source(&section, parameters, folder), damping)?;
    let reduction = match section.get("reduction") {
        Some(node) => read_reduction(&section.table("reduction", node, &reduction::KEYS)?, &source)?,
        None => Reduction { kept: Vec::new(), modes: FixedModes::Count(FIXED_MODES) },
    };
    Ok(SlidingStructure { name, source, damping, reduction })
}

fn read_source(
    section: &Section<'_>,
    parameters: &[String],
    folder: &Path,
) -> Result<StructureSource, Fault> {
    match section.get("matrices") {
        Some(node) => {
            refuse_beside_matrices(section)?;
            let sums = section.table("matrices", node, &matrices::KEYS)?;
            Ok(StructureSource::Matrices(Box::new(read_matrices(&sums, parameters, folder)?)))
        }
        None if ["beam", "block", "mesh"].iter().all(|key| section.get(key).is_none()) => {
            let expected = "beam = { … }, block = { … }, mesh = \"file.msh\" or matrices = { … }";
            Err(section.missing("beam", expected))
        }
        None => Ok(StructureSource::Body(Box::new(read_body(section, folder)?))),
    }
}

/// Matrices have no body and no other damping beside them.
fn refuse_beside_matrices(section: &Section<'_>) -> Result<(), Fault> {
    for key in BodyKeys::KEYS.iter().copied().chain(["damping"]) {
        if let Some(node) = section.get(key) {
            let problem = ContactProblem::Meaningless { key, with: section.path("matrices") };
            return Err(Cause::Contact { problem }.at(node.place));
        }
    }
    Ok(())
}

/// The `name` of a thing, such that dotted paths can contain it.
pub(super) fn read_name(section: &Section<'_>, what: &'static str) -> Result<String, Fault> {
    let node = section.required("name", &format!("name = \"…\", by which keys call this {what}"))?;
    let name = text(&section.path("name"), node)?;
    let plain = |byte: u8| byte.is_ascii_alphanumeric() || matches!(byte, b'_' | b'-');
    if (1..=100).contains(&name.len()) && name.bytes().all(plain) {
        return Ok(name.to_owned());
    }
    Err(SlidingProblem::Name { what, name: name.to_owned() }.at(node.place))
}

/// The index of the structure that `key` names.
pub(super) fn find_structure(
    structures: &[SlidingStructure; 2],
    section: &Section<'_>,
    key: &str,
) -> Result<usize, Fault> {
    let known = || structures.iter().map(|structure| structure.name.clone()).collect::<Vec<_>>();
    let expected = format!("{key} = \"…\", one of {}", known().join(", "));
    let node = section.required(key, &expected)?;
    let name = text(&section.path(key), node)?;
    structures.iter().position(|structure| structure.name == name).ok_or_else(|| {
        let (what, name) = ("structure", name.to_owned());
        Cause::UnknownName { what, name, known: known() }.at(node.place)
    })
}
