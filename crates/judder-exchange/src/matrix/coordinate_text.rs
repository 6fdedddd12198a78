//! Coordinates of Abaqus: `*MATRIX OUTPUT, FORMAT=COORDINATE`.

use super::{ENTRIES, ENTRY_BYTES, Matrix, Symmetry};
use crate::cause::FileCause;
use crate::door::ask;
use crate::error::ExchangeError;
use crate::text::{count, number, text_of};
use judder_memory::MemoryBudget;

/// Reads a row, a column and an entry a line, rows and columns from 1. The file does not say its size: it is that of the
/// largest row or column, and the matrix is square.
pub(super) fn read_coordinates(bytes: &[u8], budget: MemoryBudget) -> Result<Matrix, ExchangeError> {
    let mut entries = Vec::new();
    let mut size = 0;
    let lines = bytes.iter().filter(|byte| **byte == b'\n').count() as u128;
    ask(budget, ENTRIES, lines * ENTRY_BYTES)?;
    for (index, line) in text_of(bytes)?.lines().enumerate() {
        let line = line.trim();
        if line.is_empty() || line.starts_with("**") {
            continue;
        }
        let entry = entry(line).map_err(|cause| ExchangeError::at_line(index + 1, cause))?;
        size = size.max(entry.0 + 1).max(entry.1 + 1);
        entries.push(entry);
    }
    if entries.is_empty() {
        return Err(foreign(String::from("it is empty")).into());
    }
    Matrix::from_stored(size, size, entries, Symmetry::General)
}

fn entry(line: &str) -> Result<(usize, usize, f64), FileCause> {
    let words: Vec<&str> =
        line.split(|c: char| c == ',' || c.is_whitespace()).filter(|word| !word.is_empty()).collect();
    match words.as_slice() {
        [row, column, value] => Ok((
            count(row, 1, "a row")? - 1,
            count(column, 1, "a column")? - 1,
            number(value, "an entry of the matrix")?,
        )),
        [_, _, _, _, _] => Err(foreign(String::from(
            "its lines have five entries, as those of FORMAT=MATRIX INPUT, which names nodes",
        ))),
        words => Err(FileCause::WrongEntries {
            what: "a line of coordinates",
            expected: "a row, a column and a number",
            found: words.len(),
        }),
    }
}

fn foreign(found: String) -> FileCause {
    FileCause::Foreign {
        format: "matrix in coordinates",
        found,
        remedy: "write it with *MATRIX OUTPUT, FORMAT=COORDINATE, or as Matrix Market with its header line",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &[u8]) -> Result<Matrix, ExchangeError> {
        read_coordinates(text, MemoryBudget::of_bytes(1 << 20))
    }

    #[test]
    fn rows_columns_and_entries_are_read() {
        let matrix = read(b"  1  1  2.0D+00\n 2, 1, -1.\n1 2 -1\n2 2 2e0\n").unwrap();
        assert_eq!(matrix.entries, [(0, 0, 2.0), (0, 1, -1.0), (1, 0, -1.0), (1, 1, 2.0)]);
    }

    #[test]
    fn wrong_lines_are_named() {
        let message = |text: &str| read(text.as_bytes()).unwrap_err().to_string();
        assert!(message("1 1 1\n1 1").starts_with("line 2: a line of coordinates takes a row"));
        assert!(message("1,1,1,1,2.0").contains("FORMAT=COORDINATE"));
        assert!(message("0 1 2.0").contains("`0` is no whole number from 1 on (a row)"));
        assert!(message("1 1 nan").contains("`nan` is no finite number"));
        assert!(message("1 999999999999999999 1").contains("at most"));
        assert!(message("").contains("it is empty"));
    }
}
