//! Lines and numbers of text files.

use crate::cause::FileCause;
use crate::error::ExchangeError;
use crate::quoted::quoted;

/// The text of a file.
pub(crate) fn text_of(bytes: &[u8]) -> Result<&str, ExchangeError> {
    let text = std::str::from_utf8(bytes).map_err(|error| {
        let byte = error.valid_up_to();
        let line = 1 + bytes[..byte].iter().filter(|b| **b == b'\n').count();
        ExchangeError::at_line(line, FileCause::NotText { byte })
    })?;
    Ok(text.trim_start_matches('\u{feff}'))
}

/// A finite number; Fortran's exponents with `D` are known.
pub(crate) fn number(word: &str, what: &'static str) -> Result<f64, FileCause> {
    let parsed = match word.parse::<f64>() {
        Err(_) if word.contains(['d', 'D']) => word.replace(['d', 'D'], "e").parse(),
        parsed => parsed,
    };
    match parsed {
        Ok(value) if value.is_finite() => Ok(value),
        _ => Err(FileCause::NotANumber { text: quoted(word), what }),
    }
}

/// A whole number.
pub(crate) fn count(word: &str, least: usize, what: &'static str) -> Result<usize, FileCause> {
    match word.parse::<usize>() {
        Ok(value) if value >= least => Ok(value),
        _ => Err(FileCause::NotACount { text: quoted(word), least, what }),
    }
}

/// Whether `said` things of at least `bytes_each` can be in what is left of a file: asked before anything is allocated.
pub(crate) fn check_room(
    said: usize,
    bytes_each: usize,
    left: usize,
    what: &'static str,
) -> Result<(), FileCause> {
    let room = left / bytes_each;
    if said > room { Err(FileCause::TooMany { what, said, left, room }) } else { Ok(()) }
}
