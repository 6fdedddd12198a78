//! How much of the machine's memory this process may take: one budget, asked before anything large is allocated.
//!
//! - [`MemoryBudget`]: what may be taken, and the refusal [`BeyondMemory`].
//! - `free`: what the system says is free.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod free;

use std::fmt;
use std::sync::atomic::{AtomicU64, Ordering};
use thiserror::Error;

/// What was [told](MemoryBudget::tell); zero where nothing was.
static TOLD: AtomicU64 = AtomicU64::new(0);

/// The share of what is free that is taken where nothing was told: the rest is for what is not estimated, and for others.
const SHARE: u64 = 4;

/// How much memory a piece of work may take.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MemoryBudget {
    /// In bytes; none where there is no limit.
    bytes: Option<u64>,
    origin: BudgetOrigin,
}

/// Where a budget comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BudgetOrigin {
    /// Whoever started the process said it.
    Told,
    /// Three quarters of what is free.
    Free,
}

/// Something would take more memory than there is for it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[error("{} of memory are needed, and {} are to be had, {origin}", Amount(*needed), Amount(u128::from(*budget)))]
pub struct BeyondMemory {
    /// Bytes that it would take.
    pub needed: u128,
    /// Bytes that it may take.
    pub budget: u64,
    /// Where the budget comes from.
    pub origin: BudgetOrigin,
}

impl MemoryBudget {
    /// Sets what all later budgets of this process are.
    pub fn tell(bytes: u64) {
        TOLD.store(bytes, Ordering::Relaxed);
    }

    /// What was told, or three quarters of what is free now: of the machine, of the control group, of the address space, whichever is
    /// least. Where the system does not say, there is no limit.
    #[must_use]
    pub fn of_process() -> Self {
        match TOLD.load(Ordering::Relaxed) {
            0 => Self {
                bytes: free::free_bytes().map(|free| free / SHARE * (SHARE - 1)),
                origin: BudgetOrigin::Free,
            },
            told => Self::of_bytes(told),
        }
    }

    /// So many bytes.
    #[must_use]
    pub const fn of_bytes(bytes: u64) -> Self {
        Self { bytes: Some(bytes), origin: BudgetOrigin::Told }
    }

    /// Whether so many bytes fit.
    ///
    /// # Errors
    /// They do not.
    pub fn ask(&self, needed: u128) -> Result<(), BeyondMemory> {
        match self.bytes {
            Some(budget) if needed > u128::from(budget) => {
                Err(BeyondMemory { needed, budget, origin: self.origin })
            }
            _ => Ok(()),
        }
    }
}

impl BeyondMemory {
    /// How to go on.
    #[must_use]
    pub fn remedy(&self) -> String {
        /// More than one machine has: 64 TiB.
        const NOWHERE: u128 = 1 << 46;
        if self.needed > NOWHERE {
            return "ask for less: no machine has that".to_owned();
        }
        let gibibytes = self.needed.div_ceil(1 << 30);
        format!(
            "ask for less, or give judder more with --memory \"{gibibytes} GiB\" where the machine has it"
        )
    }
}

impl fmt::Display for BudgetOrigin {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Told => "as was said",
            Self::Free => "three quarters of what is free",
        })
    }
}

/// Bytes in words: `15.6 GB`.
struct Amount(u128);

impl fmt::Display for Amount {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        const UNITS: [(&str, f64); 5] = [("EB", 1e18), ("PB", 1e15), ("TB", 1e12), ("GB", 1e9), ("MB", 1e6)];
        let bytes = self.0 as f64;
        match UNITS.iter().find(|(_, size)| bytes >= *size) {
            Some((unit, size)) => write!(f, "{:.1} {unit}", bytes / size),
            None => write!(f, "{:.1} kB", bytes / 1e3),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_fits_passes_and_the_rest_is_told_with_both_numbers() {
        let budget = MemoryBudget::of_bytes(3_900_000_000);
        budget.ask(3_900_000_000).unwrap();
        let beyond = budget.ask(15_600_000_000).unwrap_err();
        assert_eq!(beyond.to_string(), "15.6 GB of memory are needed, and 3.9 GB are to be had, as was said");
        assert!(beyond.remedy().contains("--memory \"15 GiB\""), "{}", beyond.remedy());
        let nowhere = budget.ask(u128::MAX).unwrap_err();
        assert!(nowhere.to_string().contains("EB") && !nowhere.remedy().contains("--memory"), "{nowhere}");
    }
}
