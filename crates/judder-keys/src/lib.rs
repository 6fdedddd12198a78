//! Keys of case files: TOML text in, typed settings with exact places of what is wrong out. No physics, and no word of any model.
//!
//! The modules in the order in which the data flows:
//!
//! - [`document`]: the TOML text as a tree whose every value knows its place; `--set` options are grafted onto it. [`edited`]: the text itself,
//!   edited with its comments kept.
//! - [`dimension`], [`quantity`]: `"3.5 kN/m"` becomes a number in SI units with its dimension. [`expression`]: `"1 - 4*mu/3"`.
//! - [`numeric_key`]: plain numbers and numbers with units, and their ranges.
//! - [`section`]: typed reading of one table.
//! - [`declared`]: settings declared once, from whose fields reading, canonical form, schema and reference follow. [`keys`]: the numbers of a case that its
//!   analyses vary, declared as the variants of an enum.
//! - [`file_reference`], [`memory`], [`span`]: values that several models have: files, amounts of memory, ranges with equal ratios.
//! - [`cause`], [`problem`], `help`, [`nearest`], `excerpt`, [`error`]: what is wrong, what would be right, where.
//! - [`schema`], [`mod@reference`]: pieces of the JSON Schema and of the book's reference.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

extern crate self as judder_keys;

pub mod cause;
pub mod declared;
pub mod dimension;
pub mod document;
pub mod edited;
pub mod error;
mod excerpt;
pub mod expression;
pub mod file_reference;
mod help;
pub mod keys;
pub mod memory;
pub mod nearest;
pub mod numeric_key;
pub mod problem;
pub mod quantity;
mod range;
pub mod reference;
pub mod schema;
pub mod section;
pub mod span;

pub use judder_keys_derive::{Choice, Keys, Settings};
/// What is derived names it, in crates that need not depend on it.
#[doc(hidden)]
pub use serde_json;
