//! Heights that repeat themselves, between the points of their lattice.

use crate::indenter::HeightMap;
use crate::surface::convolution::PaddedTransform;
use std::f64::consts::PI;

/// The trigonometric interpolation of a periodic map on a lattice `factor` times as fine, each value taken `shift` fine cells
/// before its point along x.
///
/// It goes through the heights and has no waves that their lattice does not have; so it is the same surface on every finer
/// lattice, and a surface that is made of such waves itself. Waves of two cells are half of one sign, half of the other.
pub(super) fn interpolated(map: &HeightMap, factor: usize, shift: f64) -> Vec<f64> {
    let heights = map.heights();
    if factor == 1 && shift == 0.0 {
        return heights.to_vec();
    }
    let (columns, rows) = (map.grid().columns, map.grid().rows);
    let (wide, high) = (factor * columns, factor * rows);
    let mut points = vec![0.0; wide * high];
    for (index, height) in heights.iter().enumerate() {
        points[factor * (index / columns) * wide + factor * (index % columns)] = *height;
    }
    let transform = PaddedTransform::periodic(wide, high);
    // The heights alone among zeros hold every wave of theirs `factor` times each way.
    let kept_along = |index: usize| kept(index, wide, columns);
    let kept_across: Vec<f64> = (0..high).map(|index| kept(index, high, rows)).collect();
    let mut factors = Vec::with_capacity(transform.spectrum_columns() * high);
    for column in 0..transform.spectrum_columns() {
        let phase = -2.0 * PI * column as f64 / wide as f64 * shift;
        let along = judder_numerics::complex::from_polar(kept_along(column), phase);
        factors.extend(kept_across.iter().map(|across| along * across));
    }
    let scale = (factor * factor) as f64 / transform.places();
    let mut fine = vec![0.0; wide * high];
    transform.multiply(&points, &factors, scale, &mut fine, &mut transform.workspace());
    fine
}

/// What of a wave of the fine lattice the coarse one holds.
fn kept(index: usize, fine: usize, coarse: usize) -> f64 {
    let waves = index.min(fine - index);
    match (2 * waves).cmp(&coarse) {
        std::cmp::Ordering::Less => 1.0,
        std::cmp::Ordering::Equal if fine > coarse => 0.5,
        std::cmp::Ordering::Equal => 1.0,
        std::cmp::Ordering::Greater => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Waves of the lattice, one of them of two cells, on an even and on an odd number of cells.
    #[test]
    fn waves_are_what_they_are_between_the_points() {
        for (columns, rows) in [(12, 8), (9, 7)] {
            let height = |x: f64, y: f64| {
                let (along, across) = (2.0 * PI * x / columns as f64, 2.0 * PI * y / rows as f64);
                let shortest = if columns % 2 == 0 { (PI * x).cos() } else { 0.0 };
                (3.0 * along + 0.3).sin() * (2.0 * across).cos()
                    + (along - 3.0 * across).cos()
                    + 0.5 * shortest
            };
            let heights: Vec<f64> = (0..columns * rows)
                .map(|index| height((index % columns) as f64, (index / columns) as f64))
                .collect();
            let lowest = heights.iter().copied().fold(f64::INFINITY, f64::min);
            let map = HeightMap::new(heights, columns, rows, 0.1, true).unwrap();
            for (factor, shift) in [(1, 0.0), (1, 0.4), (2, 0.0), (4, 0.3)] {
                let fine = interpolated(&map, factor, shift);
                for (index, found) in fine.iter().enumerate() {
                    let (column, row) = (index % (factor * columns), index / (factor * columns));
                    let x = (column as f64 - shift) / factor as f64;
                    let wanted = height(x, row as f64 / factor as f64) - lowest;
                    assert!((found - wanted).abs() < 1e-12, "{factor} {shift} {index}: {found} {wanted}");
                }
            }
        }
    }
}
