//! The errors that a contact states cover those that it has, and what has converged is as exact as it says.

use crate::questions::on_grid;
use judder_contact::kernel::substrate::SlidingSubstrate;
use judder_contact::steady::profile::Paraboloid;
use judder_contact::steady::{GridChoice, MEMORY, SteadyQuestion, solve};
use judder_contact::unilateral::{Loading, UnilateralLimits};
use std::f64::consts::PI;

/// The accuracy of a contact that asks for none, and what it leaves to area and friction.
const ACCURACY: f64 = 1e-3;
const SECONDARY: f64 = 5e-3;
/// To what the references are known.
const KNOWN: f64 = 1e-5;
/// ŷ of all contacts.
const DEPTH: f64 = 1e-2;

/// Force, area, friction: stated and true to the accuracy, against values from a finer grid or from none.
fn the_stated_errors_hold(contrast: f64, velocity: f64, (exact, reference): ([f64; 3], usize)) {
    let contact = solve(&SteadyQuestion {
        substrate: &SlidingSubstrate::single(contrast, velocity),
        profile: &Paraboloid,
        loading: Loading::Indentation(DEPTH),
        accuracy: ACCURACY,
        grid: GridChoice::Automatic,
        limits: UnilateralLimits::default(),
        memory: MEMORY,
    })
    .unwrap();
    assert!(contact.converged, "{contrast} {velocity}");
    let r = &contact.refinement;
    assert!(r.friction.error >= contact.friction_difference());
    let cells = contact.finest.grid.columns;
    assert!(cells < reference, "{contrast} {velocity}: {cells} cells against {reference}");
    for (name, found, exact, allowed) in [
        ("force", r.force, exact[0], ACCURACY),
        ("area", r.area, exact[1], SECONDARY),
        ("friction", r.friction, exact[2], SECONDARY),
    ] {
        let off = (found.value / exact - 1.0).abs();
        println!(
            "{contrast:5} {velocity:8.1e} {cells:4} {name:8} stated {:8.1e}, true {off:8.1e}",
            found.error
        );
        assert!(
            off <= found.error + KNOWN,
            "{contrast} {velocity} {name}: off by {off:.1e}, stated {:.1e}",
            found.error
        );
        assert!(off <= allowed, "{contrast} {velocity} {name}: off by {off:.1e}");
    }
}

/// Hertz, and the friction of the lag.
fn slow(contrast: f64, velocity: f64) -> ([f64; 3], usize) {
    ([4.0 / 3.0 * DEPTH.powf(1.5), PI * DEPTH, (1.0 - 1.0 / contrast) * velocity], usize::MAX)
}

/// The contact on so many cells a side.
fn on_cells(contrast: f64, velocity: f64, cells: usize) -> ([f64; 3], usize) {
    let substrate = SlidingSubstrate::single(contrast, velocity);
    let loading = Loading::Indentation(DEPTH);
    let contact = on_grid(&substrate, &Paraboloid, loading, GridChoice::Cells(cells), 1e-7);
    let r = &contact.refinement;
    ([r.force.value, r.area.value, r.friction.value], cells)
}

#[test]
fn slow_contacts_state_their_errors() {
    for contrast in [2.0, 10.0, 1000.0] {
        for velocity in [2e-5, 5e-5] {
            the_stated_errors_hold(contrast, velocity, slow(contrast, velocity));
        }
    }
}

#[test]
fn contacts_in_the_transition_state_their_errors() {
    for velocity in [2e-3, 1e-2, 1e-1, 1.0, 10.0] {
        the_stated_errors_hold(10.0, velocity, on_cells(10.0, velocity, 512));
    }
}

#[test]
#[ignore = "expensive: run by make validate"]
fn a_contact_at_the_slow_end_of_the_transition_states_its_errors() {
    the_stated_errors_hold(10.0, 1e-3, on_cells(10.0, 1e-3, 1024));
}

#[test]
fn fast_contacts_state_their_errors() {
    for (contrast, velocity) in [(10.0, 1e3), (100.0, 1e3), (1000.0, 1e3)] {
        the_stated_errors_hold(contrast, velocity, on_cells(contrast, velocity, 512));
    }
}

#[test]
fn contacts_at_a_high_contrast_state_their_errors() {
    for velocity in [2e-3, 1.0, 10.0] {
        the_stated_errors_hold(1000.0, velocity, on_cells(1000.0, velocity, 512));
    }
}
