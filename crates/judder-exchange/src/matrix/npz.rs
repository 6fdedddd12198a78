//! Archives of `scipy.sparse.save_npz`.

use super::{ENTRY_BYTES, Matrix, Symmetry};
use crate::cause::FileCause;
use crate::door::check_unpacked;
use crate::error::ExchangeError;
use crate::npy::{NpyArray, NpyError, NpyHeader};
use crate::quoted::quoted;
use judder_memory::MemoryBudget;
use std::io::Cursor;
use zip::ZipArchive;
use zip::result::ZipError;

const ARCHIVE: &str = "the archive";
const FORMAT: &str = "sparse matrix of SciPy";
const REMEDY: &str = "write it with scipy.sparse.save_npz";

/// The arrays of an archive, unpacked.
struct ArchiveArrays<'a> {
    archive: ZipArchive<Cursor<&'a [u8]>>,
    budget: MemoryBudget,
}

/// Bytes that a number of the matrix takes while it is read, beside its entry: as a value and as a place.
const VALUE_BYTES: u128 = 16;
/// Bytes that any number takes while it is read: as it is and as what it may not be.
const COUNT_BYTES: u128 = 24;

/// Reads CSR, CSC, BSR, COO and DIA matrices.
pub(super) fn read_npz(bytes: &[u8], budget: MemoryBudget) -> Result<Matrix, ExchangeError> {
    let archive = ZipArchive::new(Cursor::new(bytes)).map_err(|_| not_opened(bytes))?;
    let mut arrays = ArchiveArrays { archive, budget };
    let shape = arrays.counts("shape")?;
    let [rows, columns] = shape.as_slice() else {
        return Err(inconsistent(format!("its shape has {} numbers; a matrix has two", shape.len())));
    };
    let (rows, columns) = (*rows, *columns);
    let format = arrays.format()?;
    let entries = match format.as_str() {
        "csr" => compressed(&mut arrays, rows, columns)?,
        "csc" => turned(compressed(&mut arrays, columns, rows)?),
        "bsr" => blocks(&mut arrays, rows, columns)?,
        "coo" => coordinates(&mut arrays)?,
        "dia" => diagonals(&mut arrays, rows, columns)?,
        other => {
            return Err(FileCause::Unsupported {
                what: "the storage of the matrix",
                found: format!("`{}`", quoted(other)),
                read: "csr, csc, bsr, coo or dia; save it as matrix.tocsr()",
            }
            .into());
        }
    };
    if let Some((row, column, _)) = entries.iter().find(|(i, j, _)| *i >= rows || *j >= columns) {
        let (row, column) = (row.saturating_add(1), column.saturating_add(1));
        return Err(FileCause::OutsideMatrix { row, column, rows, columns }.into());
    }
    match entries.iter().find(|(_, _, value)| !value.is_finite()) {
        Some((row, column, value)) => {
            let (text, what) = (format!("{value} at row {row}, column {column}"), "an entry of the matrix");
            Err(FileCause::NotANumber { text, what }.into())
        }
        None => Matrix::from_stored(rows, columns, entries, Symmetry::General),
    }
}

type MatrixTriplets = Vec<(usize, usize, f64)>;

fn inconsistent(problem: String) -> ExchangeError {
    FileCause::Inconsistent { what: "the sparse matrix", problem }.into()
}

impl ArchiveArrays<'_> {
    /// An array; it unpacks no further than its own header says, and where that is not more than the archive can hold and the budget has.
    fn array(&mut self, name: &str) -> Result<NpyArray, ExchangeError> {
        let mut file = self.archive.by_name(&format!("{name}.npy")).map_err(|error| not_had(name, &error))?;
        let header = NpyHeader::read(&mut file).map_err(refused)?;
        let each = if name == "data" { VALUE_BYTES + ENTRY_BYTES } else { COUNT_BYTES };
        let needed = header.said as u128 + header.count as u128 * each;
        check_unpacked(header.said as u64, file.compressed_size(), self.budget, needed)?;
        Ok(header.read_numbers(&mut file).map_err(refused)?)
    }

    fn floats(&mut self, name: &str) -> Result<Vec<f64>, ExchangeError> {
        Ok(self.array(name)?.floats().map_err(refused)?)
    }

    fn counts(&mut self, name: &str) -> Result<Vec<usize>, ExchangeError> {
        Ok(self.array(name)?.counts().map_err(refused)?)
    }

    /// The name of the storage: bytes, or characters of four bytes.
    fn format(&mut self) -> Result<String, ExchangeError> {
        let array = self.array("format")?;
        Ok(array.data.iter().filter(|byte| **byte != 0).map(|byte| char::from(*byte)).collect())
    }
}

/// What is wrong with bytes that do not open as an archive.
fn not_opened(bytes: &[u8]) -> FileCause {
    /// What the first file of an archive begins with.
    const BEGINNING: &[u8] = b"PK\x03\x04";
    // what is cut within it, or before it, begins as it does too
    if bytes.starts_with(BEGINNING) || BEGINNING.starts_with(bytes) {
        let problem = "the list of its arrays, which ends it, is missing or broken; was the file cut off?";
        return FileCause::Damaged { what: ARCHIVE, problem: problem.to_owned() };
    }
    FileCause::Foreign {
        format: FORMAT,
        found: "it does not begin as an archive (ZIP) does".to_owned(),
        remedy: REMEDY,
    }
}

/// That an array of an archive is not to be had.
fn not_had(name: &str, error: &ZipError) -> FileCause {
    let found = match error {
        ZipError::FileNotFound => format!("its archive has no array `{name}`"),
        ZipError::CompressionMethodNotSupported(_) => {
            format!("its array `{name}` is packed by another method than DEFLATE")
        }
        ZipError::InvalidPassword | ZipError::UnsupportedArchive(_) => {
            format!("its array `{name}` is encrypted, or packed in another way than NumPy's")
        }
        _ => {
            let problem = format!("where its array `{name}` should begin stands something else");
            return FileCause::Damaged { what: ARCHIVE, problem };
        }
    };
    FileCause::Foreign { format: FORMAT, found, remedy: REMEDY }
}

/// An array that cannot be used.
fn refused(source: NpyError) -> FileCause {
    match source {
        NpyError::Numbers { found } => FileCause::Unsupported {
            what: "the type of a NumPy array",
            found: format!("`{found}`"),
            read: "real and whole numbers of up to eight bytes; write real and imaginary parts as two matrices",
        },
        source => FileCause::Array { source },
    }
}

fn turned(entries: MatrixTriplets) -> MatrixTriplets {
    entries.into_iter().map(|(row, column, value)| (column, row, value)).collect()
}

/// Lines (rows or columns), each with its places and numbers.
fn compressed(
    arrays: &mut ArchiveArrays<'_>,
    lines: usize,
    length: usize,
) -> Result<MatrixTriplets, ExchangeError> {
    let values = arrays.floats("data")?;
    let starts = pointers(arrays, lines, values.len())?;
    let places = arrays.counts("indices")?;
    if places.len() != values.len() {
        return Err(inconsistent(format!("{} indices for {} numbers", places.len(), values.len())));
    }
    if let Some(place) = places.iter().find(|place| **place >= length) {
        return Err(inconsistent(format!("an index is {place} (from 0), of {length}")));
    }
    let of_line = |line: usize| (starts[line]..starts[line + 1]).map(move |k| (line, k));
    Ok((0..lines).flat_map(of_line).map(|(line, k)| (line, places[k], values[k])).collect())
}

/// Where each line begins and ends: ascending, within the numbers.
fn pointers(
    arrays: &mut ArchiveArrays<'_>,
    lines: usize,
    numbers: usize,
) -> Result<Vec<usize>, ExchangeError> {
    let starts = arrays.counts("indptr")?;
    let ascending = starts.windows(2).all(|pair| pair[0] <= pair[1]);
    if Some(starts.len()) != lines.checked_add(1) || !ascending || starts.last() > Some(&numbers) {
        return Err(inconsistent(format!(
            "its {} pointers do not ascend to the {numbers} entries of {lines} lines",
            starts.len()
        )));
    }
    Ok(starts)
}

/// Dense blocks at places of a coarser matrix.
fn blocks(
    arrays: &mut ArchiveArrays<'_>,
    rows: usize,
    columns: usize,
) -> Result<MatrixTriplets, ExchangeError> {
    let array = arrays.array("data")?;
    let (values, shape) = (array.floats().map_err(refused)?, array.shape);
    let [count, height @ (1..), width @ (1..)] = *shape.as_slice() else {
        return Err(inconsistent(format!("its blocks have the shape {shape:?}")));
    };
    if array.fortran_order || !rows.is_multiple_of(height) || !columns.is_multiple_of(width) {
        let problem =
            format!("blocks of {height} × {width}, or their order, do not fit into {rows} × {columns}");
        return Err(inconsistent(problem));
    }
    let starts = pointers(arrays, rows / height, count)?;
    let places = arrays.counts("indices")?;
    if places.len() != count || places.iter().any(|place| *place >= columns / width) {
        return Err(inconsistent(format!("its {} indices do not fit its {count} blocks", places.len())));
    }
    let mut entries = Vec::with_capacity(values.len());
    for (line, pair) in starts.windows(2).enumerate() {
        for block in pair[0]..pair[1] {
            let numbers = values[block * height * width..].iter().take(height * width).enumerate();
            entries
                .extend(numbers.map(|(k, value)| {
                    (line * height + k / width, places[block] * width + k % width, *value)
                }));
        }
    }
    Ok(entries)
}

fn coordinates(arrays: &mut ArchiveArrays<'_>) -> Result<MatrixTriplets, ExchangeError> {
    let values = arrays.floats("data")?;
    let (rows, columns) = match arrays.counts("row") {
        Ok(rows) => (rows, arrays.counts("col")?),
        // arrays of any dimension, since SciPy 1.13
        Err(error) => split_coordinates(arrays).map_err(|_| error)?,
    };
    if rows.len() != values.len() || columns.len() != values.len() {
        let problem =
            format!("{} rows and {} columns for {} numbers", rows.len(), columns.len(), values.len());
        return Err(inconsistent(problem));
    }
    Ok(rows.into_iter().zip(columns).zip(values).map(|((row, column), value)| (row, column, value)).collect())
}

/// Rows and columns in one array.
fn split_coordinates(arrays: &mut ArchiveArrays<'_>) -> Result<(Vec<usize>, Vec<usize>), ExchangeError> {
    let coords = arrays.counts("coords")?;
    let (rows, columns) = coords.split_at(coords.len() / 2);
    Ok((rows.to_vec(), columns.to_vec()))
}

/// A_ij = data[k, j] with i = j − offset_k.
fn diagonals(
    arrays: &mut ArchiveArrays<'_>,
    rows: usize,
    columns: usize,
) -> Result<MatrixTriplets, ExchangeError> {
    let array = arrays.array("data")?;
    let (values, shape) = (array.floats().map_err(refused)?, array.shape);
    let offsets = arrays.floats("offsets")?;
    let [count, length] = *shape.as_slice() else {
        return Err(inconsistent(format!("its diagonals have the shape {shape:?}")));
    };
    if array.fortran_order || count != offsets.len() {
        return Err(inconsistent(format!(
            "{} offsets for {count} diagonals, or these by columns",
            offsets.len()
        )));
    }
    let mut entries = Vec::new();
    for (k, offset) in offsets.iter().enumerate() {
        for column in 0..length.min(columns) {
            let (row, value) = (column as f64 - offset, values[k * length + column]);
            if row >= 0.0 && row < rows as f64 && value != 0.0 {
                entries.push((row as usize, column, value));
            }
        }
    }
    Ok(entries)
}
