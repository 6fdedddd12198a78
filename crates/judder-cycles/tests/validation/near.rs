//! Cycles that are found from a march, against those that are found from the mode.

use super::belt::{by_the_motion_itself, mass_on_belt};
use crate::common::block::block_held;
use crate::growing;
use judder_assembly::friction::Friction;
use judder_assembly::interface::InterfaceLaw;
use judder_assembly::pressure::Pressure;
use judder_cycles::CyclesError;
use judder_cycles::cycle::{CycleSettings, HarmonicCount, limit_cycles};
use judder_cycles::marched::{MarchedSettings, marched_period};
use judder_cycles::near::cycle_near;

/// Points stick, slide and lift off.
#[test]
fn from_a_march_the_cycle_is_that_of_the_mode() {
    let law = InterfaceLaw::Compliant(Pressure::Stiffness(1e11), Friction::Constant(0.3));
    let case = block_held(law, 1.0, [100.0, 5e-8]);
    let (steady, values) = growing(&case, [1e3, 6e5]);
    let settings = CycleSettings { harmonics: HarmonicCount::Fixed(27), ..CycleSettings::default() };
    let expected = &limit_cycles(&case, &steady, values[0], &settings, &|| true).unwrap().cycles[0];
    let knocked: Vec<f64> = (0..case.size()).map(|k| 1e-2 * (k as f64).sin()).collect();
    let march = MarchedSettings { step: 2e-7, duration: 25e-3 };
    let known = marched_period(&case, &steady, [&steady.displacement, &knocked], &march, &|| true).unwrap();
    assert!((known.frequency / expected.frequency() - 1.0).abs() < 1e-3);
    let cycle = cycle_near(&case, &steady, &known, &settings, &|| true).unwrap();
    assert!(cycle.held_back.is_none() && cycle.attracts.is_none());
    let off = cycle.frequency() / expected.frequency() - 1.0;
    // what is left of the contact laws between instants is weighed by other frequencies
    assert!(off.abs() < 1e-6, "{off}");
    for (own, expected) in cycle.points.iter().zip(&expected.points) {
        let off = own.tangential_velocity_rms / expected.tangential_velocity_rms - 1.0;
        assert!(off.abs() < 1e-4, "{own:?} {expected:?}");
    }
    let none = vec![0.0; case.size()];
    let short = MarchedSettings { step: 2e-7, duration: 4e-3 };
    let small: Vec<f64> = knocked.iter().map(|own| 1e-6 * own).collect();
    let early = marched_period(&case, &steady, [&steady.displacement, &small], &short, &|| true);
    assert!(
        matches!(early, Err(CyclesError::StillChanges { .. } | CyclesError::NotPeriodic { .. })),
        "{early:?}"
    );
    let stopped = marched_period(&case, &steady, [&steady.displacement, &none], &short, &|| false);
    assert_eq!(stopped, Err(CyclesError::Stopped));
}

/// The march knows no harmonics, the motion itself neither.
#[test]
fn from_a_march_a_mass_sticks_and_slips_as_the_motion_itself_does() {
    let case = mass_on_belt();
    let (steady, _) = growing(&case, [5.0, 20.0]);
    let [frequency, _, rms] = by_the_motion_itself();
    let settings = CycleSettings { harmonics: HarmonicCount::Fixed(40), ..CycleSettings::default() };
    let march = MarchedSettings { step: 1e-3, duration: 20.0 };
    let start = [&steady.displacement[..], &[0.2, 0.0]];
    let known = marched_period(&case, &steady, start, &march, &|| true).unwrap();
    assert!((known.frequency / frequency - 1.0).abs() < 2e-3, "{} {frequency}", known.frequency);
    let cycle = cycle_near(&case, &steady, &known, &settings, &|| true).unwrap();
    assert!((cycle.frequency() / frequency - 1.0).abs() < 5e-4, "{} {frequency}", cycle.frequency());
    assert!((cycle.points[0].tangential_velocity_rms / rms - 1.0).abs() < 5e-4);
}
