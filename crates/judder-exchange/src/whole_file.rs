//! Files that are there as a whole or not at all.

use crate::error::ExchangeError;
use std::io::Write;
use std::path::Path;

/// Writes a file under another name in the same folder and gives it its own when it is whole: a reader sees what was there
/// before, or all of the new. What a writer that was killed has left in the folder is removed.
///
/// # Errors
/// What `write` says, and [`FileCause::Unwritable`](crate::cause::FileCause::Unwritable); what was there before is still there.
pub fn write_file(
    path: &Path,
    write: impl FnOnce(&mut dyn Write) -> Result<(), ExchangeError>,
) -> Result<(), ExchangeError> {
    judder_disk::remove_leftovers(path);
    write_next(path, write)
}

/// The same for a file of many in one folder, in which nobody looks again for what others have left.
pub(crate) fn write_next(
    path: &Path,
    write: impl FnOnce(&mut dyn Write) -> Result<(), ExchangeError>,
) -> Result<(), ExchangeError> {
    judder_disk::write_whole(path, write).map_err(|error: ExchangeError| error.in_file(path))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cause::FileCause;

    #[test]
    fn what_fails_names_the_file() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.mtx");
        let failed = write_file(&path, |_| Err(FileCause::NoElements.into()));
        assert!(failed.unwrap_err().to_string().contains("a.mtx"));
        let failed = write_file(&folder.path().join("missing/a.mtx"), |_| Ok(()));
        assert!(failed.unwrap_err().to_string().contains("a.mtx"));
    }
}
