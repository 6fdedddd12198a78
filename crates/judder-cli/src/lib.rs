//! `judder`, the command: arguments in, one call into a lower floor, a result on standard output, an exit code.
//!
//! A library besides, so that the Python package carries the same command.
//!
//! In the order in which the data flows:
//!
//! - `arguments`: the command line as types, with the help texts.
//! - `commands`: one module a command; each makes one call into `judder-study` and prints what came of it.
//! - `threads`, `memory`, `interrupt`, `progress`: the pool of `--threads`, the budget of `--memory`, what ends a command from outside, how far it is.
//! - `failure`: every error with its message, place, help and exit code.
//! - `console`: results to standard output, all else to standard error.
//! - `scoreboard`: the table of `judder reproduce`.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod arguments;
mod commands;
mod console;
mod failure;
mod interrupt;
mod memory;
mod progress;
mod scoreboard;
mod threads;

use std::ffi::OsString;
use std::panic::{AssertUnwindSafe, catch_unwind};

use clap::{CommandFactory, Parser};

use crate::arguments::Arguments;
use crate::console::Console;
use crate::failure::{Exit, Failure};
use crate::interrupt::Interrupt;

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
    let parsed = Arguments::try_parse_from(&words);
    let console = parsed.as_ref().map_or_else(|_| Console::before_parsing(&words), Arguments::console);
    console.begin();
    let outcome = caught(|| {
        Interrupt::watch(console)?;
        let arguments = match parsed {
            Ok(arguments) => arguments,
            Err(error) => return arguments::answer(&error, console),
        };
        arguments.memory.tell();
        match arguments.command {
            Some(command) => commands::execute(command, console),
            None => arguments::without_command(console),
        }
    });
    interrupt::end_by_itself();
    let exit = outcome.unwrap_or_else(|failure| {
        console.failure(&failure);
        failure.exit
    });
    exit.code()
}

/// The outcome of a command; a panic of it is a failure as any other, for an exit code of its own would surprise a script.
fn caught(command: impl FnOnce() -> Result<Exit, Failure>) -> Result<Exit, Failure> {
    // what the command has changed is gone with it
    catch_unwind(AssertUnwindSafe(command)).unwrap_or_else(|panic| Err(Failure::fault(&*panic)))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::panic, clippy::unwrap_used, reason = "a test fails by panicking")]

    use super::*;

    #[test]
    fn a_panic_is_a_missing_result() {
        let failure = caught(|| panic!("the matrix has no rows")).unwrap_err();
        assert_eq!(failure.exit, Exit::Incomplete);
        let message = failure.json()["error"]["message"].clone();
        assert_eq!(message, "a fault of the program: the matrix has no rows");
    }
}
