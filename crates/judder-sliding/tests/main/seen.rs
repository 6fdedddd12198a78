//! What a march tells of its points is what its modes do, and nothing kicks it at its start.

use crate::common;
use judder_sliding::SlidingError;
use judder_sliding::march::{ContactMethod, March, MarchSample, MarchSettings, Predictor, Sink};
use judder_sliding::motion::{Motion, Noise};
use judder_sliding::pair::{Observed, Pair, PairSide};

const STEP: f64 = 3e-7;

/// The displacements of the last step.
struct Last(Vec<f64>);

impl Sink for Last {
    fn displaced(&mut self, point: usize, displacement: f64, _position: f64) {
        self.0[point] = displacement;
    }

    fn take(&mut self, _sample: &MarchSample, _accelerations: &[f64]) {}
}

/// The pair of the paper, its slider watched at C along y as well.
fn watched_at_the_contact() -> Pair {
    let pair = common::pair();
    let row = pair.slider().contact.rows[1].clone();
    let observed = [pair.observed(), &[Observed { side: PairSide::Slider, row, rigid: 0.0 }]].concat();
    let interpolation = pair.edge().interpolation;
    Pair::new(
        pair.slider().clone(),
        pair.track().clone(),
        interpolation,
        true,
        pair.friction().clone(),
        observed,
    )
    .unwrap()
}

/// A random force moves the points of the slider at once, and what is told of them includes it.
#[test]
fn observed_displacements_are_those_of_the_modes_under_noise_too() {
    let pair = watched_at_the_contact();
    let motion = Motion { noise: Noise { force: 0.05, seed: 3 }, ..common::motion() };
    let predictor = Predictor::WithForce;
    let settings = MarchSettings { method: ContactMethod::EnSubs, predictor, step: STEP, motion };
    let mut march = March::new(&pair, settings).unwrap();
    let mut last = Last(vec![0.0; 2]);
    let modes = pair.slider().body.modes();
    for _ in 0..500 {
        march.advance(7, &mut last).unwrap();
        let state = march.state();
        let seen = |point: usize, modal: &[f64]| {
            let row = &pair.observed()[point].row;
            row.iter().zip(modal).map(|(row, q)| row * q).sum::<f64>()
        };
        let expected = [seen(0, &state[modes..]), seen(1, &state[..modes])];
        for (found, expected) in last.0.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-9 * expected.abs() + 1e-16, "{found} {expected}");
        }
    }
}

/// The static slope comes with the load that makes it.
#[test]
fn the_static_slope_does_not_kick() {
    let pair = common::pair();
    let motion = common::motion();
    let method = ContactMethod::Subs { static_slope: true };
    let settings = MarchSettings { method, predictor: Predictor::WithForce, step: STEP, motion };
    let mut march = March::new(&pair, settings).unwrap();
    let (mut largest, mut open) = (0.0_f64, 0);
    let mut take = |sample: &MarchSample, _: &[f64]| {
        largest = largest.max(sample.normal_force);
        open += usize::from(sample.normal_force == 0.0 && sample.time > 1e-3);
    };
    march.advance((motion.settled() / STEP) as u64, &mut take).unwrap();
    assert!(largest < 1.05 * common::LOAD.abs() && open == 0, "{largest} {open}");
}

#[test]
fn a_cut_off_outside_the_frequencies_is_refused() {
    let pair = common::pair();
    for cut_off in [1.0, 40.0, 1e9] {
        let method = ContactMethod::ResidualFlexibility { cut_off };
        let motion = common::motion();
        let settings = MarchSettings { method, predictor: Predictor::WithForce, step: 1e-6, motion };
        let error = March::new(&pair, settings).unwrap_err();
        assert!(matches!(error, SlidingError::CutOff { .. }), "{cut_off}: {error}");
    }
}
