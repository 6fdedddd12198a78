//! `judder schema`: what editors know of case files.

use clap::Args;
use judder_models::schema;

use crate::console::Console;
use crate::failure::{Exit, Failure};

const HELP: &str = "\
Example:
  judder schema > judder.schema.json

An editor with a TOML language server (Taplo, Even Better TOML) completes and checks a case file whose first line is
  #:schema ./judder.schema.json";

/// Print the JSON Schema of case files, for editors
#[derive(Debug, Args)]
#[command(after_help = HELP)]
pub(crate) struct SchemaArguments {}

impl SchemaArguments {
    pub(super) fn execute(&self, console: Console) -> Result<Exit, Failure> {
        console.result(|| format!("{:#}\n", schema()), schema)?;
        Ok(Exit::Done)
    }
}
