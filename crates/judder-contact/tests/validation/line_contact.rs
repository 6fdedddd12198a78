//! Cylinders: Hertz, both ends of the speed, and viscoelastic cylinders in the literature.

use crate::questions::assert_close;
use judder_contact::indenter::IndenterShape;
use judder_contact::kernel::substrate::SlidingSubstrate;
use judder_contact::steady::{GridChoice, MEMORY, SteadyContact, SteadyError, SteadyQuestion, solve};
use judder_contact::unilateral::{Loading, UnilateralLimits};
use std::f64::consts::PI;

/// Euler's constant.
const EULER: f64 = 0.577_215_664_901_532_9;
const CYLINDER: IndenterShape = IndenterShape::Cylinder { radius: 1.0 };

fn asked(substrate: &SlidingSubstrate, load: f64) -> SteadyQuestion<'_> {
    SteadyQuestion {
        substrate,
        profile: &CYLINDER,
        loading: Loading::Load(load),
        accuracy: 1e-3,
        grid: GridChoice::Automatic,
        limits: UnilateralLimits { tolerance: 1e-8, ..UnilateralLimits::default() },
        memory: MEMORY,
    }
}

/// Solved to a thousandth, with two frictions that agree to a hundredth, on a domain that the contact fills.
fn cylinder(substrate: &SlidingSubstrate, load: f64) -> SteadyContact {
    let contact = solve(&asked(substrate, load)).unwrap();
    assert!(contact.converged, "{:?}", contact.refinement);
    assert_close(contact.finest.force, load, 1e-5);
    let free = contact.finest.solution.pressure.iter().filter(|pressure| **pressure == 0.0).count();
    assert!(free < contact.finest.grid.columns / 2, "{free} of {}", contact.finest.grid.columns);
    if contact.friction_from_dissipation > 0.0 {
        assert!(contact.friction_difference() < 3e-3, "{}", contact.friction_difference());
    }
    contact
}

/// Hertz: half width a = √(4F/π), largest pressure 2F/(π a), depth (2F/π) (ln(2d/a) + ½) against the distance d = 1.
#[test]
fn the_elastic_cylinder_is_that_of_hertz() {
    for load in [0.01, 1e-6] {
        let refinement = cylinder(&SlidingSubstrate::elastic(), load).refinement;
        let half = (4.0 * load / PI).sqrt();
        assert_close(refinement.area.value, 2.0 * half, 1e-3);
        assert_close(refinement.peak_pressure.value, 2.0 * load / (PI * half), 1e-4);
        assert_close(refinement.indentation.value, 2.0 * load / PI * ((2.0 / half).ln() + 0.5), 1e-4);
        assert!(refinement.friction.value.abs() < 1e-12);
    }
}

/// Slow sliding lags by (1 − E0/E∞) v τ. Fast sliding creeps under Hertz's glassy pressure:
/// μ = (1 − E0/E∞) (2F/π ℓ) (ln(2ℓ/a) − γ + ¼), from ∫ q/(q² + ℓ⁻²) |P(q)|² dq with P = 2F J₁(qa)/(qa).
#[test]
fn slow_and_fast_cylinders_have_the_friction_of_their_closed_forms() {
    let load: f64 = 0.01;
    for contrast in [10.0, 1000.0] {
        let slow = cylinder(&SlidingSubstrate::single(contrast, 1e-5), load).refinement;
        assert_close(slow.friction.value, (1.0 - 1.0 / contrast) * 1e-5, 2e-3);
        let length: f64 = 1e5;
        let fast = cylinder(&SlidingSubstrate::single(contrast, length), load).refinement;
        let half = (4.0 * load / (PI * contrast)).sqrt();
        let creep = 2.0 * load / (PI * length) * ((2.0 * length / half).ln() - EULER + 0.25);
        assert_close(fast.friction.value, (1.0 - 1.0 / contrast) * creep, 2e-3);
        assert_close(fast.area.value, 2.0 * half, 1e-3);
    }
}

/// In between there is no closed form, but the energy of two sides.
#[test]
fn the_two_frictions_of_a_cylinder_agree_at_every_speed() {
    let load: f64 = 0.01;
    let half = (4.0 * load / PI).sqrt();
    for contrast in [2.0, 10.0, 1000.0] {
        for exponent in -2..=3 {
            cylinder(&SlidingSubstrate::single(contrast, 10.0_f64.powi(exponent) * half), load);
        }
    }
}

#[test]
fn a_cylinder_under_an_imposed_depth_is_refused() {
    let substrate = SlidingSubstrate::elastic();
    let question = SteadyQuestion { loading: Loading::Indentation(0.01), ..asked(&substrate, 1.0) };
    assert_eq!(solve(&question), Err(SteadyError::LineIndentation));
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
        assert_close(contact.refinement.peak_pressure.value * relaxed_modulus, published, 2e-3);
    }
}
