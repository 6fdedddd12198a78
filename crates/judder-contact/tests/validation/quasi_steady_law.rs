//! Eq. (3) of the oscillator paper: how far laws of steady sliding are from the contact in motion.

use crate::questions::{follow, paraboloid, transient};
use judder_contact::transient::{
    Before, CreepingSubstrate, IndenterPath, NormalCourse, PathCourse, TransientSample,
};
use judder_contact::unilateral::{Loading, UnilateralLimits};
use num_complex::Complex64;
use std::f64::consts::TAU;

const AMPLITUDE: f64 = 0.05;

/// Force and friction force per unit of depth, oscillating about depth 1 with ω while sliding at `speed`; and the
/// derivatives of the steady laws, which take their place.
fn responses(speed: f64, frequency: f64) -> ([Complex64; 2], [f64; 2]) {
    let substrate = CreepingSubstrate::single(10.0, 1.0);
    let normal = NormalCourse::Indentation(PathCourse::sine(1.0, AMPLITUDE, frequency));
    let path = IndenterPath { position: PathCourse::Start { speed, ramp: 0.0 }, normal };
    let period = TAU / frequency;
    let settled = (6.0 / period).ceil() * period;
    let mut question = transient(&substrate, &path, settled + period, 32);
    question.before = Before::Settled;
    question.limits = UnilateralLimits { tolerance: 1e-6, ..UnilateralLimits::default() };
    let history = follow(&question);
    let wave = |quantity: fn(&TransientSample) -> f64| {
        history.harmonic(settled, settled + period, frequency, quantity)
    };
    let depth = wave(|sample| sample.indentation);
    let moving = [wave(|sample| sample.force) / depth, wave(|sample| sample.friction_force) / depth];
    let steady = [1.0 + AMPLITUDE, 1.0 - AMPLITUDE].map(|depth| {
        let contact = paraboloid(&substrate.sliding_at(speed), Loading::Indentation(depth), 128).refinement;
        [contact.force.value, contact.force.value * contact.friction.value]
    });
    let slope = |which: usize| (steady[0][which] - steady[1][which]) / (2.0 * AMPLITUDE);
    (moving, [slope(0), slope(1)])
}

/// The friction force per unit of speed, the speed oscillating by a twentieth with ω; and the derivative of the steady law.
fn response_to_speed(speed: f64, frequency: f64) -> (Complex64, f64) {
    let substrate = CreepingSubstrate::single(10.0, 1.0);
    let amplitude = AMPLITUDE * speed / frequency;
    let angular_frequency = frequency;
    let position =
        PathCourse::Oscillation { mean: 0.0, drift: speed, amplitude, angular_frequency, phase: 0.0 };
    let path = IndenterPath { position, normal: NormalCourse::Indentation(PathCourse::Constant(1.0)) };
    let period = TAU / frequency;
    let settled = (6.0 / period).ceil() * period;
    let mut question = transient(&substrate, &path, settled + period, 32);
    question.before = Before::Settled;
    question.limits = UnilateralLimits { tolerance: 1e-6, ..UnilateralLimits::default() };
    let history = follow(&question);
    let friction = history.harmonic(settled, settled + period, frequency, |sample| sample.friction_force);
    let steady = [1.0 + AMPLITUDE, 1.0 - AMPLITUDE].map(|part| {
        let substrate = substrate.sliding_at(part * speed);
        let contact = paraboloid(&substrate, Loading::Indentation(1.0), 128).refinement;
        contact.force.value * contact.friction.value
    });
    (friction / (AMPLITUDE * speed), (steady[0] - steady[1]) / (2.0 * AMPLITUDE * speed))
}

/// With the speed oscillating at ω τ = 0.4 friction follows the steady law's slope nearly as if it stood still.
#[test]
#[ignore = "expensive: run by make validate"]
fn friction_follows_an_oscillating_speed_without_delay() {
    println!("   z    ω τ   |D/D_s|  phase");
    for speed in [0.1, 1.0] {
        for frequency in [0.05, 0.4] {
            let (moving, steady) = response_to_speed(speed, frequency);
            let ratio = moving / steady;
            println!("{speed:5} {frequency:6} {:8.3} {:7.3}", ratio.norm(), ratio.arg());
            assert!((ratio - 1.0).norm() < 0.06, "{ratio}");
        }
    }
}

/// At ω τ = 0.4 the force runs ahead of the steady law, as if a damper stood beside it; at ω τ = 0.05 hardly.
#[test]
#[ignore = "expensive: run by make validate"]
fn the_steady_law_misses_the_damping_of_the_oscillators_frequency() {
    println!("   z    ω τ   |K/K_s|  phase   |Q/Q_s|  phase");
    let mut phases = Vec::new();
    for speed in [0.1, 1.0] {
        for frequency in [0.05, 0.4] {
            let (moving, steady) = responses(speed, frequency);
            let [force, friction] = [moving[0] / steady[0], moving[1] / steady[1]];
            println!(
                "{speed:5} {frequency:6} {:8.3} {:7.3} {:8.3} {:7.3}",
                force.norm(),
                force.arg(),
                friction.norm(),
                friction.arg()
            );
            phases.push(force.arg());
        }
    }
    for pair in phases.chunks(2) {
        assert!(pair[0].abs() < 0.06 && (0.2..0.4).contains(&pair[1]), "{phases:?}");
    }
}
