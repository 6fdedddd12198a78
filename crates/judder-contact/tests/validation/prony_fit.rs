//! Fits to moduli that were made from known series.

use judder_contact::material::{
    CreepSpectrum, DmaData, DmaPoint, MaterialError, PronyFit, RelaxationSpectrum, RelaxationTerm, TermCount,
};
use num_complex::Complex64;

fn known() -> RelaxationSpectrum {
    let term = |relaxation_time, modulus| RelaxationTerm { relaxation_time, modulus };
    let terms = vec![term(1e-4, 4e8), term(1e-3, 1e8), term(1e-2, 2e7), term(1e-1, 3e6)];
    RelaxationSpectrum::new(1e6, terms).unwrap()
}

/// Twelve points a decade of angular frequency, changed by a relative `noise`.
fn measured(
    modulus: impl Fn(f64) -> Complex64,
    decades: (i32, i32),
    mut noise: impl FnMut() -> f64,
) -> DmaData {
    let points = (12 * decades.0..=12 * decades.1).map(|k| {
        let angular_frequency = 10f64.powf(f64::from(k) / 12.0);
        let exact = modulus(angular_frequency);
        DmaPoint {
            angular_frequency,
            storage_modulus: exact.re * (1.0 + noise()),
            loss_modulus: exact.im * (1.0 + noise()),
        }
    });
    DmaData::new(points.collect()).unwrap()
}

/// Even on [−amplitude, amplitude]: the generator splitmix64 (Steele, Lea and Flood, OOPSLA 2014) from a seed.
fn noise(mut seed: u64, amplitude: f64) -> impl FnMut() -> f64 {
    move || {
        seed = seed.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = (seed ^ (seed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^= mixed >> 31;
        amplitude * (2.0 * (mixed >> 11) as f64 / (1u64 << 53) as f64 - 1.0)
    }
}

#[test]
fn a_known_series_comes_back() {
    let known = known();
    let data = measured(|frequency| known.complex_modulus(frequency), (-1, 6), || 0.0);
    let fit = PronyFit::new(&data, TermCount::Exactly(4), None).unwrap();
    assert!(fit.worst_deviation() < 0.02, "{fit:?}");
    for (found, known) in fit.relaxation.terms().iter().zip(known.terms()) {
        assert!((found.relaxation_time / known.relaxation_time).ln().abs() < 0.03, "{found:?} {known:?}");
        assert!((found.modulus / known.modulus).ln().abs() < 0.03, "{found:?} {known:?}");
    }
    assert!((fit.relaxation.rubbery_modulus() / 1e6 - 1.0).abs() < 1e-3);
    assert!(fit.storage_r_squared > 0.9999 && fit.loss_r_squared > 0.9999 && fit.optimality < 1e-12);
}

/// Seed 20, noise of up to ±3 %: the series stays nearer to the truth than the noise.
#[test]
fn noise_is_not_fitted() {
    let known = known();
    let data = measured(|frequency| known.complex_modulus(frequency), (-1, 6), noise(20, 0.03));
    let fit = PronyFit::new(&data, TermCount::Exactly(4), None).unwrap();
    assert!(fit.worst_deviation() > 0.025 && fit.worst_deviation() < 0.05, "{}", fit.worst_deviation());
    for point in data.points() {
        let exact = known.complex_modulus(point.angular_frequency);
        let found = fit.creep.complex_modulus(point.angular_frequency);
        assert!((found - exact).norm() < 0.02 * exact.norm(), "{exact} {found}");
    }
    let within = TermCount::Within { deviation: 1e-6, most: 40 };
    let fit = PronyFit::new(&data, within, None).unwrap();
    assert!(fit.candidates < 20 && fit.rms_deviation > 0.01, "{} {}", fit.candidates, fit.rms_deviation);
}

/// The fractional standard solid, E0 + (E∞ − E0) (iωτ)^α/(1 + (iωτ)^α), whose spectrum is continuous.
#[test]
fn more_terms_are_taken_for_a_closer_fit() {
    let modulus = |frequency: f64| {
        let power = (Complex64::new(0.0, frequency * 1e-4)).powf(0.6);
        1e6 + (1e9 - 1e6) * power / (1.0 + power)
    };
    let data = measured(modulus, (-2, 7), || 0.0);
    let mut before = 0;
    for deviation in [0.3, 0.1, 0.03, 0.01] {
        let within = TermCount::Within { deviation, most: 30 };
        let fit = PronyFit::new(&data, within, None).unwrap();
        assert!(fit.worst_deviation() <= deviation && fit.candidates > before, "{}", fit.candidates);
        before = fit.candidates;
    }
    assert!(before <= 20, "{before}");
}

#[test]
fn a_given_rubbery_modulus_is_kept() {
    let known = known();
    let data = measured(|frequency| known.complex_modulus(frequency), (1, 5), || 0.0);
    let fit = PronyFit::new(&data, TermCount::Exactly(6), Some(1e6)).unwrap();
    assert_eq!(fit.relaxation.rubbery_modulus(), 1e6);
    let above = PronyFit::new(&data, TermCount::Exactly(6), Some(1e9)).unwrap_err();
    assert!(matches!(above, MaterialError::RubberyAboveData { .. }));
}

/// A Maxwell fluid has no modulus at rest, and no creep form.
#[test]
fn a_fluid_is_refused() {
    let fluid = |frequency: f64| 1e6 * Complex64::new(0.0, frequency) / Complex64::new(1.0, frequency);
    let data = measured(fluid, (-3, 3), || 0.0);
    let error = PronyFit::new(&data, TermCount::Exactly(1), None);
    assert!(matches!(error, Err(MaterialError::NoPlateau { .. })), "{error:?}");
    let none = PronyFit::new(&data, TermCount::Exactly(0), None);
    assert!(matches!(none, Err(MaterialError::Terms { terms: 0, .. })));
}

/// ∫ E″ d ln ω = (π/2)(E∞ − E0), the sum rule that causality leaves (Tschoegl 1989), by the trapezoid rule.
#[test]
fn loss_adds_up_to_the_step_of_the_modulus() {
    let creep: CreepSpectrum = known().creep_form().unwrap();
    let per_decade = 20;
    let steps = -12 * per_decade..=16 * per_decade;
    let loss = steps.map(|k| creep.complex_modulus(10f64.powf(f64::from(k) / f64::from(per_decade))).im);
    let integral = loss.sum::<f64>() * std::f64::consts::LN_10 / f64::from(per_decade);
    let step = creep.glassy_modulus() - creep.rubbery_modulus();
    assert!((integral / (0.5 * std::f64::consts::PI * step) - 1.0).abs() < 1e-9, "{integral}");
}
