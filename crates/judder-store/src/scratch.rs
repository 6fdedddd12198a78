//! What a long analysis keeps while it runs, so that an interrupted one goes on from there.

use std::fs::File;
use std::io;
use std::iter;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use crate::{StoreError, WriteUnderWay, plain};

/// How the names of their files begin.
pub(crate) const PREFIX: &str = ".scratch-";

/// Lines of one analysis under one hash. A line is on the disk once [`keep`](Self::keep) has returned; a kill loses at most the line
/// that is being written.
#[derive(Debug)]
pub struct Scratch {
    path: PathBuf,
    hash: String,
    lines: Vec<String>,
    file: Mutex<Option<File>>,
}

impl Scratch {
    /// Takes up the lines of an earlier run under the same hash; those of another hash are forgotten.
    pub(crate) fn open(study: &Path, analysis: &str, hash: &str) -> Result<Self, StoreError> {
        let path = study.join(format!("{PREFIX}{analysis}"));
        let text = match plain::read(&path) {
            Ok(text) => String::from_utf8(text).unwrap_or_default(),
            Err(source) if source.kind() == io::ErrorKind::NotFound => String::new(),
            Err(source) => return Err(StoreError::read(&path, source)),
        };
        // what follows the last line end was being written when the run was killed
        let mut whole = text.split_inclusive('\n').filter_map(|line| line.strip_suffix('\n'));
        let known = whole.next() == Some(hash);
        let lines = if known { whole.map(str::to_owned).collect() } else { Vec::new() };
        Ok(Self { path, hash: hash.to_owned(), lines, file: Mutex::new(None) })
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
                // written anew with what is known, so that no torn line stays in the middle
                let fresh = judder_disk::create_file(&self.path)?;
                for known in iter::once(&self.hash).chain(&self.lines) {
                    judder_disk::write(&fresh, format!("{known}\n").as_bytes())?;
                }
                *file = Some(fresh);
            }
            file.as_ref().map_or(Ok(()), |file| judder_disk::write(file, format!("{line}\n").as_bytes()))
        };
        write(&mut file).map_err(|source| StoreError::write(&self.path, line.len() as u64, source))
    }

    /// Forgets all lines, once the analysis is done.
    ///
    /// # Errors
    /// A failure of the file system.
    pub fn discard(self) -> Result<(), StoreError> {
        judder_disk::remove(&self.path).map_err(|source| StoreError::write(&self.path, 0, source))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn lines_stay_under_their_hash_and_a_torn_one_is_lost() {
        let study = tempfile::tempdir().unwrap();
        let first = Scratch::open(study.path(), "law", "a").unwrap();
        assert!(first.lines().is_empty());
        first.keep("one").unwrap();
        first.keep("two").unwrap();
        let path = study.path().join(".scratch-law");
        fs::write(&path, fs::read_to_string(&path).unwrap() + "thr").unwrap();
        let second = Scratch::open(study.path(), "law", "a").unwrap();
        assert_eq!(second.lines(), ["one", "two"]);
        second.keep("three").unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), "a\none\ntwo\nthree\n");
        assert!(Scratch::open(study.path(), "law", "b").unwrap().lines().is_empty());
        second.discard().unwrap();
        assert!(!path.exists());
    }
}
