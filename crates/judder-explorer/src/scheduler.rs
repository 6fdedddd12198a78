//! How many requests work at once, how many wait, and which a newer one cancels.
//!
//! A few requests work at once, so that a hundred leave the page alive; one that finds even the waiting room full is refused. What a page
//! waits for, such as its map, has a lane and threads of its own: long analyses do not keep it. A request may name a
//! slot, such as the map of one tab: there is one at a time in a slot, the newest.

use crate::error::ExplorerError;
use crate::frame::FrameInTheMaking;
use crate::limits::{RUNNING, with_memory_of_stream};
use crate::refusal::RequestRefusal;
use crate::reporter::Reporter;
use axum::body::{Body, Bytes};
use axum::http::header::{CACHE_CONTROL, CONTENT_TYPE};
use axum::response::Response;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::collections::HashMap;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;
use tokio::sync::{OwnedSemaphorePermit, Semaphore, mpsc, watch};
use tokio::time::timeout;
use tokio_stream::wrappers::ReceiverStream;

/// Requests of a pace that wait, at most.
const WAITING: usize = 12;
/// How long the place of a request that was just cancelled is waited for.
const HANDOVER: Duration = Duration::from_secs(5);
/// Frames between the worker and the network: who reads slowly slows the work, not the memory.
const FRAMES: usize = 4;
/// What a stream of frames is called.
const STREAM: &str = "application/x-judder-frames";

/// What a request computes: it gives its frames to the reporter.
pub(crate) type Work = Box<dyn FnOnce(&Reporter) -> Result<(), RequestRefusal> + Send>;

/// How long a request may be expected to take.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Pace {
    /// A page waits for it: a map, a law, a part of a study.
    Quick,
    /// Whoever asks for it knows that it takes its time: a motion, any other analysis.
    Slow,
}

/// The requests of a pace that work, and those that wait.
#[derive(Debug)]
struct Lane {
    running: Arc<Semaphore>,
    /// Those that work and those that wait.
    admitted: Arc<Semaphore>,
}

impl Lane {
    fn new() -> Self {
        Self {
            running: Arc::new(Semaphore::new(RUNNING)),
            admitted: Arc::new(Semaphore::new(RUNNING + WAITING)),
        }
    }
}

/// A request in its slot.
struct SlotClaim {
    /// Whether a newer one has come.
    superseded: watch::Receiver<bool>,
    /// What gives the slot back.
    ticket: Option<(String, u64)>,
    /// Whether another one has been cancelled for it.
    has_cancelled: bool,
}

/// The lanes, and the slots.
#[derive(Debug)]
pub(crate) struct Scheduler {
    quick: Lane,
    slow: Lane,
    /// Threads of quick work: the other threads may all be amid something long.
    threads: Arc<ThreadPool>,
    slots: Mutex<HashMap<String, (u64, watch::Sender<bool>)>>,
    next: AtomicU64,
    closing: Arc<AtomicBool>,
}

impl Scheduler {
    pub(crate) fn new() -> Result<Self, ExplorerError> {
        let threads =
            ThreadPoolBuilder::new().build().map_err(std::io::Error::other).map_err(ExplorerError::Start)?;
        Ok(Self {
            quick: Lane::new(),
            slow: Lane::new(),
            threads: Arc::new(threads),
            slots: Mutex::default(),
            next: AtomicU64::new(0),
            closing: Arc::default(),
        })
    }

    /// Whether the server ends.
    pub(crate) fn closing(&self) -> Arc<AtomicBool> {
        Arc::clone(&self.closing)
    }

    /// Ends all work.
    pub(crate) fn close(&self) {
        self.closing.store(true, Ordering::Relaxed);
    }

    /// A stream of the frames that `work` will send; what worked in this slot before is cancelled at once, and leaves its place.
    ///
    /// # Errors
    /// [`RequestRefusal::busy`] where the waiting room is full.
    pub(crate) async fn stream(
        self: &Arc<Self>,
        pace: Pace,
        slot: Option<String>,
        work: Work,
    ) -> Result<Response, RequestRefusal> {
        let SlotClaim { superseded, ticket, has_cancelled } = self.enter(slot);
        let admitted = Arc::clone(&self.lane(pace).admitted);
        let place = match admitted.clone().try_acquire_owned() {
            Err(_) if has_cancelled => {
                timeout(HANDOVER, admitted.acquire_owned()).await.ok().and_then(Result::ok)
            }
            place => place.ok(),
        };
        let Some(place) = place else {
            self.leave(ticket);
            return Err(RequestRefusal::busy(WAITING));
        };
        let (sender, receiver) = mpsc::channel::<Result<Bytes, std::convert::Infallible>>(FRAMES);
        let reporter = Reporter::new(sender, superseded, Arc::clone(&self.closing));
        let scheduler = Arc::clone(self);
        tokio::spawn(async move {
            scheduler.work(pace, reporter, work, place).await;
            scheduler.leave(ticket);
        });
        let mut response = Response::new(Body::from_stream(ReceiverStream::new(receiver)));
        for (name, value) in [(CONTENT_TYPE, STREAM), (CACHE_CONTROL, "no-store")] {
            response.headers_mut().insert(name, axum::http::HeaderValue::from_static(value));
        }
        Ok(response)
    }

    fn lane(&self, pace: Pace) -> &Lane {
        match pace {
            Pace::Quick => &self.quick,
            Pace::Slow => &self.slow,
        }
    }

    /// Waits for its turn and works; a request that is cancelled while it waits never begins.
    async fn work(&self, pace: Pace, mut reporter: Reporter, work: Work, place: OwnedSemaphorePermit) {
        let turn = tokio::select! {
            turn = Arc::clone(&self.lane(pace).running).acquire_owned() => turn,
            () = reporter.given_up() => return,
        };
        let threads = (pace == Pace::Quick).then(|| Arc::clone(&self.threads));
        let worked = tokio::task::spawn_blocking(move || {
            let _held = (turn, place);
            let done = match threads {
                Some(threads) => threads.install(|| with_memory_of_stream(|| work(&reporter))),
                None => with_memory_of_stream(|| work(&reporter)),
            };
            let ending = match done {
                Ok(()) => reporter.last_frame(),
                Err(refusal) => FrameInTheMaking::new("error").with("error", refusal.document()),
            };
            reporter.send(ending);
        });
        // a panic of the work ends the stream without its last frame, which the page takes for an answer cut off
        let _ = worked.await;
    }

    /// Takes a slot from whoever has it.
    fn enter(&self, slot: Option<String>) -> SlotClaim {
        let (sender, superseded) = watch::channel(false);
        let Some(slot) = slot else {
            // nobody cancels it: the sender may go, the value stays
            return SlotClaim { superseded, ticket: None, has_cancelled: false };
        };
        let number = self.next.fetch_add(1, Ordering::Relaxed);
        let before = self.slots().insert(slot.clone(), (number, sender));
        let has_cancelled = before.is_some_and(|(_, before)| !before.send_replace(true));
        SlotClaim { superseded, ticket: Some((slot, number)), has_cancelled }
    }

    /// Gives a slot back, unless a newer request has it.
    fn leave(&self, ticket: Option<(String, u64)>) {
        let Some((slot, number)) = ticket else { return };
        let mut slots = self.slots();
        if slots.get(&slot).is_some_and(|(held, _)| *held == number) {
            slots.remove(&slot);
        }
    }

    fn slots(&self) -> std::sync::MutexGuard<'_, HashMap<String, (u64, watch::Sender<bool>)>> {
        self.slots.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
