//! Faces filled by what presses on them.

use super::faces::CORNERS;
use judder_store::{Dataset, VariableValues};

/// Cells of a drawn map along its longer side; a face of a usual mesh has some dozens.
const CELLS: usize = 300;
/// The least along the shorter side.
const FEWEST: usize = 40;

/// Values on a lattice of places; not a number where no face lies.
pub(super) struct Filled {
    pub(super) x: Vec<f64>,
    pub(super) y: Vec<f64>,
    pub(super) z: Vec<f64>,
}

/// The corners of all faces, by numbers of points; none where the study has no faces.
pub(super) fn faces(dataset: &Dataset) -> Vec<[usize; CORNERS]> {
    let Some(VariableValues::I64(corners)) = dataset.variable("face").map(|own| &own.data) else {
        return Vec::new();
    };
    let face = |own: &[i64]| {
        let corners: Option<Vec<usize>> = own.iter().map(|k| usize::try_from(*k).ok()).collect();
        corners?.try_into().ok()
    };
    corners.chunks_exact(CORNERS).filter_map(face).collect()
}

/// Quadrilaterals between places with values at their corners, filled linearly on the two triangles of each.
pub(super) fn filled(quadrilaterals: &[[([f64; 2], f64); CORNERS]]) -> Option<Filled> {
    let range = |axis: usize| {
        let places = quadrilaterals.iter().flatten().map(|(place, _)| place[axis]);
        [places.clone().fold(f64::INFINITY, f64::min), places.fold(f64::NEG_INFINITY, f64::max)]
    };
    let ranges = [range(0), range(1)];
    let [wide, high] = ranges.map(|[from, to]| to - from);
    let is_surface = wide > 0.0 && high > 0.0 && wide.is_finite() && high.is_finite();
    if !is_surface {
        return None;
    }
    let longer = wide.max(high);
    let counts = [wide, high].map(|own| ((CELLS as f64 * own / longer) as usize).max(FEWEST));
    let centres = |axis: usize| -> Vec<f64> {
        let [from, to] = ranges[axis];
        let step = (to - from) / counts[axis] as f64;
        (0..counts[axis]).map(|k| from + (k as f64 + 0.5) * step).collect()
    };
    let mut map = Filled { x: centres(0), y: centres(1), z: vec![f64::NAN; counts[0] * counts[1]] };
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
        let counts = [self.x.len(), self.y.len()];
        let cells = |axis: usize| {
            let places = corners.map(|(place, _)| place[axis]);
            let [from, to] = ranges[axis];
            let cell = |place: f64| {
                (((place - from) / (to - from) * counts[axis] as f64) as usize).min(counts[axis] - 1)
            };
            let [least, most] =
                [f64::min, f64::max].map(|pick| places.into_iter().reduce(pick).unwrap_or(from));
            cell(least)..=cell(most)
        };
        for row in cells(1) {
            for column in cells(0) {
                let place = [self.x[column], self.y[row]];
                let shares = [twice_area(place, b, c), twice_area(a, place, c), twice_area(a, b, place)]
                    .map(|own| own / whole);
                // on the side between two triangles it may be just outside of both
                if shares.iter().all(|share| *share >= -1e-9) {
                    let values = shares.iter().zip(&corners).map(|(share, (_, value))| share * value);
                    self.z[row * counts[0] + column] = values.sum();
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
