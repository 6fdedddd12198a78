//! The contact area with the perimeter placed inside the cells.

use crate::surface::grid::SurfaceGrid;

/// The area in contact, from pressures that are positive on the cells in contact.
///
/// Counting cells converges slowest of all results. Towards the edge of a contact the pressure falls with the square
/// root of the distance, so p² is a straight line and its zero is the edge: along every row and along every column each
/// run of cells in contact is lengthened to the zeros of p² through its two outermost cells, by at most one cell from
/// their centres. Where the pressure rises towards the edge the edge stays at the side of the cell. The two sums,
/// over rows and over columns, are averaged.
#[must_use]
pub fn contact_area(grid: &SurfaceGrid, pressure: &[f64]) -> f64 {
    area_of_lines(grid, pressure, |line| length_in_contact(line))
}

/// The same on a grid that repeats itself: contacts go on across its edges.
#[must_use]
pub fn periodic_contact_area(grid: &SurfaceGrid, pressure: &[f64]) -> f64 {
    area_of_lines(grid, pressure, |line| match line.iter().position(|value| *value <= 0.0) {
        Some(open) => {
            line.rotate_left(open);
            length_in_contact(line)
        }
        None => line.len() as f64,
    })
}

/// The mean of the two sums of lengths, over rows and over columns.
fn area_of_lines(grid: &SurfaceGrid, pressure: &[f64], length: impl Fn(&mut [f64]) -> f64) -> f64 {
    let mut line = Vec::with_capacity(grid.columns.max(grid.rows));
    let mut cells = 0.0;
    for row in 0..grid.rows {
        line.clear();
        line.extend_from_slice(&pressure[row * grid.columns..(row + 1) * grid.columns]);
        cells += 0.5 * length(&mut line);
    }
    for column in 0..grid.columns {
        line.clear();
        line.extend((0..grid.rows).map(|row| pressure[row * grid.columns + column]));
        cells += 0.5 * length(&mut line);
    }
    cells * grid.cell_area()
}

/// The length in contact along one line of cells, in cells.
pub(super) fn length_in_contact(line: &[f64]) -> f64 {
    let mut length = 0.0;
    let mut start = 0;
    while let Some(first) = (start..line.len()).find(|cell| line[*cell] > 0.0) {
        let end = (first..line.len()).find(|cell| line[*cell] <= 0.0).unwrap_or(line.len());
        let run = &line[first..end];
        let inner = run.len() - 1;
        length += inner as f64;
        length += if inner == 0 { 1.0 } else { beyond(run[0], run[1]) + beyond(run[inner], run[inner - 1]) };
        start = end;
    }
    length
}

/// How far beyond the centre of the outermost cell p² reaches zero, in cells.
fn beyond(outermost: f64, next: f64) -> f64 {
    if next <= outermost {
        return 0.5;
    }
    let (outer, inner) = (outermost * outermost, next * next);
    (outer / (inner - outer)).min(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Hertz's pressure over a circle: the area is π to a tenth of a per cent where counting is off by more.
    #[test]
    fn the_circle_of_hertz_is_measured_within_its_cells() {
        let grid = SurfaceGrid::square(64, [0.013, -0.007], 1.2);
        let pressure: Vec<f64> = (0..grid.len())
            .map(|cell| {
                let (x, y) = (grid.x(cell % 64), grid.y(cell / 64));
                (1.0 - x * x - y * y).max(0.0).sqrt()
            })
            .collect();
        let area = contact_area(&grid, &pressure);
        assert!((area / std::f64::consts::PI - 1.0).abs() < 1.5e-3, "{area}");
    }

    /// A circle cut by the edges of a period is as large as a whole one.
    #[test]
    fn a_contact_across_the_edges_of_a_period_is_one() {
        let area = |shift: usize| {
            let grid = SurfaceGrid::square(64, [0.0, 0.0], 1.2);
            let pressure: Vec<f64> = (0..grid.len())
                .map(|cell| {
                    let (x, y) = (grid.x((cell + shift) % 64), grid.y((cell / 64 + shift) % 64));
                    (1.0 - x * x - y * y).max(0.0).sqrt()
                })
                .collect();
            periodic_contact_area(&grid, &pressure)
        };
        assert!((area(0) - area(32)).abs() < 1e-12, "{} {}", area(0), area(32));
    }

    #[test]
    fn nothing_in_contact_has_no_area_and_a_full_grid_its_own() {
        let grid = SurfaceGrid::square(8, [0.0, 0.0], 1.0);
        assert_eq!(contact_area(&grid, &[0.0; 64]), 0.0);
        assert!((contact_area(&grid, &[1.0; 64]) - 4.0).abs() < 1e-14);
    }
}
