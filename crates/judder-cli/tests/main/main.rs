//! The command from outside: exit codes, messages, documents, folders.

#![allow(clippy::expect_used, clippy::panic, clippy::unwrap_used, reason = "a test fails by panicking")]

mod bad_arguments;
mod bad_case;
mod bad_contact;
mod bad_folder;
mod beside_list;
mod desk;
// a program without debug assertions knows no fault
#[cfg(debug_assertions)]
mod disk_faults;
mod editors;
mod examples;
mod explore;
mod golden;
mod interrupt;
mod point;
mod reproduce;
mod run;
mod same_bits;
mod sliding;
mod speaking;
mod structure;
mod sweep;
