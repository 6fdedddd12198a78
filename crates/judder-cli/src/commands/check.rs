//! `judder check`: what a case means and what it would take; nothing runs.

use clap::Args;
use judder_study::resolve::resolve;

use super::CaseArguments;
use crate::console::Console;
use crate::failure::{Exit, Failure};
use crate::progress::Bars;

const HELP: &str = "\
Examples:
  judder check case.toml
  judder check case.toml --set \"operation.velocity=30 mm/s\"
  judder check case.toml --json | jq .groups";

/// Validate a case and print what it means: every key, stability limits, time and memory; run nothing
#[derive(Debug, Args)]
#[command(after_help = HELP)]
pub(crate) struct CheckArguments {
    #[command(flatten)]
    case: CaseArguments,
}

impl CheckArguments {
    pub(super) fn execute(&self, console: Console) -> Result<Exit, Failure> {
        let case = self.case.read(console)?;
        let bars = Bars::of_what_is_not_kept(console);
        let resolved = resolve(&case, &bars)?;
        drop(bars);
        console.result(|| resolved.text(), || resolved.json())?;
        Ok(Exit::Done)
    }
}
