//! Surfaces that repeat themselves: sinusoids in closed form, and the kernel without images where wakes are short.

use crate::questions::assert_close;
use judder_contact::kernel::periodic::PERIODIC_MEMORY;
use judder_contact::kernel::sliding::SlidingOperator;
use judder_contact::kernel::substrate::SlidingSubstrate;
use judder_contact::surface::grid::SurfaceGrid;
use judder_contact::surface::operator::SurfaceOperator;
use std::f64::consts::PI;

/// A sinusoid in full contact shears its substrate by q²Δ² E″(qv)/[4(1−ν²)] (Persson 2001). For one retardation time
/// E = E0 (1 + iωτ)/(1 + iωρ) with ρ = τ E0/E∞, so E″/E0 = ω(τ − ρ)/(1 + ω²ρ²).
#[test]
fn a_sinusoid_in_full_contact_shears_by_the_loss_modulus() {
    let (columns, rows, waves) = (63, 12, 5.0);
    for (contrast, length) in [(10.0, 1e-3), (10.0, 0.02), (1000.0, 0.1)] {
        let grid = SurfaceGrid { columns, rows, cell: 1.0 / columns as f64, origin: [0.0, 0.0] };
        let substrate = SlidingSubstrate::single(contrast, length);
        let mut operator = SlidingOperator::periodic(grid, &substrate, u64::MAX).unwrap();
        let wave = 2.0 * PI * waves;
        let pressure: Vec<f64> = (0..grid.len()).map(|cell| (wave * grid.x(cell % columns)).cos()).collect();
        let mut displacement = vec![0.0; grid.len()];
        operator.displacement(&pressure, &mut displacement);
        let (mut in_phase, mut behind) = (0.0, 0.0);
        for (cell, value) in displacement.iter().enumerate() {
            let (sine, cosine) = (wave * (grid.x(cell % columns) - operator.collocation_shift())).sin_cos();
            in_phase += 2.0 * value * cosine / grid.len() as f64;
            behind -= 2.0 * value * sine / grid.len() as f64;
        }
        // The pressure times the slope of the surface under it, averaged over a wave.
        let shear = 0.5 * wave * behind;
        let amplitude_squared = in_phase * in_phase + behind * behind;
        let (slow, fast) = (wave * length, wave * length / contrast);
        let loss = (slow - fast) / (1.0 + fast * fast);
        assert_close(shear, wave * wave * amplitude_squared * loss / 4.0, 1e-12);
    }
}

/// A bi-sinusoid on an elastic surface: u = 2 p/(E0* |q|), |q| of the two waves together.
#[test]
fn a_bi_sinusoid_on_an_elastic_surface_yields_by_twice_the_pressure_over_its_wave_number() {
    let grid = SurfaceGrid { columns: 40, rows: 24, cell: 0.1, origin: [0.0, 0.0] };
    let mut operator = SlidingOperator::periodic(grid, &SlidingSubstrate::elastic(), u64::MAX).unwrap();
    let (along, across) = (2.0 * PI * 3.0 / 4.0, 2.0 * PI * 2.0 / 2.4);
    let pressure: Vec<f64> = (0..grid.len())
        .map(|cell| (along * grid.x(cell % 40)).cos() * (across * grid.y(cell / 40)).sin())
        .collect();
    let mut displacement = vec![0.0; grid.len()];
    operator.displacement(&pressure, &mut displacement);
    for (displacement, pressure) in displacement.iter().zip(&pressure) {
        assert!((displacement - 2.0 * pressure / along.hypot(across)).abs() < 1e-14);
    }
    assert!(operator.is_symmetric());
}

/// The drag of a Hertzian pressure of radius 1: ∫ p ∂u/∂x.
fn drag(operator: &mut SlidingOperator) -> f64 {
    let grid = *operator.grid();
    let columns = grid.columns;
    let pressure: Vec<f64> = (0..grid.len())
        .map(|cell| (1.0 - grid.x(cell % columns).powi(2) - grid.y(cell / columns).powi(2)).max(0.0).sqrt())
        .collect();
    let mut displacement = vec![0.0; grid.len()];
    operator.displacement(&pressure, &mut displacement);
    let slope = |cell: usize| (displacement[cell + 1] - displacement[cell - 1]) / (2.0 * grid.cell);
    (columns..grid.len() - columns).map(|cell| pressure[cell] * slope(cell) * grid.cell_area()).sum()
}

/// Both forms drag alike where wakes are short against the period, and on the same side.
#[test]
fn short_wakes_drag_alike_with_images_and_without() {
    let grid = SurfaceGrid::square(128, [0.0, 0.0], 8.0);
    for length in [0.1, 0.5, 1.0] {
        let substrate = SlidingSubstrate::single(10.0, length);
        let alone = drag(&mut SlidingOperator::new(grid, &substrate, u64::MAX).unwrap());
        let repeated = drag(&mut SlidingOperator::periodic(grid, &substrate, u64::MAX).unwrap());
        assert!(alone < 0.0);
        assert_close(repeated, alone, 1e-2);
    }
}

/// What the longest wake that is not refused costs an indenter that does not repeat itself: the closer its images, the more.
#[test]
fn the_longest_wake_allowed_costs_little_where_periods_are_wide() {
    for (period, allowed) in [(4.4, 0.1), (8.8, 0.03), (17.6, 0.01)] {
        let grid = SurfaceGrid::square((20.0 * period) as usize, [0.0, 0.0], 0.5 * period);
        let substrate = SlidingSubstrate::single(10.0, period / (0.901 / PERIODIC_MEMORY).ln());
        let alone = drag(&mut SlidingOperator::new(grid, &substrate, u64::MAX).unwrap());
        let repeated = drag(&mut SlidingOperator::periodic(grid, &substrate, u64::MAX).unwrap());
        let deviation = (repeated / alone - 1.0).abs();
        assert!((0.5 * allowed..allowed).contains(&deviation), "{period}: {deviation}");
    }
}
