//! Runs that are stopped on the way.

use judder_study::Progress;
use std::sync::atomic::{AtomicUsize, Ordering};

/// A run that is stopped at the n-th look.
pub(crate) struct Stopping {
    looks: AtomicUsize,
    at: usize,
    steps: AtomicUsize,
}

impl Stopping {
    /// At the so many-th look, counted from zero.
    pub(crate) fn at(at: usize) -> Self {
        Self { looks: AtomicUsize::new(0), at, steps: AtomicUsize::new(0) }
    }

    /// How often it was looked.
    pub(crate) fn looks(&self) -> usize {
        self.looks.load(Ordering::Relaxed)
    }

    /// Steps that were announced and not taken.
    pub(crate) fn steps(&self) -> usize {
        self.steps.load(Ordering::Relaxed)
    }
}

impl Progress for Stopping {
    fn begin(&self, _name: &str, steps: usize) {
        self.steps.fetch_add(steps, Ordering::Relaxed);
    }
    fn expect(&self, _steps: usize) {}
    fn advance(&self) {
        self.steps.fetch_sub(1, Ordering::Relaxed);
    }
    fn end(&self) {}
    fn interrupted(&self) -> bool {
        self.looks.fetch_add(1, Ordering::Relaxed) >= self.at
    }
}
