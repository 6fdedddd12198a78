//! The same march with vectors of every width that the machine has.

use super::{ContactMethod, March, MarchSample, MarchSettings, Predictor};
use crate::body::{Body, ModalPoint};
use crate::edge::Interpolation;
use crate::motion::{Motion, Noise, Ramps};
use crate::pair::{Observed, Pair, PairSide, Slider, TrackBody};
use crate::vectors::widths;
use judder_contact::friction::Friction;
use judder_numerics::counter::uniform;
use pulp::Arch;

/// Thirteen modes against thirty-seven, neither a multiple of a chunk, with rows that are drawn.
fn pair(interpolation: Interpolation) -> Pair {
    let drawn = |stream: u64, k: usize| 2.0 * uniform(29 + stream, k as u64) - 1.0;
    let row = |stream: u64, modes: usize| (0..modes).map(|k| 3.0 * drawn(stream, k)).collect::<Vec<f64>>();
    let body = |modes: usize| Body {
        eigenvalues: (0..modes).map(|k| (1e3 * (1.3 + k as f64)).powi(2)).collect(),
        alpha: 20.0,
        beta: 1e-6,
    };
    let point = |place: f64, stream: u64, modes: usize| ModalPoint {
        place: [place, 0.0],
        rows: [row(stream, modes), row(stream + 1, modes)],
    };
    let contact = point(0.0, 1, 13);
    let load = contact.rows[1].clone();
    let slider = Slider { body: body(13), contact, load, inertia: vec![0.1; 13] };
    let nodes = (0..6).map(|k| point(1e-3 * k as f64, 10 + 2 * k, 37)).collect();
    let track = TrackBody { body: body(37), nodes };
    let observed = [(PairSide::Slider, 3, 13), (PairSide::Track, 4, 37)]
        .map(|(side, stream, modes)| Observed { side, row: row(stream, modes), rigid: 0.0 });
    let friction = Friction::Constant(0.1);
    Pair::new(slider, track, interpolation, true, friction, observed.to_vec()).unwrap()
}

/// The bits of all that a march tells of its steps.
fn told(pair: &Pair, method: ContactMethod, arch: Arch) -> Vec<[u64; 6]> {
    let motion = Motion {
        start: 1.3e-3,
        end: 3.4e-3,
        velocity: 0.02,
        load: -0.5,
        initial_gap: 0.0,
        noise: Noise { force: 0.1, seed: 5 },
        ramps: Ramps { velocity: 0.01, load: 0.01, friction: 0.0, gap: 0.0 },
        initial_damping: None,
    };
    let settings = MarchSettings { method, predictor: Predictor::WithForce, step: 2e-6, motion };
    let mut march = March::new(pair, settings).unwrap();
    (march.slider.arch, march.track.arch) = (arch, arch);
    let mut bits = Vec::new();
    let mut take = |sample: &MarchSample, a: &[f64]| {
        let MarchSample { normal_force, tangential_force, sliding_velocity, gap, .. } = *sample;
        bits.push([normal_force, tangential_force, sliding_velocity, gap, a[0], a[1]].map(f64::to_bits));
    };
    march.advance(u64::MAX, &mut take).unwrap();
    bits
}

/// Every method, over nodes, on straight and on smooth edges: not a bit of any step depends on the width of the vectors.
#[test]
fn no_bit_depends_on_the_width_of_the_vectors() {
    let residual = ContactMethod::ResidualFlexibility { cut_off: 4e3 };
    for interpolation in [Interpolation::Linear, Interpolation::Hermite] {
        let pair = pair(interpolation);
        for method in [
            ContactMethod::Subs { static_slope: false },
            ContactMethod::EnSubs,
            ContactMethod::Film,
            residual,
        ] {
            let scalar = told(&pair, method, Arch::Scalar);
            assert!(scalar.len() > 40_000 && scalar.iter().any(|step| f64::from_bits(step[0]) > 0.1));
            for arch in widths() {
                assert!(told(&pair, method, arch) == scalar, "{interpolation} {method:?} {arch:?}");
            }
        }
    }
}
