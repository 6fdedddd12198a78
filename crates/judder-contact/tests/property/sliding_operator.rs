//! What holds for the operator of steady sliding whatever the substrate and the grid.

use judder_contact::kernel::cache::KernelCache;
use judder_contact::kernel::line::line_kernel;
use judder_contact::kernel::love;
use judder_contact::kernel::sliding::SlidingOperator;
use judder_contact::kernel::substrate::{SlidingSubstrate, WakeTerm};
use judder_contact::kernel::wake::WakeKernel;
use judder_contact::surface::grid::SurfaceGrid;
use judder_contact::surface::operator::SurfaceOperator;
use proptest::prelude::*;

fn grid(columns: usize, rows: usize, cell: f64) -> SurfaceGrid {
    SurfaceGrid { columns, rows, cell, origin: [0.0, 0.0] }
}

/// Pressures without any symmetry.
fn uneven(count: usize) -> Vec<f64> {
    (0..count).map(|index| (1.0 + (7.3 * index as f64).sin()).powi(2)).collect()
}

fn displaced(operator: &mut SlidingOperator, pressure: &[f64]) -> Vec<f64> {
    let mut displacement = vec![0.0; pressure.len()];
    operator.displacement(pressure, &mut displacement);
    displacement
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, value| value.abs().max(most))
}

#[track_caller]
fn assert_same(found: &[f64], wanted: &[f64], tolerance: f64) {
    let scale = largest(wanted);
    for (index, (found, wanted)) in found.iter().zip(wanted).enumerate() {
        assert!((found - wanted).abs() <= tolerance * scale, "{index}: {found} should be {wanted}");
    }
}

/// Σ K p cell by cell.
fn summed(kernel: &WakeKernel, cell: f64, pressure: &[f64]) -> Vec<f64> {
    let (columns, wide) = (kernel.columns, 2 * kernel.columns - 1);
    let entry = |at: usize, from: usize| {
        let along = at % columns + columns - 1 - from % columns;
        kernel.values[(at / columns).abs_diff(from / columns) * wide + along]
    };
    let sum = |at| pressure.iter().enumerate().map(|(from, value)| entry(at, from) * value).sum::<f64>();
    (0..pressure.len()).map(|at| cell * sum(at)).collect()
}

fn two_terms() -> SlidingSubstrate {
    let terms = vec![WakeTerm { compliance: 0.5, length: 0.3 }, WakeTerm { compliance: 0.4, length: 20.0 }];
    SlidingSubstrate { instantaneous: 0.1, terms, layer: None }
}

#[test]
fn a_product_is_the_sum_over_all_cells() {
    for (columns, rows) in [(1, 1), (2, 1), (1, 9), (7, 5), (16, 3), (13, 22)] {
        let (grid, substrate) = (grid(columns, rows, 0.37), two_terms());
        let mut operator = SlidingOperator::new(grid, &substrate, u64::MAX).unwrap();
        let in_cells = substrate.in_cells(grid.cell);
        let kernel = WakeKernel::new(columns, rows, in_cells.collocation_shift(1.0), &in_cells);
        let pressure = uneven(grid.len());
        assert_same(&displaced(&mut operator, &pressure), &summed(&kernel, grid.cell, &pressure), 1e-14);
        assert_eq!(operator.self_displacement(), kernel.at_itself() * grid.cell);
    }
}

#[test]
fn a_product_over_a_line_is_the_sum_over_its_strips() {
    let (grid, substrate) = (grid(23, 1, 0.37), two_terms());
    let mut operator = SlidingOperator::line(grid, &substrate, 50.0, u64::MAX).unwrap();
    let in_cells = substrate.in_cells(grid.cell);
    let kernel = line_kernel(23, in_cells.collocation_shift(1.0), 50.0 / grid.cell, &in_cells);
    let pressure = uneven(grid.len());
    assert_same(&displaced(&mut operator, &pressure), &summed(&kernel, grid.cell, &pressure), 1e-14);
}

#[test]
fn rows_in_reverse_order_give_displacements_in_reverse_order() {
    let grid = grid(12, 9, 0.5);
    let mut operator = SlidingOperator::new(grid, &two_terms(), u64::MAX).unwrap();
    let reverse = |values: &[f64]| values.chunks(12).rev().flatten().copied().collect::<Vec<f64>>();
    let pressure = uneven(grid.len());
    let straight = displaced(&mut operator, &pressure);
    assert_same(&reverse(&displaced(&mut operator, &reverse(&pressure))), &straight, 1e-14);
}

/// Sliding the other way is the transposed operator: p · K q = q · K⁻ p, with K⁻ the mirror of K along x.
#[test]
fn sliding_backwards_is_the_transposed_operator() {
    let grid = grid(14, 6, 0.5);
    let mut operator = SlidingOperator::new(grid, &two_terms(), u64::MAX).unwrap();
    let mirror =
        |values: &[f64]| values.chunks(14).flat_map(|row| row.iter().rev().copied()).collect::<Vec<f64>>();
    let (one, other) = (uneven(grid.len()), uneven(2 * grid.len())[grid.len()..].to_vec());
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let forwards = dot(&one, &displaced(&mut operator, &other));
    let backwards = dot(&other, &mirror(&displaced(&mut operator, &mirror(&one))));
    assert!((forwards / backwards - 1.0).abs() < 1e-13);
    assert!(!operator.is_symmetric());
}

#[test]
fn the_shortest_wakes_are_the_relaxed_half_space_and_the_longest_the_glassy_one() {
    let kernel = |length| WakeKernel::new(20, 20, 0.0, &SlidingSubstrate::single(10.0, length));
    let (short, long) = (kernel(1e-9), kernel(1e12));
    for (index, (short, long)) in short.values.iter().zip(&long.values).enumerate() {
        let elastic = love::displacement((index % 39) as f64 - 19.0, (index / 39) as f64);
        assert!((short / elastic - 1.0).abs() < 1e-8, "{index}: {short} {elastic}");
        assert!((long / (0.1 * elastic) - 1.0).abs() < 1e-8, "{index}: {long} {elastic}");
    }
}

#[test]
fn equal_wakes_add_and_a_wake_of_no_length_is_none() {
    let grid = grid(9, 7, 0.25);
    let term = |compliance, length| WakeTerm { compliance, length };
    let parts = vec![term(0.5, 2.0), term(0.125, 0.0), term(0.25, 2.0)];
    let mut parts = SlidingOperator::new(
        grid,
        &SlidingSubstrate { instantaneous: 0.125, terms: parts, layer: None },
        u64::MAX,
    )
    .unwrap();
    let whole = SlidingSubstrate { instantaneous: 0.25, terms: vec![term(0.75, 2.0)], layer: None };
    let pressure = uneven(grid.len());
    assert_eq!(
        displaced(&mut parts, &pressure),
        displaced(&mut SlidingOperator::new(grid, &whole, u64::MAX).unwrap(), &pressure)
    );
}

/// The kernel of a sum of terms is the sum of their kernels.
#[test]
fn terms_add() {
    let kernel = |instantaneous, terms: &[WakeTerm]| {
        WakeKernel::new(30, 30, 0.2, &SlidingSubstrate { instantaneous, terms: terms.to_vec(), layer: None })
            .values
    };
    let whole = two_terms();
    let [one, other] = whole.terms[..] else { panic!("two terms") };
    let both = kernel(0.1, &whole.terms);
    let parts = kernel(0.1, &[one]).into_iter().zip(kernel(0.0, &[other])).map(|(a, b)| a + b);
    assert_same(&parts.collect::<Vec<f64>>(), &both, 1e-15);
}

#[test]
fn a_cached_kernel_gives_the_same_bytes() {
    let cache = KernelCache::new(1 << 20);
    let pressure = uneven(99);
    for cell in [0.25, 0.25, 0.1 + 0.2] {
        // The same ratio of wake and cell, but for rounding.
        let (grid, substrate) = (grid(11, 9, cell), SlidingSubstrate::single(10.0, 12.7 * cell));
        let mut fresh = SlidingOperator::new(grid, &substrate, u64::MAX).unwrap();
        let mut cached = SlidingOperator::cached(grid, &substrate, u64::MAX, &cache).unwrap();
        assert_eq!(displaced(&mut cached, &pressure), displaced(&mut fresh, &pressure));
    }
    assert_eq!(cache.bytes(), judder_contact::kernel::spectra::KernelSpectra::memory_bytes(11, 9));
}

/// A smooth and compact pressure comes back from its displacement within the contact; towards the edges of the grid the
/// images of the approximate inverse are felt.
#[test]
fn the_approximate_inverse_undoes_the_operator() {
    let substrates = [
        SlidingSubstrate::elastic(),
        SlidingSubstrate::single(10.0, 0.05),
        SlidingSubstrate::single(100.0, 0.4),
    ];
    for substrate in substrates {
        let grid = SurfaceGrid::square(64, [0.0, 0.0], 2.0);
        let place = |cell: usize| (grid.x(cell % 64), grid.y(cell / 64));
        let mut operator = SlidingOperator::new(grid, &substrate, u64::MAX).unwrap();
        let pressure: Vec<f64> =
            (0..grid.len()).map(place).map(|(x, y)| x * (-4.0 * (x * x + y * y)).exp()).collect();
        let mut again = vec![0.0; grid.len()];
        let displacement = displaced(&mut operator, &pressure);
        operator.precondition(&displacement, &mut again);
        let within = |values: &[f64]| -> Vec<f64> {
            let inside = |cell: &usize| place(*cell).0.hypot(place(*cell).1) < 1.0;
            (0..grid.len()).filter(inside).map(|cell| values[cell]).collect()
        };
        assert_same(&within(&again), &within(&pressure), 0.1);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// Behind the load, where the wake is, the surface lies deeper than before it; everywhere it yields, and by no more than
    /// the relaxed half-space does somewhere.
    #[test]
    fn the_wake_lies_behind(contrast in 1.5..2000.0_f64, exponent in -8.0..8.0_f64, row in 0_usize..12) {
        let substrate = SlidingSubstrate::single(contrast, 10_f64.powf(exponent));
        let kernel = WakeKernel::new(40, 12, 0.0, &substrate);
        let values = &kernel.values[row * 79..(row + 1) * 79];
        for distance in 1..40 {
            let (behind, before) = (values[39 - distance], values[39 + distance]);
            prop_assert!(before > 0.0 && behind > before * (1.0 - 1e-12));
            prop_assert!(behind < love::displacement(0.0, 0.0));
        }
    }

    /// No grid and no substrate, however odd, panics: it is refused, or makes an operator.
    #[test]
    fn nothing_panics(
        columns in 0_usize..5, rows in 0_usize..5, cell in any::<f64>(), instantaneous in any::<f64>(),
        compliance in any::<f64>(), length in any::<f64>(),
    ) {
        let substrate = SlidingSubstrate { instantaneous, terms: vec![WakeTerm { compliance, length }], layer: None };
        let grid = grid(columns, rows, cell);
        if let Ok(mut operator) = SlidingOperator::new(grid, &substrate, u64::MAX) {
            let (pressure, mut out) = (vec![1.0; grid.len()], vec![0.0; grid.len()]);
            operator.displacement(&pressure, &mut out);
            operator.precondition(&pressure, &mut out);
        }
        let _ = SlidingOperator::line(grid, &substrate, cell, u64::MAX);
        let _ = SlidingOperator::periodic(grid, &substrate, u64::MAX);
    }
}
