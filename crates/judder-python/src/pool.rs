//! The threads of long calls.

use rayon::ThreadPool;
use std::process;
use std::sync::{Arc, Mutex, PoisonError};

/// The stack of each thread: as much as a main thread has.
pub(crate) const STACK: usize = 8 << 20;

/// The pool of this process that has a thread a core.
///
/// Not the global one of rayon: its threads do not follow a process that forks, as the workers of `multiprocessing` do.
pub(crate) fn shared() -> Result<Arc<ThreadPool>, String> {
    static POOL: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);
    let mut known = POOL.lock().unwrap_or_else(PoisonError::into_inner);
    let own = process::id();
    if let Some((process, pool)) = &*known
        && *process == own
    {
        return Ok(Arc::clone(pool));
    }
    let pool = Arc::new(of(0)?);
    if let Some((_, parents)) = known.replace((own, Arc::clone(&pool))) {
        // its threads are those of the parent: to drop it would wait for them
        std::mem::forget(parents);
    }
    Ok(pool)
}

/// A pool of this many threads, 0 for one a core.
pub(crate) fn of(threads: usize) -> Result<ThreadPool, String> {
    rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .stack_size(STACK)
        .build()
        .map_err(|source| format!("cannot start the threads: {source}"))
}
