//! `[[structure]]`: the two structures of a sliding case.

use std::path::Path;

use super::plain_name::PlainName;
use super::problem::SlidingProblem;
use crate::structure::case::StructureSource;
use crate::structure::case::body::{BodyKeys, read_body};
use crate::structure::case::damping::Damping;
use crate::structure::case::matrices::{self, read_matrices};
use crate::structure::case::reduction::{FIXED_MODES, FixedModes, Reduction};
use judder_keys::cause::Cause;
use judder_keys::declared::{Named, Setting, Settings, both};
use judder_keys::document::Node;
use judder_keys::error::Fault;
use judder_keys::problem::Placed;
use judder_keys::section::{Section, list};

/// One of the two structures.
#[derive(Debug, Clone)]
pub struct SlidingStructure {
    /// Its name, of letters, digits, `_` and `-`.
    pub name: PlainName,
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
        let (what, name) = ("structure", structures[1].name.to_string());
        return Err(SlidingProblem::NameTwice { what, name }.at(second.place));
    }
    Ok(structures)
}

fn read_structure(node: &Node, parameters: &[String], folder: &Path) -> Result<SlidingStructure, Fault> {
    let known = [&OWN_KEYS[..], &BodyKeys::keys()].concat();
    let section = Section::open(node, "structure", "a structure", &known)?;
    let expected = "name = \"…\", by which keys call this structure";
    let name = PlainName::read(&section, "name", section.required("name", expected)?, &"structure")?;
    let (path, title) = (format!("structure.{}", *name), format!("the structure `{}`", *name));
    let section = Section::of_table(node, &path, &title)?;
    let damping = section.get("damping").map(|node| Setting::read(&section, "damping", node, &()));
    let damping = damping.unwrap_or_else(|| Ok(Damping::default()));
    let (source, damping) = both(read_source(&section, parameters, folder), damping)?;
    let reduction = match section.inner("reduction")? {
        Some(own) => Reduction::of(&own, &source)?,
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
    for key in BodyKeys::keys().into_iter().chain(["damping"]) {
        if let Some(node) = section.get(key) {
            let problem = Cause::Meaningless { key, with: section.path("matrices") };
            return Err(problem.at(node.place));
        }
    }
    Ok(())
}

/// Finds the structure that `structure` of a section names.
pub(crate) fn find_structure(
    named: &mut Named<usize>,
    structures: &[SlidingStructure; 2],
    section: &Section<'_>,
) -> Result<(), Fault> {
    let known: Vec<String> = structures.iter().map(|structure| structure.name.to_string()).collect();
    let node = section.required("structure", &format!("structure = \"…\", one of {}", known.join(", ")))?;
    let found = known.iter().position(|other| *other == named.name).ok_or_else(|| {
        Cause::UnknownName { what: "structure", name: named.name.clone(), known }.at(node.place)
    });
    found.map(|found| named.found = found)
}
