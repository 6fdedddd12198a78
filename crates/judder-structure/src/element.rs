//! Finite elements: shape functions, quadrature, stiffness and mass.

pub mod kind;
pub mod matrices;
pub mod quadrature;
mod rotation;
pub mod shape;

pub use kind::ElementKind;
pub use matrices::{BlockElements, ElementMatrices};
pub(crate) use rotation::RotatingElement;
