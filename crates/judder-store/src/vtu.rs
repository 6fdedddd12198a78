//! Fields on square cells as a VTK unstructured grid (`.vtu`), which ParaView and meshio open.
//!
//! XML with inline arrays: base64 of blocks compressed by zlib, little-endian, as the VTK file formats say.

use std::fmt::Write as _;
use std::io::{self, Write as _};
use std::path::Path;

use base64::{Engine, engine::general_purpose::STANDARD};
use flate2::{Compression, write::ZlibEncoder};

use crate::StoreError;
use crate::name::check_name;

/// A rectangle of square cells in the plane z = 0; fields on it are row-major with x fastest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quads {
    /// Cells along x.
    pub columns: usize,
    /// Cells along y.
    pub rows: usize,
    /// Side of a cell.
    pub side: f64,
    /// The corner with the smallest x and y.
    pub origin: [f64; 2],
}

/// The type number of a quadrilateral.
const VTK_QUAD: u8 = 9;

/// The file of these cells with fields on them, one value a cell.
///
/// # Errors
/// [`StoreError::FieldSize`] for a field that does not fill the cells, [`StoreError::InvalidName`] for its name.
pub fn vtu(quads: &Quads, fields: &[(&str, &[f64])]) -> Result<Vec<u8>, StoreError> {
    let cells = quads.columns * quads.rows;
    for (name, values) in fields {
        check_name("a field", name)?;
        if values.len() != cells {
            return Err(StoreError::FieldSize {
                name: (*name).to_owned(),
                expected: cells,
                found: values.len(),
            });
        }
    }
    write(quads, fields).map_err(|source| StoreError::write(Path::new("fields"), 0, source))
}

fn write(quads: &Quads, fields: &[(&str, &[f64])]) -> io::Result<Vec<u8>> {
    let (columns, rows) = (quads.columns, quads.rows);
    let (points, cells) = ((columns + 1) * (rows + 1), columns * rows);
    let corner = |index: usize| {
        let (row, column) = (index / (columns + 1), index % (columns + 1));
        let [x, y] = quads.origin;
        [x + column as f64 * quads.side, y + row as f64 * quads.side, 0.0]
    };
    let corners_of = |cell: usize| {
        let first = cell / columns * (columns + 1) + cell % columns;
        [first, first + 1, first + columns + 2, first + columns + 1].map(|point| point as i64)
    };
    let mut xml = format!(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" \
         header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n<UnstructuredGrid>\n\
         <Piece NumberOfPoints=\"{points}\" NumberOfCells=\"{cells}\">\n<Points>\n"
    );
    let bytes =
        |values: &mut dyn Iterator<Item = f64>| values.flat_map(f64::to_le_bytes).collect::<Vec<u8>>();
    let whole =
        |values: &mut dyn Iterator<Item = i64>| values.flat_map(i64::to_le_bytes).collect::<Vec<u8>>();
    let coordinates = bytes(&mut (0..points).flat_map(corner));
    array(&mut xml, "type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"", &coordinates)?;
    xml.push_str("</Points>\n<Cells>\n");
    let connectivity = whole(&mut (0..cells).flat_map(corners_of));
    array(&mut xml, "type=\"Int64\" Name=\"connectivity\"", &connectivity)?;
    let offsets = whole(&mut (1..=cells).map(|cell| 4 * cell as i64));
    array(&mut xml, "type=\"Int64\" Name=\"offsets\"", &offsets)?;
    array(&mut xml, "type=\"UInt8\" Name=\"types\"", &vec![VTK_QUAD; cells])?;
    xml.push_str("</Cells>\n<CellData>\n");
    for (name, values) in fields {
        let attributes = format!("type=\"Float64\" Name=\"{name}\"");
        array(&mut xml, &attributes, &bytes(&mut values.iter().copied()))?;
    }
    xml.push_str("</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
    Ok(xml.into_bytes())
}

/// One array as one compressed block: the number of blocks, their size, that of the last, the compressed size; the block.
fn array(xml: &mut String, attributes: &str, bytes: &[u8]) -> io::Result<()> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::default());
    encoder.write_all(bytes)?;
    let block = encoder.finish()?;
    let size = bytes.len() as u64;
    let header: Vec<u8> =
        [1, size, size, block.len() as u64].into_iter().flat_map(u64::to_le_bytes).collect();
    let (header, block) = (STANDARD.encode(header), STANDARD.encode(block));
    // writing to a text cannot fail
    let _ = writeln!(xml, "<DataArray {attributes} format=\"binary\">{header}{block}</DataArray>");
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_field_of_the_wrong_size_is_refused() {
        let quads = Quads { columns: 3, rows: 2, side: 0.5, origin: [0.0, 0.0] };
        let short = vtu(&quads, &[("pressure", &[0.0; 5])]).unwrap_err();
        assert!(matches!(short, StoreError::FieldSize { expected: 6, found: 5, .. }));
        assert!(matches!(vtu(&quads, &[("a b", &[0.0; 6])]), Err(StoreError::InvalidName { .. })));
    }

    #[test]
    fn the_same_fields_give_the_same_bytes() {
        let quads = Quads { columns: 3, rows: 2, side: 0.5, origin: [0.0, 0.0] };
        let field = [1.0, f64::NAN, 3.0, 4.0, 5.0, 6.0];
        let file = vtu(&quads, &[("pressure", &field)]).unwrap();
        assert_eq!(file, vtu(&quads, &[("pressure", &field)]).unwrap());
        let text = String::from_utf8(file).unwrap();
        assert!(
            text.contains("NumberOfPoints=\"12\" NumberOfCells=\"6\"") && text.contains("Name=\"pressure\"")
        );
    }
}
