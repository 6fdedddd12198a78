//! Random oscillators, the same ones at every run.

use judder_contact::{FittedLaw, HertzLaw, Law};
use judder_oscillator::equilibrium::equilibrium;
use judder_oscillator::linear_system::LinearSystem;
use judder_oscillator::linearisation::Linearisation;
use judder_oscillator::{Coefficients, Contact, FrictionLoad, Groups};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestCaseResult, TestRng, TestRunner};

/// Runs a check on `cases` values of a strategy; what fails is shrunk and shown.
pub(crate) fn for_each<S: Strategy>(cases: u32, strategy: S, check: impl Fn(S::Value) -> TestCaseResult) {
    let config =
        Config { cases, failure_persistence: None, max_global_rejects: 10 * cases, ..Config::default() };
    let rng = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    if let Err(failure) = TestRunner::new_with_rng(config, rng).run(&strategy, check) {
        panic!("{failure}");
    }
}

/// Evenly distributed in the logarithm.
pub(crate) fn logarithmic(from: f64, to: f64) -> impl Strategy<Value = f64> {
    (from.ln()..to.ln()).prop_map(f64::exp)
}

/// The whole range of operating points, on the paper's structure.
pub(crate) fn operating_point() -> impl Strategy<Value = Groups> {
    let shear_strength = prop_oneof![1 => Just(0.0), 3 => 0.0..1.0, 6 => logarithmic(1e-6, 1.0)];
    (logarithmic(1e-8, 1e2), logarithmic(1e-9, 1e-1), shear_strength).prop_map(
        |(velocity, normal_load, shear_strength)| Groups {
            velocity,
            normal_load,
            shear_strength,
            ..Groups::default()
        },
    )
}

/// Operating points on structures of all kinds, with the coupling angle between `from` and `to`.
pub(crate) fn any_structure(from: f64, to: f64) -> impl Strategy<Value = Groups> {
    let structure = (logarithmic(1e-4, 1e-1), logarithmic(1e-2, 1e1), 0.2..5.0_f64, 0.0..3.0_f64, from..to);
    (operating_point(), structure, 0.0..0.2_f64, 0.0..0.2_f64).prop_map(
        |(
            groups,
            (stiffness, retardation_time, frequency_ratio, coupling, coupling_angle),
            damping_x,
            damping_y,
        )| {
            Groups {
                stiffness,
                retardation_time,
                damping_x,
                damping_y,
                frequency_ratio,
                coupling,
                coupling_angle,
                ..groups
            }
        },
    )
}

/// The paper's structure or any other whose coupling presses the indenter in (k12 ≥ 0).
pub(crate) fn any_groups() -> impl Strategy<Value = Groups> {
    prop_oneof![operating_point(), any_structure(0.0, std::f64::consts::FRAC_PI_2)]
}

pub(crate) fn any_load() -> impl Strategy<Value = FrictionLoad> {
    prop_oneof![Just(FrictionLoad::NormalLoad), Just(FrictionLoad::ContactForce)]
}

/// Every law with every friction load.
pub(crate) fn any_contact() -> impl Strategy<Value = Contact> {
    let law = prop_oneof![
        2 => Just(Law::Fitted(FittedLaw::oscillator_paper())),
        1 => Just(Law::Fitted(FittedLaw::oscillator_paper_corrected())),
        1 => prop_oneof![Just(1.0), Just(10.0)].prop_map(|modulus_ratio| Law::Hertz(HertzLaw { modulus_ratio })),
    ];
    (law, any_load()).prop_map(|(law, friction_load)| Contact { law, friction_load })
}

/// Any linear system whose mass matrix is one.
pub(crate) fn any_system() -> impl Strategy<Value = LinearSystem> {
    let mass = (0.2..3.0_f64, 0.2..3.0_f64, -0.95..0.95_f64);
    let damping = prop_oneof![1 => Just(1.0), 1 => logarithmic(1e-16, 1.0)];
    (mass, prop::array::uniform8(-2.0..2.0_f64), damping, 0.0..4.0_f64).prop_map(
        |((a, b, correlation), e, size, shift)| {
            let off = correlation * (a * b).sqrt();
            LinearSystem {
                mass: [[a, off], [off, b]],
                damping: [[size * e[0], size * e[1]], [size * e[2], size * e[3]]],
                stiffness: [[shift + e[4], e[5]], [e[6], shift + e[7]]],
            }
        },
    )
}

/// The oscillator linearised about steady sliding.
pub(crate) fn linearised(contact: &Contact, c: &Coefficients) -> Linearisation {
    Linearisation::new(contact.friction_load, c, &equilibrium(contact, c).unwrap().response)
}
