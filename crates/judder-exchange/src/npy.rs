//! Arrays in NumPy's own format (NEP 1), versions 1 to 3.

pub(crate) mod error;

pub use error::NpyError;

use crate::bytes::StoredNumber;
use crate::quoted::quoted;
use std::io::Read;

const MAGIC: &[u8] = b"\x93NUMPY";

/// An array of numbers or of bytes.
#[derive(Debug)]
pub(crate) struct NpyArray {
    /// The type of its numbers, as NumPy writes it.
    pub(crate) descr: String,
    /// Of its numbers; `None` for texts.
    pub(crate) stored: Option<StoredNumber>,
    pub(crate) big_endian: bool,
    pub(crate) fortran_order: bool,
    pub(crate) shape: Vec<usize>,
    /// Exactly those of its numbers.
    pub(crate) data: Vec<u8>,
}

impl NpyArray {
    /// All its numbers, in the order of the file.
    pub(crate) fn floats(&self) -> Result<Vec<f64>, NpyError> {
        let stored = self.stored.ok_or(NpyError::Texts)?;
        Ok(stored.floats(&self.data, self.big_endian))
    }

    /// All its whole numbers, in the order of the file.
    pub(crate) fn counts(&self) -> Result<Vec<usize>, NpyError> {
        let stored = self.stored.ok_or(NpyError::Texts)?;
        let whole: Option<Vec<usize>> = stored.counts(&self.data, self.big_endian).into_iter().collect();
        whole.ok_or(NpyError::NotIndices)
    }
}

/// What the header of an array says.
pub(crate) struct NpyHeader {
    descr: String,
    stored: Option<StoredNumber>,
    big_endian: bool,
    fortran_order: bool,
    shape: Vec<usize>,
    /// Bytes of its numbers.
    pub(crate) said: usize,
    /// How many numbers it says.
    pub(crate) count: usize,
}

/// Reads an array: its header, then its numbers.
pub(crate) fn read_npy(from: &mut impl Read) -> Result<NpyArray, NpyError> {
    NpyHeader::read(from)?.read_numbers(from)
}

impl NpyHeader {
    pub(crate) fn read(from: &mut impl Read) -> Result<Self, NpyError> {
        let header = read_header(from)?;
        let descr = entry(&header, "descr")?.trim_matches(['\'', '"']);
        let (stored, big_endian, size) =
            number(descr).ok_or_else(|| NpyError::Numbers { found: quoted(descr) })?;
        let fortran_order = match entry(&header, "fortran_order")? {
            "True" => true,
            "False" => false,
            other => return Err(NpyError::Order { found: quoted(other) }),
        };
        let shape = shape(entry(&header, "shape")?)?;
        let said = shape.iter().try_fold(size, |bytes, length| bytes.checked_mul(*length));
        let Some(said) = said else { return Err(NpyError::TooLarge { shape }) };
        let descr = descr.to_owned();
        Ok(Self { descr, stored, big_endian, fortran_order, shape, said, count: said / size })
    }

    /// The array. No more is taken than the header says, and one byte to see that no more is there: what unpacks on the way cannot fill
    /// the memory with what the array does not have.
    pub(crate) fn read_numbers(self, from: &mut impl Read) -> Result<NpyArray, NpyError> {
        let Self { descr, stored, big_endian, fortran_order, shape, said, .. } = self;
        let data = at_most(from, (said as u64).saturating_add(1))?;
        if data.len() != said {
            let found = Some(data.len()).filter(|found| *found < said);
            return Err(NpyError::WrongSize { found, shape });
        }
        Ok(NpyArray { descr, stored, big_endian, fortran_order, shape, data })
    }
}

/// The next bytes, so many at most.
fn at_most(from: &mut impl Read, most: u64) -> Result<Vec<u8>, NpyError> {
    let mut bytes = Vec::new();
    match from.take(most).read_to_end(&mut bytes) {
        Ok(_) => Ok(bytes),
        Err(error) => Err(NpyError::Damaged { problem: error.to_string() }),
    }
}

/// The next bytes, all of them.
fn exactly<const N: usize>(from: &mut impl Read) -> Result<[u8; N], NpyError> {
    at_most(from, N as u64)?.try_into().map_err(|_| NpyError::Cut)
}

/// The header's text.
fn read_header(from: &mut impl Read) -> Result<String, NpyError> {
    /// NumPy itself reads no longer ones.
    const LONGEST: usize = 10_000;
    if at_most(from, MAGIC.len() as u64)? != MAGIC {
        return Err(NpyError::Foreign);
    }
    let length = match exactly::<2>(from)?[0] {
        1 => usize::from(u16::from_le_bytes(exactly(from)?)),
        2 | 3 => u32::from_le_bytes(exactly(from)?) as usize,
        version => return Err(NpyError::Version { version }),
    };
    if length > LONGEST {
        return Err(NpyError::LongHeader { length, most: LONGEST });
    }
    let header = at_most(from, length as u64)?;
    if header.len() < length {
        return Err(NpyError::Cut);
    }
    String::from_utf8(header).map_err(|_| NpyError::NotText)
}

/// The value of a key of the header, which is a Python dictionary of plain values.
fn entry<'a>(header: &'a str, key: &'static str) -> Result<&'a str, NpyError> {
    let missing = || NpyError::MissingKey { key };
    let (_, rest) = header.split_once(&format!("'{key}'")).ok_or_else(missing)?;
    let rest = rest.trim_start().strip_prefix(':').ok_or_else(missing)?.trim_start();
    let end = match rest.chars().next().ok_or_else(missing)? {
        '(' => rest.find(')').map(|end| end + 1),
        '[' => rest.find(']').map(|end| end + 1),
        _ => rest.find([',', '}']),
    };
    Ok(rest[..end.ok_or_else(missing)?].trim())
}

/// How numbers of a type are stored, whether big-endian, and the bytes of one.
fn number(descr: &str) -> Option<(Option<StoredNumber>, bool, usize)> {
    let mut letters = descr.chars();
    let (order, kind) = letters.next().zip(letters.next())?;
    let size: usize = letters.as_str().parse().ok()?;
    let stored = match (kind, size) {
        (_, 0) => return None,
        ('f', 4 | 8) => Some(StoredNumber::Float(size)),
        ('i', 1 | 2 | 4 | 8) => Some(StoredNumber::Signed(size)),
        ('u' | 'b', 1 | 2 | 4 | 8) => Some(StoredNumber::Unsigned(size)),
        ('S', _) => None,
        ('U', _) => return Some((None, order == '>', size.checked_mul(4)?)),
        _ => return None,
    };
    Some((stored, order == '>', size))
}

fn shape(text: &str) -> Result<Vec<usize>, NpyError> {
    let inner = text.strip_prefix('(').and_then(|text| text.strip_suffix(')')).unwrap_or(text);
    let sizes: Result<Vec<usize>, _> =
        inner.split(',').map(str::trim).filter(|size| !size.is_empty()).map(str::parse).collect();
    sizes.map_err(|_| NpyError::Shape { found: quoted(text) })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(descr: &str, shape: &str, data: &[u8]) -> Result<NpyArray, NpyError> {
        let header = format!("{{'descr': '{descr}', 'fortran_order': False, 'shape': {shape}}}\n");
        let length = (header.len() as u16).to_le_bytes();
        let file = [MAGIC, &[1, 0], &length, header.as_bytes(), data].concat();
        read_npy(&mut file.as_slice())
    }

    fn message(descr: &str, shape: &str, data: &[u8]) -> String {
        read(descr, shape, data).map_or_else(|error| error.to_string(), |array| format!("{:?}", array.shape))
    }

    #[test]
    fn arrays_and_numbers_alone_are_read() {
        assert_eq!(read("<u2", "(3,)", &[1, 0, 2, 0, 3, 0]).unwrap().counts().unwrap(), [1, 2, 3]);
        assert_eq!(read(">f8", "()", &2.5_f64.to_be_bytes()).unwrap().floats().unwrap(), [2.5]);
        assert!(read("|S3", "()", b"csr").unwrap().counts().is_err());
        assert!(read("<i1", "(1,)", &[0xff]).unwrap().counts().is_err());
    }

    #[test]
    fn sizes_that_no_memory_has_are_refused() {
        let huge = "(4611686018427387904, 8)";
        for descr in ["|S0", "<U0", "<f0"] {
            assert!(message(descr, huge, &[]).contains("holds numbers of type"), "{descr}");
        }
        assert!(message("|S1", huge, &[]).contains("larger than any memory"));
        assert!(message("<f8", "(1125899906842624,)", &[0; 16]).contains("holds 16 bytes of data"));
    }

    /// A reader that would never end.
    #[test]
    fn no_more_is_read_than_the_header_says() {
        let header = "{'descr': '<i4', 'fortran_order': False, 'shape': (2,)}\n";
        let start = [MAGIC, &[1, 0], &(header.len() as u16).to_le_bytes(), header.as_bytes()].concat();
        let error = read_npy(&mut start.as_slice().chain(std::io::repeat(0))).err().unwrap();
        assert!(error.to_string().contains("holds more bytes of data"), "{error}");
        let endless = [MAGIC, &[2, 0, 0xff, 0xff, 0xff, 0xff]].concat();
        let error = read_npy(&mut endless.as_slice().chain(std::io::repeat(b' '))).err().unwrap();
        assert!(error.to_string().contains("10000 are read at most"), "{error}");
    }
}
