//! Closed forms, and eigenvalues.

pub(crate) mod block;
mod driven;
mod rod;
mod travel;

use crate::common::{IMPLICIT, assembly, coulomb, diagonal, mass_on_plane, point_on_plane, settings};
use judder_nonsmooth::NonsmoothError;
use judder_nonsmooth::contact_problem::PointMotion;
use judder_nonsmooth::march::NonsmoothMarch;
use judder_nonsmooth::scheme::ContactScheme;

/// A track that all but rests.
const REST: f64 = 1e-12;

/// ANSYS Verification Manual VM73: a mass of 10/386 on a spring of 30 with friction of 1.875, let go at −1, is at 0.87208 after 0.09 s.
#[test]
fn a_mass_with_friction_swings_as_vm73() {
    let case = mass_on_plane(10.0 / 386.0, 30.0, [0.0, -10.0], 0.1875, REST);
    for (scheme, allowed) in
        [(IMPLICIT, 2e-5), (ContactScheme::ForwardIncrement, 2e-5), (ContactScheme::Smoothed, 1e-3)]
    {
        let mut march = NonsmoothMarch::new(&case, &[], settings(scheme, 1e-5)).unwrap();
        march.set_force_scale(10.0);
        march.start(&[-1.0, 0.0], &[0.0; 2]);
        (0..9000).for_each(|_| march.advance().unwrap());
        let [place, _] = march.state();
        // half a period to x₁ = 1 − 2·0.0625, then on in closed form; the manual prints 0.87208 of it
        assert!((place[0] - 0.872_08).abs() < 3e-5 + allowed, "{scheme:?}: {}", place[0]);
    }
}

/// A block on a plane that is pushed: it stays where the push is below μ N, slides with (F − μ N)/m above it, and stops after v²/(2 μ g) when thrown.
#[test]
fn a_block_stays_slides_and_stops() {
    let (mass, weight, friction, step) = (2.0, 20.0, 0.3, 1e-4);
    for scheme in [IMPLICIT, ContactScheme::ForwardIncrement] {
        let run = |push: f64, velocity: f64, steps: usize| {
            let case = mass_on_plane(mass, 0.0, [push, -weight], friction, REST);
            let mut march = NonsmoothMarch::new(&case, &[], settings(scheme, step)).unwrap();
            march.set_force_scale(weight);
            march.start(&[0.0; 2], &[velocity, 0.0]);
            (0..steps).for_each(|_| march.advance().unwrap());
            (march.state()[0][0], march.motion(0), march.force(0))
        };
        let (place, motion, force) = run(5.9, 0.0, 1000);
        assert!(place.abs() < 1e-12 && motion == PointMotion::Stick, "{place}");
        assert!((force[0] - weight).abs() < 1e-9 && (force[1] + 5.9).abs() < 1e-9, "{force:?}");
        let (place, motion, _) = run(8.0, 0.0, 1000);
        assert!((place - 0.5 * (8.0 - 6.0) / mass * 0.01).abs() < 2.0 * step * 0.1, "{place}");
        assert_eq!(motion, PointMotion::Slip);
        let (place, motion, _) = run(0.0, 1.0, 5000);
        let stopped = 1.0 / (2.0 * friction * weight / mass);
        assert!((place - stopped).abs() < 2.0 * step, "{place} {stopped}");
        assert_eq!(motion, PointMotion::Stick);
    }
}

/// With more than 1/(1 + e) impacts would give energy, with less than ½ a step would.
#[test]
fn an_implicitness_that_gives_energy_is_refused() {
    let case = mass_on_plane(1.0, 1.0, [0.0, -1.0], 0.1, REST);
    for (restitution, implicitness, is_known) in [
        (0.0, 1.0, true),
        (0.5, 0.66, true),
        (0.5, 0.67, false),
        (0.0, 0.49, false),
        (0.0, f64::NAN, false),
        (1.1, 0.5, false),
    ] {
        let scheme = ContactScheme::MoreauJean { restitution, implicitness };
        let march = NonsmoothMarch::new(&case, &[], settings(scheme, 1e-4));
        assert_eq!(march.is_ok(), is_known, "{scheme:?}");
        assert!(is_known || matches!(march, Err(NonsmoothError::InvalidNumber { .. })), "{scheme:?}");
    }
}

/// A ball that falls from h meets the plane after √(2 h/g) and rises to e² h.
#[test]
fn a_ball_bounces_with_its_restitution() {
    let (height, gravity, restitution, step) = (0.1, 10.0, 0.5, 1e-5);
    let case = assembly(
        [diagonal(&[1.0; 2]), diagonal(&[0.0; 2]), diagonal(&[0.0; 2])],
        vec![0.0, -gravity],
        vec![point_on_plane(&[0, 1], REST, height)],
        coulomb(0.0),
    );
    let mut march = NonsmoothMarch::new(
        &case,
        &[],
        settings(ContactScheme::MoreauJean { restitution, implicitness: 0.5 }, step),
    )
    .unwrap();
    march.set_force_scale(gravity);
    let mut met = None;
    let mut highest = 0.0_f64;
    for _ in 0..30_000 {
        march.advance().unwrap();
        if march.motion(0) != PointMotion::Open {
            if met.is_some_and(|met| march.time() > met + 0.1) {
                break;
            }
            met.get_or_insert(march.time());
        }
        if met.is_some() {
            highest = highest.max(march.gap(0));
        }
    }
    assert!((met.unwrap() - (2.0 * height / gravity).sqrt()).abs() < 2.0 * step, "{met:?}");
    assert!((highest - restitution * restitution * height).abs() < 1e-5, "{highest}");
}

/// A mass on a belt through a spring: it sticks until k x = μ N, and swings about μ N/k with the amplitude V/ω that it leaves with.
#[test]
fn a_mass_on_a_belt_sticks_and_slips() {
    let (mass, spring, weight, friction, speed) = (1.0, 100.0, 10.0, 0.4, 0.5);
    let case = mass_on_plane(mass, spring, [0.0, -weight], friction, speed);
    for scheme in [IMPLICIT, ContactScheme::ForwardIncrement, ContactScheme::Smoothed] {
        let step = 1e-5;
        let mut march = NonsmoothMarch::new(&case, &[], settings(scheme, step)).unwrap();
        march.set_force_scale(weight);
        march.start(&[0.0; 2], &[speed, 0.0]);
        let mut farthest = 0.0_f64;
        for _ in 0..200_000 {
            march.advance().unwrap();
            farthest = farthest.max(march.state()[0][0]);
        }
        // it leaves with the belt's speed at k x = μ N and goes on by V/ω
        let reached = friction * weight / spring + speed * (mass / spring).sqrt();
        let allowed = if scheme == ContactScheme::Smoothed { 2e-2 } else { 1e-4 };
        assert!((farthest - reached).abs() < allowed * reached, "{scheme:?}: {farthest} {reached}");
    }
}

/// In space friction drags against the slip: a puck thrown across a belt curves until both components end together, and the heat
/// is the energy that it loses beside the belt.
#[test]
fn a_puck_on_a_belt_stops_against_its_slip() {
    let (mass, weight, friction, speed, step) = (1.0, 10.0, 0.2, 0.3, 1e-5);
    let case = assembly(
        [diagonal(&[mass; 3]), diagonal(&[0.0; 3]), diagonal(&[0.0; 3])],
        vec![0.0, -weight, 0.0],
        vec![point_on_plane(&[0, 1, 2], speed, 0.0)],
        coulomb(friction),
    );
    for scheme in [IMPLICIT, ContactScheme::ForwardIncrement] {
        let mut march = NonsmoothMarch::new(&case, &[], settings(scheme, step)).unwrap();
        march.set_force_scale(weight);
        let thrown = 0.4;
        march.start(&[0.0; 3], &[0.0, 0.0, thrown]);
        let slip = f64::hypot(speed, thrown);
        let steps = (slip / (friction * weight / mass) / step) as usize;
        (0..steps + 10).for_each(|_| march.advance().unwrap());
        assert_eq!(march.motion(0), PointMotion::Stick);
        let [place, velocity] = march.state();
        assert!((velocity[0] - speed).abs() < 1e-9 && velocity[2].abs() < 1e-9, "{velocity:?}");
        // constant deceleration along the slip from the start
        let time = slip / (friction * weight / mass);
        assert!((place[2] - 0.5 * thrown * time).abs() < 1e-4 * place[2], "{place:?}");
        let heat = march.works().heat;
        assert!((heat - 0.5 * mass * slip * slip).abs() < 1e-4 * heat, "{heat}");
    }
}
