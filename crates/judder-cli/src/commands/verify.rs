//! `judder verify`: whether a study is as it was written.

use std::path::PathBuf;

use clap::Args;
use judder_store::{Finding, Verification, verify};
use judder_study::{Progress, StudyError};

use crate::console::Console;
use crate::failure::{Exit, Failure};
use crate::progress::Bars;

const HELP: &str = "\
Example:
  judder verify out/case

Every file of a study is listed in its manifest.json with size and hash. This reads all of them and says which are damaged, missing, \
unfinished or none of judder's; it changes nothing. `judder run` computes again what is damaged and keeps the rest.";

/// Say whether a study folder is whole and as it was written
#[derive(Debug, Args)]
#[command(after_help = HELP)]
pub(crate) struct VerifyArguments {
    /// The study folder
    #[arg(value_name = "DIR")]
    folder: PathBuf,
}

impl VerifyArguments {
    pub(super) fn execute(&self, console: Console) -> Result<Exit, Failure> {
        let bars = Bars::new(console);
        bars.begin("verify", 0);
        let found = verify(&self.folder, |_, _| {
            bars.expect(1);
            bars.advance();
            !bars.interrupted()
        });
        bars.end();
        if bars.interrupted() {
            return Err(StudyError::Interrupted.into());
        }
        let found = found.map_err(StudyError::from)?;
        console.result(|| text(&found), || found.told())?;
        console.note(format_args!("{}: {}", self.folder.display(), verdict(&found)));
        Ok(if found.is_sound() { Exit::Done } else { Exit::Incomplete })
    }
}

/// A line a finding.
fn text(found: &Verification) -> String {
    found.findings.iter().map(|finding| format!("{}: {}\n", finding.path(), finding.words())).collect()
}

fn verdict(found: &Verification) -> String {
    let count = |asked| {
        let damages = found.findings.iter().filter_map(|finding| match finding {
            Finding::Damaged { damage, .. } => Some(damage.is_damage()),
            Finding::Extra { .. } | Finding::Unfinished { .. } => None,
        });
        damages.filter(|is_damage| *is_damage == asked).count()
    };
    let (damaged, unreadable) = (count(true), count(false));
    let megabytes = found.bytes as f64 / 1e6;
    let sound = format!("{} files ({megabytes:.1} MB) are as they were written", found.sound);
    let sound = match unreadable {
        0 => sound,
        1 => format!("{sound}, 1 cannot be read, and nothing is known of it"),
        count => format!("{sound}, {count} cannot be read, and nothing is known of them"),
    };
    match (damaged, found.is_complete) {
        (0, true) => sound,
        (0, false) => {
            format!("{sound}; a run is at work on the others, or was interrupted: `judder run` goes on")
        }
        (1, _) => format!("{sound}, 1 is not; `judder run` computes its result again and keeps the others"),
        (count, _) => {
            format!(
                "{sound}, {count} are not; `judder run` computes their results again and keeps the others"
            )
        }
    }
}
