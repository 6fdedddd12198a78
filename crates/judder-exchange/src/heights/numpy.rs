//! Matrices of heights in NumPy's own format.

use super::error::HeightsError;
use super::table::HeightTable;
use crate::bytes::StoredNumber;
use crate::npy::{NpyError, read_npy};

/// Reads a matrix of floating-point numbers, in either order and of either endianness.
///
/// # Errors
/// [`HeightsError::Npy`], [`HeightsError::NpyNumbers`], [`HeightsError::NpyShape`].
pub(super) fn read_numpy(mut bytes: &[u8]) -> Result<HeightTable, HeightsError> {
    let array = read_npy(&mut bytes).map_err(refused)?;
    if !matches!(array.stored, Some(StoredNumber::Float(_))) {
        return Err(HeightsError::NpyNumbers { found: array.descr });
    }
    let [rows, columns] = *array.shape.as_slice() else {
        return Err(HeightsError::NpyShape { shape: array.shape });
    };
    let stored = array.floats().map_err(refused)?;
    let heights = if array.fortran_order {
        let places = (0..rows).flat_map(|row| (0..columns).map(move |column| column * rows + row));
        places.map(|place| stored[place]).collect()
    } else {
        stored
    };
    Ok(HeightTable { columns, rows, heights, spacing: None })
}

/// What is wrong with the array, and what would be right.
fn refused(source: NpyError) -> HeightsError {
    let remedy = match source {
        NpyError::Numbers { found } => return HeightsError::NpyNumbers { found },
        NpyError::Foreign => "save heights with numpy.save",
        NpyError::WrongSize { .. } => "it was cut, or changed: save it anew with numpy.save",
        _ => "save it anew with numpy.save",
    };
    HeightsError::Npy { source, remedy }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(version: u8, descr: &str, order: &str, shape: &str, data: &[u8]) -> Vec<u8> {
        let header = format!("{{'descr': '{descr}', 'fortran_order': {order}, 'shape': {shape}, }}\n");
        let mut bytes = b"\x93NUMPY".to_vec();
        bytes.extend([version, 0]);
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
        let table = read_numpy(&file(1, "<f8", "False", "(2, 3)", &little)).unwrap();
        assert_eq!((table.rows, table.columns), (2, 3));
        assert_eq!(table.heights, [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
        let big: Vec<u8> =
            [1.0_f32, 4.0, 2.0, 5.0, 3.0, 6.0].iter().flat_map(|value| value.to_be_bytes()).collect();
        assert_eq!(read_numpy(&file(2, ">f4", "True", "(2, 3)", &big)).unwrap(), table);
    }

    #[test]
    fn other_files_are_refused_by_name() {
        let message = |bytes: &[u8]| read_numpy(bytes).unwrap_err().to_string();
        assert!(message(&file(1, "<i4", "False", "(1, 1)", &[0; 4])).contains("type <i4"));
        assert!(
            message(&file(1, "<c16", "False", "(1, 1)", &[0; 16])).contains("type <c16, and only f4 and f8")
        );
        assert!(message(&file(1, "<f8", "False", "(4,)", &[0; 32])).contains("shape (4,)"));
        assert!(message(&file(1, "<f8", "False", "(2, 2)", &[0; 24])).contains("24 bytes"));
        assert!(message(&file(1, "<f8", "Perhaps", "(2, 2)", &[0; 32])).contains("fortran_order Perhaps"));
        assert!(message(&file(9, "<f8", "False", "(2, 2)", &[0; 32])).contains("version 9"));
        assert!(message(b"PK\x03\x04").contains("does not begin"));
        assert!(message(b"\x93NUMPY\x01\x00\x76\x00{").contains("ends within"));
        assert!(message(b"\x93NUMPY\x01\x00\xff\xff{").contains("65535 bytes, and 10000 are read at most"));
    }
}
