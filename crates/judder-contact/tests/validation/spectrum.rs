//! Continuous spectra against closed forms.

use judder_contact::material::{ContinuousSpectrum, CreepSpectrum, MaterialError};
use num_complex::Complex64;

const RUBBERY: f64 = 1e6;
const GLASSY: f64 = 1e9;

/// The box τ𝒞 = L on [a, b]: ∫ L/(τ(1 + iωτ)) dτ = L ln[b(1 + iωa)/(a(1 + iωb))], by partial fractions.
fn box_modulus(from: f64, to: f64, frequency: f64) -> Complex64 {
    let height = (1.0 / RUBBERY - 1.0 / GLASSY) / (to / from).ln();
    let at = |time: f64| Complex64::new(1.0, frequency * time);
    let integral = height * ((to / from).ln() + at(from).ln() - at(to).ln());
    (integral + 1.0 / GLASSY).inv()
}

#[test]
fn the_box_spectrum_and_its_series() {
    let (from, to) = (1e-8, 1.0);
    let continuous = ContinuousSpectrum::power_law(RUBBERY, GLASSY, from, to, 0.0).unwrap();
    let mut last = f64::INFINITY;
    for terms in [5, 10, 20, 30] {
        let series = continuous.discretised(terms).unwrap();
        assert_eq!(series.spectrum.terms().len(), terms);
        assert!((series.spectrum.rubbery_modulus() / RUBBERY - 1.0).abs() < 1e-12);
        let mut worst: f64 = 0.0;
        for decade in -40..=140 {
            let frequency = 10f64.powf(f64::from(decade) / 10.0);
            let exact = box_modulus(from, to, frequency);
            let fine = continuous.fine().complex_modulus(frequency);
            assert!((fine - exact).norm() < 1e-10 * exact.norm(), "{frequency}: {fine} {exact}");
            worst = worst.max((series.spectrum.complex_modulus(frequency) - exact).norm() / exact.norm());
        }
        // the error that is shown is the error that is there
        assert!(worst < 1.05 * series.error && worst > 0.8 * series.error, "{worst} {}", series.error);
        assert!(worst < 0.2 * last, "{terms}: {worst} after {last}");
        last = worst;
    }
    assert!(last < 1e-4, "{last}");
}

#[test]
fn as_few_terms_as_the_tolerance_needs() {
    let continuous = ContinuousSpectrum::log_normal(RUBBERY, GLASSY, 1e-3, 1.0).unwrap();
    let found = continuous.discretised_within(0.01).unwrap();
    let terms = found.spectrum.terms().len();
    assert!(found.error <= 0.01 && continuous.discretised(terms - 1).unwrap().error > 0.01);
    assert!(matches!(continuous.discretised(0), Err(MaterialError::Terms { .. })));
    assert!(matches!(continuous.discretised_within(1e-30), Err(MaterialError::ToleranceNotMet { .. })));
}

/// A spectrum narrower than anything measurable is one retardation time.
#[test]
fn a_narrow_spectrum_is_one_term() {
    let continuous = ContinuousSpectrum::log_normal(RUBBERY, GLASSY, 1e-3, 1e-4).unwrap();
    let single = CreepSpectrum::single(RUBBERY, GLASSY, 1e-3).unwrap();
    let series = continuous.discretised(1).unwrap();
    for frequency in [1.0, 1e3, 1e6, 1e9] {
        let (a, b) = (series.spectrum.complex_modulus(frequency), single.complex_modulus(frequency));
        assert!((a - b).norm() < 1e-3 * b.norm());
    }
    assert!((series.spectrum.terms()[0].retardation_time / 1e-3 - 1.0).abs() < 1e-3);
}

/// A table whose τ𝒞 is constant is the box; a density given as a function is the same spectrum.
#[test]
fn a_table_and_a_function_of_the_box() {
    let height = (1.0 / RUBBERY - 1.0 / GLASSY) / 1e4_f64.ln();
    let table: Vec<(f64, f64)> =
        [1e-4, 3e-3, 0.2, 1.0].into_iter().map(|time| (time, height / time)).collect();
    let from_table = ContinuousSpectrum::sampled(GLASSY, &table).unwrap();
    let from_function = ContinuousSpectrum::from_density(GLASSY, 1e-4, 1.0, |time| height / time).unwrap();
    for frequency in [1e-2, 3.0, 1e3, 1e6] {
        let exact = box_modulus(1e-4, 1.0, frequency);
        for continuous in [&from_table, &from_function] {
            let modulus = continuous.fine().complex_modulus(frequency);
            assert!((modulus - exact).norm() < 1e-10 * exact.norm());
        }
    }
    assert!(from_table.quadrature_error() < 1e-10);
}

#[test]
fn spectra_that_are_none_are_refused() {
    let of = |density: fn(f64) -> f64| ContinuousSpectrum::from_density(GLASSY, 1e-3, 1.0, density);
    assert!(matches!(of(|_| -1.0), Err(MaterialError::Density { .. })));
    assert!(matches!(of(|_| 0.0), Err(MaterialError::Density { .. })));
    assert!(matches!(of(|_| f64::NAN), Err(MaterialError::Density { .. })));
    assert!(matches!(ContinuousSpectrum::sampled(GLASSY, &[]), Err(MaterialError::Samples { samples: 0 })));
    let backwards = ContinuousSpectrum::sampled(GLASSY, &[(1.0, 1e-9), (0.5, 1e-9)]);
    assert_eq!(backwards.unwrap_err(), MaterialError::Range { before: 1.0, after: 0.5 });
}
