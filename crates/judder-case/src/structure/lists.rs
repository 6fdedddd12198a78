//! Lists of the wrong length.

use super::problem::StructureProblem;
use crate::document::{Data, Node};
use crate::error::Fault;
use crate::problem::Placed;
use crate::section::Section;

/// The refusal of a list of the wrong length.
pub(crate) fn length(section: &Section<'_>, key: &str, expected: &'static str, node: &Node) -> Fault {
    let found = if let Data::List(items) = &node.data { items.len() } else { 0 };
    StructureProblem::Length { key: section.path(key), expected, found }.at(node.place)
}
