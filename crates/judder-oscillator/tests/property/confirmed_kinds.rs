//! The kind of an attractor does not depend on the tolerance at which it was sought: held against Newton's method and Floquet
//! multipliers for cycles, against much finer steps for steady sliding.

use crate::validation::limit_cycles::{settings, shooting};
use judder_contact::{FittedLaw, Law};
use judder_oscillator::cycle::{settle_confirmed, shoot};
use judder_oscillator::motion::attractor::{Attractor, Patience, Settled, settle};
use judder_oscillator::motion::{SlidingSystem, StickSlip};
use judder_oscillator::{Contact, FrictionLoad, Groups};

const LOOSE: f64 = 1e-6;
const FINE: f64 = 1e-11;
const PATIENCE: Patience =
    Patience { time: 5e3, transient: 2.5e3, closeness: 1e-6, rest: 1e-6, oscillations: 8 };

/// Weakly contracting cycles with short sticks, and steady sliding that motions approach slowly.
fn systems() -> Vec<StickSlip> {
    let contact = Contact {
        law: Law::Fitted(FittedLaw::oscillator_paper()),
        friction_load: FrictionLoad::ContactForce,
    };
    let points = [
        (7.5e-4, 2e-4, 4.73e-3),
        (7.5e-4, 2e-4, 5.08e-3),
        (7.5e-4, 8e-4, 2.4e-3),
        (7.5e-4, 8e-4, 3.2e-3),
        (1e-4, 1e-2, 6.21e-3),
        (1e-4, 1e-2, 6.92e-3),
        (1e-4, 1e-2, 7.46e-3),
    ];
    points
        .into_iter()
        .map(|(normal_load, velocity, shear_strength)| {
            let groups = Groups { normal_load, velocity, shear_strength, ..Groups::default() };
            StickSlip::new(contact.clone(), groups.coefficients().unwrap()).unwrap()
        })
        .collect()
}

/// Whether another algorithm finds the same kind at the end of a motion.
fn is_true(system: &StickSlip, attractor: &Attractor<4>) -> bool {
    match attractor.settled {
        Settled::SteadySliding => {
            let mut beside = system.steady_sliding();
            beside[0] += 1e-3 * system.scales()[0];
            let again = settle(system, beside, settings(system, FINE), &PATIENCE, &|| false).unwrap();
            again.settled == Settled::SteadySliding
        }
        Settled::Cycle { oscillations } => {
            let cycle = shoot(system, attractor.state, oscillations, &shooting(system, FINE));
            cycle.is_ok_and(|cycle| {
                let is_same = (cycle.period() / attractor.period - 1.0).abs() < 1e-4;
                cycle.is_stable() && cycle.oscillations == oscillations && is_same
            })
        }
        // a stable cycle that the motion has kept near to all the time would have been the right answer; an average over a
        // time that is no number of periods is off by a part of one
        Settled::Irregular => !attractor.recurrences.iter().any(|(state, oscillations)| {
            let cycle = shoot(system, *state, *oscillations, &shooting(system, FINE));
            cycle.is_ok_and(|cycle| {
                cycle.is_stable()
                    && (cycle.around.measures.rms() / attractor.measures.rms() - 1.0).abs() < 2e-2
            })
        }),
    }
}

#[test]
fn a_confirmed_kind_is_what_other_algorithms_find() {
    let mut alone = 0;
    for system in systems() {
        let mut start = system.steady_sliding();
        start[0] *= 1.2;
        let loose = settings(&system, LOOSE);
        alone +=
            usize::from(!is_true(&system, &settle(&system, start, loose, &PATIENCE, &|| false).unwrap()));
        let told = settle_confirmed(&system, start, loose, &PATIENCE, &|| false).unwrap();
        let shear = system.coefficients().shear_strength;
        assert!(told.is_confirmed, "{shear:e}: {:?} at {:e}", told.attractor.settled, told.tolerance);
        assert!(is_true(&system, &told.attractor), "{shear:e}: {:?}", told.attractor.settled);
    }
    // one tolerance alone is not enough: otherwise these systems would show nothing
    assert!(alone >= 4, "{alone}");
}

/// Steady sliding that does not decay is no attractor, though a motion at rest stays there.
#[test]
fn unstable_steady_sliding_is_not_told() {
    let contact = Contact {
        law: Law::Fitted(FittedLaw::oscillator_paper()),
        friction_load: FrictionLoad::ContactForce,
    };
    let groups = Groups { normal_load: 7.5e-4, velocity: 4e-4, shear_strength: 0.03, ..Groups::default() };
    let system = StickSlip::new(contact, groups.coefficients().unwrap()).unwrap();
    let (rest, loose) = (system.steady_sliding(), settings(&system, LOOSE));
    let alone = settle(&system, rest, loose, &PATIENCE, &|| false).unwrap();
    assert_eq!(alone.settled, Settled::SteadySliding);
    let told = settle_confirmed(&system, rest, loose, &PATIENCE, &|| false).unwrap();
    assert!(told.is_confirmed && matches!(told.attractor.settled, Settled::Cycle { .. }), "{told:?}");
}
