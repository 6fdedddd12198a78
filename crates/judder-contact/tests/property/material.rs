//! What holds for every viscoelastic material.

use judder_contact::material::{
    CreepSpectrum, CreepTerm, MaterialChecks, RelaxationSpectrum, RelaxationTerm,
};
use proptest::prelude::*;

/// Up to 30 terms, each 0.1 to 3 decades of time after the last, with weights over eight decades.
fn steps() -> impl Strategy<Value = Vec<(f64, f64)>> {
    prop::collection::vec((0.1..3.0_f64, -8.0..0.0_f64), 1..=30)
}

/// Times and weights from steps; the whole spans at most `decades`.
fn spectrum(steps: &[(f64, f64)], decades: f64) -> Vec<(f64, f64)> {
    let total: f64 = steps.iter().map(|s| s.0).sum();
    let squeeze = (decades / total).min(1.0);
    let mut at = -0.5 * decades;
    steps
        .iter()
        .map(|(step, weight)| {
            at += step * squeeze;
            (10f64.powf(at), 10f64.powf(*weight))
        })
        .collect()
}

fn creep(steps: &[(f64, f64)]) -> CreepSpectrum {
    let terms = spectrum(steps, 20.0);
    let terms = terms
        .into_iter()
        .map(|(retardation_time, weight)| CreepTerm { retardation_time, compliance: weight * 1e-6 });
    CreepSpectrum::new(1e9, terms.collect()).unwrap()
}

proptest! {
    #[test]
    fn creep_survives_the_way_to_relaxation_and_back(steps in steps()) {
        let creep = creep(&steps);
        let back = creep.relaxation_form().unwrap().creep_form().unwrap();
        prop_assert_eq!(creep.terms().len(), back.terms().len());
        prop_assert!((back.glassy_modulus() / creep.glassy_modulus() - 1.0).abs() < 1e-12);
        for (a, b) in creep.terms().iter().zip(back.terms()) {
            prop_assert!((b.retardation_time / a.retardation_time - 1.0).abs() < 1e-12, "{:?} {:?}", a, b);
            prop_assert!((b.compliance / a.compliance - 1.0).abs() < 1e-12, "{:?} {:?}", a, b);
        }
    }

    #[test]
    fn relaxation_survives_the_way_to_creep_and_back(steps in steps()) {
        let terms = spectrum(&steps, 20.0).into_iter();
        let terms = terms.map(|(relaxation_time, weight)| RelaxationTerm { relaxation_time, modulus: weight * 1e9 });
        let relaxation = RelaxationSpectrum::new(1e6, terms.collect()).unwrap();
        let back = relaxation.creep_form().unwrap().relaxation_form().unwrap();
        prop_assert!((back.rubbery_modulus() / relaxation.rubbery_modulus() - 1.0).abs() < 1e-12);
        for (a, b) in relaxation.terms().iter().zip(back.terms()) {
            prop_assert!((b.relaxation_time / a.relaxation_time - 1.0).abs() < 1e-12, "{:?} {:?}", a, b);
            prop_assert!((b.modulus / a.modulus - 1.0).abs() < 1e-12, "{:?} {:?}", a, b);
        }
    }

    #[test]
    fn both_forms_have_one_modulus_and_their_times_interlace(steps in steps(), decade in -12.0..12.0_f64) {
        let creep = creep(&steps);
        let relaxation = creep.relaxation_form().unwrap();
        let frequency = 10f64.powf(decade);
        let (a, b) = (creep.complex_modulus(frequency), relaxation.complex_modulus(frequency));
        prop_assert!((a - b).norm() < 1e-12 * a.norm(), "{} {}", a, b);
        prop_assert!((a.im - b.im).abs() < 1e-12 * a.im, "{} {}", a, b);
        for (k, (slow, fast)) in creep.terms().iter().zip(relaxation.terms()).enumerate() {
            prop_assert!(fast.relaxation_time <= slow.retardation_time);
            prop_assert!(k == 0 || fast.relaxation_time >= creep.terms()[k - 1].retardation_time);
        }
    }

    #[test]
    fn a_term_cut_in_two_halves_is_the_same_term(steps in steps()) {
        let whole = creep(&steps);
        let half = |term: &CreepTerm| CreepTerm { compliance: 0.5 * term.compliance, ..*term };
        let halves: Vec<_> = whole.terms().iter().chain(whole.terms()).map(half).collect();
        prop_assert_eq!(CreepSpectrum::new(whole.glassy_modulus(), halves).unwrap(), whole);
    }
}

proptest! {
#[test]
fn the_checks_hold_for_every_spectrum(steps in steps()) {
    prop_assert!(MaterialChecks::of(&creep(&steps)).hold());
}}
