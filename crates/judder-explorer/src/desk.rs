//! How many requests work at once, how many wait, and which a newer one cancels.
//!
//! Work that takes time is done at a few seats, so that a hundred requests leave the page alive; who finds even the waiting room full is
//! told so. A request may name a slot, such as the map of one tab: there is one at a time in a slot, the newest.

use crate::frame::Frame;
use crate::refusal::Refusal;
use crate::reporter::Reporter;
use axum::body::{Body, Bytes};
use axum::http::header::{CACHE_CONTROL, CONTENT_TYPE};
use axum::response::Response;
use std::collections::HashMap;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use tokio::sync::{OwnedSemaphorePermit, Semaphore, mpsc, watch};
use tokio_stream::wrappers::ReceiverStream;

/// Requests that work at once: a long one does not keep the page from drawing its map.
const SEATS: usize = 4;
/// Requests that wait for a seat, at most.
const WAITING: usize = 12;
/// Answers in one piece that are computed at once: points under a cursor.
const STOOLS: usize = 8;
/// Frames between the worker and the network: who reads slowly slows the work, not the memory.
const FRAMES: usize = 4;
/// What a stream of frames is called.
const STREAM: &str = "application/x-judder-frames";

/// What a request computes: it tells its frames to the reporter.
pub(crate) type Work = Box<dyn FnOnce(&Reporter) -> Result<(), Refusal> + Send>;

/// The seats, the waiting room, the slots.
#[derive(Debug)]
pub(crate) struct Desk {
    seats: Arc<Semaphore>,
    /// Seats and waiting room together.
    places: Arc<Semaphore>,
    stools: Arc<Semaphore>,
    slots: Mutex<HashMap<String, (u64, watch::Sender<bool>)>>,
    next: AtomicU64,
    closing: Arc<AtomicBool>,
}

impl Desk {
    pub(crate) fn new() -> Self {
        Self {
            seats: Arc::new(Semaphore::new(SEATS)),
            places: Arc::new(Semaphore::new(SEATS + WAITING)),
            stools: Arc::new(Semaphore::new(STOOLS)),
            slots: Mutex::default(),
            next: AtomicU64::new(0),
            closing: Arc::default(),
        }
    }

    /// Whether the server ends.
    pub(crate) fn closing(&self) -> Arc<AtomicBool> {
        Arc::clone(&self.closing)
    }

    /// A place for a short computation, when one is free.
    pub(crate) async fn stool(&self) -> Option<OwnedSemaphorePermit> {
        Arc::clone(&self.stools).acquire_owned().await.ok()
    }

    /// Ends all work.
    pub(crate) fn close(&self) {
        self.closing.store(true, Ordering::Relaxed);
    }

    /// A stream of what `work` will tell; what worked in this slot before is cancelled at once.
    ///
    /// # Errors
    /// [`Refusal::busy`] where the waiting room is full.
    pub(crate) fn stream(self: &Arc<Self>, slot: Option<String>, work: Work) -> Result<Response, Refusal> {
        let (superseded, ticket) = self.enter(slot);
        let place = Arc::clone(&self.places).try_acquire_owned().map_err(|_| Refusal::busy(WAITING))?;
        let (sender, receiver) = mpsc::channel::<Result<Bytes, std::convert::Infallible>>(FRAMES);
        let reporter = Reporter::new(sender, superseded, Arc::clone(&self.closing));
        let desk = Arc::clone(self);
        tokio::spawn(async move {
            desk.work(reporter, work, place).await;
            desk.leave(ticket);
        });
        let headers = [(CONTENT_TYPE, STREAM), (CACHE_CONTROL, "no-store")];
        let mut response = Response::new(Body::from_stream(ReceiverStream::new(receiver)));
        for (name, value) in headers {
            response.headers_mut().insert(name, axum::http::HeaderValue::from_static(value));
        }
        Ok(response)
    }

    /// Waits for a seat and works; a request that is cancelled while it waits never sits down.
    async fn work(&self, mut reporter: Reporter, work: Work, place: OwnedSemaphorePermit) {
        let seat = tokio::select! {
            seat = Arc::clone(&self.seats).acquire_owned() => seat,
            () = reporter.given_up() => return,
        };
        let worked = tokio::task::spawn_blocking(move || {
            let _held = (seat, place);
            let ending = match work(&reporter) {
                Ok(()) => reporter.last_frame(),
                Err(refusal) => Frame::new("error").with("error", refusal.document()),
            };
            reporter.tell(ending);
        });
        // a panic of the work ends the stream without its last frame, which the page tells as an answer cut off
        let _ = worked.await;
    }

    /// Takes a slot from whoever has it.
    fn enter(&self, slot: Option<String>) -> (watch::Receiver<bool>, Option<(String, u64)>) {
        let (sender, receiver) = watch::channel(false);
        let Some(slot) = slot else {
            // nobody cancels it: the sender may go, the value stays
            return (receiver, None);
        };
        let number = self.next.fetch_add(1, Ordering::Relaxed);
        let before = self.slots().insert(slot.clone(), (number, sender));
        if let Some((_, before)) = before {
            before.send_replace(true);
        }
        (receiver, Some((slot, number)))
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
