//! How much of the machine's memory this process may take: one budget, asked before anything large is allocated.
//!
//! - [`MemoryBudget`]: what may be taken, and the refusal [`BeyondMemory`]; [`Crowded`] where fewer at once would have it.
//! - [`HeldMemory`]: what several pieces of work hold of one budget.
//! - `free`: what the system says is free.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod free;
mod held;

use free::SystemMemory;
pub use held::{HeldMemory, TakenMemory};

use std::cell::Cell;
use std::fmt;
use std::sync::atomic::{AtomicU64, Ordering};
use thiserror::Error;

/// What was [told](MemoryBudget::tell); zero where nothing was.
static TOLD: AtomicU64 = AtomicU64::new(0);

/// The share of what is free that is taken where nothing was told: the rest is for what is not estimated, and for others.
const SHARE: u64 = 4;

thread_local! {
    /// Among how many the work of this thread [shares](MemoryBudget::shared) the budget of the process.
    static SHARED_BY: Cell<u64> = const { Cell::new(1) };
    /// What work that [may be put off](MemoryBudget::shared_or_crowded) was refused, the worst of it.
    static REFUSED: Cell<Option<BeyondMemory>> = const { Cell::new(None) };
}

/// How much memory a piece of work may take.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MemoryBudget {
    /// In bytes; none where there is no limit.
    bytes: Option<u64>,
    origin: BudgetOrigin,
    /// Among how many that of the process is divided.
    shared_by: u64,
    /// What is held of it already.
    held: u128,
}

/// Where a budget comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BudgetOrigin {
    /// Whoever started the process said it.
    Told,
    /// Three quarters of what is free.
    Free,
}

/// Work was refused memory because others work beside it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Crowded {
    /// How many may work at once instead: fewer, and one at least.
    pub at_once: u64,
}

/// Something would take more memory than there is for it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[error("{} of memory are needed, and {} are to be had, {origin}{}", Amount(*needed), Amount(u128::from(*budget)), ShareWords(*shared_by))]
pub struct BeyondMemory {
    /// Bytes that it would take.
    pub needed: u128,
    /// Bytes that it may take.
    pub budget: u64,
    /// Where the budget comes from.
    pub origin: BudgetOrigin,
    /// Among how many it is divided.
    pub shared_by: u64,
}

impl MemoryBudget {
    /// Sets what all later budgets of this process are; with zero what they are where nothing was told.
    pub fn tell(bytes: u64) {
        TOLD.store(bytes, Ordering::Relaxed);
    }

    /// Does work that may take one part of so many of what the process may: budgets that this thread asks for meanwhile are these parts.
    pub fn shared<T>(among: u64, work: impl FnOnce() -> T) -> T {
        /// Gives back what was, however the work ends.
        struct EarlierShare(u64);
        impl Drop for EarlierShare {
            fn drop(&mut self) {
                SHARED_BY.set(self.0);
            }
        }
        let _earlier = EarlierShare(SHARED_BY.replace(among.max(1)));
        work()
    }

    /// The same of work that can be done again with fewer beside it.
    ///
    /// # Errors
    /// Something of it was refused that alone it might have; what came of it is of no use.
    pub fn shared_or_crowded<T>(among: u64, work: impl FnOnce() -> T) -> Result<T, Crowded> {
        REFUSED.set(None);
        let done = Self::shared(among, work);
        match REFUSED.take() {
            Some(refused) if among > 1 => {
                let whole = u128::from(refused.budget) * u128::from(refused.shared_by);
                let fit = u64::try_from(whole / refused.needed.max(1)).unwrap_or(u64::MAX);
                Err(Crowded { at_once: fit.clamp(1, among - 1) })
            }
            _ => Ok(done),
        }
    }

    /// Among how many this thread's work shares: what another thread does for it is to share as well.
    #[must_use]
    pub fn parts() -> u64 {
        SHARED_BY.get()
    }

    /// What was told, or three quarters of what is free now: of the machine, of the control group, of the address space, whichever is
    /// least; of that the part which this thread's work [shares](Self::shared). Where the system does not say, there is no limit.
    #[must_use]
    pub fn of_process() -> Self {
        Self::beside(|_| 0)
    }

    /// The same for all that the process will hold at its peak: what it holds already counts as free.
    #[must_use]
    pub fn of_whole_process() -> Self {
        Self::beside(|memory| memory.resident.unwrap_or(0))
    }

    /// The same for work beside so many bytes that belong to it and are held already. What was told holds for both together; what is free is free beside them.
    #[must_use]
    pub fn of_process_beside(held: u128) -> Self {
        let own = Self::of_process();
        let counted = if own.origin == BudgetOrigin::Told { held } else { 0 };
        Self { held: counted, ..own }
    }

    /// With so many bytes free beside those that the system says are.
    fn beside(held: fn(&SystemMemory) -> u64) -> Self {
        let share =
            |memory: SystemMemory| Some(memory.free?.saturating_add(held(&memory)) / SHARE * (SHARE - 1));
        let (bytes, origin) = match TOLD.load(Ordering::Relaxed) {
            0 => (share(free::system_memory()), BudgetOrigin::Free),
            told => (Some(told), BudgetOrigin::Told),
        };
        let shared_by = SHARED_BY.get();
        Self { bytes: bytes.map(|bytes| bytes / shared_by), origin, shared_by, held: 0 }
    }

    /// No limit.
    #[must_use]
    pub const fn unlimited() -> Self {
        Self { bytes: None, origin: BudgetOrigin::Told, shared_by: 1, held: 0 }
    }

    /// So many bytes.
    #[must_use]
    pub const fn of_bytes(bytes: u64) -> Self {
        Self { bytes: Some(bytes), origin: BudgetOrigin::Told, shared_by: 1, held: 0 }
    }

    /// The most that fits, in bytes.
    #[must_use]
    pub fn most(&self) -> u64 {
        let held = u64::try_from(self.held).unwrap_or(u64::MAX);
        self.bytes.map_or(u64::MAX, |bytes| bytes.saturating_sub(held))
    }

    /// Among how many that of the process is divided.
    #[must_use]
    pub fn shared_by(&self) -> u64 {
        self.shared_by
    }

    /// The same of which so much is left.
    #[must_use]
    pub fn of_which(self, bytes: u64) -> Self {
        Self { bytes: Some(bytes), ..self }
    }

    /// Whether so many bytes fit.
    ///
    /// # Errors
    /// They do not.
    pub fn ask(&self, needed: u128) -> Result<(), BeyondMemory> {
        let needed = needed.saturating_add(self.held);
        match self.bytes {
            Some(budget) if needed > u128::from(budget) => {
                let refused = BeyondMemory { needed, budget, origin: self.origin, shared_by: self.shared_by };
                refused.note();
                Err(refused)
            }
            _ => Ok(()),
        }
    }
}

impl BeyondMemory {
    /// Counts as refused to this thread, as of work that [may be put off](MemoryBudget::shared_or_crowded): another thread that worked for it was refused.
    pub fn note(self) {
        let worst = REFUSED.get().filter(|earlier| earlier.needed > self.needed);
        REFUSED.set(Some(worst.unwrap_or(self)));
    }

    /// How to go on.
    #[must_use]
    pub fn remedy(&self) -> String {
        self.remedy_or("ask for less")
    }

    /// The same where this would take less.
    #[must_use]
    pub fn remedy_or(&self, less: &str) -> String {
        /// More than one machine has: 64 TiB.
        const NOWHERE: u128 = 1 << 46;
        if self.needed > NOWHERE {
            return format!("{less}: no machine has that");
        }
        let gibibytes = (self.needed * u128::from(self.shared_by)).div_ceil(1 << 30);
        format!("{less}, or give judder more with --memory \"{gibibytes} GiB\" where the machine has it")
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

/// Among how many a budget is shared, in words.
struct ShareWords(u64);

impl fmt::Display for ShareWords {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0 > 1 { write!(f, ", shared among {} that may work at once", self.0) } else { Ok(()) }
    }
}

/// Bytes in words: `15.6 GB`.
#[must_use]
pub fn in_words(bytes: u128) -> String {
    Amount(bytes).to_string()
}

/// The same as it stands in messages.
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
        let fewer = beyond.remedy_or("take fewer cells");
        assert!(
            fewer.starts_with("take fewer cells, or give judder more with --memory \"15 GiB\""),
            "{fewer}"
        );
        assert!(nowhere.to_string().contains("EB") && !nowhere.remedy().contains("--memory"), "{nowhere}");
    }

    #[test]
    fn who_shares_is_given_a_part_and_told_so() {
        let alone = || MemoryBudget::of_process().ask(u128::MAX).unwrap_err();
        let (whole, part) = (alone(), MemoryBudget::shared(6, alone));
        assert_eq!((whole.shared_by, part.shared_by), (1, 6));
        // what is free changes between two looks
        let ratio = whole.budget as f64 / part.budget as f64;
        assert!((4.0..9.0).contains(&ratio), "{ratio}");
        assert!(part.to_string().ends_with("shared among 6 that may work at once"), "{part}");
        let small = BeyondMemory { needed: 1 << 31, budget: 1 << 30, ..part };
        assert!(small.remedy().contains("--memory \"12 GiB\""), "{}", small.remedy());
        assert_eq!(alone().shared_by, 1, "what was is so again");
    }

    #[test]
    fn who_is_refused_among_others_is_told_how_many_fit() {
        let whole = MemoryBudget::of_process().ask(u128::MAX).unwrap_err().budget;
        let taking = |part: u64, among| {
            MemoryBudget::shared_or_crowded(among, || {
                MemoryBudget::of_process().ask(u128::from(whole / part)).is_ok()
            })
        };
        // what is free changes between two looks: no part is near an edge
        assert_eq!(taking(20, 8), Ok(true));
        assert!(matches!(taking(7, 16), Err(Crowded { at_once: 6..=8 })));
        assert_eq!(taking(10_000_000, 1), Ok(true), "what was refused before is forgotten");
        let beyond = |among| {
            MemoryBudget::shared_or_crowded(among, || MemoryBudget::of_process().ask(u128::MAX).is_ok())
        };
        assert_eq!(beyond(8), Err(Crowded { at_once: 1 }), "alone it is told what is wrong");
        assert_eq!(beyond(1), Ok(false));
    }
}
