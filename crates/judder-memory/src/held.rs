//! What several pieces of work hold together of one budget.

use super::{BeyondMemory, MemoryBudget};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

/// A budget, and what is held of it; its copies are one.
#[derive(Debug, Clone)]
pub struct HeldMemory {
    budget: MemoryBudget,
    held: Arc<AtomicU64>,
}

/// A part of what is held; it is given back when it is dropped.
#[derive(Debug)]
pub struct TakenMemory {
    of: HeldMemory,
    bytes: u64,
}

impl HeldMemory {
    /// Nothing yet, of a budget.
    #[must_use]
    pub fn of(budget: MemoryBudget) -> Self {
        Self { budget, held: Arc::default() }
    }

    /// Takes so many bytes.
    ///
    /// # Errors
    /// With what is held already they do not fit.
    pub fn take(&self, bytes: u64) -> Result<TakenMemory, BeyondMemory> {
        let mut taken = TakenMemory { of: self.clone(), bytes: 0 };
        taken.take(bytes)?;
        Ok(taken)
    }

    /// How many times so many bytes fit beside what is held; once at least.
    #[must_use]
    pub fn fit(&self, bytes: u64) -> usize {
        let left = self.budget.most().saturating_sub(self.held.load(Ordering::Relaxed));
        usize::try_from(left / bytes.max(1)).unwrap_or(usize::MAX).max(1)
    }
}

impl TakenMemory {
    /// Takes so many bytes more.
    ///
    /// # Errors
    /// With what is held already they do not fit.
    pub fn take(&mut self, bytes: u64) -> Result<(), BeyondMemory> {
        self.bytes += bytes;
        let before = self.of.held.fetch_add(bytes, Ordering::Relaxed);
        let asked = self.of.budget.ask(u128::from(before) + u128::from(bytes));
        if asked.is_err() {
            // others may have what is refused here
            self.keep(self.bytes - bytes);
        }
        asked
    }

    /// Gives all but so many bytes back.
    pub fn keep(&mut self, bytes: u64) {
        let given = self.bytes.saturating_sub(bytes);
        self.bytes -= given;
        self.of.held.fetch_sub(given, Ordering::Relaxed);
    }

    /// What it is a part of.
    #[must_use]
    pub fn of(&self) -> &HeldMemory {
        &self.of
    }
}

impl Drop for TakenMemory {
    fn drop(&mut self) {
        self.keep(0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_held_counts_until_it_is_dropped() {
        let held = HeldMemory::of(MemoryBudget::of_bytes(100));
        let mut first = held.take(60).unwrap();
        assert_eq!(held.clone().take(50).unwrap_err().needed, 110, "copies are one");
        // what was refused is not held
        let second = held.take(40).unwrap();
        assert_eq!(first.take(1).unwrap_err().needed, 101);
        first.keep(10);
        drop(second);
        drop(first.of().take(90).unwrap());
        drop(first);
        held.take(100).unwrap();
        assert!(HeldMemory::of(MemoryBudget::unlimited()).take(u64::MAX).is_ok());
    }
}
