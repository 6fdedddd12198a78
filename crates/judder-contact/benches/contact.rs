//! What the contact computation costs on one thread: kernels, operators, products.
#![allow(clippy::unwrap_used, reason = "a benchmark that cannot go on has failed")]

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use judder_contact::kernel::sliding::SlidingOperator;
use judder_contact::kernel::substrate::SlidingSubstrate;
use judder_contact::kernel::wake::WakeKernel;
use judder_contact::surface::grid::SurfaceGrid;
use judder_contact::surface::operator::SurfaceOperator;
use std::hint::black_box;
use std::time::Duration;

const SIDES: [usize; 3] = [256, 512, 1024];

/// The substrate of a contact of radius 1 at the speed where it drags most.
fn substrate() -> SlidingSubstrate {
    SlidingSubstrate::single(10.0, 1.0)
}

fn grid(side: usize) -> SurfaceGrid {
    SurfaceGrid::square(side, [0.0, 0.0], 1.3)
}

/// The kernel at all differences of two cells, and the operator made of it.
fn making(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("making");
    group.sample_size(10).warm_up_time(Duration::from_millis(200)).measurement_time(Duration::from_secs(1));
    for side in SIDES {
        let in_cells = substrate().in_cells(grid(side).cell);
        group.bench_function(BenchmarkId::new("kernel", side), |bencher| {
            bencher.iter(|| WakeKernel::new(side, side, 0.3, black_box(&in_cells)));
        });
        group.bench_function(BenchmarkId::new("operator", side), |bencher| {
            bencher.iter(|| SlidingOperator::new(grid(side), black_box(&substrate()), u64::MAX).unwrap());
        });
    }
    group.finish();
}

/// A product with the operator, and one with its approximate inverse.
fn products(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("product");
    group.sample_size(20).warm_up_time(Duration::from_millis(200)).measurement_time(Duration::from_secs(1));
    for side in SIDES {
        let mut operator = SlidingOperator::new(grid(side), &substrate(), u64::MAX).unwrap();
        let pressure: Vec<f64> = (0..side * side).map(|cell| (cell % 17) as f64).collect();
        let mut displacement = vec![0.0; pressure.len()];
        group.bench_function(BenchmarkId::new("displacement", side), |bencher| {
            bencher.iter(|| operator.displacement(black_box(&pressure), &mut displacement));
        });
        group.bench_function(BenchmarkId::new("precondition", side), |bencher| {
            bencher.iter(|| operator.precondition(black_box(&pressure), &mut displacement));
        });
    }
    group.finish();
}

criterion_group!(benches, making, products);
criterion_main!(benches);
