//! Every change that judder makes on a disk, call by call, so that a test can make any of them fail.
//!
//! - `calls.rs`: folders, files, renames, removals: those of the system.
//! - [`StagingFolder`], [`StagedFile`] (`staged.rs`): what is put together before it takes its place; it goes when it is dropped.
//! - [`write_whole`] (`whole.rs`): files that are there as a whole or not at all.
//! - [`kind_in_words`] (`kind.rs`): what stands at a place.
//! - `fault.rs`: the fault that a test asks for.
//!
//! # Faults
//!
//! A program with debug assertions, which is none that is shipped, counts these calls and reads `JUDDER_DISK_FAULT`: `full@17` fails the 17th and all after it
//! that take room, as a full disk does; `broken@17` fails the 17th alone; `end@17` ends the process there. A write that is struck leaves half of
//! its bytes. Standard error says which call it was.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod calls;
mod fault;
mod kind;
mod staged;
mod whole;

pub use calls::{
    create_file, create_folder, create_folders, create_new_file, exchange, open_lasting, remove, remove_file,
    rename, set_length, sync, sync_folder, write,
};
pub use fault::FAULT_VARIABLE;
pub use kind::kind_in_words;
pub use staged::{StagedFile, StagingFolder};
pub use whole::{remove_leftovers, write_whole};
