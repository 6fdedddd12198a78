//! A request at work: its frames, its progress, its end.

use crate::frame::FrameInTheMaking;
use crate::refusal::{ENDING, InTerminal, RequestRefusal};
use axum::body::Bytes;
use judder_study::Progress;
use std::convert::Infallible;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};
use tokio::sync::mpsc::error::TrySendError;
use tokio::sync::{mpsc, watch};

/// The longest that a request may work.
const LONGEST: Duration = Duration::from_secs(600);
/// How often it is looked whether the one that reads has room again.
const ROOM: Duration = Duration::from_millis(2);
/// How often progress is sent.
const PROGRESS_EVERY: Duration = Duration::from_millis(100);

/// Why a request has no use any more.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum EndedRequest {
    /// A newer one came to its slot.
    Superseded,
    /// Nobody listens any more.
    Deserted,
    /// It took too long.
    TooLong,
    /// The server ends.
    Closing,
}

impl EndedRequest {
    fn refusal(self) -> RequestRefusal {
        let because = |reason: &str| RequestRefusal::interrupted(reason.to_owned());
        match self {
            Self::Superseded => because("a newer request has taken its place"),
            Self::TooLong => RequestRefusal::took_too_long(LONGEST.as_secs(), InTerminal::Run),
            Self::Closing => because(ENDING),
            Self::Deserted => because("nobody waits for it any more"),
        }
    }
}

/// Sends the frames of a request, and knows whether anybody still wants them.
#[derive(Debug)]
pub(crate) struct Reporter {
    sender: mpsc::Sender<Result<Bytes, Infallible>>,
    superseded: watch::Receiver<bool>,
    closing: Arc<AtomicBool>,
    start: Instant,
    done: AtomicUsize,
    expected: AtomicUsize,
    /// When progress was sent last.
    last_progress: Mutex<Option<Instant>>,
}

impl Reporter {
    pub(crate) fn new(
        sender: mpsc::Sender<Result<Bytes, Infallible>>,
        superseded: watch::Receiver<bool>,
        closing: Arc<AtomicBool>,
    ) -> Self {
        let (done, expected) = (AtomicUsize::new(0), AtomicUsize::new(0));
        Self {
            sender,
            superseded,
            closing,
            start: Instant::now(),
            done,
            expected,
            last_progress: Mutex::new(None),
        }
    }

    /// Waits until nobody wants the answer.
    pub(crate) async fn given_up(&mut self) {
        let superseded = &mut self.superseded;
        let newer = async {
            if superseded.wait_for(|superseded| *superseded).await.is_err() {
                // no slot, nobody to supersede it
                std::future::pending::<()>().await;
            }
        };
        tokio::select! {
            () = self.sender.closed() => {}
            () = newer => {}
        }
    }

    /// Sends a frame, as soon as the one that reads has room for it; what nobody wants any more is dropped.
    pub(crate) fn send(&self, frame: FrameInTheMaking) {
        let mut message = Ok(Bytes::from(frame.bytes()));
        while let Err(TrySendError::Full(unsent)) = self.sender.try_send(message) {
            if self.ended().is_some() {
                return;
            }
            message = unsent;
            std::thread::sleep(ROOM);
        }
    }

    /// Seconds since the request came.
    pub(crate) fn seconds(&self) -> f64 {
        self.start.elapsed().as_secs_f64()
    }

    /// Why the answer has no use any more; `None` while it has.
    pub(crate) fn ended(&self) -> Option<EndedRequest> {
        match () {
            () if *self.superseded.borrow() => Some(EndedRequest::Superseded),
            () if self.sender.is_closed() => Some(EndedRequest::Deserted),
            () if self.closing.load(Ordering::Relaxed) => Some(EndedRequest::Closing),
            () if self.start.elapsed() > LONGEST => Some(EndedRequest::TooLong),
            () => None,
        }
    }

    /// What ends a stream that is whole.
    pub(crate) fn last_frame(&self) -> FrameInTheMaking {
        FrameInTheMaking::new("end").with("seconds", self.seconds())
    }

    /// The error of a computation; of one that was given up, the reason: a solver may have its own words for it.
    pub(crate) fn refusal(&self, error: impl Into<RequestRefusal>) -> RequestRefusal {
        match self.ended() {
            Some(ended) => ended.refusal(),
            None => error.into(),
        }
    }

    /// Whether progress shall be sent now.
    fn is_time(&self) -> bool {
        let mut last = self.last_progress.lock().unwrap_or_else(PoisonError::into_inner);
        let now = Instant::now();
        let due = last.is_none_or(|before| now.duration_since(before) >= PROGRESS_EVERY);
        if due {
            *last = Some(now);
        }
        due
    }
}

impl Progress for Reporter {
    fn begin(&self, _name: &str, steps: usize) {
        self.expected.store(steps, Ordering::Relaxed);
    }

    fn expect(&self, steps: usize) {
        self.expected.fetch_add(steps, Ordering::Relaxed);
    }

    fn advance(&self) {
        let done = self.done.fetch_add(1, Ordering::Relaxed) + 1;
        if self.is_time() {
            let frame = FrameInTheMaking::new("progress")
                .with("done", done)
                .with("of", self.expected.load(Ordering::Relaxed));
            // what does not fit now is sent later: no work waits for it
            let _ = self.sender.try_send(Ok(Bytes::from(frame.bytes())));
        }
    }

    fn end(&self) {}

    fn interrupted(&self) -> bool {
        self.ended().is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn reporter() -> (Reporter, mpsc::Receiver<Result<Bytes, Infallible>>, watch::Sender<bool>) {
        let ((sender, receiver), (newer, superseded)) = (mpsc::channel(4), watch::channel(false));
        (Reporter::new(sender, superseded, Arc::default()), receiver, newer)
    }

    #[test]
    fn work_ends_when_it_has_taken_too_long() {
        let (mut reporter, _receiver, _newer) = reporter();
        assert_eq!((reporter.ended(), reporter.interrupted()), (None, false));
        reporter.start = Instant::now().checked_sub(LONGEST + Duration::from_secs(1)).unwrap();
        assert_eq!((reporter.ended(), reporter.interrupted()), (Some(EndedRequest::TooLong), true));
        let words = reporter.refusal(judder_study::StudyError::Interrupted).document();
        assert!(words["help"].as_str().unwrap().contains("type `judder run CASE.toml`"), "{words}");
    }

    #[test]
    fn work_ends_when_nobody_wants_it() {
        let (deserted, receiver, _newer) = reporter();
        drop(receiver);
        assert_eq!(deserted.ended(), Some(EndedRequest::Deserted));
        let (superseded, _receiver, newer) = reporter();
        newer.send_replace(true);
        assert_eq!(superseded.ended(), Some(EndedRequest::Superseded));
        let (closing, _receiver, _newer) = reporter();
        closing.closing.store(true, Ordering::Relaxed);
        assert_eq!(closing.ended(), Some(EndedRequest::Closing));
    }

    #[test]
    fn progress_that_nobody_reads_holds_up_nothing() {
        let (reporter, mut receiver, _newer) = reporter();
        reporter.begin("", 10_000);
        (0..10_000).for_each(|_| reporter.advance());
        assert!(receiver.try_recv().is_ok(), "some of it was sent");
        assert_eq!(reporter.done.load(Ordering::Relaxed), 10_000);
    }
}
