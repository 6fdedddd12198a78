//! Bars while an analysis runs, its time when it is done.

use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use judder_study::Progress;

use crate::console::Console;
use crate::failure::Failure;
use crate::interrupt::Interrupt;

const BAR: &str = "{spinner} {prefix} {bar:30} {pos}/{len}  {per_sec}, {eta} left";
const TICK: Duration = Duration::from_millis(100);

/// One bar at a time on a terminal; a line for every analysis with `-v`.
pub(crate) struct Bars {
    console: Console,
    interrupt: Interrupt,
    bar: Mutex<ProgressBar>,
}

impl Bars {
    /// Bars for this console, which Ctrl-C stops.
    ///
    /// # Errors
    /// As [`Interrupt::watch`].
    pub(crate) fn new(console: Console) -> Result<Self, Failure> {
        let interrupt = Interrupt::watch(console)?;
        Ok(Self { console, interrupt, bar: Mutex::new(ProgressBar::hidden()) })
    }

    fn bar(&self) -> MutexGuard<'_, ProgressBar> {
        // A bar is whole after every call, whatever became of the thread that drew it.
        self.bar.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Progress for Bars {
    fn begin(&self, name: &str, steps: usize) {
        let target = match self.console.has_bars() {
            true => ProgressDrawTarget::stderr(),
            false => ProgressDrawTarget::hidden(),
        };
        let bar = ProgressBar::with_draw_target(Some(steps as u64), target).with_prefix(name.to_owned());
        if let Ok(style) = ProgressStyle::with_template(BAR) {
            bar.set_style(style);
        }
        if self.console.has_bars() {
            bar.enable_steady_tick(TICK);
        }
        *self.bar() = bar;
    }

    fn advance(&self) {
        self.bar().inc(1);
    }

    fn end(&self) {
        let bar = self.bar();
        bar.finish_and_clear();
        let (name, seconds) = (bar.prefix(), bar.elapsed().as_secs_f64());
        self.console.detail(1, format_args!("{name}: {seconds:.2} s"));
        self.console
            .detail(2, format_args!("{name}: {} of {} steps", bar.position(), bar.length().unwrap_or(0)));
    }

    fn interrupted(&self) -> bool {
        self.interrupt.asked()
    }
}
