//! Case files: TOML text in, a typed and validated case out.
//!
//! - [`mod@text`]: the text as given. [`mod@file`]: the way in; `tree`: what it reads. [`resolved`]: the way out, canonical JSON for the hash and the
//!   report. [`root`]: what a case of any model has.
//! - [`analysis`]: a name that serves as a file name, and a kind with its settings.
//! - [`scale`], [`key_sweep`], [`study_sweep`]: any number of a case that varies, and `[[sweep]]`, the whole case at many points.
//! - [`options`], [`mod@compose`]: options, and one analysis, written into the text of a case; one of its analyses alone. [`mod@anywhere`]: its files by whole
//!   paths.
//! - [`mod@keys`]: what a case may say, as data. [`mod@schema`], [`mod@reference`]: the JSON Schema for editors, the book's reference.

pub mod analysis;
pub mod anywhere;
pub mod compose;
pub mod file;
pub mod key_sweep;
pub mod keys;
pub mod options;
pub mod reference;
pub mod resolved;
pub mod root;
pub mod scale;
pub mod schema;
pub mod study_sweep;
pub mod text;
mod tree;
