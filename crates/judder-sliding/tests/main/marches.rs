//! The marches on the pair of the beams paper.
use crate::common;
use judder_contact::friction::Friction;
use judder_numerics::signal::Decimation;
use judder_numerics::signal::decimate::Decimator;
use judder_sliding::coupling::{Coupling, SteadyFriction};
use judder_sliding::edge::{Interpolation, RunOff};
use judder_sliding::march::{
    ContactMethod, ContactState, March, MarchSample, MarchSettings, MarchStart, Predictor, Reached,
};
use judder_sliding::motion::{Motion, Noise, Ramps};
use judder_sliding::pair::Pair;
use judder_sliding::{SlidingError, statics::PairEquilibrium};

const STEP: f64 = 3e-7;

/// The last fifth of the path: the ramps end before its loudest zone begins, at 90 mm.
fn last_part() -> Motion {
    Motion { start: 0.080, ..common::motion() }
}

/// What is kept of a march: the low-passed acceleration of T, and counts after the ramps.
struct Kept {
    acceleration: Vec<f64>,
    stick: usize,
    open: usize,
    least_force: f64,
    least_velocity: f64,
}

impl Kept {
    fn peak(&self) -> f64 {
        self.acceleration.iter().fold(0.0, |peak, a| a.abs().max(peak))
    }
}

fn march(pair: &Pair, method: ContactMethod, step: f64, motion: Motion) -> Kept {
    let mut march =
        March::new(pair, MarchSettings { method, predictor: Predictor::WithForce, step, motion }).unwrap();
    let factor = Decimation::factor_to(1.0 / step, 400e3);
    let mut filter = Decimator::new(&Decimation::new(1.0 / step, 50e3, factor), &[0.0]).unwrap();
    let settled = motion.settled() + filter.delay();
    let mut kept = Kept {
        acceleration: Vec::new(),
        stick: 0,
        open: 0,
        least_force: f64::INFINITY,
        least_velocity: f64::INFINITY,
    };
    let mut take = |sample: &MarchSample, accelerations: &[f64]| {
        let filtered = filter.push(&accelerations[..1]);
        if sample.time > settled {
            kept.acceleration.extend(filtered.into_iter().flatten());
            kept.stick += usize::from(sample.state == ContactState::Stick);
            kept.open += usize::from(sample.state == ContactState::LiftOff);
            kept.least_force = kept.least_force.min(sample.normal_force);
            kept.least_velocity = kept.least_velocity.min(sample.sliding_velocity);
        }
    };
    assert_eq!(march.advance(u64::MAX, &mut take), Ok(Reached::End));
    kept
}

fn rms(values: impl Iterator<Item = f64> + Clone) -> f64 {
    let count = values.clone().count() as f64;
    (values.map(|v| v * v).sum::<f64>() / count).sqrt()
}

/// Sections 2.3 and 3.1 of the paper: EnSubs and FiLM agree, both burst, sliding never ends; Subs does not burst, and the static slope
/// alone makes it burst.
#[test]
fn ensubs_and_film_burst_and_subs_does_not() {
    let pair = common::pair();
    let [ensubs, film] =
        [ContactMethod::EnSubs, ContactMethod::Film].map(|method| march(&pair, method, STEP, last_part()));
    let difference = rms(ensubs.acceleration.iter().zip(&film.acceleration).map(|(a, b)| a - b));
    assert!(difference < 1e-3 * rms(ensubs.acceleration.iter().copied()), "{difference}");
    for kept in [&ensubs, &film] {
        assert_eq!((kept.stick, kept.open), (0, 0));
        assert!(kept.least_force > 0.0 && kept.least_velocity > 0.0);
    }
    let [subs, sloped] = [false, true]
        .map(|static_slope| march(&pair, ContactMethod::Subs { static_slope }, STEP, last_part()));
    let peaks = [&ensubs, &subs, &sloped].map(Kept::peak);
    assert!(peaks[1] < 0.1 * peaks[0], "{peaks:?}");
    assert!(peaks[2] > 0.5 * peaks[0], "{peaks:?}");
}

/// Half the step changes the burst's peak by less than 0.2 %.
#[test]
fn the_burst_does_not_depend_on_the_step() {
    let pair = common::pair();
    let [whole, half] =
        [STEP, 0.5 * STEP].map(|step| march(&pair, ContactMethod::EnSubs, step, last_part()).peak());
    assert!((half / whole - 1.0).abs() < 2e-3, "{whole} {half}");
}

/// Just below the printed limit a march runs, just above it blows up, and is refused where it is not asked for by name.
#[test]
fn the_step_limit_is_the_limit() {
    let pair = common::pair();
    let motion = Motion { start: 0.097, ..common::motion() };
    let at =
        |step| MarchSettings { method: ContactMethod::EnSubs, predictor: Predictor::WithForce, step, motion };
    let limit = March::new(&pair, at(STEP)).unwrap().step_limit();
    let mut nothing = |_: &MarchSample, _: &[f64]| ();
    let below = March::new(&pair, at(0.99 * limit)).unwrap().advance(300_000, &mut nothing);
    assert_eq!(below, Ok(Reached::End));
    let above = March::beyond_limit(&pair, at(1.01 * limit)).unwrap().advance(300_000, &mut nothing);
    assert!(matches!(above, Err(SlidingError::NotFinite { .. })), "{above:?}");
    let refused = March::new(&pair, at(1.01 * limit)).err();
    assert_eq!(refused, Some(SlidingError::StepOverLimit { step: 1.01 * limit, limit }));
}

/// Without friction and damping, held at one place, what central differences conserve in place of the energy stays over 1e6 steps:
/// |Δq|²/2h² + qₙ·Λ qₙ₊₁/2 less the work of the load.
#[test]
fn the_shadow_energy_stays() {
    shadow_energy(1_000_000);
}

/// The same over 1e7 steps.
#[test]
#[ignore = "takes a minute; `make validate` runs it"]
fn the_shadow_energy_stays_for_ten_million_steps() {
    shadow_energy(10_000_000);
}

fn shadow_energy(steps: u64) {
    let frictionless = Friction::Constant(0.0);
    let damped = common::pair_with(Interpolation::Linear, frictionless, 20);
    let pair = common::without_damping(&damped);
    let position = 0.0405;
    let sliding = SteadyFriction::at(pair.friction(), common::SPEED);
    let rest = PairEquilibrium::undeformed(&pair, position, common::LOAD, sliding).unwrap();
    // a disturbance of every mode that keeps the contact closed: the structures' weightless state
    let start = MarchStart {
        now: rest.state.iter().map(|q| 0.9 * q).collect(),
        before: rest.state.iter().map(|q| 0.9 * q).collect(),
        forces: [[0.0, 0.9 * rest.normal_force]; 2],
    };
    let motion = Motion { start: position, end: position, velocity: common::SPEED, ..common::motion() };
    let settings = MarchSettings {
        method: ContactMethod::Subs { static_slope: false },
        predictor: Predictor::WithForce,
        step: STEP,
        motion,
    };
    let mut march = March::held(&pair, settings, &start).unwrap();
    let eigenvalues = pair.eigenvalues();
    let energy = |now: &[f64], next: &[f64]| -> f64 {
        let modes = now.iter().zip(next).zip(&eigenvalues);
        let own: f64 =
            modes.map(|((q, p), value)| 0.5 * ((p - q) / STEP).powi(2) + 0.5 * value * q * p).sum();
        let load = &pair.slider().load;
        let work: f64 = load.iter().zip(now.iter().zip(next)).map(|(f, (q, p))| 0.5 * f * (q + p)).sum();
        own - common::LOAD * work
    };
    let mut nothing = |_: &MarchSample, _: &[f64]| ();
    let mut of_step = || {
        let now = march.state();
        march.advance(1, &mut nothing).unwrap();
        (energy(&now, &march.state()), march.advance(steps / 100, &mut nothing).unwrap())
    };
    let (first, _) = of_step();
    let scale = {
        let (now, rest) = (start.now.clone(), rest.state.clone());
        let away: f64 = now
            .iter()
            .zip(&rest)
            .zip(&eigenvalues)
            .map(|((q, r), value)| 0.5 * value * (q - r).powi(2))
            .sum();
        away
    };
    for _ in 0..99 {
        let (energy, _) = of_step();
        assert!((energy - first).abs() < 1e-4 * scale, "{energy:e} {first:e} {scale:e}");
    }
}

/// A march that is taken up from a checkpoint ends in the same bits, across nodes and while damping is released.
#[test]
fn a_continued_march_is_the_same_to_the_bit() {
    let pair = common::pair();
    for method in
        [ContactMethod::EnSubs, ContactMethod::Film, ContactMethod::ResidualFlexibility { cut_off: 60e3 }]
    {
        let step = if matches!(method, ContactMethod::ResidualFlexibility { .. }) { 2.4e-6 } else { STEP };
        let motion = Motion {
            start: 0.0938,
            end: 0.0946,
            noise: Noise { force: 1e-4, seed: 3 },
            ramps: Ramps { velocity: 0.002, load: 0.004, friction: 0.004, gap: 0.0 },
            initial_damping: common::motion()
                .initial_damping
                .map(|d| judder_sliding::motion::InitialDamping { hold: 0.004, release: 0.02, ..d }),
            ..common::motion()
        };
        let settings = MarchSettings { method, predictor: Predictor::WithForce, step, motion };
        let mut through = March::new(&pair, settings).unwrap();
        let mut samples = Vec::new();
        let mut take = |sample: &MarchSample, a: &[f64]| samples.push((*sample, a[0]));
        assert_eq!(through.advance(u64::MAX, &mut take), Ok(Reached::End));
        let mut continued = Vec::new();
        let mut march = March::new(&pair, settings).unwrap();
        loop {
            let mut take = |sample: &MarchSample, a: &[f64]| continued.push((*sample, a[0]));
            let reached = march.advance(7_919, &mut take).unwrap();
            let text = serde_json::to_string(&march.checkpoint()).unwrap();
            march = March::new(&pair, settings).unwrap();
            march.resume(&serde_json::from_str(&text).unwrap()).unwrap();
            if reached == Reached::End {
                break;
            }
        }
        assert!(samples == continued, "{method:?}");
    }
}

/// A checkpoint whose slider fits and whose track does not leaves the march as it was: it ends in the bits of one that saw none.
#[test]
fn a_foreign_checkpoint_changes_nothing() {
    let pair = common::pair();
    let other = {
        let slow = |values: &[f64]| values[..values.len() - 1].to_vec();
        let mut track = pair.track().clone();
        track.body.eigenvalues = slow(&track.body.eigenvalues);
        for row in track.nodes.iter_mut().flat_map(|node| &mut node.rows) {
            *row = slow(row);
        }
        let mut observed = pair.observed().to_vec();
        observed[0].row = slow(&observed[0].row);
        let interpolation = Interpolation::Linear;
        Pair::new(pair.slider().clone(), track, interpolation, true, pair.friction().clone(), observed)
            .unwrap()
    };
    let settings = MarchSettings {
        method: ContactMethod::EnSubs,
        predictor: Predictor::WithForce,
        step: STEP,
        motion: common::motion(),
    };
    let mut nothing = |_: &MarchSample, _: &[f64]| ();
    let mut foreign = March::new(&other, settings).unwrap();
    foreign.advance(5_000, &mut nothing).unwrap();
    let [mut untouched, mut asked] = [0, 1].map(|_| March::new(&pair, settings).unwrap());
    for march in [&mut untouched, &mut asked] {
        march.advance(1_000, &mut nothing).unwrap();
    }
    assert_eq!(asked.resume(&foreign.checkpoint()), Err(SlidingError::ForeignCheckpoint));
    for march in [&mut untouched, &mut asked] {
        march.advance(1_000, &mut nothing).unwrap();
    }
    assert_eq!(asked.checkpoint(), untouched.checkpoint());
}

/// Every method names the same c·M⁻¹e where the slider locks, that of the coupling there, whatever its step. With residual flexibility it
/// may lock where c·M⁻¹e is positive, and says so.
#[test]
fn locking_is_the_same_quantity_in_every_march() {
    let friction = 30.0;
    let locked = |friction: f64, method, step| {
        let pair = common::pair_with(Interpolation::Linear, Friction::Constant(friction), 20);
        let ramps = Ramps { friction: 0.0, ..common::motion().ramps };
        let motion = Motion { start: 0.0505, ramps, ..common::motion() };
        let settings = MarchSettings { method, predictor: Predictor::WithForce, step, motion };
        let mut nothing = |_: &MarchSample, _: &[f64]| ();
        March::new(&pair, settings).and_then(|mut march| march.advance(10_000, &mut nothing)).unwrap_err()
    };
    let pair = common::pair();
    let expected = |position: f64| {
        let touch = pair.undeformed(position).unwrap();
        Coupling::new(&pair, &touch, SteadyFriction { friction, slope: 0.0, direction: 1.0 }).mobility()
    };
    let subs = ContactMethod::Subs { static_slope: false };
    let residual = ContactMethod::ResidualFlexibility { cut_off: 60e3 };
    for (method, step) in
        [(subs, STEP), (subs, 0.3 * STEP), (ContactMethod::EnSubs, STEP), (residual, 2.4e-6)]
    {
        let error = locked(friction, method, step);
        let SlidingError::SpragSlip { position, mobility, .. } = error else { panic!("{method:?}: {error}") };
        assert!((position - 0.0505).abs() < 1e-3, "{method:?}: {position}");
        // the march with residual flexibility looks at the ends and the middle of each segment
        let expected = expected(position);
        assert!((mobility / expected - 1.0).abs() < 1e-3, "{method:?}: {mobility} {expected}");
    }
    let error = locked(2.0, residual, 2.4e-6);
    assert!(matches!(error, SlidingError::LocksAtOnce { compliance, .. } if compliance <= 0.0), "{error}");
    assert!(error.to_string().contains("another cut-off"), "{error}");
}

/// FiLM sticks where the speed stays below what friction holds, slides on, and lifts off where the load is taken away: nothing of it
/// breaks Signorini's or Coulomb's law.
#[test]
fn film_sticks_and_lifts_off() {
    let pair = common::pair_with(Interpolation::Linear, Friction::Constant(0.3), 20);
    // a slow start under the whole load sticks; noise of the load's own size tears it off
    let motion = Motion {
        start: 0.09,
        end: 0.0903,
        noise: Noise { force: 0.8, seed: 11 },
        ramps: Ramps { velocity: 0.01, load: 0.0, friction: 0.0, gap: 0.0 },
        initial_damping: None,
        ..common::motion()
    };
    let mut march = March::new(
        &pair,
        MarchSettings { method: ContactMethod::Film, predictor: Predictor::WithForce, step: STEP, motion },
    )
    .unwrap();
    let (mut stick, mut open, mut slip) = (0, 0, 0);
    let mut take = |sample: &MarchSample, _: &[f64]| {
        let MarchSample { normal_force, tangential_force, gap, sliding_velocity, friction, state, .. } =
            *sample;
        assert!(normal_force >= 0.0 && gap > -1e-18, "{sample:?}");
        assert!(normal_force * gap.abs() < 1e-18, "{sample:?}");
        assert!(tangential_force.abs() <= friction * normal_force * (1.0 + 1e-12), "{sample:?}");
        match state {
            ContactState::Stick => assert!(sliding_velocity.abs() < 1e-9, "{sample:?}"),
            ContactState::SlipBehind | ContactState::SlipAhead => {
                assert!(tangential_force * sliding_velocity <= 1e-12, "{sample:?}");
            }
            ContactState::LiftOff => assert_eq!((normal_force, tangential_force), (0.0, 0.0)),
        }
        stick += usize::from(state == ContactState::Stick);
        open += usize::from(state == ContactState::LiftOff);
        slip += usize::from(matches!(state, ContactState::SlipBehind | ContactState::SlipAhead));
    };
    march.advance(u64::MAX, &mut take).unwrap();
    assert!(stick > 100 && open > 100 && slip > 100, "{stick} {open} {slip}");
}

/// A slider that runs off its track, one that locks, and one that starts beside it are told from each other.
#[test]
fn wrong_marches_are_named() {
    let pair = common::pair();
    let at = |motion| {
        March::new(
            &pair,
            MarchSettings {
                method: ContactMethod::EnSubs,
                predictor: Predictor::WithForce,
                step: STEP,
                motion,
            },
        )
    };
    let beyond = at(Motion { end: 0.2, ..common::motion() }).err();
    assert!(matches!(beyond, Some(SlidingError::OffTrack { .. })), "{beyond:?}");
    let kick = Motion {
        initial_gap: -1e-9,
        ramps: Ramps { gap: 0.0, ..common::motion().ramps },
        ..common::motion()
    };
    let kick = at(kick).err();
    assert!(matches!(kick, Some(SlidingError::OpenAtStart { .. })), "{kick:?}");
    let locking = common::pair_with(Interpolation::Linear, Friction::Constant(30.0), 20);
    let settings = MarchSettings {
        method: ContactMethod::EnSubs,
        predictor: Predictor::WithForce,
        step: STEP,
        motion: Motion { ramps: Ramps { friction: 0.0, ..common::motion().ramps }, ..common::motion() },
    };
    let mut nothing = |_: &MarchSample, _: &[f64]| ();
    let locked = March::new(&locking, settings).unwrap().advance(1_000_000, &mut nothing);
    assert!(matches!(locked, Err(SlidingError::SpragSlip { .. })), "{locked:?}");
    let end = Motion { start: 0.0985, end: 0.1, ..common::motion() };
    let end = at(end).unwrap().advance(u64::MAX, &mut nothing);
    assert_eq!(end, Ok(Reached::RunOff(RunOff::Last)));
}

/// The force of the last step deforms the same nodes when C comes to the next segment: on a smooth edge the normal force goes over a node
/// as smoothly as without that force in the geometry.
#[test]
fn a_smooth_node_is_crossed_without_a_click() {
    let friction = Friction::Constant(common::FRICTION);
    let pair = common::pair_with(Interpolation::Hermite, friction, 20);
    let ramps = Ramps { velocity: 2e-3, load: 4e-3, friction: 4e-3, gap: 0.0 };
    let motion = Motion { start: 0.0501, ramps, ..common::motion() };
    let [printed, with_force] = [Predictor::Printed, Predictor::WithForce].map(|predictor| {
        let settings = MarchSettings { method: ContactMethod::EnSubs, predictor, step: STEP, motion };
        let mut march = March::new(&pair, settings).unwrap();
        let (mut last, mut bend) = ([0.0; 2], 0.0_f64);
        let mut take = |sample: &MarchSample, _: &[f64]| {
            // once the ramps' motion has died down: with the node at 51 mm, by what C is deformed
            if sample.position > 0.0506 {
                bend = bend.max((sample.normal_force - 2.0 * last[1] + last[0]).abs());
            }
            last = [last[1], sample.normal_force];
        };
        assert_eq!(march.advance(120_000, &mut take), Ok(Reached::Steps));
        bend
    });
    assert!(with_force < 1.1 * printed, "{with_force:e} {printed:e} N");
}
