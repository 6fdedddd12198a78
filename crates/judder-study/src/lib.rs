//! Studies: a case file in, a folder with results, figures and a report out.
//!
//! The engine knows no model and no analysis by name: what it asks of them stands in [`model`], and which there are a [`registry::Registry`]
//! says, which a case is read with.
//!
//! In the order in which the data flows:
//!
//! - [`case`]: case files, typed and validated.
//! - [`input_file`]: the files that a case names.
//! - [`model`]: what is asked of a model and of an analysis, by everything that follows. [`registry`]: the models that there are.
//! - [`outcome`]: what an analysis leaves: scalars, arrays, a table, checks, warnings.
//! - [`analyses`]: an analysis alone, in no study folder. [`kept`]: what an interrupted run has left of one.
//! - [`axis`], [`labels`]: swept quantities as coordinates of arrays, and how they are called.
//! - [`sweep`]: the case at many points, in chunks that any number of processes share.
//! - [`run`]: the analyses and sweeps of a case into a study folder, where what is done already is not done again, or in memory. [`ledger`]: what the folder says of
//!   them. `terminal_tables`: what is shown on the terminal. [`home`]: which folder, where nobody names one; `way`: from it to the case file.
//! - [`pictures`]: figures from stored arrays.
//! - [`report`], [`report_tables`]: figures and page of a study folder, rebuilt from what is stored.
//! - [`study_view`]: a study folder for a page, not held: what it holds, parts of its arrays.
//! - [`fn@version`]: which judder this is, as studies are stamped with it.
//! - [`maker`]: that and the processor, as files are.
//! - [`resolve`], [`text`]: what `judder check` shows. [`fault_told`]: what a panic says.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

pub mod analyses;
pub mod axis;
pub mod case;
mod error;
mod fault;
pub mod home;
pub mod input_file;
pub mod kept;
pub mod labels;
pub mod ledger;
pub mod model;
pub mod outcome;
pub mod pictures;
pub mod prefixed;
mod progress;
pub mod registry;
pub mod report;
pub mod report_tables;
pub mod resolve;
pub mod run;
pub mod shown;
pub mod study_view;
pub mod sweep;
mod terminal_tables;
pub mod text;
mod version;
mod way;

pub use error::{ModelFault, StudyError, WrongArray};
pub use fault::fault_told;
pub use progress::{Progress, Silent, Untold};
pub use registry::Registry;
pub use version::{maker, name_version, version};
