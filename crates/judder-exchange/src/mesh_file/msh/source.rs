//! The words of a `.msh` file: whitespace-separated in a text, of fixed widths in a binary file, in the same order.

use crate::bytes::Bytes;
use crate::cause::FileCause;
use crate::error::ExchangeError;
use crate::quoted::quoted;
use crate::text::{check_room, count, number};

/// How numbers are stored.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum MshForm {
    Text,
    Binary { big_endian: bool },
}

/// A walk over the file.
pub(super) struct MshSource<'a> {
    bytes: &'a [u8],
    at: usize,
    form: MshForm,
}

impl<'a> MshSource<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, at: 0, form: MshForm::Text }
    }

    pub(super) fn set_form(&mut self, form: MshForm) {
        self.form = form;
    }

    fn left(&self) -> &'a [u8] {
        &self.bytes[self.at.min(self.bytes.len())..]
    }

    /// An error here: its line in a text, its byte in a binary file.
    pub(super) fn error(&self, cause: FileCause) -> ExchangeError {
        self.error_at(self.at, cause)
    }

    fn error_at(&self, at: usize, cause: FileCause) -> ExchangeError {
        match self.form {
            MshForm::Text => {
                let before = &self.bytes[..at.min(self.bytes.len())];
                ExchangeError::at_line(1 + before.iter().filter(|byte| **byte == b'\n').count(), cause)
            }
            MshForm::Binary { .. } => ExchangeError::at_byte(at, cause),
        }
    }

    pub(super) fn is_text(&self) -> bool {
        self.form == MshForm::Text
    }

    /// Bytes that are left.
    pub(super) fn left_bytes(&self) -> usize {
        self.left().len()
    }

    /// The next line that is not empty, without its end; none at the end of the file.
    pub(super) fn line(&mut self) -> Result<Option<&'a str>, ExchangeError> {
        self.skip_spaces();
        let left = self.left();
        if left.is_empty() {
            return Ok(None);
        }
        let end = left.iter().position(|byte| *byte == b'\n').unwrap_or(left.len());
        let text = std::str::from_utf8(&left[..end])
            .map_err(|error| self.error(FileCause::NotText { byte: self.at + error.valid_up_to() }))?;
        self.at += end;
        Ok(Some(text.trim()))
    }

    fn skip_spaces(&mut self) {
        self.at += self.left().iter().take_while(|byte| byte.is_ascii_whitespace()).count();
    }

    /// Four bytes as they are.
    pub(super) fn four_bytes(&mut self) -> Result<[u8; 4], ExchangeError> {
        let mut walk = Bytes::new(self.bytes, self.at, false);
        let mut four = [0; 4];
        four.copy_from_slice(walk.take(4, "the number that tells the endianness")?);
        self.at = walk.at();
        Ok(four)
    }

    /// Goes behind the end of a line: binary numbers begin there.
    pub(super) fn begin_numbers_after_line(&mut self) {
        self.at += usize::from(self.left().first() == Some(&b'\r'));
        self.at += usize::from(self.left().first() == Some(&b'\n'));
    }

    /// Enters the numbers of a section.
    pub(super) fn begin_numbers(&mut self) {
        if !self.is_text() {
            self.begin_numbers_after_line();
        }
    }

    /// The next word of a text and where it begins.
    fn word(&mut self, what: &'static str) -> Result<(&'a str, usize), ExchangeError> {
        self.skip_spaces();
        let (left, at) = (self.left(), self.at);
        let length = left.iter().take_while(|byte| !byte.is_ascii_whitespace()).count();
        if length == 0 {
            return Err(self.error(FileCause::Cut { what, needed: 1, left: 0 }));
        }
        self.at += length;
        let word = std::str::from_utf8(&left[..length])
            .map_err(|error| self.error_at(at, FileCause::NotText { byte: at + error.valid_up_to() }))?;
        Ok((word, at))
    }

    fn fixed<const N: usize>(
        &mut self,
        big_endian: bool,
        what: &'static str,
    ) -> Result<[u8; N], ExchangeError> {
        let mut walk = Bytes::new(self.bytes, self.at, big_endian);
        let mut bytes = [0; N];
        bytes.copy_from_slice(walk.take(N, what)?);
        if big_endian {
            bytes.reverse();
        }
        self.at = walk.at();
        Ok(bytes)
    }

    /// An `int`: four bytes in a binary file.
    pub(super) fn int(&mut self, what: &'static str) -> Result<i64, ExchangeError> {
        match self.form {
            MshForm::Text => {
                let (word, at) = self.word(what)?;
                let cause = |_| FileCause::NotACount { text: quoted(word), least: 0, what };
                word.parse().map_err(|error| self.error_at(at, cause(error)))
            }
            MshForm::Binary { big_endian } => {
                Ok(i64::from(i32::from_le_bytes(self.fixed(big_endian, what)?)))
            }
        }
    }

    /// A `size_t`: eight bytes in a binary file.
    pub(super) fn size(&mut self, what: &'static str) -> Result<usize, ExchangeError> {
        match self.form {
            MshForm::Text => {
                let (word, at) = self.word(what)?;
                count(word, 0, what).map_err(|cause| self.error_at(at, cause))
            }
            MshForm::Binary { big_endian } => {
                let size = u64::from_le_bytes(self.fixed(big_endian, what)?);
                let text = || size.to_string();
                usize::try_from(size)
                    .map_err(|_| self.error(FileCause::NotACount { text: text(), least: 0, what }))
            }
        }
    }

    /// A finite number.
    pub(super) fn double(&mut self, what: &'static str) -> Result<f64, ExchangeError> {
        match self.form {
            MshForm::Text => {
                let (word, at) = self.word(what)?;
                number(word, what).map_err(|cause| self.error_at(at, cause))
            }
            MshForm::Binary { big_endian } => {
                let at = self.at;
                let value = f64::from_le_bytes(self.fixed(big_endian, what)?);
                if value.is_finite() {
                    return Ok(value);
                }
                Err(self.error_at(at, FileCause::NotANumber { text: value.to_string(), what }))
            }
        }
    }

    /// How many things follow, of at least so many words each; in a binary file a word has at least four bytes.
    pub(super) fn number_of(
        &mut self,
        words_each: usize,
        what: &'static str,
    ) -> Result<usize, ExchangeError> {
        let said = self.size(what)?;
        self.check_words(said, words_each, what)?;
        Ok(said)
    }

    /// An `int` that is not negative.
    pub(super) fn whole(&mut self, what: &'static str) -> Result<usize, ExchangeError> {
        let number = self.int(what)?;
        usize::try_from(number)
            .map_err(|_| self.error(FileCause::NotACount { text: number.to_string(), least: 0, what }))
    }

    /// How many things follow, of at least so many words each, where the number itself is an `int`.
    pub(super) fn int_count(
        &mut self,
        words_each: usize,
        what: &'static str,
    ) -> Result<usize, ExchangeError> {
        let said = self.whole(what)?;
        self.check_words(said, words_each, what)?;
        Ok(said)
    }

    fn check_words(&self, said: usize, words_each: usize, what: &'static str) -> Result<(), ExchangeError> {
        let word = if self.is_text() { 2 } else { 4 };
        // the last word of a text may lack its end
        check_room(said, words_each.saturating_mul(word), self.left().len() + 1, what)
            .map_err(|cause| self.error(cause))
    }

    /// Goes behind the line that ends a section; whether it is there.
    pub(super) fn skip_to(&mut self, end: &str) -> bool {
        let needle = end.as_bytes();
        let found = self.left().windows(needle.len()).position(|window| window == needle);
        self.at += found.map_or(0, |found| found + needle.len());
        found.is_some()
    }
}
