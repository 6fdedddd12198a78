//! `judder demo`: a first result, from what is inside the program.

use std::path::{Path, PathBuf};

use clap::Args;
use judder_examples::{ExampleError, ExampleKind, example};
use judder_papers::Paper;
use judder_study::resolve::resolve;
use serde_json::Value;

use super::reproduce::reproduce;
use super::run::run_case;
use crate::console::Console;
use crate::failure::{Exit, Failure};
use crate::progress::Bars;
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
        let bars = Bars::of_what_is_not_kept(console);
        let known = resolve(&judder_models::read(&case, &[])?, &bars)?;
        drop(bars);
        for expected in expectations(&known.json()) {
            console.note(expected);
        }
        run_case(&case, self.output.as_deref(), self.threads, console)
    }
}

/// What each analysis takes, as `judder check` tells it: about so long on one core, or what it is asked; and how many points each sweep has.
fn expectations(known: &Value) -> Vec<String> {
    let told = |own: &Value| {
        let name = own["name"].as_str()?;
        let seconds =
            own["seconds"].as_f64().map(|seconds| format!("takes about {seconds:.1} s on one core"));
        let asked = || own["asked"].as_str().map(str::to_owned);
        Some(format!("{name}: {}", seconds.or_else(asked)?))
    };
    let points = |own: &Value| Some(format!("{}: {} points", own["name"].as_str()?, own["points"].as_u64()?));
    let list = |key: &str| known[key].as_array().into_iter().flatten();
    list("estimate").filter_map(told).chain(list("sweeps").filter_map(points)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn estimates_are_told_by_the_time_or_by_what_is_asked() {
        let known = json!({
            "estimate": [{ "name": "map", "points": 4, "seconds": 2.04 }, { "name": "modes", "asked": "5 modes" }, {}],
            "sweeps": [{ "name": "grid", "points": 512 }],
        });
        let told = ["map: takes about 2.0 s on one core", "modes: 5 modes", "grid: 512 points"];
        assert_eq!(expectations(&known), told);
        assert_eq!(expectations(&Value::Null), [""; 0]);
    }
}
