//! Sweeps of whole studies: a case at many points, in chunks that any number of processes share.
//!
//! In the order in which the data flows:
//!
//! - `plan`: what a sweep stores, under which hash, in which chunks.
//! - `scalars`: a number out of the results of an analysis.
//! - `evaluate`: the points of a chunk.
//! - [`shard`]: which chunks are whose; `chunks`: chunks claimed, computed, written.
//! - `waiting`: for what another process holds.
//! - `part`: chunks and points for whoever hands them out to machines of his own.
//! - `dry_run`: what a sweep would take.
//! - `statistics`, `indices`: what a finished sweep says: extremes, failures, sensitivity.
//! - `finish`: a finished sweep as an outcome.

mod chunks;
mod dry_run;
mod evaluate;
mod finish;
mod indices;
mod part;
mod plan;
mod probabilities;
mod scalars;
pub mod shard;
mod statistics;
mod waiting;

pub(crate) use chunks::{compute_anew, mend, work};
pub use dry_run::SweepEstimate;
pub use evaluate::Evaluator;
pub(crate) use finish::{ReadChunks, SweepReading, read};
pub use part::{Handed, joined, missing};
pub use plan::SweepPlan;
pub(crate) use plan::check_together;
pub use shard::Shard;
pub(crate) use waiting::when_free;
