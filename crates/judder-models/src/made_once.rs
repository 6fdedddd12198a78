//! What takes long to make: made once by many threads, and remembered within a bound of bytes.

use crate::error::ModelError;
use judder_memory::MemoryBudget;
use judder_study::Progress;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::panic::resume_unwind;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

/// Between two looks whether another thread is done.
const PAUSE: Duration = Duration::from_millis(5);

/// What was made, by keys, from what was asked for longest ago to what was asked for last.
pub(crate) struct MadeOnce<T> {
    most_bytes: usize,
    state: Mutex<MadeSoFar<T>>,
}

struct MadeSoFar<T> {
    known: Vec<KnownMaking<T>>,
    /// The keys of what is being made.
    under_way: Vec<String>,
}

struct KnownMaking<T> {
    key: String,
    bytes: usize,
    made: T,
}

impl<T: Clone + Send> MadeOnce<T> {
    /// Nothing yet; of what is made so many bytes are remembered, and the last whatever its size.
    pub(crate) const fn new(most_bytes: usize) -> Self {
        Self { most_bytes, state: Mutex::new(MadeSoFar { known: Vec::new(), under_way: Vec::new() }) }
    }

    /// What has this key: remembered, or made now with its size in bytes. Who asks while another thread makes it waits.
    ///
    /// It is made by threads that make nothing else: one that waits for parts of its own work takes up other work, and if that waits for what it makes
    /// itself, or for what waits for it, none of them goes on.
    ///
    /// # Errors
    /// Those of `make`, [`ModelError::Interrupted`], threads that cannot be started.
    pub(crate) fn get(
        &self,
        key: &str,
        progress: &dyn Progress,
        make: impl FnOnce() -> Result<(T, usize), ModelError> + Send,
    ) -> Result<T, ModelError> {
        loop {
            let mut state = self.state();
            if let Some(made) = state.find(key) {
                return Ok(made);
            }
            if !state.under_way.iter().any(|own| own == key) {
                state.under_way.push(key.to_owned());
                break;
            }
            drop(state);
            progress.go_on()?;
            thread::sleep(PAUSE);
        }
        let under_way = UnderWay { of: self, key };
        let (made, bytes) = apart(make)??;
        self.state().keep(KnownMaking { key: key.to_owned(), bytes, made: made.clone() }, self.most_bytes);
        drop(under_way);
        Ok(made)
    }
}

impl<T> MadeOnce<T> {
    fn state(&self) -> MutexGuard<'_, MadeSoFar<T>> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl<T: Clone> MadeSoFar<T> {
    fn find(&mut self, key: &str) -> Option<T> {
        let place = self.known.iter().position(|own| own.key == key)?;
        self.known[place..].rotate_left(1);
        self.known.last().map(|own| own.made.clone())
    }

    fn keep(&mut self, making: KnownMaking<T>, most_bytes: usize) {
        self.known.retain(|own| own.key != making.key);
        self.known.push(making);
        let mut bytes: usize = self.known.iter().map(|own| own.bytes).sum();
        while bytes > most_bytes && self.known.len() > 1 {
            bytes -= self.known.remove(0).bytes;
        }
    }
}

/// A making that ends, however it ends.
struct UnderWay<'a, T> {
    of: &'a MadeOnce<T>,
    key: &'a str,
}

impl<T> Drop for UnderWay<'_, T> {
    fn drop(&mut self) {
        let mut state = self.of.state();
        if let Some(place) = state.under_way.iter().position(|own| own == self.key) {
            state.under_way.swap_remove(place);
        }
    }
}

/// Does work on threads of its own, as many as the caller has, within the caller's part of the memory, which this one waits for without doing anything
/// else.
fn apart<R: Send>(work: impl FnOnce() -> R + Send) -> Result<R, ModelError> {
    let refused = |reason: String| ModelError::Unsupported(format!("threads cannot be started: {reason}"));
    let pool = pool(rayon::current_num_threads()).map_err(refused)?;
    let parts = MemoryBudget::parts();
    thread::scope(|scope| {
        let shared = || pool.install(|| MemoryBudget::shared(parts, work));
        let within = thread::Builder::new().spawn_scoped(scope, shared);
        let within = within.map_err(|error| refused(error.to_string()))?;
        Ok(within.join().unwrap_or_else(|panic| resume_unwind(panic)))
    })
}

/// The threads that work apart, so many of them; those that there were before stay as long as there are as many.
fn pool(threads: usize) -> Result<Arc<ThreadPool>, String> {
    static KNOWN: Mutex<Option<Arc<ThreadPool>>> = Mutex::new(None);
    let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
    match &*known {
        Some(pool) if pool.current_num_threads() == threads => Ok(Arc::clone(pool)),
        _ => {
            let pool = ThreadPoolBuilder::new().num_threads(threads).build();
            let pool = Arc::new(pool.map_err(|error| error.to_string())?);
            *known = Some(Arc::clone(&pool));
            Ok(pool)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use judder_study::Silent;
    use rayon::prelude::*;
    use std::sync::atomic::{AtomicUsize, Ordering};
    use std::sync::mpsc;

    #[test]
    fn what_was_asked_for_longest_ago_is_forgotten_beyond_the_bound() {
        let memory = MadeOnce::new(100);
        let makings = AtomicUsize::new(0);
        let get = |key: &str, bytes: usize| {
            let make = || {
                makings.fetch_add(1, Ordering::Relaxed);
                Ok((bytes, bytes))
            };
            memory.get(key, &Silent, make).unwrap()
        };
        for (key, bytes) in [("a", 40), ("b", 40), ("a", 40), ("c", 40), ("a", 40)] {
            assert_eq!(get(key, bytes), bytes);
        }
        assert_eq!(makings.load(Ordering::Relaxed), 3, "b went, as a was asked for after it");
        get("b", 40);
        get("larger than all", 1000);
        get("larger than all", 1000);
        assert_eq!(makings.load(Ordering::Relaxed), 5);
        assert_eq!(memory.state().known.len(), 1);
    }

    #[test]
    fn who_makes_has_the_memory_of_who_asks() {
        let memory = MadeOnce::new(100);
        let parts = || memory.get("parts", &Silent, || Ok((MemoryBudget::parts(), 1))).unwrap();
        assert_eq!(MemoryBudget::shared(6, parts), 6);
    }

    #[test]
    fn a_failure_is_not_remembered_and_blocks_nobody() {
        let memory = MadeOnce::new(100);
        let failed = memory.get("a", &Silent, || Err(ModelError::Interrupted));
        assert!(matches!(failed, Err(ModelError::Interrupted)));
        assert_eq!(memory.get("a", &Silent, || Ok((7, 1))).unwrap(), 7);
    }

    /// Makings whose parts are done by all threads, in a loop over all threads, as the points of a law in a sweep of substrates.
    #[test]
    fn makings_in_parallel_do_not_wait_for_each_other_for_ever() {
        let (sender, ended) = mpsc::channel();
        thread::spawn(move || {
            let pool = ThreadPoolBuilder::new().num_threads(8).build().unwrap();
            let memory = MadeOnce::new(16);
            let part = |part: usize| {
                thread::sleep(Duration::from_micros(100 + 50 * (part as u64 % 7)));
                part
            };
            let make =
                |key: usize| Ok(((0..16usize).into_par_iter().map(|own| part(key + own)).sum::<usize>(), 8));
            let point = |key: usize| memory.get(&(key % 8).to_string(), &Silent, || make(key % 8)).unwrap();
            let found: Vec<usize> =
                pool.install(|| (0..400usize).into_par_iter().with_max_len(1).map(point).collect());
            sender.send(found).unwrap();
        });
        let found = ended.recv_timeout(Duration::from_secs(60)).expect("threads wait for each other");
        for (key, sum) in (0..).zip(found) {
            assert_eq!(sum, 16 * (key % 8) + 120);
        }
    }
}
