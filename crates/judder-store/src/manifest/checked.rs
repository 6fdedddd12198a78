//! A file that is compared with what is listed of it while it is read.

use std::fs::File;
use std::io::{self, Read, Take};

use super::{FileDamage, FileRecord};

/// A file of a study that is handed on as it is read, however large.
///
/// Its size was compared with what is listed of it before the first byte; its content is by the last one, which is an error in place of bytes where
/// it is not what was written.
#[derive(Debug)]
pub struct CheckedFile {
    file: Take<File>,
    size: u64,
    /// What was read hashes to, and the hash that was written; none where nothing is listed of it.
    listed: Option<(Box<blake3::Hasher>, String)>,
}

impl CheckedFile {
    /// A file of which this is listed.
    pub(crate) fn new(file: File, record: Option<FileRecord>) -> io::Result<Self> {
        let size = file.metadata()?.len();
        let listed = record.map(|record| (Box::default(), record.hash));
        Ok(Self { file: file.take(size), size, listed })
    }

    /// How many bytes it has.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        self.size
    }
}

impl Read for CheckedFile {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        let count = self.file.read(into)?;
        if let Some((hasher, written)) = &mut self.listed {
            hasher.update(into.get(..count).unwrap_or_default());
            if self.file.limit() == 0 && hasher.finalize().to_hex().as_str() != written {
                return Err(io::Error::new(io::ErrorKind::InvalidData, FileDamage::Content));
            }
        }
        Ok(count)
    }
}
