//! What a spreadsheet wants.

use std::borrow::Cow;
use std::io;

use csv::Writer;
use serde::{Serialize, Serializer};

use crate::StoreError;

/// The cells of one column, top to bottom.
#[derive(Debug, Clone, PartialEq)]
pub enum Cells {
    /// Real numbers, written with the fewest digits that read back as the same number; NaN becomes an empty cell,
    /// infinities `inf` and `-inf`.
    F64(Vec<f64>),
    /// Whole numbers.
    I64(Vec<i64>),
    /// Words.
    Text(Vec<String>),
}

impl From<Vec<f64>> for Cells {
    fn from(cells: Vec<f64>) -> Self {
        Self::F64(cells)
    }
}

impl From<Vec<i64>> for Cells {
    fn from(cells: Vec<i64>) -> Self {
        Self::I64(cells)
    }
}

impl From<Vec<String>> for Cells {
    fn from(cells: Vec<String>) -> Self {
        Self::Text(cells)
    }
}

impl Cells {
    fn len(&self) -> usize {
        match self {
            Self::F64(cells) => cells.len(),
            Self::I64(cells) => cells.len(),
            Self::Text(cells) => cells.len(),
        }
    }
}

/// Columns of one length, each with a head `name [unit]`.
///
/// ```
/// use judder_store::Table;
/// let table = Table::new().column("velocity", "1", vec![1e-4, 1e-2])?.column("load", "N", vec![0.2, f64::NAN])?;
/// assert_eq!(table.rows(), 2);
/// # Ok::<(), judder_store::StoreError>(())
/// ```
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Table {
    columns: Vec<(String, Cells)>,
}

impl Table {
    /// No columns yet.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// With one more column; the unit goes into its head, unless it is `1` (dimensionless) or empty.
    ///
    /// # Errors
    /// A head that is taken; another number of rows than the columns before.
    pub fn column(mut self, name: &str, units: &str, cells: impl Into<Cells>) -> Result<Self, StoreError> {
        let cells = cells.into();
        let head = if matches!(units, "" | "1") { name.to_owned() } else { format!("{name} [{units}]") };
        if let Some(expected) = self.columns.first().map(|(_, first)| first.len())
            && expected != cells.len()
        {
            return Err(StoreError::ColumnLength { column: head, expected, found: cells.len() });
        }
        if self.columns.iter().any(|(taken, _)| *taken == head) {
            return Err(StoreError::Duplicate { what: "column", name: head });
        }
        self.columns.push((head, cells));
        Ok(self)
    }

    /// How many rows there are, the heads not counted.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.columns.first().map_or(0, |(_, cells)| cells.len())
    }

    /// The table as CSV: commas, line feeds, quotes where a cell needs them.
    ///
    /// # Errors
    /// None that a table in memory can meet.
    pub fn to_csv(&self) -> io::Result<Vec<u8>> {
        let mut writer = Writer::from_writer(Vec::new());
        writer.write_record(self.columns.iter().map(|(head, _)| guarded(head).into_owned()))?;
        for row in 0..self.rows() {
            writer.serialize(
                self.columns.iter().map(|(_, cells)| WrittenCell { cells, row }).collect::<Vec<_>>(),
            )?;
        }
        writer.into_inner().map_err(csv::IntoInnerError::into_error)
    }
}

/// One cell of a column.
struct WrittenCell<'a> {
    cells: &'a Cells,
    row: usize,
}

impl Serialize for WrittenCell<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.cells {
            Cells::F64(cells) => cells.get(self.row).filter(|value| !value.is_nan()).serialize(serializer),
            Cells::I64(cells) => cells.get(self.row).serialize(serializer),
            Cells::Text(cells) => cells.get(self.row).map(|text| guarded(text)).serialize(serializer),
        }
    }
}

/// A text that a spreadsheet would take for a formula after an apostrophe, by which it takes it for a text; numbers are numbers.
fn guarded(text: &str) -> Cow<'_, str> {
    let is_formula = text.starts_with(['=', '+', '-', '@', '\t', '\r']) && text.parse::<f64>().is_err();
    if is_formula { Cow::Owned(format!("'{text}")) } else { Cow::Borrowed(text) }
}
