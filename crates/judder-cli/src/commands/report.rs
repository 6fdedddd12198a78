//! `judder report`: figures and page again, from stored results.

use std::path::PathBuf;

use clap::Args;
use judder_papers::rebuild;
use serde_json::json;

use crate::console::Console;
use crate::failure::{Exit, Failure};

const HELP: &str = "\
Example:
  judder report out/case";

/// Rebuild figures and report.html of a study folder from its stored results
#[derive(Debug, Args)]
#[command(after_help = HELP)]
pub(crate) struct ReportArguments {
    /// The study folder
    #[arg(value_name = "DIR")]
    folder: PathBuf,
}

impl ReportArguments {
    pub(super) fn execute(&self, console: Console) -> Result<Exit, Failure> {
        let page = rebuild(&self.folder)?;
        console.document(|| json!({ "report": page }))?;
        console.note(format_args!("report: {}", page.display()));
        Ok(Exit::Done)
    }
}
