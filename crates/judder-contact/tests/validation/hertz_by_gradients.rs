//! Hertz (1882) by conjugate gradients, and through a height map.

use crate::questions::{assert_close, on_grid};
use judder_contact::indenter::{HeightMap, IndenterShape};
use judder_contact::kernel::sliding::SlidingOperator;
use judder_contact::kernel::substrate::SlidingSubstrate;
use judder_contact::steady::GridChoice;
use judder_contact::steady::profile::Profile;
use judder_contact::surface::grid::SurfaceGrid;
use judder_contact::unilateral::active_set::UnilateralStart;
use judder_contact::unilateral::{Loading, UnilateralLimits, UnilateralProblem, symmetric};

const RADIUS: f64 = 2.0;
const DEPTH: f64 = 0.01;

/// F = (4/3) √R δ^1.5, p₀ = (2/π) √(δ/R).
#[test]
fn force_and_pressure_of_a_paraboloid() {
    let grid = SurfaceGrid::square(128, [0.0, 0.0], 1.15 * (RADIUS * DEPTH).sqrt());
    let shape = IndenterShape::Paraboloid { radius: RADIUS };
    let centres = (0..grid.len()).map(|cell| (grid.x(cell % 128), grid.y(cell / 128)));
    let heights: Vec<f64> = centres.map(|(x, y)| shape.height(x, y)).collect();
    let mut operator = SlidingOperator::new(grid, &SlidingSubstrate::elastic(), u64::MAX).unwrap();
    let problem = UnilateralProblem { heights: &heights, loading: Loading::Indentation(DEPTH) };
    let limits = UnilateralLimits { tolerance: 1e-9, ..UnilateralLimits::default() };
    let nowhere = UnilateralStart { pressure: &[], indentation: 0.0 };
    let solution = symmetric::solve(&mut operator, &problem, nowhere, limits).unwrap();
    assert!(solution.converged, "{:?}", solution.errors);
    let force = solution.pressure.iter().sum::<f64>() * grid.cell_area();
    assert_close(force, 4.0 / 3.0 * RADIUS.sqrt() * DEPTH.powf(1.5), 1e-3);
    let centre = solution.pressure[64 * 128 + 64];
    assert_close(centre, 2.0 / std::f64::consts::PI * (DEPTH / RADIUS).sqrt(), 1e-3);
}

/// A paraboloid that was sampled on a lattice presses like the paraboloid, sliding or not.
#[test]
fn a_sampled_paraboloid_presses_like_the_paraboloid() {
    let spacing = 0.02;
    let places = (0..900).map(|index| ((index % 30) as f64 - 14.0, (index / 30) as f64 - 15.0));
    let heights = places.map(|(x, y)| 0.5 * spacing * spacing * (x * x + y * y) / RADIUS);
    let map = HeightMap::new(heights.collect(), 30, 30, spacing, false).unwrap();
    for substrate in [SlidingSubstrate::elastic(), SlidingSubstrate::single(10.0, 0.1)] {
        let [exact, sampled] =
            [IndenterShape::Paraboloid { radius: RADIUS }, IndenterShape::HeightMap(map.clone())].map(
                |shape| {
                    let grid = GridChoice::Fixed { cells: 32, half_width: 0.17, centre: [0.01, 0.0] };
                    on_grid(&substrate, &shape, Loading::Indentation(DEPTH), grid, 1e-9).finest
                },
            );
        assert_close(sampled.force, exact.force, 1e-9);
        assert!((sampled.friction - exact.friction).abs() < 1e-9);
    }
}
