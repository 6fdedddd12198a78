//! The same spectrum by three ways.

use crate::common;
use judder_contact::friction::Friction;
use judder_sliding::SlidingError;
use judder_sliding::characteristic::PairCharacteristic;
use judder_sliding::coupling::{Coupling, SteadyFriction};
use judder_sliding::dense_forms::ThreeField;
use judder_sliding::edge::Interpolation;
use judder_sliding::pair::Pair;
use judder_sliding::spectrum::{Spectrum, WantedEigenvalues};
use judder_sliding::statics::PairEquilibrium;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Where full matrices are shifted to, 1/s.
const SHIFT: f64 = 2e4;
/// Up to where spectra are compared, rad/s: 40 kHz.
const LIMIT: f64 = TAU * 40e3;

fn pair(friction: f64) -> Pair {
    common::pair_with(Interpolation::Linear, Friction::Constant(friction), 20)
}

fn coupling(pair: &Pair, position: f64, is_deformed: bool) -> Coupling {
    let sliding = SteadyFriction::at(pair.friction(), common::SPEED);
    if is_deformed {
        return PairEquilibrium::new(pair, position, common::LOAD, sliding).unwrap().coupling(pair, sliding);
    }
    Coupling::new(pair, &pair.undeformed(position).unwrap(), sliding)
}

fn within(mut values: Vec<Complex64>) -> Vec<Complex64> {
    values.retain(|s| s.im >= -1e-6 && s.im <= LIMIT && s.re.abs() <= LIMIT);
    values.sort_by(|a, b| a.im.total_cmp(&b.im).then(a.re.total_cmp(&b.re)));
    values
}

/// The largest distance of two lists, as a share of the size; both are matched by the nearest.
fn distance(a: &[Complex64], b: &[Complex64]) -> f64 {
    assert_eq!(a.len(), b.len(), "{a:?} {b:?}");
    let mut left = b.to_vec();
    a.iter().fold(0.0, |worst, s| {
        let nearest = |k: &usize| (left[*k] - s).norm();
        let k = (0..left.len()).min_by(|i, j| nearest(i).total_cmp(&nearest(j))).unwrap();
        let found = left.swap_remove(k);
        f64::max(worst, (found - s).norm() / s.norm())
    })
}

/// Primal, dual and characteristic function: on nodes and between them, with friction and without, undeformed and deformed, as the
/// paper damps them.
#[test]
fn primal_dual_and_characteristic_function_agree() {
    for friction in [0.0, 0.3] {
        let pair = pair(friction);
        for (position, is_deformed) in [(0.0740, false), (0.0823, false), (0.0740, true), (0.0823, true)] {
            let coupling = coupling(&pair, position, is_deformed);
            let (eigenvalues, damping) = (pair.eigenvalues(), pair.damping());
            let function = PairCharacteristic::new(&coupling, &eigenvalues, &damping).unwrap();
            let found = Spectrum::new(&function, position, WantedEigenvalues::Below(LIMIT)).unwrap();
            let found = within(found.eigenvalues);
            let fields = ThreeField::new(&coupling, &eigenvalues, &damping).unwrap();
            let primal = within(fields.primal_spectrum(SHIFT).unwrap());
            let dual = within(fields.dual_spectrum(SHIFT).unwrap());
            println!(
                "{friction} {position} {is_deformed}: {} values, {:.1e} {:.1e}",
                found.len(),
                distance(&found, &primal),
                distance(&found, &dual)
            );
            assert!(distance(&found, &primal) < 1e-6, "{friction} {position} {is_deformed}");
            assert!(distance(&found, &dual) < 1e-6, "{friction} {position} {is_deformed}");
        }
    }
}

/// So large a friction that real eigenvalues come near and go far: complete, as the full matrices have it, or locked with its position.
#[test]
fn spectra_under_large_friction_are_complete() {
    let (mut large, mut locked) = (0, 0);
    for friction in [3.0, 5.0, 10.0] {
        let pair = pair(friction);
        for (position, is_deformed) in
            [(0.0740, false), (0.0740, true), (0.0505, false), (0.0200, true), (0.0823, false)]
        {
            let coupling = coupling(&pair, position, is_deformed);
            if let Err(error) = coupling.check(position, friction) {
                assert!(error.to_string().contains(&format!(" {position} m")), "{error}");
                locked += 1;
                continue;
            }
            let (eigenvalues, damping) = (pair.eigenvalues(), pair.damping());
            let function = PairCharacteristic::new(&coupling, &eigenvalues, &damping).unwrap();
            let fields = ThreeField::new(&coupling, &eigenvalues, &damping).unwrap();
            let dense = fields.primal_spectrum(SHIFT).unwrap();
            large += dense.iter().filter(|s| s.im == 0.0 && s.re.abs() > LIMIT).count();
            for wanted in [
                WantedEigenvalues::Lowest(1),
                WantedEigenvalues::Lowest(8),
                WantedEigenvalues::Lowest(20),
                WantedEigenvalues::Below(LIMIT),
            ] {
                let found = Spectrum::new(&function, position, wanted).unwrap();
                assert!(
                    !matches!(wanted, WantedEigenvalues::Lowest(count) if found.eigenvalues.len() < count)
                );
                let within =
                    |s: &&Complex64| s.im >= -1e-6 && s.im <= found.limit && s.re.abs() <= found.limit;
                let dense: Vec<Complex64> = dense.iter().filter(within).copied().collect();
                let worst = distance(&found.eigenvalues, &dense);
                assert!(worst < 1e-6, "{friction} {position} {is_deformed} {wanted:?}: {worst:e}");
            }
        }
    }
    // the test would say nothing without either
    assert!(large > 0 && locked > 0, "{large} {locked}");
}

/// Without friction and damping all frequencies are real, and the primal form is symmetric: L_E = L_C, and what follows the deformation is
/// the stiffness of a potential. With friction it is not.
#[test]
fn without_friction_the_pair_is_conservative() {
    for (friction, is_symmetric) in [(0.0, true), (0.3, false)] {
        let pair = pair(friction);
        let undamped = vec![0.0; pair.modes()];
        for (position, is_deformed) in [(0.0740, false), (0.0823, false), (0.0740, true), (0.0823, true)] {
            let coupling = coupling(&pair, position, is_deformed);
            let function = PairCharacteristic::new(&coupling, &pair.eigenvalues(), &undamped).unwrap();
            let found = Spectrum::new(&function, position, WantedEigenvalues::Below(LIMIT)).unwrap();
            assert_eq!(found.eigenvalues.len(), 34);
            assert!(!is_symmetric || found.eigenvalues.iter().all(|s| s.re == 0.0 && s.im > 0.0));
            let fields = ThreeField::new(&coupling, &pair.eigenvalues(), &undamped).unwrap();
            let (left, right) = (fields.equilibrium_basis(), fields.compatible_basis());
            let mass = left.transpose() * &fields.mass * &right;
            let stiffness = left.transpose() * &fields.stiffness * &right;
            let skew = [&mass, &stiffness].map(|matrix| (matrix - matrix.transpose()).norm_max());
            // rounding of the largest ω², and of the much smaller geometric stiffness
            let is_small = skew[0] < 1e-13 && skew[1] < 1e-14 * stiffness.norm_max();
            assert_eq!(is_small, is_symmetric, "{friction} {position} {is_deformed}: {skew:?}");
        }
    }
}

/// Real eigenvalues: a rigid mode and a soft one, damped beyond their critical damping, coupled to a stiff one. Full matrices have the same.
#[test]
fn overdamped_eigenvalues_are_found_and_real() {
    let coupling = Coupling {
        compatibility: vec![1.0, 0.7, -0.4, 0.3],
        equilibrium: vec![1.0, 0.5, -0.6, 0.2],
        feedback: Vec::new(),
    };
    let (eigenvalues, damping) = ([0.0, 1.0, 400.0, 900.0], [3.0, 5.0, 0.5, 0.5]);
    let function = PairCharacteristic::new(&coupling, &eigenvalues, &damping).unwrap();
    let found = Spectrum::new(&function, 0.0, WantedEigenvalues::Below(28.0)).unwrap().eigenvalues;
    let fields = ThreeField::new(&coupling, &eigenvalues, &damping).unwrap();
    let mut dense = fields.primal_spectrum(1.0).unwrap();
    dense.retain(|s| s.im > -1e-9 && s.im < 28.0);
    assert!(found.iter().filter(|s| s.im == 0.0).count() >= 2, "{found:?}");
    assert!(distance(&found, &dense) < 1e-9, "{found:?} {dense:?}");
}

/// At the clamp the track gives no way: all its modes are eigenvalues, next to those of the slider alone.
#[test]
fn modes_that_are_not_coupled_are_eigenvalues() {
    let pair = pair(0.3);
    let touch = pair.undeformed(0.0).unwrap();
    let coupling = Coupling::new(&pair, &touch, SteadyFriction::at(pair.friction(), common::SPEED));
    let function = PairCharacteristic::new(&coupling, &pair.eigenvalues(), &pair.damping()).unwrap();
    let found = Spectrum::new(&function, 0.0, WantedEigenvalues::Below(LIMIT)).unwrap().eigenvalues;
    let first = pair.slider().body.modes();
    let track = (first..pair.modes()).map(|mode| function.poles(mode)[0]).filter(|pole| pole.im < LIMIT);
    for pole in track {
        let nearest = found.iter().map(|s| (s - pole).norm()).fold(f64::INFINITY, f64::min);
        assert!(nearest < 1e-9 * pole.norm(), "{pole}: {nearest}");
    }
}

/// c·M⁻¹e falls with friction in a straight line: up to its root the pair slides, beyond it locks. The paper's μ = 0.3 is far from it.
#[test]
fn locking_is_named_with_its_position() {
    let pair = pair(0.3);
    let touch = pair.undeformed(0.0505).unwrap();
    let coupled =
        |friction: f64| Coupling::new(&pair, &touch, SteadyFriction { friction, slope: 0.0, direction: 1.0 });
    let none = coupled(0.0).mobility();
    let critical = none / (none - coupled(1.0).mobility());
    assert!(critical > 3.0, "{critical}");
    let check = |friction: f64| coupled(friction).check(0.0505, friction);
    assert_eq!((check(0.3), check(critical * (1.0 - 1e-9))), (Ok(()), Ok(())));
    let error = check(critical * (1.0 + 1e-9)).unwrap_err();
    assert!(matches!(error, SlidingError::SpragSlip { mobility, .. } if mobility <= 0.0), "{error}");
    assert!(error.to_string().contains(" 0.0505 m"), "{error}");
}

/// More eigenvalues than there are, or none, are refused, not left out.
#[test]
fn wishes_that_cannot_be_met_are_refused() {
    let pair = pair(0.3);
    let function =
        PairCharacteristic::new(&coupling(&pair, 0.05, false), &pair.eigenvalues(), &pair.damping()).unwrap();
    for wanted in [
        WantedEigenvalues::Lowest(0),
        WantedEigenvalues::Lowest(243),
        WantedEigenvalues::Below(-1.0),
        WantedEigenvalues::Below(f64::NAN),
    ] {
        let error = Spectrum::new(&function, 0.05, wanted).unwrap_err();
        assert!(matches!(error, SlidingError::InvalidNumber { .. }), "{wanted:?}: {error}");
    }
}
