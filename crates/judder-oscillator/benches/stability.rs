//! What a stability decision costs: alone, in a map decided at every point, in an adaptive map; and one full analysis.
#![allow(clippy::unwrap_used, reason = "a benchmark that cannot start has nothing to report")]

#[path = "../tests/computed/mod.rs"]
mod computed;
#[path = "../tests/panels/mod.rs"]
mod panels;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use judder_oscillator::characteristic::Characteristic;
use judder_oscillator::equilibrium::equilibrium;
use judder_oscillator::linearisation::Linearisation;
use judder_oscillator::map::{OperatingPlane, adaptive, every_point};
use judder_oscillator::spectrum::eigenvalues;
use judder_oscillator::{Contact, FrictionLoad, Groups, Verdict};
use panels::{panels, paper};
use std::hint::black_box;
use std::time::Duration;

/// Both ways to decide a 1000 × 1000 map, on one thread, for every panel of Figs. 9 and 10.
fn maps(criterion: &mut Criterion) {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    for panel in panels(1000) {
        let mut group = criterion.benchmark_group(format!("{}, {}", panel.figure, panel.load_name()));
        group
            .sample_size(10)
            .warm_up_time(Duration::from_millis(500))
            .measurement_time(Duration::from_secs(2));
        group.throughput(Throughput::Elements(1_000_000));
        for (method, decide) in [("every point", false), ("adaptive", true)] {
            group.bench_function(BenchmarkId::from_parameter(method), |bencher| {
                pool.install(|| {
                    bencher.iter(|| match decide {
                        false => every_point(&panel.contact, &panel.plane),
                        true => adaptive(&panel.contact, &panel.plane),
                    });
                });
            });
        }
        group.finish();
    }
}

/// One decision without neighbours: bracket, Newton, Hurwitz.
fn decision(contact: &Contact, c: &judder_oscillator::Coefficients) -> Option<Verdict> {
    let response = equilibrium(contact, c).ok()?.response;
    let system = Linearisation::new(contact.friction_load, c, &response).system();
    Some(Characteristic::new(&system.reduced().ok()?).verdict())
}

fn single_points(criterion: &mut Criterion) {
    let panel = panels(100).swap_remove(0);
    let mut group = criterion.benchmark_group("one point at a time");
    group.throughput(Throughput::Elements(10_000));
    group.sample_size(20);
    group.bench_function("decision, 100 × 100 map of Fig. 9a", |bencher| {
        bencher.iter(|| {
            for row in 0..100 {
                for column in 0..100 {
                    black_box(decision(&panel.contact, &panel.plane.coefficients(column, row)));
                }
            }
        });
    });
    group.finish();
    let contact = paper(FrictionLoad::NormalLoad);
    criterion.bench_function("equilibrium, matrices and eigenvalues of one point", |bencher| {
        bencher.iter(|| {
            let c = black_box(Groups::default()).coefficients().unwrap();
            let e = equilibrium(&contact, &c).unwrap();
            let system = Linearisation::new(contact.friction_load, &c, &e.response).system();
            eigenvalues(&system.reduced().unwrap()).unwrap()
        });
    });
}

/// Fig. 9a decided at every point, with the printed law and with laws that are tables.
fn laws(criterion: &mut Criterion) {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let mut panel = panels(1000).swap_remove(0);
    let mut group = criterion.benchmark_group("laws, 1000 × 1000 at every point");
    group.sample_size(10).measurement_time(Duration::from_secs(2));
    let [curve, table] = computed::computed_laws();
    let printed = panel.contact.law.clone();
    for (name, law) in [("fitted", printed), ("collapsed", curve), ("tabulated", table)] {
        panel.contact.law = law;
        group.bench_function(name, |bencher| {
            pool.install(|| bencher.iter(|| every_point(&panel.contact, &panel.plane)));
        });
    }
    group.finish();
}

criterion_group!(benches, maps, laws, single_points);
criterion_main!(benches);
