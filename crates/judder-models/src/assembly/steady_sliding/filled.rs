//! Faces filled by what presses on them.

#![deny(clippy::indexing_slicing, reason = "stored arrays may be of any length")]

use super::faces::CORNERS;
use judder_study::pictures::{StoredArrays, at, wholes};

/// Cells of a drawn map along its longer side; a face of a usual mesh has some dozens.
const CELLS: usize = 300;
/// The least along the shorter side.
const FEWEST: usize = 40;

/// A coordinate of a place.
type PlaceCoordinate = fn(&[f64; 2]) -> f64;
/// Both of them.
const ALONG: [PlaceCoordinate; 2] = [|place| place[0], |place| place[1]];

/// Values on a lattice of places; not a number where no face lies.
pub(super) struct Filled {
    pub(super) x: Vec<f64>,
    pub(super) y: Vec<f64>,
    pub(super) z: Vec<f64>,
}

/// The corners of all faces, by numbers of points; none where the study has no faces.
pub(super) fn faces(dataset: &StoredArrays<'_>) -> Vec<[usize; CORNERS]> {
    let is_so = dataset.shaped("face", &[None, Some(CORNERS)]);
    let Some(corners) = is_so.and_then(|()| wholes(dataset, "face")) else { return Vec::new() };
    let face = |own: &[i64; CORNERS]| {
        let corners: Option<Vec<usize>> = own.iter().map(|k| usize::try_from(*k).ok()).collect();
        corners?.try_into().ok()
    };
    corners.as_chunks().0.iter().filter_map(face).collect()
}

/// Quadrilaterals between places with values at their corners, filled linearly on the two triangles of each.
pub(super) fn filled(quadrilaterals: &[[([f64; 2], f64); CORNERS]]) -> Option<Filled> {
    let ranges = ALONG.map(|along| {
        let places = quadrilaterals.iter().flatten().map(|(place, _)| along(place));
        [places.clone().fold(f64::INFINITY, f64::min), places.fold(f64::NEG_INFINITY, f64::max)]
    });
    let [wide, high] = ranges.map(|[from, to]| to - from);
    let is_surface = wide > 0.0 && high > 0.0 && wide.is_finite() && high.is_finite();
    if !is_surface {
        return None;
    }
    let longer = wide.max(high);
    let counts = [wide, high].map(|own| ((CELLS as f64 * own / longer) as usize).max(FEWEST));
    let centres = |[from, to]: [f64; 2], count: usize| -> Vec<f64> {
        let step = (to - from) / count as f64;
        (0..count).map(|k| from + (k as f64 + 0.5) * step).collect()
    };
    let (x, y) = (centres(ranges[0], counts[0]), centres(ranges[1], counts[1]));
    let mut map = Filled { x, y, z: vec![f64::NAN; counts[0] * counts[1]] };
    for corners in quadrilaterals {
        let [a, b, c, d] = *corners;
        map.fill([a, b, c], ranges);
        map.fill([a, c, d], ranges);
    }
    Some(map)
}

impl Filled {
    /// Fills the cells whose centres lie in a triangle.
    fn fill(&mut self, corners: [([f64; 2], f64); 3], ranges: [[f64; 2]; 2]) {
        let [a, b, c] = corners.map(|(place, _)| place);
        let twice_area = |p: [f64; 2], q: [f64; 2], r: [f64; 2]| {
            (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
        };
        let whole = twice_area(a, b, c);
        if whole == 0.0 {
            return;
        }
        let cells = |along: PlaceCoordinate, [from, to]: [f64; 2], count: usize| {
            let places = corners.map(|(place, _)| along(&place));
            let cell = |place: f64| {
                (((place - from) / (to - from) * count as f64) as usize).min(count.saturating_sub(1))
            };
            let [least, most] =
                [f64::min, f64::max].map(|pick| places.into_iter().reduce(pick).unwrap_or(from));
            cell(least)..=cell(most)
        };
        let columns = self.x.len();
        let rows = cells(ALONG[1], ranges[1], self.y.len());
        for row in rows {
            for column in cells(ALONG[0], ranges[0], columns) {
                let place = [at(&self.x, column), at(&self.y, row)];
                let shares = [twice_area(place, b, c), twice_area(a, place, c), twice_area(a, b, place)]
                    .map(|own| own / whole);
                // on the side between two triangles it may be just outside of both
                if shares.iter().all(|share| *share >= -1e-9) {
                    let values = shares.iter().zip(&corners).map(|(share, (_, value))| share * value);
                    if let Some(cell) = self.z.get_mut(row * columns + column) {
                        *cell = values.sum();
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quadrilateral_is_filled_linearly_and_nothing_beside_it() {
        let value = |[x, y]: [f64; 2]| 1.0 + 2.0 * x - y;
        let corner = |x: f64, y: f64| ([x, y], value([x, y]));
        let leaning = [corner(0.0, 0.0), corner(2.0, 0.5), corner(3.0, 2.0), corner(0.5, 1.5)];
        let map = filled(&[leaning]).unwrap();
        assert_eq!((map.x.len(), map.y.len()), (300, 200));
        let mut inside = 0;
        for (row, y) in map.y.iter().enumerate() {
            for (column, x) in map.x.iter().enumerate() {
                let found = map.z[row * map.x.len() + column];
                if found.is_finite() {
                    inside += 1;
                    assert!((found - value([*x, *y])).abs() < 1e-12);
                }
            }
        }
        // the area of the quadrilateral by the shoelace formula, over that of a cell
        let area = inside as f64 * 0.01 * 0.01;
        assert!((area - 3.0).abs() < 0.05, "{area}");
        assert!(filled(&[[corner(0.0, 0.0); 4]]).is_none());
    }
}
