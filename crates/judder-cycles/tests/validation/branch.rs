//! Cycles along the friction coefficient.

use super::belt::{FALLING, slow_mass_on_belt};
use super::own_engine::shooting;
use crate::common::block::block_held;
use crate::growing;
use faer::c64;
use judder_assembly::assembly::Assembly;
use judder_assembly::compliance::Compliance;
use judder_assembly::friction::{FallingFriction, Friction};
use judder_assembly::interface::InterfaceLaw;
use judder_assembly::linearised::{Linearised, LinearisedTerms};
use judder_assembly::pressure::Pressure;
use judder_assembly::steady::steady_sliding;
use judder_cycles::CyclesError;
use judder_cycles::balance::HarmonicBalance;
use judder_cycles::branch::{AssemblyCycleBranch, BranchSettings, CycleBranchEnd, cycle_branch};
use judder_cycles::cycle::{CycleSettings, HarmonicCount, limit_cycles};
use judder_cycles::fold::refined_fold;
use judder_cycles::path::PathRule;
use judder_oscillator::cycle::{Continuation, global_margin};
use judder_oscillator::motion::BeltOscillator;
use judder_structure::complex_modes::{ComplexModeSettings, Region, complex_modes};

fn with_friction(coefficient: f64) -> Assembly {
    let law = InterfaceLaw::Compliant(Pressure::Stiffness(1e11), Friction::Constant(coefficient));
    block_held(law, 1.0, [100.0, 5e-8])
}

/// The eigenvalue of a block near an angular frequency in rad/s.
fn eigenvalue(coefficient: f64, near: f64) -> c64 {
    let case = with_friction(coefficient);
    let steady = steady_sliding(&case, &Compliance::new(&case).unwrap()).unwrap();
    let about = Linearised::new(&case, &steady, LinearisedTerms::default()).unwrap();
    let region = Region { re: [-1e4, 1e4], im: [0.95 * near, 1.05 * near] };
    let found = complex_modes(&about.problem, &region, &ComplexModeSettings::default()).unwrap();
    let value = found.modes.iter().map(|mode| mode.eigenvalue.value).max_by(|a, b| a.re.total_cmp(&b.re));
    value.map(|value| c64::new(value.re, value.im)).unwrap()
}

/// With less and less friction the cycle shrinks to steady sliding, where the eigenvalue ceases to grow; the frequency there is the eigenvalue's.
#[test]
fn a_cycle_shrinks_to_steady_sliding_where_the_eigenvalue_ceases_to_grow() {
    let case = with_friction(0.3);
    let (steady, values) = growing(&case, [1e3, 6e5]);
    let settings = CycleSettings { harmonics: HarmonicCount::Fixed(9), ..CycleSettings::default() };
    let found = limit_cycles(&case, &steady, values[0], &settings, &|| true).unwrap();
    let cycle = &found.cycles[0];
    let settings = BranchSettings {
        rule: PathRule { steps: [0.02, 0.2, 1e-6], ..PathRule::default() },
        range: [0.0, 0.5],
        unit: 0.3,
        rises: false,
        points: 100,
    };
    let at = |coefficient: f64| Ok(with_friction(coefficient));
    let branch = cycle_branch(&at, &cycle.balance, (0.3, &cycle.motion), &settings, &|| true).unwrap();
    assert_eq!(branch.end, CycleBranchEnd::SteadySliding);
    assert!(branch.folds.is_empty() && branch.branch_points.is_empty() && branch.cycles.len() > 5);
    let last = branch.cycles.last().unwrap();
    let value = eigenvalue(last.parameter, last.motion.turning.frequency);
    assert!((value.im / last.motion.turning.frequency - 1.0).abs() < 1e-6, "{value} {last:?}");
    assert!(value.re.abs() < 1e-6 * value.im, "{value}");
    // the same equations at the first value
    assert!((branch.cycles[0].motion.turning.frequency / cycle.frequency() - 1.0).abs() < 1e-9);
}

/// What an assembly cannot be built of ends the branch with its reason.
#[test]
fn a_branch_tells_where_no_assembly_is() {
    let case = with_friction(0.3);
    let (steady, values) = growing(&case, [1e3, 6e5]);
    let settings = CycleSettings { harmonics: HarmonicCount::Fixed(3), ..CycleSettings::default() };
    let found = limit_cycles(&case, &steady, values[0], &settings, &|| true).unwrap();
    let at = |value: f64| match value > 0.28 {
        true => Ok(with_friction(value)),
        false => Err(CyclesError::NoAssembly { value, reason: "too little".to_owned() }),
    };
    let rule = PathRule { steps: [0.02, 0.2, 1e-4], ..PathRule::default() };
    let settings = BranchSettings { rule, range: [0.0, 0.5], unit: 0.3, rises: false, points: 100 };
    let cycle = &found.cycles[0];
    let branch = cycle_branch(&at, &cycle.balance, (0.3, &cycle.motion), &settings, &|| true).unwrap();
    assert!(matches!(branch.end, CycleBranchEnd::Lost(CyclesError::NoAssembly { .. })), "{:?}", branch.end);
    assert!(branch.cycles.last().unwrap().parameter < 0.282);
}

/// The smallest value at which a branch turns, and what it is told to be off.
fn least_fold<F: Fn(f64) -> Result<Assembly, CyclesError>>(
    at: &F,
    balance: &HarmonicBalance<'_>,
    branch: &AssemblyCycleBranch,
    settings: &BranchSettings,
) -> [f64; 2] {
    let folds = branch.folds.iter().enumerate();
    let (place, (own, fold)) = folds.min_by(|a, b| a.1.1.total_cmp(&b.1.1)).unwrap();
    let around = [own - 1, *own, own + 1].map(|k| &branch.cycles[k]);
    let refined = refined_fold(at, balance, around, settings, &|| true).unwrap();
    [*fold, branch.fold_error(place, refined)]
}

/// The stick-slip cycles of a mass on a belt turn where the mass that leaves the belt just comes back to it, which the engine of the oscillator knows; what the fold of
/// harmonics is told to be off holds that, of two masses. Along −v the largest speed is the smallest value.
#[test]
fn the_fold_of_a_mass_on_a_belt_is_known_to_what_twice_the_harmonics_say() {
    let literature = FallingFriction::exponential([1.0, 0.5], 0.5);
    for (damping, falling) in [(0.025, FALLING), (0.05, literature)] {
        let engine = |speed: f64| BeltOscillator::new(damping, 1.0, speed, falling).unwrap();
        let slope = (falling.at_rest - falling.at_speed) / falling.decay_speed;
        let onset = falling.decay_speed * (slope / (2.0 * damping)).ln();
        let options = Continuation {
            shooting: shooting(&engine(onset)),
            range: (0.5, 2.5),
            steps: (0.01, 0.1),
            points: 200,
            parameter_scale: 1.0,
        };
        let margin = global_margin(&|speed: f64| Ok(engine(speed)), onset, 1.0, &options).unwrap();
        let expected = margin.fold.unwrap();
        let at = |value: f64| Ok(slow_mass_on_belt([2.0 * damping, -value], falling));
        let begin = -0.85 * onset;
        let case = at(begin).unwrap();
        let (steady, values) = growing(&case, [0.5, 2.0]);
        for harmonics in [9, 13, 25] {
            let settings =
                CycleSettings { harmonics: HarmonicCount::Fixed(harmonics), ..CycleSettings::default() };
            let found = limit_cycles(&case, &steady, values[0], &settings, &|| true).unwrap();
            let cycle = &found.cycles[0];
            let rule = PathRule { steps: [0.01, 0.05, 1e-7], tolerance: 1e-8, ..PathRule::default() };
            let settings = BranchSettings { rule, range: [-2.5, -0.5], unit: 1.5, rises: false, points: 400 };
            let branch =
                cycle_branch(&at, &cycle.balance, (begin, &cycle.motion), &settings, &|| true).unwrap();
            let [fold, error] = least_fold(&at, &cycle.balance, &branch, &settings);
            println!("{harmonics}: {:.5} ± {error:.5}, off by {:.5}", -fold, -fold - expected);
            assert!(
                (fold + expected).abs() < error && error < 0.02,
                "{harmonics}: {fold} {error} {expected}"
            );
        }
    }
}

/// The equations of few harmonics have kinks near the fold, where single instants come to stick; beyond them the branch goes on to where its cycles vanish, at the onset of
/// linear analysis, in place of back over the cycles that it came by.
#[test]
fn a_branch_does_not_come_back_over_its_own_cycles_at_kinks_of_few_harmonics() {
    let damping = 0.025;
    let slope = (FALLING.at_rest - FALLING.at_speed) / FALLING.decay_speed;
    let onset = FALLING.decay_speed * (slope / (2.0 * damping)).ln();
    let at = |value: f64| Ok(slow_mass_on_belt([2.0 * damping, -value], FALLING));
    for (begin, harmonics) in [(-0.9, 3), (-0.9, 7), (-0.95, 10)] {
        let case = at(begin).unwrap();
        let (steady, values) = growing(&case, [0.5, 2.0]);
        let settings =
            CycleSettings { harmonics: HarmonicCount::Fixed(harmonics), ..CycleSettings::default() };
        let found = limit_cycles(&case, &steady, values[0], &settings, &|| true).unwrap();
        let cycle = &found.cycles[0];
        let rule = PathRule { steps: [0.02, 0.1, 1e-7], tolerance: 1e-8, ..PathRule::default() };
        let settings = BranchSettings { rule, range: [-1.6, -0.7], unit: 0.9, rises: false, points: 400 };
        let branch = cycle_branch(&at, &cycle.balance, (begin, &cycle.motion), &settings, &|| true).unwrap();
        println!("{harmonics}: {:?} of {onset}, {:?}", branch.vanishes_at(), branch.branch_points);
        assert_eq!((branch.end.clone(), branch.branch_points.len()), (CycleBranchEnd::SteadySliding, 0));
        assert!((branch.vanishes_at().unwrap() + onset).abs() < 1e-3 * onset, "{harmonics}");
    }
}
