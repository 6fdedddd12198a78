//! Matrices in NumPy's own format (NEP 1), versions 1 to 3.

use super::error::IndenterError;
use super::height_table::HeightTable;

const MAGIC: &[u8] = b"\x93NUMPY";

/// Reads a matrix of floating-point numbers, in either order and of either endianness.
///
/// # Errors
/// [`IndenterError::Npy`] for damaged files, for arrays that are no matrix and for numbers that are not `f4` or `f8`.
pub fn read_npy(bytes: &[u8]) -> Result<HeightTable, IndenterError> {
    let (header, data) = split(bytes)?;
    let number = Number::of(entry(header, "descr")?)?;
    let fortran = match entry(header, "fortran_order")? {
        "True" => true,
        "False" => false,
        other => {
            return Err(problem(format!(
                "has the fortran_order {other}, which is neither True nor False; save it anew with numpy.save"
            )));
        }
    };
    let (rows, columns) = shape(entry(header, "shape")?)?;
    let needed = rows.checked_mul(columns).and_then(|count| count.checked_mul(number.size()));
    if needed != Some(data.len()) {
        let found = data.len();
        return Err(problem(format!(
            "holds {found} bytes of data, which are not the {rows} × {columns} numbers that its header says; it was cut, or changed: save \
             it anew with numpy.save"
        )));
    }
    let stored: Vec<f64> = data.chunks_exact(number.size()).map(|bytes| number.read(bytes)).collect();
    let heights = if fortran {
        let places = (0..rows).flat_map(|row| (0..columns).map(move |column| column * rows + row));
        places.map(|place| stored[place]).collect()
    } else {
        stored
    };
    Ok(HeightTable { columns, rows, heights, spacing: None })
}

fn problem(problem: String) -> IndenterError {
    IndenterError::Npy { problem }
}

/// The header's text and the data behind it.
fn split(bytes: &[u8]) -> Result<(&str, &[u8]), IndenterError> {
    let cut = || problem(String::from("ends within its header; save it anew with numpy.save"));
    let foreign = || {
        problem(String::from("does not begin with \\x93NUMPY, and so is none; save heights with numpy.save"))
    };
    let rest = bytes.strip_prefix(MAGIC).ok_or_else(foreign)?;
    let (version, rest) = rest.split_first_chunk::<2>().ok_or_else(cut)?;
    let (length, rest) = match version[0] {
        1 => rest.split_first_chunk::<2>().map(|(size, rest)| (u16::from_le_bytes(*size) as usize, rest)),
        2 | 3 => rest.split_first_chunk::<4>().map(|(size, rest)| (u32::from_le_bytes(*size) as usize, rest)),
        other => {
            return Err(problem(format!("has version {other} of the format; versions 1, 2 and 3 are read")));
        }
    }
    .ok_or_else(cut)?;
    let (header, data) = rest.split_at_checked(length).ok_or_else(cut)?;
    let header = std::str::from_utf8(header)
        .map_err(|_| problem(String::from("has a header that is no text; save it anew with numpy.save")))?;
    Ok((header, data))
}

/// The value of a key of the header, which is a Python dictionary of plain values.
fn entry<'a>(header: &'a str, key: &str) -> Result<&'a str, IndenterError> {
    let missing = || problem(format!("has no {key} in its header; save it anew with numpy.save"));
    let (_, rest) = header.split_once(&format!("'{key}'")).ok_or_else(missing)?;
    let rest = rest.trim_start().strip_prefix(':').ok_or_else(missing)?.trim_start();
    let end = match rest.chars().next().ok_or_else(missing)? {
        '(' => rest.find(')').map(|end| end + 1),
        '[' => rest.find(']').map(|end| end + 1),
        _ => rest.find([',', '}']),
    };
    Ok(rest[..end.ok_or_else(missing)?].trim())
}

fn shape(text: &str) -> Result<(usize, usize), IndenterError> {
    let inner = text.strip_prefix('(').and_then(|text| text.strip_suffix(')')).unwrap_or(text);
    let sizes: Result<Vec<usize>, _> =
        inner.split(',').map(str::trim).filter(|size| !size.is_empty()).map(str::parse).collect();
    match sizes.as_deref() {
        Ok([rows, columns]) => Ok((*rows, *columns)),
        _ => Err(problem(format!(
            "holds an array of shape {text}; a matrix of shape (rows, columns) is needed"
        ))),
    }
}

/// A floating-point number of a file.
#[derive(Clone, Copy)]
enum Number {
    LittleSingle,
    LittleDouble,
    BigSingle,
    BigDouble,
}

impl Number {
    fn of(descr: &str) -> Result<Self, IndenterError> {
        match descr.trim_matches(['\'', '"']) {
            "<f4" => Ok(Self::LittleSingle),
            "<f8" => Ok(Self::LittleDouble),
            ">f4" => Ok(Self::BigSingle),
            ">f8" => Ok(Self::BigDouble),
            other => Err(problem(format!(
                "holds numbers of type {other}, and only f4 and f8 are read; save it as array.astype('f8')"
            ))),
        }
    }

    fn size(self) -> usize {
        match self {
            Self::LittleSingle | Self::BigSingle => 4,
            Self::LittleDouble | Self::BigDouble => 8,
        }
    }

    /// The number in `size` bytes.
    fn read(self, bytes: &[u8]) -> f64 {
        let mut eight = [0; 8];
        eight[..bytes.len()].copy_from_slice(bytes);
        let four = [eight[0], eight[1], eight[2], eight[3]];
        match self {
            Self::LittleSingle => f64::from(f32::from_le_bytes(four)),
            Self::BigSingle => f64::from(f32::from_be_bytes(four)),
            Self::LittleDouble => f64::from_le_bytes(eight),
            Self::BigDouble => f64::from_be_bytes(eight),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(version: u8, descr: &str, order: &str, shape: &str, data: &[u8]) -> Vec<u8> {
        let header = format!("{{'descr': '{descr}', 'fortran_order': {order}, 'shape': {shape}, }}\n");
        let mut bytes = [MAGIC, &[version, 0]].concat();
        if version == 1 {
            bytes.extend((header.len() as u16).to_le_bytes());
        } else {
            bytes.extend((header.len() as u32).to_le_bytes());
        }
        bytes.extend(header.as_bytes());
        bytes.extend(data);
        bytes
    }

    #[test]
    fn both_orders_and_endiannesses_give_the_same_matrix() {
        let little: Vec<u8> = (1..=6).flat_map(|value| f64::from(value).to_le_bytes()).collect();
        let table = read_npy(&file(1, "<f8", "False", "(2, 3)", &little)).unwrap();
        assert_eq!((table.rows, table.columns), (2, 3));
        assert_eq!(table.heights, [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
        let big: Vec<u8> =
            [1.0_f32, 4.0, 2.0, 5.0, 3.0, 6.0].iter().flat_map(|value| value.to_be_bytes()).collect();
        assert_eq!(read_npy(&file(2, ">f4", "True", "(2, 3)", &big)).unwrap(), table);
    }

    #[test]
    fn other_files_are_refused_by_name() {
        let message = |bytes: &[u8]| read_npy(bytes).unwrap_err().to_string();
        assert!(message(&file(1, "<i4", "False", "(1, 1)", &[0; 4])).contains("type <i4"));
        assert!(message(&file(1, "<f8", "False", "(4,)", &[0; 32])).contains("shape (4,)"));
        assert!(message(&file(1, "<f8", "False", "(2, 2)", &[0; 24])).contains("24 bytes"));
        assert!(message(&file(9, "<f8", "False", "(2, 2)", &[0; 32])).contains("version 9"));
        assert!(message(b"PK\x03\x04").contains("does not begin"));
        assert!(message(b"\x93NUMPY\x01\x00\xff\xff{").contains("ends within"));
    }
}
