//! Symmetries, balances and refusals of the contact over time.

use crate::questions::{assert_close, follow, transient};
use judder_contact::transient::{
    Before, CreepingSubstrate, CreepingTerm, IndenterPath, NormalCourse, PathCourse, TransientError, run,
};
use judder_contact::unilateral::UnilateralLimits;
use std::f64::consts::TAU;
use std::ops::ControlFlow;

fn depth(value: f64) -> NormalCourse {
    NormalCourse::Indentation(PathCourse::Constant(value))
}

/// Work = energy stored + energy dissipated; the last two know the pressures in the substrate only.
#[test]
fn the_work_of_a_reciprocating_indenter_is_stored_or_dissipated() {
    let substrate = CreepingSubstrate::single(10.0, 1.0);
    let path = IndenterPath::reciprocation(0.5, TAU, depth(1.0));
    let mut question = transient(&substrate, &path, 2.0, 24);
    question.before = Before::Settled;
    question.energy = true;
    question.steps.cells_a_step = 0.5;
    let history = follow(&question);
    let (first, last) = (history.samples[0].energy.unwrap(), history.last().unwrap());
    let energy = last.energy.unwrap();
    assert_close(last.work(), energy.stored - first.stored + energy.dissipated, 1e-2);
    assert!(last.sliding_work > 0.1 && last.normal_work == 0.0);
    assert_eq!(history.work_by_period(1.0).len(), 2);
}

/// The way back is the way forth, mirrored.
#[test]
fn a_mirrored_path_has_mirrored_friction() {
    let substrate = CreepingSubstrate::single(10.0, 1.0);
    let histories = [0.8, -0.8].map(|speed| {
        let path = IndenterPath::start_of_sliding(speed, 0.3, depth(1.0));
        let mut question = transient(&substrate, &path, 1.0, 20);
        question.limits = UnilateralLimits { tolerance: 1e-8, ..UnilateralLimits::default() };
        follow(&question)
    });
    let [right, left] = histories.each_ref().map(|history| *history.last().unwrap());
    assert_close(left.force, right.force, 1e-6);
    assert_close(left.friction_force, -right.friction_force, 1e-6);
}

/// The depth that a force finds makes that force.
#[test]
fn an_imposed_force_and_the_depth_that_it_finds_are_one_contact() {
    let substrate = CreepingSubstrate::single(10.0, 1.0);
    let position = PathCourse::Start { speed: 0.5, ramp: 0.2 };
    let pressed =
        IndenterPath { position: position.clone(), normal: NormalCourse::Load(PathCourse::Constant(1.0)) };
    let mut question = transient(&substrate, &pressed, 1.0, 24);
    question.before = Before::Settled;
    question.grid.half_width = Some(1.4);
    let pressed = follow(&question);
    let samples = &pressed.samples;
    let times = samples.iter().map(|sample| sample.time).collect();
    let values = samples.iter().map(|sample| sample.indentation).collect();
    let indented =
        IndenterPath { position, normal: NormalCourse::Indentation(PathCourse::Sampled { times, values }) };
    question.path = &indented;
    let indented = follow(&question);
    for wanted in samples {
        let found = indented.samples.iter().find(|sample| sample.time == wanted.time).unwrap();
        assert_close(found.force, 1.0, 5e-3);
        assert!((found.friction_force - wanted.friction_force).abs() < 1e-3);
    }
}

/// Two equal retardation times of half the strength are one, and the same question has the same answer.
#[test]
fn two_equal_terms_are_one() {
    let half = CreepingTerm { compliance: 0.45, time: 1.0 };
    let substrates = [
        CreepingSubstrate::single(10.0, 1.0),
        CreepingSubstrate { instantaneous: 0.1, terms: vec![half, half] },
    ];
    let path = IndenterPath::start_of_sliding(1.0, 0.0, depth(1.0));
    let [one, two] = substrates.each_ref().map(|substrate| follow(&transient(substrate, &path, 0.5, 16)));
    assert_close(two.last().unwrap().force, one.last().unwrap().force, 1e-5);
    assert_eq!(follow(&transient(&substrates[0], &path, 0.5, 16)), one);
}

/// A lifted indenter feels nothing; where it comes back the surface has not yet recovered.
#[test]
fn a_lifted_indenter_returns_to_a_dent() {
    let substrate = CreepingSubstrate::single(10.0, 1.0);
    let times = vec![0.0, 0.01, 0.1, 0.11];
    let lifted = PathCourse::Sampled { times, values: vec![1.0, -0.2, -0.2, 0.5] };
    let path = IndenterPath::at_rest(NormalCourse::Indentation(lifted));
    let mut question = transient(&substrate, &path, 0.11, 24);
    question.before = Before::Settled;
    question.fields_at = &[0.05];
    let history = follow(&question);
    let away: Vec<_> = history.samples.iter().filter(|sample| sample.indentation < 0.0).collect();
    assert!(away.len() > 2 && away.iter().all(|sample| sample.force == 0.0 && sample.area == 0.0));
    assert!(history.fields[0].gap.iter().all(|gap| *gap > 0.2));
    // Glass would press back with 10 · 4/3 · 0.5^1.5 = 4.7.
    let back = history.last().unwrap();
    assert!(back.force < 1.0, "{back:?}");
}

/// The strip is shorter than the path; that it forgets makes no difference.
#[test]
fn what_has_faded_is_forgotten_without_a_trace() {
    let substrate = CreepingSubstrate::single(10.0, 1.0);
    let path = IndenterPath::start_of_sliding(0.5, 0.0, depth(1.0));
    let mut question = transient(&substrate, &path, 22.0, 16);
    question.before = Before::Settled;
    question.limits = UnilateralLimits { tolerance: 1e-7, ..UnilateralLimits::default() };
    let history = follow(&question);
    assert!(history.strip[0] as f64 * history.cell < 0.9 * history.last().unwrap().position);
    // Means over the passage of two cells.
    let passage = 4.0 * history.cell;
    let mean = |from: f64| history.mean(from, from + passage, |sample| sample.friction_force);
    assert_close(mean(20.0), mean(20.0 - 10.0 * passage), 1e-3);
}

#[test]
fn what_cannot_be_computed_is_refused_with_the_reason() {
    let substrate = CreepingSubstrate::single(10.0, 1.0);
    let refused = |substrate: &CreepingSubstrate, path: &IndenterPath, memory_limit: u64| {
        let mut question = transient(substrate, path, 1.0, 16);
        question.grid.memory_limit = memory_limit;
        question.grid.half_width = Some(0.5);
        run(&question, &mut |_| ControlFlow::Continue(())).unwrap_err()
    };
    let resting = IndenterPath::at_rest(depth(1.0));
    let error = refused(&substrate, &resting, 1 << 30);
    assert!(matches!(error, TransientError::WindowTooSmall { needed, .. } if needed > 0.5), "{error}");
    let error = refused(&substrate, &resting, 1000);
    assert!(
        matches!(error, TransientError::Memory { needed, allowed: 1000, .. } if needed > 1000),
        "{error}"
    );
    let error = refused(&substrate, &IndenterPath::at_rest(depth(-1.0)), 1 << 30);
    assert_eq!(error, TransientError::NeverTouches { what: "indentation", value: -1.0 });
    let error = refused(&CreepingSubstrate::single(10.0, -1.0), &resting, 1 << 30);
    assert_eq!(error, TransientError::NotPositive { what: "retardation time", value: -1.0 });
    let error = refused(&substrate, &IndenterPath::at_rest(depth(f64::NAN)), 1 << 30);
    assert!(matches!(error, TransientError::NotFinite { .. }), "{error}");
    let error = refused(&substrate, &IndenterPath::reciprocation(1e-9, 1e12, depth(1.0)), 1 << 30);
    assert!(matches!(error, TransientError::TooManySteps { needed, .. } if needed > 1e12), "{error}");
    let error = refused(&substrate, &IndenterPath::start_of_sliding(1.0, f64::NAN, depth(1.0)), 1 << 30);
    assert!(matches!(error, TransientError::NotPositive { what: "time of the start", .. }), "{error}");
}

#[test]
fn a_run_that_is_stopped_keeps_what_it_has() {
    let substrate = CreepingSubstrate::single(10.0, 1.0);
    let path = IndenterPath::at_rest(depth(1.0));
    let question = transient(&substrate, &path, 1.0, 16);
    let stop = &mut |sample: &judder_contact::transient::TransientSample| {
        if sample.time > 0.01 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let history = run(&question, stop).unwrap();
    assert!(!history.completed && history.samples.len() > 1 && history.last().unwrap().time < 0.5);
}
