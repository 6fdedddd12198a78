//! What the user sees: results on standard output, everything else on standard error.

use std::borrow::Cow;
use std::ffi::OsString;
use std::fmt::Display;
use std::io::{self, BufWriter, ErrorKind, IsTerminal, Write};
use std::sync::{Mutex, PoisonError};

use clap::ValueEnum;
use clap::builder::StyledStr;
use miette::{Diagnostic, GraphicalReportHandler, GraphicalTheme};
use serde::Serialize;
use serde_json::{Value, json};
use terminal_size::{Width, terminal_size_of};

use crate::failure::{Exit, Failure, Message};

/// Where more is said of what a result lacks.
pub(crate) const IN_THE_REPORT: &str = "the report says it in its place";
/// Where no terminal gives a width.
const WIDTH: u16 = 120;

/// Whether the one document of `--json` stands on standard output; held while it is written.
static HAS_DOCUMENT: Mutex<bool> = Mutex::new(false);

/// How to speak to the user of this command line.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Console {
    json: bool,
    quiet: bool,
    verbosity: u8,
    progress: ProgressForm,
}

/// How is told how far a command is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum ProgressForm {
    /// Bars on a terminal, elsewhere a line at least every ten seconds
    Auto,
    /// Lines of JSON on standard error, messages among them
    Json,
    /// Nothing
    None,
}

/// A result as a document that says why the command ends with another exit code than 0.
#[derive(Debug, Serialize)]
pub(crate) struct ResultDocument<'a, D> {
    #[serde(flatten)]
    pub(crate) result: D,
    /// What the result lacks, a line each.
    #[serde(skip_serializing_if = "<[String]>::is_empty")]
    pub(crate) lacking: &'a [String],
    /// Why a part of it was refused, as a document of its own.
    #[serde(flatten)]
    pub(crate) error: Option<Value>,
}

impl<'a, D> ResultDocument<'a, D> {
    /// A result of which this is missing.
    pub(crate) fn lacking(result: D, lacking: &'a [String]) -> Self {
        Self { result, lacking, error: None }
    }
}

impl Console {
    pub(crate) fn new(json: bool, quiet: bool, verbosity: u8, progress: ProgressForm) -> Self {
        Self { json, quiet, verbosity, progress }
    }

    /// For arguments that could not be parsed: of these only those matter that say how a program reads.
    pub(crate) fn before_parsing(words: &[OsString]) -> Self {
        let options: Vec<_> = words.iter().skip(1).take_while(|argument| *argument != "--").collect();
        let is_given = |option: &[&str]| options.windows(option.len()).any(|own| own == option);
        let has_json_lines = is_given(&["--progress=json"]) || is_given(&["--progress", "json"]);
        let progress = if has_json_lines { ProgressForm::Json } else { ProgressForm::Auto };
        Self::new(is_given(&["--json"]), false, 0, progress)
    }

    /// For a command that begins: no document stands on standard output yet.
    pub(crate) fn begin(self) {
        *HAS_DOCUMENT.lock().unwrap_or_else(PoisonError::into_inner) = false;
    }

    /// Whether one JSON document is the result.
    pub(crate) fn json(self) -> bool {
        self.json
    }

    /// Whether progress bars may be drawn.
    pub(crate) fn has_bars(self) -> bool {
        !self.json && !self.quiet && self.progress == ProgressForm::Auto && io::stderr().is_terminal()
    }

    /// Whether lines tell how far a command is.
    pub(crate) fn has_lines(self) -> bool {
        !self.quiet && self.progress == ProgressForm::Auto && !self.has_bars()
    }

    /// Whether these are lines of JSON.
    pub(crate) fn has_json_lines(self) -> bool {
        self.progress == ProgressForm::Json
    }

    /// A line of JSON, where they are asked for.
    pub(crate) fn json_line(self, line: impl FnOnce() -> Value) {
        if self.has_json_lines() {
            write_message(&format!("{}\n", line()));
        }
    }

    /// A line that tells how far a command is.
    pub(crate) fn progress_line(self, text: impl FnOnce() -> String, line: impl FnOnce() -> Value) {
        if self.has_lines() {
            write_message(&format!("{}\n", harmless(&text())));
        }
        self.json_line(line);
    }

    /// A message as it is, or as a line of JSON.
    fn say(self, text: &str) {
        match self.has_json_lines() {
            true => self.json_line(|| json!({ "event": "message", "text": text.trim_end() })),
            false => write_message(text),
        }
    }

    /// Says a message with its place and help.
    fn draw(self, diagnostic: &dyn Diagnostic) {
        self.say(&drawn(diagnostic, self.has_json_lines()));
    }

    /// Prints the result of a command in the form that was asked for.
    ///
    /// # Errors
    /// Standard output cannot be written; a reader that has gone is none.
    pub(crate) fn result<D: Serialize>(
        self,
        text: impl FnOnce() -> String,
        json: impl FnOnce() -> D,
    ) -> Result<(), Failure> {
        if self.json {
            write_document(&json())
        } else {
            write_output(|output| output.write_all(harmless(&text()).as_bytes()))
        }
    }

    /// Prints the result of a command that has one only for `--json`.
    ///
    /// # Errors
    /// As [`Console::result`].
    pub(crate) fn document<D: Serialize>(self, json: impl FnOnce() -> D) -> Result<(), Failure> {
        self.result(String::new, json)
    }

    /// A line for whoever did not ask for silence.
    pub(crate) fn note(self, text: impl Display) {
        self.detail(0, text);
    }

    /// A line for whoever asked for as many `-v`.
    pub(crate) fn detail(self, verbosity: u8, text: impl Display) {
        if !self.quiet && self.verbosity >= verbosity {
            self.say(&format!("{}\n", harmless(&text.to_string())));
        }
    }

    /// What the user has to know before trusting the result.
    pub(crate) fn warn(self, text: &str) {
        if !self.quiet {
            self.draw(&Message::warning(text));
        }
    }

    /// Why a result is missing although the command ended well; told also to whoever asked for silence.
    pub(crate) fn incomplete(self, text: &str, help: &str) {
        self.draw(&Message::error(text).with_help(help));
    }

    /// What a result lacks, a line each, also for whoever asked for silence; how the command ends.
    pub(crate) fn lacking(self, lacking: &[String], help: &str) -> Exit {
        if lacking.is_empty() {
            return Exit::Done;
        }
        let text = format!("a requested result is missing: {}", lacking.join("\n"));
        self.incomplete(&text, help);
        Exit::Incomplete
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
            self.draw(one.diagnostic());
        }
        let more = (failure.others.len() + 1).saturating_sub(MOST);
        if more > 0 {
            self.draw(&Message::error(format!("{more} more things are wrong with it")));
        }
    }

    /// Why there is no result: for a person on standard error, for a program on standard output.
    pub(crate) fn failure(self, failure: &Failure) {
        if self.json {
            // If standard output cannot be written, the message on standard error is all there is.
            let _ = write_document(&failure.json());
        }
        self.draw_all(failure);
    }
}

/// Columns of the terminal on standard output, where there is one.
pub(crate) fn output_width() -> u16 {
    terminal_size_of(io::stdout()).map_or(WIDTH, |(Width(columns), _)| columns)
}

/// A message with its place and help. On a terminal lines wrap and have colours; in a file they stay whole, as those that a program reads do.
fn drawn(diagnostic: &dyn Diagnostic, is_for_program: bool) -> String {
    let theme = if is_for_program { GraphicalTheme::unicode_nocolor() } else { GraphicalTheme::unicode() };
    let handler = GraphicalReportHandler::new_themed(theme);
    let handler = match terminal_size_of(io::stderr()) {
        Some((Width(columns), _)) if !is_for_program => handler.with_width(usize::from(columns)),
        _ => handler.with_wrap_lines(false),
    };
    let mut drawing = String::new();
    match handler.render_report(&mut drawing, diagnostic) {
        Ok(()) if is_for_program => harmless(&drawing).into_owned(),
        Ok(()) => harmless_in_colour(&drawing),
        Err(_) => harmless(&format!("{diagnostic}\n")).into_owned(),
    }
}

/// A text with its control characters, other than ends of lines and tabs, escaped: those of a title could clear the terminal.
fn harmless(text: &str) -> Cow<'_, str> {
    let is_told = |letter: char| letter.is_control() && !matches!(letter, '\n' | '\t');
    if !text.contains(is_told) {
        return text.into();
    }
    let mut told = String::with_capacity(text.len());
    for letter in text.chars() {
        match is_told(letter) {
            true => told.extend(letter.escape_default()),
            false => told.push(letter),
        }
    }
    told.into()
}

/// The same of a text that has colours.
fn harmless_in_colour(text: &str) -> String {
    const ESCAPE: char = '\u{1b}';
    let is_colour = |code: &str| {
        let code = code.strip_prefix('[').unwrap_or_default();
        code.trim_start_matches(|letter: char| letter.is_ascii_digit() || letter == ';').starts_with('m')
    };
    let mut pieces = text.split(ESCAPE);
    let mut told = harmless(pieces.next().unwrap_or_default()).into_owned();
    for piece in pieces {
        match is_colour(piece) {
            true => told.push(ESCAPE),
            false => told.extend(ESCAPE.escape_default()),
        }
        told.push_str(&harmless(piece));
    }
    told
}

/// Writes to standard error; the stream drops colours where they are not wanted.
fn write_message(text: &str) {
    // Where standard error is closed there is nobody to tell.
    let _ = anstream::stderr().write_all(text.as_bytes());
}

/// Writes the document as it is made, where none stands there yet: that of a large study does not lie in memory once more.
fn write_document(document: &impl Serialize) -> Result<(), Failure> {
    let mut has_document = HAS_DOCUMENT.lock().unwrap_or_else(PoisonError::into_inner);
    if *has_document {
        return Ok(());
    }
    *has_document = true;
    write_output(|output| {
        serde_json::to_writer_pretty(&mut *output, document)?;
        output.write_all(b"\n")
    })
}

/// Prints help or version, with colours where they are wanted.
///
/// # Errors
/// As [`Console::result`].
pub(crate) fn print_styled(text: &StyledStr) -> Result<(), Failure> {
    let mut output = anstream::stdout().lock();
    settle(write!(output, "{}", text.ansi()).and_then(|()| output.flush()))
}

fn write_output(write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), Failure> {
    let mut output = BufWriter::new(io::stdout().lock());
    settle(write(&mut output).and_then(|()| output.flush()))
}

fn settle(written: io::Result<()>) -> Result<(), Failure> {
    match written {
        // `judder schema | head -1`: the reader has what it wants.
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        written => written.map_err(Failure::output),
    }
}
