//! Materials against closed forms.

use judder_contact::material::{CreepSpectrum, CreepTerm, MaterialError};

/// The standard solid: tan δ peaks at 1/√(τρ), with (E∞ − E0)/(2√(E0E∞)), and E″ at 1/ρ, with half of E∞ − E0.
/// Source: Tschoegl, *The Phenomenological Theory of Linear Viscoelastic Behavior* (1989), the three-parameter solid.
#[test]
fn the_standard_solid() {
    let material = CreepSpectrum::single(1e6, 1e7, 0.01).unwrap();
    let relaxation_time: f64 = 0.001;
    let steepest = 1.0 / (0.01 * relaxation_time).sqrt();
    let peak = 9e6 / (2.0 * 1e13_f64.sqrt());
    assert!((material.loss_tangent(steepest) / peak - 1.0).abs() < 1e-14);
    assert!(material.loss_tangent(steepest * 1.01) < peak && material.loss_tangent(steepest / 1.01) < peak);
    let loss = |frequency: f64| material.complex_modulus(frequency).im;
    let highest = 1.0 / relaxation_time;
    assert!((loss(highest) / 4.5e6 - 1.0).abs() < 1e-14);
    assert!(loss(highest * 1.01) < loss(highest) && loss(highest / 1.01) < loss(highest));
}

/// Both ends of frequency and of time.
#[test]
fn rubber_at_rest_glass_in_a_hurry() {
    let material = CreepSpectrum::single(1e6, 1e7, 0.01).unwrap();
    for frequency in [0.0, f64::MIN_POSITIVE, 1e-200] {
        assert!((material.complex_modulus(frequency).re / 1e6 - 1.0).abs() < 1e-14);
    }
    for frequency in [1e200, f64::MAX, f64::INFINITY] {
        assert!((material.complex_modulus(frequency).re / 1e7 - 1.0).abs() < 1e-14);
    }
    assert_eq!(material.creep_compliance(-1.0), 0.0);
    assert!((material.creep_compliance(0.0) * 1e7 - 1.0).abs() < 1e-14);
    assert!((material.creep_compliance(1e9) * 1e6 - 1.0).abs() < 1e-14);
    // a hundred-millionth of τ later, with all its digits
    let early = material.creep_compliance(1e-10) - material.creep_compliance(0.0);
    assert!((early / 9e-15 - 1.0).abs() < 1e-7);
}

/// ∫_0^t E(t − s) J(s) ds = t, the convolution that ties the two forms (Tschoegl 1989), by Simpson's rule.
#[test]
fn relaxation_undoes_creep() {
    let term = |retardation_time, compliance| CreepTerm { retardation_time, compliance };
    let creep = CreepSpectrum::new(2e8, vec![term(0.05, 2e-8), term(0.4, 1e-8), term(3.0, 5e-8)]).unwrap();
    let relaxation = creep.relaxation_form().unwrap();
    for time in [0.01, 0.3, 2.0, 10.0] {
        let intervals = 40_000;
        let step = time / f64::from(intervals);
        let value = |k: i32| {
            let at = f64::from(k) * step;
            let weight = if k == 0 || k == intervals { 1.0 } else { f64::from(2 + 2 * (k % 2)) };
            weight * relaxation.relaxation_modulus(time - at) * creep.creep_compliance(at)
        };
        let integral = (0..=intervals).map(value).sum::<f64>() * step / 3.0;
        assert!((integral / time - 1.0).abs() < 1e-9, "{time}: {integral}");
    }
}

#[test]
fn what_is_no_material_is_refused_with_its_place() {
    let term = |retardation_time, compliance| CreepTerm { retardation_time, compliance };
    let refused = |terms: Vec<CreepTerm>| CreepSpectrum::new(1e7, terms).unwrap_err();
    assert_eq!(
        refused(vec![term(1.0, 1e-7), term(2.0, -1e-8)]),
        MaterialError::Term { index: 2, name: "compliance", value: -1e-8 }
    );
    assert!(matches!(refused(vec![term(f64::NAN, 1e-7)]), MaterialError::Term { index: 1, .. }));
    assert!(matches!(refused(vec![term(0.0, 1e-7)]), MaterialError::Term { name: "retardation time", .. }));
    assert_eq!(
        CreepSpectrum::single(1e7, 1e6, 0.01).unwrap_err(),
        MaterialError::RubberyNotBelowGlassy { rubbery: 1e7, glassy: 1e6 }
    );
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-320] {
        assert!(matches!(CreepSpectrum::elastic(bad), Err(MaterialError::NotPositive { .. })));
        assert!(matches!(CreepSpectrum::single(1e6, 1e7, bad), Err(MaterialError::NotPositive { .. })));
    }
}

/// The oscillator's groups: E0/E∞ and C E0 add up to one, and the length of the wake is v τ.
#[test]
fn what_the_contact_computation_sees() {
    let substrate = CreepSpectrum::single(1e6, 1e7, 0.01).unwrap().sliding_at(3.0);
    assert!((substrate.instantaneous - 0.1).abs() < 1e-15);
    assert!((substrate.terms[0].compliance - 0.9).abs() < 1e-15);
    assert!((substrate.terms[0].length - 0.03).abs() < 1e-16);
}
