//! Long calls: the work goes on beside, without the interpreter's lock; the thread that called watches for Ctrl-C and tells how far it is.

use crate::errors;
use crate::pool;
use judder_study::Progress;
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;
use rayon::ThreadPool;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

/// How often the calling thread looks up.
const LOOK: Duration = Duration::from_millis(50);

/// How far a stretch of work is.
#[derive(Debug, Clone, Default, PartialEq)]
struct Stretch {
    name: String,
    done: usize,
    total: usize,
}

/// What the work tells and what it is told.
#[derive(Debug, Default)]
pub(crate) struct WorkWatch {
    stop: AtomicBool,
    stretches: Mutex<Vec<Stretch>>,
    finished: Mutex<bool>,
    bell: Condvar,
}

impl WorkWatch {
    fn stretches(&self) -> MutexGuard<'_, Vec<Stretch>> {
        self.stretches.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn now(&self, change: impl FnOnce(&mut Stretch)) {
        if let Some(stretch) = self.stretches().last_mut() {
            change(stretch);
        }
    }

    fn finish(&self) {
        *self.finished.lock().unwrap_or_else(PoisonError::into_inner) = true;
        self.bell.notify_all();
    }

    /// Whether the work ends within a look.
    fn ends(&self) -> bool {
        let finished = self.finished.lock().unwrap_or_else(PoisonError::into_inner);
        let waited = self.bell.wait_timeout_while(finished, LOOK, |finished| !*finished);
        *waited.unwrap_or_else(PoisonError::into_inner).0
    }

    /// Takes the stretches that have ended, and looks at the one that goes on.
    fn told(&self) -> Vec<Stretch> {
        let mut stretches = self.stretches();
        let told = stretches.clone();
        stretches.drain(..told.len().saturating_sub(1));
        told
    }
}

impl Progress for WorkWatch {
    fn begin(&self, name: &str, steps: usize) {
        self.stretches().push(Stretch { name: name.to_owned(), done: 0, total: steps });
    }

    fn expect(&self, steps: usize) {
        self.now(|stretch| stretch.total += steps);
    }

    fn advance(&self) {
        self.now(|stretch| stretch.done += 1);
    }

    fn end(&self) {
        self.now(|stretch| stretch.total = stretch.done);
    }

    fn interrupted(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }
}

/// More than any machine has; a larger number is a slip.
const MOST_THREADS: usize = 4096;

/// How a long call is done.
#[derive(Debug, Default)]
pub(crate) struct Manner {
    /// `progress(name, done, total)`.
    pub(crate) progress: Option<Py<PyAny>>,
    /// How many threads; one a core where none is said.
    pub(crate) threads: Option<usize>,
    /// The threads, where they are there already.
    pub(crate) pool: Option<Arc<ThreadPool>>,
    /// `stop()`: whether the work is to end.
    pub(crate) stop: Option<Py<PyAny>>,
}

impl Manner {
    /// With this callback and so many threads.
    pub(crate) fn new(progress: Option<Py<PyAny>>, threads: Option<usize>) -> PyResult<Self> {
        match threads {
            Some(threads) if !(1..=MOST_THREADS).contains(&threads) => {
                Err(errors::input("threads", format!("{threads} must be from 1 to {MOST_THREADS}")))
            }
            _ => Ok(Self { progress, threads, ..Self::default() }),
        }
    }
}

impl Manner {
    /// The same for work that may wait for another that holds a study or a chunk: a thread that both had could take up the one amid the other, and
    /// wait for ever for what lies beneath it.
    pub(crate) fn on_threads_of_its_own(
        progress: Option<Py<PyAny>>,
        threads: Option<usize>,
    ) -> PyResult<Self> {
        let manner = Self::new(progress, threads)?;
        let pool = pool::of(threads.unwrap_or(0)).map_err(errors::system)?;
        Ok(Self { pool: Some(Arc::new(pool)), ..manner })
    }
}

/// What came of watched work.
pub(crate) struct Watched<T> {
    /// What it returned.
    pub(crate) result: T,
    /// What stopped it: Ctrl-C, or an error of the progress callback.
    pub(crate) stopped: Option<PyErr>,
}

impl<T, E> Watched<Result<T, E>> {
    /// The result: what stopped the work where anything did, else its own error.
    pub(crate) fn settled(self, error: impl FnOnce(E) -> PyErr) -> PyResult<T> {
        match self.stopped {
            Some(stop) => Err(stop),
            None => self.result.map_err(error),
        }
    }
}

/// Does `work` on other threads. The calling thread alone touches the interpreter, so that neither can wait for the other.
///
/// # Errors
/// Threads that the system does not give; a fault of judder itself.
pub(crate) fn watched<T: Send>(
    py: Python<'_>,
    manner: &Manner,
    work: impl FnOnce(&WorkWatch) -> T + Send,
) -> PyResult<Watched<T>> {
    let pool = match (&manner.pool, manner.threads) {
        (Some(pool), _) => Ok(Arc::clone(pool)),
        (None, None) => pool::shared(),
        (None, Some(threads)) => pool::of(threads).map(Arc::new),
    };
    let pool = pool.map_err(errors::system)?;
    let watch = WorkWatch::default();
    thread::scope(|scope| {
        let beside = || {
            let result =
                std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| pool.install(|| work(&watch))));
            watch.finish();
            result
        };
        let worker = thread::Builder::new().spawn_scoped(scope, beside).map_err(errors::system)?;
        let (mut stopped, mut last) = (None, None);
        while !py.detach(|| watch.ends()) {
            if stopped.is_none() {
                stopped = py.check_signals().and_then(|()| tell(py, manner, &watch, &mut last)).err();
                let ends = stopped.is_none()
                    && asked_to_stop(py, manner).unwrap_or_else(|error| {
                        stopped = Some(error);
                        true
                    });
                watch.stop.store(ends || stopped.is_some(), Ordering::Relaxed);
            }
        }
        let result = py.detach(|| worker.join());
        if stopped.is_none() {
            stopped = py.check_signals().and_then(|()| tell(py, manner, &watch, &mut last)).err();
        }
        match result {
            Ok(Ok(result)) => Ok(Watched { result, stopped }),
            _ => Err(errors::fault()),
        }
    })
}

/// Whether this is Ctrl-C.
pub(crate) fn is_ctrl_c(py: Python<'_>, error: &PyErr) -> bool {
    error.is_instance_of::<PyKeyboardInterrupt>(py)
}

/// Whether somebody else wants the work to end.
fn asked_to_stop(py: Python<'_>, manner: &Manner) -> PyResult<bool> {
    match &manner.stop {
        Some(stop) => stop.call0(py)?.is_truthy(py),
        None => Ok(false),
    }
}

/// Tells the callback what has changed.
fn tell(py: Python<'_>, manner: &Manner, watch: &WorkWatch, last: &mut Option<Stretch>) -> PyResult<()> {
    let Some(callback) = &manner.progress else { return Ok(()) };
    for stretch in watch.told() {
        if last.as_ref() != Some(&stretch) {
            callback.call1(py, (&stretch.name, stretch.done, stretch.total))?;
            *last = Some(stretch);
        }
    }
    Ok(())
}
