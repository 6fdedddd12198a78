//! Symmetries and equivalences of steady sliding.

use crate::questions::{assert_close, on_grid, paraboloid};
use judder_contact::indenter::{HeightMap, IndenterShape};
use judder_contact::kernel::sliding::SlidingOperator;
use judder_contact::kernel::substrate::SlidingSubstrate;
use judder_contact::steady::profile::{Paraboloid, Profile, Sphere};
use judder_contact::steady::{GridChoice, MEMORY, SteadyError, SteadyQuestion, solve, solve_until};
use judder_contact::surface::grid::SurfaceGrid;
use judder_contact::surface::operator::SurfaceOperator;
use judder_contact::unilateral::active_set::{self, UnilateralStart};
use judder_contact::unilateral::{Loading, UnilateralLimits, UnilateralProblem};
use std::sync::atomic::{AtomicUsize, Ordering};

/// For a paraboloid and one retardation time all depends on z = v τ/√(R δ).
#[test]
fn the_paraboloid_collapses_on_one_curve() {
    for z in [0.05, 1.0, 40.0] {
        let scaled: Vec<[f64; 3]> = [1.0, 1e-2, 3.7e-5]
            .map(|depth: f64| {
                let substrate = SlidingSubstrate::single(10.0, z * depth.sqrt());
                let contact = on_grid(
                    &substrate,
                    &Paraboloid,
                    Loading::Indentation(depth),
                    GridChoice::Cells(64),
                    1e-12,
                );
                assert!(contact.refinement.levels.iter().all(|level| level.converged));
                let level = contact.finest;
                [level.force / depth.powf(1.5), level.area / depth, level.friction / depth.sqrt()]
            })
            .to_vec();
        for other in &scaled[1..] {
            for (found, wanted) in other.iter().zip(scaled[0]) {
                assert_close(*found, wanted, 1e-10);
            }
        }
    }
}

#[test]
fn an_imposed_load_and_the_depth_that_it_finds_are_one_contact() {
    for (contrast, length) in [(10.0, 0.02), (100.0, 0.5), (1000.0, 0.1)] {
        let substrate = SlidingSubstrate::single(contrast, length);
        let pressed = paraboloid(&substrate, Loading::Load(2e-3), 64);
        assert!(pressed.refinement.levels.iter().all(|level| level.converged));
        let grid = pressed.finest.grid;
        let half_width = 0.5 * grid.cell * grid.columns as f64;
        let centre = [grid.origin[0] + half_width, grid.origin[1] + half_width];
        let depth = Loading::Indentation(pressed.finest.solution.indentation);
        let fixed = GridChoice::Fixed { cells: 64, half_width, centre };
        let indented = on_grid(&substrate, &Paraboloid, depth, fixed, 1e-7);
        assert_close(indented.finest.force, 2e-3, 1e-5);
        assert_close(indented.finest.friction, pressed.finest.friction, 1e-5);
        assert_close(indented.finest.area, pressed.finest.area, 1e-3);
    }
}

/// Nothing distinguishes +y from −y.
#[test]
fn fields_are_symmetric_across_the_direction_of_sliding() {
    let contact = paraboloid(&SlidingSubstrate::single(10.0, 1.0), Loading::Indentation(1.0), 64);
    let pressure = &contact.finest.solution.pressure;
    let largest = pressure.iter().copied().fold(0.0, f64::max);
    for row in 0..64 {
        for column in 0..64 {
            let (here, there) = (pressure[row * 64 + column], pressure[(63 - row) * 64 + column]);
            assert!((here - there).abs() < 1e-5 * largest);
        }
    }
}

/// A skew bump and its mirror image.
struct Skew {
    side: f64,
}

impl Profile for Skew {
    fn height(&self, x: f64, y: f64) -> f64 {
        0.5 * (x * x + 1.7 * y * y + 0.5 * self.side * x * y)
    }

    fn extent(&self, depth: f64) -> f64 {
        (2.5 * depth).sqrt()
    }

    fn elastic_depth(&self, force: f64) -> f64 {
        Paraboloid.elastic_depth(force)
    }
}

/// A mirrored indenter gives the mirrored pressure.
#[test]
fn a_mirrored_indenter_has_mirrored_fields() {
    let substrate = SlidingSubstrate::single(10.0, 0.6);
    let grid = GridChoice::Fixed { cells: 48, half_width: 1.5, centre: [0.0, 0.0] };
    let solved =
        [1.0, -1.0].map(|side| on_grid(&substrate, &Skew { side }, Loading::Indentation(1.0), grid, 1e-9));
    let [left, right] = &solved;
    assert_close(left.finest.force, right.finest.force, 1e-8);
    for row in 0..48 {
        for column in 0..48 {
            let here = left.finest.solution.pressure[row * 48 + column];
            let there = right.finest.solution.pressure[(47 - row) * 48 + column];
            assert!((here - there).abs() < 1e-7);
        }
    }
}

/// Sliding to −x: the transposed operator, summed cell by cell. Only its approximate inverse is that of +x, mirrored.
struct Backwards {
    forwards: SlidingOperator,
    /// The displacements of a unit pressure on each cell.
    columns: Vec<Vec<f64>>,
}

impl Backwards {
    fn new(mut forwards: SlidingOperator) -> Self {
        let cells = forwards.grid().len();
        let columns = (0..cells).map(|cell| {
            let (mut unit, mut displacement) = (vec![0.0; cells], vec![0.0; cells]);
            unit[cell] = 1.0;
            forwards.displacement(&unit, &mut displacement);
            displacement
        });
        Self { columns: columns.collect(), forwards }
    }
}

impl SurfaceOperator for Backwards {
    fn grid(&self) -> &SurfaceGrid {
        self.forwards.grid()
    }

    fn displacement(&mut self, pressure: &[f64], displacement: &mut [f64]) {
        for (value, column) in displacement.iter_mut().zip(&self.columns) {
            *value = column.iter().zip(pressure).map(|(entry, pressure)| entry * pressure).sum();
        }
    }

    fn precondition(&mut self, displacement: &[f64], pressure: &mut [f64]) {
        let columns = self.grid().columns;
        let mut backwards = vec![0.0; pressure.len()];
        self.forwards.precondition(&mirrored(displacement, columns), &mut backwards);
        pressure.copy_from_slice(&mirrored(&backwards, columns));
    }

    fn is_symmetric(&self) -> bool {
        false
    }

    fn self_displacement(&self) -> f64 {
        self.forwards.self_displacement()
    }

    fn collocation_shift(&self) -> f64 {
        -self.forwards.collocation_shift()
    }
}

fn mirrored(values: &[f64], columns: usize) -> Vec<f64> {
    values.chunks(columns).flat_map(|row| row.iter().rev().copied()).collect()
}

/// The mirror image of an indenter that slides the other way presses with the mirrored pressure and drags the other way.
#[test]
fn mirrored_sliding_has_mirrored_fields() {
    let grid = SurfaceGrid { rows: 18, ..SurfaceGrid::square(24, [0.0, 0.0], 1.4) };
    let grid = SurfaceGrid { origin: [grid.origin[0], -9.0 * grid.cell], ..grid };
    let leaning = |x: f64, y: f64| 0.5 * (x * x + 1.3 * y * y) + 0.12 * x * x * x + 0.1 * x * y + 0.05;
    let limits = UnilateralLimits { tolerance: 1e-10, ..UnilateralLimits::default() };
    for (contrast, length) in [(10.0, 0.6), (1000.0, 2.0)] {
        let substrate = SlidingSubstrate::single(contrast, length);
        let pressed = |operator: &mut dyn SurfaceOperator, side: f64| {
            let shift = operator.collocation_shift();
            let heights: Vec<f64> = (0..grid.len())
                .map(|cell| leaning(side * (grid.x(cell % 24) - shift), grid.y(cell / 24)))
                .collect();
            let problem = UnilateralProblem { heights: &heights, loading: Loading::Indentation(0.8) };
            let start = UnilateralStart { pressure: &vec![0.0; grid.len()], indentation: 0.8 };
            let solution = active_set::solve(operator, &problem, start, limits).unwrap();
            assert!(solution.converged, "{:?}", solution.errors);
            solution.pressure
        };
        let mut forwards = SlidingOperator::new(grid, &substrate, MEMORY).unwrap();
        let ahead = pressed(&mut forwards, 1.0);
        let back = pressed(&mut Backwards::new(forwards), -1.0);
        let largest = ahead.iter().copied().fold(0.0, f64::max);
        for (there, here) in mirrored(&back, 24).iter().zip(&ahead) {
            assert!((there - here).abs() < 1e-8 * largest, "{there} {here}");
        }
        // It is no symmetric contact that is compared with itself.
        let skew = mirrored(&ahead, 24).iter().zip(&ahead).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(skew > 0.1 * largest);
    }
}

#[test]
fn a_domain_that_the_contact_outgrows_is_refused_with_the_width_that_would_do() {
    let substrate = SlidingSubstrate::elastic();
    let grid = GridChoice::Fixed { cells: 32, half_width: 0.8, centre: [0.0, 0.0] };
    let question = SteadyQuestion {
        substrate: &substrate,
        profile: &Paraboloid,
        loading: Loading::Indentation(1.0),
        accuracy: 1e-2,
        grid,
        limits: UnilateralLimits::default(),
        memory: MEMORY,
    };
    let error = solve(&question).unwrap_err();
    let SteadyError::DomainTooSmall { needed, .. } = error else { panic!("{error}") };
    // Hertz's radius is 1, the rest is margin.
    assert!((1.05..1.6).contains(&needed), "{needed}");
    assert!(error.to_string().contains("touches the edge"));
}

/// A bowl on a lattice that ends at 0.7 of the contact's radius is refused where it ends.
#[test]
fn a_height_map_that_ends_under_the_contact_is_refused() {
    let (side, spacing) = (15, 0.1);
    let heights = (0..side * side)
        .map(|index| {
            let at = |k: usize| (k as f64 - 7.0) * spacing;
            0.5 * (at(index % side).powi(2) + at(index / side).powi(2))
        })
        .collect();
    let map = HeightMap::new(heights, side, side, spacing, false).unwrap();
    let substrate = SlidingSubstrate::elastic();
    let question = SteadyQuestion {
        substrate: &substrate,
        profile: &IndenterShape::HeightMap(map),
        loading: Loading::Indentation(1.0),
        accuracy: 1e-2,
        grid: GridChoice::Cells(64),
        limits: UnilateralLimits::default(),
        memory: MEMORY,
    };
    let error = solve(&question).unwrap_err();
    assert!(matches!(error, SteadyError::BeyondIndenter { .. }), "{error}");
}

#[test]
fn a_sphere_below_its_equator_is_refused() {
    let substrate = SlidingSubstrate::elastic();
    for depth in [1.0, 1.4, 3.0] {
        let question = SteadyQuestion {
            substrate: &substrate,
            profile: &Sphere,
            loading: Loading::Indentation(depth),
            accuracy: 1e-2,
            grid: GridChoice::Automatic,
            limits: UnilateralLimits::default(),
            memory: MEMORY,
        };
        assert!(matches!(solve(&question), Err(SteadyError::TooDeep { .. })));
    }
}

/// Told to stop before any of its products, a solver makes no further one; not told, it ends in the same contact.
#[test]
fn a_contact_is_given_up_before_any_product() {
    for substrate in [SlidingSubstrate::elastic(), SlidingSubstrate::single(10.0, 0.1)] {
        let question = SteadyQuestion {
            substrate: &substrate,
            profile: &Paraboloid,
            loading: Loading::Indentation(1e-2),
            accuracy: 1e-2,
            grid: GridChoice::Automatic,
            limits: UnilateralLimits::default(),
            memory: MEMORY,
        };
        let asked = AtomicUsize::new(0);
        let until = |last: usize| {
            asked.store(0, Ordering::Relaxed);
            solve_until(&question, &|| asked.fetch_add(1, Ordering::Relaxed) >= last)
        };
        assert_eq!(until(usize::MAX), solve(&question));
        let all = asked.load(Ordering::Relaxed);
        assert!(all > 50, "{all}");
        for last in [0, 1, 7, all / 2, all - 1] {
            assert_eq!(until(last), Err(SteadyError::Interrupted), "{last} of {all}");
            assert_eq!(asked.load(Ordering::Relaxed), last + 1);
        }
    }
}
