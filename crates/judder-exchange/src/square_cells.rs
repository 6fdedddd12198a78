//! Fields on square cells in a plane, for ParaView.

use crate::cause::FileCause;
use crate::error::ExchangeError;
use crate::vtu::{Piece, VtuField, array_bytes, cell_type, index_bytes, write_piece};
use judder_structure::element::ElementKind;
use std::io::Write;

/// A rectangle of square cells in the plane z = 0; fields on it are row-major with x fastest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SquareCells {
    /// Cells along x.
    pub columns: usize,
    /// Cells along y.
    pub rows: usize,
    /// Side of a cell, in the unit in which lengths are to be shown.
    pub side: f64,
    /// The corner with the smallest x and y, in the same unit.
    pub origin: [f64; 2],
}

impl SquareCells {
    /// Writes the cells with fields on them, one value a cell.
    ///
    /// # Errors
    /// [`FileCause::WrongCount`] for a field that does not fill the cells, [`FileCause::Unwritable`].
    pub fn write_vtu(&self, to: &mut dyn Write, fields: &[VtuField]) -> Result<(), ExchangeError> {
        let said = self.columns * self.rows;
        if let Some(field) = fields.iter().find(|field| field.values.len() != said) {
            let found = field.values.len();
            return Err(FileCause::WrongCount { what: "values of a field", said, found }.into());
        }
        Ok(write_piece(to, &self.piece(), None, Some(fields))?)
    }

    fn piece(&self) -> Piece {
        let points_a_row = self.columns + 1;
        let [x, y] = self.origin;
        let corner = |index: usize| {
            let (row, column) = (index / points_a_row, index % points_a_row);
            [x + column as f64 * self.side, y + row as f64 * self.side, 0.0]
        };
        let corners_of = |cell: usize| {
            let first = cell / self.columns * points_a_row + cell % self.columns;
            [first, first + 1, first + points_a_row + 1, first + points_a_row]
        };
        let cells = self.columns * self.rows;
        Piece {
            places: array_bytes((0..points_a_row * (self.rows + 1)).flat_map(corner)),
            connectivity: index_bytes((0..cells).flat_map(corners_of)),
            ends: index_bytes((1..=cells).map(|cell| 4 * cell)),
            types: vec![cell_type(ElementKind::Quad4); cells],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vtu::FieldValues;

    const CELLS: SquareCells = SquareCells { columns: 3, rows: 2, side: 0.5, origin: [0.0, 0.0] };

    fn pressure(values: &[f64]) -> [VtuField; 1] {
        [VtuField { name: String::from("pressure"), values: FieldValues::Scalars(values.to_vec()) }]
    }

    #[test]
    fn a_field_of_the_wrong_size_is_refused() {
        let error = CELLS.write_vtu(&mut Vec::new(), &pressure(&[0.0; 5])).unwrap_err();
        assert!(matches!(error.cause(), FileCause::WrongCount { said: 6, found: 5, .. }));
    }

    #[test]
    fn the_same_fields_give_the_same_bytes() {
        let write = || {
            let mut file = Vec::new();
            CELLS.write_vtu(&mut file, &pressure(&[1.0, f64::NAN, 3.0, 4.0, 5.0, 6.0])).unwrap();
            file
        };
        let text = String::from_utf8(write()).unwrap();
        assert_eq!(text.as_bytes(), write());
        for part in [
            "NumberOfPoints=\"12\" NumberOfCells=\"6\"",
            "<CellData>\n<DataArray type=\"Float64\" Name=\"pressure\"",
        ] {
            assert!(text.contains(part), "{part}");
        }
        assert!(!text.contains("PointData"));
    }
}
