//! The files of one group, as the array library writes and reads them: through `judder-disk`, forced to the disk one by one.

use std::collections::HashMap;
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

/// A group that is being written.
#[derive(Debug)]
pub(crate) struct GroupStore {
    store: FilesystemStore,
    written: Mutex<WrittenFiles>,
}

impl GroupStore {
    /// That of a folder.
    ///
    /// # Errors
    /// A path that cannot be one.
    pub(crate) fn new(folder: &Path) -> Result<Self, FilesystemStoreCreateError> {
        Ok(Self { store: FilesystemStore::new(folder)?, written: Mutex::default() })
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
        self.store.get_partial_many(key, byte_ranges)
    }

    fn size_key(&self, key: &StoreKey) -> Result<Option<u64>, StorageError> {
        self.store.size_key(key)
    }

    fn supports_get_partial(&self) -> bool {
        self.store.supports_get_partial()
    }
}

impl WritableStorageTraits for GroupStore {
    fn set(&self, key: &StoreKey, value: Bytes) -> Result<(), StorageError> {
        let path = self.store.key_to_fspath(key);
        if let Some(folder) = path.parent() {
            judder_disk::create_folders(folder)?;
        }
        let file = judder_disk::create_file(&path)?;
        judder_disk::write(&file, &value)?;
        judder_disk::sync(&file)?;
        let listed = (value.len() as u64, content_hash(&value));
        self.written.lock().unwrap_or_else(PoisonError::into_inner).insert(path, listed);
        Ok(())
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
