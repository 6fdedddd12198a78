//! `judder new`: a commented case file to start from.

use clap::Args;
use judder_models::template::template;
use serde_json::json;

use crate::console::Console;
use crate::failure::{Exit, Failure};

const HELP: &str = "\
Examples:
  judder new > case.toml
  judder new contact > contact.toml
  judder new belt > belt.toml
  judder new two-degrees > minimal.toml

Templates:
  oscillator    two degrees of freedom on a viscoelastic substrate; every key with the paper's value
  contact       a rigid indenter that slides on a viscoelastic substrate: fields, laws, fits, moduli
  belt          one mass on a moving belt, with friction that falls with speed
  two-degrees   mass, damping and stiffness matrices of your own, with parameters
  structure     one linear structure alone: modes, reduction, complex modes
  beams-paper   one structure slides along another: the beams paper with every reading as a key";

/// Print a commented case file
#[derive(Debug, Args)]
#[command(after_help = HELP)]
pub(crate) struct NewArguments {
    /// Which one
    #[arg(default_value = "oscillator")]
    template: String,
}

impl NewArguments {
    pub(super) fn execute(&self, console: Console) -> Result<Exit, Failure> {
        let name = self.template.as_str();
        let text = template(name)?;
        console.result(|| text.clone(), || json!({ "template": name, "text": text }))?;
        Ok(Exit::Done)
    }
}
