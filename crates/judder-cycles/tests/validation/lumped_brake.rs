//! The lumped brake of S. Hultén with cubic stiffness: a mass between two plates that slide along each other's normals.
//!
//! Equations as of J.-J. Sinou, L. Jézéquel, *Mode coupling instability in friction-induced vibrations and its dependency on system parameters including damping*, Eur. J.
//! Mech. A/Solids 26 (2007), after S. Hultén (Machinery Acoustics, KTH, 1993):
//!
//! ```text
//! ẍ₁ + η₁ω₁ẋ₁ + ω₁²x₁ + φ₁x₁³ − μ (ω₂²x₂ + φ₂x₂³) = 0
//! ẍ₂ + η₂ω₂ẋ₂ + ω₂²x₂ + φ₂x₂³ + μ (ω₁²x₁ + φ₁x₁³) = 0
//! ```

use super::own_engine::off_nearest;
use crate::common::{assembly, diagonal, point_on_plane};
use crate::growing;
use faer::c64;
use judder_assembly::assembly::Assembly;
use judder_assembly::compliance::Compliance;
use judder_assembly::contact_point::ContactPoint;
use judder_assembly::friction::Friction;
use judder_assembly::interface::{Interface, InterfaceLaw};
use judder_assembly::linearised::{Linearised, LinearisedTerms};
use judder_assembly::pressure::{CubicPointForce, Pressure};
use judder_assembly::row::Row;
use judder_assembly::steady::steady_sliding;
use judder_cycles::CyclesError;
use judder_cycles::backbone::PeriodicMotion;
use judder_cycles::branch::{BranchSettings, CycleBranchEnd, cycle_branch};
use judder_cycles::cycle::{CycleSettings, HarmonicCount, limit_cycles};
use judder_cycles::path::PathRule;
use judder_cycles::stability::{HILL_ROWS, floquet_multipliers, hill_multipliers};
use judder_structure::complex_modes::{ComplexModeSettings, Region, complex_modes};
use std::f64::consts::TAU;

/// ω₁ and ω₂ in rad/s.
const OMEGA: [f64; 2] = [TAU * 100.0, TAU * 75.0];
/// η of both.
const LOSS: f64 = 0.02;
/// The displacement of the first plate at which its cube presses as much as what is linear, in m; φ₂ = 0.
const BEND: f64 = 1e-3;
/// How far both are pressed in steady sliding, so that they never lift off, in m.
const CLOSURE: f64 = 1.5e-3;
/// So fast that friction never turns, in m/s.
const SPEED: f64 = 10.0;

fn linear() -> [f64; 2] {
    OMEGA.map(|omega| omega * omega)
}

fn damping() -> [f64; 2] {
    OMEGA.map(|omega| LOSS * omega)
}

/// 1 kg on two plates, of which each drags along the normal of the other.
fn brake(friction: f64) -> Assembly {
    let plate = |k: usize, point: ContactPoint| {
        let stiffness = linear()[k];
        let pressure = match k {
            0 => Pressure::PointCubic(CubicPointForce {
                stiffness,
                cubic_stiffness: stiffness / (BEND * BEND),
                about: CLOSURE,
            }),
            _ => Pressure::PointStiffness(stiffness),
        };
        Interface {
            name: format!("plate {k}"),
            points: vec![point],
            law: InterfaceLaw::Compliant(pressure, Friction::Constant(friction)),
            all_closed: false,
        }
    };
    let relative = [0, 1, 2].map(|k: usize| Row::new((k < 2).then_some((k, 1.0)).into_iter().collect()));
    // what presses on x₁ drags along x₂ with −μN₁ = μ(ω₁²x₁ + …) on the left side, and the other way round
    let first = ContactPoint {
        normal: [1.0, 0.0, 0.0],
        velocity: [0.0, SPEED, 0.0],
        relative: relative.clone(),
        ..point_on_plane(&[0, 1], 0.0, 0.0)
    };
    let second = ContactPoint { velocity: [-SPEED, 0.0, 0.0], ..point_on_plane(&[0, 1], 0.0, 0.0) };
    let [k, l] = linear();
    let pressed = [k * CLOSURE * (1.0 + CLOSURE * CLOSURE / (BEND * BEND)), l * CLOSURE];
    let mut case = assembly(
        [diagonal(&[1.0; 2]), diagonal(&damping()), diagonal(&[0.0; 2])],
        vec![-pressed[0] + friction * pressed[1], -pressed[1] - friction * pressed[0]],
        Vec::new(),
        InterfaceLaw::Rigid(Friction::Constant(0.0)),
    );
    case.interfaces = vec![plate(0, first), plate(1, second)];
    case
}

/// μ at which the criterion of A. Hurwitz for s⁴ + a₃s³ + a₂s² + a₁s + a₀, a₃a₂a₁ = a₁² + a₃²a₀, holds, and ω = √(a₁/a₃) there.
fn hopf_point() -> [f64; 2] {
    let ([k, l], [c, d]) = (linear(), damping());
    let [a3, a2, a1] = [c + d, k + l + c * d, c * l + d * k];
    let a0 = (a3 * a2 * a1 - a1 * a1) / (a3 * a3);
    [(a0 / (k * l) - 1.0).sqrt(), (a1 / a3).sqrt()]
}

fn eigenvalue(friction: f64) -> c64 {
    let case = brake(friction);
    let steady = steady_sliding(&case, &Compliance::new(&case).unwrap()).unwrap();
    let about = Linearised::new(&case, &steady, LinearisedTerms::default()).unwrap();
    let region = Region { re: [-1e3, 1e3], im: [1.0, 1e3] };
    let found = complex_modes(&about.problem, &region, &ComplexModeSettings::default()).unwrap();
    let value = found.modes.iter().map(|mode| mode.eigenvalue.value).max_by(|a, b| a.re.total_cmp(&b.re));
    value.map(|value| c64::new(value.re, value.im)).unwrap()
}

#[test]
fn a_lumped_brake_begins_to_squeal_where_hurwitz_says() {
    let [friction, frequency] = hopf_point();
    let value = eigenvalue(friction);
    assert!(value.re.abs() < 1e-9 * frequency, "{value}");
    assert!((value.im / frequency - 1.0).abs() < 1e-12, "{value} {frequency}");
    assert!(eigenvalue(0.999 * friction).re < 0.0 && eigenvalue(1.001 * friction).re > 0.0);
}

/// ω, and the root mean squares of x₁ and x₂, of the motion that the printed equations come to: Runge–Kutta of the fourth order.
fn by_the_motion_itself(friction: f64) -> [f64; 3] {
    const STEP: f64 = 2e-5;
    const CYCLES: usize = 400;
    let [k, l] = linear();
    let [c, d] = damping();
    let rate = |[x, y, u, v]: [f64; 4]| {
        let [first, second] = [k * x * (1.0 + x * x / (BEND * BEND)), l * y];
        [u, v, -c * u - first + friction * second, -d * v - second - friction * first]
    };
    let along =
        |at: [f64; 4], d: [f64; 4], by: f64| -> [f64; 4] { std::array::from_fn(|k| at[k] + by * d[k]) };
    let mut at = [1e-3, 0.0, 0.0, 0.0];
    let mut crossings = 0;
    let (mut begun, mut time, mut squared) = (0.0, 0.0, [0.0; 2]);
    loop {
        let k1 = rate(at);
        let k2 = rate(along(at, k1, 0.5 * STEP));
        let k3 = rate(along(at, k2, 0.5 * STEP));
        let k4 = rate(along(at, k3, STEP));
        let next: [f64; 4] =
            std::array::from_fn(|i| at[i] + STEP / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
        assert!(next.iter().all(|own| own.is_finite()), "the motion grows without bound");
        let rises = at[0] < 0.0 && next[0] >= 0.0;
        // where x₁ passes through zero, by Hermite's cubic to the fourth order
        let share = if rises { passed(at[0], next[0], STEP * at[2], STEP * next[2]) } else { 1.0 };
        let area = |i: usize, share: f64| {
            let value = |t: f64| hermite([at[i], next[i], STEP * at[i + 2], STEP * next[i + 2]], t);
            let [a, b, c] = [0.0, 0.5 * share, share].map(|t| value(t) * value(t));
            share * STEP * (a + 4.0 * b + c) / 6.0
        };
        if rises {
            crossings += 1;
            if crossings == CYCLES {
                begun = time + share * STEP;
                squared = [0, 1].map(|i| area(i, 1.0) - area(i, share));
            } else if crossings == CYCLES + 10 {
                let period = (time + share * STEP - begun) / 10.0;
                let rms = [0, 1].map(|i| ((squared[i] + area(i, share)) / (10.0 * period)).sqrt());
                return [TAU / period, rms[0], rms[1]];
            } else {
                squared = [0, 1].map(|i| squared[i] + area(i, 1.0));
            }
        } else {
            squared = [0, 1].map(|i| squared[i] + area(i, 1.0));
        }
        time += STEP;
        at = next;
    }
}

fn hermite([a, b, u, v]: [f64; 4], t: f64) -> f64 {
    let (s, t2) = (1.0 - t, t * t);
    s * s * (1.0 + 2.0 * t) * a + t2 * (3.0 - 2.0 * t) * b + t * s * s * u - t2 * s * v
}

/// Where Hermite's cubic passes through zero, by bisection.
fn passed(a: f64, b: f64, u: f64, v: f64) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if hermite([a, b, u, v], middle) < 0.0 { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

#[test]
fn a_lumped_brake_comes_to_the_cycle_of_its_printed_equations() {
    const FRICTION: f64 = 0.35;
    let case = brake(FRICTION);
    let (steady, values) = growing(&case, [1.0, 1e3]);
    let expected = by_the_motion_itself(FRICTION);
    let errors = [3, 7, 15].map(|harmonics| {
        let settings =
            CycleSettings { harmonics: HarmonicCount::Fixed(harmonics), ..CycleSettings::default() };
        let found = limit_cycles(&case, &steady, values[0], &settings, &|| true).unwrap();
        let cycle = &found.cycles[0];
        let rms = [0, 1].map(|k| {
            let own = cycle.followed(&Row::new(vec![(k, 1.0)])).unwrap();
            own[1..].iter().map(|part| 0.5 * part * part).sum::<f64>().sqrt()
        });
        let own = [cycle.frequency(), rms[0], rms[1]];
        (0..3).map(|k| (own[k] / expected[k] - 1.0).abs()).fold(0.0, f64::max)
    });
    assert!(errors[2] < 1e-7, "{errors:?} {expected:?}");
    assert!(errors[1] < 1e-2 * errors[0], "{errors:?}");
}

/// The branch of cycles shrinks to steady sliding at the Hopf point of the printed equations.
#[test]
fn the_cycles_of_a_lumped_brake_begin_at_its_hopf_point() {
    const FRICTION: f64 = 0.35;
    let case = brake(FRICTION);
    let (steady, values) = growing(&case, [1.0, 1e3]);
    let settings = CycleSettings { harmonics: HarmonicCount::Fixed(5), ..CycleSettings::default() };
    let found = limit_cycles(&case, &steady, values[0], &settings, &|| true).unwrap();
    let cycle = &found.cycles[0];
    let rule = PathRule { steps: [0.02, 0.2, 1e-6], ..PathRule::default() };
    let settings = BranchSettings { rule, range: [0.0, 0.5], unit: FRICTION, rises: false, points: 200 };
    let at = |friction: f64| Ok(brake(friction));
    let branch = cycle_branch(&at, &cycle.balance, (FRICTION, &cycle.motion), &settings, &|| true).unwrap();
    assert_eq!(branch.end, CycleBranchEnd::SteadySliding);
    let [friction, frequency] = hopf_point();
    let last = branch.cycles.last().unwrap();
    let vanishes = branch.vanishes_at().unwrap();
    assert!((vanishes / friction - 1.0).abs() < 1e-5, "{vanishes} {} {friction}", last.parameter);
    assert!((last.motion.turning.frequency / frequency - 1.0).abs() < 1e-4);
}

/// A branch comes to the ends of its range and no farther, where the bodies cannot be built beyond them as well; at an end that it begins at it has no more than that cycle.
#[test]
fn the_cycles_of_a_lumped_brake_reach_both_ends_of_a_range() {
    const RANGE: [f64; 2] = [0.31, 0.37];
    let case = brake(RANGE[1]);
    let (steady, values) = growing(&case, [1.0, 1e3]);
    let settings = CycleSettings { harmonics: HarmonicCount::Fixed(5), ..CycleSettings::default() };
    let found = limit_cycles(&case, &steady, values[0], &settings, &|| true).unwrap();
    let cycle = &found.cycles[0];
    let rule = PathRule { steps: [0.02, 0.2, 1e-6], ..PathRule::default() };
    let at = |value: f64| match (RANGE[0]..=RANGE[1]).contains(&value) {
        true => Ok(brake(value)),
        false => Err(CyclesError::NoAssembly { value, reason: "out of range".to_owned() }),
    };
    let branch = |motion: &PeriodicMotion, from: f64, rises: bool| {
        let settings = BranchSettings { rule, range: RANGE, unit: 0.35, rises, points: 200 };
        cycle_branch(&at, &cycle.balance, (from, motion), &settings, &|| true).unwrap()
    };
    let down = branch(&cycle.motion, RANGE[1], false);
    let last = down.cycles.last().unwrap();
    assert_eq!((&down.end, last.parameter), (&CycleBranchEnd::Range, RANGE[0]));
    let up = branch(&last.motion, RANGE[0], true);
    let again = up.cycles.last().unwrap();
    assert_eq!((&up.end, again.parameter), (&CycleBranchEnd::Range, RANGE[1]));
    let off = again.motion.turning.frequency / cycle.frequency() - 1.0;
    assert!(off.abs() < 1e-9, "{off:e}");
    let beyond = branch(&again.motion, RANGE[1], true);
    assert_eq!((beyond.end, beyond.cycles.len()), (CycleBranchEnd::Range, 1));
}

/// By steps and by Hill's method, which share the laws and nothing else. Of four states the product of the multipliers is that of the divergence, exp(−(η₁ω₁ + η₂ω₂) T)
/// (J. Liouville).
#[test]
fn the_multipliers_of_a_lumped_brake_are_those_of_hills_method() {
    const FRICTION: f64 = 0.35;
    let case = brake(FRICTION);
    let (steady, values) = growing(&case, [1.0, 1e3]);
    let settings = CycleSettings { harmonics: HarmonicCount::Fixed(15), ..CycleSettings::default() };
    let found = limit_cycles(&case, &steady, values[0], &settings, &|| true).unwrap();
    let cycle = &found.cycles[0];
    let hill = hill_multipliers(&cycle.balance, &cycle.motion, HILL_ROWS, &|| true).unwrap().unwrap();
    assert!((hill.phase.unwrap() - 1.0).norm() < 1e-8 && hill.error < 1e-8, "{hill:?}");
    let product: c64 = hill.values.iter().product();
    let expected = (-damping().iter().sum::<f64>() * TAU / cycle.frequency()).exp();
    assert!((product / expected - 1.0).norm() < 1e-8, "{product} {expected}");
    let stepped = floquet_multipliers(&cycle.balance, &cycle.motion, &|| true).unwrap().unwrap();
    assert!(off_nearest(&stepped.values, &hill.values) < 3e-4, "{hill:?} {stepped:?}");
}
