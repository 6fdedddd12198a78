//! Named sets of a deck: names are the same in capitals and small letters, shown as first written.

use super::deck::{Keyword, words};
use crate::cause::FileCause;
use crate::error::ExchangeError;
use crate::quoted::quoted;
use crate::text::count;
use std::collections::{BTreeMap, HashMap};

/// Numbers of the file: `first`, `first + step`, … up to `last`.
#[derive(Debug, Clone, Copy)]
pub(super) struct NumberSpan {
    first: usize,
    last: usize,
    step: usize,
    line: usize,
}

/// How often a set, and all sets together, may name all there is.
const MOST_REPEATS: usize = 8;
const MOST_IN_ALL: usize = 256;

/// A set as it is written.
#[derive(Debug, Clone, Default)]
pub(super) struct NamedSet {
    pub(super) name: String,
    pub(super) spans: Vec<NumberSpan>,
}

/// Sets of one kind of thing by their names in capitals.
pub(super) struct Sets {
    sets: BTreeMap<String, NamedSet>,
    spans: usize,
    /// Sets that name sets could grow beyond any memory: there are no more spans than this.
    most: usize,
}

impl NumberSpan {
    pub(super) fn one(label: usize, line: usize) -> Self {
        Self { first: label, last: label, step: 1, line }
    }

    /// The places of its things.
    fn places(self, labels: &HashMap<usize, usize>, what: &'static str) -> Result<Vec<usize>, ExchangeError> {
        let here = |cause| ExchangeError::at_line(self.line, cause);
        let said = (self.last - self.first) / self.step + 1;
        if said > labels.len() {
            return Err(here(FileCause::WrongCount { what, said, found: labels.len() }));
        }
        let place = |label: usize| {
            let unknown = || here(FileCause::Unknown { what, label: label.to_string() });
            labels.get(&label).copied().ok_or_else(unknown)
        };
        (self.first..=self.last).step_by(self.step).map(place).collect()
    }
}

impl Sets {
    pub(super) fn new(most: usize) -> Self {
        Self { sets: BTreeMap::new(), spans: 0, most }
    }

    /// Adds to the set of this name, which is new where there is none.
    pub(super) fn add(&mut self, name: &str, spans: &[NumberSpan]) -> Result<(), FileCause> {
        self.charge(spans)?;
        self.entry(name).spans.extend(spans);
        Ok(())
    }

    /// Counts spans that are kept.
    pub(super) fn charge(&mut self, spans: &[NumberSpan]) -> Result<(), FileCause> {
        self.spans += spans.len();
        if self.spans > self.most { Err(FileCause::SetsTooLarge { most: self.most }) } else { Ok(()) }
    }

    /// The set of this name, new where there is none.
    fn entry(&mut self, name: &str) -> &mut NamedSet {
        let new = || NamedSet { name: name.to_owned(), spans: Vec::new() };
        self.sets.entry(name.to_ascii_uppercase()).or_insert_with(new)
    }

    pub(super) fn get(&self, name: &str) -> Option<&NamedSet> {
        self.sets.get(&name.to_ascii_uppercase())
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = &NamedSet> {
        self.sets.values()
    }

    /// Adds what the data lines of `*NSET` or `*ELSET` name: numbers, sets that are there, spans.
    pub(super) fn read(
        &mut self,
        keyword: &Keyword<'_>,
        name: &str,
        what: &'static str,
    ) -> Result<(), ExchangeError> {
        for (line, text) in &keyword.data {
            let added = if keyword.has("GENERATE") {
                span(text, *line, what).and_then(|span| self.add(name, &[span]))
            } else {
                words(text).iter().try_for_each(|word| {
                    let spans = self.named(word, *line, what)?;
                    self.add(name, &spans)
                })
            };
            added.map_err(|cause| ExchangeError::at_line(*line, cause))?;
        }
        // a set may be empty
        self.entry(name);
        Ok(())
    }

    /// A number, or the content of the set of this name.
    pub(super) fn named(
        &self,
        word: &str,
        line: usize,
        what: &'static str,
    ) -> Result<Vec<NumberSpan>, FileCause> {
        if word.starts_with(|letter: char| letter.is_ascii_digit() || letter == '-') {
            return Ok(vec![NumberSpan::one(count(word, 1, what)?, line)]);
        }
        let word = word.trim_matches('"');
        let set = self.get(word).ok_or_else(|| FileCause::Unknown { what: "set", label: quoted(word) })?;
        Ok(set.spans.clone())
    }
}

/// The places of the things of some spans, in their order.
pub(super) fn places(
    spans: &[NumberSpan],
    labels: &HashMap<usize, usize>,
    what: &'static str,
) -> Result<Vec<usize>, ExchangeError> {
    let mut all = Vec::new();
    let most = MOST_REPEATS * labels.len();
    for span in spans {
        let own = span.places(labels, what)?;
        if all.len() + own.len() > most {
            return Err(ExchangeError::at_line(span.line, FileCause::SetsTooLarge { most }));
        }
        all.extend(own);
    }
    Ok(all)
}

/// Whether sets of so many members in all are those of a mesh of so many things.
pub(super) fn check_members(members: usize, things: usize) -> Result<(), FileCause> {
    let most = MOST_IN_ALL * things;
    if members > most { Err(FileCause::SetsTooLarge { most }) } else { Ok(()) }
}

/// A line of a generated set: first, last, step.
fn span(text: &str, line: usize, what: &'static str) -> Result<NumberSpan, FileCause> {
    let words = words(text);
    let (first, last, step) = match words.as_slice() {
        [first, last] | [first, last, ""] => (first, last, &"1"),
        [first, last, step] => (first, last, step),
        _ => {
            let expected = "the first, the last and the step";
            return Err(FileCause::WrongEntries {
                what: "a line of a generated set",
                expected,
                found: words.len(),
            });
        }
    };
    let (first, last, step) = (count(first, 1, what)?, count(last, 1, what)?, count(step, 1, "a step")?);
    if last < first {
        let problem = format!("it goes from {first} to {last}");
        return Err(FileCause::Inconsistent { what: "a line of a generated set", problem });
    }
    Ok(NumberSpan { first, last, step, line })
}
