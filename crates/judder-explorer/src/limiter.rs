//! Short computations, a few at a time, and whether their readers are still there: answers in one piece, while the scheduler gives streams.

use crate::limits::with_memory_of_answer;
use crate::refusal::{ENDING, InTerminal, RequestRefusal};
use axum::http::StatusCode;
use judder_study::Progress;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};
use tokio::sync::{OwnedSemaphorePermit, Semaphore};

/// The longest that it may take: a law that is computed takes so long, a point does not.
const LONGEST: Duration = Duration::from_secs(300);

/// Short computations that wait, at most.
const WAITING: usize = 64;

/// Whether somebody waits for the answer, and has not waited too long.
#[derive(Debug)]
pub(crate) struct RequestWatch {
    left: Arc<AtomicBool>,
    closing: Arc<AtomicBool>,
    start: Instant,
}

impl RequestWatch {
    /// The error of a computation: of an interrupted one, the reason.
    pub(crate) fn refusal(&self, error: impl Into<RequestRefusal>) -> RequestRefusal {
        if !self.interrupted() {
            return error.into();
        }
        if self.closing.load(Ordering::Relaxed) {
            return RequestRefusal::interrupted(ENDING.to_owned());
        }
        RequestRefusal::took_too_long(LONGEST.as_secs(), InTerminal::Point)
    }
}

impl Progress for RequestWatch {
    fn begin(&self, _name: &str, _steps: usize) {}
    fn expect(&self, _steps: usize) {}
    fn advance(&self) {}
    fn end(&self) {}

    fn interrupted(&self) -> bool {
        self.left.load(Ordering::Relaxed)
            || self.closing.load(Ordering::Relaxed)
            || self.start.elapsed() > LONGEST
    }
}

/// Tells that the reader has gone, wherever the waiting for the answer ends.
struct Leaving(Arc<AtomicBool>);

impl Drop for Leaving {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Relaxed);
    }
}

/// How many short computations are done at a time, with a waiting room.
#[derive(Debug)]
pub(crate) struct Limiter {
    running: Arc<Semaphore>,
    /// Those that run and those that wait.
    admitted: Arc<Semaphore>,
}

impl Limiter {
    /// So many at a time.
    pub(crate) fn new(most: usize) -> Self {
        Self { running: Arc::new(Semaphore::new(most)), admitted: Arc::new(Semaphore::new(most + WAITING)) }
    }

    async fn take(&self) -> Result<(OwnedSemaphorePermit, Option<OwnedSemaphorePermit>), RequestRefusal> {
        let place =
            Arc::clone(&self.admitted).try_acquire_owned().map_err(|_| RequestRefusal::busy(WAITING))?;
        // never closed: the permit comes
        Ok((place, Arc::clone(&self.running).acquire_owned().await.ok()))
    }

    /// Computes an answer beside the network's threads, as soon as there is room.
    pub(crate) async fn run<T: Send + 'static>(
        &self,
        closing: Arc<AtomicBool>,
        work: impl FnOnce(&RequestWatch) -> Result<T, RequestRefusal> + Send + 'static,
    ) -> Result<T, RequestRefusal> {
        let leaving = Leaving(Arc::default());
        let left = Arc::clone(&leaving.0);
        let room = self.take().await?;
        let working = tokio::task::spawn_blocking(move || {
            let _held = room;
            with_memory_of_answer(|| work(&RequestWatch { left, closing, start: Instant::now() }))
        });
        let broken = "the computation broke off; this is a fault of judder, please report it with the address of the page";
        working.await.map_err(|_| RequestRefusal::new(StatusCode::INTERNAL_SERVER_ERROR, broken))?
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn reason(closing: bool, start: Instant) -> String {
        let watch = RequestWatch { left: Arc::default(), closing: Arc::new(AtomicBool::new(closing)), start };
        watch.refusal(judder_study::StudyError::Interrupted).document()["message"].to_string()
    }

    #[test]
    fn who_is_interrupted_is_told_why() {
        let now = Instant::now();
        assert!(reason(true, now).contains("is ending"));
        assert!(
            now.checked_sub(2 * LONGEST).is_none_or(|long_ago| reason(false, long_ago).contains("300 s"))
        );
    }
}
