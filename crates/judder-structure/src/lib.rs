//! Linear structures: what vibrates beside the contact.
//!
//! In the order in which the data flows:
//!
//! - [`mesh`]: nodes, elements, named sets.
//! - [`material`]: linear elasticity, plane stress, plane strain.
//! - [`element`]: shape functions, quadrature, stiffness and consistent mass of one element.

pub mod element;
mod error;
pub mod material;
pub mod mesh;

pub use error::StructureError;
