//! `judder report`: figures and page again, from stored results.

use std::path::PathBuf;

use clap::Args;
use judder_papers::rebuild;
use serde_json::json;

use crate::console::{Console, IN_THE_REPORT, ResultDocument};
use crate::failure::{Exit, Failure};

const HELP: &str = "\
Examples:
  judder report out/case
  judder report /data/of-others/case -o my-report

With -o the study stays as it is, as it must where its folder may not be written to. A figure that cannot be drawn says why in its place; \
the exit code is then 1.";

/// Rebuild figures and report.html of a study folder from its stored results
#[derive(Debug, Args)]
#[command(after_help = HELP)]
pub(crate) struct ReportArguments {
    /// The study folder
    #[arg(value_name = "DIR")]
    folder: PathBuf,
    /// Write figures and report.html into this folder, and nothing into that of the study
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
}

impl ReportArguments {
    pub(super) fn execute(&self, console: Console) -> Result<Exit, Failure> {
        let page = rebuild(&self.folder, self.output.as_deref())?;
        let (path, lacking) = (page.path.display(), page.lacking());
        console.document(|| ResultDocument::lacking(json!({ "report": path.to_string() }), &lacking))?;
        if !page.not_computed.is_empty() {
            let names = page.not_computed.join(", ");
            console.note(format_args!("not computed yet: {names}; `judder run` computes them"));
        }
        console.note(format_args!("report: {path}"));
        Ok(console.lacking(&lacking, IN_THE_REPORT))
    }
}
