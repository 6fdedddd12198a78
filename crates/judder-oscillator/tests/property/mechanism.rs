//! A mechanism is what is left of an instability when the rest is removed: the label of a point against the eigenvalues of the systems that
//! are left, from a Schur form of the state matrix, which shares nothing with the Hurwitz conditions that decide.

use crate::sampling::{any_contact, any_structure, for_each, logarithmic};
use judder_oscillator::equilibrium::equilibrium;
use judder_oscillator::linear_system::LinearSystem;
use judder_oscillator::linearisation::Linearisation;
use judder_oscillator::mechanism::StabilityClass;
use judder_oscillator::{Contact, Groups};
use nalgebra::{Matrix4, Schur};
use proptest::prelude::*;
use std::cell::RefCell;
use std::collections::BTreeMap;

/// Operating points, the same ones at every run.
const POINTS: u32 = 10_000;
/// A growth rate over the largest eigenvalue is one above the first, is none below the second, and rounding may decide between them.
const CLEAR: [f64; 2] = [1e-6, 1e-7];

type Matrix = [[f64; 2]; 2];

/// Whether q̈ + C q̇ + K q = 0 grows; `None` where rounding decides.
fn grows(damping: Matrix, stiffness: Matrix) -> Option<bool> {
    let ([[a, b], [c, d]], [[e, f], [g, h]]) = (damping, stiffness);
    #[rustfmt::skip]
    let state = Matrix4::new(
        0.0, 0.0, 1.0, 0.0,
        0.0, 0.0, 0.0, 1.0,
        -e, -f, -a, -b,
        -g, -h, -c, -d,
    );
    let values = Schur::try_new(state, f64::EPSILON, 10_000)?.complex_eigenvalues();
    let growth = values.iter().map(|value| value.re).fold(f64::NEG_INFINITY, f64::max);
    let share = growth / values.iter().map(|value| value.norm()).fold(0.0, f64::max);
    match share {
        share if share > CLEAR[0] => Some(true),
        share if share < CLEAR[1] => Some(false),
        _ => None,
    }
}

/// Whether the oscillation of one direction by itself grows; a mass on an even spring tells of its damper alone.
fn grows_alone(damping: f64) -> bool {
    damping < 0.0
}

/// The label that removal gives: of all damping, of all coupling, of the one-way coupling by speed.
fn by_removal(
    damping: Matrix,
    without: Matrix,
    stiffness: Matrix,
    dampers: [f64; 2],
) -> Option<&'static str> {
    if !grows(damping, stiffness)? {
        return Some("stable");
    }
    let undamped = grows([[0.0; 2]; 2], stiffness)?;
    let alone = dampers.into_iter().any(grows_alone);
    Some(match (undamped, alone) {
        (true, true) => "both",
        (true, false) => "flutter",
        (false, true) => "negative-damping",
        (false, false) if grows(without, stiffness)? => "destabilised-by-damping",
        (false, false) => "normal-force-coupling",
    })
}

fn any_point() -> impl Strategy<Value = (Contact, Groups)> {
    let unequal = (logarithmic(1e-4, 0.3), logarithmic(1e-4, 0.3), logarithmic(0.3, 3.0));
    let groups = (any_structure(-1.5, 1.5), unequal).prop_map(|(groups, (damping_x, damping_y, ratio))| {
        Groups { damping_x, damping_y, frequency_ratio: ratio, ..groups }
    });
    (any_contact(), groups)
}

#[test]
fn the_mechanism_of_an_oscillator_is_what_removal_leaves() {
    let seen = RefCell::new(BTreeMap::<&str, u32>::new());
    for_each(POINTS, any_point(), |(contact, groups)| {
        let coefficients = groups.coefficients().unwrap();
        // a spring that pulls out may leave no steady sliding, or several
        let sliding = equilibrium(&contact, &coefficients);
        prop_assume!(sliding.is_ok());
        let system = Linearisation::new(contact.friction_load, &coefficients, &sliding.unwrap().response);
        let (damping, stiffness) = (system.damping(), system.stiffness());
        let dampers = [system.c11, system.c22];
        let without = [[system.c11, 0.0], [0.0, system.c22]];
        let expected = by_removal(damping, without, stiffness, dampers);
        prop_assume!(expected.is_some());
        let class = StabilityClass::of(&system.system().reduced().unwrap());
        prop_assert_eq!(Some(class.name()), expected);
        let mean = 0.5 * (system.c11 + system.c22);
        if class.name() == "destabilised-by-damping" {
            prop_assert_eq!(grows([[mean, 0.0], [0.0, mean]], stiffness), Some(false), "equal dampers");
        }
        if system.c21 == 0.0 {
            prop_assert_ne!(class.name(), "normal-force-coupling");
        }
        *seen.borrow_mut().entry(class.name()).or_default() += 1;
        Ok(())
    });
    let seen = seen.into_inner();
    let all =
        ["stable", "flutter", "negative-damping", "both", "normal-force-coupling", "destabilised-by-damping"];
    assert!(all.iter().all(|name| seen.get(name).is_some_and(|count| *count > 50)), "{seen:?}");
}

/// K with springs in both directions, C of any kind: dampers that are small or negative, cross terms of one sign, of both, one way.
fn any_general() -> impl Strategy<Value = LinearSystem> {
    let mass = (0.3..3.0_f64, 0.3..3.0_f64, prop_oneof![Just(0.0), -0.8..0.8_f64]);
    let damper = || prop_oneof![4 => logarithmic(1e-3, 0.5), 1 => -0.1..0.0_f64];
    let cross = || prop_oneof![2 => Just(0.0), 3 => -0.3..0.3_f64];
    (mass, (damper(), damper(), cross(), cross()), (0.5..3.0_f64, 0.5..3.0_f64, -1.5..1.5_f64, -1.5..1.5_f64))
        .prop_map(|((m1, m2, correlation), (c11, c22, c12, c21), (k11, k22, k12, k21))| {
            let off = correlation * (m1 * m2).sqrt();
            LinearSystem {
                mass: [[m1, off], [off, m2]],
                damping: [[c11, c12], [c21, c22]],
                stiffness: [[k11, k12], [k21, k22]],
            }
        })
}

#[test]
fn the_mechanism_of_a_general_system_is_what_removal_leaves() {
    let seen = RefCell::new(BTreeMap::<&str, u32>::new());
    for_each(POINTS, any_general(), |system| {
        let [[c11, c12], [c21, c22]] = system.damping;
        // what both directions give each other is a damper between them; the rest goes one way
        let shared = if c12.signum() == c21.signum() { c12.signum() * c12.abs().min(c21.abs()) } else { 0.0 };
        let reduced = |damping: Matrix| LinearSystem { damping, ..system }.reduced().unwrap();
        let without = reduced([[c11, shared], [shared, c22]]).damping;
        let whole = reduced(system.damping);
        let expected = by_removal(whole.damping, without, whole.stiffness, [c11, c22]);
        prop_assume!(expected.is_some());
        let class = StabilityClass::of_system(&system).unwrap();
        prop_assert_eq!(Some(class.name()), expected);
        *seen.borrow_mut().entry(class.name()).or_default() += 1;
        Ok(())
    });
    let seen = seen.into_inner();
    let all =
        ["stable", "flutter", "negative-damping", "both", "normal-force-coupling", "destabilised-by-damping"];
    assert!(all.iter().all(|name| seen.get(name).is_some_and(|count| *count > 50)), "{seen:?}");
}
