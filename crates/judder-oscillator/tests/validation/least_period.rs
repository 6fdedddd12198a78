//! A cycle's period is its least one: cycles walked twice against cycles whose period has doubled.

use super::limit_cycles::{disturbed, section_5, settings, shooting};
use judder_contact::{FittedLaw, Law};
use judder_oscillator::cycle::shooting::{Cycle, from_simulation, shoot};
use judder_oscillator::cycle::{Continuation, continue_branch, return_map};
use judder_oscillator::motion::attractor::{Patience, Settled, distance, settle};
use judder_oscillator::motion::history::follow_cycle;
use judder_oscillator::motion::{SlidingSystem, StickSlip};
use judder_oscillator::{Contact, FrictionLoad, Groups};

/// v̂_d of the cycle that alternating returns come to.
const VELOCITY: f64 = 0.000_043_36;

/// The paper's oscillator where returns to its cycle alternate: found by hand.
fn alternating(velocity: f64) -> StickSlip {
    let contact =
        Contact { law: Law::Fitted(FittedLaw::oscillator_paper()), friction_load: FrictionLoad::NormalLoad };
    let groups = Groups { velocity, shear_strength: 0.010_76, ..Groups::default() };
    StickSlip::new(contact, groups.coefficients().unwrap()).unwrap()
}

fn least_multiplier(cycle: &Cycle<4>) -> f64 {
    cycle.multipliers.iter().map(|m| m.re).fold(f64::INFINITY, f64::min)
}

/// The motion itself says what its period is: over two oscillations it is where it was half of the time before.
#[test]
fn a_cycle_that_alternating_returns_come_to_has_the_period_of_one_oscillation() {
    let system = alternating(VELOCITY);
    let start = disturbed(&system);
    let shooting = shooting(&system, 1e-10);
    let limits = shooting.settings;
    let cycle = from_simulation(&system, start, &shooting, &Patience::default(), &|| false).unwrap();
    let two = return_map(&system, cycle.start, 2, limits, shooting.longest).unwrap().time;
    let history = follow_cycle(&system, cycle.start, limits, 2, two, 2049).unwrap();
    let half_later = &history.samples[history.samples.len() / 2..];
    let (smallest, largest) = history.measures.range;
    let shifts = history.samples.iter().zip(half_later).map(|(a, b)| (a.state[0] - b.state[0]).abs());
    let shift = shifts.fold(0.0, f64::max);
    assert!(half_later.len() == 1025 && shift < 1e-8 * (largest - smallest), "{shift:e}");

    assert_eq!(cycle.oscillations, 1);
    assert!((cycle.period() / two - 0.5).abs() < 1e-9 && (cycle.period() - 6.222_25).abs() < 1e-5);
    assert!((least_multiplier(&cycle) + 0.7713).abs() < 1e-4, "{:?}", cycle.multipliers);
    let settled = settle(&system, start, limits, &Patience::default(), &|| false).unwrap();
    assert_eq!(settled.settled, Settled::Cycle { oscillations: 1 });
    assert!((settled.period - cycle.period()).abs() < 1e-5, "{}", settled.period);
}

/// A return to the start after one oscillation is one after any number of them.
#[test]
fn a_cycle_sought_over_several_oscillations_is_the_one_sought_over_one() {
    let system = alternating(VELOCITY);
    let shooting = shooting(&system, 1e-10);
    let start = from_simulation(&system, disturbed(&system), &shooting, &Patience::default(), &|| false)
        .unwrap()
        .start;
    let mut beside = start;
    beside[0] += 1e-6 * system.scales()[0];
    let one = shoot(&system, beside, 1, &shooting).unwrap();
    for oscillations in [2, 3, 6] {
        let cycle = shoot(&system, beside, oscillations, &shooting).unwrap();
        assert_eq!(cycle.oscillations, 1);
        assert!((cycle.period() / one.period() - 1.0).abs() < 1e-8, "{oscillations}: {}", cycle.period());
        for (a, b) in cycle.multipliers.iter().zip(&one.multipliers) {
            assert!((a - b).norm() < 1e-4, "{oscillations}: {:?} {:?}", cycle.multipliers, one.multipliers);
        }
    }
    let at = |factor: f64| Ok(alternating(factor * VELOCITY));
    let options =
        Continuation { shooting, range: (0.9, 1.1), steps: (1e-3, 1e-2), points: 3, parameter_scale: 1.0 };
    let branch = continue_branch(&at, 1.0, (beside, 2), 1.0, &options).unwrap();
    assert!(branch.points.len() == 3 && branch.points.iter().all(|point| point.cycle.oscillations == 1));
}

/// A cycle doubles its period where a multiplier passes −1 (any text on bifurcations): beyond, the short cycle is another, unstable one,
/// and motions settle to the doubled one, which misses its start after one oscillation.
#[test]
fn a_period_that_has_doubled_stays_doubled() {
    let mut doubled = Vec::new();
    for shear_strength in [0.002_96, 0.002_98, 0.002_985, 0.002_99, 0.003, 0.003_02] {
        let system = section_5(shear_strength, FrictionLoad::ContactForce);
        let shooting = shooting(&system, 1e-10);
        let cycle =
            from_simulation(&system, disturbed(&system), &shooting, &Patience::default(), &|| false).unwrap();
        let short = shoot(&system, cycle.start, 1, &shooting).unwrap();
        println!("{shear_strength} {} {} {}", cycle.oscillations, cycle.period(), least_multiplier(&short));
        let again = shoot(&system, cycle.start, 4, &shooting).unwrap();
        assert_eq!(again.oscillations, cycle.oscillations);
        assert!((again.period() / cycle.period() - 1.0).abs() < 1e-6);
        assert!(cycle.is_stable());
        assert_eq!(cycle.oscillations == 2, least_multiplier(&short) < -1.0, "{shear_strength}");
        if cycle.oscillations == 2 {
            let once = return_map(&system, cycle.start, 1, settings(&system, 1e-10), 2000.0).unwrap();
            let miss = distance(&once.state, &cycle.start, &system.scales());
            assert!(miss > 1e-2, "{shear_strength}: {miss:e}");
            doubled.push(shear_strength);
        }
    }
    assert!(!doubled.is_empty() && doubled.len() < 6, "{doubled:?}");
}
