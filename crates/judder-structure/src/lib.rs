//! Linear structures: what vibrates beside the contact.
//!
//! In the order in which the data flows:
//!
//! - [`mesh`]: nodes, elements, named sets; [`beam`] makes one of a straight beam, [`grid`] of a box, with [`chamfer`]s where asked, [`disc`] of a ring.
//! - [`material`]: linear elasticity, plane stress, plane strain.
//! - [`element`]: shape functions, quadrature, stiffness and consistent mass of one element.
//! - [`freedom`]: which displacements are free, tied, held.
//! - [`assembly`]: sparse stiffness and mass of a mesh.
//! - [`rotation`]: what turns with a body: gyroscopic and centrifugal matrices, in the frame that turns or in the one that stands still.
//! - [`factor`]: the factorisation of a symmetric matrix, with the count of its negative eigenvalues.
//! - [`definiteness`]: how many eigenvalues of a symmetric matrix are negative or zero.
//! - [`modes`]: undamped modes, with a count that shows whether one is missing.
//! - [`rigid`]: which eigenvalues are those of rigid motions.
//! - [`craig_bampton`]: a structure on the freedoms that are kept and its lowest fixed-interface modes.
//! - [`interface_modes`]: the freedoms that are kept for contacts, reduced themselves.
//! - [`modal_form`]: a reduced structure in its own modes, and the flexibility of those that are cut off.
//! - [`reduction_error`]: how far reduced frequencies can be from full ones, told by the reduction alone.
//! - [`reduction_report`]: a reduced structure beside the full one.
//! - [`damping`]: Rayleigh's, and viscous in place of structural.
//! - [`quadratic`]: mass, damping and stiffness of a structure that need not be symmetric, [`affine`]: as sums of matrices with factors.
//! - [`asked_region`]: which eigenvalues are asked for.
//! - [`complex_modes`]: all eigenvalues of a region of the complex plane, each with its error and verdict.
//! - [`eigen_sweep`]: complex modes over parameters, followed from point to point.
//! - [`onset`]: where along a parameter modes begin or cease to grow.
//! - [`diagnosis`]: why a mode grows.
//! - [`receptance`]: the displacement of one degree of freedom under a harmonic force on another.
//! - [`statics`]: displacements under loads that rest.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

pub mod affine;
pub mod asked_region;
pub mod assembly;
pub mod beam;
pub mod chamfer;
pub mod complex_modes;
pub mod craig_bampton;
pub mod damping;
pub mod definiteness;
pub mod diagnosis;
mod direction;
pub mod disc;
pub mod eigen_sweep;
pub mod element;
mod error;
pub mod factor;
pub mod freedom;
pub mod grid;
pub mod interface_modes;
pub mod material;
pub mod mesh;
pub mod modal_form;
pub mod modes;
pub mod onset;
pub mod quadratic;
pub mod receptance;
pub mod reduction_error;
pub mod reduction_report;
pub mod rigid;
pub mod rotation;
pub mod statics;

pub use error::StructureError;
