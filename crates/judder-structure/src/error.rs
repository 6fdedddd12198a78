use crate::element::ElementKind;
use thiserror::Error;

/// Why there is no structure.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum StructureError {
    /// A number is out of its range.
    #[error("{name} is {value}: it must be {requirement}")]
    InvalidNumber {
        /// Which.
        name: &'static str,
        /// Its value.
        value: f64,
        /// What it must be.
        requirement: &'static str,
    },
    /// An element is folded or flat.
    #[error(
        "element {element} ({kind}) is folded or flat: its Jacobian determinant is {determinant:e} at {place:?}; are its nodes in order?"
    )]
    Folded {
        /// Its number from 0, in the order of the mesh.
        element: usize,
        /// Its shape.
        kind: ElementKind,
        /// Where, in its own coordinates.
        place: [f64; 3],
        /// The determinant there.
        determinant: f64,
    },
    /// An element of the plane is given as a solid, or the other way round.
    #[error("{kind}s have {dimension} dimensions, their section has {section}")]
    WrongSection {
        /// The shape.
        kind: ElementKind,
        /// Of the shape.
        dimension: usize,
        /// Of the section.
        section: usize,
    },
    /// An element names a node that the mesh does not have.
    #[error("element {element} names node {node}, the mesh has {nodes} nodes (counted from 0)")]
    UnknownNode {
        /// Its number from 0, in the order of the mesh.
        element: usize,
        /// The node that it names.
        node: usize,
        /// How many there are.
        nodes: usize,
    },
    /// The list of an element's nodes is too short or too long.
    #[error("{found} node numbers do not make {kind}s of {nodes} nodes each")]
    BrokenConnectivity {
        /// The shape.
        kind: ElementKind,
        /// The nodes of one.
        nodes: usize,
        /// Node numbers in the list.
        found: usize,
    },
}
