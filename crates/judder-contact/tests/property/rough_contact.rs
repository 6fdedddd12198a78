//! What holds for every contact of a rough surface.

use judder_contact::indenter::{HeightMap, RoughSurface, Roughness};
use judder_contact::kernel::sliding::SlidingOperator;
use judder_contact::kernel::substrate::SlidingSubstrate;
use judder_contact::periodic_contact::{PeriodicContact, PeriodicQuestion, solve};
use judder_contact::unilateral::active_set::{self, Start};
use judder_contact::unilateral::{Loading, UnilateralLimits, UnilateralProblem};

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

fn press(surface: &HeightMap, substrate: &SlidingSubstrate, mean_pressure: f64) -> PeriodicContact {
    let question = PeriodicQuestion { substrate, surface, mean_pressure, limits: limits(), memory: u64::MAX };
    solve(&question).unwrap()
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
    let start = Start { pressure: &even, indentation: 0.0 };
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
