//! `judder demo`: a first result, from what is inside the program.

use std::path::{Path, PathBuf};

use clap::Args;
use judder_examples::{ExampleError, ExampleKind, example};
use judder_papers::Paper;

use super::reproduce::reproduce;
use super::run::run_case;
use crate::console::Console;
use crate::failure::{Exit, Failure};
use crate::threads::Threads;

const HELP: &str = "\
Examples:
  judder demo                          the oscillator paper, figure by figure, in less than a minute
  judder demo assembly/mode-coupling   any case that `judder examples` lists

A case is written to out/demo first, so that it can be changed and run again.";

/// Where the cases go.
const FOLDER: &str = "out/demo";

/// See a first result: a quick reproduction of the oscillator paper, or a case that is inside the program
#[derive(Debug, Args)]
#[command(after_help = HELP)]
pub(crate) struct DemoArguments {
    /// A case of `judder examples` [default: the oscillator paper, quickly]
    name: Option<String>,
    #[arg(
        short,
        long,
        value_name = "DIR",
        help = "The study folder [default: out/<case name>, or out/demo/oscillator-paper]"
    )]
    output: Option<PathBuf>,
    #[command(flatten)]
    threads: Threads,
}

/// A case that was changed since the last demo is the user's own.
fn changed(error: ExampleError) -> Failure {
    match error {
        ExampleError::Exists { path } => Failure::wrong_input(
            format!("{} is there already, and is not the example any more", path.display()),
            format!("`judder run {}` runs it as it is", path.with_extension("toml").display()),
        ),
        error => error.into(),
    }
}

impl DemoArguments {
    pub(super) fn execute(&self, console: Console) -> Result<Exit, Failure> {
        let Some(name) = &self.name else {
            let paper = Paper::Oscillator;
            let usual = Path::new(FOLDER).join(paper.name());
            return reproduce(
                paper,
                true,
                Some(self.output.as_deref().unwrap_or(&usual)),
                self.threads,
                console,
            );
        };
        let own = example(name)?;
        if own.kind == ExampleKind::Script {
            return Err(Failure::wrong_input(
                format!("`{}` is a script of Python, and no case", own.name),
                format!("judder examples {} > {file}; python {file}", own.name, file = own.file),
            ));
        }
        let case = own.write(Path::new(FOLDER)).map_err(changed)?;
        console.note(format_args!("case: {}", case.display()));
        run_case(&case, self.output.as_deref(), self.threads, console)
    }
}
