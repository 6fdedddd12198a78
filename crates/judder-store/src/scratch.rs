//! What a long analysis keeps while it runs, so that an interrupted one goes on from there.

use std::fs::{File, OpenOptions};
use std::io::{self, Seek, SeekFrom};
use std::path::PathBuf;
use std::sync::{Mutex, PoisonError};

use crate::name::check_name;
use crate::{StoreError, StudyFolder, WriteUnderWay, content_hash, plain, staging};

/// How the names of their files begin.
pub(crate) const PREFIX: &str = ".scratch-";
/// And those of what one analysis alone keeps: under a name that what several share does not have.
pub(crate) const OF_ANALYSIS: &str = ".scratch-of-";

/// Letters of the hash by which a line is known to be as it was written.
const CHECK_LETTERS: usize = 16;

/// Lines of one analysis under one hash. A line is on the disk once [`keep`](Self::keep) has returned; a kill loses at most the line
/// that is being written, and a line that is damaged counts for nothing.
#[derive(Debug)]
pub struct Scratch {
    path: PathBuf,
    hash: String,
    lines: Vec<String>,
    /// Up to where lines are whole in a file of this hash; what follows was being written when the run was killed.
    whole_bytes: Option<u64>,
    file: Mutex<Option<File>>,
}

impl Scratch {
    /// Takes up the lines of an earlier run under the same hash; those of another hash are forgotten.
    pub(crate) fn open(path: PathBuf, hash: &str) -> Result<Self, StoreError> {
        let mut content = match plain::read(&path) {
            Ok(content) => content,
            Err(source) if source.kind() == io::ErrorKind::NotFound => Vec::new(),
            Err(source) => return Err(StoreError::read(&path, source)),
        };
        content.truncate(content.iter().rposition(|byte| *byte == b'\n').map_or(0, |end| end + 1));
        let mut whole = content.split(|byte| *byte == b'\n');
        let is_known = whole.next() == Some(hash.as_bytes());
        let lines = if is_known { whole.filter_map(sound_line).collect() } else { Vec::new() };
        let whole_bytes = is_known.then_some(content.len() as u64);
        Ok(Self { path, hash: hash.to_owned(), lines, whole_bytes, file: Mutex::new(None) })
    }

    /// The lines of the earlier run.
    #[must_use]
    pub fn lines(&self) -> &[String] {
        &self.lines
    }

    /// Keeps one more line; it may come from any thread.
    ///
    /// # Errors
    /// A failure of the file system.
    pub fn keep(&self, line: &str) -> Result<(), StoreError> {
        let _write = WriteUnderWay::begin();
        let mut file = self.file.lock().unwrap_or_else(PoisonError::into_inner);
        let write = |file: &mut Option<File>| -> io::Result<()> {
            if file.is_none() {
                *file = Some(self.begun()?);
            }
            let line = format!("{} {line}\n", check(line.as_bytes()));
            file.as_ref().map_or(Ok(()), |file| judder_disk::write(file, line.as_bytes()))
        };
        write(&mut file).map_err(|source| StoreError::write(&self.path, line.len() as u64, source))
    }

    /// The file, behind its last whole line.
    fn begun(&self) -> io::Result<File> {
        let Some(bytes) = self.whole_bytes else {
            let fresh = judder_disk::create_file(&self.path)?;
            judder_disk::write(&fresh, format!("{}\n", self.hash).as_bytes())?;
            return Ok(fresh);
        };
        let mut known = OpenOptions::new().write(true).open(&self.path)?;
        judder_disk::set_length(&known, bytes)?;
        known.seek(SeekFrom::End(0))?;
        Ok(known)
    }

    /// Forgets all lines, once the analysis is done.
    ///
    /// # Errors
    /// A failure of the file system.
    pub fn discard(self) -> Result<(), StoreError> {
        judder_disk::remove(&self.path).map_err(|source| StoreError::write(&self.path, 0, source))
    }
}

impl StudyFolder {
    /// Removes what an analysis that is done has kept while it ran, where a run was killed before it could.
    ///
    /// # Errors
    /// A failure of the file system.
    pub fn discard_work(&self, analysis: &str) -> Result<(), StoreError> {
        check_name("an analysis", analysis)?;
        for prefix in [OF_ANALYSIS, staging::STREAM_PREFIX] {
            let left = self.path().join(format!("{prefix}{analysis}"));
            if left.symlink_metadata().is_ok() {
                judder_disk::remove(&left).map_err(|source| StoreError::write(&left, 0, source))?;
            }
        }
        Ok(())
    }

    /// What an analysis has kept under this hash before it was interrupted, and where it keeps more.
    ///
    /// # Errors
    /// A name that cannot be a file, failures of the file system.
    pub fn scratch(&self, analysis: &str, hash: &str) -> Result<Scratch, StoreError> {
        check_name("an analysis", analysis)?;
        Scratch::open(self.path().join(format!("{OF_ANALYSIS}{analysis}")), hash)
    }

    /// The same of what several analyses share, such as a law.
    ///
    /// # Errors
    /// As of [`scratch`](Self::scratch).
    pub fn shared_scratch(&self, name: &str, hash: &str) -> Result<Scratch, StoreError> {
        check_name("what analyses share", name)?;
        Scratch::open(self.path().join(format!("{PREFIX}{name}")), hash)
    }
}

/// What a line begins with.
fn check(line: &[u8]) -> String {
    let mut check = content_hash(line);
    check.truncate(CHECK_LETTERS);
    check
}

/// A line without its check; none where it is not as it was written.
fn sound_line(line: &[u8]) -> Option<String> {
    let (found, line) = line.split_at_checked(CHECK_LETTERS)?;
    let line = line.strip_prefix(b" ")?;
    (found == check(line).as_bytes()).then(|| String::from_utf8(line.to_vec()).ok()).flatten()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn lines_stay_under_their_hash_and_a_torn_one_is_lost() {
        let study = tempfile::tempdir().unwrap();
        let path = study.path().join(".scratch-law");
        let open = |hash: &str| Scratch::open(path.clone(), hash).unwrap();
        let first = open("a");
        assert!(first.lines().is_empty());
        first.keep("one").unwrap();
        first.keep("two").unwrap();
        fs::write(&path, fs::read_to_string(&path).unwrap() + "thr").unwrap();
        let second = open("a");
        assert_eq!(second.lines(), ["one", "two"]);
        second.keep("three").unwrap();
        assert_eq!(open("a").lines(), ["one", "two", "three"]);
        assert_eq!(fs::read_to_string(&path).unwrap().lines().count(), 4);
        assert!(open("b").lines().is_empty());
        second.discard().unwrap();
        assert!(!path.exists());
    }

    #[test]
    fn a_damaged_line_counts_for_nothing() {
        let study = tempfile::tempdir().unwrap();
        let path = study.path().join(".scratch-law");
        let kept = Scratch::open(path.clone(), "a").unwrap();
        ["0.125", "0.25", "0.5"].iter().for_each(|line| kept.keep(line).unwrap());
        let content = fs::read_to_string(&path).unwrap();
        fs::write(&path, content.replace("0.25", "0.35")).unwrap();
        let again = Scratch::open(path.clone(), "a").unwrap();
        assert_eq!(again.lines(), ["0.125", "0.5"]);
        again.keep("0.25").unwrap();
        assert_eq!(Scratch::open(path, "a").unwrap().lines(), ["0.125", "0.5", "0.25"]);
    }
}
