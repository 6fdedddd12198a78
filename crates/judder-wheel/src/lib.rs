//! The library that the Python package loads: the module `_judder` of [`judder_python`], and nothing else.
//!
//! A crate of its own, because the level at which a library is optimised across the crates is that of the crate that makes it: this one's is that of what
//! computes, and the bindings, which are glue, are compiled small.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

pub use judder_python as bindings;
