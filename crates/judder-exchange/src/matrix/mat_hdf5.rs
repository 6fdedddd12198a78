//! MATLAB's files of version 7.3: HDF5 behind a header of 512 bytes.
//!
//! MathWorks does not describe the layout; it is that of `mat73` and `hdf5storage`: the class of a variable is its attribute
//! `MATLAB_class`; a full matrix is a dataset with its dimensions turned around; a sparse one a group of `data`, `ir` and `jc`, whose
//! attribute `MATLAB_sparse` says the rows; a complex one has numbers of two fields.

use super::Matrix;
use super::mat_matrix::{SparseColumns, ask_for_numbers, complex, full_entries, only_matrix, whole_matrix};
use crate::bytes::StoredNumber;
use crate::cause::FileCause;
use crate::door::{ask, check_unpacked};
use crate::error::ExchangeError;
use hdf5_reader::group::Group;
use hdf5_reader::{Attribute, ByteOrder, Dataset, Datatype, Hdf5File, OpenOptions};
use judder_memory::MemoryBudget;

/// Classes of MATLAB whose arrays are numbers.
const NUMERIC: [&str; 11] =
    ["double", "single", "int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64", "logical"];
/// How many entries of the file are looked at: a damaged one may list the same without end.
const MOST_VARIABLES: usize = 10_000;

/// Whether a file is of this version.
pub(super) fn is_hdf5(bytes: &[u8]) -> bool {
    bytes.starts_with(b"\x89HDF") || bytes.starts_with(b"MATLAB 7.3")
}

/// What the numbers of a file may take.
#[derive(Clone, Copy)]
struct HdfRoom {
    /// Bytes of the file.
    file: u64,
    budget: MemoryBudget,
}

/// Reads the one real matrix, sparse or full, of a file; what is no matrix of numbers is passed over.
pub(super) fn read_mat_hdf5(bytes: &[u8], budget: MemoryBudget) -> Result<Matrix, ExchangeError> {
    let room = HdfRoom { file: bytes.len() as u64, budget };
    // nothing is read twice
    let options = OpenOptions { chunk_cache_bytes: 0, ..OpenOptions::default() };
    let file = Hdf5File::from_bytes_with_options(bytes, options).map_err(damaged)?;
    let (groups, datasets) = file.root_group().and_then(|root| root.members()).map_err(damaged)?;
    if groups.len() + datasets.len() > MOST_VARIABLES {
        let (what, said) = ("variables", groups.len() + datasets.len());
        return Err(FileCause::TooMany { what, said, left: bytes.len(), room: MOST_VARIABLES }.into());
    }
    let mut found = Vec::new();
    for dataset in &datasets {
        found.extend(full(dataset, room)?.map(|matrix| (dataset.name().to_owned(), matrix)));
    }
    for group in &groups {
        found.extend(sparse(group, room)?.map(|matrix| (group.name().to_owned(), matrix)));
    }
    only_matrix(found)
}

fn damaged(error: hdf5_reader::error::Error) -> FileCause {
    FileCause::Damaged { what: "the HDF5 file", problem: error.to_string() }
}

/// Whether the class of a variable is one of numbers.
fn is_numeric(attributes: &[Attribute]) -> bool {
    let class = attributes.iter().find(|attribute| attribute.name == "MATLAB_class");
    let class = class.and_then(|attribute| attribute.read_string().ok());
    class.is_some_and(|class| NUMERIC.contains(&class.trim_end_matches('\0')))
}

/// The matrix in a dataset; none where it is no matrix of numbers.
fn full(dataset: &Dataset, room: HdfRoom) -> Result<Option<Matrix>, ExchangeError> {
    let attributes = dataset.attributes();
    let is_empty = attributes.iter().any(|attribute| attribute.name == "MATLAB_empty");
    let [columns, rows] = *dataset.shape() else { return Ok(None) };
    if !is_numeric(&attributes) || is_empty {
        return Ok(None);
    }
    let (rows, columns) = (whole(rows)?, whole(columns)?);
    let values = HdfNumbers::of(dataset, room)?.floats();
    let entries = full_entries(&values, rows, columns, room.budget)?;
    Ok(Some(whole_matrix(rows, columns, entries)?))
}

/// The sparse matrix in a group; none where it is none.
fn sparse(group: &Group, room: HdfRoom) -> Result<Option<Matrix>, ExchangeError> {
    let attributes = group.attributes().map_err(damaged)?;
    let rows = attributes.iter().find(|attribute| attribute.name == "MATLAB_sparse");
    let Some(rows) = rows.filter(|_| is_numeric(&attributes)) else { return Ok(None) };
    let rows = whole(rows.read_scalar::<u64>().map_err(damaged)?)?;
    let part = |name: &str| group.dataset(name).map_err(damaged);
    let starts = HdfNumbers::of(&part("jc")?, room)?.counts()?;
    let Some(columns) = starts.len().checked_sub(1) else { return Ok(None) };
    // without entries MATLAB writes neither rows nor numbers
    let (places, values) = if starts[columns] == 0 {
        (Vec::new(), Vec::new())
    } else {
        let data = part("data")?;
        let count = data.num_elements().map_err(damaged)?;
        ask_for_numbers(room.budget, whole(count)?)?;
        (HdfNumbers::of(&part("ir")?, room)?.counts()?, HdfNumbers::of(&data, room)?.floats())
    };
    let entries = SparseColumns { places, starts, values }.entries(rows, columns)?;
    Ok(Some(whole_matrix(rows, columns, entries)?))
}

fn whole(size: u64) -> Result<usize, FileCause> {
    let problem = || format!("{size} is larger than any memory");
    usize::try_from(size).map_err(|_| FileCause::Inconsistent { what: "a size", problem: problem() })
}

/// The numbers of a dataset as they are stored.
struct HdfNumbers {
    stored: StoredNumber,
    big_endian: bool,
    bytes: Vec<u8>,
}

impl HdfNumbers {
    /// Reads them, where the file can hold them and the budget has room for them.
    fn of(dataset: &Dataset, room: HdfRoom) -> Result<Self, FileCause> {
        let (stored, order) = match dataset.dtype() {
            Datatype::FloatingPoint { size: size @ (4 | 8), byte_order } => {
                (StoredNumber::Float(usize::from(*size)), *byte_order)
            }
            Datatype::FixedPoint { size: size @ 1..=8, signed, byte_order } => {
                let size = usize::from(*size);
                (if *signed { StoredNumber::Signed(size) } else { StoredNumber::Unsigned(size) }, *byte_order)
            }
            Datatype::Compound { .. } => return Err(complex(dataset.name())),
            other => {
                return Err(FileCause::Unsupported {
                    what: "the type of the numbers",
                    found: format!("{other:?}"),
                    read: "real and whole numbers of up to eight bytes",
                });
            }
        };
        let count = dataset.num_elements().map_err(damaged)?;
        let size = stored.size() as u64;
        if let Some(chunk) = dataset.chunks() {
            // a chunk is unpacked as a whole, however little of it is in the array
            let numbers = chunk.iter().fold(1_u128, |count, side| count.saturating_mul(u128::from(*side)));
            ask(room.budget, "a chunk of an array", numbers.saturating_mul(u128::from(2 * size)))?;
        }
        // the bytes, and the numbers that are made of them
        let needed = u128::from(count) * u128::from(size + 16);
        check_unpacked(count.saturating_mul(size), room.file, room.budget, needed)?;
        let bytes = dataset.read_raw_bytes().map_err(damaged)?;
        Ok(Self { stored, big_endian: order == ByteOrder::BigEndian, bytes })
    }

    fn floats(&self) -> Vec<f64> {
        self.stored.floats(&self.bytes, self.big_endian)
    }

    fn counts(&self) -> Result<Vec<usize>, FileCause> {
        let counts = self.stored.counts(&self.bytes, self.big_endian);
        counts.into_iter().collect::<Option<Vec<usize>>>().ok_or_else(|| {
            let problem = String::from("a number is negative or not whole where a count is needed");
            FileCause::Inconsistent { what: "the sparse matrix", problem }
        })
    }
}
