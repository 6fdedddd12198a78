//! Finite elements: shape functions, quadrature, stiffness and mass.

pub mod kind;
pub mod matrices;
pub mod quadrature;
pub mod shape;

pub use kind::ElementKind;
pub use matrices::{BlockElements, ElementMatrices};
