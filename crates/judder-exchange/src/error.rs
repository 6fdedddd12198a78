//! An error with its place: which file, where in it, what is wrong.

use crate::cause::FileCause;
use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

/// Where in a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FilePlace {
    /// The file as a whole.
    Whole,
    /// A line of a text, counted from 1.
    Line(usize),
    /// A byte of a binary file, counted from 0.
    Byte(usize),
}

/// What is wrong with a file, and where.
#[derive(Debug)]
pub struct ExchangeError {
    path: Option<PathBuf>,
    place: FilePlace,
    cause: Box<FileCause>,
}

impl ExchangeError {
    pub(crate) fn new(place: FilePlace, cause: FileCause) -> Self {
        Self { path: None, place, cause: Box::new(cause) }
    }

    pub(crate) fn at_line(line: usize, cause: FileCause) -> Self {
        Self::new(FilePlace::Line(line), cause)
    }

    pub(crate) fn at_byte(byte: usize, cause: FileCause) -> Self {
        Self::new(FilePlace::Byte(byte), cause)
    }

    pub(crate) fn in_file(mut self, path: &Path) -> Self {
        self.path.get_or_insert_with(|| path.to_owned());
        self
    }

    /// The same at another place.
    pub(crate) fn moved(mut self, place: FilePlace) -> Self {
        self.place = place;
        self
    }

    /// The same where bytes are counted from an earlier one.
    pub(crate) fn shifted(mut self, by: usize) -> Self {
        self.place = match self.place {
            FilePlace::Byte(byte) => FilePlace::Byte(byte + by),
            FilePlace::Whole => FilePlace::Byte(by),
            line @ FilePlace::Line(_) => line,
        };
        self
    }

    /// The file; none where bytes were read.
    #[must_use]
    pub fn path(&self) -> Option<&Path> {
        self.path.as_deref()
    }

    /// Where in it.
    #[must_use]
    pub fn place(&self) -> FilePlace {
        self.place
    }

    /// What is wrong, with the values that a caller can act on.
    #[must_use]
    pub fn cause(&self) -> &FileCause {
        &self.cause
    }
}

impl From<FileCause> for ExchangeError {
    fn from(cause: FileCause) -> Self {
        Self::new(FilePlace::Whole, cause)
    }
}

impl From<io::Error> for ExchangeError {
    /// Files are read in one go: what fails on the way is writing.
    fn from(source: io::Error) -> Self {
        FileCause::Unwritable { source }.into()
    }
}

impl fmt::Display for ExchangeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(path) = &self.path {
            write!(f, "{}: ", path.display())?;
        }
        match self.place {
            FilePlace::Whole => {}
            FilePlace::Line(line) => write!(f, "line {line}: ")?,
            FilePlace::Byte(byte) => write!(f, "byte {byte}: ")?,
        }
        write!(f, "{}", self.cause)
    }
}

impl std::error::Error for ExchangeError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        std::error::Error::source(&*self.cause)
    }
}
