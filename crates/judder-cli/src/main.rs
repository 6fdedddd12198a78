//! `judder`, the command; everything of it is in the library beside.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

use std::process::ExitCode;

fn main() -> ExitCode {
    ExitCode::from(judder_cli::main_with(std::env::args_os()))
}
