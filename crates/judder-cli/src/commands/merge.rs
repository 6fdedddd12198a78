//! `judder merge`: summary and report of sweeps that others have computed.

use std::path::PathBuf;

use clap::Args;
use judder_study::home;
use judder_study::run::{RunOptions, SweepWork, run};

use super::CaseArguments;
use super::run::tell;
use crate::console::Console;
use crate::failure::{Exit, Failure};
use crate::progress::Bars;

const HELP: &str = "\
Examples:
  judder merge case.toml
  judder merge case.toml -o /scratch/study

The parts of `judder run --shard k/N` leave chunks in one study folder. This computes none and copies none: it reads all, says \
which sweep lacks how many or has damaged ones, and writes the metadata, summary.json and the report where none does.";

/// Write summary and report of sweeps whose parts are all computed
#[derive(Debug, Args)]
#[command(after_help = HELP)]
pub(crate) struct MergeArguments {
    #[command(flatten)]
    case: CaseArguments,
    #[arg(short, long, value_name = "DIR", help = "The study folder [default: out/<case name>]")]
    output: Option<PathBuf>,
    /// Merge this sweep and no others; may be given several times
    #[arg(long, value_name = "NAME")]
    only: Vec<String>,
}

impl MergeArguments {
    pub(super) fn execute(&self, console: Console) -> Result<Exit, Failure> {
        let file = self.case.read(console)?;
        let folder = self.output.clone().map_or_else(|| home::of_file(&file, false), Ok)?;
        // without a name given, the sweeps alone: the analyses are none of its business
        let sweeps = || file.sweeps.iter().map(|sweep| sweep.name.clone()).collect();
        let only: Vec<String> = if self.only.is_empty() { sweeps() } else { self.only.clone() };
        if only.is_empty() {
            return Err(Failure::wrong_input(
                "the case has no sweep to merge",
                "`judder run` runs its analyses",
            ));
        }
        let options = RunOptions { only, sweeps: SweepWork::Merge, ..RunOptions::default() };
        let bars = Bars::new(console);
        let report = run(&file, &folder, &options, &bars)?;
        tell(report, &self.case.case, console)
    }
}
