//! The fast solver against a dense matrix of the same kernel and elimination, on 24² cells.

use judder_contact::kernel::sliding::SlidingOperator;
use judder_contact::kernel::substrate::SlidingSubstrate;
use judder_contact::kernel::wake::WakeKernel;
use judder_contact::surface::grid::SurfaceGrid;
use judder_contact::surface::operator::SurfaceOperator;
use judder_contact::unilateral::active_set::{UnilateralStart, solve};
use judder_contact::unilateral::{Loading, UnilateralLimits, UnilateralProblem};

const SIDE: usize = 24;

#[test]
fn a_dense_solve_finds_the_same_pressure() {
    let grid = SurfaceGrid::square(SIDE, [0.0, 0.0], 1.3);
    for substrate in [SlidingSubstrate::single(10.0, 1.0), SlidingSubstrate::elastic()] {
        let mut operator = SlidingOperator::new(grid, &substrate, u64::MAX).unwrap();
        let shift = operator.collocation_shift();
        let heights: Vec<f64> = (0..grid.len())
            .map(|cell| {
                let (x, y) = (grid.x(cell % SIDE) - shift, grid.y(cell / SIDE));
                0.5 * (x * x + y * y)
            })
            .collect();
        let problem = UnilateralProblem { heights: &heights, loading: Loading::Indentation(1.0) };
        let start = UnilateralStart { pressure: &vec![0.0; grid.len()], indentation: 1.0 };
        let limits = UnilateralLimits { tolerance: 1e-11, ..UnilateralLimits::default() };
        let fast = solve(&mut operator, &problem, start, limits).unwrap();
        assert!(fast.converged, "{:?}", fast.errors);
        let kernel = WakeKernel::new(SIDE, SIDE, shift / grid.cell, &substrate.in_cells(grid.cell));
        let dense = dense_pressure(&kernel, grid.cell, &heights);
        for (found, wanted) in fast.pressure.iter().zip(&dense) {
            assert!((found - wanted).abs() < 1e-8, "{found} {wanted}");
        }
    }
}

/// Cells that pull leave the contact one generation at a time, cells that penetrate enter it, each solved by elimination.
fn dense_pressure(kernel: &WakeKernel, cell: f64, heights: &[f64]) -> Vec<f64> {
    let entry = |at: usize, from: usize| {
        let row = (at / SIDE).abs_diff(from / SIDE);
        cell * kernel.values[row * (2 * SIDE - 1) + at % SIDE + SIDE - 1 - from % SIDE]
    };
    let mut inside: Vec<bool> = heights.iter().map(|height| *height < 1.0).collect();
    for _ in 0..50 {
        let cells: Vec<usize> = (0..inside.len()).filter(|cell| inside[*cell]).collect();
        let matrix = cells.iter().map(|at| cells.iter().map(|from| entry(*at, *from)).collect()).collect();
        let solved = eliminate(matrix, cells.iter().map(|cell| 1.0 - heights[*cell]).collect());
        let mut pressure = vec![0.0; inside.len()];
        for (cell, value) in cells.iter().zip(&solved) {
            pressure[*cell] = *value;
        }
        let next: Vec<bool> = (0..inside.len())
            .map(|at| {
                let displacement: f64 = cells.iter().map(|from| entry(at, *from) * pressure[*from]).sum();
                if inside[at] { pressure[at] > 0.0 } else { displacement + heights[at] - 1.0 < -1e-12 }
            })
            .collect();
        if next == inside {
            return pressure;
        }
        inside = next;
    }
    unreachable!("the dense active set did not come to rest")
}

/// Gaussian elimination with partial pivoting.
fn eliminate(mut matrix: Vec<Vec<f64>>, mut right: Vec<f64>) -> Vec<f64> {
    let size = right.len();
    for column in 0..size {
        let pivot = (column..size)
            .max_by(|a, b| matrix[*a][column].abs().total_cmp(&matrix[*b][column].abs()))
            .unwrap();
        matrix.swap(column, pivot);
        right.swap(column, pivot);
        let (above, below) = matrix.split_at_mut(column + 1);
        let pivot_row = &above[column];
        for (offset, row) in below.iter_mut().enumerate() {
            let factor = row[column] / pivot_row[column];
            for (value, pivot) in row[column..].iter_mut().zip(&pivot_row[column..]) {
                *value -= factor * pivot;
            }
            right[column + 1 + offset] -= factor * right[column];
        }
    }
    for row in (0..size).rev() {
        let known: f64 = (row + 1..size).map(|column| matrix[row][column] * right[column]).sum();
        right[row] = (right[row] - known) / matrix[row][row];
    }
    right
}
