//! Groups and quantities with units hold the same information.

use crate::sampling::{any_groups, for_each, logarithmic};
use judder_oscillator::Groups;
use judder_oscillator::groups::Scales;
use proptest::prelude::*;

fn values(g: &Groups) -> [f64; 10] {
    [
        g.stiffness,
        g.retardation_time,
        g.velocity,
        g.normal_load,
        g.shear_strength,
        g.damping_x,
        g.damping_y,
        g.frequency_ratio,
        g.coupling,
        g.coupling_angle,
    ]
}

#[test]
fn groups_to_units_and_back() {
    let scales = (logarithmic(1e3, 1e11), logarithmic(1e-6, 1.0), logarithmic(1e-2, 1e6)).prop_map(
        |(reduced_modulus, radius, natural_frequency)| Scales { reduced_modulus, radius, natural_frequency },
    );
    for_each(10_000, (any_groups(), scales), |(groups, scales)| {
        let dimensional = groups.dimensional(&scales);
        let back = dimensional.groups();
        for (a, b) in values(&groups).into_iter().zip(values(&back)) {
            prop_assert!((a - b).abs() <= 8.0 * f64::EPSILON * a, "{a} came back as {b}");
        }
        prop_assert_eq!(dimensional.scales(), scales);
        Ok(())
    });
}
