//! One module a command.

mod check;
mod completions;
mod demo;
mod examples;
mod explore;
mod merge;
mod new;
mod point;
mod report;
mod reproduce;
mod run;
mod schema;
mod verify;

use std::path::PathBuf;

use clap::{Args, Subcommand};
use judder_study::Progress;
use judder_study::case::file::CaseFile;

use crate::console::Console;
use crate::failure::{Exit, Failure};
use crate::progress::Bars;

/// What judder is asked to do.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    Demo(demo::DemoArguments),
    Examples(examples::ExamplesArguments),
    New(new::NewArguments),
    Check(check::CheckArguments),
    Run(run::RunArguments),
    Merge(merge::MergeArguments),
    Point(point::PointArguments),
    Report(report::ReportArguments),
    Verify(verify::VerifyArguments),
    Reproduce(reproduce::ReproduceArguments),
    Schema(schema::SchemaArguments),
    Completions(completions::CompletionsArguments),
    Explore(explore::ExploreArguments),
}

/// Does what was asked for.
///
/// # Errors
/// Why there is no result.
pub(crate) fn execute(command: Command, console: Console) -> Result<Exit, Failure> {
    match command {
        Command::Demo(demo) => demo.execute(console),
        Command::Examples(examples) => examples.execute(console),
        Command::New(new) => new.execute(console),
        Command::Check(check) => check.execute(console),
        Command::Run(run) => run.execute(console),
        Command::Merge(merge) => merge.execute(console),
        Command::Point(point) => point.execute(console),
        Command::Report(report) => report.execute(console),
        Command::Verify(verify) => verify.execute(console),
        Command::Reproduce(reproduce) => reproduce.execute(console),
        Command::Schema(schema) => schema.execute(console),
        Command::Completions(completions) => completions.execute(console),
        Command::Explore(explore) => explore.execute(console),
    }
}

/// A case file with changes on top.
#[derive(Debug, Args)]
struct CaseArguments {
    /// The case file
    #[arg(value_name = "CASE.toml")]
    case: PathBuf,
    /// Set a key of the case on top of its file; may be given several times
    #[arg(long = "set", value_name = "KEY=VALUE")]
    overrides: Vec<String>,
}

impl CaseArguments {
    /// Reads the case with the changes applied; a file of thousands of sweeps takes a while.
    fn read(&self, console: Console) -> Result<CaseFile, Failure> {
        let bars = Bars::of_what_is_not_kept(console);
        bars.announce(Some("reading the case"));
        let read = judder_models::read(&self.case, &self.overrides);
        bars.announce(None);
        Ok(read?)
    }
}
