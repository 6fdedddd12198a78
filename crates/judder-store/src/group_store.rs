//! The files of one group, as the array library writes and reads them: through `judder-disk`, forced to the disk one by one.

use std::path::Path;

use zarrs::filesystem::{FilesystemStore, FilesystemStoreCreateError};
use zarrs::storage::byte_range::ByteRangeIterator;
use zarrs::storage::{
    Bytes, MaybeBytesIterator, OffsetBytesIterator, ReadableStorageTraits, StorageError, StoreKey,
    StorePrefix, WritableStorageTraits, store_set_partial_many,
};

/// A group that is being written.
#[derive(Debug)]
pub(crate) struct GroupStore(FilesystemStore);

impl GroupStore {
    /// That of a folder.
    ///
    /// # Errors
    /// A path that cannot be one.
    pub(crate) fn new(folder: &Path) -> Result<Self, FilesystemStoreCreateError> {
        FilesystemStore::new(folder).map(Self)
    }
}

impl ReadableStorageTraits for GroupStore {
    fn get_partial_many<'a>(
        &'a self,
        key: &StoreKey,
        byte_ranges: ByteRangeIterator<'a>,
    ) -> Result<MaybeBytesIterator<'a>, StorageError> {
        self.0.get_partial_many(key, byte_ranges)
    }

    fn size_key(&self, key: &StoreKey) -> Result<Option<u64>, StorageError> {
        self.0.size_key(key)
    }

    fn supports_get_partial(&self) -> bool {
        self.0.supports_get_partial()
    }
}

impl WritableStorageTraits for GroupStore {
    fn set(&self, key: &StoreKey, value: Bytes) -> Result<(), StorageError> {
        let path = self.0.key_to_fspath(key);
        if let Some(folder) = path.parent() {
            judder_disk::create_folders(folder)?;
        }
        let file = judder_disk::create_file(&path)?;
        judder_disk::write(&file, &value)?;
        Ok(judder_disk::sync(&file)?)
    }

    fn set_partial_many(
        &self,
        key: &StoreKey,
        offset_values: OffsetBytesIterator<'_>,
    ) -> Result<(), StorageError> {
        store_set_partial_many(self, key, offset_values)
    }

    fn erase(&self, key: &StoreKey) -> Result<(), StorageError> {
        Ok(judder_disk::remove(&self.0.key_to_fspath(key))?)
    }

    fn erase_prefix(&self, prefix: &StorePrefix) -> Result<(), StorageError> {
        Ok(judder_disk::remove(&self.0.prefix_to_fs_path(prefix))?)
    }

    fn supports_set_partial(&self) -> bool {
        false
    }
}
