//! `judder examples`: the cases and scripts that are inside the program.

use std::path::PathBuf;

use clap::Args;
use judder_examples::{Example, example, examples};
use serde_json::{Value, json};

use crate::console::Console;
use crate::failure::{Exit, Failure};

const HELP: &str = "\
Examples:
  judder examples                                    all, a line each
  judder examples assembly/mode-coupling > case.toml
  judder examples tutorials/own-rubber -o rubber     with the file of moduli that it names
  judder examples python/own-rubber-to-map > map.py

`judder demo NAME` runs a case.";

/// List the cases and scripts that are inside the program, or print or write one
#[derive(Debug, Args)]
#[command(after_help = HELP)]
pub(crate) struct ExamplesArguments {
    /// Which one; its last part is enough where it is the only one
    name: Option<String>,
    /// Write it, and the files that it names, into this folder
    #[arg(short, long, value_name = "DIR", requires = "name")]
    output: Option<PathBuf>,
}

impl ExamplesArguments {
    pub(super) fn execute(&self, console: Console) -> Result<Exit, Failure> {
        let Some(name) = &self.name else {
            let all = examples();
            let document =
                || all.iter().map(|own| json!({ "name": own.name, "title": own.title })).collect::<Vec<_>>();
            console.result(|| listed(&all), document)?;
            return Ok(Exit::Done);
        };
        let own = example(name)?;
        match &self.output {
            Some(folder) => {
                let path = own.write(folder)?;
                console.document(|| json!({ "name": own.name, "path": path.display().to_string() }))?;
                console.note(path.display());
            }
            None => {
                console.result(|| own.text.clone(), || document(&own))?;
                if let [(first, _), ..] = own.files.as_slice() {
                    let folder = own.name.rsplit('/').next().unwrap_or_default();
                    console.note(format_args!(
                        "it names {first}: `judder examples {} -o {folder}` writes both",
                        own.name
                    ));
                }
            }
        }
        Ok(Exit::Done)
    }
}

/// Name and title of each, in two columns.
fn listed(all: &[Example]) -> String {
    let width = all.iter().map(|own| own.name.chars().count()).max().unwrap_or_default();
    all.iter().map(|own| format!("{:width$}  {}\n", own.name, own.title)).collect()
}

fn document(own: &Example) -> Value {
    let files: Vec<&str> = own.files.iter().map(|(name, _)| name.as_str()).collect();
    json!({ "name": own.name, "title": own.title, "text": own.text, "files": files })
}
