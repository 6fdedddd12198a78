//! Steps of the marches beside a dense step of the same size, on the pair of the beams paper.
//!
//! The floor: a step reads the modes' state and six rows and writes the state, about 5 kflop.
#![allow(clippy::unwrap_used, missing_docs, reason = "a benchmark")]
#[path = "../tests/common/mod.rs"]
mod common;

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, Throughput, criterion_group, criterion_main};
use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, Par};
use judder_numerics::signal::Decimation;
use judder_sliding::march::{ContactMethod, March, MarchSample, MarchSettings, Predictor};
use judder_sliding::motion::{Motion, Ramps};
use judder_sliding::pair::Pair;
use judder_sliding::recorder::{Channel, Recorder};
use std::hint::black_box;

const STEPS: u64 = 10_000;

fn steps(criterion: &mut Criterion) {
    let pair = common::pair();
    let motion = Motion {
        start: 0.02,
        end: 0.0985,
        ramps: Ramps::default(),
        initial_damping: None,
        ..common::motion()
    };
    let mut group = criterion.benchmark_group("step of 243 modes");
    group.throughput(Throughput::Elements(STEPS)).sample_size(30);
    let methods = [
        ("subs", ContactMethod::Subs { static_slope: false }, 3e-7),
        ("ensubs", ContactMethod::EnSubs, 3e-7),
        ("film", ContactMethod::Film, 3e-7),
        ("residual-flexibility", ContactMethod::ResidualFlexibility { cut_off: 60e3 }, 3e-6),
    ];
    for (name, method, step) in methods {
        let settings = MarchSettings { method, predictor: Predictor::WithForce, step, motion };
        let start = March::new(&pair, settings).unwrap();
        let mut march = start.clone();
        group.bench_function(name, |bencher| {
            bencher.iter(|| {
                let mut sum = 0.0;
                if march.steps() + STEPS > march.all_steps() {
                    march = start.clone();
                }
                march
                    .advance(STEPS, &mut |sample: &MarchSample, a: &[f64]| sum += sample.normal_force + a[0])
                    .unwrap();
                black_box(sum)
            });
        });
    }
    recorded(&mut group, &pair, motion);
    let size = pair.modes();
    let stiffness = Mat::from_fn(size, size, |i, j| 1.0 / (1 + i + j) as f64);
    let (mut now, mut before) = (Mat::from_fn(size, 1, |i, _| 1e-9 * i as f64), Mat::<f64>::zeros(size, 1));
    let mut next = Mat::<f64>::zeros(size, 1);
    // the predictor alone, u* = 2u − u₋ − h² M⁻¹K u with a dense M⁻¹K, of a hundredth of the steps
    group.throughput(Throughput::Elements(STEPS / 100));
    group.bench_function("dense predictor (peer)", |bencher| {
        bencher.iter(|| {
            for _ in 0..STEPS / 100 {
                matmul(next.as_mut(), Accum::Replace, stiffness.as_ref(), now.as_ref(), -1e-14, Par::Seq);
                for i in 0..size {
                    next[(i, 0)] += 2.0 * now[(i, 0)] - before[(i, 0)];
                }
                std::mem::swap(&mut before, &mut now);
                std::mem::swap(&mut now, &mut next);
            }
            black_box(now[(0, 0)])
        });
    });
    group.finish();
}

/// EnSubs with what a study keeps of it, low-passed at 50 kHz and decimated to 400 kHz.
fn recorded(group: &mut BenchmarkGroup<'_, WallTime>, pair: &Pair, motion: Motion) {
    let settings =
        MarchSettings { method: ContactMethod::EnSubs, predictor: Predictor::WithForce, step: 3e-7, motion };
    let channels = [
        Channel::Acceleration(0),
        Channel::Velocity(0),
        Channel::NormalForce,
        Channel::TangentialForce,
        Channel::SlidingVelocity,
    ];
    let decimation = Decimation::new(1.0 / settings.step, 50e3, 8);
    let (start, empty) =
        (March::new(pair, settings).unwrap(), Recorder::new(pair, &motion, &channels, &decimation).unwrap());
    let (mut march, mut recorder) = (start.clone(), empty.clone());
    group.bench_function("ensubs, five signals recorded", |bencher| {
        bencher.iter(|| {
            if march.steps() + STEPS > march.all_steps() {
                (march, recorder) = (start.clone(), empty.clone());
            }
            march.advance(STEPS, &mut recorder).unwrap();
            recorder.clear();
        });
    });
}

criterion_group!(benches, steps);
criterion_main!(benches);
