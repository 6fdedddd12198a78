//! The command line as types.

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{ArgAction, Args, CommandFactory, Parser};
use serde_json::json;

use crate::commands::Command;
use crate::console::{Console, ProgressForm, print_styled};
use crate::failure::{Exit, Failure};
use crate::memory::MemoryLimit;

const HELP: &str = "\
Examples:
  judder demo                       a first result: the oscillator paper, quickly
  judder examples                   the cases that are inside the program
  judder new > case.toml            a commented case file to start from
  judder check case.toml            what it means, before anything runs
  judder run case.toml              out/case/report.html and everything else
  judder point case.toml --set operation.velocity=1e-3
  judder explore case.toml          a page in the browser, computed live
  judder reproduce --quick          the oscillator paper, figure by figure

Exit codes:
  0  done; an unstable point or an empty list of roots is an answer, a failed check a warning
  1  a requested result is missing: it did not converge, was interrupted (Ctrl-C, SIGTERM, SIGHUP) or could not be written
  2  the input is wrong: the case, an option, the folder

Colours obey NO_COLOR, CLICOLOR and CLICOLOR_FORCE.";

/// judder: a workbench for friction-induced vibration
#[derive(Debug, Parser)]
#[command(name = "judder", version = crate::BUILD, after_help = HELP, max_term_width = 100)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    pub(crate) command: Option<Command>,
    #[command(flatten)]
    manner: ConsoleManner,
    #[command(flatten)]
    pub(crate) memory: MemoryLimit,
}

/// How every command speaks.
#[derive(Debug, Args)]
#[command(next_help_heading = "Everywhere")]
struct ConsoleManner {
    /// Print one JSON document on standard output and nothing else there; an error is {"error": …}
    #[arg(long, global = true)]
    json: bool,
    /// Say nothing but results and errors
    #[arg(short, long, global = true, conflicts_with = "verbose")]
    quiet: bool,
    /// Say more: every analysis with its time; -vv also where and what
    #[arg(short, long, global = true, action = ArgAction::Count)]
    verbose: u8,
    /// How to tell on standard error how far a command is
    #[arg(long, global = true, value_name = "FORM", value_enum, default_value_t = ProgressForm::Auto)]
    progress: ProgressForm,
}

impl Arguments {
    /// The console that these arguments ask for.
    pub(crate) fn console(&self) -> Console {
        let ConsoleManner { json, quiet, verbose, progress } = self.manner;
        Console::new(json, quiet, verbose, progress)
    }
}

/// The answer to a command line without a command: how to go on.
///
/// # Errors
/// That there is none, where the answer is read by a program.
pub(crate) fn without_command(console: Console) -> Result<Exit, Failure> {
    if console.json() {
        return Err(Failure::wrong_input("no command was given", "`judder --help` lists the commands"));
    }
    print_styled(&Arguments::command().render_help())?;
    Ok(Exit::Done)
}

/// The answer to a command line that asks for no command: help, version.
///
/// # Errors
/// What is wrong with it, and what would be right.
pub(crate) fn answer(error: &clap::Error, console: Console) -> Result<Exit, Failure> {
    let key = match error.kind() {
        ErrorKind::DisplayHelp => "help",
        ErrorKind::DisplayVersion => "version",
        _ => return Err(refuse(error)),
    };
    if console.json() {
        console.document(|| json!({ key: error.to_string() }))?;
    } else {
        print_styled(&error.render())?;
    }
    Ok(Exit::Done)
}

/// What is wrong with a command line, and what would be right.
fn refuse(error: &clap::Error) -> Failure {
    if let Some(ContextValue::String(name)) = error.get(ContextKind::InvalidSubcommand) {
        return unknown_command(name);
    }
    // clap writes paragraphs: what is wrong, tips, the usage.
    let text = error.to_string();
    let mut paragraphs = text.split("\n\n").map(|paragraph| paragraph.lines().map(str::trim));
    let wrong: Vec<_> = paragraphs.next().into_iter().flatten().collect();
    let wrong = wrong.join(" ");
    let right: Vec<_> = paragraphs.flatten().filter(|line| !line.is_empty()).collect();
    Failure::wrong_input(wrong.strip_prefix("error: ").unwrap_or(&wrong), right.join("\n"))
}

/// clap finds no neighbour of a word as short as `rnu`, so the nearest command is sought here.
fn unknown_command(name: &str) -> Failure {
    let arguments = Arguments::command();
    let known: Vec<_> = arguments
        .get_subcommands()
        .filter(|command| !command.is_hide_set())
        .map(clap::Command::get_name)
        .collect();
    let edits = |command: &&&str| strsim::damerau_levenshtein(name, command);
    let near =
        known.iter().min_by_key(edits).filter(|command| edits(command) <= 1 + name.chars().count() / 3);
    let question = near.map(|command| format!("did you mean `{command}`? ")).unwrap_or_default();
    Failure::wrong_input(
        format!("there is no command `{name}`"),
        format!("{question}commands: {}", known.join(", ")),
    )
}
