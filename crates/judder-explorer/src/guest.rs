//! Who is at a connection: let in or not yet, and who goes where there is no room for another.

use std::collections::VecDeque;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError, Weak};
use tokio::sync::Notify;

/// Who is at a connection.
#[derive(Debug, Default)]
pub(crate) struct Guest {
    is_known: AtomicBool,
    has_to_go: Notify,
}

impl Guest {
    /// A request of this connection has been let in: it is not sent away any more.
    pub(crate) fn is_let_in(&self) {
        self.is_known.store(true, Ordering::Relaxed);
    }

    /// Waits until it is sent away.
    pub(crate) async fn sent_away(&self) {
        self.has_to_go.notified().await;
    }
}

/// Those whose requests have not been let in, the one that has been here longest first.
#[derive(Debug, Default)]
pub(crate) struct Strangers(Mutex<VecDeque<Weak<Guest>>>);

impl Strangers {
    /// Somebody has come.
    pub(crate) fn welcome(&self) -> Arc<Guest> {
        let guest = Arc::new(Guest::default());
        let mut strangers = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        strangers.retain(|one| one.upgrade().is_some_and(|one| !one.is_known.load(Ordering::Relaxed)));
        strangers.push_back(Arc::downgrade(&guest));
        guest
    }

    /// Sends the one away that has been here longest, where there is any.
    pub(crate) fn send_one_away(&self) {
        let mut strangers = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        while let Some(longest) = strangers.pop_front() {
            let Some(guest) = longest.upgrade() else { continue };
            if !guest.is_known.load(Ordering::Relaxed) {
                guest.has_to_go.notify_one();
                return;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Duration;
    use tokio::time::timeout;

    #[tokio::test]
    async fn the_stranger_that_came_first_goes_first() {
        let strangers = Strangers::default();
        let (gone, known, waits) = (strangers.welcome(), strangers.welcome(), strangers.welcome());
        let has_gone =
            async |guest: &Guest| timeout(Duration::from_millis(1), guest.sent_away()).await.is_ok();
        known.is_let_in();
        drop(gone);
        strangers.send_one_away();
        assert_eq!((has_gone(&known).await, has_gone(&waits).await), (false, true));
        strangers.send_one_away();
        assert!(!has_gone(&known).await, "nobody is left to go");
    }
}
