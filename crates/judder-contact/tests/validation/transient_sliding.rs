//! Sliding that has lasted long is steady sliding, computed otherwise.

use crate::questions::{assert_close, follow, paraboloid, transient};
use judder_contact::transient::{
    Before, CreepingSubstrate, CreepingTerm, IndenterPath, NormalCourse, PathCourse, TransientQuestion,
};
use judder_contact::unilateral::Loading;

fn agrees(substrate: &CreepingSubstrate, speed: f64, duration: f64, cells: usize, tolerance: [f64; 2]) {
    let path =
        IndenterPath::start_of_sliding(speed, 0.5, NormalCourse::Indentation(PathCourse::Constant(1.0)));
    let question = transient(substrate, &path, duration, cells);
    let history = follow(&TransientQuestion { before: Before::Settled, ..question });
    let steady = paraboloid(&substrate.sliding_at(speed), Loading::Indentation(1.0), 128).refinement;
    let from = 0.85 * duration;
    let force = history.mean(from, duration, |sample| sample.force);
    assert_close(force, steady.force.value, tolerance[0]);
    let friction = history.mean(from, duration, |sample| sample.friction_force) / force;
    assert_close(friction, steady.friction.value, tolerance[1]);
}

#[test]
fn long_sliding_becomes_steady() {
    let substrate = CreepingSubstrate::single(10.0, 1.0);
    agrees(&substrate, 0.1, 8.0, 40, [2e-3, 1e-2]);
    agrees(&substrate, 0.5, 8.0, 32, [3e-3, 3e-3]);
}

#[test]
fn two_retardation_times_become_steady_too() {
    let terms =
        vec![CreepingTerm { compliance: 0.4, time: 0.2 }, CreepingTerm { compliance: 0.4, time: 1.0 }];
    let substrate = CreepingSubstrate { instantaneous: 0.2, terms };
    agrees(&substrate, 0.5, 8.0, 32, [3e-3, 5e-3]);
}

#[test]
#[ignore = "expensive: run by make validate"]
fn fast_sliding_and_high_contrasts_become_steady() {
    let substrate = CreepingSubstrate::single(10.0, 1.0);
    agrees(&substrate, 3.0, 10.0, 32, [3e-3, 5e-3]);
    agrees(&substrate, 10.0, 10.0, 32, [3e-3, 1e-2]);
    let substrate = CreepingSubstrate::single(1000.0, 1.0);
    agrees(&substrate, 0.1, 8.0, 48, [3e-3, 1e-2]);
    agrees(&substrate, 1.0, 8.0, 48, [3e-3, 5e-3]);
}
