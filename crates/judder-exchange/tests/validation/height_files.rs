//! Height maps written by NumPy, SciPy and netCDF4 (`height_maps/write.py`), read back.

use crate::file;
use judder_exchange::heights::{HeightTable, HeightsError, read_heights};
use std::path::Path;

fn read(name: &str, variable: Option<&str>) -> Result<HeightTable, HeightsError> {
    let path = file("validation/height_maps").join(name);
    read_heights(&path, std::fs::read(&path).unwrap(), variable)
}

/// z = 0.25 (2 x² + y²) + 0.125 x + 3, as in the script.
fn expected(row: usize, column: usize) -> f64 {
    let (x, y) = (0.5 * column as f64, 0.5 * row as f64 - 1.0);
    0.25 * (2.0 * x * x + y * y) + 0.125 * x + 3.0
}

#[test]
fn every_form_gives_the_same_heights() {
    for (name, spacing) in [
        ("c_order.npy", None),
        ("fortran_order_f4.npy", None),
        ("classic.nc", Some(0.5)),
        ("transposed.nc", Some(0.5)),
        ("no_coordinates.nc", None),
        ("four_packed.nc", Some(0.5)),
    ] {
        let table = read(name, None).unwrap();
        assert_eq!((table.columns, table.rows, table.spacing), (5, 4, spacing), "{name}");
        for (index, height) in table.heights.iter().enumerate() {
            // The numbers are sums of powers of two that every form holds exactly.
            assert_eq!(*height, expected(index / 5, index % 5), "{name}, {index}");
        }
    }
}

#[test]
fn ambiguous_files_are_refused_by_name() {
    let message = |name, variable| read(name, variable).unwrap_err().to_string();
    assert!(message("two_variables.nc", None).contains("`variable` to one of \"z\", \"error\""));
    assert!(message("two_variables.nc", Some("depth")).contains("no variable \"depth\""));
    assert!(read("two_variables.nc", Some("z")).is_ok());
    assert!(matches!(read("stretched.nc", None), Err(HeightsError::UnequalSteps { step: 2, .. })));
    assert_eq!(read("oblong.nc", None), Err(HeightsError::NotSquare { x: 1.0, y: 0.5 }));
    assert!(matches!(read("two_units.nc", None), Err(HeightsError::UnitsDiffer { .. })));
    assert!(message("integers.npy", None).contains("<i8"));
    assert!(message("c_order.npy", Some("z")).contains("leave `variable` out"));
}

#[test]
fn numbers_of_every_type_and_byte_order_are_read() {
    let ends = |kind: &str| match kind {
        "i1" => [i8::MAX.into(), i8::MIN.into()],
        "u1" => [u8::MAX.into(), 0.0],
        "i2" => [i16::MAX.into(), i16::MIN.into()],
        "u2" => [u16::MAX.into(), 0.0],
        "i4" => [i32::MAX.into(), i32::MIN.into()],
        "u4" => [u32::MAX.into(), 0.0],
        "i8" => [i64::MAX as f64, i64::MIN as f64],
        "u8" => [u64::MAX as f64, 0.0],
        _ => [2.0_f64.powi(100), -2.0_f64.powi(100)],
    };
    for kind in ["i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", "f4", "f8"] {
        for order in ["little", "big"] {
            let table = read("four_types.nc", Some(&format!("{kind}-{order}"))).unwrap();
            assert_eq!((table.columns, table.rows), (3, 2));
            let [largest, smallest] = ends(kind);
            assert_eq!(table.heights, [largest, smallest, 2.0, 1.0, 0.0, 7.0], "{kind}, {order}");
        }
    }
}

/// First the sign, then the mask, then the factor.
#[test]
fn bytes_that_are_unsigned_by_an_attribute_are_masked_as_that() {
    let heights = read("four_unsigned.nc", None).unwrap().heights;
    assert!(heights[0].is_nan());
    assert_eq!(heights[1..], [127.0, 1.0, 63.5]);
}

#[test]
fn masked_heights_are_not_numbers() {
    let table = read("four_masked.nc", None).unwrap();
    let masked = |height: &f64| height.is_nan();
    assert_eq!(table.heights.iter().position(masked), Some(2 * table.columns + 3));
    assert_eq!(table.heights.iter().filter(|height| masked(height)).count(), 1);
}

#[test]
fn files_that_are_none_are_refused() {
    assert_eq!(read("write.py", None), Err(HeightsError::UnknownEnding { ending: String::from("py") }));
    for name in ["heights.npy", "heights.txt", "heights.nc"] {
        assert_eq!(read_heights(Path::new(name), Vec::new(), None), Err(HeightsError::Empty));
    }
    let text = read_heights(Path::new("heights.nc"), b"1 2\n3 4\n".to_vec(), None);
    assert!(matches!(text, Err(HeightsError::NetCdf { .. })));
}
