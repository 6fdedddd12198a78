//! Case files: TOML text in, a typed and validated case out.
//!
//! - [`mod@file`]: the way in. `resolved`: the way out, canonical JSON for the hash and the report.
//! - [`analysis`]: a name that serves as a file name, and a kind with its settings.
//! - [`key_sweep`], [`study_sweep`]: any number of a case that varies, and `[[sweep]]`, the whole case at many points.
//! - [`mod@compose`]: options, and one analysis, written into the text of a case; one of its analyses alone. [`mod@anywhere`]: its files by whole
//!   paths.
//! - [`mod@schema`], [`mod@reference`], [`mod@template`]: the JSON Schema for editors, the book's reference, the commented cases of `judder new`.

pub mod analysis;
pub mod anywhere;
pub mod compose;
pub mod file;
pub mod key_sweep;
pub mod reference;
pub(crate) mod resolved;
pub mod schema;
pub mod study_sweep;
pub mod template;
