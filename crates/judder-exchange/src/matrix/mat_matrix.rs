//! What MATLAB's two file formats have in common: columns of a sparse matrix, columns of a full one, one matrix a file.

use super::{ENTRIES, ENTRY_BYTES, Matrix, Symmetry};
use crate::cause::FileCause;
use crate::door::ask;
use crate::error::ExchangeError;
use crate::quoted::quoted;
use judder_memory::MemoryBudget;

/// Bytes that a number takes while it is read beside its entry: as a value, as a row, and as the count that a row is first.
const NUMBER_BYTES: u128 = 32;

/// Entries, each with its row and column from 0.
pub(super) type MatEntries = Vec<(usize, usize, f64)>;

/// A sparse matrix as MATLAB keeps it.
pub(super) struct SparseColumns {
    /// The row of each entry, from 0.
    pub(super) places: Vec<usize>,
    /// Where each column begins, and the end of the last.
    pub(super) starts: Vec<usize>,
    pub(super) values: Vec<f64>,
}

/// Asks for what so many numbers of a sparse matrix will take.
pub(super) fn ask_for_numbers(budget: MemoryBudget, count: usize) -> Result<(), FileCause> {
    ask(budget, ENTRIES, count as u128 * (NUMBER_BYTES + ENTRY_BYTES))
}

impl SparseColumns {
    /// The entries of a matrix of this size.
    pub(super) fn entries(&self, rows: usize, columns: usize) -> Result<MatEntries, FileCause> {
        let Self { places, starts, values } = self;
        let inconsistent = |problem: String| FileCause::Inconsistent { what: "the sparse matrix", problem };
        let ascending = starts.windows(2).all(|pair| pair[0] <= pair[1]);
        if Some(starts.len()) != columns.checked_add(1) || !ascending {
            return Err(inconsistent(format!(
                "its {} column pointers do not ascend over {columns} columns",
                starts.len()
            )));
        }
        // of both arrays more may be stored than is used
        let used = starts[columns];
        if places.len().min(values.len()) < used {
            let (rows, values) = (places.len(), values.len());
            return Err(inconsistent(format!(
                "its columns hold {used} entries, stored are {rows} rows and {values} numbers"
            )));
        }
        if let Some(row) = places[..used].iter().find(|row| **row >= rows) {
            return Err(inconsistent(format!("a row is {row} (from 0), of {rows}")));
        }
        let of_column = |column: usize| (starts[column]..starts[column + 1]).map(move |k| (column, k));
        Ok((0..columns).flat_map(of_column).map(|(column, k)| (places[k], column, values[k])).collect())
    }
}

/// The entries of a full matrix, whose numbers stand column by column.
pub(super) fn full_entries(
    values: &[f64],
    rows: usize,
    columns: usize,
    budget: MemoryBudget,
) -> Result<MatEntries, FileCause> {
    if rows.checked_mul(columns) != Some(values.len()) {
        let problem = format!("{rows} × {columns} numbers are said, {} are there", values.len());
        return Err(FileCause::Inconsistent { what: "the full matrix", problem });
    }
    let filled = || values.iter().enumerate().filter(|(_, value)| **value != 0.0);
    ask(budget, ENTRIES, filled().count() as u128 * ENTRY_BYTES)?;
    Ok(filled().map(|(k, value)| (k % rows, k / rows, *value)).collect())
}

/// The matrix of these entries.
pub(super) fn whole_matrix(
    rows: usize,
    columns: usize,
    entries: MatEntries,
) -> Result<Matrix, ExchangeError> {
    match entries.iter().find(|(_, _, value)| !value.is_finite()) {
        Some((row, column, value)) => {
            let text = format!("{value} at row {}, column {}", row + 1, column + 1);
            Err(FileCause::NotANumber { text, what: "an entry of the matrix" }.into())
        }
        None => Matrix::from_stored(rows, columns, entries, Symmetry::General),
    }
}

/// A complex matrix is refused by its name.
pub(super) fn complex(name: &str) -> FileCause {
    FileCause::Unsupported {
        what: "the matrix",
        found: format!("complex (`{}`)", quoted(name)),
        read: "a real one; save real and imaginary parts as two matrices",
    }
}

/// The one matrix that was found.
pub(super) fn only_matrix(mut found: Vec<(String, Matrix)>) -> Result<Matrix, ExchangeError> {
    match found.len() {
        1 => Ok(found.swap_remove(0).1),
        0 => Err(foreign("it holds no matrix of numbers").into()),
        _ => {
            let names: Vec<&str> = found.iter().map(|(name, _)| name.as_str()).collect();
            Err(FileCause::Unsupported {
                what: "the content",
                found: format!("{} matrices ({})", names.len(), quoted(&names.join(", "))),
                read: "one matrix a file",
            }
            .into())
        }
    }
}

pub(super) fn foreign(found: &str) -> FileCause {
    FileCause::Foreign {
        format: "MATLAB file",
        found: found.to_owned(),
        remedy: "save one sparse or full matrix with save(…, '-v7') or scipy.io.savemat",
    }
}
