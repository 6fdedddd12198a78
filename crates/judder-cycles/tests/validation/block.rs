//! A block of quadrilaterals, nine nodes on a moving plane: the cycle of its unstable mode against its march.

use crate::common::block::block_held;
use crate::common::{IMPLICIT, settings};
use crate::growing;
use judder_assembly::friction::Friction;
use judder_assembly::interface::InterfaceLaw;
use judder_assembly::pressure::Pressure;
use judder_cycles::cycle::{CycleSettings, limit_cycles};
use judder_nonsmooth::march::NonsmoothMarch;
use judder_nonsmooth::statistics::Statistics;
use std::f64::consts::TAU;

/// Points stick, slide and lift off in both; the march knows nothing of periods.
#[test]
fn the_cycle_of_a_mode_is_what_the_march_settles_to() {
    const STEP: f64 = 1e-7;
    let law = InterfaceLaw::Compliant(Pressure::Stiffness(1e11), Friction::Constant(0.3));
    let case = block_held(law, 1.0, [100.0, 5e-8]);
    let (steady, values) = growing(&case, [1e3, 6e5]);
    assert_eq!(values.len(), 1);
    let found = limit_cycles(&case, &steady, values[0], &CycleSettings::default()).unwrap();
    let cycle = &found.cycles[0];
    assert!(
        cycle.attracts && cycle.held_back.is_none() && cycle.quality.left_out < 0.01,
        "{:?}",
        cycle.quality
    );
    let mut march = NonsmoothMarch::new(&case, &[], settings(IMPLICIT, STEP)).unwrap();
    let disturbed: Vec<f64> = (0..case.size()).map(|k| 1e-2 * (k as f64).sin()).collect();
    march.start(&steady.displacement, &disturbed);
    let mut told = Statistics::new(9);
    let (mut before, mut crossings) = (f64::NAN, Vec::new());
    for step in 0..250_000 {
        march.advance().unwrap();
        if step > 150_000 {
            told.take(&march);
            let [_, now, _] = march.velocity(0);
            if before < 0.0 && now >= 0.0 {
                crossings.push(march.time() - STEP * now / (now - before));
            }
            before = now;
        }
    }
    let turns = (crossings.len() - 1) as f64;
    let frequency = TAU * turns / (crossings[crossings.len() - 1] - crossings[0]);
    assert!((cycle.frequency() / frequency - 1.0).abs() < 1e-3, "{} {frequency}", cycle.frequency());
    for (point, own) in cycle.points.iter().enumerate() {
        let of_march = told.of(point).unwrap();
        let off = |a: f64, b: f64| (a / b - 1.0).abs();
        assert!(
            off(own.tangential_velocity_rms, of_march.tangential_velocity_rms) < 3e-3,
            "{own:?} {of_march:?}"
        );
        assert!(off(own.normal_force, of_march.normal_force_mean) < 3e-3, "{own:?} {of_march:?}");
        assert!((own.shares[2] - of_march.open_share).abs() < 2e-3, "{own:?} {of_march:?}");
        // what sticks is told by instants at which the velocity is small, not zero
        assert!((own.shares[0] - of_march.stick_share).abs() < 0.04, "{own:?} {of_march:?}");
    }
}
