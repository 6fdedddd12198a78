//! The kernel of long strips against its definition in 40 digits (`wake_oracle.py`), and against the elliptic pressure.

use crate::questions::assert_close;
use judder_contact::kernel::line::{line_kernel, reference_at_depth};
use judder_contact::kernel::sliding::SlidingOperator;
use judder_contact::kernel::substrate::{SlidingSubstrate, WakeTerm};
use judder_contact::surface::grid::SurfaceGrid;
use judder_contact::surface::operator::SurfaceOperator;
use std::f64::consts::PI;

/// x, y = 0, wake length (all in strips), displacement relative to 1000 strips.
const ORACLE: &str = include_str!("line_oracle.csv");

const STRIPS: usize = 129;

#[test]
fn the_kernel_of_strips_agrees_with_its_definition() {
    let mut places = 0;
    for line in ORACLE.lines() {
        let numbers: Vec<f64> = line.split(',').map(|number| number.parse().unwrap()).collect();
        let [x, _, length, expected] = numbers[..] else { panic!("{line}") };
        let column = x.ceil();
        let substrate = SlidingSubstrate {
            instantaneous: 0.0,
            terms: vec![WakeTerm { compliance: 1.0, length }],
            layer: None,
        };
        let kernel = line_kernel(STRIPS, column - x, 1000.0, &substrate);
        let error = kernel.values[(column + STRIPS as f64 - 1.0) as usize] / expected - 1.0;
        assert!(error.abs() < 1e-10, "x {x}, length {length}: {error:.1e}");
        places += 1;
    }
    assert_eq!(places, 176);
}

fn displaced(operator: &mut SlidingOperator, pressure: &[f64]) -> Vec<f64> {
    let mut displacement = vec![0.0; pressure.len()];
    operator.displacement(pressure, &mut displacement);
    displacement
}

/// A semi-elliptic pressure a/(2R) √(1 − x²/a²) makes the parabola x²/(2R) (Johnson, Contact Mechanics, 4.2).
#[test]
fn an_elliptic_pressure_presses_a_cylinder_into_an_elastic_half_space() {
    let strips = 400;
    let grid = SurfaceGrid { columns: strips, rows: 1, cell: 2.4 / strips as f64, origin: [-1.2, 0.0] };
    let mut operator = SlidingOperator::line(grid, &SlidingSubstrate::elastic(), 100.0, u64::MAX).unwrap();
    let pressure: Vec<f64> =
        (0..strips).map(|strip| 0.5 * (1.0 - grid.x(strip).powi(2)).max(0.0).sqrt()).collect();
    let displacement = displaced(&mut operator, &pressure);
    let depth = displacement[strips / 2];
    for (strip, value) in displacement.iter().enumerate().filter(|(strip, _)| grid.x(*strip).abs() < 0.95) {
        let height = 0.5 * grid.x(strip).powi(2);
        assert!((depth - value - height).abs() < 1e-4, "{}: {} {height}", grid.x(strip), depth - value);
    }
    // Relative to a distance d the cylinder sinks by F/π (2 ln(2d/a) + 1) with F = π a²/(4R), from the logarithmic
    // potential of a semi-ellipse at its centre.
    assert_close(depth, 0.25 * (2.0 * 200.0_f64.ln() + 1.0), 1e-3);
}

/// d enters as (2/π) ln d times the relaxed compliance times the force, wakes or not.
#[test]
fn the_reference_distance_moves_all_strips_alike() {
    let grid = SurfaceGrid { columns: 50, rows: 1, cell: 0.1, origin: [0.0, 0.0] };
    let substrate = SlidingSubstrate::single(10.0, 2.0);
    let pressure: Vec<f64> = (0..50).map(|strip| f64::from(strip % 7)).collect();
    let force: f64 = pressure.iter().sum::<f64>() * grid.cell;
    let far = reference_at_depth(1e3, 0.5);
    let [near, far] = [10.0, far]
        .map(|reference| (reference, SlidingOperator::line(grid, &substrate, reference, u64::MAX).unwrap()))
        .map(|(reference, mut operator)| (reference, displaced(&mut operator, &pressure)));
    let expected = 2.0 / PI * (far.0 / near.0).ln() * force * substrate.relaxed();
    for (near, far) in near.1.iter().zip(&far.1) {
        assert_close(far - near, expected, 1e-12);
    }
}
