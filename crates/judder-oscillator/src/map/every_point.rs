//! The map decided at every grid point.

use super::{OperatingPlane, StabilityMap};
use crate::Contact;
use crate::block::{LANES, PointBlock};
use crate::mechanism::StabilityClass;
use judder_numerics::parallel;
use rayon::prelude::*;

/// Rows that one task decides: each tile starts afresh, so its size is fixed, whatever the number of threads, and a map may be decided
/// in stretches of so many rows.
pub const TILE_ROWS: usize = 256;

/// Decides every point. Tiles are [`LANES`] columns wide; inside a tile the rows before give the starting values.
#[must_use]
pub fn every_point(contact: &Contact, plane: &impl OperatingPlane) -> StabilityMap {
    let (columns, rows) = (plane.columns(), plane.rows());
    let mut classes = vec![StabilityClass::Unresolved as u8; columns * rows];
    classes.par_chunks_mut((TILE_ROWS * columns).max(1)).enumerate().for_each(|(band, classes)| {
        let first_row = band * TILE_ROWS;
        let height = classes.len() / columns;
        let tiles: Vec<(usize, Vec<u8>)> = parallel::each_place(columns.div_ceil(LANES), |tile| {
            let column = tile * LANES;
            let width = LANES.min(columns - column);
            let mut codes = Vec::with_capacity(width * height);
            let at = |lane: usize, row: usize| plane.coefficients(column + lane, first_row + row);
            sweep_rows(contact, width, height, at, |_, block| {
                codes.extend((0..width).map(|lane| block.class(lane) as u8));
            });
            (column, codes)
        });
        for (column, codes) in tiles {
            let width = codes.len() / height;
            for (row, codes) in codes.chunks(width).enumerate() {
                classes[row * columns + column..][..width].copy_from_slice(codes);
            }
        }
    });
    StabilityMap { columns, rows, classes, decisions: columns * rows }
}

/// Decides `height` rows of `width` ≤ [`LANES`] points, each row starting from those before it, and shows each decided row.
pub(super) fn sweep_rows(
    contact: &Contact,
    width: usize,
    height: usize,
    coefficients: impl Fn(usize, usize) -> crate::Coefficients,
    mut show: impl FnMut(usize, &PointBlock),
) {
    let mut block = PointBlock::default();
    let mut history = RowHistory::default();
    for row in 0..height {
        for lane in 0..width {
            block.set(lane, &coefficients(lane, row), history.extrapolate(lane));
        }
        block.decide(contact, width);
        history.push(&block.ln_indentation);
        show(row, &block);
    }
}

/// ln ŷ_e of the four rows before, the latest first.
struct RowHistory([[f64; LANES]; 4]);

impl Default for RowHistory {
    fn default() -> Self {
        Self([[f64::NAN; LANES]; 4])
    }
}

impl RowHistory {
    fn push(&mut self, row: &[f64; LANES]) {
        self.0.rotate_right(1);
        self.0[0] = *row;
    }

    /// The cubic through the four rows before, or as much of it as there is: on fine grids one Newton step then settles it.
    #[inline(always)]
    fn extrapolate(&self, lane: usize) -> f64 {
        let [a, b, c, d] = [self.0[0][lane], self.0[1][lane], self.0[2][lane], self.0[3][lane]];
        let cubic = 4.0 * (a + c) - 6.0 * b - d;
        let linear = a + (a - b);
        match (cubic.is_nan(), linear.is_nan()) {
            (false, _) => cubic,
            (true, false) => linear,
            (true, true) => a,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::map::{CoefficientPlane, SweptCoefficient};
    use crate::{FrictionLoad, Groups};
    use judder_contact::{FittedLaw, Law};

    #[test]
    fn stretches_of_tiles_make_the_whole_map() {
        let contact = Contact {
            law: Law::Fitted(FittedLaw::oscillator_paper()),
            friction_load: FrictionLoad::NormalLoad,
        };
        let base = Groups::default().resolve();
        let logarithmic = |from: f64, to: f64, count: usize| -> Vec<f64> {
            (0..count).map(|k| from * (to / from).powf(k as f64 / (count - 1) as f64)).collect()
        };
        let velocities = logarithmic(1e-6, 1.0, 45);
        let strengths = logarithmic(1e-4, 0.3, 2 * TILE_ROWS + 9);
        let of = |rows: &[f64]| {
            let (x, y) = (
                (SweptCoefficient::Velocity, velocities.clone()),
                (SweptCoefficient::ShearStrength, rows.to_vec()),
            );
            every_point(&contact, &CoefficientPlane { base, x, y }).classes
        };
        let stretches: Vec<u8> = strengths.chunks(TILE_ROWS).flat_map(of).collect();
        assert_eq!(stretches, of(&strengths));
        assert!(
            stretches.contains(&(StabilityClass::Stable as u8))
                && stretches.contains(&(StabilityClass::Flutter as u8))
        );
    }
}
