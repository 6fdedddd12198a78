//! Bars while an analysis runs, its time when it is done.

use std::fmt::Write;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use indicatif::{HumanDuration, ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};
use judder_study::Progress;

use crate::console::Console;
use crate::failure::Failure;
use crate::interrupt::Interrupt;

const BAR: &str = "{spinner} {prefix} {bar:30} {pos}/{len}  {pace}";
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
        let interrupt = Interrupt::watch(console, "ending, and keeping what is done")?;
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
            bar.set_style(style.with_key("pace", write_pace));
        }
        if self.console.has_bars() {
            bar.enable_steady_tick(TICK);
        }
        *self.bar() = bar;
    }

    fn expect(&self, steps: usize) {
        self.bar().inc_length(steps as u64);
    }

    fn advance(&self) {
        self.bar().inc(1);
    }

    fn end(&self) {
        let bar = self.bar();
        bar.finish_and_clear();
        let (name, seconds) = (bar.prefix(), bar.elapsed().as_secs_f64());
        let (done, steps) = (bar.position(), bar.length().unwrap_or(0));
        self.console.detail(1, format_args!("{name}: {done} of {steps} steps in {seconds:.2} s"));
    }

    fn interrupted(&self) -> bool {
        self.interrupt.asked()
    }
}

/// `120/s, 4 seconds left`; nothing before the first step, when nobody knows.
fn write_pace(state: &ProgressState, line: &mut dyn Write) {
    if state.pos() > 0 {
        let (rate, left) = (state.per_sec(), HumanDuration(state.eta()));
        let digits = if rate < 100.0 { 1 } else { 0 };
        // A bar that cannot be drawn is no failure of the analysis.
        let _ = write!(line, "{rate:.digits$}/s, {left} left");
    }
}
