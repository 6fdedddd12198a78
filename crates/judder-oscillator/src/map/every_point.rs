//! The map decided at every grid point.

use super::{Plane, StabilityMap};
use crate::Contact;
use crate::block::{Block, LANES};
use crate::mechanism::StabilityClass;
use rayon::prelude::*;

/// Rows that one task decides: each tile starts afresh, so its size is fixed, whatever the number of threads.
const TILE_ROWS: usize = 256;

/// Decides every point. Tiles are [`LANES`] columns wide; inside a tile the rows before give the starting values.
#[must_use]
pub fn every_point(contact: &Contact, plane: &impl Plane) -> StabilityMap {
    let (columns, rows) = (plane.columns(), plane.rows());
    let bands: Vec<Vec<u8>> = (0..rows.div_ceil(TILE_ROWS))
        .into_par_iter()
        .map(|band| {
            let first = band * TILE_ROWS;
            let height = TILE_ROWS.min(rows - first);
            let mut classes = vec![StabilityClass::Unresolved as u8; height * columns];
            let tiles: Vec<(usize, Vec<u8>)> = (0..columns.div_ceil(LANES))
                .into_par_iter()
                .map(|tile| (tile * LANES, decide_tile(contact, plane, tile * LANES, first, height)))
                .collect();
            for (column, tile) in tiles {
                let width = tile.len() / height;
                for (row, codes) in tile.chunks(width).enumerate() {
                    classes[row * columns + column..][..width].copy_from_slice(codes);
                }
            }
            classes
        })
        .collect();
    StabilityMap { columns, rows, classes: bands.concat(), decisions: columns * rows }
}

/// The classes of one tile, row by row.
fn decide_tile(
    contact: &Contact,
    plane: &impl Plane,
    column: usize,
    first_row: usize,
    height: usize,
) -> Vec<u8> {
    let width = LANES.min(plane.columns() - column);
    let mut codes = Vec::with_capacity(width * height);
    let mut block = Block::default();
    let mut history = History::default();
    for row in first_row..first_row + height {
        history.push(&block.ln_indentation);
        for lane in 0..width {
            block.set(lane, &plane.coefficients(column + lane, row), history.extrapolate(lane));
        }
        block.decide(contact, width);
        codes.extend((0..width).map(|lane| block.class(lane) as u8));
    }
    codes
}

/// ln ŷ_e of the four rows before, the latest first.
struct History([[f64; LANES]; 4]);

impl Default for History {
    fn default() -> Self {
        Self([[f64::NAN; LANES]; 4])
    }
}

impl History {
    fn push(&mut self, row: &[f64; LANES]) {
        self.0.rotate_right(1);
        self.0[0] = *row;
    }

    /// The cubic through the four rows before, or as much of it as there is: on fine grids one Newton step then settles it.
    #[inline(always)]
    fn extrapolate(&self, lane: usize) -> f64 {
        let [a, b, c, d] = self.0.map(|row| row[lane]);
        let cubic = 4.0 * (a + c) - 6.0 * b - d;
        let linear = a + (a - b);
        match (cubic.is_nan(), linear.is_nan()) {
            (false, _) => cubic,
            (true, false) => linear,
            (true, true) => a,
        }
    }
}
