//! What the user sees: results on standard output, everything else on standard error.

use std::ffi::OsString;
use std::fmt::Display;
use std::io::{self, ErrorKind, IsTerminal, Write};

use miette::{Diagnostic, GraphicalReportHandler, GraphicalTheme};
use serde_json::Value;
use terminal_size::{Width, terminal_size_of};

use crate::failure::{Failure, Message};

/// Where no terminal gives a width.
const WIDTH: u16 = 120;

/// How to speak to the user of this command line.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Console {
    json: bool,
    quiet: bool,
    verbosity: u8,
}

impl Console {
    pub(crate) fn new(json: bool, quiet: bool, verbosity: u8) -> Self {
        Self { json, quiet, verbosity }
    }

    /// For arguments that could not be parsed: of these only `--json` matters.
    pub(crate) fn before_parsing(words: &[OsString]) -> Self {
        let mut options = words.iter().skip(1).take_while(|argument| *argument != "--");
        Self::new(options.any(|argument| argument == "--json"), false, 0)
    }

    /// Whether one JSON document is the result.
    pub(crate) fn json(self) -> bool {
        self.json
    }

    /// Whether progress bars may be drawn.
    pub(crate) fn has_bars(self) -> bool {
        !self.json && !self.quiet && io::stderr().is_terminal()
    }

    /// Prints the result of a command in the form that was asked for.
    ///
    /// # Errors
    /// Standard output cannot be written; a reader that has gone is none.
    pub(crate) fn result(
        self,
        text: impl FnOnce() -> String,
        json: impl FnOnce() -> Value,
    ) -> Result<(), Failure> {
        if self.json { write_output(&format!("{:#}\n", json())) } else { write_output(&text()) }
    }

    /// Prints the result of a command that has one only for `--json`.
    ///
    /// # Errors
    /// As [`Console::result`].
    pub(crate) fn document(self, json: impl FnOnce() -> Value) -> Result<(), Failure> {
        self.result(String::new, json)
    }

    /// A line for whoever did not ask for silence.
    pub(crate) fn note(self, text: impl Display) {
        self.detail(0, text);
    }

    /// A line for whoever asked for as many `-v`.
    pub(crate) fn detail(self, verbosity: u8, text: impl Display) {
        if !self.quiet && self.verbosity >= verbosity {
            write_message(&format!("{text}\n"));
        }
    }

    /// What the user has to know before trusting the result.
    pub(crate) fn warn(self, text: &str) {
        if !self.quiet {
            write_message(&draw(&Message::warning(text)));
        }
    }

    /// Why a result is missing although the command ended well; told also to whoever asked for silence.
    pub(crate) fn incomplete(self, text: &str, help: &str) {
        write_message(&draw(&Message::error(text).with_help(help)));
    }

    /// Why a part of the result is missing; told also to whoever asked for silence.
    pub(crate) fn refusal(self, failure: &Failure) {
        self.draw_all(failure);
    }

    /// What is wrong, one message after the other; of very many the first.
    fn draw_all(self, failure: &Failure) {
        /// A screen or two.
        const MOST: usize = 20;
        for one in std::iter::once(failure).chain(&failure.others).take(MOST) {
            write_message(&draw(one.diagnostic()));
        }
        let more = (failure.others.len() + 1).saturating_sub(MOST);
        if more > 0 {
            write_message(&draw(&Message::error(format!("{more} more things are wrong with it"))));
        }
    }

    /// Why there is no result: for a person on standard error, for a program on standard output.
    pub(crate) fn failure(self, failure: &Failure) {
        if self.json {
            // If standard output cannot be written, the message on standard error is all there is.
            let _ = write_output(&format!("{:#}\n", failure.json()));
        }
        self.draw_all(failure);
    }
}

/// Columns of the terminal on standard output, where there is one.
pub(crate) fn output_width() -> u16 {
    terminal_size_of(io::stdout()).map_or(WIDTH, |(Width(columns), _)| columns)
}

/// A message with its place and help. On a terminal lines wrap; in a file they stay whole.
fn draw(diagnostic: &dyn Diagnostic) -> String {
    let handler = GraphicalReportHandler::new_themed(GraphicalTheme::unicode());
    let handler = match terminal_size_of(io::stderr()) {
        Some((Width(columns), _)) => handler.with_width(usize::from(columns)),
        None => handler.with_wrap_lines(false),
    };
    let mut drawing = String::new();
    match handler.render_report(&mut drawing, diagnostic) {
        Ok(()) => drawing,
        Err(_) => format!("{diagnostic}\n"),
    }
}

/// Writes to standard error; the stream drops colours where they are not wanted.
fn write_message(text: &str) {
    // Where standard error is closed there is nobody to tell.
    let _ = anstream::stderr().write_all(text.as_bytes());
}

fn write_output(text: &str) -> Result<(), Failure> {
    let mut output = io::stdout().lock();
    match output.write_all(text.as_bytes()).and_then(|()| output.flush()) {
        // `judder schema | head -1`: the reader has what it wants.
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        written => written.map_err(Failure::output),
    }
}
