//! What holds for every contact of a rough surface.

use judder_contact::indenter::{HeightMap, RoughSurface, Roughness};
use judder_contact::kernel::sliding::SlidingOperator;
use judder_contact::kernel::substrate::SlidingSubstrate;
use judder_contact::periodic_contact::level::PeriodicLevel;
use judder_contact::periodic_contact::{
    PeriodicContactError, PeriodicLoading, PeriodicQuestion, solve, solve_until,
};
use judder_contact::steady::MEMORY;
use judder_contact::unilateral::active_set::{self, UnilateralStart};
use judder_contact::unilateral::{Loading, UnilateralLimits, UnilateralProblem};
use std::sync::atomic::{AtomicUsize, Ordering};

const TOLERANCE: f64 = 1e-8;

fn rough(cells: usize) -> HeightMap {
    let roughness = Roughness::Slope(0.1);
    RoughSurface {
        period: 1.0,
        cells,
        hurst: 0.7,
        roll_off: 0.3,
        cut_off: 8.0 / cells as f64,
        roughness,
        seed: 5,
    }
    .generate()
    .unwrap()
}

fn limits() -> UnilateralLimits {
    UnilateralLimits { tolerance: TOLERANCE, ..UnilateralLimits::default() }
}

fn asked<'a>(
    surface: &'a HeightMap,
    substrate: &'a SlidingSubstrate,
    loading: PeriodicLoading,
    accuracy: Option<f64>,
) -> PeriodicQuestion<'a> {
    PeriodicQuestion { substrate, surface, loading, accuracy, limits: limits(), memory: MEMORY }
}

fn press(surface: &HeightMap, substrate: &SlidingSubstrate, mean_pressure: f64) -> PeriodicLevel {
    let loading = PeriodicLoading::MeanPressure(mean_pressure);
    solve(&asked(surface, substrate, loading, None)).unwrap().finest
}

/// Two algorithms, one pressure.
#[test]
fn conjugate_gradients_and_the_active_set_agree() {
    let surface = rough(64);
    let contact = press(&surface, &SlidingSubstrate::elastic(), 0.01);
    assert!(contact.solution.converged && contact.solution.errors.worst() <= TOLERANCE);
    let mut operator =
        SlidingOperator::periodic(surface.grid(), &SlidingSubstrate::elastic(), u64::MAX).unwrap();
    let problem = UnilateralProblem { heights: surface.heights(), loading: Loading::Load(0.01) };
    let even = vec![0.01; surface.heights().len()];
    let start = UnilateralStart { pressure: &even, indentation: 0.0 };
    let other = active_set::solve(&mut operator, &problem, start, limits()).unwrap();
    assert!(other.converged);
    let largest = other.pressure.iter().copied().fold(0.0, f64::max);
    for (one, two) in contact.solution.pressure.iter().zip(&other.pressure) {
        assert!((one - two).abs() < 1e-5 * largest, "{one} {two}");
    }
}

/// The real area grows in proportion to a light load, κ p̄/√⟨|∇h|²⟩ with κ about 2 (Bush 1975: √2π; Persson 2001: √8/π).
#[test]
fn contact_is_proportional_to_a_light_load() {
    let surface = rough(128);
    let fraction = |pressure: f64| press(&surface, &SlidingSubstrate::elastic(), pressure).contact_fraction;
    let (light, double) = (fraction(0.001), fraction(0.002));
    assert!((double / light - 2.0).abs() < 0.3, "{}", double / light);
    let proportion = double / 0.002 * 0.1 / 2.0;
    assert!((1.4..3.6).contains(&(2.0 * proportion)), "{proportion}");
}

/// Slow sliding over a rough surface dissipates, and the answer says the same twice.
#[test]
fn sliding_over_roughness_has_friction_and_the_same_bytes() {
    let surface = rough(64);
    let substrate = SlidingSubstrate::single(10.0, 0.02);
    let contact = press(&surface, &substrate, 0.02);
    assert!(contact.solution.converged, "{:?}", contact.solution.errors);
    assert!(contact.friction > 0.0);
    assert_eq!(contact, press(&surface, &substrate, 0.02));
    let elastic = press(&surface, &SlidingSubstrate::elastic(), 0.02);
    assert!(elastic.friction.abs() < 0.01 * contact.friction, "{} {}", elastic.friction, contact.friction);
    assert!(contact.contact_fraction < elastic.contact_fraction);
}

/// Finer grids hold the same surface: the accuracy is met, friction is that of the bulk, and a depth is as good as its load.
#[test]
fn a_rough_contact_is_refined_until_its_accuracy_is_met() {
    let (surface, accuracy) = (rough(64), 1e-2);
    for (substrate, load) in
        [(SlidingSubstrate::elastic(), 0.01), (SlidingSubstrate::single(10.0, 0.02), 0.02)]
    {
        let pressed =
            solve(&asked(&surface, &substrate, PeriodicLoading::MeanPressure(load), Some(accuracy))).unwrap();
        assert!(pressed.converged, "{:?}", pressed.refinement);
        let levels = &pressed.refinement.levels;
        assert!(levels.len() > 1 && levels.iter().all(|level| level.converged));
        assert!((pressed.finest.mean_pressure / load - 1.0).abs() < 1e-8);
        if !substrate.terms.is_empty() {
            assert!(pressed.friction_difference() < 1e-2, "{}", pressed.friction_difference());
        }
        let depth = PeriodicLoading::Indentation(pressed.refinement.indentation.value);
        let indented = solve(&asked(&surface, &substrate, depth, Some(accuracy))).unwrap();
        assert!(indented.converged, "{:?}", indented.refinement);
        assert!((indented.refinement.force.value / load - 1.0).abs() < 2.0 * accuracy);
        let heights = surface.heights();
        let mean = heights.iter().sum::<f64>() / heights.len() as f64;
        let gap = mean - indented.finest.solution.indentation;
        assert!((indented.finest.mean_gap / gap - 1.0).abs() < 1e-9);
    }
}

/// An accuracy beyond the finest grid that memory allows is missed, and said to be.
#[test]
fn an_accuracy_out_of_reach_is_missed_honestly() {
    let (surface, substrate) = (rough(32), SlidingSubstrate::elastic());
    let question = asked(&surface, &substrate, PeriodicLoading::MeanPressure(0.01), Some(1e-6));
    let memory = SlidingOperator::memory_bytes(64, 64);
    let contact = solve(&PeriodicQuestion { memory, ..question }).unwrap();
    assert_eq!(contact.finest.grid.columns, 64);
    assert!(contact.finest.solution.converged && !contact.converged);
    let too_deep = solve(&asked(&surface, &substrate, PeriodicLoading::Indentation(1.0), None));
    assert!(matches!(too_deep, Err(PeriodicContactError::TooDeep { .. })));
}

#[test]
fn a_period_is_given_up_before_any_product() {
    let surface = rough(64);
    for substrate in [SlidingSubstrate::elastic(), SlidingSubstrate::single(10.0, 0.01)] {
        let question = asked(&surface, &substrate, PeriodicLoading::MeanPressure(0.01), None);
        let count = AtomicUsize::new(0);
        let until = |last: usize| {
            count.store(0, Ordering::Relaxed);
            solve_until(&question, &|| count.fetch_add(1, Ordering::Relaxed) >= last)
        };
        assert_eq!(until(usize::MAX), solve(&question));
        let all = count.load(Ordering::Relaxed);
        for last in [0, all / 2, all - 1] {
            assert_eq!(until(last), Err(PeriodicContactError::Interrupted), "{last} of {all}");
            assert_eq!(count.load(Ordering::Relaxed), last + 1);
        }
    }
}
