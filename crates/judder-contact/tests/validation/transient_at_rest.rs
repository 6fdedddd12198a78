//! An indenter that only moves up and down, against closed forms.

use crate::questions::{assert_close, follow, transient};
use judder_contact::transient::{
    Before, CreepingSubstrate, CreepingTerm, IndenterPath, NormalCourse, PathCourse, StepControl,
    TransientSample,
};
use judder_contact::unilateral::UnilateralLimits;
use std::f64::consts::TAU;

const FINER: StepControl = StepControl { tolerance: 1e-5, cells_a_step: 1.0, most: 10_000 };

/// E(t)/E0 = 1 + (c − 1) e^{−c t/τ}: with one retardation time the relaxation time is τ E0/E∞.
fn relaxation(contrast: f64, time: f64) -> f64 {
    1.0 + (contrast - 1.0) * (-contrast * time).exp()
}

/// Lee and Radok (1960): after a step to δ the contact keeps its radius, so F(t) = 4/3 E(t) √R δ^1.5.
#[test]
fn a_held_indenter_relaxes_with_the_modulus() {
    for (contrast, tolerance) in [(10.0, 3e-3), (1000.0, 1e-2)] {
        let substrate = CreepingSubstrate::single(contrast, 1.0);
        let path = IndenterPath::at_rest(NormalCourse::Indentation(PathCourse::Constant(1.0)));
        let mut question = transient(&substrate, &path, 10.0 / contrast, 32);
        question.steps = FINER;
        let history = follow(&question);
        for sample in &history.samples {
            assert_close(sample.force, 4.0 / 3.0 * relaxation(contrast, sample.time), tolerance);
        }
        assert_close(history.samples[0].force, contrast * 4.0 / 3.0, 1e-3);
    }
}

/// Lee and Radok (1960): while the contact grows F(t) = 4/3 √R ∫ E(t − s) d(δ^1.5).
#[test]
fn a_growing_contact_is_the_integral_over_its_past() {
    let contrast = 10.0;
    let substrate = CreepingSubstrate::single(contrast, 1.0);
    let ramp = PathCourse::Ramp { from: 0.0, to: 1.0, duration: 0.5 };
    let path = IndenterPath::at_rest(NormalCourse::Indentation(ramp));
    let mut question = transient(&substrate, &path, 0.5, 40);
    question.steps = FINER;
    let history = follow(&question);
    for sample in history.samples.iter().filter(|sample| sample.indentation > 0.1) {
        let panels = 2000;
        let step = sample.time / f64::from(panels);
        let integral: f64 = (0..panels)
            .map(|panel| (f64::from(panel) + 0.5) * step)
            .map(|s| relaxation(contrast, sample.time - s) * 1.5 * (2.0 * s).sqrt() * 2.0 * step)
            .sum();
        assert_close(sample.force, 4.0 / 3.0 * integral, 1e-2);
    }
    let last = history.last().unwrap();
    let exact = 4.0 / 3.0
        * (0..100_000)
            .map(|panel| (f64::from(panel) + 0.5) * 5e-6)
            .fold(0.0, |sum, s| sum + relaxation(contrast, 0.5 - s) * 1.5 * (2.0 * s).sqrt() * 2.0 * 5e-6);
    assert_close(last.force, exact, 2e-3);
}

/// Under a constant force the contact grows, δ^1.5 = 3/4 F J(t)/√R, with as many times as there are.
#[test]
fn a_constant_force_sinks_in_with_the_creep_function() {
    let terms =
        vec![CreepingTerm { compliance: 0.5, time: 0.05 }, CreepingTerm { compliance: 0.4, time: 2.0 }];
    let substrate = CreepingSubstrate { instantaneous: 0.1, terms };
    let path = IndenterPath::at_rest(NormalCourse::Load(PathCourse::Constant(4.0 / 3.0)));
    let history = follow(&transient(&substrate, &path, 8.0, 32));
    for sample in &history.samples {
        let creep = 1.0 - 0.5 * (-sample.time / 0.05).exp() - 0.4 * (-sample.time / 2.0).exp();
        assert_close(sample.force, 4.0 / 3.0, 1e-5);
        assert_close(sample.indentation, creep.powf(2.0 / 3.0), 4e-3);
    }
}

/// An elastic substrate has no past: every instant is Hertz's, and nothing is dissipated.
#[test]
fn an_elastic_substrate_answers_like_hertz_at_every_instant() {
    let substrate = CreepingSubstrate::elastic();
    let path = IndenterPath::at_rest(NormalCourse::Indentation(PathCourse::sine(0.5, 1.0, TAU)));
    let history = follow(&transient(&substrate, &path, 1.0, 40));
    for sample in &history.samples {
        let hertz = 4.0 / 3.0 * sample.indentation.max(0.0).powf(1.5);
        assert!((sample.force - hertz).abs() < 3e-3 * 2.45, "{sample:?}");
        assert!(sample.indentation > 0.0 || sample.area == 0.0);
    }
    assert!(history.last().unwrap().work().abs() < 3e-3);
}

/// What a cycle dissipates over π Δ² 2 a E″(ω), after the first, for a settled contact of depth 1.
fn dissipated_over_linear(frequency: f64, amplitude: f64) -> f64 {
    let substrate = CreepingSubstrate::single(10.0, 1.0);
    let path = IndenterPath::at_rest(NormalCourse::Indentation(PathCourse::sine(1.0, amplitude, frequency)));
    let period = TAU / frequency;
    let mut question = transient(&substrate, &path, 2.0 * period, 48);
    question.before = Before::Settled;
    question.limits = UnilateralLimits { tolerance: 1e-7, ..UnilateralLimits::default() };
    let linear = TAU * amplitude * amplitude * substrate.complex_modulus(frequency).im;
    follow(&question).work_by_period(period)[1] / linear
}

/// The edge of the contact carries no pressure, so for small oscillations the contact is a flat punch of complex stiffness
/// 2 a E(ω). The departure is proportional to the amplitude: two amplitudes tell the limit.
#[test]
fn small_oscillations_dissipate_by_the_loss_modulus() {
    for frequency in [0.4, 3.0] {
        let [large, small] = [0.05, 0.025].map(|amplitude| dissipated_over_linear(frequency, amplitude));
        assert_close(2.0 * small - large, 1.0, 5e-3);
    }
    let [large, small] = [0.2, 0.1].map(|amplitude| 1.0 - dissipated_over_linear(3.0, amplitude));
    assert!((1.5..3.0).contains(&(large / small)) && small > 0.02, "{large} {small}");
}

/// The stiffness itself, its phase included.
#[test]
fn small_oscillations_have_the_stiffness_of_the_complex_modulus() {
    let (frequency, amplitude) = (0.4, 0.05);
    let substrate = CreepingSubstrate::single(10.0, 1.0);
    let path = IndenterPath::at_rest(NormalCourse::Indentation(PathCourse::sine(1.0, amplitude, frequency)));
    let period = TAU / frequency;
    let mut question = transient(&substrate, &path, 2.0 * period, 48);
    question.before = Before::Settled;
    question.limits = UnilateralLimits { tolerance: 1e-7, ..UnilateralLimits::default() };
    let history = follow(&question);
    let wave =
        |quantity: fn(&TransientSample) -> f64| history.harmonic(period, 2.0 * period, frequency, quantity);
    let stiffness = wave(|sample| sample.force) / wave(|sample| sample.indentation);
    let modulus = substrate.complex_modulus(frequency);
    assert_close(stiffness.re, 2.0 * modulus.re, 1e-2);
    assert_close(stiffness.im, 2.0 * modulus.im, 2e-2);
}
