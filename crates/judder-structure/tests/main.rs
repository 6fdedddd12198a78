//! Linear structures, by the kind of evidence.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

mod convergence;
mod property;
mod validation;

use judder_structure::assembly::{Assembled, assemble};
use judder_structure::freedom::{Direction, Numbering, Supports};
use judder_structure::material::{Elastic, ElementSection};
use judder_structure::mesh::Mesh;
use std::collections::BTreeMap;

/// A mesh all of one material, with its sections and supports.
struct Body {
    mesh: Mesh,
    material: Elastic,
    section: ElementSection,
}

impl Body {
    fn numbering(&self, supports: &Supports) -> Numbering {
        Numbering::new(&self.mesh, self.section.dimension(), supports).unwrap()
    }

    fn assembled(&self, numbering: &Numbering) -> Assembled {
        let names: Vec<String> = self.mesh.blocks.iter().map(|block| block.material.clone()).collect();
        let materials: BTreeMap<_, _> =
            names.into_iter().map(|name| (name, (self.material, self.section))).collect();
        assemble(&self.mesh, &materials, numbering).unwrap()
    }

    /// All displacements of these nodes held.
    fn held(&self, nodes: &[usize]) -> Supports {
        let directions = &Direction::ALL[..self.section.dimension()];
        Supports {
            fixed: nodes.iter().flat_map(|node| directions.iter().map(move |d| (*node, *d))).collect(),
            ..Supports::default()
        }
    }
}
