//! What ends a command from outside: Ctrl-C, SIGTERM, SIGHUP. The first ends it cleanly and keeps what is done, the second at once.

use std::process;
#[cfg(unix)]
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, OnceLock, PoisonError};
use std::thread;
use std::time::Duration;

use judder_store::close_writes;
use judder_study::StudyError;

use crate::console::Console;
use crate::failure::{Exit, Failure, Message};

/// How long a command may take to end by itself. What it stores is whole after any end, so that nothing is lost by an end in the midst of a step; a result
/// or a checkpoint that is being written then is waited for.
const GRACE: Duration = Duration::from_secs(1);

/// The signals of this process, which come to all that it does.
static SIGNALS: Signals =
    Signals { asked: AtomicBool::new(false), ended: AtomicBool::new(false), how: Mutex::new(None) };

struct Signals {
    /// Whether the user has asked for the end.
    asked: AtomicBool,
    /// Whether somebody is about to say how the command ended.
    ended: AtomicBool,
    how: Mutex<Option<(Console, Ending)>>,
}

/// What a signal does to the command that runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Ending {
    /// It keeps nothing: it ends.
    AtOnce,
    /// It is told to end, and ended where it does not hear.
    Kept,
    /// It is told to end, and does.
    Served,
}

/// Whether the user has asked for the end.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Interrupt(());

impl Interrupt {
    /// Signals from now on end what is done at once, with the exit code and the document of an interruption.
    ///
    /// # Errors
    /// The system does not let this process watch.
    pub(crate) fn watch(console: Console) -> Result<(), Failure> {
        static WATCHED: OnceLock<Result<(), String>> = OnceLock::new();
        SIGNALS.asked.store(false, Ordering::Relaxed);
        SIGNALS.ended.store(false, Ordering::Relaxed);
        set(console, Ending::AtOnce);
        let watched = WATCHED.get_or_init(|| begin().map_err(|error| error.to_string()));
        watched
            .clone()
            .map_err(|reason| Failure::missing(Message::error(format!("cannot watch for Ctrl-C: {reason}"))))
    }

    /// From now on a signal is heard by the command, which keeps what is done.
    pub(crate) fn kept(console: Console) -> Self {
        set(console, Ending::Kept);
        Self(())
    }

    /// Of a command that a signal ends at once, as long as nothing else is said.
    pub(crate) fn unkept() -> Self {
        Self(())
    }

    /// From now on a signal is heard by the command, which lasts until then.
    pub(crate) fn served(console: Console) -> Self {
        set(console, Ending::Served);
        Self(())
    }

    /// Whether a signal has come.
    pub(crate) fn asked(self) -> bool {
        SIGNALS.asked.load(Ordering::Relaxed)
    }
}

/// Says that the command has ended by itself. Where a signal ends it just now this does not return.
pub(crate) fn end_by_itself() {
    if SIGNALS.ended.swap(true, Ordering::SeqCst) {
        loop {
            thread::park();
        }
    }
}

fn set(console: Console, ending: Ending) {
    *SIGNALS.how.lock().unwrap_or_else(PoisonError::into_inner) = Some((console, ending));
}

/// Watches for what ends a command on this system.
fn begin() -> Result<(), Box<dyn std::error::Error>> {
    ctrlc::set_handler(|| heard("Ctrl-C once more"))?;
    #[cfg(unix)]
    {
        use signal_hook::consts::{SIGHUP, SIGTERM, SIGXFSZ};
        // a file beyond `ulimit -f` is an error of the write then; what is started from here has the system's own way again
        signal_hook::flag::register(SIGXFSZ, Arc::default())?;
        let hangup = (!is_hangup_ignored()).then_some(SIGHUP);
        let mut signals = signal_hook::iterator::Signals::new([SIGTERM].into_iter().chain(hangup))?;
        thread::Builder::new().name("signals".to_owned()).spawn(move || {
            signals.forever().for_each(|_| heard("a second signal"));
        })?;
    }
    Ok(())
}

/// Whether SIGHUP was ignored when this process began, as below `nohup`. Where the system does not say, it stays as it is: who ignores it goes on doing
/// so, and whom it ends it ends.
#[cfg(unix)]
fn is_hangup_ignored() -> bool {
    let told = std::fs::read_to_string("/proc/self/status").ok();
    told.and_then(|told| ignored_signals(&told))
        .is_none_or(|ignored| ignored & (1 << (signal_hook::consts::SIGHUP - 1)) != 0)
}

/// The signals that a process ignores, a bit each from that of signal 1 on, from what Linux tells of it.
#[cfg(unix)]
fn ignored_signals(status: &str) -> Option<u64> {
    let line = status.lines().find_map(|line| line.strip_prefix("SigIgn:"))?;
    u64::from_str_radix(line.trim(), 16).ok()
}

/// A signal has come; what ends the command at once from now on.
fn heard(again: &str) {
    let how = *SIGNALS.how.lock().unwrap_or_else(PoisonError::into_inner);
    let Some((console, ending)) = how else { process::exit(i32::from(Exit::Incomplete.code())) };
    if SIGNALS.asked.swap(true, Ordering::Relaxed) {
        let text = "ended at once; what was stored stays, and the same command goes on from there";
        end(console, &Failure::missing(Message::from_sentence(&text)));
        return;
    }
    match ending {
        Ending::AtOnce => end(console, &Failure::missing(Message::error("interrupted"))),
        Ending::Served => console.note(format_args!("\nending; {again} ends at once")),
        Ending::Kept => {
            console.note(format_args!("\nending, and keeping what is done; {again} ends at once"));
            // a step of the computation may not ask for longer than a user waits
            thread::spawn(move || {
                thread::sleep(GRACE);
                let _closed = close_writes();
                end(console, &StudyError::Interrupted.into());
            });
        }
    }
}

/// Ends the process, unless it is just ending by itself.
fn end(console: Console, failure: &Failure) {
    if !SIGNALS.ended.swap(true, Ordering::SeqCst) {
        console.failure(failure);
        process::exit(i32::from(failure.exit.code()));
    }
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    #[test]
    fn ignored_signals_are_told_by_the_system() {
        let status = "Name:\tsleep\nSigIgn:\t0000000000000003\nSigCgt:\t00\n";
        assert_eq!(ignored_signals(status), Some(0b11));
        assert_eq!(ignored_signals("Name:\tsleep\n"), None);
    }
}
