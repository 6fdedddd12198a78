//! Studies: a case file in, a folder with results, figures and a report out.
//!
//! In the order in which the data flows:
//!
//! - [`bridge`]: from the keys of a case to the oscillator and its contact.
//! - `input_file`, `spectrum_source`, `material`, `indenter`: the files that a case names, the substrate, the surface that presses.
//! - `measured_band`: the frequencies that sliding excites, against those of measured moduli.
//! - `known_substrate`: what is to be said of the substrate of an oscillator case.
//! - `door`: what is refused of a contact case before anything runs.
//! - `structure`: the structure of a case: elements assembled, matrices read.
//! - `sliding`: the pair of a sliding case: both structures reduced, the contact between them.
//! - [`coupled_pair`]: the pair of a sliding case for whoever marches it by himself.
//! - [`sliding_shapes`]: the shapes in which a pair swings at any position, on all points of both structures.
//! - [`quasi_steady`]: eq. (3), on which laws of steady sliding stand in motion, and what is told of it.
//! - `within_law`: what the errors of a contact law leave of results, in words.
//! - [`point`]: everything about one operating point.
//! - [`key_plane`]: the operating points over two keys of a case.
//! - [`law_cache`]: material and law of a case whose numbers move; a law over speeds and depths.
//! - [`outcome`]: what an analysis leaves: scalars, arrays, a table, checks, warnings.
//! - [`analyses`]: one module a kind of analysis.
//! - [`checks`]: every number doubted by another number.
//! - [`sweep`]: the case at many points, in chunks that any number of processes share.
//! - [`run`]: the analyses and sweeps of a case into a study folder; what is done already is not done again. `ledger`: what the folder says of
//!   them. `told`: what is shown on the terminal. [`home`]: which folder, where nobody names one.
//! - [`pictures`]: figures from stored arrays.
//! - [`report`]: figures and page of a study folder, rebuilt from what is stored.
//! - [`study_view`]: a study folder for a page, not held: what it holds, parts of its arrays.
//! - [`resolve`]: what `judder check` shows.
//! - [`reproduce`]: the oscillator paper, figure by figure, with its scoreboard.

pub mod analyses;
mod band;
pub mod bridge;
pub mod checks;
mod computed_law;
pub mod coupled_pair;
mod door;
mod error;
pub mod home;
mod indenter;
mod input_file;
mod kept;
pub mod key_plane;
mod known_substrate;
mod labels;
pub mod law_cache;
mod ledger;
mod material;
mod measured_band;
pub mod outcome;
pub mod pictures;
pub mod point;
mod progress;
pub mod quasi_steady;
pub mod report;
mod report_tables;
pub mod reproduce;
pub mod resolve;
pub mod run;
mod sliding;
pub mod sliding_shapes;
mod spectrum_source;
mod structure;
pub mod study_view;
pub mod sweep;
mod text;
mod told;
mod within_law;

pub use error::StudyError;
pub use progress::{Progress, Silent};
