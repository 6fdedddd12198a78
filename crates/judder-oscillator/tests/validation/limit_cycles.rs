//! The stick-slip cycles of section 5 of the text: F̃_n = 7.5e-4, ṽ_d = 5e-3.

use judder_contact::{FittedLaw, Law};
use judder_numerics::piecewise::StepSettings;
use judder_oscillator::critical::{ParameterRange, RangeScale, thresholds};
use judder_oscillator::cycle::shooting::{Shooting, from_simulation, shoot};
use judder_oscillator::cycle::{BranchEnd, Continuation, continue_branch, global_margin, return_map};
use judder_oscillator::hopf::{growth_rate, growth_slope, hopf_point};
use judder_oscillator::motion::attractor::{Patience, Settled, settle};
use judder_oscillator::motion::{ContactState, SlidingSystem, StickSlip};
use judder_oscillator::{Contact, FrictionLoad, Groups};

pub(crate) fn section_5(shear_strength: f64, friction_load: FrictionLoad) -> StickSlip {
    let contact = Contact { law: Law::Fitted(FittedLaw::oscillator_paper()), friction_load };
    let groups = Groups { normal_load: 7.5e-4, velocity: 4e-4, shear_strength, ..Groups::default() };
    StickSlip::new(contact, groups.coefficients().unwrap()).unwrap()
}

pub(crate) fn settings<const N: usize>(system: &impl SlidingSystem<N>, tolerance: f64) -> StepSettings<N> {
    let absolute = system.scales().map(|scale| tolerance * scale);
    StepSettings { relative: tolerance, absolute, longest_step: 1.0, steps: 10_000_000 }
}

pub(crate) fn shooting<const N: usize>(system: &impl SlidingSystem<N>, tolerance: f64) -> Shooting<N> {
    Shooting {
        settings: settings(system, tolerance),
        tolerance: 100.0 * tolerance,
        iterations: 20,
        longest: 2000.0,
    }
}

pub(crate) fn disturbed(system: &StickSlip) -> [f64; 4] {
    let mut start = system.steady_sliding();
    start[0] += 0.2 * start[0].abs();
    start
}

/// Our notes on the paper: stable, with a period of about 133.
#[test]
fn the_cycle_at_0_03_has_a_period_of_about_133_and_is_stable() {
    for (load, period) in [(FrictionLoad::NormalLoad, 132.855_768), (FrictionLoad::ContactForce, 131.894_444)]
    {
        let system = section_5(0.03, load);
        let cycle = from_simulation(
            &system,
            disturbed(&system),
            &shooting(&system, 1e-11),
            &Patience::default(),
            &|| false,
        )
        .unwrap();
        assert!((cycle.period() - period).abs() < 1e-5, "{}", cycle.period());
        assert!(
            cycle.is_stable() && cycle.trivial_error < 1e-5,
            "{:?} {:e}",
            cycle.multipliers,
            cycle.trivial_error
        );
        assert!(cycle.fraction(ContactState::Stick) > 0.97);
    }
}

/// Our notes on the paper: an orbit of period about 204 is unstable, and motions stay irregular. They give its multiplier as 1.5; from
/// the saltation matrices, which differences of the return map confirm elsewhere, it is 1.214.
#[test]
fn the_cycle_at_0_05_is_unstable_and_found_beside_the_irregular_motion() {
    let system = section_5(0.05, FrictionLoad::NormalLoad);
    let patience = Patience { time: 5e3, ..Patience::default() };
    let limits = settings(&system, 1e-9);
    let settled = settle(&system, disturbed(&system), limits, &patience, &|| false).unwrap();
    assert_eq!(settled.settled, Settled::Irregular);
    let cycle =
        from_simulation(&system, disturbed(&system), &shooting(&system, 1e-9), &patience, &|| false).unwrap();
    println!("{} {:?}", cycle.period(), cycle.multipliers);
    assert!((cycle.period() - 205.094).abs() < 1e-2, "{}", cycle.period());
    assert!((cycle.largest_multiplier() - 1.214).abs() < 1e-2, "{:?}", cycle.multipliers);
}

#[test]
fn the_monodromy_agrees_with_differences_of_the_return_map() {
    for load in [FrictionLoad::NormalLoad, FrictionLoad::ContactForce] {
        let system = section_5(0.03, load);
        let limits = settings(&system, 1e-12);
        let cycle = from_simulation(
            &system,
            disturbed(&system),
            &shooting(&system, 1e-12),
            &Patience::default(),
            &|| false,
        )
        .unwrap();
        let scales = system.scales();
        let around = |start| return_map(&system, start, cycle.oscillations, limits, 1000.0).unwrap();
        let exact = around(cycle.start).derivative;
        let scaled = |i: usize, j: usize, entry: f64| entry * scales[j] / scales[i];
        let largest =
            (0..16).fold(0.0_f64, |largest, k| largest.max(scaled(k / 4, k % 4, exact[k / 4][k % 4]).abs()));
        for column in [0, 1, 3] {
            let moved = |by: f64| {
                let mut start = cycle.start;
                start[column] += by * scales[column];
                around(start).state
            };
            let (far, near) = (1e-4, 5e-5);
            let slope = |by: f64, i: usize| (moved(by)[i] - moved(-by)[i]) / (2.0 * by * scales[column]);
            for i in [0, 1, 3] {
                let difference = (4.0 * slope(near, i) - slope(far, i)) / 3.0;
                let error = scaled(i, column, difference - exact[i][column]).abs();
                assert!(error < 1e-6 * largest, "{load:?} {i} {column}: {difference} {}", exact[i][column]);
            }
        }
    }
}

#[test]
fn above_a_supercritical_threshold_the_amplitude_follows_the_lyapunov_coefficient() {
    let load = FrictionLoad::ContactForce;
    let contact = Contact { law: Law::Fitted(FittedLaw::oscillator_paper()), friction_load: load };
    let range = ParameterRange { from: 1e-4, to: 1e-1, scale: RangeScale::Logarithmic };
    let at = |shear_strength| *section_5(shear_strength, load).coefficients();
    let threshold = thresholds(&contact, &range, 200, at).full[0];
    let hopf = hopf_point(&section_5(threshold, load)).unwrap();
    println!("{threshold} {hopf:?}");
    assert!(!hopf.is_subcritical());
    let growth_at = |shear_strength| growth_rate(&section_5(shear_strength, load)).ok();
    let factor = hopf.amplitude_factor(growth_slope(growth_at, threshold, threshold).unwrap());
    for beyond in [1e-4, 1e-3] {
        let system = section_5(threshold * (1.0 + beyond), load);
        let here = hopf_point(&system).unwrap();
        let predicted = hopf.rms(here.growth_rate).unwrap();
        let start = hopf.state_on_cycle(&system.steady_sliding(), predicted);
        let cycle = shoot(&system, start, 1, &shooting(&system, 1e-12)).unwrap();
        println!("{beyond} {predicted} {} {:?}", cycle.around.measures.rms(), cycle.multipliers);
        assert!(cycle.is_stable());
        assert!((cycle.around.measures.rms() / predicted - 1.0).abs() < 0.01);
        let of_law = (factor * threshold * beyond).sqrt();
        assert!((cycle.around.measures.rms() / of_law - 1.0).abs() < 0.01, "{of_law}");
    }
}

/// Hard cases: a growth rate that bends right below the threshold, and cycles whose ỹ is a thousand times that of steady sliding.
/// The fold must not depend on the steps, and no cycle may have collapsed to steady sliding, which returns to itself as well.
#[test]
fn a_fold_does_not_depend_on_the_steps_along_its_branch() {
    let contact = Contact {
        law: Law::Fitted(FittedLaw::oscillator_paper()),
        friction_load: FrictionLoad::ContactForce,
    };
    for (normal_load, velocity, known) in [(1e-5, 1.0, 0.190_577), (1e-4, 1e-2, 0.007_091)] {
        let coefficients = |shear_strength: f64| {
            Groups { normal_load, velocity, shear_strength, ..Groups::default() }.resolve()
        };
        let range = ParameterRange { from: 1e-2, to: 10.0, scale: RangeScale::Logarithmic };
        let threshold = thresholds(&contact, &range, 100, coefficients).full[0];
        // along the logarithm of the shear strength
        let at = |s: f64| Ok(StickSlip::new(contact.clone(), coefficients(threshold * s.exp()))?);
        let fold = |longest_step: f64| {
            let options = Continuation {
                shooting: shooting(&at(0.0).unwrap(), 1e-8),
                range: (-10.0, 0.0),
                steps: (0.01, longest_step),
                points: 150,
                parameter_scale: 1.0,
            };
            let margin = global_margin(&at, 0.0, -1.0, &options).unwrap();
            let branch = margin.branch.as_ref().unwrap();
            let amplitude = |k: usize| branch.points[k].cycle.around.measures.amplitude();
            assert!((0..=branch.folds[0].after).all(|k| amplitude(k) >= amplitude(0)));
            threshold * margin.fold.unwrap().exp()
        };
        let folds = [fold(4.0), fold(8.0)];
        assert!((folds[0] / folds[1] - 1.0).abs() < 1e-5, "{folds:?}");
        assert!((folds[1] / known - 1.0).abs() < 1e-4, "{folds:?}");
    }
}

/// The stable cycle of τ̃0 = 0.03 loses stability, turns at 0.0325005 and ends where it grazes the release from stick: motions beside
/// it release early and come back elsewhere.
#[test]
#[ignore = "expensive: run by make validate"]
fn the_branch_of_section_5_ends_at_a_grazing_release() {
    let at = |shear: f64| Ok(section_5(shear, FrictionLoad::NormalLoad));
    let system = section_5(0.03, FrictionLoad::NormalLoad);
    let shooting = shooting(&system, 1e-9);
    let cycle =
        from_simulation(&system, disturbed(&system), &shooting, &Patience::default(), &|| false).unwrap();
    let options = Continuation {
        shooting,
        range: (1e-3, 0.06),
        steps: (0.01, 0.1),
        points: 300,
        parameter_scale: 0.03,
    };
    let branch = continue_branch(&at, 0.03, (cycle.start, 1), 1.0, &options).unwrap();
    println!("{:?} {:?} {}", branch.folds, branch.end, branch.points.len());
    let [fold] = branch.folds[..] else { unreachable!("one fold") };
    assert!(fold.is_smooth && (fold.parameter - 0.032_500_5).abs() < 1e-6);
    let BranchEnd::Grazing { pattern, jump } = &branch.end else { unreachable!("{:?}", branch.end) };
    let sticks = |pattern: &[ContactState]| pattern.iter().filter(|s| **s == ContactState::Stick).count();
    assert!(*jump > 0.1 && sticks(pattern) > sticks(&cycle.around.pattern));
}

/// F̃_n = 1e-6, v̂ = 1e-2: stable below τ̃0 = 0.104, but a knock starts a cycle from 0.0604 on.
#[test]
fn below_a_subcritical_threshold_the_cycle_of_its_branch_ends_at_the_fold() {
    let contact = Contact {
        law: Law::Fitted(FittedLaw::oscillator_paper()),
        friction_load: FrictionLoad::ContactForce,
    };
    let coefficients = |shear_strength: f64| {
        Groups { normal_load: 1e-6, velocity: 1e-2, shear_strength, ..Groups::default() }.resolve()
    };
    let at = |shear: f64| Ok(StickSlip::new(contact.clone(), coefficients(shear))?);
    let range = ParameterRange { from: 1e-2, to: 1.0, scale: RangeScale::Logarithmic };
    let threshold = thresholds(&contact, &range, 100, coefficients).full[0];
    let options = Continuation {
        shooting: shooting(&at(threshold).unwrap(), 1e-10),
        range: (1e-3, 1.0),
        steps: (0.01, 0.5),
        points: 150,
        parameter_scale: threshold,
    };
    let margin = global_margin(&at, threshold, -1.0, &options).unwrap();
    let fold = margin.fold.unwrap();
    assert!((threshold - 0.103_99).abs() < 1e-4 && (fold - 0.0604).abs() < 1e-4, "{threshold} {fold}");
    let branch = margin.branch.unwrap();
    let (first, last) = (branch.points.first().unwrap(), branch.points.last().unwrap());
    assert!(!first.cycle.is_stable() && last.cycle.is_stable() && branch.folds[0].is_smooth);
    let simulated = |shear: f64| {
        let system: StickSlip = at(shear).unwrap();
        settle(&system, last.cycle.start, settings(&system, 1e-9), &Patience::default(), &|| false)
            .unwrap()
            .settled
    };
    // below the fold another cycle is left, of 8 oscillations, which belongs to no branch of this threshold
    assert!(!matches!(simulated(0.99 * fold), Settled::Cycle { oscillations: 1 }));
    assert_eq!(simulated(1.01 * fold), Settled::Cycle { oscillations: 1 });
}
