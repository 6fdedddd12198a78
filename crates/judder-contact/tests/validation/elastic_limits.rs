//! Hertz (1882) at both ends of the speed: modulus E0 for v → 0, E∞ for v → ∞.

use crate::questions::{assert_close, paraboloid};
use judder_contact::kernel::substrate::SlidingSubstrate;
use judder_contact::unilateral::Loading;
use std::f64::consts::PI;

#[test]
fn the_elastic_paraboloid_is_that_of_hertz() {
    let contact = paraboloid(&SlidingSubstrate::elastic(), Loading::Indentation(1.0), 128);
    assert_close(contact.finest.force, 4.0 / 3.0, 1e-3);
    assert_close(contact.refinement.force.value, 4.0 / 3.0, 1e-4);
    assert_close(contact.finest.area, PI, 1e-2);
    assert!(contact.finest.friction.abs() < 1e-6);
    assert!(contact.converged);
}

/// The whole pressure, p = (2/π) √(1 − r²), away from the edge.
#[test]
fn the_pressure_is_the_half_ellipsoid_of_hertz() {
    let contact = paraboloid(&SlidingSubstrate::elastic(), Loading::Indentation(1.0), 128);
    let grid = contact.finest.grid;
    for (cell, pressure) in contact.finest.solution.pressure.iter().enumerate() {
        let (x, y) = (grid.x(cell % grid.columns), grid.y(cell / grid.columns));
        let radius = x.hypot(y);
        if radius < 0.9 {
            assert_close(*pressure, 2.0 / PI * (1.0 - radius * radius).sqrt(), 3e-3);
        }
    }
}

/// Slow: E0, but for (v τ)². Fast: E∞, less the creep during the passage, C F/(π v τ) ∫ e^{−s/vτ} ds/r, which is
/// (ln(4 v τ/a) − γ) C F/(π v τ) all over the contact but for its logarithms, and counts 3/2 times in the force.
#[test]
fn slow_and_fast_sliding_have_the_two_moduli() {
    const EULER: f64 = 0.577_215_664_901_532_9;
    for contrast in [2.0, 10.0] {
        let (compliance, length) = (1.0 - 1.0 / contrast, 1e6_f64);
        let glassy = 4.0 / 3.0 * contrast;
        let creep = compliance * glassy / (PI * length) * ((4.0 * length).ln() - EULER);
        for (length, force) in [(1e-6, 4.0 / 3.0), (length, glassy * (1.0 - 1.5 * creep))] {
            let substrate = SlidingSubstrate::single(contrast, length);
            let contact = paraboloid(&substrate, Loading::Indentation(1.0), 128);
            assert_close(contact.finest.force, force, 1e-3);
            assert_close(contact.refinement.force.value, force, 1e-4);
            assert_close(contact.refinement.area.value, PI, 1e-2);
        }
    }
}

/// δ = (3F/4)^{2/3} and A = π δ.
#[test]
fn an_imposed_load_finds_the_depth_of_hertz() {
    let contact = paraboloid(&SlidingSubstrate::elastic(), Loading::Load(1e-3), 128);
    assert_close(contact.refinement.indentation.value, 7.5e-4_f64.powf(2.0 / 3.0), 1e-3);
    assert_close(contact.finest.force, 1e-3, 1e-6);
    assert!(contact.converged);
}
