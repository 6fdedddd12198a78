//! Kernels that have been computed before.

use super::spectra::KernelSpectra;
use super::substrate::SlidingSubstrate;
use std::sync::{Arc, Mutex, PoisonError};

/// Kernels by the numbers of cells and the ratios ℓ/h, shared by threads and bounded in bytes.
///
/// What a computation gets does not depend on what is in the cache, so neither does its result. The kernels used
/// longest ago go first.
pub struct KernelCache {
    capacity: u64,
    /// From the one used longest ago to the one used last.
    entries: Mutex<Vec<CachedKernel>>,
}

struct CachedKernel {
    key: KernelKey,
    bytes: u64,
    spectra: Arc<KernelSpectra>,
}

#[derive(PartialEq)]
struct KernelKey {
    columns: usize,
    rows: usize,
    substrate: SlidingSubstrate,
}

impl KernelCache {
    /// An empty cache that keeps at most `capacity` bytes; with 0 nothing is kept.
    #[must_use]
    pub fn new(capacity: u64) -> Self {
        Self { capacity, entries: Mutex::new(Vec::new()) }
    }

    /// The kernel of a grid without images; lengths of the substrate in cells.
    #[must_use]
    pub fn spectra(&self, columns: usize, rows: usize, substrate: &SlidingSubstrate) -> Arc<KernelSpectra> {
        let key = KernelKey { columns, rows, substrate: substrate.clone() };
        if let Some(known) = self.find(&key) {
            return known;
        }
        // Computed outside the lock: two threads may compute the same kernel, none waits for another's.
        let spectra = Arc::new(KernelSpectra::unbounded(columns, rows, substrate));
        self.keep(key, &spectra);
        spectra
    }

    /// Bytes held.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        self.lock().iter().map(|entry| entry.bytes).sum()
    }

    /// A thread that panicked while it held the lock leaves a list that is whole: every change is one step.
    fn lock(&self) -> std::sync::MutexGuard<'_, Vec<CachedKernel>> {
        self.entries.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn find(&self, key: &KernelKey) -> Option<Arc<KernelSpectra>> {
        let mut entries = self.lock();
        let index = entries.iter().position(|entry| entry.key == *key)?;
        entries[index..].rotate_left(1);
        entries.last().map(|entry| Arc::clone(&entry.spectra))
    }

    fn keep(&self, key: KernelKey, spectra: &Arc<KernelSpectra>) {
        let bytes = KernelSpectra::memory_bytes(key.columns, key.rows);
        let mut entries = self.lock();
        if bytes > self.capacity || entries.iter().any(|entry| entry.key == key) {
            return;
        }
        while entries.iter().map(|entry| entry.bytes).sum::<u64>() > self.capacity - bytes {
            entries.remove(0);
        }
        entries.push(CachedKernel { key, bytes, spectra: Arc::clone(spectra) });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_kernel_used_longest_ago_goes_first() {
        let bytes = KernelSpectra::memory_bytes(8, 8);
        let cache = KernelCache::new(2 * bytes);
        let substrate = |length| SlidingSubstrate::single(10.0, length);
        let first = cache.spectra(8, 8, &substrate(1.0));
        let second = cache.spectra(8, 8, &substrate(2.0));
        assert!(Arc::ptr_eq(&first, &cache.spectra(8, 8, &substrate(1.0))));
        let third = cache.spectra(8, 8, &substrate(3.0));
        assert!(Arc::ptr_eq(&first, &cache.spectra(8, 8, &substrate(1.0))));
        assert!(Arc::ptr_eq(&third, &cache.spectra(8, 8, &substrate(3.0))));
        assert!(!Arc::ptr_eq(&second, &cache.spectra(8, 8, &substrate(2.0))));
        assert_eq!(cache.bytes(), 2 * bytes);
    }
}
