//! What motion costs: one period of the stick-slip cycle of section 5, its return map with derivatives, Newton's method, a branch.
#![allow(clippy::unwrap_used, reason = "a benchmark that cannot start has nothing to report")]

use criterion::{Criterion, criterion_group, criterion_main};
use judder_contact::{FittedLaw, Law};
use judder_numerics::piecewise::StepSettings;
use judder_oscillator::cycle::return_map::returned_state;
use judder_oscillator::cycle::shooting::{Shooting, from_simulation, shoot};
use judder_oscillator::cycle::{Continuation, CycleError, continue_branch, return_map};
use judder_oscillator::motion::attractor::Patience;
use judder_oscillator::motion::{SlidingSystem, StickSlip};
use judder_oscillator::{Contact, FrictionLoad, Groups};

const SHEAR_STRENGTH: f64 = 0.03;

fn section_5(shear_strength: f64) -> Result<StickSlip, CycleError> {
    let contact = Contact {
        law: Law::Fitted(FittedLaw::oscillator_paper()),
        friction_load: FrictionLoad::ContactForce,
    };
    let groups = Groups { normal_load: 7.5e-4, velocity: 4e-4, shear_strength, ..Groups::default() };
    Ok(StickSlip::new(contact, groups.resolve())?)
}

fn shooting(system: &StickSlip, tolerance: f64) -> Shooting<4> {
    let absolute = system.scales().map(|scale| tolerance * scale);
    let settings = StepSettings { relative: tolerance, absolute, longest_step: 1.0, steps: 10_000_000 };
    Shooting { settings, tolerance: 100.0 * tolerance, iterations: 20, longest: 1000.0 }
}

fn cycles(criterion: &mut Criterion) {
    let system = section_5(SHEAR_STRENGTH).unwrap();
    let shooting = shooting(&system, 1e-8);
    let mut start = system.steady_sliding();
    start[0] *= 1.2;
    let cycle = from_simulation(&system, start, &shooting, &Patience::default(), &|| false).unwrap();
    let beside = cycle.start.map(|u| u * (1.0 + 1e-4));
    let mut group = criterion.benchmark_group("the cycle of section 5, tolerance 1e-8");
    group.sample_size(20);
    group.bench_function("one period", |bencher| {
        bencher.iter(|| returned_state(&system, cycle.start, 1, shooting.settings, 1000.0).unwrap());
    });
    group.bench_function("one period with its monodromy", |bencher| {
        bencher.iter(|| return_map(&system, cycle.start, 1, shooting.settings, 1000.0).unwrap());
    });
    group.bench_function("Newton's method from 1e-4 beside it", |bencher| {
        bencher.iter(|| shoot(&system, beside, 1, &shooting).unwrap());
    });
    group.finish();
    let options = Continuation {
        shooting,
        range: (0.02, 0.04),
        steps: (0.05, 0.5),
        points: 10,
        parameter_scale: SHEAR_STRENGTH,
    };
    let mut group = criterion.benchmark_group("a branch");
    group.sample_size(10);
    group.bench_function("10 cycles", |bencher| {
        bencher
            .iter(|| continue_branch(&section_5, SHEAR_STRENGTH, (cycle.start, 1), -1.0, &options).unwrap());
    });
    group.finish();
}

criterion_group!(benches, cycles);
criterion_main!(benches);
