//! Tables of numbers, as signals over time.

use crate::fields::{lines_of_fields, parted};
use thiserror::Error;

/// A column of a table.
#[derive(Debug, Clone, PartialEq)]
pub struct TableColumn {
    /// What its unit is, in brackets behind its name; none where there are no brackets.
    pub unit: Option<String>,
    /// Its numbers, finite.
    pub values: Vec<f64>,
}

/// Why a table of numbers cannot be used. Lines are those of the file, counted from 1.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum NumberTableError {
    /// No numbers.
    #[error("there are no numbers; a header line such as `{expected}` and lines of numbers are needed")]
    Empty {
        /// What the header could be.
        expected: String,
    },
    /// A header that is none.
    #[error("line {line} begins with the number {found}, but must be a header such as `{expected}`")]
    NoHeader {
        /// The first line.
        line: usize,
        /// What it begins with.
        found: String,
        /// What the header could be.
        expected: String,
    },
    /// A line with more or fewer fields than there are columns.
    #[error("line {line} has {found} fields, where {columns} are needed, as in `{expected}`")]
    Fields {
        /// The line.
        line: usize,
        /// Its fields.
        found: usize,
        /// How many there must be.
        columns: usize,
        /// What the header could be.
        expected: String,
    },
    /// What is no number.
    #[error("`{found}` in line {line} is no finite number with a decimal point")]
    Value {
        /// The line.
        line: usize,
        /// What was found.
        found: String,
    },
}

/// Reads a table of text with one header line and so many columns.
///
/// - The header names the columns, each with its unit in brackets, as in `time [s],force [N]`; the columns are known by their order.
/// - Fields are separated by semicolons, tabs or commas, whichever the header has, in this order. Decimal points.
/// - Empty lines and lines that begin with `#` are left out.
///
/// # Errors
/// [`NumberTableError`] with the line; `expected` is a header as messages show it.
pub fn read_number_table<const N: usize>(
    text: &str,
    expected: &str,
) -> Result<[TableColumn; N], NumberTableError> {
    let expected = || expected.to_owned();
    let mut lines = lines_of_fields(text);
    let (line, header) = lines.next().ok_or_else(|| NumberTableError::Empty { expected: expected() })?;
    if let Some(found) = header.first().filter(|first| first.parse::<f64>().is_ok()) {
        return Err(NumberTableError::NoHeader { line, found: (*found).to_owned(), expected: expected() });
    }
    let as_many = |line: usize, found: usize| match found == N {
        true => Ok(()),
        false => Err(NumberTableError::Fields { line, found, columns: N, expected: expected() }),
    };
    as_many(line, header.len())?;
    let mut columns: [TableColumn; N] = std::array::from_fn(|k| TableColumn {
        unit: parted(header[k]).1.map(str::to_owned),
        values: Vec::new(),
    });
    for (line, fields) in lines {
        as_many(line, fields.len())?;
        for (column, field) in columns.iter_mut().zip(fields) {
            let value = field.parse().ok().filter(|value: &f64| value.is_finite());
            let wrong = || NumberTableError::Value { line, found: field.to_owned() };
            column.values.push(value.ok_or_else(wrong)?);
        }
    }
    match columns.iter().all(|column| column.values.is_empty()) {
        true => Err(NumberTableError::Empty { expected: expected() }),
        false => Ok(columns),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEADER: &str = "time [s],force [N]";

    fn read(text: &str) -> Result<[TableColumn; 2], NumberTableError> {
        read_number_table(text, HEADER)
    }

    #[test]
    fn columns_are_read_in_their_order() {
        let text = "\u{feff}# measured\n\ntime (ms); \"factor\"\n0;1\n 2.5 ; -3e2\n";
        let [time, factor] = read(text).unwrap();
        assert_eq!((time.unit.as_deref(), time.values), (Some("ms"), vec![0.0, 2.5]));
        assert_eq!((factor.unit, factor.values), (None, vec![1.0, -300.0]));
    }

    #[test]
    fn what_is_no_table_is_refused_with_its_line() {
        let refused = |text: &str| read(text).unwrap_err().to_string();
        let needed = "a header line such as `time [s],force [N]` and lines of numbers are needed";
        assert_eq!(refused("# nothing\n"), format!("there are no numbers; {needed}"));
        assert!(refused(HEADER).contains(needed));
        assert_eq!(
            refused("0,1\n1,2\n"),
            "line 1 begins with the number 0, but must be a header such as `time [s],force [N]`"
        );
        assert_eq!(
            refused("time [s],a,b\n0,1,2"),
            "line 1 has 3 fields, where 2 are needed, as in `time [s],force [N]`"
        );
        assert!(refused("time [s],a\n0,1\n\n2").contains("line 4 has 1 fields"));
        for wrong in ["x", "nan", "inf", "1,5", ""] {
            let text = format!("time [s]; force [N]\n0;1\n1;{wrong}");
            assert_eq!(
                refused(&text),
                format!("`{wrong}` in line 3 is no finite number with a decimal point")
            );
        }
    }
}
