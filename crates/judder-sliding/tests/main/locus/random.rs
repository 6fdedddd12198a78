//! Spectra of random pairs against full matrices.

use judder_numerics::counter::uniform;
use judder_sliding::characteristic::PairCharacteristic;
use judder_sliding::coupling::{Coupling, Feedback};
use judder_sliding::dense_forms::ThreeField;
use judder_sliding::spectrum::{Spectrum, WantedEigenvalues};
use num_complex::Complex64;
use proptest::prelude::*;

/// Up to where eigenvalues are sought; frequencies of the modes reach from 0 to 40.
const LIMIT: f64 = 25.0;

/// Modes of any kind: rigid, double, damped or not, not coupled at all.
fn random(seed: u64, modes: usize, terms: usize) -> (Coupling, Vec<f64>, Vec<f64>) {
    let number = |list: u64, k: usize| uniform(seed, 1000 * list + k as u64);
    let list = |which: u64| {
        let entry = |k| if number(which + 50, k) < 0.1 { 0.0 } else { 2.0 * number(which, k) - 1.0 };
        (0..modes).map(entry).collect::<Vec<f64>>()
    };
    let feedback = (0..terms).map(|k| {
        let which = 2 * k as u64 + 4;
        Feedback { row: list(which), column: list(which + 1), follows_velocity: k % 2 == 0 }
    });
    // friction: a force about as the compatibility, and something beside it
    let compatibility = list(0);
    let aside = list(1);
    let equilibrium = compatibility.iter().zip(&aside).map(|(c, aside)| c + 0.5 * aside).collect();
    let mut frequencies: Vec<f64> = (0..modes).map(|k| 40.0 * number(30, k)).collect();
    frequencies[0] = 0.0;
    frequencies[2] = frequencies[1];
    let damping = frequencies.iter().enumerate().map(|(k, f)| if k % 3 == 0 { 0.0 } else { 0.02 * f });
    let damping = damping.collect();
    let eigenvalues = frequencies.iter().map(|f| f * f).collect();
    (Coupling { compatibility, equilibrium, feedback: feedback.collect() }, eigenvalues, damping)
}

fn within(values: &[Complex64], limit: f64) -> Vec<Complex64> {
    values.iter().copied().filter(|s| s.im > -1e-6 && s.im <= limit && s.re.abs() <= limit).collect()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    /// Every eigenvalue of the full matrices is found, and none besides; those that are double only to half of their digits.
    #[test]
    fn nothing_is_missing_and_nothing_is_besides(seed: u64, modes in 4..16_usize, terms in 0..4_usize) {
        let (coupling, eigenvalues, damping) = random(seed, modes, terms);
        prop_assume!(coupling.mobility() > 1e-3);
        let function = PairCharacteristic::new(&coupling, &eigenvalues, &damping).unwrap();
        let fields = ThreeField::new(&coupling, &eigenvalues, &damping).unwrap();
        let dense = fields.primal_spectrum(0.37).unwrap();
        // none so near to a border that rounding decides
        let border = |s: &Complex64| (s.im - LIMIT).abs().min((s.re.abs() - LIMIT).abs());
        prop_assume!(dense.iter().all(|s| border(s) > 1e-3));
        let expected = within(&dense, LIMIT);
        let found = Spectrum::new(&function, 0.0, WantedEigenvalues::Below(LIMIT)).unwrap().eigenvalues;
        prop_assert_eq!(found.len(), expected.len(), "{:?} {:?}", found, expected);
        let mut left = expected;
        for s in found {
            let distance = |k: &usize| (left[*k] - s).norm();
            let nearest = (0..left.len()).min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap();
            prop_assert!(distance(&nearest) < 1e-5, "{} {:?}", s, left);
            left.swap_remove(nearest);
        }
    }
}
