//! Eigenvalues, solutions and products of dense matrices.
//!
//! The algorithms of faer are generic: a crate that calls one compiles it anew, its unit tests once more. Here they are compiled once, for
//! the numbers that are used.
//!
//! - [`symmetric`]: eigenvalues of symmetric matrices, and of pairs of them.
//! - [`general`]: eigenvalues, solutions and pivots of matrices that need not be symmetric.
//! - `product`: the product of two.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

pub mod general;
pub mod product;
pub mod symmetric;
