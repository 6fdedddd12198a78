//! The command line as types.

use clap::{ArgAction, Args, Parser};

use crate::commands::Command;
use crate::console::Console;

const HELP: &str = "\
Examples:
  judder new > case.toml            a commented case file to start from
  judder check case.toml            what it means, before anything runs
  judder run case.toml              out/case/report.html and everything else
  judder point case.toml --set operation.velocity=1e-3
  judder reproduce --quick          the oscillator paper, figure by figure

Exit codes:
  0  done; an unstable point or an empty list of roots is an answer
  1  a requested result is missing: it did not converge, was interrupted or could not be written
  2  the input is wrong: the case, an option, the folder

Colours obey NO_COLOR, CLICOLOR and CLICOLOR_FORCE.";

/// judder: a workbench for friction-induced vibration
#[derive(Debug, Parser)]
#[command(name = "judder", version, after_help = HELP, max_term_width = 100, disable_help_subcommand = true)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    pub(crate) command: Option<Command>,
    #[command(flatten)]
    manner: Manner,
}

/// How every command speaks.
#[derive(Debug, Args)]
#[command(next_help_heading = "Everywhere")]
struct Manner {
    /// Print one JSON document on standard output and nothing else there; an error is {"error": …}
    #[arg(long, global = true)]
    json: bool,
    /// Say nothing but results and errors
    #[arg(short, long, global = true, conflicts_with = "verbose")]
    quiet: bool,
    /// Say more: every analysis with its time; -vv also its steps and the folder's state
    #[arg(short, long, global = true, action = ArgAction::Count)]
    verbose: u8,
}

impl Arguments {
    /// The console that these arguments ask for.
    pub(crate) fn console(&self) -> Console {
        Console::new(self.manner.json, self.manner.quiet, self.manner.verbose)
    }
}
