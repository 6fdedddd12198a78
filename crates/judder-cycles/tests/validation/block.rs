//! A block of quadrilaterals, nine nodes on a moving plane: the cycle of its unstable mode against its march.

use crate::common::block::{block, block_held};
use crate::common::{IMPLICIT, settings};
use crate::growing;
use judder_assembly::assembly::Assembly;
use judder_assembly::friction::Friction;
use judder_assembly::interface::InterfaceLaw;
use judder_assembly::pressure::Pressure;
use judder_assembly::steady::SteadySliding;
use judder_cycles::cycle::{CycleSettings, HarmonicCount, limit_cycles};
use judder_cycles::stability::{CycleStability, floquet_multipliers};
use judder_nonsmooth::march::NonsmoothMarch;
use judder_nonsmooth::statistics::Statistics;
use std::f64::consts::TAU;

const STEP: f64 = 1e-7;

/// What the points of a march do in its last 100 000 steps, and when the first one's velocity rises through zero, in s.
fn marched(case: &Assembly, steady: &SteadySliding, steps: usize) -> (Statistics, Vec<f64>) {
    let mut march = NonsmoothMarch::new(case, &[], settings(IMPLICIT, STEP)).unwrap();
    let disturbed: Vec<f64> = (0..case.size()).map(|k| 1e-2 * (k as f64).sin()).collect();
    march.start(&steady.displacement, &disturbed);
    let mut told = Statistics::new(9);
    let (mut before, mut crossings) = (f64::NAN, Vec::new());
    for step in 0..steps {
        march.advance().unwrap();
        if step >= steps - 100_000 {
            told.take(&march);
            let [_, now, _] = march.velocity(0);
            if before < 0.0 && now >= 0.0 {
                crossings.push(march.time() - STEP * now / (now - before));
            }
            before = now;
        }
    }
    (told, crossings)
}

/// Points stick, slide and lift off in both; the march knows nothing of periods.
#[test]
fn the_cycle_of_a_mode_is_what_the_march_settles_to() {
    let law = InterfaceLaw::Compliant(Pressure::Stiffness(1e11), Friction::Constant(0.3));
    let case = block_held(law, 1.0, [100.0, 5e-8]);
    let (steady, values) = growing(&case, [1e3, 6e5]);
    assert_eq!(values.len(), 1);
    let found = limit_cycles(&case, &steady, values[0], &CycleSettings::default(), &|| true).unwrap();
    let cycle = &found.cycles[0];
    assert!(
        cycle.attracts == Some(true) && cycle.held_back.is_none() && cycle.quality.left_out < 0.01,
        "{:?}",
        cycle.quality
    );
    let multipliers = floquet_multipliers(&cycle.balance, &cycle.motion, &|| true).unwrap().unwrap();
    assert_eq!(multipliers.verdict(), CycleStability::Stable, "{multipliers:?}");
    assert!((multipliers.phase.unwrap() - 1.0).norm() < 0.01, "{multipliers:?}");
    let (told, crossings) = marched(&case, &steady, 250_000);
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
    // forces at instants, damping by harmonics
    let power = cycle.power(1000).unwrap();
    assert!(power.friction > 0.0 && power.damping < 0.0 && power.imbalance() < 1e-4, "{power:?}");
}

/// The march does not come to this cycle, and its multipliers say why: a pair of them lies outside the unit circle.
#[test]
#[ignore = "expensive"]
fn a_cycle_that_the_march_does_not_come_to_is_unstable() {
    let law = InterfaceLaw::Compliant(Pressure::Stiffness(1e11), Friction::Constant(0.35));
    let case = block(law, 1.0, [100.0, 5e-8]);
    let (steady, values) = growing(&case, [1e3, 6e5]);
    let settings = CycleSettings { harmonics: HarmonicCount::Fixed(80), ..CycleSettings::default() };
    let found = limit_cycles(&case, &steady, values[0], &settings, &|| true).unwrap();
    let cycle = &found.cycles[0];
    assert!(cycle.attracts == Some(true) && cycle.held_back.is_none());
    let multipliers = floquet_multipliers(&cycle.balance, &cycle.motion, &|| true).unwrap().unwrap();
    assert_eq!(multipliers.verdict(), CycleStability::Unstable, "{multipliers:?}");
    assert!(multipliers.values[0].im != 0.0);
    let (told, _) = marched(&case, &steady, 300_000);
    let of_march = told.of(0).unwrap().tangential_velocity_rms;
    assert!(cycle.points[0].tangential_velocity_rms > 1.1 * of_march, "{of_march}");
}
