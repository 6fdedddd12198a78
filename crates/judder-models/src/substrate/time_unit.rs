//! In which unit a case has the times of its substrate.

use judder_keys::dimension::Dimension;
use judder_keys::document::{Data, Node};
use judder_keys::quantity::{Quantity, WrittenUnit};
use judder_keys::section::Section;

/// The unit of the first time of `[substrate]`; that of a case that gives none is the second.
pub(crate) fn time_unit(root: &Section<'_>) -> WrittenUnit {
    let written = root.get("substrate").and_then(first_time);
    written.unwrap_or_else(|| WrittenUnit::si(Dimension::TIME))
}

fn first_time(node: &Node) -> Option<WrittenUnit> {
    match &node.data {
        Data::Text(text) => {
            let is_time = Quantity::parse(text).is_ok_and(|own| own.dimension == Dimension::TIME);
            is_time.then(|| WrittenUnit::of(text)).flatten()
        }
        Data::Table(table) => table.entries.iter().find_map(|entry| first_time(&entry.node)),
        Data::List(items) => items.iter().find_map(first_time),
        _ => None,
    }
}
