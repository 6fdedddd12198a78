//! Regular files, and nothing else that a name may lead to: a pipe would be waited for, a device read until memory ends.

use std::fs::{self, File};
use std::io::{self, ErrorKind, Read};
use std::path::Path;

use judder_disk::kind_in_words;
use judder_memory::MemoryBudget;

/// Opens a regular file to read; anything else is refused without waiting for it.
pub(crate) fn open(path: &Path) -> io::Result<File> {
    let mut options = fs::OpenOptions::new();
    options.read(true);
    #[cfg(unix)]
    {
        use std::os::unix::fs::OpenOptionsExt;
        // a pipe that nobody writes to would be waited for
        options.custom_flags(NON_BLOCKING);
    }
    let file = options.open(path)?;
    let kind = file.metadata()?.file_type();
    if kind.is_file() {
        Ok(file)
    } else {
        Err(io::Error::new(ErrorKind::InvalidInput, NotAFile(kind_in_words(kind))))
    }
}

/// The longest document that a study has, in bytes: metadata, summary, manifest, a law. A manifest of a million files is shorter.
pub const LARGEST_DOCUMENT: u64 = 256 << 20;

/// A file is longer than any of its kind.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("it has {size} bytes, where such a file has at most {largest}")]
pub struct OversizedFile {
    /// Its size in bytes.
    pub size: u64,
    /// The most that one has.
    pub largest: u64,
}

impl OversizedFile {
    /// What a failure of [`read_small_file`] says of it.
    #[must_use]
    pub fn of(failure: &io::Error) -> Option<Self> {
        failure.get_ref()?.downcast_ref().copied()
    }
}

/// Reads a regular file whole, where there is memory for it.
pub(crate) fn read(path: &Path) -> io::Result<Vec<u8>> {
    read_small_file(path, u64::MAX)
}

/// Reads a regular file whole, of at most so many bytes, where there is memory for it.
///
/// # Errors
/// [`OversizedFile`] before anything is read; what is no file, or takes more memory than there is; a failure of the file system.
pub fn read_small_file(path: &Path, largest: u64) -> io::Result<Vec<u8>> {
    let file = open(path)?;
    let size = file.metadata()?.len();
    check_size(size, largest)?;
    ask(u128::from(size))?;
    let mut content = Vec::new();
    content.try_reserve_exact(usize::try_from(size).unwrap_or(usize::MAX))?;
    // one that grows meanwhile is read as far as it was asked for
    file.take(size).read_to_end(&mut content)?;
    Ok(content)
}

/// Refuses a file of more bytes than any of its kind has.
pub(crate) fn check_size(size: u64, largest: u64) -> io::Result<()> {
    if size <= largest {
        return Ok(());
    }
    Err(io::Error::new(ErrorKind::FileTooLarge, OversizedFile { size, largest }))
}

/// Reads a document of JSON, where there is memory for what it says.
pub(crate) fn read_json(path: &Path) -> io::Result<Vec<u8>> {
    let content = read_small_file(path, LARGEST_DOCUMENT)?;
    ask(content.len() as u128 + parsed_bytes(&content))?;
    Ok(content)
}

/// Bytes that a document takes as values, at most, while its longest list grows: each has a sign of these before it.
fn parsed_bytes(content: &[u8]) -> u128 {
    const VALUE: usize = 3 * size_of::<serde_json::Value>();
    let signs = content.iter().filter(|byte| matches!(byte, b',' | b':' | b'[' | b'{')).count();
    (content.len() + signs * VALUE) as u128
}

/// Refuses what takes more memory than there is.
pub(crate) fn ask(bytes: u128) -> io::Result<()> {
    MemoryBudget::of_process()
        .ask(bytes)
        .map_err(|beyond| io::Error::new(ErrorKind::OutOfMemory, format!("{beyond}; {}", beyond.remedy())))
}

/// Whether a link stands at a place, wherever it leads.
pub(crate) fn is_link(path: &Path) -> bool {
    fs::symlink_metadata(path).is_ok_and(|metadata| metadata.is_symlink())
}

/// What stands in the place of a file, in words; none where it is one, or nothing is there.
pub(crate) fn other_than_file(path: &Path) -> Option<&'static str> {
    let kind = fs::symlink_metadata(path).ok()?.file_type();
    (!kind.is_file()).then(|| kind_in_words(kind))
}

#[cfg(unix)]
const NON_BLOCKING: i32 = {
    #[cfg(any(target_os = "linux", target_vendor = "apple"))]
    {
        rustix::fs::OFlags::NONBLOCK.bits() as i32
    }
    #[cfg(not(any(target_os = "linux", target_vendor = "apple")))]
    {
        0
    }
};

/// What stands where a file should.
#[derive(Debug, thiserror::Error)]
#[error("this is {0}, where a file should be")]
struct NotAFile(&'static str);

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use super::*;

    #[test]
    fn what_there_is_no_memory_for_is_not_read() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("summary.json");
        fs::File::create(&path).unwrap().set_len(1 << 42).unwrap();
        let refused = read(&path).unwrap_err();
        assert_eq!(refused.kind(), ErrorKind::OutOfMemory);
        assert!(refused.to_string().contains("4.4 TB of memory are needed"), "{refused}");
        let refused = read_small_file(&path, 1 << 20).unwrap_err();
        let oversized = OversizedFile { size: 1 << 42, largest: 1 << 20 };
        assert_eq!(OversizedFile::of(&refused), Some(oversized), "its size before the memory");
        // a short text of many values
        fs::write(&path, format!("[{}0]", "0,".repeat(1 << 20))).unwrap();
        let among = |parts| MemoryBudget::shared(parts, || read_json(&path));
        assert_eq!(among(1).unwrap().len(), (1 << 21) + 3);
        assert!(among(1 << 16).unwrap_err().to_string().contains("are needed"));
        assert_eq!(parsed_bytes(b"[0,1]"), 5 + 2 * 3 * size_of::<serde_json::Value>() as u128);
    }

    #[test]
    fn what_is_no_file_is_refused_at_once() {
        let folder = tempfile::tempdir().unwrap();
        let refused = |path: &Path| read(path).unwrap_err().to_string();
        assert_eq!(refused(folder.path()), "this is a folder, where a file should be");
        assert_eq!(refused(Path::new("/dev/zero")), "this is a device, where a file should be");
        let pipe = folder.path().join("pipe");
        assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
        assert_eq!(refused(&pipe), "this is a pipe, where a file should be");
        let file = folder.path().join("file");
        fs::write(&file, "content").unwrap();
        assert_eq!(read(&file).unwrap(), b"content");
    }
}
