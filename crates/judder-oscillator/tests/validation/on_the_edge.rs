//! The oscillator on the very edge between stick, slip and lift-off.

use crate::validation::limit_cycles::settings;
use judder_contact::{FittedLaw, Law};
use judder_numerics::piecewise::PiecewiseMarch;
use judder_oscillator::motion::{ContactState, SlidingSystem, StickSlip};
use judder_oscillator::{Contact, FrictionLoad, Groups};

/// Without coupling and damping along x the force that sticking takes is x itself.
fn uncoupled() -> StickSlip {
    let contact = Contact {
        law: Law::Fitted(FittedLaw::oscillator_paper()),
        friction_load: FrictionLoad::ContactForce,
    };
    let groups = Groups {
        normal_load: 7.5e-4,
        velocity: 4e-4,
        shear_strength: 0.03,
        coupling: 0.0,
        damping_x: 0.0,
        ..Groups::default()
    };
    StickSlip::new(contact, groups.resolve()).unwrap()
}

/// At rest on the substrate, stretched to the limit of stick to the last bit.
fn at_the_limit(system: &StickSlip) -> [f64; 4] {
    let [_, y, ..] = system.steady_sliding();
    let c = system.coefficients();
    assert_eq!((c.k11, c.k12, c.damping_x), (1.0, 0.0, 0.0));
    let area = system.response(ContactState::Stick, &[0.0, y, system.belt_velocity(), 0.0]).area.value;
    [c.shear_strength * area / c.normal_load, y, system.belt_velocity(), 0.0]
}

#[test]
fn with_no_velocity_and_no_margin_the_rate_of_the_margin_decides() {
    let system = uncoupled();
    let rest = at_the_limit(&system);
    assert_eq!(system.relative_velocity(&rest), 0.0);
    // the substrate carries it on, so the margin shrinks
    assert_eq!(system.contact_state(&rest), ContactState::SlipBehind);
    // it sinks, and the area grows faster than the spring's pull
    let sinking = [rest[0], rest[1], rest[2], 1e3 * rest[2]];
    assert_eq!(system.contact_state(&sinking), ContactState::Stick);
    let less = [rest[0].next_down(), rest[1], rest[2], 0.0];
    assert_eq!(system.contact_state(&less), ContactState::Stick);
    let more = [rest[0].next_up(), rest[1], rest[2], 0.0];
    assert_eq!(system.contact_state(&more), ContactState::SlipBehind);
}

#[test]
fn starts_on_an_edge_go_on_and_lose_no_event() {
    let system = uncoupled();
    let rest = at_the_limit(&system);
    let velocity = system.belt_velocity();
    let starts = [
        rest,
        [-rest[0], rest[1], velocity, 0.0],
        // touching with v_rel = 0: two edges at once
        [rest[0], 0.0, velocity, 0.0],
        [0.0, 0.0, velocity, 0.0],
        [rest[0], 0.0, velocity, -0.1],
        [rest[0], 0.0, velocity, 0.1],
        [rest[0], -1e-12, velocity, 0.0],
    ];
    for start in starts {
        let mode = system.contact_state(&start);
        let mut march = PiecewiseMarch::new(&system, mode, start, settings(&system, 1e-10)).unwrap();
        let mut last = mode;
        while march.time() < 30.0 {
            let advance = march.advance(30.0).unwrap();
            if let Some(crossing) = advance.crossing {
                assert_eq!(crossing.from, last, "{start:?}: an event is lost");
                last = crossing.to;
            }
            let state = march.state();
            assert!(state.iter().all(|u| u.is_finite()));
            let slack = 1e-9 * system.scales()[1];
            match march.mode() {
                ContactState::LiftOff => assert!(state[1] <= slack, "{start:?} {state:?}"),
                ContactState::Stick => assert_eq!(state[2], velocity),
                _ => assert!(state[1] >= -slack, "{start:?} {state:?}"),
            }
        }
    }
}
