//! Growth with the contact held, measured in marches, against eigenvalues.
use crate::common;
use judder_contact::friction::Friction;
use judder_sliding::SlidingError;
use judder_sliding::coupling::SteadyFriction;
use judder_sliding::edge::{Interpolation, RunOff};
use judder_sliding::growth::{GrowthSettings, Held, frozen_growth};
use judder_sliding::locus::{Conditions, Configuration, LocusSettings, locus, spectrum};
use judder_sliding::march::{ContactMethod, March, MarchSettings, MarchStart, Predictor};
use judder_sliding::pair::Pair;
use judder_sliding::spectrum::WantedEigenvalues;
use judder_sliding::statics::PairEquilibrium;
use judder_sliding::zones::Zone;
use std::f64::consts::TAU;

fn conditions(configuration: Configuration) -> Conditions {
    Conditions { configuration, is_damped: true, velocity: common::SPEED, load: common::LOAD }
}

/// The zones of the paper's path, those of largest growth first.
fn zones(pair: &Pair, configuration: Configuration) -> Vec<Zone> {
    let positions = vec![0.010, 0.0985];
    let settings = LocusSettings { conditions: conditions(configuration), count: 20, positions };
    let mut zones = locus(pair, &settings).unwrap().followed.zones;
    zones.sort_by(|a, b| b.growth_rate.total_cmp(&a.growth_rate));
    zones
}

/// Measured growth agrees with the eigenvalue to 1 % where the pair grows fastest in each zone.
fn growth_agrees(pair: &Pair, method: ContactMethod, configuration: Configuration, step: f64) {
    let zones = zones(pair, configuration);
    assert!(zones.len() >= 4, "{zones:?}");
    growth_agrees_in(&zones[..zones.len().min(5)], pair, method, configuration, step);
}

fn growth_agrees_in(
    zones: &[Zone],
    pair: &Pair,
    method: ContactMethod,
    configuration: Configuration,
    step: f64,
) {
    for zone in zones {
        // growth may be largest where it jumps, at a corner of the edge, over which the contact would swing: a micrometre beside it
        let position = zone.peak + (0.5 * (zone.from + zone.to) - zone.peak).clamp(-1e-6, 1e-6);
        let settings = GrowthSettings { method, step, position, velocity: common::SPEED, load: common::LOAD };
        let held = Held::new(pair, &settings).unwrap();
        let conditions = conditions(configuration);
        let all = spectrum(pair, &conditions, position, WantedEigenvalues::Lowest(20)).unwrap().eigenvalues;
        let fastest = all.iter().copied().max_by(|a, b| a.re.total_cmp(&b.re)).unwrap();
        let growth = frozen_growth(pair, &settings, &held, fastest).unwrap();
        println!(
            "{method:?} {:.3} mm, {:.2} Hz: measured {:.4}, predicted {:.4}, halves differ by {:.1e}, {:.4} Hz off",
            position * 1e3,
            fastest.im / TAU,
            growth.measured.re,
            fastest.re,
            growth.spread,
            (growth.measured.im - fastest.im) / TAU
        );
        assert!((growth.measured.re / fastest.re - 1.0).abs() < 1e-2, "{growth:?}");
    }
}

#[test]
fn subs_grows_as_the_undeformed_eigenvalue() {
    let method = ContactMethod::Subs { static_slope: false };
    growth_agrees(&common::pair(), method, Configuration::Undeformed, 3e-7);
}

#[test]
fn ensubs_grows_as_the_deformed_eigenvalue() {
    growth_agrees(&common::pair(), ContactMethod::EnSubs, Configuration::Deformed, 3e-7);
}

/// So it does by FiLM, whose contact slides while it is held: the friction that turns with the sliding velocity is that of the eigenvalue.
#[test]
fn film_grows_as_the_deformed_eigenvalue() {
    let pair = common::pair();
    let zones = zones(&pair, Configuration::Deformed);
    growth_agrees_in(&zones[..3], &pair, ContactMethod::Film, Configuration::Deformed, 3e-7);
}

/// So does the march with residual flexibility, whose step is eight times as long.
#[test]
fn residual_flexibility_grows_as_the_deformed_eigenvalue() {
    let method = ContactMethod::ResidualFlexibility { cut_off: 150e3 };
    growth_agrees(&common::pair(), method, Configuration::Deformed, 1.2e-6);
}

/// So it does on a smooth edge, straight and curved: the bulge of 0.1 mm lies in C's way before the load deforms anything.
#[test]
fn growth_agrees_on_a_smooth_edge() {
    let friction = Friction::Constant(common::FRICTION);
    let straight = common::pair_with(Interpolation::Hermite, friction, 20);
    let curved = common::bulging(&straight, 1e-4);
    assert!(curved.undeformed(0.074).unwrap().gap < -5e-5);
    for pair in [straight, curved] {
        let configuration = Configuration::Deformed;
        let zones = zones(&pair, configuration);
        assert!(zones.len() >= 3, "{zones:?}");
        growth_agrees_in(&zones[..3], &pair, ContactMethod::EnSubs, configuration, 3e-7);
    }
}

/// A mode that does not swing, and a state of another pair, are refused; neither hangs nor panics.
#[test]
fn growth_of_nothing_is_refused() {
    let pair = common::pair();
    let method = ContactMethod::EnSubs;
    let settings =
        GrowthSettings { method, step: 3e-7, position: 0.074, velocity: common::SPEED, load: common::LOAD };
    let held = Held::new(&pair, &settings).unwrap();
    let still = frozen_growth(&pair, &settings, &held, num_complex::Complex64::new(-3.0, 0.0));
    assert!(matches!(still, Err(SlidingError::InvalidNumber { .. })), "{still:?}");
    let short = MarchStart { now: vec![0.0], before: vec![0.0], forces: [[0.0; 2]; 2] };
    let settings =
        MarchSettings { method, predictor: Predictor::default(), step: 3e-7, motion: common::motion() };
    let refused = March::held(&pair, settings, &short).err();
    assert!(matches!(refused, Some(SlidingError::Length { .. })), "{refused:?}");
}

/// A contact ten nanometres from the end of the track: the mode that swings along the track carries it beyond, and that is said with its
/// place; one that starts beyond is off the track.
#[test]
fn a_contact_that_swings_off_the_track_is_named() {
    let pair = common::pair();
    let sliding = SteadyFriction::at(pair.friction(), common::SPEED);
    let nodes = pair.node_positions();
    let reached = |position: f64| {
        let at = PairEquilibrium::new(&pair, position, common::LOAD, sliding).unwrap().touch.at;
        nodes[at.segment] + at.fraction * (nodes[at.segment + 1] - nodes[at.segment])
    };
    let position = (0..6).fold(0.0999, |position, _| position + pair.length() - 1e-8 - reached(position));
    let (method, step) = (ContactMethod::EnSubs, 3e-7);
    let settings = GrowthSettings { method, step, position, velocity: common::SPEED, load: common::LOAD };
    let held = Held::new(&pair, &settings).unwrap();
    let conditions = conditions(Configuration::Deformed);
    let all = spectrum(&pair, &conditions, position, WantedEigenvalues::Lowest(6)).unwrap().eigenvalues;
    let errors: Vec<SlidingError> = all
        .into_iter()
        .filter(|s| s.im > 1e3)
        .filter_map(|s| frozen_growth(&pair, &settings, &held, s).err())
        .collect();
    let runs_off = SlidingError::RunsOff { position, length: pair.length(), end: RunOff::Last };
    assert!(errors.contains(&runs_off), "{errors:?}");
    assert!(
        runs_off
            .to_string()
            .contains("held at 0.0999796 m the contact has run off the track beyond its last node"),
        "{runs_off}"
    );
    let beyond = GrowthSettings { position: pair.length() + 1e-3, ..settings };
    let refused = Held::new(&pair, &beyond).err();
    assert!(matches!(refused, Some(SlidingError::OffTrack { .. })), "{refused:?}");
}
