//! How far a command is: bars on a terminal, elsewhere a line now and then, or lines of JSON.

use std::fmt::Write;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use indicatif::{HumanDuration, ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};
use judder_study::Progress;
use serde_json::json;

use crate::console::Console;
use crate::interrupt::Interrupt;

const BAR: &str = "{spinner} {prefix} {bar:30} {pos}/{len}  {pace}";
const SPINNER: &str = "{spinner} {prefix}  {elapsed}";
const TICK: Duration = Duration::from_millis(100);
/// How often is looked whether a line is due.
const LOOK: Duration = Duration::from_millis(200);
/// After how long something that has no steps is told.
const SILENCE: Duration = Duration::from_secs(1);
/// The longest time between lines.
const LINE: Duration = Duration::from_secs(10);

/// One bar at a time on a terminal, lines elsewhere; a line for every analysis with `-v`.
pub(crate) struct Bars {
    board: Arc<Board>,
    interrupt: Interrupt,
    ticker: Option<JoinHandle<()>>,
}

/// What the commands tell, and those who show it.
struct Board {
    console: Console,
    now: Mutex<Now>,
    bell: Condvar,
}

/// What is being done.
struct Now {
    bar: ProgressBar,
    /// What has no steps, since when, and whether a line has told it.
    announced: Option<Announced>,
    last_line: Instant,
    /// Steps that were told last, as JSON.
    told: u64,
    is_over: bool,
}

struct Announced {
    what: String,
    since: Instant,
    is_told: bool,
    spinner: ProgressBar,
}

impl Bars {
    /// Bars for this console, of a command that a signal stops and that keeps what is done.
    pub(crate) fn new(console: Console) -> Self {
        Self::with(console, Interrupt::kept(console))
    }

    /// Bars for this console, of a command that a signal ends at once.
    pub(crate) fn of_what_is_not_kept(console: Console) -> Self {
        Self::with(console, Interrupt::unkept())
    }

    fn with(console: Console, interrupt: Interrupt) -> Self {
        let (bar, last_line) = (ProgressBar::hidden(), Instant::now());
        bar.finish();
        let now = Now { bar, announced: None, last_line, told: 0, is_over: false };
        let board = Arc::new(Board { console, now: Mutex::new(now), bell: Condvar::new() });
        let has_lines = console.has_lines() || console.has_json_lines();
        let shown = Arc::clone(&board);
        // where the system gives no thread no lines come
        let ticker = has_lines.then(|| thread::Builder::new().spawn(move || shown.tell()).ok()).flatten();
        Self { board, interrupt, ticker }
    }
}

impl Drop for Bars {
    fn drop(&mut self) {
        self.board.now().is_over = true;
        self.board.bell.notify_all();
        if let Some(ticker) = self.ticker.take() {
            // a line that could not be written is no failure of the command
            let _ = ticker.join();
        }
    }
}

impl Board {
    fn now(&self) -> MutexGuard<'_, Now> {
        // It is whole after every call, whatever became of the thread that changed it.
        self.now.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Writes lines until the command is over.
    fn tell(&self) {
        let mut now = self.now();
        while !now.is_over {
            now = self.bell.wait_timeout(now, LOOK).unwrap_or_else(PoisonError::into_inner).0;
            if !now.is_over && now.is_line_due(self.console.has_json_lines()) {
                now.line(self.console);
            }
        }
    }
}

impl Now {
    fn is_line_due(&self, is_json: bool) -> bool {
        let silent = self.last_line.elapsed();
        let is_new = |own: &Announced| !own.is_told && own.since.elapsed() >= SILENCE;
        let has_moved = is_json && self.bar.position() != self.told && silent >= SILENCE;
        silent >= LINE || has_moved || self.announced.as_ref().is_some_and(is_new)
    }

    fn line(&mut self, console: Console) {
        self.last_line = Instant::now();
        self.told = self.bar.position();
        match &mut self.announced {
            Some(Announced { what, since, is_told, .. }) => {
                *is_told = true;
                let seconds = since.elapsed().as_secs_f64();
                let line = json!({ "event": "announce", "name": what, "seconds": seconds });
                console.progress_line(|| format!("{what}: {seconds:.0} s"), || line);
            }
            None if self.bar.is_finished() => {
                console.progress_line(
                    || "at work".to_owned(),
                    || json!({ "event": "announce", "name": "at work" }),
                );
            }
            None => console.progress_line(|| self.steps_told(), || self.event("step")),
        }
    }

    /// `map: 120 of 480 steps, 12 s`.
    fn steps_told(&self) -> String {
        let (name, seconds) = (self.bar.prefix(), self.bar.elapsed().as_secs_f64());
        let (done, steps) = (self.bar.position(), self.bar.length().unwrap_or(0));
        format!("{name}: {done} of {steps} steps, {seconds:.0} s")
    }

    fn event(&self, event: &str) -> serde_json::Value {
        json!({
            "event": event, "name": self.bar.prefix(), "done": self.bar.position(), "steps": self.bar.length(),
            "seconds": self.bar.elapsed().as_secs_f64(),
        })
    }
}

/// A bar of this template on the terminal, where there is one.
fn drawn(console: Console, name: &str, steps: Option<u64>, template: &str) -> ProgressBar {
    let target = match console.has_bars() {
        true => ProgressDrawTarget::stderr(),
        false => ProgressDrawTarget::hidden(),
    };
    let bar = ProgressBar::with_draw_target(steps, target).with_prefix(name.to_owned());
    if let Ok(style) = ProgressStyle::with_template(template) {
        bar.set_style(style.with_key("pace", write_pace));
    }
    if console.has_bars() {
        bar.enable_steady_tick(TICK);
    }
    bar
}

impl Progress for Bars {
    fn begin(&self, name: &str, steps: usize) {
        let console = self.board.console;
        let mut now = self.board.now();
        now.bar = drawn(console, name, Some(steps as u64), BAR);
        now.told = 0;
        console.json_line(|| now.event("begin"));
    }

    fn expect(&self, steps: usize) {
        self.board.now().bar.inc_length(steps as u64);
    }

    fn advance(&self) {
        self.board.now().bar.inc(1);
    }

    fn end(&self) {
        let (console, now) = (self.board.console, self.board.now());
        now.bar.finish_and_clear();
        console.json_line(|| now.event("end"));
        let (name, seconds) = (now.bar.prefix(), now.bar.elapsed().as_secs_f64());
        let (done, steps) = (now.bar.position(), now.bar.length().unwrap_or(0));
        console.detail(1, format_args!("{name}: {done} of {steps} steps in {seconds:.2} s"));
    }

    fn announce(&self, what: Option<&str>) {
        let console = self.board.console;
        let mut now = self.board.now();
        if let Some(last) = now.announced.take() {
            last.spinner.finish_and_clear();
        }
        let Some(what) = what else { return };
        // two that draw at a time would draw over each other
        let spinner = match now.bar.is_finished() {
            true => drawn(console, what, None, SPINNER),
            false => {
                now.bar.println(what);
                ProgressBar::hidden()
            }
        };
        let (what, since) = (what.to_owned(), Instant::now());
        now.announced = Some(Announced { what, since, is_told: false, spinner });
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::console::ProgressForm;

    #[test]
    fn a_line_is_due_after_a_while() {
        let bars = Bars::of_what_is_not_kept(Console::new(false, true, 0, ProgressForm::None));
        let due = || bars.board.now().is_line_due(false);
        let earlier = |seconds| Instant::now().checked_sub(Duration::from_secs(seconds)).unwrap();
        bars.begin("map", 480);
        assert!(!due(), "nothing at once");
        bars.board.now().last_line = earlier(9);
        assert!(!due());
        bars.board.now().last_line = earlier(10);
        assert!(due(), "at least every ten seconds");
        bars.board.now().last_line = Instant::now();
        bars.announce(Some("preparing the model"));
        assert!(!due());
        bars.board.now().announced.as_mut().unwrap().since = earlier(1);
        assert!(due(), "what has no steps is told after a second");
        bars.announce(None);
        assert!(!due());
    }
}
