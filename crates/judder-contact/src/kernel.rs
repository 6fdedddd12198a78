//! How the surface of the substrate yields under a pressure that slides along.
//!
//! - [`substrate`]: compliances and wakes at one speed of sliding.
//! - [`love`]: the elastic displacement under a square cell.
//! - [`wake`]: the same with the wake behind it, at all differences of two cells.
//! - [`mod@line`]: the same for infinitely long strips, the contact of a cylinder.
//! - [`layer`]: strips on a layer of finite thickness, whose surface has a place at rest.
//! - [`spectra`]: kernels as factors of Fourier modes, with their approximate inverses.
//! - [`cache`]: kernels that have been computed before.
//! - [`sliding`]: the operator that solvers use.
//! - [`periodic`]: the operator of a surface that repeats itself.
//! - [`check`]: what an operator can be made for.

pub mod cache;
pub mod check;
pub mod layer;
pub mod line;
pub mod love;
pub mod periodic;
mod quadrature;
mod recurrence;
pub mod sliding;
pub mod spectra;
pub mod substrate;
pub mod wake;
