//! What a run of judder leaves in its folder, written so that a reader sees the old content or the new, never half
//! of it. This crate knows no physics and no case files: it stores what it is handed.
//!
//! In the order in which the data flows:
//!
//! - [`Variable`], [`VariableValues`] (`variable.rs`) and [`Dataset`] (`dataset.rs`): named arrays with dimension names, units and
//!   long names, checked as they are put together so that `xarray` can open what is stored.
//! - [`Table`], [`Cells`] (`table.rs`): columns with units, for a spreadsheet.
//! - [`Results`], [`Rows`] (`declared.rs`): what an analysis leaves, a struct from which summary, arrays and table follow, and what keys a summary has.
//! - [`Summary`], [`AnalysisRecord`], [`Status`] (`summary.rs`): `summary.json`, which also says what is done, so that
//!   a rerun resumes.
//! - [`StudyFolder`] (`folder.rs`): the folder of one study: takes it, locks it, sweeps what a killed run left, and is the
//!   one door through which everything is written and read.
//! - [`SharedStudy`] (`shared.rs`): the same folder while several processes work on its sweeps; `lock.rs`: the locks of both; [`LockSign`] (`lock_sign.rs`): who holds one, and whether that process lives.
//! - [`StudyReader`] (`reader.rs`): the same folder, looked at while others may work on it; part by part, and nothing outside.
//! - [`Scratch`] (`scratch.rs`): what an analysis keeps while it runs.
//! - [`StreamWriter`] (`stream.rs`): a dataset in the making, too long for memory, with the checkpoint from which an interrupted analysis goes on.
//! - [`SweepLayout`], [`SweepStore`] (`sweep.rs`): many points, computed chunk by chunk by any number of processes.
//! - `zarr.rs`, `array.rs`: one dataset as one group of the Zarr v3 store `results.zarr`, and its arrays; `bounded_zstd.rs`: their compression; `metadata.rs`: the metadata of its groups,
//!   consolidated so that one read opens all; `group_store.rs`: its files as the array library writes them; `staging.rs`: the atomic write under all of the above, whose calls
//!   are those of `judder-disk`.
//! - `manifest.rs`: `manifest.json`, what a study was when it was written, so that damage is told from results ([`FileDamage`]); [`verify`] (`verify.rs`)
//!   compares all of a study with it. [`read_small_file`] (`plain.rs`): regular files, and no pipes and devices, nor
//!   files that are longer than their kind.
//! - [`content_hash`] (`hash.rs`) names a case or an analysis by its content.
//! - [`StoreError`] (`error.rs`): what can go wrong, and what to do about it.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]
#![deny(clippy::indexing_slicing, reason = "stored arrays may be of any length")]

mod array;
mod bounded_zstd;
mod dataset;
mod declared;
mod error;
mod folder;
mod group_store;
mod hash;
mod lock;
mod lock_sign;
mod manifest;
mod metadata;
mod name;
mod plain;
mod reader;
mod results;
mod scratch;
mod shared;
mod staging;
mod stream;
mod summary;
mod sweep;
mod table;
mod under_way;
mod variable;
mod verify;
mod zarr;

pub use dataset::Dataset;
pub use declared::{
    Array, ByName, Cell, Column, Declared, Element, GridValues, Results, Rows, Told, ValueKind,
};
pub use error::StoreError;
pub use folder::StudyFolder;
pub use hash::content_hash;
pub use lock_sign::{LockSign, lock_sign};
pub use manifest::{CheckedFile, FileDamage, SoundFiles, vouch_for, vouch_for_file};
pub use num_complex::Complex64;
pub use plain::{LARGEST_DOCUMENT, OversizedFile, read_small_file};
pub use reader::{DatasetHead, StudyReader};
pub use scratch::Scratch;
pub use shared::SharedStudy;
pub use stream::{StreamSlice, StreamWriter};
pub use summary::{AnalysisRecord, Status, Summary, number};
pub use sweep::{
    ChunkClaim, ChunkDamage, ChunkFile, ChunkPoints, ChunkState, ClaimAnswer, PointFailure, StoredChunk,
    SweepChunks, SweepDimension, SweepFailure, SweepLayout, SweepQuantity, SweepStore,
};
pub use table::{Cells, Table};
pub use under_way::{ClosedWrites, WriteUnderWay, close_writes};
pub use variable::{Variable, VariableValues};
pub use verify::{Finding, Verification, verify};
