//! The fit of appendix B of the oscillator paper: (34)–(39).

use judder_contact::fit::{FitError, FitSample, LawFit, Weighting, fit_law};
use judder_contact::law::PerQuantity;
use judder_contact::{ContactLaw, FittedLaw, LawPoint};
use std::f64::consts::TAU;

/// Samples of a law, evenly in the logarithms.
fn samples(law: &FittedLaw, log10_v: (f64, f64, usize), log10_y: (f64, f64, usize)) -> Vec<FitSample> {
    let at = |(from, to, count): (f64, f64, usize), k: usize| {
        10_f64.powf(from + (to - from) * k as f64 / (count - 1) as f64)
    };
    let mut samples = Vec::new();
    for row in 0..log10_y.2 {
        for column in 0..log10_v.2 {
            let (velocity, indentation) = (at(log10_v, column), at(log10_y, row));
            let response = law.evaluate(&LawPoint::new(velocity, indentation));
            let values = PerQuantity {
                force: response.force.value,
                area: response.area.value,
                friction: response.friction.value,
            };
            samples.push(FitSample { velocity, indentation, values });
        }
    }
    samples
}

fn largest_deviation(fit: &LawFit, law: &FittedLaw) -> f64 {
    fit.beside(law).iter().map(|c| c.relative_deviation().abs()).fold(0.0, f64::max)
}

#[test]
fn samples_of_the_paper_return_its_coefficients() {
    for weighting in [Weighting::Absolute, Weighting::Scaled] {
        for law in [FittedLaw::oscillator_paper(), FittedLaw::oscillator_paper_corrected()] {
            let shift = -law.log10_velocity_scale;
            // grids that cover the transitions in different ways, one of them only a part
            for (v, y) in [
                ((-5.0, 1.0, 40), (-3.0, -1.0, 40)),
                ((-4.0, 0.0, 15), (-2.5, -1.0, 6)),
                ((-7.0, 3.0, 31), (-5.0, -1.0, 9)),
                ((-3.2, -0.5, 12), (-2.0, -1.0, 5)),
            ] {
                let samples = samples(&law, (v.0 + shift, v.1 + shift, v.2), y);
                let fit = fit_law(&samples, law.log10_velocity_scale, weighting).unwrap();
                let deviation = largest_deviation(&fit, &law);
                assert!(deviation < 1e-6, "{weighting:?} {v:?} {y:?}: {deviation:e}");
                assert!(fit.force.r2 > 1.0 - 1e-12 && fit.friction.r2 > 1.0 - 1e-12);
                assert!(fit.force.residuals.len() == samples.len());
            }
        }
    }
}

#[test]
fn read_on_the_printed_axis_the_same_contacts_are_shifted_by_two_decades() {
    let corrected = FittedLaw::oscillator_paper_corrected();
    let samples = samples(&corrected, (-3.0, 3.0, 25), (-3.0, -1.0, 9));
    let fit = fit_law(&samples, 0.0, Weighting::Absolute).unwrap();
    // log v̂ − 2 enters: a5 − 2 a3, b4 + 2, c3 + 2
    assert!((fit.force.coefficients[4] - (0.412 - 2.0 * 0.873)).abs() < 1e-6);
    assert!((fit.area.coefficients[3] - (-1.328 + 2.0)).abs() < 1e-6);
    assert!((fit.friction.coefficients[2] - (-1.682 + 2.0)).abs() < 1e-6);
}

/// Normal numbers of Box and Muller from SplitMix64.
struct Noise(u64);

impl Noise {
    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn normal(&mut self) -> f64 {
        let (a, b) = (1.0 - self.uniform(), self.uniform());
        (-2.0 * a.ln()).sqrt() * (TAU * b).cos()
    }
}

#[test]
fn ninety_five_percent_intervals_hold_the_truth_ninety_five_times_in_a_hundred() {
    const REPEATS: usize = 200;
    const SEED: u64 = 2021;
    let law = FittedLaw::oscillator_paper_corrected();
    let exact = samples(&law, (-1.5, 1.5, 12), (-2.5, -1.0, 5));
    let mut noise = Noise(SEED);
    let mut hits = [0_usize; 14];
    for _ in 0..REPEATS {
        let noisy: Vec<FitSample> = exact
            .iter()
            .map(|s| {
                let y = s.indentation;
                let values = PerQuantity {
                    force: s.values.force + 0.05 * y.powf(1.5) * noise.normal(),
                    area: s.values.area + 0.02 * y * noise.normal(),
                    friction: s.values.friction + 0.005 * y.sqrt() * noise.normal(),
                };
                FitSample { values, ..*s }
            })
            .collect();
        let fit = fit_law(&noisy, -2.0, Weighting::Scaled).unwrap();
        for (hit, c) in hits.iter_mut().zip(fit.beside(&law)) {
            *hit += usize::from(c.interval.0 <= c.reference && c.reference <= c.interval.1);
        }
    }
    // 95 % of 200 with four standard deviations of the count, 3.1 each
    assert!(hits.iter().all(|hit| (178..=200).contains(hit)), "{hits:?}");
    let share = hits.iter().sum::<usize>() as f64 / (14 * REPEATS) as f64;
    assert!((share - 0.95).abs() < 0.02, "{share}");
}

/// Every sample k times over tells what the samples tell once: errors and intervals come back.
#[test]
fn repeated_samples_have_the_errors_of_the_independent_ones() {
    let law = FittedLaw::oscillator_paper_corrected();
    let mut noise = Noise(35);
    let once: Vec<FitSample> = samples(&law, (-1.5, 1.5, 8), (-2.5, -1.0, 4))
        .into_iter()
        .map(|s| FitSample { values: s.values.map(|value| value * (1.0 + 0.02 * noise.normal())), ..s })
        .collect();
    let fit = fit_law(&once, -2.0, Weighting::Absolute).unwrap();
    let repeated = fit_law(&once.repeat(5), -2.0, Weighting::Absolute).unwrap();
    let honest = repeated.clone().of_independent(once.len()).unwrap();
    let errors = |fit: &LawFit| fit.beside(&law).into_iter().map(|c| (c.standard_error, c.interval));
    for ((once, repeated), honest) in errors(&fit).zip(errors(&repeated)).zip(errors(&honest)) {
        assert!((honest.0 / once.0 - 1.0).abs() < 1e-5 && repeated.0 < 0.5 * once.0);
        assert!(
            (honest.1.1 - once.1.1).abs() < 1e-4 * once.0 && (honest.1.0 - once.1.0).abs() < 1e-4 * once.0
        );
    }
    assert!(matches!(
        repeated.of_independent(5),
        Err(FitError::TooFewSamples { samples: 5, coefficients: 5, .. })
    ));
}

#[test]
fn what_cannot_be_fitted_is_refused() {
    let law = FittedLaw::oscillator_paper();
    let fit = |samples: &[FitSample]| fit_law(samples, 0.0, Weighting::Absolute);
    let good = samples(&law, (-4.0, 0.0, 9), (-2.5, -1.0, 5));
    assert!(matches!(fit(&good[..5]), Err(FitError::TooFewSamples { samples: 5, .. })));
    // one depth alone leaves a4 and a5 undetermined
    assert!(matches!(fit(&good[..9]), Err(FitError::Undetermined { .. })));
    let mut bad = good.clone();
    bad[3].values.area = f64::NAN;
    assert!(matches!(fit(&bad), Err(FitError::InvalidSample { index: 3, name: "area", .. })));
    assert!(matches!(
        fit_law(&good, f64::NAN, Weighting::Absolute),
        Err(FitError::InvalidVelocityScale { .. })
    ));
    let same: Vec<FitSample> = good.iter().map(|_| good[0]).collect();
    assert!(matches!(fit(&same), Err(FitError::Undetermined { .. })));
    // a force that rises evenly with the logarithm of the speed has no transition to place
    let even = good.iter().map(|s| {
        let force = (5.0 + s.velocity.log10()) * s.indentation.powf(1.5);
        FitSample { values: PerQuantity { force, ..s.values }, ..*s }
    });
    let error = fit(&even.collect::<Vec<_>>()).unwrap_err();
    assert!(matches!(error, FitError::NotConverged { .. }), "{error}");
    assert!(error.to_string().contains("the coefficients still move after"), "{error}");
}
