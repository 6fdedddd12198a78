//! A rod that meets a wall: ANSYS Verification Manual VM265, impact of an elastic rod on a rigid wall.

use crate::common::{IMPLICIT, assembly, coulomb, dense, diagonal, point_on_plane, settings};
use judder_assembly::assembly::Assembly;
use judder_nonsmooth::march::NonsmoothMarch;
use judder_nonsmooth::scheme::ContactScheme;

/// The manual's numbers, in its units of pounds and inches; its section is of one square inch.
const MODULUS: f64 = 3e7;
const DENSITY: f64 = 0.73e-3;
const LENGTH: f64 = 10.0;
const GAP: f64 = 0.01;
const SPEED: f64 = 202.2;
/// Times that the manual tells, in s.
const CONTACT: f64 = 0.494e-4;
const RELEASE: f64 = 0.148e-3;

/// Bars of the rod.
const MESHES: [usize; 4] = [25, 50, 100, 200];

/// What the wave takes through one of so many bars, in s.
fn passage(bars: usize) -> f64 {
    LENGTH / bars as f64 / (MODULUS / DENSITY).sqrt()
}

/// Bars of one length with lumped masses along the normal of the wall, and a freedom of its own along it.
fn rod(bars: usize) -> Assembly {
    let long = LENGTH / bars as f64;
    let (spring, mass) = (MODULUS / long, DENSITY * long);
    let mut masses = vec![mass; bars + 2];
    (masses[0], masses[bars]) = (0.5 * mass, 0.5 * mass);
    let mut stiffness = vec![vec![0.0; bars + 2]; bars + 2];
    for bar in 0..bars {
        stiffness[bar][bar] += spring;
        stiffness[bar + 1][bar + 1] += spring;
        stiffness[bar][bar + 1] -= spring;
        stiffness[bar + 1][bar] -= spring;
    }
    assembly(
        [diagonal(&masses), diagonal(&vec![0.0; bars + 2]), dense(&stiffness)],
        vec![0.0; bars + 2],
        vec![point_on_plane(&[bars + 1, 0], 1e-12, GAP)],
        coulomb(0.0),
    )
}

/// Times of contact and release in s, and the impulse of the wall over 2 m v.
fn impact(scheme: ContactScheme, bars: usize) -> [f64; 3] {
    let case = rod(bars);
    let step = 0.5 * passage(bars);
    let plateau = (DENSITY * MODULUS).sqrt() * SPEED;
    let mut march = NonsmoothMarch::new(&case, &[], settings(scheme, step)).unwrap();
    march.set_force_scale(plateau);
    let mut velocity = vec![-SPEED; bars + 2];
    velocity[bars + 1] = 0.0;
    march.start(&vec![0.0; bars + 2], &velocity);
    let (mut contact, mut release, mut impulse) = (None, 0.0, 0.0);
    while march.time() < 2e-4 {
        march.advance().unwrap();
        let force = march.force(0)[0];
        impulse += step * force;
        if force > 0.2 * plateau {
            contact.get_or_insert(march.time());
            release = march.time();
        }
    }
    [contact.unwrap(), release, impulse / (2.0 * DENSITY * LENGTH * SPEED)]
}

/// With 200 bars the rod meets the wall and leaves it when the manual says, to 1 %, and its momentum turns round to 1 %; the exact release is after
/// two passes of the wave, and what is off is at most one and a half of what the wave takes through a bar.
#[test]
fn a_rod_meets_a_wall_and_leaves_it_as_vm265() {
    let exact = GAP / SPEED + 2.0 * passage(1);
    for scheme in [IMPLICIT, ContactScheme::ForwardIncrement] {
        let all = MESHES.map(|bars| impact(scheme, bars));
        let [contact, release, impulse] = all[3];
        assert!((contact / CONTACT - 1.0).abs() < 0.01, "{scheme:?}: {contact}");
        assert!((release / RELEASE - 1.0).abs() < 0.01, "{scheme:?}: {release}");
        assert!((impulse - 1.0).abs() < 0.01, "{scheme:?}: {impulse}");
        for ([_, release, _], bars) in all.iter().zip(MESHES) {
            let off = (release - exact).abs();
            assert!(off < 1.5 * passage(bars), "{scheme:?}, {bars} bars: {off}");
        }
    }
}
