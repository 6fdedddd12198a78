//! Writes that are under way, which whoever ends the process waits for.

use std::cell::Cell;
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};

/// The writes of this process.
static WRITES: Mutex<Writes> = Mutex::new(Writes { under_way: 0, is_closed: false });
/// Told whenever that changes.
static CHANGED: Condvar = Condvar::new();

thread_local! {
    /// How many writes of this thread lie in each other.
    static DEPTH: Cell<usize> = const { Cell::new(0) };
}

struct Writes {
    /// Threads that write.
    under_way: usize,
    /// Whether none is to begin any more.
    is_closed: bool,
}

/// A write under way, until dropped: a result, a checkpoint or a chunk that is to be whole.
#[derive(Debug)]
#[must_use]
pub struct WriteUnderWay(());

impl WriteUnderWay {
    /// Begins a write. Where [`close_writes`] was asked for, this waits for the end of the process.
    pub fn begin() -> Self {
        if DEPTH.get() == 0 {
            let mut writes = CHANGED
                .wait_while(writes(), |writes| writes.is_closed)
                .unwrap_or_else(PoisonError::into_inner);
            writes.under_way += 1;
        }
        DEPTH.set(DEPTH.get() + 1);
        Self(())
    }
}

impl Drop for WriteUnderWay {
    fn drop(&mut self) {
        DEPTH.set(DEPTH.get() - 1);
        if DEPTH.get() == 0 {
            writes().under_way -= 1;
            CHANGED.notify_all();
        }
    }
}

/// Writes of this process that none follows, as long as this lives.
#[derive(Debug)]
#[must_use]
pub struct ClosedWrites(());

impl Drop for ClosedWrites {
    fn drop(&mut self) {
        writes().is_closed = false;
        CHANGED.notify_all();
    }
}

/// Lets no write begin any more, and returns once those that are under way have ended: for who is about to end the process.
pub fn close_writes() -> ClosedWrites {
    let mut open = writes();
    open.is_closed = true;
    drop(CHANGED.wait_while(open, |writes| writes.under_way > 0).unwrap_or_else(PoisonError::into_inner));
    ClosedWrites(())
}

fn writes() -> MutexGuard<'static, Writes> {
    WRITES.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::{AtomicUsize, Ordering};
    use std::thread;
    use std::time::Duration;

    #[test]
    fn an_end_waits_for_writes_and_none_follows() {
        let steps = AtomicUsize::new(0);
        thread::scope(|scope| {
            let outer = WriteUnderWay::begin();
            let closer = scope.spawn(|| {
                let closed = close_writes();
                let before = steps.load(Ordering::SeqCst);
                thread::sleep(Duration::from_millis(50));
                assert_eq!((before, steps.load(Ordering::SeqCst)), (2, 2));
                steps.fetch_add(1, Ordering::SeqCst);
                drop(closed);
            });
            while !writes().is_closed {
                thread::yield_now();
            }
            steps.fetch_add(1, Ordering::SeqCst);
            // a part of a write that is under way
            drop(WriteUnderWay::begin());
            scope.spawn(|| {
                let _late = WriteUnderWay::begin();
                assert_eq!(steps.load(Ordering::SeqCst), 3);
            });
            thread::sleep(Duration::from_millis(20));
            steps.fetch_add(1, Ordering::SeqCst);
            drop(outer);
            closer.join().unwrap();
        });
    }
}
