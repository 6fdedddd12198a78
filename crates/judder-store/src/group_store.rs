//! The files of one group, as the array library writes and reads them: through `judder-disk`, forced to the disk one by one; or told, and not written.

use std::collections::HashMap;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use zarrs::filesystem::{FilesystemStore, FilesystemStoreCreateError};
use zarrs::storage::byte_range::ByteRangeIterator;
use zarrs::storage::{
    Bytes, MaybeBytesIterator, OffsetBytesIterator, ReadableStorageTraits, StorageError, StoreKey,
    StorePrefix, WritableStorageTraits, store_set_partial_many,
};

use crate::content_hash;

/// Files that were written by their paths, with size and hash of what each was to hold.
pub(crate) type WrittenFiles = HashMap<PathBuf, (u64, String)>;

/// A group that is being written, or described.
#[derive(Debug)]
pub(crate) struct GroupStore {
    store: FilesystemStore,
    /// Whether its files are told alone.
    is_told: bool,
    written: Mutex<WrittenFiles>,
}

impl GroupStore {
    /// That of a folder.
    ///
    /// # Errors
    /// A path that cannot be one.
    pub(crate) fn new(folder: &Path) -> Result<Self, FilesystemStoreCreateError> {
        Ok(Self { store: FilesystemStore::new(folder)?, is_told: false, written: Mutex::default() })
    }

    /// That of a folder, of which the files are told: nothing is read there, and nothing written.
    ///
    /// # Errors
    /// As of [`new`](Self::new).
    pub(crate) fn told(folder: &Path) -> Result<Self, FilesystemStoreCreateError> {
        Ok(Self { is_told: true, ..Self::new(folder)? })
    }

    /// Writes a file, where files are written.
    pub(crate) fn put(&self, path: PathBuf, content: &[u8]) -> io::Result<()> {
        if !self.is_told {
            if let Some(folder) = path.parent() {
                judder_disk::create_folders(folder)?;
            }
            let file = judder_disk::create_file(&path)?;
            judder_disk::write(&file, content)?;
            judder_disk::sync(&file)?;
        }
        let listed = (content.len() as u64, content_hash(content));
        self.written.lock().unwrap_or_else(PoisonError::into_inner).insert(path, listed);
        Ok(())
    }

    /// What was written, so that no file is read to be listed.
    pub(crate) fn written(&self) -> WrittenFiles {
        self.written.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }
}

impl ReadableStorageTraits for GroupStore {
    fn get_partial_many<'a>(
        &'a self,
        key: &StoreKey,
        byte_ranges: ByteRangeIterator<'a>,
    ) -> Result<MaybeBytesIterator<'a>, StorageError> {
        if self.is_told { Ok(None) } else { self.store.get_partial_many(key, byte_ranges) }
    }

    fn size_key(&self, key: &StoreKey) -> Result<Option<u64>, StorageError> {
        if self.is_told { Ok(None) } else { self.store.size_key(key) }
    }

    fn supports_get_partial(&self) -> bool {
        self.store.supports_get_partial()
    }
}

impl WritableStorageTraits for GroupStore {
    fn set(&self, key: &StoreKey, value: Bytes) -> Result<(), StorageError> {
        Ok(self.put(self.store.key_to_fspath(key), &value)?)
    }

    fn set_partial_many(
        &self,
        key: &StoreKey,
        offset_values: OffsetBytesIterator<'_>,
    ) -> Result<(), StorageError> {
        store_set_partial_many(self, key, offset_values)
    }

    fn erase(&self, key: &StoreKey) -> Result<(), StorageError> {
        Ok(judder_disk::remove(&self.store.key_to_fspath(key))?)
    }

    fn erase_prefix(&self, prefix: &StorePrefix) -> Result<(), StorageError> {
        Ok(judder_disk::remove(&self.store.prefix_to_fs_path(prefix))?)
    }

    fn supports_set_partial(&self) -> bool {
        false
    }
}
