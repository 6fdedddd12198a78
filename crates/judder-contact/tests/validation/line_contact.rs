//! Viscoelastic cylinders in the literature.

use crate::questions::assert_close;
use judder_contact::kernel::substrate::SlidingSubstrate;
use judder_contact::steady::MEMORY;
use judder_contact::steady::line::{LineContact, LineQuestion, solve};
use judder_contact::unilateral::UnilateralLimits;
use std::f64::consts::PI;

fn cylinder(substrate: &SlidingSubstrate, load: f64) -> LineContact {
    let limits = UnilateralLimits { tolerance: 1e-8, ..UnilateralLimits::default() };
    solve(&LineQuestion { substrate, load, cells: 1024, limits, memory: MEMORY }).unwrap()
}

/// Hertz: half width a = √(4F/π), largest pressure 2F/(π a).
#[test]
fn the_elastic_cylinder_is_that_of_hertz() {
    let contact = cylinder(&SlidingSubstrate::elastic(), 0.01);
    assert!(contact.solution.converged, "{:?}", contact.solution.errors);
    let half = (0.04 / PI).sqrt();
    assert_close(contact.width, 2.0 * half, 1e-3);
    assert_close(contact.peak_pressure, 0.02 / (PI * half), 1e-4);
}

/// Wang and Knothe, "Stress analysis for rolling contact between two viscoelastic cylinders", J. Appl. Mech. 60 (1993):
/// largest pressure in N/mm² over the creep time, two equal cylinders, G = 1143 N/mm² at once and half of it in the end,
/// ν = 0.4, R = 50 mm combined, 600 N/mm, 1000 mm/s. Two equal bodies have twice the compliance of one.
#[test]
fn the_cylinders_of_wang_and_knothe_have_their_peak_pressures() {
    let relaxed_modulus = 2.0 * 571.5 * 1.4 / (1.0 - 0.16) / 2.0;
    let load = 600.0 / (relaxed_modulus * 50.0);
    for (creep_time, published) in [(0.0, 60.32), (0.009, 78.74), (0.045, 84.72), (2.0, 85.31)] {
        let contact = cylinder(&SlidingSubstrate::single(2.0, 1000.0 * creep_time / 50.0), load);
        assert!(contact.solution.converged);
        assert_close(contact.peak_pressure * relaxed_modulus, published, 5e-3);
    }
}
