//! Waiting for what another process holds: told, interruptible, and only as long as that process shows a sign of life.

use crate::error::StudyError;
use crate::progress::Progress;
use judder_store::{LockSign, StoreError, lock_sign};
use std::path::Path;
use std::thread;
use std::time::{Duration, Instant};

/// How long to wait before asking again.
const PAUSE: Duration = Duration::from_millis(50);
/// Without a sign of life for so long the other is taken to have stopped: who holds something gives one every five seconds, and network file systems pass
/// it on within a minute.
const PATIENCE: Duration = Duration::from_secs(120);
/// How long nothing is told: most who hold something let go at once.
const TOLD_AFTER: Duration = Duration::from_millis(500);

/// A wait for what another holds.
pub(super) struct Waiting<'a> {
    progress: &'a dyn Progress,
    patience: Duration,
    began: Option<Instant>,
    /// The last sign of life, and when it was seen.
    seen: Option<(LockSign, Instant)>,
    is_told: bool,
}

impl<'a> Waiting<'a> {
    pub(super) fn new(progress: &'a dyn Progress) -> Self {
        Self { progress, patience: PATIENCE, began: None, seen: None, is_told: false }
    }

    /// Waits a moment for what has this sign.
    ///
    /// # Errors
    /// [`StudyError::NoSignOfLife`], [`StudyError::Interrupted`].
    pub(super) fn pause(&mut self, sign: LockSign) -> Result<(), StudyError> {
        self.progress.go_on()?;
        let now = Instant::now();
        let began = *self.began.get_or_insert(now);
        if !self.is_told && now - began >= TOLD_AFTER {
            self.is_told = true;
            let limit = self.patience.as_secs();
            let what = format!("waiting for {sign}; without a sign of life of it this ends after {limit} s");
            self.progress.announce(Some(&what));
        }
        match &self.seen {
            Some((last, since)) if *last == sign => {
                if now - *since >= self.patience {
                    let seconds = self.patience.as_secs();
                    return Err(StudyError::NoSignOfLife { held: sign.to_string(), seconds });
                }
            }
            _ => self.seen = Some((sign, now)),
        }
        thread::sleep(PAUSE);
        Ok(())
    }
}

impl Drop for Waiting<'_> {
    fn drop(&mut self) {
        if self.is_told {
            self.progress.announce(None);
        }
    }
}

/// The study in a folder as soon as nobody keeps it. Asked for again and again: a wait in the file system would not hear that it is to end.
///
/// # Errors
/// Failures of the file system, [`StudyError::NoSignOfLife`], [`StudyError::Interrupted`].
pub(crate) fn when_free<T>(
    folder: &Path,
    progress: &dyn Progress,
    take: impl Fn() -> Result<T, StoreError>,
) -> Result<T, StudyError> {
    let mut waiting = Waiting::new(progress);
    loop {
        match take() {
            Err(StoreError::Locked { .. }) => waiting.pause(lock_sign(folder))?,
            taken => return Ok(taken?),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Mutex;

    #[derive(Default)]
    struct Heard(Mutex<Vec<String>>);

    impl Progress for Heard {
        fn begin(&self, _name: &str, _steps: usize) {}
        fn expect(&self, _steps: usize) {}
        fn advance(&self) {}
        fn end(&self) {}
        fn interrupted(&self) -> bool {
            false
        }
        fn announce(&self, what: Option<&str>) {
            self.0.lock().unwrap().push(what.unwrap_or("over").to_owned());
        }
    }

    #[test]
    fn who_shows_no_sign_of_life_is_not_waited_for() {
        let (heard, folder) = (Heard::default(), Path::new("nobody-has-it"));
        let mut waiting = Waiting::new(&heard);
        waiting.patience = Duration::from_millis(700);
        let began = Instant::now();
        let error = loop {
            if let Err(error) = waiting.pause(lock_sign(folder)) {
                break error;
            }
        };
        drop(waiting);
        assert!(began.elapsed() < Duration::from_secs(2));
        assert!(matches!(error, StudyError::NoSignOfLife { .. }), "{error}");
        assert!(!error.is_wrong_input());
        let heard = heard.0.into_inner().unwrap();
        assert!(heard[0].starts_with("waiting for ") && heard[0].contains(".judder.lock"), "{heard:?}");
        assert_eq!(heard[1..], ["over"]);
    }
}
