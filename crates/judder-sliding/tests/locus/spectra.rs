//! The same spectrum by three ways.

use crate::common;
use judder_sliding::characteristic::Characteristic;
use judder_sliding::coupling::{Coupling, Sliding};
use judder_sliding::dense_forms::ThreeField;
use judder_sliding::edge::Interpolation;
use judder_sliding::friction::Friction;
use judder_sliding::pair::Pair;
use judder_sliding::spectrum::{Spectrum, Wanted};
use judder_sliding::statics::Equilibrium;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Where full matrices are shifted to, 1/s.
const SHIFT: f64 = 2e4;
/// Up to where spectra are compared, rad/s: 40 kHz.
const LIMIT: f64 = TAU * 40e3;

fn pair(friction: f64) -> Pair {
    common::pair_with(Interpolation::Linear, Friction::constant(friction).unwrap(), 20)
}

fn coupling(pair: &Pair, position: f64, is_deformed: bool) -> Coupling {
    let sliding = Sliding::at(pair.friction(), common::SPEED);
    if is_deformed {
        return Equilibrium::new(pair, position, common::LOAD, sliding).unwrap().coupling(pair, sliding);
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
            let function = Characteristic::new(&coupling, &eigenvalues, &damping).unwrap();
            let found = Spectrum::new(&function, position, Wanted::Below(LIMIT)).unwrap();
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
