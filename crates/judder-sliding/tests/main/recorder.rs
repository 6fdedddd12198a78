//! What is kept of a march: times, decimation, extremes, going on after an interruption.

use crate::common;
use judder_numerics::signal::Decimation;
use judder_sliding::march::{
    ContactMethod, ContactState, March, MarchSample, MarchSettings, Predictor, Sink,
};
use judder_sliding::motion::Motion;
use judder_sliding::recorder::{Channel, Recorder};
use std::f64::consts::TAU;

const STEP: f64 = 3e-7;

fn decimation() -> Decimation {
    Decimation::new(1.0 / STEP, 50e3, 8)
}

fn sample(motion: &Motion, step: u64, force: f64) -> MarchSample {
    let time = step as f64 * STEP;
    MarchSample {
        time,
        position: motion.at(time).position,
        normal_force: force,
        tangential_force: -0.3 * force,
        sliding_velocity: 0.03,
        gap: 0.0,
        friction: 0.3,
        state: ContactState::SlipBehind,
    }
}

/// Tones within the pass band come out at the times that are told, whatever the delays: accelerations are those of the step before.
#[test]
fn the_delay_is_taken_out_of_the_times() {
    let (pair, motion) = (common::pair(), common::motion());
    let channels = [
        Channel::Acceleration(0),
        Channel::NormalForce,
        Channel::TangentialForce,
        Channel::Displacement(0),
        Channel::Velocity(0),
    ];
    let mut recorder = Recorder::new(&pair, &motion, &channels, &decimation()).unwrap();
    let tone = |time: f64| (TAU * 9e3 * time).sin();
    for step in 1..=20_000_u64 {
        let sample = sample(&motion, step, tone(step as f64 * STEP));
        recorder.displaced(0, tone(sample.time), sample.position);
        recorder.take(&sample, &[tone((step - 1) as f64 * STEP)]);
    }
    recorder.flush();
    let columns = recorder.columns();
    let times = columns[0];
    assert!((times[0] >= 0.0) && times.windows(2).all(|t| (t[1] - t[0] - 8.0 * STEP).abs() < 1e-12));
    // to the last step, less what the filters hold at an end
    assert!((times[times.len() - 1] - 20_000.0 * STEP).abs() < 10.0 * STEP);
    for (k, time) in times.iter().enumerate().skip(100).take(2000) {
        assert_eq!(columns[1][k], motion.at(*time).position);
        for (column, expected) in
            [(2, tone(*time)), (3, tone(*time)), (4, -0.3 * tone(*time)), (5, tone(*time))]
        {
            assert!((columns[column][k] - expected).abs() < 2e-4, "{column} {time}: {}", columns[column][k]);
        }
        let velocity = TAU * 9e3 * (TAU * 9e3 * time).cos();
        assert!((columns[6][k] - velocity).abs() < 2e-4 * TAU * 9e3, "{time}");
    }
}

#[test]
fn extremes_and_states_are_those_after_the_ramps() {
    let (pair, motion) = (common::pair(), common::motion());
    let mut recorder = Recorder::new(&pair, &motion, &[], &decimation()).unwrap();
    let settled = (motion.settled() / STEP) as u64;
    let mut take = |step: u64, force: f64, velocity: f64, state: ContactState| {
        let sample = MarchSample { sliding_velocity: velocity, state, ..sample(&motion, step, force) };
        recorder.take(&sample, &[0.0]);
    };
    take(settled - 10, 99.0, -5.0, ContactState::LiftOff);
    take(settled + 10, 0.2, 0.03, ContactState::SlipBehind);
    take(settled + 11, 0.1, -0.01, ContactState::SlipAhead);
    take(settled + 12, 0.3, 0.0, ContactState::Stick);
    take(settled + 13, 0.0, 0.05, ContactState::LiftOff);
    take(settled + 14, 0.2, 0.02, ContactState::SlipBehind);
    let tally = recorder.tally();
    let values = |extremes: &judder_numerics::signal::extremes::Extremes| {
        [extremes.minimum().unwrap().1, extremes.maximum().unwrap().1]
    };
    assert_eq!(values(&tally.normal_force), [0.0, 0.3]);
    assert_eq!(values(&tally.sliding_velocity), [-0.01, 0.05]);
    let counts = [tally.slip_steps, tally.stick_steps, tally.open_steps, tally.reversed_steps];
    assert_eq!(counts, [2, 1, 1, 1]);
    // the first of eight steps
    let time = (settled - 10) as f64 * STEP;
    assert_eq!(recorder.states(), (&[time][..], &[ContactState::LiftOff.number()][..]));
}

/// A march and its recorder, both taken up again from text, leave the same samples to the bit.
#[test]
fn a_recorder_goes_on_to_the_bit() {
    let pair = common::pair();
    let motion = common::motion();
    let settings =
        MarchSettings { method: ContactMethod::EnSubs, step: STEP, motion, predictor: Predictor::default() };
    let channels = [Channel::Acceleration(0), Channel::Velocity(0), Channel::NormalForce];
    let new = || {
        let march = March::new(&pair, settings).unwrap();
        (march, Recorder::new(&pair, &motion, &channels, &decimation()).unwrap())
    };
    let (mut march, mut whole) = new();
    march.advance(4000, &mut whole).unwrap();
    let (mut march, mut first) = new();
    march.advance(1501, &mut first).unwrap();
    let text = serde_json::to_string(&(march.checkpoint(), first.state())).unwrap();
    let (checkpoint, state) = serde_json::from_str(&text).unwrap();
    let (mut march, mut second) = new();
    march.resume(&checkpoint).unwrap();
    second.resume(&decimation(), &state).unwrap();
    march.advance(2499, &mut second).unwrap();
    for (whole, (first, second)) in
        whole.columns().into_iter().zip(first.columns().into_iter().zip(second.columns()))
    {
        assert_eq!(whole, [first, second].concat());
    }
    let of = |recorder: &Recorder| recorder.states().1.to_vec();
    assert_eq!(of(&whole), [of(&first), of(&second)].concat());
    assert_eq!(whole.tally(), second.tally());
}

/// Steps take no memory: not the marches, not what is kept of them once there is room; across nodes of the track too.
#[test]
fn a_step_allocates_nothing() {
    let pair = common::pair();
    let motion = common::motion();
    for method in [
        ContactMethod::Subs { static_slope: false },
        ContactMethod::EnSubs,
        ContactMethod::Film,
        ContactMethod::Subs { static_slope: true },
    ] {
        let settings = MarchSettings { method, step: STEP, motion, predictor: Predictor::default() };
        let mut march = March::new(&pair, settings).unwrap();
        let channels = [Channel::Acceleration(0), Channel::NormalForce, Channel::SlidingVelocity];
        let mut recorder = Recorder::new(&pair, &motion, &channels, &decimation()).unwrap();
        recorder.reserve(400_000);
        let counted = allocation_counter::measure(|| {
            march.advance(400_000, &mut recorder).unwrap();
        });
        assert_eq!((march.steps(), counted.count_total), (400_000, 0), "{method:?}");
    }
}
