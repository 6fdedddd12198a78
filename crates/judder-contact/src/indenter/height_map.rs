//! Heights on a lattice, interpolated between its points.

use super::error::IndenterError;
use crate::steady::profile::OUT_OF_REACH;
use crate::surface::grid::SurfaceGrid;
use std::f64::consts::{PI, SQRT_2};

/// Fewest heights a side: the interpolation takes four.
const LEAST: usize = 4;
/// Halvings of the interval in which the depth of a force is sought: below rounding.
const HALVINGS: usize = 100;

/// Heights of an indenter's surface above its lowest point, on a square lattice; lengths in the problem's unit.
///
/// The lowest point of the lattice touches first and stands at the origin. Where large values of a measured topography
/// point towards the substrate, [`turned_over`](Self::turned_over) is meant. Between the points the
/// interpolation is bicubic (Catmull and Rom 1974): smooth, exact on the lattice and for parabolas.
/// Outside a map that does not repeat itself the indenter is out of reach.
#[derive(Debug, Clone, PartialEq)]
pub struct HeightMap {
    heights: Vec<f64>,
    columns: usize,
    rows: usize,
    spacing: f64,
    periodic: bool,
    lowest: usize,
}

impl HeightMap {
    /// A map of `rows` × `columns` heights, row-major with x fastest, `spacing` apart.
    ///
    /// # Errors
    /// [`IndenterError::HeightsDoNotFit`], [`IndenterError::TooFewHeights`], [`IndenterError::HeightNotFinite`] with the
    /// place, [`IndenterError::NotPositive`] for the spacing.
    pub fn new(
        mut heights: Vec<f64>,
        columns: usize,
        rows: usize,
        spacing: f64,
        periodic: bool,
    ) -> Result<Self, IndenterError> {
        if columns.checked_mul(rows) != Some(heights.len()) {
            return Err(IndenterError::HeightsDoNotFit { found: heights.len(), rows, columns });
        }
        if columns < LEAST || rows < LEAST {
            return Err(IndenterError::TooFewHeights { rows, columns, least: LEAST });
        }
        if let Some(index) = heights.iter().position(|height| !height.is_finite()) {
            let (row, column) = (index / columns, index % columns);
            return Err(IndenterError::HeightNotFinite { row, column, value: heights[index] });
        }
        if !(spacing > 0.0 && spacing.is_finite()) {
            return Err(IndenterError::NotPositive { what: "spacing of the heights", value: spacing });
        }
        let lowest = (0..heights.len()).min_by(|a, b| heights[*a].total_cmp(&heights[*b])).unwrap_or(0);
        let bottom = heights[lowest];
        heights.iter_mut().for_each(|height| *height -= bottom);
        Ok(Self { heights, columns, rows, spacing, periodic, lowest })
    }

    /// The map of the same topography whose peaks touch first: every height h becomes max h − h.
    #[must_use]
    pub fn turned_over(&self) -> Self {
        let highest = (0..self.heights.len()).max_by(|a, b| self.heights[*a].total_cmp(&self.heights[*b]));
        let lowest = highest.unwrap_or(0);
        let top = self.heights[lowest];
        let heights = self.heights.iter().map(|height| top - height).collect();
        Self { heights, lowest, ..*self }
    }

    /// The same map with this length as the unit of its own.
    #[must_use]
    pub fn in_units_of(self, length: f64) -> Self {
        let heights = self.heights.iter().map(|height| height / length).collect();
        Self { heights, spacing: self.spacing / length, ..self }
    }

    /// The heights, `rows` × `columns`, the lowest zero.
    #[must_use]
    pub fn heights(&self) -> &[f64] {
        &self.heights
    }

    /// The lattice's cells, with the lowest point at the origin.
    #[must_use]
    pub fn grid(&self) -> SurfaceGrid {
        let (row, column) = (self.lowest / self.columns, self.lowest % self.columns);
        let origin = [-(column as f64 + 0.5) * self.spacing, -(row as f64 + 0.5) * self.spacing];
        SurfaceGrid { columns: self.columns, rows: self.rows, cell: self.spacing, origin }
    }

    /// Distance of neighbouring heights.
    #[must_use]
    pub fn spacing(&self) -> f64 {
        self.spacing
    }

    /// Whether the surface repeats itself beyond its edges.
    #[must_use]
    pub fn is_periodic(&self) -> bool {
        self.periodic
    }

    /// The lowest height on the edge of a map that does not repeat itself: pressed deeper, the contact could leave the map.
    #[must_use]
    pub fn edge_height(&self) -> f64 {
        if self.periodic {
            return f64::INFINITY;
        }
        let at_edge = |index: usize| {
            let (row, column) = (index / self.columns, index % self.columns);
            row == 0 || column == 0 || row + 1 == self.rows || column + 1 == self.columns
        };
        let edge = self.heights.iter().enumerate().filter(|(index, _)| at_edge(*index));
        edge.map(|(_, height)| *height).fold(f64::INFINITY, f64::min)
    }

    /// The height at a point, the lowest point of the lattice being the origin.
    #[must_use]
    pub fn height(&self, x: f64, y: f64) -> f64 {
        let along = x / self.spacing + (self.lowest % self.columns) as f64;
        let across = y / self.spacing + (self.lowest / self.columns) as f64;
        let beyond = |position: f64, count: usize| !(-0.5..=count as f64 - 0.5).contains(&position);
        if !self.periodic && (beyond(along, self.columns) || beyond(across, self.rows)) {
            return OUT_OF_REACH;
        }
        let (column, right) = (along.floor(), along - along.floor());
        let (row, down) = (across.floor(), across - across.floor());
        let lines = [-1.0, 0.0, 1.0, 2.0].map(|step| {
            self.through_ghosts(row + step, self.rows, |line| {
                let values = [-1.0, 0.0, 1.0, 2.0].map(|step| {
                    self.through_ghosts(column + step, self.columns, |place| {
                        self.heights[line * self.columns + place]
                    })
                });
                between(values, right)
            })
        });
        between(lines, down)
    }

    /// A value at an index that may lie outside: of the repeated map, or of the parabola through the last three inside.
    fn through_ghosts(&self, index: f64, count: usize, value: impl Fn(usize) -> f64) -> f64 {
        if self.periodic {
            return value((index as i64).rem_euclid(count as i64) as usize);
        }
        let last = count as f64 - 1.0;
        let (edge, inward, outside) = if index < 0.0 {
            (0, 1_isize, -index)
        } else if index > last {
            (count - 1, -1, index - last)
        } else {
            return value(index as usize);
        };
        let [first, second, third] = [0, 1, 2].map(|step| value(edge.saturating_add_signed(inward * step)));
        let (slope, bend) = (first - second, first - 2.0 * second + third);
        first + outside * slope + 0.5 * outside * (outside + 1.0) * bend
    }

    /// Half the side of the square about the lowest point that holds all heights below `depth`, and a cell more.
    #[must_use]
    pub fn extent(&self, depth: f64) -> f64 {
        let grid = self.grid();
        let below = self.heights.iter().enumerate().filter(|(_, height)| **height < depth);
        let farthest = below
            .map(|(index, _)| grid.x(index % self.columns).abs().max(grid.y(index / self.columns).abs()))
            .fold(0.0, f64::max);
        farthest + self.spacing
    }

    /// A guess of the depth at which the elastic force is `force`: that of flat punches as large as the overlap.
    ///
    /// F = (8/3) √(A/2π) d with the area A of the overlap and its mean depth d; exact for a paraboloid.
    #[must_use]
    pub fn elastic_depth(&self, force: f64) -> f64 {
        let carried = |depth: f64| {
            let (mut count, mut overlap) = (0_usize, 0.0);
            for height in self.heights.iter().filter(|height| **height < depth) {
                count += 1;
                overlap += depth - height;
            }
            let area = count as f64 * self.spacing * self.spacing;
            let mean = if count > 0 { overlap / count as f64 } else { 0.0 };
            4.0 / 3.0 * SQRT_2 * (area / PI).sqrt() * mean
        };
        let mut high = self.spacing;
        while carried(high) < force && high.is_finite() {
            high *= 2.0;
        }
        let mut low = 0.0;
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if carried(middle) < force { low = middle } else { high = middle }
        }
        high
    }
}

/// The cubic of Catmull and Rom between the second and the third of four equally spaced values.
fn between([before, left, right, after]: [f64; 4], part: f64) -> f64 {
    let slope = 0.5 * (right - before);
    let bend = before - 2.5 * left + 2.0 * right - 0.5 * after;
    let twist = 0.5 * (after - before) + 1.5 * (left - right);
    left + part * (slope + part * (bend + part * twist))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bowl(periodic: bool) -> HeightMap {
        let heights = (0..400).map(|index| {
            let (x, y) = ((index % 20) as f64 - 9.0, (index / 20) as f64 - 8.0);
            0.005 * (x * x + y * y) + 3.0
        });
        HeightMap::new(heights.collect(), 20, 20, 0.1, periodic).unwrap()
    }

    #[test]
    fn a_sampled_paraboloid_is_a_paraboloid_up_to_its_edge() {
        let map = bowl(false);
        for (x, y) in [(0.0, 0.0), (0.03, -0.21), (-0.93, 0.4), (1.04, 1.1), (-0.94, -0.84)] {
            assert!((map.height(x, y) - 0.5 * (x * x + y * y)).abs() < 1e-13, "{x} {y}");
        }
        assert_eq!(map.height(1.3, 0.0), OUT_OF_REACH);
        assert!((map.edge_height() - 0.5 * 0.8 * 0.8).abs() < 1e-12);
    }

    #[test]
    fn depth_and_extent_of_a_sampled_paraboloid() {
        let map = bowl(false);
        let force = 4.0 / 3.0 * 0.2_f64.powf(1.5);
        assert!((map.elastic_depth(force) / 0.2 - 1.0).abs() < 0.02, "{}", map.elastic_depth(force));
        assert!((map.extent(0.2) - 0.7).abs() < 1e-12);
    }

    #[test]
    fn a_periodic_map_repeats_itself() {
        let map = bowl(true);
        for (x, y) in [(0.37, 0.11), (0.95, -0.83)] {
            assert!((map.height(x, y) - map.height(x - 2.0, y + 4.0)).abs() < 1e-13);
        }
        assert_eq!(map.edge_height(), f64::INFINITY);
    }

    #[test]
    fn turned_over_the_peaks_touch() {
        let turned = bowl(false).turned_over();
        let highest = turned.turned_over();
        assert_eq!(turned.height(0.0, 0.0), 0.0);
        assert!(highest.heights().iter().zip(bowl(false).heights()).all(|(a, b)| (a - b).abs() < 1e-15));
    }

    #[test]
    fn bad_maps_are_refused_with_the_place() {
        let mut heights = vec![0.0; 20];
        heights[13] = f64::NAN;
        let error = HeightMap::new(heights.clone(), 5, 4, 1.0, false).unwrap_err();
        let message =
            "the height at row 2, column 3 (counted from 0) is NaN, not a finite number; fill the gaps first";
        assert_eq!(error.to_string(), message);
        heights[13] = 0.0;
        let shape = |columns, rows, spacing| HeightMap::new(heights.clone(), columns, rows, spacing, false);
        assert!(matches!(shape(10, 2, 1.0), Err(IndenterError::TooFewHeights { .. })));
        assert!(matches!(shape(6, 4, 1.0), Err(IndenterError::HeightsDoNotFit { .. })));
        assert!(matches!(shape(5, 4, 0.0), Err(IndenterError::NotPositive { .. })));
    }
}
