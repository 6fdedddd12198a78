//! A mass on a belt with friction that falls: its stick-slip cycle, against the motion itself.

use super::own_engine::{known, off_nearest, order, settled, told, worst};
use crate::common::{assembly, diagonal, point_on_plane};
use crate::growing;
use faer::c64;
use judder_assembly::assembly::Assembly;
use judder_assembly::friction::{FallingFriction, Friction};
use judder_assembly::interface::InterfaceLaw;
use judder_cycles::backbone::{BackboneEnd, BackboneSettings, backbone};
use judder_cycles::balance::HarmonicBalance;
use judder_cycles::cycle::{CycleSettings, HarmonicCount, limit_cycles};
use judder_cycles::series::Series;
use judder_cycles::shooting::{ShootingSettings, shoot};
use judder_cycles::stability::shot_multipliers;
use judder_oscillator::motion::{BeltOscillator, ContactState};
use std::f64::consts::TAU;

pub(super) const FALLING: FallingFriction = FallingFriction::exponential([0.4, 0.2], 0.5);
const SPEED: f64 = 0.3;
const DAMPING: f64 = 0.02;
const STIFFNESS: f64 = 100.0;

/// 1 kg on 100 N/m, pressed with 1 N on a belt at 0.3 m/s.
pub(super) fn mass_on_belt() -> Assembly {
    assembly(
        [diagonal(&[1.0; 2]), diagonal(&[DAMPING, 0.0]), diagonal(&[STIFFNESS, 0.0])],
        vec![0.0, -1.0],
        vec![point_on_plane(&[0, 1], SPEED, 0.0)],
        InterfaceLaw::Rigid(Friction::Falling(FALLING)),
    )
}

/// ω in rad/s, the share of stick, the root mean square of the velocity: the mass leaves the belt where the spring overcomes μ(0), slides until it is as fast
/// as the belt again (Runge–Kutta of the fourth order), and is carried back to where it left.
pub(super) fn by_the_motion_itself() -> [f64; 3] {
    const STEP: f64 = 1e-5;
    let rate =
        |[x, v]: [f64; 2]| [v, FALLING.at((v - SPEED).abs()).coefficient - DAMPING * v - STIFFNESS * x];
    let leaves = (FALLING.at_rest - DAMPING * SPEED) / STIFFNESS;
    let along = |[x, v]: [f64; 2], [dx, dv]: [f64; 2], by: f64| [x + by * dx, v + by * dv];
    let mut at = [leaves + 1e-12, SPEED - 1e-12];
    let (mut time, mut squared, mut steps) = (0.0, 0.0, 0_u64);
    loop {
        let k1 = rate(at);
        let k2 = rate(along(at, k1, 0.5 * STEP));
        let k3 = rate(along(at, k2, 0.5 * STEP));
        let k4 = rate(along(at, k3, STEP));
        let next = [0, 1].map(|i| at[i] + STEP / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
        let share = if next[1] > SPEED && steps > 1000 { (SPEED - at[1]) / (next[1] - at[1]) } else { 1.0 };
        time += share * STEP;
        squared += share * STEP * 0.5 * (at[1] * at[1] + next[1].min(SPEED) * next[1].min(SPEED));
        at = [at[0] + share * (next[0] - at[0]), next[1].min(SPEED)];
        steps += 1;
        if share < 1.0 {
            break;
        }
    }
    let stuck = (leaves - at[0]) / SPEED;
    let period = time + stuck;
    [std::f64::consts::TAU / period, stuck / period, ((squared + SPEED * SPEED * stuck) / period).sqrt()]
}

/// The mass of the literature, μ = 0.5 + 0.5 e^{−v/0.5}, ξ = 0.05, N = 1, at v = 1, against the engine of the oscillator.
///
/// As the mass is caught its velocity has a kink, of which H harmonics leave H^{−3/2} out in the mean square; period and root mean square follow that, whatever the number of instants. What a
/// march that comes back is off by is of first order in its steps, so that two of them tell what is left without steps.
#[test]
fn a_mass_sticks_and_slips_as_in_the_engine_of_the_oscillator() {
    const FALLING: FallingFriction = FallingFriction::exponential([1.0, 0.5], 0.5);
    let belt = BeltOscillator::new(0.05, 1.0, 1.0, FALLING).unwrap();
    let own = settled(&belt, [1.0, 1.0]);
    assert_eq!(own.around.pattern, [ContactState::SlipBehind, ContactState::Stick]);
    let expected = known(&belt, &own);
    let case = assembly(
        [diagonal(&[1.0; 2]), diagonal(&[0.1, 0.0]), diagonal(&[1.0, 0.0])],
        vec![0.0, -1.0],
        vec![point_on_plane(&[0, 1], 1.0, 0.0)],
        InterfaceLaw::Rigid(Friction::Falling(FALLING)),
    );
    let (steady, values) = growing(&case, [0.5, 2.0]);
    let with = |[harmonics, samples]: [usize; 2]| {
        let settings =
            CycleSettings { harmonics: HarmonicCount::Fixed(harmonics), samples, ..CycleSettings::default() };
        let found = limit_cycles(&case, &steady, values[0], &settings, &|| true).unwrap();
        found.cycles.into_iter().next().unwrap()
    };
    let errors = [[40, 16], [80, 16], [160, 16], [80, 64]].map(|counts| {
        let errors = expected.errors(&with(counts));
        println!("{counts:?}: {}", told(&errors));
        errors
    });
    for k in [0, 1] {
        let [first, middle, last, finer] = [0, 1, 2, 3].map(|which: usize| errors[which][k].abs());
        let found = order([(40, first), (160, last)]);
        println!("order of {}: {found:.2}", ["the period", "x"][k]);
        assert!((1.3..1.7).contains(&found), "{found}");
        assert!((finer / middle - 1.0).abs() < 0.01, "{finer} {middle}");
    }
    let near = with([40, 16]);
    let [few, many] = [2048, 4096].map(|steps| {
        let settings = ShootingSettings { steps, ..ShootingSettings::default() };
        let shot = shoot(&case, &near.balance, &near.motion, &settings, &|| true).unwrap();
        let velocity = shot.statistics.of(0).unwrap().tangential_velocity_rms;
        [TAU / shot.frequency / expected.period - 1.0, velocity / expected.rms[1] - 1.0]
    });
    let left = [0, 1].map(|k| 2.0 * many[k] - few[k]);
    println!("march: {}", told(&[few, many, left].concat()));
    assert!([0, 1].iter().all(|k| (few[*k] / many[*k] - 2.0).abs() < 0.01), "{few:?} {many:?}");
    assert!(worst(&left) < 1e-6, "{left:?}");
}

/// The engine has 1 and 0, as whatever differs is caught; of the two freedoms of the assembly one is held besides.
#[test]
fn a_mass_that_sticks_has_the_multipliers_of_the_engine_of_the_oscillator_by_a_march() {
    const FALLING: FallingFriction = FallingFriction::exponential([1.0, 0.5], 0.5);
    let belt = BeltOscillator::new(0.05, 1.0, 1.0, FALLING).unwrap();
    let own = settled(&belt, [1.0, 1.0]);
    assert!(off_nearest(&own.multipliers, &[c64::ONE, c64::ZERO]) < 1e-9, "{:?}", own.multipliers);
    let case = slow_mass_on_belt([0.1, 1.0], FALLING);
    let (steady, values) = growing(&case, [0.5, 2.0]);
    let settings = CycleSettings { harmonics: HarmonicCount::Fixed(40), ..CycleSettings::default() };
    let found = limit_cycles(&case, &steady, values[0], &settings, &|| true).unwrap();
    let near = (&found.cycles[0].balance, &found.cycles[0].motion);
    let counts = [1024, 4096];
    let off = counts.map(|steps| {
        let settings = ShootingSettings { steps, tolerance: 1e-9, ..ShootingSettings::default() };
        let shot = shoot(&case, near.0, near.1, &settings, &|| true).unwrap();
        let found = shot_multipliers(&case, near, (&shot, &settings), &|| true).unwrap().unwrap();
        let off = (found.phase.unwrap() - c64::ONE).norm();
        println!("{steps}: {off:.1e}, told {:.1e}", found.error);
        assert!(off < found.error && found.values.iter().all(|own| own.norm() < 1e-9), "{found:?}");
        off
    });
    let found = order([(counts[0], off[0]), (counts[1], off[1])]);
    println!("order: {found:.2}");
    assert!(off[1] < 1e-6 && (1.5..2.5).contains(&found), "{off:?}");
}

/// Friction jumps where the mass is caught, so that the error falls slowly with the number of harmonics.
#[test]
fn a_mass_sticks_and_slips_as_the_motion_itself_does() {
    let case = mass_on_belt();
    let (steady, values) = growing(&case, [5.0, 20.0]);
    let [frequency, _, rms] = by_the_motion_itself();
    let errors = [10, 40, 160].map(|harmonics| {
        let settings =
            CycleSettings { harmonics: HarmonicCount::Fixed(harmonics), ..CycleSettings::default() };
        let found = limit_cycles(&case, &steady, values[0], &settings, &|| true).unwrap();
        let cycle = &found.cycles[0];
        assert!(cycle.attracts == Some(true) && cycle.held_back.is_none());
        assert_eq!(cycle.balance.series().harmonics(), harmonics);
        let [stick, slip, open] = cycle.points[0].shares;
        assert!(stick > 0.0 && (stick + slip - 1.0).abs() < 1e-12 && open == 0.0);
        [cycle.frequency() / frequency - 1.0, cycle.points[0].tangential_velocity_rms / rms - 1.0]
    });
    let largest = errors.map(|own| own[0].abs().max(own[1].abs()));
    assert!(largest[1] < 5e-4 && largest[2] < 2e-4, "{errors:?}");
    assert!(largest[1] < 0.1 * largest[0], "{errors:?}");
}

/// 1 kg on 1 N/m with a damping in N s/m, on a belt at a speed.
pub(super) fn slow_mass_on_belt([damping, speed]: [f64; 2], falling: FallingFriction) -> Assembly {
    assembly(
        [diagonal(&[1.0; 2]), diagonal(&[damping, 0.0]), diagonal(&[1.0, 0.0])],
        vec![0.0, -1.0],
        vec![point_on_plane(&[0, 1], speed, 0.0)],
        InterfaceLaw::Rigid(Friction::Falling(falling)),
    )
}

/// At 0.9 m/s motions with three harmonics turn sharply where the mass first sticks, and lead on to the cycle.
#[test]
fn a_cycle_is_found_behind_a_kink_at_which_the_path_turns_sharply() {
    let belt = BeltOscillator::new(0.025, 1.0, 0.9, FALLING).unwrap();
    let expected = known(&belt, &settled(&belt, [0.3, 0.9]));
    let case = slow_mass_on_belt([0.05, 0.9], FALLING);
    let (steady, values) = growing(&case, [0.5, 2.0]);
    let found = limit_cycles(&case, &steady, values[0], &CycleSettings::default(), &|| true).unwrap();
    assert_eq!(found.followed_with, [3]);
    assert_eq!(found.cycles[0].attracts, Some(true));
    let errors = expected.errors(&found.cycles[0]);
    println!("{}", told(&errors));
    assert!(worst(&errors) < 2e-3, "{errors:?}");
}

/// The mass has one cycle. Beyond it motions go on to any amplitude, over kinks at which they all but turn back on the way that they came: at 0.6 m/s with three harmonics by 170 degrees.
#[test]
fn motions_go_on_behind_every_kink() {
    for speed in [0.3, 0.415, 0.52, 0.59, 0.6, 0.73, 0.835, 0.94] {
        let case = slow_mass_on_belt([0.05, speed], FALLING);
        let (steady, values) = growing(&case, [0.5, 2.0]);
        for harmonics in [3, 7, 15] {
            let series = Series::new(harmonics, 16 * harmonics);
            let balance = HarmonicBalance::new(&case, &steady, values[0].im, series, &[]).unwrap();
            let settings = BackboneSettings { cycles: 2, ..BackboneSettings::default() };
            let found = backbone(&balance, &steady, values[0], &settings, &|| true).unwrap();
            assert_eq!((found.end, found.cycles.len()), (BackboneEnd::Largest, 1), "{speed} {harmonics}");
        }
    }
}
