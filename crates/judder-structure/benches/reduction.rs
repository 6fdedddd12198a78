//! What the reduction of the beams of the beams paper costs, with its error bounds.
#![allow(clippy::unwrap_used, reason = "a benchmark that cannot go on has failed")]

use criterion::{Criterion, criterion_group, criterion_main};
use judder_structure::assembly::{Assembled, assemble};
use judder_structure::beam::Beam;
use judder_structure::craig_bampton::{CraigBampton, CutOff};
use judder_structure::freedom::{Direction, Numbering, Supports};
use judder_structure::material::{Elastic, ElementSection};
use std::f64::consts::FRAC_PI_6;
use std::hint::black_box;
use std::time::Duration;

/// A beam of Tables 1 and 2, held at its start.
fn beam(beam: Beam, width: f64, material: Elastic, kept: &str) -> (Assembled, Vec<usize>) {
    let mesh = beam.mesh("any").unwrap();
    let plane = [Direction::X, Direction::Y];
    let fixed = mesh.node_sets["start"].iter().flat_map(|node| plane.map(|d| (*node, d))).collect();
    let numbering = Numbering::new(&mesh, 2, &Supports { fixed, ..Supports::default() }).unwrap();
    let materials = [("any".to_owned(), (material, ElementSection::PlaneStress { thickness: width }))].into();
    let kept = mesh.node_sets[kept].iter().flat_map(|node| plane.map(|d| numbering.number(*node, d)));
    (assemble(&mesh, &materials, &numbering).unwrap(), kept.flatten().collect())
}

fn reduction(criterion: &mut Criterion) {
    let horizontal = Beam { length: 0.1, thickness: 0.002, elements: [100, 2], origin: [0.0; 2], angle: 0.0 };
    let oblique =
        Beam { length: 0.075, thickness: 0.0015, elements: [75, 2], origin: [0.0; 2], angle: FRAC_PI_6 };
    let rubber = Elastic::new(2.38e9, 0.4, 1200.0).unwrap();
    let aluminium = Elastic::new(71e9, 0.33, 2770.0).unwrap();
    let beams = [beam(horizontal, 0.02, rubber, "upper-corners"), beam(oblique, 0.01, aluminium, "end")];
    let mut group = criterion.benchmark_group("reduction");
    group.sample_size(10).warm_up_time(Duration::from_millis(500)).measurement_time(Duration::from_secs(5));
    let reduced = || {
        beams.each_ref().map(|(structure, kept)| {
            let cut_off = CutOff::Count(20);
            CraigBampton::new(&structure.stiffness, &structure.mass, kept, cut_off).unwrap()
        })
    };
    group.bench_function("both beams", |bencher| bencher.iter(|| black_box(reduced())));
    let made = reduced();
    group.bench_function("limits of both", |bencher| {
        bencher.iter(|| made.each_ref().map(|reduced| reduced.error().unwrap().limit_hz(1e-4)));
    });
    group.finish();
}

criterion_group!(benches, reduction);
criterion_main!(benches);
