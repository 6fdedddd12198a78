//! `judder reproduce`: a paper, figure by figure, with its scoreboard.

use std::path::{Path, PathBuf};

use clap::builder::PossibleValue;
use clap::{Args, ValueEnum};
use judder_papers::Paper;

use crate::console::{Console, IN_THE_REPORT, output_width};
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
    #[arg(value_enum, default_value_t = AskedPaper(Paper::Oscillator))]
    paper: AskedPaper,
    /// In seconds instead of minutes: fewer points and a paraboloid's law in place of the sphere's, or the last quarter of the path
    #[arg(long)]
    quick: bool,
    #[arg(short, long, value_name = "DIR", help = "The study folder [default: out/reproduce/<paper>]")]
    output: Option<PathBuf>,
    #[command(flatten)]
    threads: Threads,
}

/// A paper as a word of the command line.
#[derive(Debug, Clone, Copy)]
struct AskedPaper(Paper);

impl ValueEnum for AskedPaper {
    fn value_variants<'a>() -> &'a [Self] {
        const ALL: [AskedPaper; Paper::ALL.len()] = {
            let [first, second] = Paper::ALL;
            [AskedPaper(first), AskedPaper(second)]
        };
        &ALL
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(PossibleValue::new(self.0.name()).help(self.0.title()))
    }
}

impl ReproduceArguments {
    pub(super) fn execute(&self, console: Console) -> Result<Exit, Failure> {
        let AskedPaper(paper) = self.paper;
        reproduce(paper, self.quick, self.output.as_deref(), self.threads, console)
    }
}

/// Recomputes a paper and tells what came of it.
pub(super) fn reproduce(
    paper: Paper,
    quick: bool,
    output: Option<&Path>,
    threads: Threads,
    console: Console,
) -> Result<Exit, Failure> {
    let folder = output.map_or_else(|| paper.usual_folder(), Path::to_owned);
    let bars = Bars::new(console);
    let reproduction = threads.install(|| paper.reproduce(&folder, quick, &bars))??;
    console.result(|| scoreboard::text(&reproduction, output_width()), || reproduction.json())?;
    console.note(format_args!("report: {}", reproduction.report.display()));
    Ok(console.lacking(&reproduction.lacking, IN_THE_REPORT))
}
