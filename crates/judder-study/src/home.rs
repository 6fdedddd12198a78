//! Where the study of a case lies where nobody names a folder: that of a case file under the name of the file, any other under a name of its content.

use crate::case::file::CaseFile;
use crate::error::StudyError;
use crate::ledger::{Keepsakes, case_hash};
use crate::run::resolved_with_files;
use crate::way::without_turns;
use judder_store::StudyReader;
use serde_json::Value;
use std::path::{Path, PathBuf};

/// The folder of the studies that nobody has put elsewhere.
const OUT: &str = "out";
/// Digits of the hash of a case that tell its folder from others: of ten thousand cases two share one with a chance of 2e-7.
const DIGITS: usize = 12;
/// Letters of a title that go into the name of a folder.
const LETTERS: usize = 40;

/// `out/<name>`, for the case file of this name as it is.
///
/// # Errors
/// [`StudyError::OtherCase`] where the study of another case file of this name lies there, unless it is to be forgotten.
pub fn of_file(file: &CaseFile, fresh: bool) -> Result<PathBuf, StudyError> {
    let folder = Path::new(OUT).join(&file.name);
    let owner = file.path.as_deref().filter(|_| !fresh).and_then(|path| other_owner(&folder, path));
    match owner {
        Some(owner) => Err(StudyError::OtherCase { folder, owner }),
        None => Ok(folder),
    }
}

/// `out/<title>-<hash>`, for a case that no file holds as it is: the same case has the same folder, another case another. Without a title the model names
/// it, and a case file with changes is called by the file.
///
/// # Errors
/// A file of the case that cannot be read.
pub fn of_content(file: &CaseFile) -> Result<PathBuf, StudyError> {
    let (resolved, _) = resolved_with_files(file)?;
    let title = plain(resolved.get("title").and_then(Value::as_str).unwrap_or_default());
    let name = match (&file.path, title.is_empty()) {
        (Some(_), _) => &file.name,
        (None, false) => &title,
        (None, true) => file.case.model(),
    };
    let hash = case_hash(&resolved);
    Ok(Path::new(OUT).join(format!("{name}-{}", &hash[..DIGITS])))
}

/// The study of this case file, where `judder run` has left one.
#[must_use]
pub fn usual(case: &Path) -> Option<PathBuf> {
    let folder = Path::new(OUT).join(case.file_stem()?);
    (StudyReader::open(&folder).is_ok() && other_owner(&folder, case).is_none()).then_some(folder)
}

/// The case file whose study lies in a folder, where that is another one and still there.
fn other_owner(folder: &Path, own: &Path) -> Option<PathBuf> {
    let summary = StudyReader::open(folder).ok()?.read_summary().ok()??;
    let owner = without_turns(&folder.join(Keepsakes::of(&summary).file?));
    let (there, here) = (owner.canonicalize().ok()?, own.canonicalize().ok()?);
    (there != here).then_some(owner)
}

/// A title as the name of a folder: letters and digits of ASCII, in lower case, with hyphens for what lies between.
fn plain(title: &str) -> String {
    let words = title.split(|letter: char| !letter.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
    let mut name = words.collect::<Vec<_>>().join("-").to_ascii_lowercase();
    name.truncate(LETTERS);
    name.trim_end_matches('-').to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn titles_become_names() {
        assert_eq!(plain("A first map"), "a-first-map");
        assert_eq!(plain("µ = 0.3 (../../etc)"), "0-3-etc");
        assert_eq!(plain("Größe"), "gr-e");
        assert_eq!(plain("…"), "");
        assert_eq!(plain(&"abc ".repeat(40)), "abc-".repeat(10).trim_end_matches('-'));
    }
}
