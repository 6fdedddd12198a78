//! Cycles by a march that comes back, against those by harmonics: two ways that share neither the unknowns nor the treatment of the contact.

use crate::common::block::{block, block_held};
use crate::growing;
use judder_assembly::friction::Friction;
use judder_assembly::interface::InterfaceLaw;
use judder_assembly::pressure::Pressure;
use judder_cycles::CyclesError;
use judder_cycles::cycle::{CycleSettings, limit_cycles};
use judder_cycles::shooting::{ShootingSettings, shoot};

/// A stable cycle and one that no march comes to.
#[test]
fn a_march_comes_back_to_where_a_cycle_by_harmonics_begins() {
    let law = |friction| InterfaceLaw::Compliant(Pressure::Stiffness(1e11), Friction::Constant(friction));
    let damping = [100.0, 5e-8];
    for case in [block_held(law(0.3), 1.0, damping), block(law(0.35), 1.0, damping)] {
        let (steady, values) = growing(&case, [1e3, 6e5]);
        let found = limit_cycles(&case, &steady, values[0], &CycleSettings::default(), &|| true).unwrap();
        let cycle = &found.cycles[0];
        let [few, many] = [512, 2048].map(|steps| {
            let settings = ShootingSettings { steps, ..ShootingSettings::default() };
            shoot(&case, &cycle.balance, &cycle.motion, &settings, &|| true).unwrap()
        });
        assert!(many.residual <= 1e-7 && many.iterations < 8, "{}", many.iterations);
        let off = |frequency: f64| (frequency / cycle.frequency() - 1.0).abs();
        assert!(off(many.frequency) < 1e-4, "{} {}", many.frequency, cycle.frequency());
        assert!((few.frequency / many.frequency - 1.0).abs() < 3e-5, "{} {}", few.frequency, many.frequency);
        for (point, own) in cycle.points.iter().enumerate() {
            let shot = many.statistics.of(point).unwrap();
            let rms = own.tangential_velocity_rms / shot.tangential_velocity_rms - 1.0;
            assert!(rms.abs() < 3e-3, "{point}: {own:?} {shot:?}");
            assert!((own.shares[2] - shot.open_share).abs() < 5e-3, "{point}: {own:?} {shot:?}");
        }
    }
}

/// With too few steps of Newton's method it says what is missed.
#[test]
fn a_march_that_does_not_come_back_says_what_it_misses() {
    let law = InterfaceLaw::Compliant(Pressure::Stiffness(1e11), Friction::Constant(0.3));
    let case = block_held(law, 1.0, [100.0, 5e-8]);
    let (steady, values) = growing(&case, [1e3, 6e5]);
    let found = limit_cycles(&case, &steady, values[0], &CycleSettings::default(), &|| true).unwrap();
    let cycle = &found.cycles[0];
    let settings = ShootingSettings { steps: 256, iterations: 0, ..ShootingSettings::default() };
    let error = shoot(&case, &cycle.balance, &cycle.motion, &settings, &|| true).unwrap_err();
    assert!(matches!(error, CyclesError::NotReturned { iterations: 0, missed } if missed < 0.1), "{error}");
}
