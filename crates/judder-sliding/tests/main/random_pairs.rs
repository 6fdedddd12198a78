//! The laws of contact at every step of FiLM, on random pairs.

use judder_contact::friction::{Friction, TableInterpolation};
use judder_numerics::counter::uniform;
use judder_sliding::SlidingError;
use judder_sliding::body::{Body, ModalPoint};
use judder_sliding::edge::Interpolation;
use judder_sliding::march::{ContactMethod, ContactState, March, MarchSample, MarchSettings, Predictor};
use judder_sliding::motion::{Motion, Noise, Ramps};
use judder_sliding::pair::{Pair, Slider, TrackBody};
use proptest::prelude::*;

/// Modes, rows and nodes drawn from a seed: a slider of three modes, a track of six with five nodes about a millimetre apart.
fn pair(seed: u64, interpolation: Interpolation, friction: f64) -> Pair {
    let drawn = |stream: u64, n: usize| 2.0 * uniform(seed ^ (stream << 32), n as u64) - 1.0;
    let rows = |stream: u64, modes: usize| {
        [0, 1].map(|axis| (0..modes).map(|k| 3.0 * drawn(stream, 2 * k + axis)).collect::<Vec<f64>>())
    };
    let body = |stream: u64, modes: usize| Body {
        eigenvalues: (0..modes).map(|k| (1e3 * (1.0 + k as f64 + drawn(stream, k).abs())).powi(2)).collect(),
        alpha: 20.0,
        beta: 1e-6,
    };
    let node = |k: usize| ModalPoint {
        place: [1e-3 * (k as f64 + 0.2 * drawn(50, k)), 0.0],
        rows: rows(60 + k as u64, 6),
    };
    let contact = ModalPoint { place: [0.0; 2], rows: rows(3, 3) };
    let load = contact.rows[1].clone();
    let slider = Slider { body: body(1, 3), contact, load, inertia: vec![0.1; 3] };
    let track = TrackBody { body: body(2, 6), nodes: (0..5).map(node).collect() };
    let friction =
        Friction::table(vec![0.01, 0.05], vec![friction, 0.8 * friction], TableInterpolation::Linear)
            .unwrap();
    Pair::new(slider, track, interpolation, true, friction, Vec::new()).unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, ..ProptestConfig::default() })]

    /// N ≥ 0, gap ≥ 0, N gap = 0; |T| ≤ μ N, T opposes slip, and there is none inside the cone.
    #[test]
    fn signorini_and_coulomb_hold_at_every_step(seed in 0..u64::MAX, friction in 0.0..0.6_f64, hermite in any::<bool>(), load in -3.0..-0.1_f64) {
        let interpolation = if hermite { Interpolation::Hermite } else { Interpolation::Linear };
        let pair = pair(seed, interpolation, friction);
        let motion = Motion {
            start: 1.3e-3,
            end: 2.7e-3,
            velocity: 0.02,
            load,
            initial_gap: 0.0,
            noise: Noise { force: 2.0, seed },
            ramps: Ramps { velocity: 0.01, load: 0.0, friction: 0.0, gap: 0.0 },
            initial_damping: None,
        };
        let settings = MarchSettings { method: ContactMethod::Film, predictor: Predictor::WithForce, step: 2e-6, motion };
        let mut broken = None;
        let mut take = |sample: &MarchSample, _: &[f64]| {
            let MarchSample { normal_force: n, tangential_force: t, gap, sliding_velocity: v, friction, state, .. } = *sample;
            let small = 1e-10 * n.abs().max(1.0);
            let holds = n >= 0.0
                && gap > -1e-15
                && (n * gap).abs() < 1e-14
                && t.abs() <= friction * n + small
                && match state {
                    ContactState::Stick => v.abs() < 1e-8,
                    ContactState::SlipBehind | ContactState::SlipAhead => t * v <= small,
                    ContactState::LiftOff => n == 0.0 && t == 0.0,
                };
            if !holds && broken.is_none() {
                broken = Some(*sample);
            }
        };
        let mut march = March::new(&pair, settings).unwrap();
        // a random slider may lock, or be thrown off the short track: stated, both
        match march.advance(40_000, &mut take) {
            Ok(_) | Err(SlidingError::SpragSlip { .. }) => (),
            Err(other) => prop_assert!(false, "{other}"),
        }
        prop_assert!(broken.is_none(), "{broken:?}");
    }
}
