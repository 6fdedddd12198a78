//! Studies: a case file in, a folder with results, figures and a report out.
//!
//! In the order in which the data flows:
//!
//! - [`case`]: case files, typed and validated.
//! - [`bridge`]: from the keys of a case to the oscillator and its contact.
//! - `input_file`, `spectrum_source`, `material`, `indenter`: the files that a case names, the substrate, the surface that presses.
//! - `measured_band`: the frequencies that sliding excites, against those of measured moduli.
//! - `known_substrate`: what is to be said of the substrate of an oscillator case.
//! - [`law_cache`]: material and law of a case whose numbers move; a law over speeds and depths.
//! - `within_law`: what the errors of a contact law leave of results, in words.
//! - `model`: what is asked of a model and of an analysis, by everything that follows.
//! - `models`: a folder a model, in it a folder an analysis; the only list of them.
//! - [`outcome`]: what an analysis leaves: scalars, arrays, a table, checks, warnings.
//! - [`analyses`]: an analysis alone, in no study folder.
//! - [`checks`]: every number doubted by another number.
//! - [`sweep`]: the case at many points, in chunks that any number of processes share.
//! - [`run`]: the analyses and sweeps of a case into a study folder; what is done already is not done again. `ledger`: what the folder says of
//!   them. `told`: what is shown on the terminal. [`home`]: which folder, where nobody names one.
//! - [`pictures`]: figures from stored arrays.
//! - [`report`]: figures and page of a study folder, rebuilt from what is stored.
//! - [`study_view`]: a study folder for a page, not held: what it holds, parts of its arrays.
//! - [`resolve`]: what `judder check` shows.

pub mod analyses;
pub mod band;
pub mod bridge;
pub mod case;
pub mod checks;
pub mod computed_law;
mod error;
pub mod home;
mod indenter;
pub mod input_file;
pub mod kept;
mod known_substrate;
pub mod labels;
pub mod law_cache;
pub mod ledger;
pub mod material;
mod measured_band;
pub mod model;
pub mod models;
pub mod outcome;
pub mod pictures;
mod progress;
pub mod report;
mod report_tables;
pub mod resolve;
pub mod run;
mod spectrum_source;
pub mod study_view;
pub mod sweep;
mod text;
mod told;
mod within_law;

pub use error::StudyError;
pub use models::oscillator::{key_plane, point, quasi_steady};
pub use models::sliding::{coupled_pair, shapes as sliding_shapes};
pub use progress::{Progress, Silent};
