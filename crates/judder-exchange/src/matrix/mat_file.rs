//! MATLAB's binary files of version 5, which are those of `-v6` and, compressed, of `-v7`.
//!
//! MathWorks, *MAT-File Format*, chapter 1.

use super::Matrix;
use super::mat_hdf5::{is_hdf5, read_mat_hdf5};
use super::mat_matrix::{
    SparseColumns, ask_for_numbers, complex, foreign, full_entries, only_matrix, whole_matrix,
};
use crate::bytes::{Bytes, StoredNumber};
use crate::cause::FileCause;
use crate::door::{ask, check_unpacked};
use crate::error::{ExchangeError, FilePlace};
use flate2::read::ZlibDecoder;
use judder_memory::MemoryBudget;
use std::io::Read;

const HEADER: usize = 128;

const ELEMENT: &str = "a data element";
/// Bytes of an element's type and size.
const TAG: u64 = 8;

/// Types of data elements.
const MATRIX: u32 = 14;
const COMPRESSED: u32 = 15;

/// Classes of arrays.
const SPARSE: u32 = 5;
/// From double (6) to the last integer (15).
const NUMERIC: std::ops::RangeInclusive<u32> = 6..=15;
const COMPLEX: u32 = 0x800;

/// A data element: its type and its bytes.
struct MatElement<'a> {
    kind: u32,
    data: &'a [u8],
    at: usize,
}

/// Reads the one real matrix, sparse or full, of a file of any version; what is no matrix of numbers is passed over.
pub(super) fn read_mat(bytes: &[u8], budget: MemoryBudget) -> Result<Matrix, ExchangeError> {
    if is_hdf5(bytes) {
        return read_mat_hdf5(bytes, budget);
    }
    let big_endian = check_header(bytes)?;
    let mut walk = Bytes::new(bytes, HEADER, big_endian);
    let mut found: Vec<(String, Matrix)> = Vec::new();
    while walk.left() > 0 {
        let start = walk.at();
        let element = element(&mut walk, false)?;
        let read = if element.kind == COMPRESSED {
            // places in what was packed mean nothing in the file: the element's own is told
            let at = element.at;
            let plain = unpacked(&element, big_endian, budget)?;
            let mut inner = Bytes::new(&plain, 0, big_endian);
            self::element(&mut inner, false)
                .and_then(|element| variable(&element, big_endian, budget))
                .map_err(|error| error.moved(FilePlace::Byte(at)))?
        } else {
            variable(&element, big_endian, budget).map_err(|error| error.shifted(element.at))?
        };
        found.extend(read);
        debug_assert!(walk.at() > start);
    }
    only_matrix(found)
}

/// Whether the file is big-endian.
fn check_header(bytes: &[u8]) -> Result<bool, ExchangeError> {
    match bytes.get(HEADER - 4..HEADER) {
        Some([0, 1, b'I', b'M']) => Ok(false),
        Some([1, 0, b'M', b'I']) => Ok(true),
        Some(_) => Err(foreign("its header is not that of version 5").into()),
        None => {
            Err(FileCause::Cut { what: "the header of 128 bytes", needed: HEADER, left: bytes.len() }.into())
        }
    }
}

/// The next element. Inside arrays each begins at a multiple of eight bytes, and short ones have tag and data in eight.
fn element<'a>(walk: &mut Bytes<'a>, aligned: bool) -> Result<MatElement<'a>, ExchangeError> {
    let what = ELEMENT;
    let first = walk.u32(what)?;
    let (small, kind) = (first >> 16, first & 0xffff);
    if small > 0 {
        let at = walk.at();
        let data = walk.take(4, what)?;
        let data = data.get(..small as usize).ok_or_else(|| {
            walk.error(FileCause::Inconsistent {
                what,
                problem: format!("{small} bytes are said to lie in four"),
            })
        })?;
        return Ok(MatElement { kind, data, at });
    }
    let size = walk.u32(what)? as usize;
    let at = walk.at();
    let data = walk.take(size, what)?;
    if aligned {
        // the last one of a file may lack its padding
        walk.take(size.next_multiple_of(8).saturating_sub(size).min(walk.left()), what)?;
    }
    Ok(MatElement { kind, data, at })
}

/// The element within a compressed one, with its tag: no more is unpacked than the tag says, and one byte to see that no more is
/// there, which also lets the checksum be compared.
fn unpacked(
    element: &MatElement<'_>,
    big_endian: bool,
    budget: MemoryBudget,
) -> Result<Vec<u8>, ExchangeError> {
    let damaged = |problem: String| {
        ExchangeError::at_byte(element.at, FileCause::Damaged { what: "a compressed element", problem })
    };
    let mut stream = ZlibDecoder::new(element.data);
    let mut unpack = |count: u64, plain: &mut Vec<u8>| {
        stream.by_ref().take(count).read_to_end(plain).map_err(|error| damaged(error.to_string()))
    };
    let mut plain = Vec::new();
    unpack(TAG, &mut plain)?;
    let mut tag = Bytes::new(&plain, 0, big_endian);
    let (first, size) = (tag.u32(ELEMENT), tag.u32(ELEMENT));
    // short elements lie in the tag itself
    let size = match (first, size) {
        (Ok(first), Ok(size)) if first >> 16 == 0 => u64::from(size),
        _ => 0,
    };
    // what is unpacked, and numbers of eight bytes that are made of it
    check_unpacked(size, element.data.len() as u64, budget, 2 * u128::from(size))
        .map_err(|cause| ExchangeError::at_byte(element.at, cause))?;
    unpack(size, &mut plain)?;
    if unpack(1, &mut plain)? > 0 {
        return Err(damaged(format!("it holds more than the {size} bytes that its tag says")));
    }
    Ok(plain)
}

/// The matrix in an element, with its name; none where it is no array of numbers.
fn variable(
    outer: &MatElement<'_>,
    big_endian: bool,
    budget: MemoryBudget,
) -> Result<Option<(String, Matrix)>, ExchangeError> {
    if outer.kind != MATRIX {
        return Ok(None);
    }
    let mut walk = Bytes::new(outer.data, 0, big_endian);
    let flags = whole_numbers(&element(&mut walk, true)?, big_endian)?;
    let flags = *flags.first().unwrap_or(&0) as u32;
    let class = flags & 0xff;
    if class != SPARSE && !NUMERIC.contains(&class) {
        return Ok(None);
    }
    let shape = whole_numbers(&element(&mut walk, true)?, big_endian)?;
    let name = element(&mut walk, true)?;
    let name = String::from_utf8_lossy(name.data).into_owned();
    let [rows, columns] = *shape.as_slice() else {
        return Ok(None);
    };
    if flags & COMPLEX != 0 {
        return Err(walk.error(complex(&name)));
    }
    let entries = if class == SPARSE {
        let (places, starts) = (element(&mut walk, true)?, element(&mut walk, true)?);
        let values = element(&mut walk, true)?;
        let count = values.data.len() / stored(&values)?.size();
        ask_for_numbers(budget, count).map_err(|cause| walk.error(cause))?;
        let (places, starts) = (whole_numbers(&places, big_endian)?, whole_numbers(&starts, big_endian)?);
        SparseColumns { places, starts, values: numbers(&values, big_endian)? }.entries(rows, columns)
    } else {
        let values = element(&mut walk, true)?;
        // numbers of one byte become eight
        let needed = 8 * (values.data.len() / stored(&values)?.size()) as u128;
        ask(budget, "the numbers of the matrix", needed).map_err(|cause| walk.error(cause))?;
        full_entries(&numbers(&values, big_endian)?, rows, columns, budget)
    };
    let entries = entries.map_err(|cause| walk.error(cause))?;
    let matrix =
        whole_matrix(rows, columns, entries).map_err(|error| error.moved(FilePlace::Byte(walk.at())))?;
    Ok(Some((name, matrix)))
}

/// How an element stores its numbers.
fn stored(element: &MatElement<'_>) -> Result<StoredNumber, ExchangeError> {
    match element.kind {
        1 => Ok(StoredNumber::Signed(1)),
        2 => Ok(StoredNumber::Unsigned(1)),
        3 => Ok(StoredNumber::Signed(2)),
        4 => Ok(StoredNumber::Unsigned(2)),
        5 => Ok(StoredNumber::Signed(4)),
        6 => Ok(StoredNumber::Unsigned(4)),
        7 => Ok(StoredNumber::Float(4)),
        9 => Ok(StoredNumber::Float(8)),
        12 => Ok(StoredNumber::Signed(8)),
        13 => Ok(StoredNumber::Unsigned(8)),
        other => {
            let problem = format!("its type is {other}, which is no number");
            Err(ExchangeError::at_byte(element.at, FileCause::Inconsistent { what: ELEMENT, problem }))
        }
    }
}

fn numbers(element: &MatElement<'_>, big_endian: bool) -> Result<Vec<f64>, ExchangeError> {
    Ok(stored(element)?.floats(element.data, big_endian))
}

fn whole_numbers(element: &MatElement<'_>, big_endian: bool) -> Result<Vec<usize>, ExchangeError> {
    let counts = stored(element)?.counts(element.data, big_endian);
    counts.into_iter().collect::<Option<Vec<usize>>>().ok_or_else(|| {
        let problem = String::from("a number is negative or not whole where a count is needed");
        ExchangeError::at_byte(element.at, FileCause::Inconsistent { what: ELEMENT, problem })
    })
}
