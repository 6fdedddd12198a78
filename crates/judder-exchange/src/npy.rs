//! Arrays in NumPy's own format (NEP 1), versions 1 to 3.

use crate::bytes::Stored;
use crate::cause::Cause;
use crate::quoted::quoted;

const MAGIC: &[u8] = b"\x93NUMPY";
const ARRAY: &str = "a NumPy array";

/// An array of numbers or of bytes.
pub(crate) struct Array {
    /// Of its numbers; `None` for texts.
    pub(crate) stored: Option<Stored>,
    pub(crate) big_endian: bool,
    pub(crate) fortran_order: bool,
    pub(crate) shape: Vec<usize>,
    /// Exactly those of its numbers.
    pub(crate) data: Vec<u8>,
}

impl Array {
    /// All its numbers, in the order of the file.
    pub(crate) fn floats(&self) -> Result<Vec<f64>, Cause> {
        let stored = self.stored.ok_or_else(|| damaged(String::from("texts where numbers are needed")))?;
        Ok(stored.floats(&self.data, self.big_endian))
    }

    /// All its whole numbers, in the order of the file.
    pub(crate) fn counts(&self) -> Result<Vec<usize>, Cause> {
        let counts = self.stored.map_or_else(Vec::new, |stored| stored.counts(&self.data, self.big_endian));
        let whole: Option<Vec<usize>> = counts.into_iter().collect();
        match whole {
            Some(whole) if whole.len() == self.shape.iter().product() => Ok(whole),
            _ => {
                Err(damaged(String::from("numbers that are negative or not whole where indices are needed")))
            }
        }
    }
}

fn damaged(problem: String) -> Cause {
    Cause::Inconsistent { what: ARRAY, problem }
}

/// The array in these bytes.
pub(crate) fn read_npy(mut bytes: Vec<u8>) -> Result<Array, Cause> {
    let (header, data) = split(&bytes)?;
    let start = bytes.len() - data.len();
    let (stored, big_endian, size) = number(entry(header, "descr")?)?;
    let fortran_order = entry(header, "fortran_order")? == "True";
    let shape = shape(entry(header, "shape")?)?;
    let count = shape.iter().try_fold(size, |bytes, length| bytes.checked_mul(*length));
    if count != Some(data.len()) {
        let found = data.len();
        return Err(damaged(format!(
            "its header says shape {shape:?} of {size} bytes each, and {found} bytes follow"
        )));
    }
    bytes.drain(..start);
    Ok(Array { data: bytes, stored, big_endian, fortran_order, shape })
}

/// The header's text and the data behind it.
fn split(bytes: &[u8]) -> Result<(&str, &[u8]), Cause> {
    let cut = || Cause::Cut { what: "the header of a NumPy array", needed: 128, left: bytes.len() };
    let rest = bytes.strip_prefix(MAGIC).ok_or_else(|| Cause::Foreign {
        format: "NumPy array",
        found: String::from("it does not begin with \\x93NUMPY"),
        remedy: "write it with scipy.sparse.save_npz",
    })?;
    let (version, rest) = rest.split_first_chunk::<2>().ok_or_else(cut)?;
    let (length, rest) = match version[0] {
        1 => rest.split_first_chunk::<2>().map(|(size, rest)| (u16::from_le_bytes(*size) as usize, rest)),
        2 | 3 => rest.split_first_chunk::<4>().map(|(size, rest)| (u32::from_le_bytes(*size) as usize, rest)),
        other => return Err(damaged(format!("version {other} of the format; 1, 2 and 3 are read"))),
    }
    .ok_or_else(cut)?;
    let (header, data) = rest.split_at_checked(length).ok_or_else(cut)?;
    let header = std::str::from_utf8(header).map_err(|_| damaged(String::from("its header is no text")))?;
    Ok((header, data))
}

/// The value of a key of the header, which is a Python dictionary of plain values.
fn entry<'a>(header: &'a str, key: &str) -> Result<&'a str, Cause> {
    let missing = || damaged(format!("its header has no {key}"));
    let (_, rest) = header.split_once(&format!("'{key}'")).ok_or_else(missing)?;
    let rest = rest.trim_start().strip_prefix(':').ok_or_else(missing)?.trim_start();
    let end = match rest.chars().next().ok_or_else(missing)? {
        '(' => rest.find(')').map(|end| end + 1),
        _ => rest.find([',', '}']),
    };
    Ok(rest[..end.ok_or_else(missing)?].trim())
}

/// How numbers are stored, whether big-endian, and the bytes of one.
fn number(descr: &str) -> Result<(Option<Stored>, bool, usize), Cause> {
    let unsupported = || Cause::Unsupported {
        what: "the type of a NumPy array",
        found: format!("`{}`", quoted(descr)),
        read: "real and whole numbers of up to eight bytes; write real and imaginary parts as two matrices",
    };
    let text = descr.trim_matches(['\'', '"']);
    let mut letters = text.chars();
    let (order, kind) = letters.next().zip(letters.next()).ok_or_else(unsupported)?;
    let size: usize = letters.as_str().parse().map_err(|_| unsupported())?;
    let stored = match (kind, size) {
        ('f', 4 | 8) => Some(Stored::Float(size)),
        ('i', 1 | 2 | 4 | 8) => Some(Stored::Signed(size)),
        ('u' | 'b', 1 | 2 | 4 | 8) => Some(Stored::Unsigned(size)),
        ('S', _) => None,
        ('U', _) => return Ok((None, order == '>', size.checked_mul(4).ok_or_else(unsupported)?)),
        _ => return Err(unsupported()),
    };
    Ok((stored, order == '>', size))
}

fn shape(text: &str) -> Result<Vec<usize>, Cause> {
    let inner = text.strip_prefix('(').and_then(|text| text.strip_suffix(')')).unwrap_or(text);
    let sizes: Result<Vec<usize>, _> =
        inner.split(',').map(str::trim).filter(|size| !size.is_empty()).map(str::parse).collect();
    sizes.map_err(|_| damaged(format!("its shape is {}", quoted(text))))
}
