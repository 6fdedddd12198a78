//! `judder run`: the analyses of a case into a study folder.

use std::path::{Path, PathBuf};

use clap::Args;
use judder_study::home;
use judder_study::run::{PartedSweep, RunOptions, RunReport, SweepWork, dry_run, run};
use judder_study::sweep::{Shard, SweepEstimate};
use serde_json::{Value, json};

use super::CaseArguments;
use crate::console::{Console, IN_THE_REPORT, ResultDocument};
use crate::failure::{Exit, Failure};
use crate::progress::Bars;
use crate::threads::Threads;

const HELP: &str = "\
Examples:
  judder run case.toml
  judder run case.toml -o out/fast --set operation.velocity=1e-2
  judder run case.toml --only map --only thresholds --threads 8
  judder run case.toml --json | jq .results.map.unstable_fraction
  judder run case.toml --dry-run
  judder run case.toml --shard 3/16

A sweep ([[sweep]]) is computed in chunks, each written whole or not at all. Any number of processes may work on one \
study folder: what one computes the others leave alone. --shard k/N takes every N-th chunk and nothing else, for job arrays; \
judder merge writes summary and report when all parts are done.

The folder then holds summary.json, results.zarr, tables as CSV, figures and report.html. A second run goes on \
where the first one ended: an analysis runs again only where something that it depends on has changed.

A check beyond its limit is a warning; the exit code is 1 only where a requested result is missing, and 2 where the input \
is to blame for it.

Ctrl-C ends cleanly and keeps what is done; a second Ctrl-C ends at once.";

/// Run the analyses of a case; a rerun resumes
#[derive(Debug, Args)]
#[command(after_help = HELP)]
pub(crate) struct RunArguments {
    #[command(flatten)]
    case: CaseArguments,
    #[arg(short, long, value_name = "DIR", help = "The study folder [default: out/<case name>]")]
    output: Option<PathBuf>,
    /// Run this analysis and no others; may be given several times
    #[arg(long, value_name = "NAME")]
    only: Vec<String>,
    #[command(flatten)]
    threads: Threads,
    /// Forget earlier results first
    #[arg(long, conflicts_with_all = ["skip_completed", "shard"])]
    fresh: bool,
    /// Compute nothing that is there already; this is the default
    #[arg(long)]
    skip_completed: bool,
    /// Compute the k-th of N parts of the chunks of every sweep, and nothing else
    #[arg(long, value_name = "k/N")]
    shard: Option<Shard>,
    /// Say what the sweeps would take, from a few of their points; write nothing
    #[arg(long)]
    dry_run: bool,
    /// Draw neither figures nor report; `judder report` draws them later
    #[arg(long)]
    no_report: bool,
}

impl RunArguments {
    pub(super) fn execute(&self, console: Console) -> Result<Exit, Failure> {
        let file = self.case.read(console)?;
        let folder = self.output.clone().map_or_else(|| home::of_file(&file, self.fresh), Ok)?;
        let sweeps = self.shard.map_or(SweepWork::All, SweepWork::Part);
        let options = RunOptions {
            only: self.only.clone(),
            fresh: self.fresh,
            sweeps,
            without_report: self.no_report,
            ..RunOptions::default()
        };
        let bars = Bars::new(console);
        if self.dry_run {
            let estimates = self.threads.install(|| dry_run(&file, &folder, &options, &bars))??;
            console.result(|| told(&estimates), || json!({ "sweeps": documents(&estimates) }))?;
            return Ok(Exit::Done);
        }
        let report = self.threads.install(|| run(&file, &folder, &options, &bars))??;
        tell(report, &self.case.case, console)
    }
}

/// Runs a case file as it is, into this folder or into that of its name.
pub(super) fn run_case(
    case: &Path,
    output: Option<&Path>,
    threads: Threads,
    console: Console,
) -> Result<Exit, Failure> {
    let file = judder_models::read(case, &[])?;
    let folder = output.map_or_else(|| home::of_file(&file, false), |folder| Ok(folder.to_owned()))?;
    let bars = Bars::new(console);
    let report = threads.install(|| run(&file, &folder, &RunOptions::default(), &bars))??;
    tell(report, case, console)
}

/// What the sweeps would take, one below the other.
fn told(estimates: &[SweepEstimate]) -> String {
    match estimates.is_empty() {
        true => "the case has no sweep; `judder check` estimates its analyses\n".to_owned(),
        false => estimates.iter().map(SweepEstimate::text).collect::<Vec<_>>().join("\n"),
    }
}

fn documents(estimates: &[SweepEstimate]) -> Vec<Value> {
    estimates.iter().map(SweepEstimate::json).collect()
}

/// How to have what a study lacks that is left to others.
const COMPUTED_BY_RUN: &str = "`judder run` computes it";

/// Says what came of a run. Failed checks are among the warnings: only a missing result changes the exit code.
///
/// # Errors
/// As [`Console::result`].
pub(super) fn tell(report: RunReport, case: &Path, console: Console) -> Result<Exit, Failure> {
    let lacking = [report.lacking.as_slice(), &report.undrawn].concat();
    let refused = report.refused.into_iter().map(|refused| Failure::of_analysis(case, refused));
    let refused = Failure::all(refused);
    let error = refused.as_ref().map(Failure::json);
    if !report.parted.is_empty() {
        let sweeps: Vec<Value> = report.parted.iter().map(PartedSweep::json).collect();
        console.document(|| ResultDocument {
            result: json!({ "sweeps": sweeps }),
            lacking: &lacking,
            error,
        })?;
        report.notes.iter().for_each(|note| console.note(note));
        return Ok(console.lacking(&lacking, COMPUTED_BY_RUN));
    }
    console.document(|| ResultDocument { result: &report.summary, lacking: &lacking, error })?;
    for line in report.forgotten.told() {
        console.note(line);
    }
    if !report.skipped.is_empty() {
        console.note(format_args!("done before: {}", report.skipped.join(", ")));
    }
    for line in report.tables.iter().chain(&report.notes) {
        console.note(line);
    }
    for message in &report.messages {
        console.warn(message);
    }
    console.detail(2, format_args!("folder: {}", report.folder.display()));
    console.detail(2, format_args!("case: {}", report.summary.case_hash));
    console.detail(1, format_args!("wall time: {:.2} s", report.summary.wall_time_s));
    if let Some(page) = &report.report {
        console.note(format_args!("report: {}", page.display()));
    }
    if let Some(refused) = refused {
        console.refusal(&refused);
        return Ok(refused.exit);
    }
    Ok(console.lacking(&lacking, IN_THE_REPORT))
}
