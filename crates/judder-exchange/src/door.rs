//! The way in: a file is read whole where it is a file and where the budget has room for it.

use crate::cause::FileCause;
use crate::error::ExchangeError;
use judder_memory::MemoryBudget;
use std::path::Path;

/// The bytes of a file of which `times` its size is needed to read it, the bytes themselves among them.
///
/// # Errors
/// [`FileCause::Unreadable`], [`FileCause::NotAFile`] for a folder, a device or a pipe, which may have no end, [`FileCause::Memory`].
pub(crate) fn bytes_of(path: &Path, times: u64, budget: MemoryBudget) -> Result<Vec<u8>, ExchangeError> {
    let unreadable = |source| ExchangeError::from(FileCause::Unreadable { source }).in_file(path);
    let known = std::fs::metadata(path).map_err(unreadable)?;
    if !known.is_file() {
        return Err(ExchangeError::from(FileCause::NotAFile).in_file(path));
    }
    ask(budget, "the file", u128::from(known.len()) * u128::from(times))
        .map_err(|cause| ExchangeError::from(cause).in_file(path))?;
    std::fs::read(path).map_err(unreadable)
}

/// Whether the budget has so many bytes.
pub(crate) fn ask(budget: MemoryBudget, what: &'static str, needed: u128) -> Result<(), FileCause> {
    budget.ask(needed).map_err(|source| FileCause::Memory { what, source })
}

/// The most that DEFLATE makes of a byte.
const DEFLATE: u64 = 1032;

/// Whether so many packed bytes can unpack to what is said, and whether the budget has what that takes.
pub(crate) fn check_unpacked(
    said: u64,
    packed: u64,
    budget: MemoryBudget,
    needed: u128,
) -> Result<(), FileCause> {
    const WHAT: &str = "unpacked bytes";
    let room = packed.saturating_mul(DEFLATE).saturating_add(DEFLATE);
    if said > room {
        let sizes = [said, packed, room].map(|size| usize::try_from(size).unwrap_or(usize::MAX));
        return Err(FileCause::TooMany { what: WHAT, said: sizes[0], left: sizes[1], room: sizes[2] });
    }
    ask(budget, "what the file unpacks to", needed)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_file_or_too_large_is_not_read() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.mtx");
        std::fs::write(&path, [0; 100]).unwrap();
        let budget = MemoryBudget::of_bytes(1000);
        assert_eq!(bytes_of(&path, 10, budget).unwrap().len(), 100);
        let message = bytes_of(&path, 11, budget).unwrap_err().to_string();
        assert!(message.contains("a.mtx: the file: 1.1 kB of memory are needed, and 1.0 kB"), "{message}");
        assert!(message.contains("--memory"), "{message}");
        assert!(bytes_of(folder.path(), 1, budget).unwrap_err().to_string().contains("is no file"));
        #[cfg(unix)]
        assert!(bytes_of(Path::new("/dev/zero"), 1, budget).is_err());
    }

    #[test]
    fn no_more_is_unpacked_than_deflate_can_make() {
        let budget = MemoryBudget::of_bytes(5000);
        check_unpacked(4000, 4, budget, 4000).unwrap();
        assert!(matches!(check_unpacked(40_000, 4, budget, 4000), Err(FileCause::TooMany { .. })));
        assert!(matches!(check_unpacked(4000, 4, budget, 8000), Err(FileCause::Memory { .. })));
    }
}
