//! `judder`, the command: arguments in, one call into a lower floor, a result on standard output, an exit code.
//!
//! A library besides, so that the Python package carries the same command.
//!
//! In the order in which the data flows:
//!
//! - `arguments`: the command line as types, with the help texts.
//! - `commands`: one module a command; each makes one call into `judder-study` and prints what came of it.
//! - `threads`, `interrupt`, `progress`: the pool of `--threads`, Ctrl-C, bars and times.
//! - `failure`: every error with its message, place, help and exit code.
//! - `console`: results to standard output, all else to standard error.
//! - `scoreboard`: the table of `judder reproduce`.

mod arguments;
mod commands;
mod console;
mod failure;
mod interrupt;
mod progress;
mod scoreboard;
mod threads;

use std::ffi::OsString;

use clap::error::ErrorKind;
use clap::{CommandFactory, Parser};

use crate::arguments::Arguments;
use crate::console::Console;
use crate::failure::Exit;

/// The version of the program: its number and, where they are known, the sources it was built from, such as `0.1.0+4d3b94b50f1e`.
pub const VERSION: &str = env!("JUDDER_VERSION");

/// [`VERSION`] with how it was built.
const BUILD: &str =
    concat!(env!("JUDDER_VERSION"), " (", env!("JUDDER_PROFILE"), " build, ", env!("JUDDER_TARGET"), ")");

/// The command line as it is declared, of which the manual pages are written.
#[must_use]
pub fn command_line() -> clap::Command {
    Arguments::command()
}

/// Does what a command line asks for, the name of the program first, and returns the exit code: 0 all done, 1 a result is missing,
/// 2 the input is wrong. Results go to standard output, all else to standard error.
#[must_use]
pub fn main_with(arguments: impl IntoIterator<Item = OsString>) -> u8 {
    judder_study::name_version(VERSION);
    let words: Vec<OsString> = arguments.into_iter().collect();
    let (console, outcome) = match Arguments::try_parse_from(&words) {
        Ok(arguments) => {
            let console = arguments.console();
            let outcome = match arguments.command {
                Some(command) => commands::execute(command, console),
                None => arguments::without_command(console),
            };
            (console, outcome)
        }
        Err(help) if matches!(help.kind(), ErrorKind::DisplayHelp | ErrorKind::DisplayVersion) => {
            // A reader that has gone, as in `judder --help | head -1`, is no failure.
            let _ = help.print();
            return Exit::Done.code();
        }
        Err(error) => (Console::before_parsing(&words), Err(arguments::refuse(&error))),
    };
    let exit = outcome.unwrap_or_else(|failure| {
        console.failure(&failure);
        failure.exit
    });
    exit.code()
}
