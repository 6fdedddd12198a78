//! What is wrong is named with its place: in the track, in a list, along the path.

use crate::common;
use judder_contact::friction::Friction;
use judder_numerics::words::plain;
use judder_sliding::SlidingError;
use judder_sliding::coupling::SteadyFriction;
use judder_sliding::edge::{Interpolation, RunOff};
use judder_sliding::march::{
    ContactMethod, ContactState, March, MarchSample, MarchSettings, Predictor, Reached,
};
use judder_sliding::motion::{Motion, Ramps};
use judder_sliding::pair::{Pair, Slider, TrackBody};
use judder_sliding::statics::PairEquilibrium;

const STEP: f64 = 3e-7;

fn built(pair: &Pair, change: impl FnOnce(&mut Slider, &mut TrackBody)) -> Result<Pair, SlidingError> {
    let (mut slider, mut track) = (pair.slider().clone(), pair.track().clone());
    change(&mut slider, &mut track);
    let interpolation = Interpolation::Linear;
    Pair::new(slider, track, interpolation, true, pair.friction().clone(), pair.observed().to_vec())
}

fn refused(pair: &Pair, change: impl FnOnce(&mut Slider, &mut TrackBody)) -> String {
    built(pair, change).unwrap_err().to_string()
}

fn marched(pair: &Pair, method: ContactMethod, step: f64, motion: Motion) -> Result<Reached, SlidingError> {
    let settings = MarchSettings { method, predictor: Predictor::default(), step, motion };
    March::new(pair, settings)?.advance(20_000, &mut |_: &MarchSample, _: &[f64]| ())
}

/// A contact point beside the track, at the start, at the end, at rest: with its position and the track's length.
#[test]
fn a_contact_point_beside_the_track_is_told_with_its_position() {
    let pair = common::pair();
    let sliding = SteadyFriction::at(pair.friction(), common::SPEED);
    let motion = common::motion();
    let errors = [
        pair.undeformed(-1e-3).map(|_| ()),
        PairEquilibrium::new(&pair, -1e-3, common::LOAD, sliding).map(|_| ()),
        marched(&pair, ContactMethod::EnSubs, STEP, Motion { start: -1e-3, ..motion }).map(|_| ()),
        marched(&pair, ContactMethod::Film, STEP, Motion { end: 0.5, ..motion }).map(|_| ()),
        pair.undeformed(f64::NAN).map(|_| ()),
    ]
    .map(|result| result.unwrap_err().to_string());
    for (error, position) in errors.iter().zip(["-0.001", "-0.001", "-0.001", "0.5", "NaN"]) {
        assert!(error.contains(&format!("off the track: {position} m")), "{error}");
        assert!(error.contains(" 0.1 m long"), "{error}");
    }
}

/// A track whose nodes do not follow each other: with the node, where it lies, and by how much it turns there.
#[test]
fn an_unordered_track_is_told_with_its_node() {
    let pair = common::pair();
    let swapped = refused(&pair, |_, track| track.nodes.swap(40, 41));
    assert!(swapped.contains("from node 40 to the next it turns back by 180°"), "{swapped}");
    assert!(swapped.contains("(0.041, "), "{swapped}");
    let twice = refused(&pair, |_, track| track.nodes[7] = track.nodes[6].clone());
    assert!(twice.contains("from node 6 "), "{twice}");
    let single = refused(&pair, |_, track| track.nodes.truncate(1));
    assert!(single.contains("two nodes at least, this one has 1"), "{single}");
}

/// A number that is none, in any list of either structure: with the list and the entry.
#[test]
fn a_number_that_is_none_is_told_with_its_entry() {
    let pair = common::pair();
    let errors = [
        (
            refused(&pair, |slider, _| slider.body.eigenvalues[3] = f64::NAN),
            "ω² of mode 4 of the slider is NaN",
        ),
        (refused(&pair, |_, track| track.body.beta = f64::INFINITY), "β of the track is inf"),
        (refused(&pair, |slider, _| slider.load[2] = f64::NAN), "entry 3 of the slider's load is NaN"),
        (
            refused(&pair, |slider, _| slider.contact.rows[1][5] = f64::NAN),
            "entry 6 of the y row of the contact point",
        ),
        (
            refused(&pair, |_, track| track.nodes[9].rows[0][1] = f64::NAN),
            "entry 2 of the x row of node 9 of the track",
        ),
        (
            refused(&pair, |_, track| track.nodes[9].place[1] = f64::NAN),
            "entry 2 of the place of node 9 of the track",
        ),
    ];
    for (error, expected) in errors {
        assert!(error.contains(expected) && error.contains("must be finite"), "{error}");
    }
    let short = refused(&pair, |_, track| track.nodes[9].rows[0].truncate(3));
    assert!(short.contains("a row of node 9 of the track has 3 entries"), "{short}");
}

/// A step over the limit, with both; a slider that locks and one that the load lifts, each with its position.
#[test]
fn a_march_that_cannot_go_on_says_where() {
    let pair = common::pair();
    let over = marched(&pair, ContactMethod::EnSubs, 1e-6, common::motion()).unwrap_err();
    assert!(over.to_string().contains("step of 1e-6 s is over its limit of 3.6"), "{over}");
    let friction = Friction::Constant(30.0);
    let locking = common::pair_with(Interpolation::Linear, friction, 20);
    let at_once = Ramps { friction: 0.0, ..common::motion().ramps };
    let motion = Motion { start: 0.02, ramps: at_once, ..common::motion() };
    let locked = marched(&locking, ContactMethod::EnSubs, STEP, motion).unwrap_err();
    assert!(locked.to_string().contains("sprag-slip at 0.02 m"), "{locked}");
    let sliding = SteadyFriction::at(pair.friction(), common::SPEED);
    let lifted = PairEquilibrium::new(&pair, 0.02, -common::LOAD, sliding).unwrap_err();
    let expected = "nothing holds the pair at rest at 0.02 m: the load pulls the slider off the track";
    assert_eq!(lifted.to_string(), expected);
}

/// A load that lifts the slider off in the middle of a march is a state, not an error: what was computed stands, nothing pulls.
#[test]
fn a_load_that_lifts_off_is_a_state() {
    let pair = common::pair();
    for method in [ContactMethod::EnSubs, ContactMethod::Film] {
        let motion = Motion { load: -common::LOAD, ..common::motion() };
        let settings = MarchSettings { method, predictor: Predictor::default(), step: STEP, motion };
        let mut march = March::new(&pair, settings).unwrap();
        let (mut open, mut least) = (0_u32, f64::INFINITY);
        let mut take = |sample: &MarchSample, _: &[f64]| {
            open += u32::from(sample.state == ContactState::LiftOff);
            least = least.min(sample.normal_force);
        };
        assert_eq!(march.advance(20_000, &mut take), Ok(Reached::Steps), "{method:?}");
        assert!(open > 10_000 && least == 0.0, "{method:?}: {open} {least}");
    }
}

/// It flies on until it is farther from the track than that is long: then the march ends, and says that the slider has lifted off, where
/// and how far. So it does where C leaves the track sideways while it rises.
#[test]
fn a_slider_that_flies_away_has_lifted_off() {
    let pair = common::pair();
    let ramps = Ramps { velocity: 2e-3, load: 2e-3, friction: 2e-3, gap: 0.0 };
    for (method, start) in
        [(ContactMethod::EnSubs, 0.01), (ContactMethod::Film, 0.01), (ContactMethod::EnSubs, 0.09)]
    {
        let motion = Motion { start, load: -common::LOAD, ramps, ..common::motion() };
        let settings = MarchSettings { method, predictor: Predictor::default(), step: STEP, motion };
        let mut march = March::new(&pair, settings).unwrap();
        let mut last = 0.0;
        let ended = march.advance(1_000_000, &mut |sample: &MarchSample, _: &[f64]| last = sample.gap);
        let Err(SlidingError::LiftedOff { position, gap }) = ended else { panic!("{method:?}: {ended:?}") };
        assert!((start..start + 3e-3).contains(&position), "{method:?}: {position}");
        assert!(gap > 0.01 && (gap - last).abs() < 1e-5, "{method:?}: {gap} {last}");
        let message = ended.unwrap_err().to_string();
        assert!(
            message.contains("lifted off") && message.contains(&format!("{} m", plain(gap))),
            "{message}"
        );
    }
}

/// Friction so large that a mode grows without bound throws C beyond an end of the track. That is growth, not the end of the track, while
/// the frame is far from it, and also near it, where C leaps. A frame that comes to the end runs off there, and which end it was is told.
#[test]
fn growth_without_bound_is_not_the_end_of_the_track() {
    let rough = common::pair_with(Interpolation::Linear, Friction::Constant(9.0), 20);
    let marched = |pair: &Pair, motion: Motion| {
        let settings = MarchSettings {
            method: ContactMethod::EnSubs,
            predictor: Predictor::default(),
            step: STEP,
            motion,
        };
        March::new(pair, settings).unwrap().advance(400_000, &mut |_: &MarchSample, _: &[f64]| ())
    };
    // such growth is chaotic: some of the marches lock or fly away before it ends them
    let mut grown = 0;
    for start in [0.01, 0.02, 0.03, 0.05, 0.06, 0.07, 0.08, 0.09, 0.095] {
        match marched(&rough, Motion { start, ..common::motion() }) {
            Err(SlidingError::NotFinite { .. }) => grown += 1,
            Err(SlidingError::SpragSlip { .. } | SlidingError::LiftedOff { .. }) => (),
            other => panic!("{start}: {other:?}"),
        }
    }
    assert!(grown > 1, "{grown}");
    let end = marched(&common::pair(), Motion { start: 0.0985, end: 0.1, ..common::motion() });
    assert_eq!(end, Ok(Reached::RunOff(RunOff::Last)));
    assert_eq!(RunOff::Last.to_string(), "run off the track beyond its last node");
}

/// A gap or penetration of a micrometre at the start is closed smoothly over its ramp, on a straight and on a smooth edge: from step to
/// step the normal force jumps by less than 1e-4 of the load. A ramp so short that the growing load cannot keep the slider down lets it
/// lift off, a state of its own; up to there the same holds. Without a ramp it is refused, with its place and size.
#[test]
fn an_initial_gap_is_never_a_kick() {
    for interpolation in [Interpolation::Linear, Interpolation::Hermite] {
        let friction = Friction::Constant(common::FRICTION);
        let pair = common::pair_with(interpolation, friction, 20);
        for (gap, duration) in [(1e-6, 0.1), (-1e-6, 0.1), (1e-6, 3e-3), (-1e-6, 3e-3)] {
            let ramps = Ramps { gap: duration, ..common::motion().ramps };
            let motion = Motion { start: 0.05, initial_gap: gap, ramps, ..common::motion() };
            for method in [ContactMethod::EnSubs, ContactMethod::Film] {
                let settings = MarchSettings { method, predictor: Predictor::default(), step: STEP, motion };
                let mut march = March::new(&pair, settings).unwrap();
                let (mut before, mut largest, mut is_off) = (0.0, 0.0_f64, false);
                let is_slow = duration >= common::motion().ramps.load;
                let mut take = |sample: &MarchSample, _: &[f64]| {
                    is_off |= sample.state == ContactState::LiftOff && !is_slow;
                    if is_off {
                        return;
                    }
                    largest = largest.max((sample.normal_force - before).abs());
                    before = sample.normal_force;
                };
                march.advance(100_000, &mut take).unwrap();
                let bound = 1e-4 * common::LOAD.abs();
                assert!(largest < bound, "{interpolation} {gap} {duration} {method:?}: {largest} N");
            }
            let at_once = Ramps { gap: 0.0, ..common::motion().ramps };
            let kick =
                marched(&pair, ContactMethod::EnSubs, STEP, Motion { ramps: at_once, ..motion }).unwrap_err();
            let size = if gap > 0.0 {
                "1e-6 m from the track (a gap)"
            } else {
                "-1e-6 m from the track (a penetration)"
            };
            assert!(kick.to_string().contains("at the start, 0.05 m, C is "), "{kick}");
            assert!(kick.to_string().contains(size), "{kick}");
        }
    }
}
