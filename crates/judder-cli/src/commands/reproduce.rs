//! `judder reproduce`: a paper, figure by figure, with its scoreboard.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use judder_papers::{beams_paper, oscillator_paper};
use judder_study::Progress;

use crate::console::{Console, output_width};
use crate::failure::{Exit, Failure};
use crate::progress::Bars;
use crate::scoreboard;
use crate::threads::Threads;

const HELP: &str = "\
Examples:
  judder reproduce oscillator-paper
  judder reproduce beams-paper
  judder reproduce --quick -o out/quick
  judder reproduce --json | jq '.scoreboard[] | select(.verdict == \"open\")'";

/// Recompute every figure and quoted number of a paper and print the scoreboard
#[derive(Debug, Args)]
#[command(after_help = HELP)]
pub(crate) struct ReproduceArguments {
    /// Which paper
    #[arg(value_enum, default_value_t = Paper::OscillatorPaper)]
    paper: Paper,
    /// In seconds instead of minutes: fewer points and a paraboloid's law in place of the sphere's, or the last quarter of the path
    #[arg(long)]
    quick: bool,
    #[arg(short, long, value_name = "DIR", help = "The study folder [default: out/reproduce/<paper>]")]
    output: Option<PathBuf>,
    #[command(flatten)]
    threads: Threads,
}

/// The papers that judder knows.
#[derive(Debug, Clone, Copy, ValueEnum)]
enum Paper {
    /// Critical thresholds for mode-coupling instability in viscoelastic sliding contacts (2021)
    OscillatorPaper,
    /// Dynamic substructuring with time variant coupling conditions (2020)
    BeamsPaper,
}

impl ReproduceArguments {
    pub(super) fn execute(&self, console: Console) -> Result<Exit, Failure> {
        let (name, recompute): (_, fn(&Path, bool, &dyn Progress) -> _) = match self.paper {
            Paper::OscillatorPaper => ("oscillator-paper", oscillator_paper),
            Paper::BeamsPaper => ("beams-paper", beams_paper),
        };
        let folder = self.output.clone().unwrap_or_else(|| Path::new("out/reproduce").join(name));
        let bars = Bars::new(console)?;
        let reproduction = self.threads.install(|| recompute(&folder, self.quick, &bars))??;
        console.result(
            || scoreboard::text(&reproduction, output_width()),
            || scoreboard::document(&reproduction),
        )?;
        console.note(format_args!("report: {}", reproduction.report.display()));
        if reproduction.complete {
            return Ok(Exit::Done);
        }
        console.incomplete("a result of the reproduction is missing", "the report says which");
        Ok(Exit::Incomplete)
    }
}
