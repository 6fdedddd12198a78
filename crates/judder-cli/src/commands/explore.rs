//! `judder explore`: the local page.

use std::fs;
use std::io::Write;
use std::path::PathBuf;

use clap::Args;
use judder_explorer::{Explorer, ViewedCase};
use judder_study::home;
use serde_json::json;
use tempfile::NamedTempFile;

use crate::console::Console;
use crate::failure::{Exit, Failure};
use crate::interrupt::Interrupt;

const HELP: &str = "\
Examples:
  judder explore                       the paper's oscillator
  judder explore case.toml             its map, its points, its contact; its results, where out/case has some
  judder explore out/brake             the results of a study folder
  judder explore case.toml --no-browser --port 8420

The page is served to this machine alone, on a loopback address that only the browser that is opened knows. Every view has an address \
and gives its figure, its data and its case file. Ctrl-C ends it.";

/// Open the local page: move through the map, open a point, hear it
#[derive(Debug, Args)]
#[command(after_help = HELP)]
pub(crate) struct ExploreArguments {
    /// The case file, or the folder of a study [default: the paper's oscillator]
    #[arg(value_name = "CASE.toml|DIR")]
    subject: Option<PathBuf>,
    #[arg(
        long,
        value_name = "DIR",
        help = "The study folder to look at [default: out/<case name>, where there is one]"
    )]
    study: Option<PathBuf>,
    /// Listen on this port [default: any that is free]
    #[arg(long, value_name = "N")]
    port: Option<u16>,
    /// Print the address and open nothing
    #[arg(long)]
    no_browser: bool,
}

impl ExploreArguments {
    pub(super) fn execute(&self, console: Console) -> Result<Exit, Failure> {
        let explorer = Explorer::new(self.open()?, self.port)?;
        let interrupt = Interrupt::served(console);
        let address = explorer.address();
        console.result(
            || format!("{address}\n\nThe address lets a browser of this machine in. Ctrl-C ends the page.\n"),
            || json!({ "address": address }),
        )?;
        if let Some(doubt) = explorer.doubt() {
            console.warn(&doubt);
        }
        let door = if self.no_browser { None } else { door(&address) };
        if let Some(door) = &door
            && let Err(error) = open::that_detached(door.path())
        {
            console.warn(&format!("no browser could be opened ({error}); open the address above"));
        }
        explorer.serve(&|| interrupt.asked())?;
        Ok(Exit::Done)
    }

    /// The case and the study folder that are meant.
    fn open(&self) -> Result<ViewedCase, Failure> {
        let (case, study) = match &self.subject {
            Some(path) if fs::metadata(path).is_ok_and(|metadata| metadata.is_dir()) => {
                if self.study.is_some() {
                    let text = format!("{} is a study folder, and `--study` names another", path.display());
                    return Err(Failure::wrong_input(
                        text,
                        "give a case file with `--study`, or one folder alone",
                    ));
                }
                (None, Some(path.clone()))
            }
            path => (path.as_deref(), self.study.clone()),
        };
        let study = study.or_else(|| case.and_then(home::usual));
        Ok(ViewedCase::open(case, study.as_deref())?)
    }
}

/// A file, readable by its owner alone, that leads a browser to the address: on a command line every user of the machine could read it.
fn door(address: &str) -> Option<NamedTempFile> {
    let mut file = tempfile::Builder::new().prefix("judder-").suffix(".html").tempfile().ok()?;
    let page = format!(
        "<!doctype html><meta charset=\"utf-8\"><meta http-equiv=\"refresh\" content=\"0; url={address}\">\n"
    );
    file.write_all(page.as_bytes()).ok()?;
    Some(file)
}
