//! `judder completions`: what a shell knows of the command line.

use clap::{Args, CommandFactory};
use clap_complete::Shell;
use serde_json::json;

use crate::arguments::Arguments;
use crate::console::Console;
use crate::failure::{Exit, Failure};

const HELP: &str = "\
Examples:
  judder completions bash > ~/.local/share/bash-completion/completions/judder
  judder completions zsh > ~/.zfunc/_judder        with ~/.zfunc in fpath
  judder completions fish > ~/.config/fish/completions/judder.fish";

/// Print what a shell needs to complete judder's command line
#[derive(Debug, Args)]
#[command(after_help = HELP)]
pub(crate) struct CompletionsArguments {
    /// The shell
    #[arg(value_enum)]
    shell: Shell,
}

impl CompletionsArguments {
    pub(super) fn execute(&self, console: Console) -> Result<Exit, Failure> {
        let script = self.script();
        console
            .result(|| script.clone(), || json!({ "shell": self.shell.to_string(), "script": &script }))?;
        Ok(Exit::Done)
    }

    fn script(&self) -> String {
        let mut script = Vec::new();
        clap_complete::generate(self.shell, &mut Arguments::command(), "judder", &mut script);
        String::from_utf8_lossy(&script).into_owned()
    }
}
