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

#[test]
fn slow_and_fast_sliding_have_the_two_moduli() {
    let slow = paraboloid(&SlidingSubstrate::single(10.0, 1e-6), Loading::Indentation(1.0), 64);
    assert_close(slow.refinement.force.value, 4.0 / 3.0, 1e-3);
    let fast = paraboloid(&SlidingSubstrate::single(10.0, 1e6), Loading::Indentation(1.0), 64);
    assert_close(fast.refinement.force.value, 40.0 / 3.0, 1e-3);
    assert_close(fast.refinement.area.value, PI, 1e-2);
}

/// δ = (3F/4)^{2/3} and A = π δ.
#[test]
fn an_imposed_load_finds_the_depth_of_hertz() {
    let contact = paraboloid(&SlidingSubstrate::elastic(), Loading::Load(1e-3), 64);
    assert_close(contact.refinement.indentation.value, 7.5e-4_f64.powf(2.0 / 3.0), 1e-3);
    assert_close(contact.finest.force, 1e-3, 1e-6);
    assert!(contact.converged);
}
