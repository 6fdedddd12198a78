//! Contact points that travel, against the march of one point along a track in `judder-sliding`, which was held against the beams paper.

use crate::common::{IMPLICIT, assembly, coulomb, diagonal, settings};
use judder_assembly::assembly::Assembly;
use judder_assembly::contact_point::ContactPoint;
use judder_assembly::friction::Friction;
use judder_assembly::interface::InterfaceLaw;
use judder_assembly::pressure::Pressure;
use judder_assembly::row::Row;
use judder_nonsmooth::NonsmoothError;
use judder_nonsmooth::course::{Course, TimeFactor};
use judder_nonsmooth::march::{NonsmoothMarch, NonsmoothSettings};
use judder_nonsmooth::scheme::ContactScheme;
use judder_nonsmooth::travel::{EdgeNode, TravellingContact};
use judder_sliding::body::{Body, ModalPoint};
use judder_sliding::edge::{Interpolation, RunOff};
use judder_sliding::march::{ContactMethod, ContactState, March, MarchSample, MarchSettings, Predictor};
use judder_sliding::motion::{Motion, Noise, Ramps};
use judder_sliding::pair::{Pair, Slider, TrackBody};
use std::f64::consts::PI;

const FILM: ContactScheme = ContactScheme::ForwardIncrement;
const FRICTION: f64 = 0.3;
const START: f64 = 0.013;
const STEP: f64 = 1e-6;

/// What differs from march to march.
#[derive(Debug, Clone, Copy)]
struct Ride {
    interpolation: Interpolation,
    /// Of the slider, in m/s.
    velocity: f64,
    /// In N.
    load: f64,
    /// How high and low the nodes ahead lie, in m.
    bumps: f64,
    /// A share of the damping.
    damping: f64,
}

const CALM: Ride =
    Ride { interpolation: Interpolation::Linear, velocity: 0.4, load: -0.4, bumps: 0.0, damping: 1.0 };

/// Modes of a bar that is held at one end, as their rows at places from 0 to 1 along it.
fn row(modes: usize, place: f64, phase: f64, size: f64) -> Vec<f64> {
    (0..modes)
        .map(|k| size * ((k as f64 + 0.5) * PI * place + phase).sin() / (1.0 + 0.2 * k as f64))
        .collect()
}

/// Five modes against nine, along a track of twenty-one nodes with 5 mm between them.
fn pair(ride: Ride) -> Pair {
    let body = |modes: usize, lowest: f64, alpha: f64| Body {
        eigenvalues: (0..modes).map(|k| (lowest * (1.0 + 1.7 * k as f64)).powi(2)).collect(),
        alpha: ride.damping * alpha,
        beta: ride.damping * 1e-6,
    };
    let contact = ModalPoint { place: [0.0, 0.0], rows: [row(5, 0.9, 0.4, 2.0), row(5, 0.8, 0.0, 5.0)] };
    let load = contact.rows[1].clone();
    let slider = Slider { body: body(5, 900.0, 60.0), contact, load, inertia: vec![0.0; 5] };
    let node = |k: usize| {
        let place = k as f64 / 20.0;
        let height = if (5..20).contains(&k) { ride.bumps * (7.0 * k as f64).sin() } else { 0.0 };
        ModalPoint { place: [0.1 * place, height], rows: [row(9, place, 0.2, 0.5), row(9, place, 0.0, 4.0)] }
    };
    let track = TrackBody { body: body(9, 700.0, 40.0), nodes: (0..21).map(node).collect() };
    Pair::new(slider, track, ride.interpolation, true, Friction::Constant(FRICTION), Vec::new()).unwrap()
}

/// The same as an assembly: modes are its freedoms.
fn as_assembly(pair: &Pair, ride: Ride) -> (Assembly, TravellingContact) {
    let row = |values: &[f64], first: usize| {
        Row::new(values.iter().enumerate().map(|(k, value)| (first + k, *value)).collect())
    };
    let (slider, track) = (pair.slider(), pair.track());
    let first = slider.body.modes();
    let of_slider = [0, 1].map(|k| row(&slider.contact.rows[k], 0));
    let nodes = track
        .nodes
        .iter()
        .map(|node| EdgeNode { place: node.place, rows: [0, 1].map(|k| row(&node.rows[k], first)) });
    let point = ContactPoint {
        place: [START, 0.0, 0.0],
        normal: [0.0, 1.0, 0.0],
        velocity: [-ride.velocity, 0.0, 0.0],
        rest_direction: None,
        area: 1.0,
        gap: 0.0,
        relative: [of_slider[0].clone(), of_slider[1].clone(), Row::default()],
        convected: None,
        foot: None,
    };
    let travelling = TravellingContact {
        interface: 0,
        points: vec![of_slider],
        interpolation: pair.edge().interpolation,
        nodes: nodes.collect(),
    };
    let modes = pair.eigenvalues();
    let mut forces = vec![0.0; modes.len()];
    forces.iter_mut().zip(&slider.load).for_each(|(force, own)| *force = ride.load * own);
    let matrices = [diagonal(&vec![1.0; modes.len()]), diagonal(&pair.damping()), diagonal(&modes)];
    (assembly(matrices, forces, vec![point], coulomb(FRICTION)), travelling)
}

fn marched(pair: &Pair, ride: Ride, method: ContactMethod, ramps: Ramps) -> Vec<MarchSample> {
    let motion = Motion {
        start: START,
        end: if ride.velocity > 0.0 { 0.099 } else { 0.001 },
        velocity: ride.velocity,
        load: ride.load,
        initial_gap: 0.0,
        noise: Noise::default(),
        ramps,
        initial_damping: None,
    };
    let settings = MarchSettings { method, predictor: Predictor::WithForce, step: STEP, motion };
    let mut march = March::new(pair, settings).unwrap();
    let mut samples = Vec::new();
    march.advance(100_000, &mut |sample: &MarchSample, _: &[f64]| samples.push(*sample)).unwrap();
    samples
}

/// One point along straight and smooth edges, in both directions: forces and gaps of every step. Where it is thrown by bumps, or sticks and turns, rounding of places of
/// 0.1 m, of which a step of 1e-6 s makes forces, goes through impacts.
#[test]
fn one_point_travels_as_the_beams_paper_has_it() {
    let smooth = Ride { interpolation: Interpolation::Hermite, ..CALM };
    let thrown = Ride { velocity: 0.8, bumps: 3e-5, damping: 0.5, ..CALM };
    let turning = Ride { velocity: 0.01, load: -4.0, bumps: 3e-4, damping: 0.02, ..CALM };
    let (film, known) = ((FILM, ContactMethod::Film), (ContactScheme::KnownSliding, ContactMethod::EnSubs));
    let rides = [
        (CALM, film, 1e-9),
        (smooth, film, 1e-9),
        (Ride { velocity: -0.1, ..smooth }, film, 1e-9),
        (Ride { velocity: -0.1, ..smooth }, known, 1e-9),
        (thrown, film, 1e-6),
        (thrown, known, 1e-6),
        (turning, film, 1e-6),
    ];
    let mut counts = [0; 2];
    for (ride, (scheme, method), allowed) in rides {
        let pair = pair(ride);
        let expected = marched(&pair, ride, method, Ramps::default());
        assert_eq!(expected.len(), 100_000);
        let (case, travelling) = as_assembly(&pair, ride);
        let mut march =
            NonsmoothMarch::travelling(&case, &[travelling], &[], settings(scheme, STEP)).unwrap();
        let largest = expected.iter().map(|own| own.normal_force).fold(0.0, f64::max);
        march.set_force_scale(largest);
        for (step, sample) in expected.iter().enumerate() {
            march.advance().unwrap();
            let [normal, friction, _] = march.force(0);
            let off = [
                normal - sample.normal_force,
                friction + ride.velocity.signum() * sample.tangential_force,
                (march.gap(0) - sample.gap) / 1e-3,
            ];
            assert!(
                off.iter().all(|own| own.abs() < allowed * largest),
                "{ride:?}, {scheme:?}, step {step}: {off:?}"
            );
        }
        counts[0] += expected.iter().filter(|own| own.state == ContactState::LiftOff).count();
        counts[1] += expected.iter().filter(|own| own.state == ContactState::Stick).count();
    }
    assert!(counts[0] > 10_000 && counts[1] > 100, "{counts:?}");
}

/// A course is what the ramps of the march of sliding structures are; the friction of a step is that at its beginning, there at its end.
#[test]
fn a_course_is_what_ramps_are() {
    let ride = Ride { interpolation: Interpolation::Hermite, ..CALM };
    let pair = pair(ride);
    let (case, travelling) = as_assembly(&pair, ride);
    for (friction, allowed) in [(0.0, 1e-9), (0.06, 1e-3)] {
        let ramps = Ramps { velocity: 0.05, load: 0.03, friction, gap: 0.0 };
        let expected = marched(&pair, ride, ContactMethod::Film, ramps);
        let mut march =
            NonsmoothMarch::travelling(&case, std::slice::from_ref(&travelling), &[], settings(FILM, STEP))
                .unwrap();
        let largest = expected.iter().map(|own| own.normal_force).fold(0.0, f64::max);
        march.set_force_scale(largest);
        let rise = |time: f64| if time > 0.0 { TimeFactor::Rise(time) } else { TimeFactor::Constant(1.0) };
        let course = Course {
            speed: rise(ramps.velocity),
            load: rise(ramps.load),
            friction: vec![rise(ramps.friction)],
        };
        march.follow(course, &[]).unwrap();
        let size = case.size();
        march.start(&vec![0.0; size], &vec![0.0; size]);
        for (step, sample) in expected.iter().enumerate() {
            march.advance().unwrap();
            let [normal, along, _] = march.force(0);
            let off = [normal - sample.normal_force, along + sample.tangential_force];
            assert!(off.iter().all(|own| own.abs() < allowed * largest), "{friction}, step {step}: {off:?}");
        }
    }
}

/// A sole of three points with a mass each on a track that moves as one: it travels as it would slide on a body without an edge.
#[test]
fn points_on_a_track_that_moves_as_one_need_no_place() {
    let (size, spring) = (8, 4e4);
    // freedoms: x and y of three masses, x and y of the track
    let stiffness: Vec<f64> = (0..size).map(|k| spring * (1.0 + 0.3 * k as f64)).collect();
    let load: Vec<f64> = (0..size).map(|k| if k % 2 == 1 && k < 6 { -3.0 - k as f64 } else { 0.0 }).collect();
    let of_track = [Row::of_freedom(6), Row::of_freedom(7)];
    let of_point = |point: usize| [Row::of_freedom(2 * point), Row::of_freedom(2 * point + 1)];
    let point = |number: usize| {
        let relative = [0, 1].map(|k| Row::sum([(1.0, &of_point(number)[k]), (-1.0, &of_track[k])]));
        let [x, y] = relative;
        ContactPoint {
            place: [0.02 + 0.001 * number as f64, 0.0, 0.0],
            normal: [0.0, 1.0, 0.0],
            velocity: [-0.2, 0.0, 0.0],
            rest_direction: None,
            area: 1.0,
            gap: 0.0,
            relative: [x, y, Row::default()],
            convected: None,
            foot: None,
        }
    };
    let matrices = [
        diagonal(&[0.02, 0.02, 0.03, 0.03, 0.04, 0.04, 0.5, 0.5]),
        diagonal(&[0.3; 8]),
        diagonal(&stiffness),
    ];
    let case = assembly(matrices, load, (0..3).map(point).collect(), coulomb(FRICTION));
    let nodes = (0..9).map(|k| EdgeNode { place: [0.01 * f64::from(k), 0.0], rows: of_track.clone() });
    let travelling = TravellingContact {
        interface: 0,
        points: (0..3).map(of_point).collect(),
        interpolation: Interpolation::Linear,
        nodes: nodes.collect(),
    };
    for scheme in [IMPLICIT, FILM] {
        let mut still = NonsmoothMarch::new(&case, &[], settings(scheme, 1e-5)).unwrap();
        let mut moving =
            NonsmoothMarch::travelling(&case, std::slice::from_ref(&travelling), &[], settings(scheme, 1e-5))
                .unwrap();
        for step in 0..20_000 {
            still.advance().unwrap();
            moving.advance().unwrap();
            for point in 0..3 {
                for (own, other) in moving.force(point).into_iter().zip(still.force(point)) {
                    assert!((own - other).abs() < 1e-6, "{scheme:?}, step {step}: {own} {other}");
                }
            }
        }
    }
}

/// The balance of energy closes where couplings change from step to step, by both schemes, which lead to the same motion.
#[test]
fn energy_closes_along_the_track() {
    let ride = Ride { interpolation: Interpolation::Hermite, bumps: 3e-5, ..CALM };
    let pair = pair(ride);
    let (case, travelling) = as_assembly(&pair, ride);
    let (mut forces, mut gaps) = (Vec::new(), Vec::new());
    for scheme in [IMPLICIT, FILM] {
        let mut march =
            NonsmoothMarch::travelling(&case, std::slice::from_ref(&travelling), &[], settings(scheme, 2e-6))
                .unwrap();
        let energy = |march: &NonsmoothMarch<'_>| march.energy().kinetic + march.energy().potential;
        let (first, mut sum) = (energy(&march), 0.0);
        for _ in 0..20_000 {
            march.advance().unwrap();
            sum += march.force(0)[0];
        }
        let works = march.works();
        let gained = works.friction + works.normal + works.damping + works.circulation;
        let moved = works.friction.abs() + works.damping.abs();
        assert!((energy(&march) - first - gained).abs() < 1e-9 * moved, "{scheme:?}: {works:?}");
        forces.push(sum / 20_000.0);
        gaps.push(march.gap(0));
    }
    assert!((forces[0] - forces[1]).abs() < 1e-3 * forces[1], "{forces:?}");
    // a bump has thrown it
    assert!((gaps[0] - gaps[1]).abs() < 1e-3 * gaps[1] && gaps[1] > 1e-5, "{gaps:?}");
}

/// Impacts give no energy where a bump throws a point that is let go with half of its velocity, and what slides otherwise than is known is told.
#[test]
fn impacts_on_slopes_take_energy_and_known_sliding_is_watched() {
    let thrown = Ride { velocity: 0.8, bumps: 3e-5, damping: 0.5, ..CALM };
    let turning = Ride { velocity: 0.01, load: -4.0, bumps: 3e-4, damping: 0.02, ..CALM };
    let ridden = |ride: Ride, scheme: ContactScheme| {
        let (case, travelling) = as_assembly(&pair(ride), ride);
        let mut march =
            NonsmoothMarch::travelling(&case, std::slice::from_ref(&travelling), &[], settings(scheme, STEP))
                .unwrap();
        march.set_force_scale(1.0);
        (0..100_000).for_each(|_| march.advance().unwrap());
        (march.works(), march.record())
    };
    for restitution in [0.0, 0.5] {
        let (works, _) = ridden(thrown, ContactScheme::MoreauJean { restitution, implicitness: 0.5 });
        let (impacts, moved) = (works.normal - works.slope, works.normal.abs() + works.slope.abs());
        assert!(impacts < 1e-3 * moved && moved > 0.0, "{restitution}: {works:?}");
    }
    // downhill a point that rests on its track is not let go, whatever the restitution
    let (case, mut downhill) = as_assembly(&pair(CALM), CALM);
    downhill.nodes.iter_mut().for_each(|node| node.place[1] -= 1e-4 * (node.place[0] - START));
    let scheme = ContactScheme::MoreauJean { restitution: 0.5, implicitness: 0.5 };
    let mut march = NonsmoothMarch::travelling(&case, &[downhill], &[], settings(scheme, STEP)).unwrap();
    let pressed = (0..100_000).filter(|_| march.advance().is_ok() && march.force(0)[0] > 0.0).count();
    assert!(pressed > 99_000, "{pressed}");
    let (_, record) = ridden(turning, ContactScheme::KnownSliding);
    assert!(record.against > 100 && record.first_against.is_some(), "{record:?}");
    let (_, record) = ridden(CALM, ContactScheme::KnownSliding);
    assert_eq!((record.against, record.first_against), (0, None));
}

/// Modes above 800 Hz only yield: a step that is twenty times as long, beyond what the fastest of them allows, follows the ride; the balance of energy closes with what
/// they take.
#[test]
fn modes_that_only_yield_carry_what_is_slow() {
    let ride = Ride { interpolation: Interpolation::Hermite, bumps: 3e-6, velocity: 0.1, ..CALM };
    let pair = pair(ride);
    let (case, travelling) = as_assembly(&pair, ride);
    let means = [(2e-6, None), (2.5e-4, Some(800.0))].map(|(step, cut_off)| {
        let settings = NonsmoothSettings { cut_off, ..settings(FILM, step) };
        let mut march =
            NonsmoothMarch::travelling(&case, std::slice::from_ref(&travelling), &[], settings).unwrap();
        let energy = |march: &NonsmoothMarch<'_>| march.energy().kinetic + march.energy().potential;
        let (steps, first) = ((0.5 / step) as usize, energy(&march));
        let mut sums = [0.0; 2];
        for taken in 0..steps {
            march.advance().unwrap();
            if 2 * taken >= steps {
                let [normal, _, _] = march.force(0);
                sums[0] += normal / (steps - steps / 2) as f64;
                sums[1] += march.velocity(0)[1] / (steps - steps / 2) as f64;
            }
        }
        let works = march.works();
        let gained = works.friction + works.normal + works.damping + works.circulation + works.flexibility;
        let moved = works.friction.abs() + works.damping.abs();
        assert!((energy(&march) - first - gained).abs() < 1e-9 * moved, "{cut_off:?}: {works:?}");
        assert_eq!(works.flexibility != 0.0, cut_off.is_some());
        sums
    });
    assert!((means[0][0] - means[1][0]).abs() < 2e-3 * means[0][0], "{means:?}");
    let too_long = NonsmoothMarch::travelling(&case, &[travelling], &[], settings(FILM, 2.5e-4));
    assert!(matches!(too_long, Err(NonsmoothError::StepOverLimit { .. })), "{too_long:?}");
}

/// Springs at the points allow an explicit step that is the shorter, the softer the track is under them: one that fits where the ride begins is told where it no longer does. The springs of
/// the smoothed contact follow the place.
#[test]
fn steps_and_springs_are_those_of_the_place() {
    let ride = Ride { interpolation: Interpolation::Hermite, ..CALM };
    let (mut case, travelling) = as_assembly(&pair(ride), ride);
    let ridden = |case: &Assembly, scheme: ContactScheme, step: f64, until: f64| {
        let travelling = std::slice::from_ref(&travelling);
        NonsmoothMarch::travelling(case, travelling, &[], settings(scheme, step)).map(|mut march| {
            for _ in 0..(until / step) as u64 {
                march.advance()?;
            }
            // how far it gives in, per force
            Ok(-march.gap(0) / march.force(0)[0])
        })
    };
    let giving = |until: f64| ridden(&case, ContactScheme::Smoothed, 2e-5, until).unwrap().unwrap();
    let (early, late) = (giving(0.005), giving(0.1));
    assert!(early > 0.0 && late > 1.04 * early, "{early} {late}");
    case.interfaces[0].law =
        InterfaceLaw::Compliant(Pressure::PointStiffness(1e7), Friction::Constant(FRICTION));
    let Err(NonsmoothError::StepOverLimit { limit: first, .. }) = ridden(&case, FILM, 1.0, 0.0) else {
        panic!("too long")
    };
    let Ok(Err(NonsmoothError::StepOverLimit { step, limit })) = ridden(&case, FILM, 0.999 * first, 0.1)
    else {
        panic!("it fits everywhere")
    };
    assert!(step == 0.999 * first && limit < step, "{step} {limit}");
}

/// A march that goes on from what was written of it travels as if it had never stopped, to the bit.
#[test]
fn a_travelling_point_goes_on_from_its_checkpoint() {
    let ride = Ride { velocity: 0.8, bumps: 3e-5, damping: 0.5, ..CALM };
    let pair = pair(ride);
    let (case, travelling) = as_assembly(&pair, ride);
    for scheme in [IMPLICIT, FILM] {
        let new = || {
            let travelling = std::slice::from_ref(&travelling);
            NonsmoothMarch::travelling(&case, travelling, &[], settings(scheme, 2e-6)).unwrap()
        };
        let (mut whole, mut cut) = (new(), new());
        let text = |march: &NonsmoothMarch<'_>| serde_json::to_string(&march.checkpoint()).unwrap();
        for step in 1..=10_000 {
            whole.advance().unwrap();
            cut.advance().unwrap();
            if step % 777 == 0 {
                let kept = serde_json::from_str(&text(&cut)).unwrap();
                cut = new();
                cut.resume(&kept).unwrap();
                assert_eq!((cut.gap(0), cut.velocity(0)), (whole.gap(0), whole.velocity(0)), "{step}");
            }
        }
        assert_eq!(text(&whole), text(&cut), "{scheme:?}");
        let mut still = NonsmoothMarch::new(&case, &[], settings(scheme, 2e-6)).unwrap();
        assert_eq!(still.resume(&whole.checkpoint()), Err(NonsmoothError::ForeignCheckpoint));
    }
}

/// The implicit scheme closes gaps at velocities: off the edge it drifts by the square of the step.
#[test]
fn the_implicit_scheme_drifts_by_the_square_of_the_step() {
    let ride = Ride { interpolation: Interpolation::Hermite, ..CALM };
    let (case, travelling) = as_assembly(&pair(ride), ride);
    let [coarse, fine] = [4e-6, 2e-6].map(|step| {
        let mut march = NonsmoothMarch::travelling(
            &case,
            std::slice::from_ref(&travelling),
            &[],
            settings(IMPLICIT, step),
        )
        .unwrap();
        (0..(0.04 / step) as u64).fold(0.0_f64, |most, _| {
            march.advance().unwrap();
            most.max(march.gap(0).abs())
        })
    });
    assert!((3.5..4.5).contains(&(coarse / fine)) && coarse < 1e-12, "{coarse:e} {fine:e}");
}

#[test]
fn a_point_that_leaves_its_track_is_told() {
    let pair = pair(CALM);
    let (case, travelling) = as_assembly(&pair, Ride { velocity: 4.0, ..CALM });
    let mut march = NonsmoothMarch::travelling(&case, &[travelling], &[], settings(FILM, 2e-6)).unwrap();
    let error = (0..20_000).find_map(|_| march.advance().err()).unwrap();
    let NonsmoothError::RunOff { interface, point, end, time } = error else { panic!("{error}") };
    assert_eq!((interface.as_str(), point, end), ("sole", 1, RunOff::Last));
    assert!((time - (0.1 - START) / 4.0).abs() < 1e-4, "{time}");
}
