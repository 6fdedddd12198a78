//! Against closed forms and numbers that other programs print.

mod block;

use crate::common::{dense, diagonal, point_on_plane, rigid, undamped};
use judder_assembly::AssemblyError;
use judder_assembly::compliance::Compliance;
use judder_assembly::linearised::{ContactTerm, Linearised, LinearisedTerms};
use judder_assembly::steady::{Uniqueness, steady_sliding};
use judder_assembly::work::{Worker, growth_shares};
use judder_structure::complex_modes::{ComplexModeSettings, Region, complex_modes};

/// ANSYS Verification Manual, VM274: a mass on a moving belt, free across the slip: friction damps it by ζ = μN/(2 v √(km)).
#[test]
fn friction_damps_a_mass_that_swings_across_the_slip() {
    let (mass, stiffness, force, friction, speed) = (8.0, 315.0, 1.0, 0.5, 10.0);
    // x along the belt is held, y presses, z is free on a spring
    let point = point_on_plane([None, Some(0), Some(1)], [speed, 0.0, 0.0]);
    let assembly = undamped(
        diagonal(&[mass, mass]),
        diagonal(&[stiffness, stiffness]),
        vec![-force, 0.0],
        vec![rigid(vec![point], friction)],
    );
    let steady = steady_sliding(&assembly, &Compliance::new(&assembly).unwrap()).unwrap();
    assert!((steady.points[0].normal_force - force).abs() < 1e-14 && steady.residual < 1e-14);
    let about = Linearised::new(&assembly, &steady, LinearisedTerms::default()).unwrap();
    let region = Region { re: [-1.0, 1.0], im: [1.0, 20.0] };
    let found = complex_modes(&about.problem, &region, &ComplexModeSettings::default()).unwrap();
    assert!(found.complete() && found.modes.len() == 1);
    let mode = &found.modes[0];
    let ratio = mode.eigenvalue.damping_ratio();
    assert!((ratio - 4.980_12e-4).abs() < 5e-10, "{ratio}");
    assert!((ratio - friction * force / (2.0 * speed * (stiffness * mass).sqrt())).abs() < 1e-12);
    // all of it is the work of the friction across the slip
    let shares = growth_shares(&about, mode.eigenvalue.value, &about.expanded(&mode.right)).unwrap();
    let (worker, growth) = shares.shares.iter().max_by(|a, b| a.1.abs().total_cmp(&b.1.abs())).unwrap();
    assert_eq!(*worker, Worker::Contact(0, ContactTerm::FrictionAcrossSlip));
    assert!((growth - mode.eigenvalue.value.re).abs() < 1e-12);
}

/// ANSYS Verification Manual, VM29: a block on an incline of 20°, μ = 0.3, pressed by 100 with a support along it: N = 95.942 would be of
/// the direction that slides down with friction, T = 28.783 = μ N.
#[test]
fn a_block_slides_down_an_incline() {
    let (angle, friction, weight): (f64, f64, f64) = (20_f64.to_radians(), 0.3, 100.0);
    let point = point_on_plane([Some(0), Some(1), None], [-1.0, 0.0, 0.0]);
    // along the incline a spring holds what friction leaves
    let assembly = undamped(
        diagonal(&[1.0, 1.0]),
        diagonal(&[1e3, 0.0]),
        vec![weight * angle.sin(), -weight * angle.cos()],
        vec![rigid(vec![point], friction)],
    );
    let steady = steady_sliding(&assembly, &Compliance::new(&assembly).unwrap()).unwrap();
    let along = 1e3 * steady.displacement[0];
    assert!((steady.points[0].normal_force - weight * angle.cos()).abs() < 1e-10);
    assert!((along - (weight * angle.sin() - friction * weight * angle.cos())).abs() < 1e-10);
}

/// One point on a structure with K = (a, b; b, d): a unit normal force opens it by (a − μ b)/det K, so that sprag-slip begins at μ = a/b.
#[test]
fn sprag_slip_begins_where_friction_presses_as_hard_as_the_contact_pushes() {
    for (friction, expected) in [(0.5, 3.0), (3.0, 0.5)] {
        let assembly = undamped(
            diagonal(&[1.0, 1.0]),
            dense(&[&[3.0, 2.0], &[2.0, 5.0]]),
            vec![0.0, -1.0],
            vec![rigid(vec![point_on_plane([Some(0), Some(1), None], [1.0, 0.0, 0.0])], friction)],
        );
        let steady = steady_sliding(&assembly, &Compliance::new(&assembly).unwrap());
        match steady {
            Ok(steady) => {
                let Uniqueness::LostAt { factor, point } = steady.uniqueness else { panic!("{steady:?}") };
                assert!(point == 0 && (factor - expected).abs() < 1e-12, "{factor}");
                assert!(friction == 0.5);
            }
            // beyond it no state presses: the point neither closes nor stays open
            Err(error) => {
                assert!(friction == 3.0 && matches!(error, AssemblyError::NoConvergence { .. }), "{error}");
            }
        }
    }
}
