//! Derives what is declared of results: a struct becomes a part of `summary.json`, arrays and columns of a table.
//!
//! ```text
//! #[derive(Results)]
//! #[results(along = "mode", arrays(mode, frequency), columns(mode, frequency))]
//! struct Modes {
//!     /// number of the mode
//!     #[result(hidden)]
//!     mode: Vec<i64>,
//!     /// natural frequency
//!     #[result(summary = "frequencies_hz", unit = "Hz")]
//!     frequency: Vec<f64>,
//!     /// modes of a free body
//!     rigid_modes: usize,
//! }
//! ```
//!
//! The fields in their order are the summary. The attribute of the struct takes
//!
//! - `arrays`, `columns`: which fields are arrays and columns of the table, in their order; their doc comments are the long names of the arrays;
//! - `along`: the dimensions of the arrays, parted by blanks;
//! - `rows`: each value is a row of a list, whose fields are arrays along this dimension; `prefix`: what the names of those arrays begin with.
//!
//! That of a field takes
//!
//! - `summary`: its key in the summary, where it is not called as the field is; `hidden`: it has none;
//! - `optional`: where there is none the key is left out and not `null`;
//! - `unit`, where it is no plain number; `column`: the head of its column, where that is not name and unit; `along`, where it lies along other dimensions than the others;
//! - `attribute`: it is an attribute of the dataset too;
//! - `rows`: the rows of this list are the arrays and columns that stand in its place; `flatten`: the keys, arrays and columns of these results are.

mod field;
mod results;

use proc_macro::TokenStream;
use syn::{DeriveInput, parse_macro_input};

/// A struct of results.
#[proc_macro_derive(Results, attributes(results, result))]
pub fn derive_results(input: TokenStream) -> TokenStream {
    results::derive(&parse_macro_input!(input as DeriveInput))
        .unwrap_or_else(syn::Error::into_compile_error)
        .into()
}
