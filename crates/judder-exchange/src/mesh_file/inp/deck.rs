//! The lines of an input deck: keywords with parameters and data.

use crate::cause::FileCause;
use crate::error::ExchangeError;
use crate::quoted::quoted;
use std::collections::BTreeMap;

/// A keyword with what belongs to it.
pub(super) struct Keyword<'a> {
    /// In capitals, without the star.
    pub(super) name: String,
    /// Where it stands.
    pub(super) line: usize,
    /// By names in capitals; without a value empty.
    pub(super) parameters: BTreeMap<String, String>,
    /// Data lines that are no comments, with their numbers.
    pub(super) data: Vec<(usize, &'a str)>,
}

/// The keywords of a deck in their order.
pub(super) fn keywords(text: &str) -> Result<Vec<Keyword<'_>>, ExchangeError> {
    let mut keywords: Vec<Keyword<'_>> = Vec::new();
    let numbered = text.lines().enumerate().map(|(k, line)| (k + 1, line.trim()));
    let mut lines = numbered.filter(|(_, line)| !line.is_empty() && !line.starts_with("**"));
    while let Some((line, text)) = lines.next() {
        if text.starts_with('*') {
            let mut whole = text.to_owned();
            while whole.ends_with(',') {
                let Some((_, more)) = lines.next() else { break };
                whole.push_str(more);
            }
            keywords.push(keyword(&whole, line));
        } else if let Some(keyword) = keywords.last_mut() {
            keyword.data.push((line, text));
        } else {
            let cause = FileCause::Foreign {
                format: "input deck",
                found: format!("its first line is `{}`", quoted(text)),
                remedy: "a deck begins with a keyword, such as *HEADING or *NODE",
            };
            return Err(ExchangeError::at_line(line, cause));
        }
    }
    if keywords.is_empty() {
        let cause = FileCause::Foreign {
            format: "input deck",
            found: String::from("it has no keywords"),
            remedy: "it needs *NODE and *ELEMENT",
        };
        return Err(cause.into());
    }
    Ok(keywords)
}

fn keyword(text: &str, line: usize) -> Keyword<'static> {
    let mut parts = text.trim_start_matches('*').split(',');
    let capitals = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ").to_ascii_uppercase();
    let name = capitals(parts.next().unwrap_or(""));
    let parameters = parts.filter(|part| !part.trim().is_empty()).map(|part| {
        let (key, value) = part.split_once('=').unwrap_or((part, ""));
        (capitals(key), value.trim().trim_matches('"').to_owned())
    });
    Keyword { name, line, parameters: parameters.collect(), data: Vec::new() }
}

impl Keyword<'_> {
    pub(super) fn has(&self, parameter: &str) -> bool {
        self.parameters.contains_key(parameter)
    }

    /// The value of a parameter in capitals.
    pub(super) fn capitals(&self, parameter: &str) -> Option<String> {
        self.parameters.get(parameter).map(|value| value.to_ascii_uppercase())
    }

    /// The value of a parameter that must be there.
    pub(super) fn needed(&self, parameter: &'static str) -> Result<&str, FileCause> {
        match self.parameters.get(parameter) {
            Some(value) if !value.is_empty() => Ok(value),
            _ => Err(FileCause::MissingParameter { keyword: quoted(&self.name), parameter }),
        }
    }

    /// An error at the keyword's line.
    pub(super) fn error(&self, cause: FileCause) -> ExchangeError {
        ExchangeError::at_line(self.line, cause)
    }
}

/// The entries of a data line; a comma at its end adds none.
pub(super) fn words(line: &str) -> Vec<&str> {
    line.strip_suffix(',').unwrap_or(line).split(',').map(str::trim).collect()
}
