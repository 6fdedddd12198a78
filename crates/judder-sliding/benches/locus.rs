//! The locus of the beams paper's pair at 1000 positions with located zones, and one position beside the full matrices.
//!
//! Threads as `RAYON_NUM_THREADS` has it.
#![allow(clippy::unwrap_used, reason = "a benchmark that cannot go on has failed")]

#[path = "../tests/common/mod.rs"]
mod common;

use criterion::{Criterion, criterion_group, criterion_main};
use judder_sliding::dense_forms::ThreeField;
use judder_sliding::locus::{Conditions, Configuration, LocusSettings, contact, locus, spectrum};
use judder_sliding::spectrum::WantedEigenvalues;
use std::hint::black_box;
use std::time::Duration;

const COUNT: usize = 20;
/// Where the full matrices are shifted to, 1/s.
const SHIFT: f64 = 2e4;

fn whole(criterion: &mut Criterion) {
    let pair = common::pair();
    let mut group = criterion.benchmark_group("locus");
    group.sample_size(10).warm_up_time(Duration::from_millis(500)).measurement_time(Duration::from_secs(8));
    let conditions = |configuration| Conditions {
        configuration,
        is_damped: true,
        velocity: common::SPEED,
        load: common::LOAD,
    };
    let positions: Vec<f64> = (0..1000).map(|k| 0.010 + 0.0885 * f64::from(k) / 999.0).collect();
    for configuration in [Configuration::Undeformed, Configuration::Deformed] {
        let conditions = conditions(configuration);
        let settings = LocusSettings { conditions, count: COUNT, positions: positions.clone() };
        group.bench_function(format!("1000 positions, {configuration:?}"), |bencher| {
            bencher.iter(|| black_box(locus(&pair, &settings).unwrap()));
        });
        group.bench_function(format!("one position, {configuration:?}"), |bencher| {
            let wanted = WantedEigenvalues::Lowest(COUNT);
            bencher.iter(|| black_box(spectrum(&pair, &conditions, 0.0742, wanted).unwrap()));
        });
    }
    let conditions = conditions(Configuration::Deformed);
    group.bench_function("one position, full matrices, Deformed", |bencher| {
        bencher.iter(|| {
            let (coupling, _) = contact(&pair, &conditions, 0.0742).unwrap();
            let fields = ThreeField::new(&coupling, &pair.eigenvalues(), &pair.damping()).unwrap();
            black_box(fields.primal_spectrum(SHIFT).unwrap())
        });
    });
    group.finish();
}

criterion_group!(benches, whole);
criterion_main!(benches);
