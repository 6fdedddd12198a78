//! Files that are there as a whole or not at all.

use crate::calls;
use crate::staged::StagingFolder;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::Path;

/// How the names of the folders begin in which files are put together that are no part of a study; so many characters follow.
const PREFIX: &str = ".partial-file-";
const MARK: usize = 6;
/// The file in such a folder, locked by its writer.
const CONTENT: &str = "content";

/// Writes a file under another name in the same folder and gives it its own when it is whole: a reader sees what was there before, or all of the
/// new.
///
/// # Errors
/// What `write` says, and `E` of a failure of the file system; what was there before is still there.
pub fn write_whole<E: From<io::Error>>(
    path: &Path,
    write: impl FnOnce(&mut dyn Write) -> Result<(), E>,
) -> Result<(), E> {
    let (stage, file) = staged(folder_of(path))?;
    let mut buffered = BufWriter::new(Through(&file));
    write(&mut buffered)?;
    buffered.flush()?;
    calls::sync(&file)?;
    Ok(calls::rename(&stage.path().join(CONTENT), path)?)
}

/// A file under another name, held as long as it is written.
fn staged(folder: &Path) -> io::Result<(StagingFolder, File)> {
    loop {
        let stage = StagingFolder::new(folder, PREFIX)?;
        let place = stage.path().join(CONTENT);
        let file = calls::create_new_file(&place)?;
        // where the file system has no locks nobody takes it for a leftover, either
        let _ = file.try_lock();
        // somebody may have taken it for one before it was held
        if place.exists() {
            return Ok((stage, file));
        }
    }
}

/// Removes what writers that were killed have left beside this path: what nobody holds. What cannot be removed stays.
pub fn remove_leftovers(path: &Path) {
    let Ok(entries) = fs::read_dir(folder_of(path)) else { return };
    for folder in entries.flatten().filter(|entry| entry.file_name().to_str().is_some_and(is_staging)) {
        let folder = folder.path();
        if File::open(folder.join(CONTENT)).is_ok_and(|content| content.try_lock().is_ok()) {
            let _ = calls::remove(&folder);
        }
    }
}

fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// Whether a folder has the name of one in which a file is put together.
fn is_staging(name: &str) -> bool {
    let mark = name.strip_prefix(PREFIX);
    mark.is_some_and(|mark| mark.len() == MARK && mark.bytes().all(|byte| byte.is_ascii_alphanumeric()))
}

/// A file to which a writer writes.
struct Through<'a>(&'a std::fs::File);

impl Write for Through<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        calls::write(self.0, bytes).map(|()| bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_that_fails_leaves_what_was_there() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.mtx");
        write_whole(&path, |out| out.write_all(b"old")).unwrap();
        let failed = write_whole(&path, |out| {
            out.write_all(b"new")?;
            Err(io::Error::other("no more"))
        });
        assert_eq!(failed.unwrap_err().to_string(), "no more");
        assert_eq!(fs::read(&path).unwrap(), b"old");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
        assert!(write_whole(&folder.path().join("missing/a.mtx"), |_| io::Result::Ok(())).is_err());
    }

    #[test]
    fn what_a_killed_writer_has_left_is_removed_and_nothing_else() {
        let folder = tempfile::tempdir().unwrap();
        let place = |name: &str| folder.path().join(name);
        let staged_before = |name: &str| {
            fs::create_dir(place(name)).unwrap();
            fs::write(place(name).join(CONTENT), "half").unwrap();
        };
        staged_before(".partial-file-AbC012");
        staged_before(".partial-notes");
        let living = staged(folder.path()).unwrap();
        remove_leftovers(&place("a.mtx"));
        assert!(!place(".partial-file-AbC012").exists());
        assert!(place(".partial-notes").exists() && living.0.path().join(CONTENT).exists());
    }
}
