//! Columns of tables of a case: what is wrong with their numbers, said as the case or its file writes them.

use crate::number_columns::ColumnFile;
use judder_keys::dimension::Dimension;
use judder_keys::document::{Data, Node};
use judder_keys::error::{Fault, Place};
use judder_keys::problem::{Placed, Problem};
use judder_keys::quantity::WrittenUnit;
use judder_keys::section::Section;
use judder_numerics::words::plain;
use thiserror::Error;

/// A column of a table.
pub(crate) struct WrittenColumn<'a> {
    /// What its numbers are.
    what: &'static str,
    numbers: &'a [f64],
    source: ColumnSource<'a>,
    place: Place,
}

/// Where its numbers are written.
enum ColumnSource<'a> {
    /// Each in the case.
    List(&'a [Node]),
    /// In a file, in this unit.
    File(WrittenUnit),
}

/// What is wrong with numbers of a table.
#[derive(Debug, Clone, PartialEq, Error)]
enum TableProblem {
    /// Numbers that do not ascend.
    #[error("{what} must ascend, but {number} follows {before}")]
    NotAscending { what: &'static str, before: String, number: String },
    /// A number below zero.
    #[error("{what} must be zero or positive, but one is {number}")]
    Negative { what: &'static str, number: String },
    /// No zero among them.
    #[error("{what} must have zero among them, but the first is {number}")]
    NoZero { what: &'static str, number: String },
    /// What belongs to the zero of the other column.
    #[error("{what} must be zero at {zero}, but are {number}")]
    NotZero { what: &'static str, zero: String, number: String },
}

impl Problem for TableProblem {
    fn kind(&self) -> &'static str {
        "Table"
    }

    fn label(&self) -> &'static str {
        match self {
            Self::NotAscending { .. } => "not ascending",
            Self::Negative { .. } => "below zero",
            Self::NoZero { .. } => "without a zero",
            Self::NotZero { .. } => "not zero there",
        }
    }

    fn help(&self) -> Option<String> {
        let help = match self {
            Self::NotAscending { .. } => "list them from the smallest to the largest, none twice",
            Self::Negative { .. } => return None,
            Self::NoZero { .. } | Self::NotZero { .. } => {
                "reckon the closure from where the sides just touch: there nothing presses"
            }
        };
        Some(help.to_owned())
    }
}

impl<'a> WrittenColumn<'a> {
    /// The list under a key of a section, read as these numbers.
    pub(crate) fn of_list(section: &Section<'a>, key: &str, what: &'static str, numbers: &'a [f64]) -> Self {
        let items = match section.get(key).map(|node| &node.data) {
            Some(Data::List(items)) => items.as_slice(),
            _ => &[],
        };
        Self { what, numbers, source: ColumnSource::List(items), place: section.place_of(&[key]) }
    }

    /// A column of the file that a section names.
    pub(crate) fn of_file(
        section: &Section<'a>,
        file: &'a ColumnFile,
        column: usize,
        what: &'static str,
    ) -> Self {
        let unit = file.units[column].as_deref().and_then(WrittenUnit::called);
        let unit = unit.unwrap_or_else(|| WrittenUnit::si(Dimension::NUMBER));
        let place = section.place_of(&["file"]);
        Self { what, numbers: &file.columns[column], source: ColumnSource::File(unit), place }
    }

    /// A number as it is written.
    fn written(&self, index: usize) -> String {
        let number = self.numbers[index];
        match &self.source {
            ColumnSource::File(unit) => unit.text(number),
            ColumnSource::List(items) => match items.get(index).map(|node| &node.data) {
                Some(Data::Text(text)) => text.trim().to_owned(),
                _ => plain(number),
            },
        }
    }

    /// Refuses numbers that do not ascend.
    pub(crate) fn check_ascending(&self) -> Result<(), Fault> {
        let what = self.what;
        match self.numbers.windows(2).position(|pair| pair[1] <= pair[0]) {
            Some(index) => {
                let [before, number] = [index, index + 1].map(|own| self.written(own));
                Err(TableProblem::NotAscending { what, before, number }.at(self.place))
            }
            None => Ok(()),
        }
    }

    /// Refuses numbers below zero.
    pub(crate) fn check_not_negative(&self) -> Result<(), Fault> {
        match self.numbers.iter().position(|number| *number < 0.0) {
            Some(index) => {
                let number = self.written(index);
                Err(TableProblem::Negative { what: self.what, number }.at(self.place))
            }
            None => Ok(()),
        }
    }

    /// Refuses columns of which this one has no zero, or the other another number beside it.
    pub(crate) fn check_zero(&self, other: &Self) -> Result<(), Fault> {
        let Some(index) = self.numbers.iter().position(|number| *number == 0.0) else {
            let first = (!self.numbers.is_empty()).then(|| self.written(0));
            let no_zero = |number| TableProblem::NoZero { what: self.what, number }.at(self.place);
            return first.map_or(Ok(()), |number| Err(no_zero(number)));
        };
        match other.numbers.get(index) {
            Some(number) if *number != 0.0 => {
                let [zero, number] = [self, other].map(|column| column.written(index));
                Err(TableProblem::NotZero { what: other.what, zero, number }.at(other.place))
            }
            _ => Ok(()),
        }
    }
}
