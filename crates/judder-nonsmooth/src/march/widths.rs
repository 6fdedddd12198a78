//! The same march with vectors of every width that the machine has.

use super::{NonsmoothMarch, NonsmoothSettings};
use crate::gauss_seidel::ContactAccuracy;
use crate::scheme::ContactScheme;
use faer::sparse::Triplet;
use judder_assembly::assembly::{Assembly, from_triplets};
use judder_assembly::contact_point::ContactPoint;
use judder_assembly::friction::Friction;
use judder_assembly::interface::{Interface, InterfaceLaw};
use judder_assembly::row::Row;
use judder_numerics::counter::uniform;
use pulp::Arch;
use std::sync::Arc;

/// Modes and points, no multiples of a vector.
const MODES: usize = 37;
const POINTS: usize = 7;

/// A slider in modes whose rows are drawn, on a plane.
fn slider(dimension: usize) -> Assembly {
    let drawn = |stream: u64, k: usize| 2.0 * uniform(stream, k as u64) - 1.0;
    let omega = |mode: usize| 1e3 * (1.3 + mode as f64);
    let diagonal = |of: &dyn Fn(usize) -> f64| {
        let entries: Vec<_> = (0..MODES).map(|mode| Triplet::new(mode, mode, of(mode))).collect();
        Arc::new(from_triplets(MODES, MODES, &entries).unwrap())
    };
    let point = |point: usize| {
        let row =
            |k: usize| Row::new((0..MODES).map(|mode| (mode, drawn((3 * point + k) as u64, mode))).collect());
        ContactPoint {
            place: [0.0; 3],
            normal: [0.0, 1.0, 0.0],
            velocity: [0.02, 0.0, 0.0],
            rest_direction: None,
            area: 1.0,
            gap: 0.0,
            relative: [row(0), row(1), if dimension == 3 { row(2) } else { Row::default() }],
            convected: None,
            foot: None,
        }
    };
    let points: Vec<_> = (0..POINTS).map(point).collect();
    let mut load = vec![0.0; MODES];
    points.iter().for_each(|point| point.relative[1].add_to(-50.0, &mut load));
    let law = InterfaceLaw::Rigid(Friction::Constant(0.8));
    Assembly {
        mass: diagonal(&|_| 1.0),
        damping: diagonal(&|mode| 0.004 * omega(mode)),
        stiffness: diagonal(&|mode| omega(mode).powi(2)),
        gyroscopic: Vec::new(),
        load,
        interfaces: vec![Interface { name: "sole".to_owned(), points, law, all_closed: false }],
    }
}

/// The bits of the forces and velocities of all points in every step.
fn told(case: &Assembly, scheme: ContactScheme, arch: Arch) -> Vec<u64> {
    let settings =
        NonsmoothSettings { scheme, step: 5e-6, accuracy: ContactAccuracy::default(), cut_off: None };
    let mut march = NonsmoothMarch::new(case, &[], settings).unwrap();
    march.set_arch(arch);
    march.set_force_scale(50.0);
    let mut bits = Vec::new();
    for _ in 0..3000 {
        march.advance().unwrap();
        for point in 0..POINTS {
            bits.extend([march.force(point), march.velocity(point)].concat().into_iter().map(f64::to_bits));
        }
    }
    bits
}

/// By both schemes, in the plane and in space: not a bit of any step depends on the width of the vectors.
#[test]
fn no_bit_depends_on_the_width_of_the_vectors() {
    let mut widths = vec![Arch::new()];
    #[cfg(target_arch = "x86_64")]
    {
        widths.extend(pulp::x86::V3::try_new().map(Arch::V3));
        widths.extend(pulp::x86::V4::try_new().map(Arch::V4));
    }
    for dimension in [2, 3] {
        let case = slider(dimension);
        for scheme in [
            ContactScheme::MoreauJean { restitution: 0.0, implicitness: 0.5 },
            ContactScheme::ForwardIncrement,
            ContactScheme::Smoothed,
        ] {
            let scalar = told(&case, scheme, Arch::Scalar);
            for arch in &widths {
                assert!(told(&case, scheme, *arch) == scalar, "{dimension} {scheme:?} {arch:?}");
            }
        }
    }
}
