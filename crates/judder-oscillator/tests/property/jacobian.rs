//! C and K (20) are the Jacobian of the equations of motion (12).

use crate::sampling::{any_contact, any_groups, for_each};
use judder_oscillator::equilibrium::equilibrium;
use judder_oscillator::linearisation::Linearisation;
use judder_oscillator::motion::accelerations;
use judder_oscillator::{Coefficients, Contact};
use proptest::prelude::*;

/// Step of the differences, relative to the size of what is varied.
const STEP: f64 = 1e-3;

/// Central difference of fourth order of the accelerations along one coordinate of the state.
fn slope(contact: &Contact, c: &Coefficients, at: &[f64; 4], coordinate: usize, step: f64) -> [f64; 2] {
    let moved = |steps: f64| {
        let mut state = *at;
        state[coordinate] += steps * step;
        accelerations(contact, c, &state)
    };
    let [far_left, left, right, far_right] = [-2.0, -1.0, 1.0, 2.0].map(moved);
    [0, 1].map(|i| (8.0 * (right[i] - left[i]) - (far_right[i] - far_left[i])) / (12.0 * step))
}

/// Random points of the whole range, both friction loads, all laws, all structures: 1e-6 of the terms that an entry sums,
/// beside what rounding leaves of a difference.
#[test]
fn damping_and_stiffness_are_the_jacobian_of_the_motion() {
    for_each(20_000, (any_contact(), any_groups()), |(contact, groups)| {
        let c = groups.coefficients().unwrap();
        let e = equilibrium(&contact, &c).unwrap();
        let l = Linearisation::new(contact.friction_load, &c, &e.response);
        let at = [e.x, e.y, 0.0, 0.0];

        let friction = c.k11 * e.x + c.k12 * e.y;
        let force = e.response.force.value / c.normal_load;
        let sizes = [
            (c.k11 * e.x).abs() + (c.k12 * e.y).abs() + friction.abs(),
            (c.k22 * e.y).abs() + (c.k12 * e.x).abs() + force + 1.0,
        ];
        let rest = accelerations(&contact, &c, &at);
        prop_assert!((0..2).all(|i| rest[i].abs() <= 1e-12 * sizes[i]), "no equilibrium: {rest:?}");

        // of each coordinate: its size, the entries that it brings into C or K, and the sizes of the terms that these sum
        let velocity = c.velocity * c.radius() / c.retardation_time;
        let coordinates: [(f64, [f64; 2], [f64; 2]); 4] = [
            (e.x.abs().max(e.y), [l.k11, l.k12], [l.k11, l.k12.abs()]),
            (e.y, [l.k12 + l.k12c, l.k22], [l.k12.abs() + l.k12c.abs(), c.k22 + (l.k22 - c.k22).abs()]),
            (velocity, [l.c11, l.c21], [c.damping_x + (l.c11 - c.damping_x).abs(), l.c21.abs()]),
            (e.y, [0.0, l.c22], [0.0, l.c22]),
        ];
        for (k, (size, entries, terms)) in coordinates.into_iter().enumerate() {
            let step = STEP * size;
            let slopes = slope(&contact, &c, &at, k, step);
            for i in 0..2 {
                let rounding = 16.0 * f64::EPSILON * sizes[i] / step;
                prop_assert!(
                    (slopes[i] + entries[i]).abs() <= 1e-6 * terms[i] + rounding,
                    "row {i}, coordinate {k}: {} by differences, {} by the law",
                    -slopes[i],
                    entries[i]
                );
            }
        }
        Ok(())
    });
}
