//! Meshes: nodes, blocks of elements of one kind, named sets.

use crate::StructureError;
use crate::element::ElementKind;
use std::collections::BTreeMap;

/// Nodes and elements with named sets of them.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Mesh {
    /// Places in m; z is zero in the plane.
    pub nodes: Vec<[f64; 3]>,
    /// Elements; their numbers run on from block to block.
    pub blocks: Vec<MeshBlock>,
    /// Nodes by the name of the set; where a set is an edge they stand in its order.
    pub node_sets: BTreeMap<String, Vec<usize>>,
    /// Elements by the name of the set.
    pub element_sets: BTreeMap<String, Vec<usize>>,
    /// Sides of elements by the name of the set.
    pub side_sets: BTreeMap<String, Vec<ElementSide>>,
}

/// Elements of one kind and material.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshBlock {
    /// Their shape.
    pub kind: ElementKind,
    /// The name of their material.
    pub material: String,
    /// The nodes of one after the other.
    pub connectivity: Vec<usize>,
}

/// A side of an element.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ElementSide {
    /// The element's number in the mesh.
    pub element: usize,
    /// The place in [`ElementKind::sides`].
    pub side: usize,
}

impl Mesh {
    /// Elements in all blocks.
    #[must_use]
    pub fn elements(&self) -> usize {
        self.blocks.iter().map(|block| block.connectivity.len() / block.kind.nodes()).sum()
    }

    /// Whether every element has its nodes, and they exist and are finite.
    ///
    /// # Errors
    /// [`StructureError::BrokenConnectivity`], [`StructureError::UnknownNode`], [`StructureError::InvalidNumber`].
    pub fn check(&self) -> Result<(), StructureError> {
        let mut element = 0;
        for block in &self.blocks {
            let (kind, nodes, found) = (block.kind, block.kind.nodes(), block.connectivity.len());
            if found % nodes != 0 {
                return Err(StructureError::BrokenConnectivity { kind, nodes, found });
            }
            for own in block.connectivity.chunks(nodes) {
                if let Some(node) = own.iter().find(|node| **node >= self.nodes.len()) {
                    return Err(StructureError::UnknownNode {
                        element,
                        node: *node,
                        nodes: self.nodes.len(),
                    });
                }
                element += 1;
            }
        }
        match self.nodes.iter().flatten().find(|place| !place.is_finite()) {
            Some(value) => Err(StructureError::InvalidNumber {
                name: "the place of a node",
                value: *value,
                requirement: "finite",
            }),
            None => Ok(()),
        }
    }
}
