//! Files that are there as a whole or not at all.

use crate::cause::FileCause;
use crate::error::ExchangeError;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::Path;

/// Writes a file under another name in the same folder and gives it its own when it is whole: a reader sees what was there
/// before, or all of the new.
///
/// # Errors
/// What `write` says, and [`FileCause::Unwritable`]; what was there before is still there.
pub fn write_file(
    path: &Path,
    write: impl FnOnce(&mut dyn Write) -> Result<(), ExchangeError>,
) -> Result<(), ExchangeError> {
    let unwritable = |source: io::Error| ExchangeError::from(FileCause::Unwritable { source }).in_file(path);
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let stage = tempfile::Builder::new().prefix(".partial-").tempdir_in(folder).map_err(unwritable)?;
    let staged = stage.path().join("content");
    let mut file = BufWriter::new(File::create_new(&staged).map_err(unwritable)?);
    write(&mut file).map_err(|error| error.in_file(path))?;
    let file = file.into_inner().map_err(|error| unwritable(error.into_error()))?;
    file.sync_all().map_err(unwritable)?;
    fs::rename(&staged, path).map_err(unwritable)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_that_fails_leaves_what_was_there() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.mtx");
        write_file(&path, |out| Ok(out.write_all(b"old")?)).unwrap();
        let failed = write_file(&path, |out| {
            out.write_all(b"new")?;
            Err(FileCause::NoElements.into())
        });
        assert!(failed.unwrap_err().to_string().contains("a.mtx"));
        assert_eq!(fs::read(&path).unwrap(), b"old");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
        assert!(write_file(&folder.path().join("missing/a.mtx"), |_| Ok(())).is_err());
    }
}
