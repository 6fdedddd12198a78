//! Lists of the wrong length.

use judder_keys::cause::Cause;
use judder_keys::document::{Data, Node};
use judder_keys::error::Fault;
use judder_keys::section::Section;

/// The refusal of a list of the wrong length.
pub(crate) fn length(section: &Section<'_>, key: &str, expected: &'static str, node: &Node) -> Fault {
    let found = if let Data::List(items) = &node.data { items.len() } else { 0 };
    Cause::Length { key: section.path(key), expected, found }.at(node.place)
}
