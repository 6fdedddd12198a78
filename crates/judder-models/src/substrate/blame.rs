//! Which key of a substrate is to blame.

use judder_keys::document::Data;
use judder_keys::error::Place;
use judder_keys::section::Section;

/// Where the ratio of the moduli was given: the key that says most about it.
pub(crate) fn moduli_place(root: &Section<'_>) -> Place {
    let node = match root.get("substrate").map(|node| &node.data) {
        Some(Data::Table(table)) => {
            ["prony", "relaxation", "continuous", "dma", "glassy_modulus", "rubbery_modulus"]
                .into_iter()
                .find_map(|key| table.get(key))
        }
        _ => None,
    };
    node.map_or(root.place, |entry| entry.node.place)
}
