//! Ctrl-C: the first ends the command cleanly and keeps what is done, the second ends it at once.

use std::process;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::console::Console;
use crate::failure::{Failure, Message};

/// Whether the user has asked for the end.
#[derive(Debug, Clone, Default)]
pub(crate) struct Interrupt(Arc<AtomicBool>);

impl Interrupt {
    /// Watches for Ctrl-C from now on; `ending` is said at the first.
    ///
    /// # Errors
    /// The system does not let this process watch.
    pub(crate) fn watch(console: Console, ending: &'static str) -> Result<Self, Failure> {
        let interrupt = Self::default();
        let asked = Arc::clone(&interrupt.0);
        let handler = move || {
            if asked.swap(true, Ordering::Relaxed) {
                process::exit(1);
            }
            console.note(format_args!("\n{ending}; Ctrl-C once more ends at once"));
        };
        match ctrlc::set_handler(handler) {
            Ok(()) => Ok(interrupt),
            Err(source) => {
                Err(Failure::missing(Message::error(format!("cannot watch for Ctrl-C: {source}"))))
            }
        }
    }

    /// Whether Ctrl-C was pressed.
    pub(crate) fn asked(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}
