//! The contact area with the perimeter placed inside the cells.

use crate::kernel::substrate::SlidingSubstrate;
use crate::surface::grid::SurfaceGrid;

/// How the rows along the sliding go on beyond their ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum ContactEnds {
    /// Nothing presses there.
    Free,
    /// The row repeats itself.
    Periodic,
}

/// The area in contact, from pressures that are positive on the cells in contact.
///
/// Counting cells converges slowest of all results. Towards the edge of an elastic contact the pressure falls with the square
/// root of the distance, so its square is a straight line and its zero is the edge. Two pressures of a sliding contact do so at
/// any speed: at the trailing edge the pressure p itself, at the leading edge the pressure q = J p that would move an elastic
/// surface as far (the substrate remembers nothing there yet). The other of the two has a layer at the edge, as thin as the wake,
/// beyond which it falls to a zero outside the contact. So along every row and every column each run of cells in contact is
/// lengthened to the nearer of the zeros of p² and q² through its two outermost cells, by at most one cell from their centres.
/// The two sums, over rows and over columns, are averaged.
#[must_use]
pub fn contact_area(grid: &SurfaceGrid, pressure: &[f64], substrate: &SlidingSubstrate) -> f64 {
    let elastic = elastic_pressure(grid, pressure, substrate, ContactEnds::Free);
    area_of_lines(grid, pressure, &elastic, |line| length_in_contact(line))
}

/// The same on a grid that repeats itself: contacts go on across its edges.
#[must_use]
pub fn periodic_contact_area(grid: &SurfaceGrid, pressure: &[f64], substrate: &SlidingSubstrate) -> f64 {
    let elastic = elastic_pressure(grid, pressure, substrate, ContactEnds::Periodic);
    area_of_lines(grid, pressure, &elastic, |line| match line.iter().position(|cell| cell.pressure <= 0.0) {
        Some(open) => {
            line.rotate_left(open);
            length_in_contact(line)
        }
        None => line.len() as f64,
    })
}

/// The length in contact of a single row, in the grid's unit.
#[must_use]
pub fn contact_length(grid: &SurfaceGrid, pressure: &[f64], substrate: &SlidingSubstrate) -> f64 {
    let elastic = elastic_pressure(grid, pressure, substrate, ContactEnds::Free);
    let line: Vec<EdgeCell> = cells(pressure, &elastic).collect();
    length_in_contact(&line) * grid.cell
}

/// The pressure on a cell, and the one that would move an elastic surface as far.
#[derive(Debug, Clone, Copy)]
struct EdgeCell {
    pressure: f64,
    elastic: f64,
}

fn cells<'a>(pressure: &'a [f64], elastic: &'a [f64]) -> impl Iterator<Item = EdgeCell> + 'a {
    pressure
        .iter()
        .zip(elastic)
        .map(|(pressure, elastic)| EdgeCell { pressure: *pressure, elastic: *elastic })
}

/// q = E0/E∞ p + Σ C_k E0 ∫ e^{−t} p(x + ℓ_k t) dt, averaged over every cell of a pressure that is constant on each.
fn elastic_pressure(
    grid: &SurfaceGrid,
    pressure: &[f64],
    substrate: &SlidingSubstrate,
    ends: ContactEnds,
) -> Vec<f64> {
    let mut elastic: Vec<f64> = pressure.iter().map(|p| substrate.instantaneous * p).collect();
    for term in &substrate.terms {
        let (per_cell, columns) = (grid.cell / term.length, grid.columns);
        // what a cell forgets, and what of a memory is left in its mean
        let forgotten = -libm::expm1(-per_cell);
        let carried = if term.length > 0.0 { forgotten / per_cell } else { 0.0 };
        for (given, found) in pressure.chunks(columns).zip(elastic.chunks_mut(columns)) {
            let along =
                |memory: f64| given.iter().rev().fold(memory, |w, p| forgotten * p + (1.0 - forgotten) * w);
            let mut memory = match ends {
                ContactEnds::Free => 0.0,
                ContactEnds::Periodic => along(0.0) / -libm::expm1(-per_cell * columns as f64),
            };
            for (p, q) in given.iter().zip(found).rev() {
                *q += term.compliance * ((1.0 - carried) * p + carried * memory);
                memory = forgotten * p + (1.0 - forgotten) * memory;
            }
        }
    }
    elastic
}

/// The mean of the two sums of lengths, over rows and over columns.
fn area_of_lines(
    grid: &SurfaceGrid,
    pressure: &[f64],
    elastic: &[f64],
    length: impl Fn(&mut [EdgeCell]) -> f64,
) -> f64 {
    let mut line = Vec::with_capacity(grid.columns.max(grid.rows));
    let mut sum = 0.0;
    for row in 0..grid.rows {
        line.clear();
        line.extend(cells(pressure, elastic).skip(row * grid.columns).take(grid.columns));
        sum += 0.5 * length(&mut line);
    }
    for column in 0..grid.columns {
        line.clear();
        line.extend(cells(pressure, elastic).skip(column).step_by(grid.columns));
        sum += 0.5 * length(&mut line);
    }
    sum * grid.cell_area()
}

/// The length in contact along one line of cells, in cells.
fn length_in_contact(line: &[EdgeCell]) -> f64 {
    let is_closed = |cell: &usize| line[*cell].pressure > 0.0;
    let mut length = 0.0;
    let mut start = 0;
    while let Some(first) = (start..line.len()).find(is_closed) {
        let end = (first..line.len()).find(|cell| !is_closed(cell)).unwrap_or(line.len());
        let run = &line[first..end];
        let inner = run.len() - 1;
        length += inner as f64;
        length += if inner == 0 { 1.0 } else { beyond(run[0], run[1]) + beyond(run[inner], run[inner - 1]) };
        start = end;
    }
    length
}

/// How far beyond the centre of the outermost cell the contact reaches, in cells.
fn beyond(outermost: EdgeCell, next: EdgeCell) -> f64 {
    let zeros = [(outermost.pressure, next.pressure), (outermost.elastic, next.elastic)]
        .map(|(outer, inner)| zero(outer, inner));
    // where both rise towards the edge it stays at the side of the cell
    zeros.into_iter().flatten().reduce(f64::min).unwrap_or(0.5).min(1.0)
}

/// How far beyond the outer of two cells the square of a pressure is zero; `None` where it rises outwards.
fn zero(outer: f64, inner: f64) -> Option<f64> {
    let (outer, inner) = (outer * outer, inner * inner);
    (inner > outer).then(|| outer / (inner - outer))
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
        let area = contact_area(&grid, &pressure, &SlidingSubstrate::elastic());
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
            periodic_contact_area(&grid, &pressure, &SlidingSubstrate::elastic())
        };
        assert!((area(0) - area(32)).abs() < 1e-12, "{} {}", area(0), area(32));
    }

    #[test]
    fn nothing_in_contact_has_no_area_and_a_full_grid_its_own() {
        let grid = SurfaceGrid::square(8, [0.0, 0.0], 1.0);
        assert_eq!(contact_area(&grid, &[0.0; 64], &SlidingSubstrate::elastic()), 0.0);
        assert!((contact_area(&grid, &[1.0; 64], &SlidingSubstrate::elastic()) - 4.0).abs() < 1e-14);
    }
}
