//! Files that are there as a whole or not at all.

use crate::calls;
use crate::staged::StagingFolder;
use std::io::{self, BufWriter, Write};
use std::path::Path;

/// How the names of the folders begin in which files are put together that are no part of a study.
const PREFIX: &str = ".partial-";

/// Writes a file under another name in the same folder and gives it its own when it is whole: a reader sees what was there before, or all of the
/// new.
///
/// # Errors
/// What `write` says, and `E` of a failure of the file system; what was there before is still there.
pub fn write_whole<E: From<io::Error>>(
    path: &Path,
    write: impl FnOnce(&mut dyn Write) -> Result<(), E>,
) -> Result<(), E> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let stage = StagingFolder::new(folder, PREFIX)?;
    let staged = stage.path().join("content");
    let file = calls::create_new_file(&staged)?;
    let mut buffered = BufWriter::new(Through(&file));
    write(&mut buffered)?;
    buffered.flush()?;
    calls::sync(&file)?;
    Ok(calls::rename(&staged, path)?)
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
    use std::fs;

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
}
