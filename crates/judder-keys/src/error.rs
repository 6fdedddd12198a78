//! An error with its place: which file (or `--set` option), which bytes, what would be right.

use std::fmt;
use std::sync::Arc;

use miette::{Diagnostic, LabeledSpan, SourceCode, SourceSpan};

use crate::cause::Cause;
use crate::document::path_at;
use crate::excerpt::{QUOTED, QuotedSource};

/// What is wrong with a case, and where: a [`Cause`] at a place of the case file or of a `--set` option.
///
/// As a [`Diagnostic`] it carries the source text, one labelled span and a help line; the terminal draws them.
#[derive(Debug)]
pub struct CaseError {
    cause: Box<Cause>,
    source: QuotedSource,
    span: Option<SourceSpan>,
    others: Vec<CaseError>,
}

impl CaseError {
    /// A cause that has no place in a text; `name` is what the text is called.
    pub fn without_place(cause: Cause, name: &str) -> Self {
        Self {
            cause: Box::new(cause),
            source: QuotedSource { name: name.to_owned(), text: Arc::from("") },
            span: None,
            others: Vec::new(),
        }
    }

    /// What is wrong, with the values that a caller can act on.
    pub fn cause(&self) -> &Cause {
        &self.cause
    }

    /// The dotted path of the key that is to blame, items of lists by their names or positions; where the error has no place in a text, as its cause has it.
    pub fn key(&self) -> Option<String> {
        let own = self.cause.key().map(str::to_owned);
        let bytes = self.span.map(|span| span.offset()..span.offset() + span.len());
        let Some(at) = bytes.and_then(|bytes| path_at(&self.source.text, &bytes)) else { return own };
        match (&*self.cause, own) {
            // whose place is that of its section
            (Cause::MissingKey { .. }, Some(key)) => Some(format!("{at}.{key}")),
            _ => Some(at),
        }
    }

    /// What else is wrong with the same case, in the order of its text.
    pub fn others(&self) -> &[Self] {
        &self.others
    }

    /// The error alone, and all that is wrong besides.
    #[must_use]
    pub fn split(mut self) -> (Self, Vec<Self>) {
        let others = std::mem::take(&mut self.others);
        (self, others)
    }

    /// The name of the text that the error points into: that of the case file, or `--set`.
    pub fn source_name(&self) -> &str {
        &self.source.name
    }

    /// The same of a text that is called otherwise.
    #[must_use]
    pub fn called(mut self, name: &str) -> Self {
        name.clone_into(&mut self.source.name);
        self.others = self.others.into_iter().map(|other| other.called(name)).collect();
        self
    }

    /// Line and column at which that part begins, both from 1; `None` where the error has no place.
    pub fn line_and_column(&self) -> Option<(usize, usize)> {
        let before = self.source.text.get(..self.span?.offset())?;
        let line_start = before.rfind('\n').map_or(0, |end| end + 1);
        Some((before.matches('\n').count() + 1, before[line_start..].chars().count() + 1))
    }

    /// The part of the text that the error concerns; empty where the error has no place.
    pub fn place(&self) -> &str {
        let span = self.span.map_or(0..0, |span| span.offset()..span.offset() + span.len());
        self.source.text.get(span).unwrap_or_default()
    }
}

impl fmt::Display for CaseError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let message = self.cause.to_string();
        // a message repeats words of the case, which may be of any length
        match message.floor_char_boundary(QUOTED) {
            end if end < message.len() => write!(formatter, "{}…", &message[..end]),
            _ => formatter.write_str(&message),
        }
    }
}

impl std::error::Error for CaseError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        std::error::Error::source(&*self.cause)
    }
}

impl Diagnostic for CaseError {
    fn help<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        self.cause.help().map(|help| Box::new(help) as Box<dyn fmt::Display>)
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        self.span.map(|_| &self.source as &dyn SourceCode)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let span = self.source.shorten(self.span?);
        Some(Box::new(std::iter::once(LabeledSpan::at(span, self.cause.label()))))
    }
}

/// A range of bytes in one of the texts of a case.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Place {
    /// 0 is the case file, n the n-th `--set` option.
    pub source: usize,
    /// The first byte.
    pub start: usize,
    /// The byte after the last.
    pub end: usize,
}

impl Place {
    /// Whether it lies in a `--set` option.
    pub fn is_option(self) -> bool {
        self.source > 0
    }
}

/// A cause with its place, before the source text is attached.
#[derive(Debug)]
pub struct Fault {
    cause: Box<Cause>,
    place: Place,
    /// What else is wrong with the same text.
    others: Vec<Fault>,
}

impl Cause {
    /// The cause at a place.
    pub fn at(self, place: Place) -> Fault {
        Fault { cause: Box::new(self), place, others: Vec::new() }
    }
}

impl Fault {
    /// Where it is.
    pub fn place(&self) -> Place {
        self.place
    }

    /// This one, and another one beside it.
    pub fn and(mut self, mut other: Self) -> Self {
        let beside = std::mem::take(&mut other.others);
        self.others.push(other);
        self.others.extend(beside);
        self
    }

    /// Where it begins: in which text, and there.
    fn start(&self) -> (usize, usize) {
        (self.place.source, self.place.start)
    }

    /// What is wrong, without its place.
    pub fn into_cause(self) -> Cause {
        *self.cause
    }
}

/// A key that stands for another one, and where.
struct MisspeltKey {
    meant: String,
    section: String,
    start: (usize, usize),
}

fn misspelt_keys(faults: &[Fault]) -> Vec<MisspeltKey> {
    let misspelt = |fault: &Fault| {
        let (meant, section) = fault.cause.misspelt_key()?;
        Some(MisspeltKey { meant, section, start: fault.start() })
    };
    faults.iter().filter_map(misspelt).collect()
}

/// Which fault says that the meant key lacks: of sections that are called alike, that of the last that begins before it.
fn lack_of(misspelt: &MisspeltKey, faults: &[Fault]) -> Option<usize> {
    let is_this = |fault: &Fault| {
        fault.cause.is_lack_of(&misspelt.meant, &misspelt.section) && fault.start() <= misspelt.start
    };
    let lacks = (0..faults.len()).filter(|k| is_this(&faults[*k]));
    lacks.max_by_key(|k| faults[*k].start())
}

/// The texts of a case: the file first, then the `--set` options.
pub struct Sources(Vec<(String, Arc<str>)>);

impl Sources {
    /// The text of a case, what it is called, and its `--set` options.
    pub fn new(name: &str, text: &str, overrides: &[String]) -> Self {
        let options = overrides.iter().map(|option| ("--set".to_owned(), Arc::from(option.as_str())));
        Self(std::iter::once((name.to_owned(), Arc::from(text))).chain(options).collect())
    }

    /// Attaches the text to a fault, and to those beside it, by their places. A key that lacks because it is misspelt is told once.
    pub fn error(&self, mut fault: Fault) -> CaseError {
        let mut all = std::mem::take(&mut fault.others);
        all.insert(0, fault);
        for misspelt in misspelt_keys(&all) {
            if let Some(lack) = lack_of(&misspelt, &all) {
                all.remove(lack);
            }
        }
        all.sort_by_key(Fault::start);
        let first = all.remove(0);
        let others = all.into_iter().map(|other| self.error_of(other)).collect();
        CaseError { others, ..self.error_of(first) }
    }

    fn error_of(&self, fault: Fault) -> CaseError {
        let Place { source, start, end } = fault.place;
        let (name, text) = self.0.get(source).cloned().unwrap_or_default();
        let span = Some(SourceSpan::from((start, end.saturating_sub(start))));
        CaseError { cause: fault.cause, source: QuotedSource { name, text }, span, others: Vec::new() }
    }
}
