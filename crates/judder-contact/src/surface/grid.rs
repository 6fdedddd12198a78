//! The square cells on which pressures and displacements live.

/// A rectangle of square cells; arrays on it are row-major with x fastest: index = row · columns + column.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfaceGrid {
    /// Cells along x, the direction of sliding.
    pub columns: usize,
    /// Cells along y.
    pub rows: usize,
    /// h, side of a cell, in the length unit of the problem.
    pub cell: f64,
    /// The corner with the smallest x and y.
    pub origin: [f64; 2],
}

impl SurfaceGrid {
    /// A square of `side` × `side` cells about a centre, with the given half width.
    #[must_use]
    pub fn square(side: usize, centre: [f64; 2], half_width: f64) -> Self {
        let origin = [centre[0] - half_width, centre[1] - half_width];
        Self { columns: side, rows: side, cell: 2.0 * half_width / side as f64, origin }
    }

    /// Number of cells.
    #[must_use]
    pub fn len(&self) -> usize {
        self.columns * self.rows
    }

    /// Whether there is no cell.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// x of the centre of a column.
    #[must_use]
    pub fn x(&self, column: usize) -> f64 {
        self.origin[0] + (column as f64 + 0.5) * self.cell
    }

    /// y of the centre of a row.
    #[must_use]
    pub fn y(&self, row: usize) -> f64 {
        self.origin[1] + (row as f64 + 0.5) * self.cell
    }

    /// h², area of a cell.
    #[must_use]
    pub fn cell_area(&self) -> f64 {
        self.cell * self.cell
    }
}
