//! Sobol' indices against their closed forms.

use std::f64::consts::PI;

use judder_numerics::sampling::SobolSequence;
use judder_numerics::sensitivity::{Bootstrap, SensitivityError, SobolIndices, sobol_indices};

const BOOTSTRAP: Bootstrap = Bootstrap { confidence: 0.95, resamples: 200, seed: 1 };

/// The values of a function of the unit cube on rows A, AB_1 … AB_k, B.
fn rows(function: impl Fn(&[f64]) -> f64, inputs: usize, count: u64, seed: u64) -> Vec<f64> {
    let sequence = SobolSequence::scrambled(2 * inputs, seed).unwrap();
    let mut values = Vec::new();
    for index in 0..count {
        let point = |of_second: &dyn Fn(usize) -> bool| -> Vec<f64> {
            let dimension = |k: usize| if of_second(k) { inputs + k } else { k };
            (0..inputs).map(|k| sequence.coordinate(index, dimension(k))).collect()
        };
        values.push(function(&point(&|_| false)));
        values.extend((0..inputs).map(|j| function(&point(&|k| k == j))));
        values.push(function(&point(&|_| true)));
    }
    values
}

/// sin x_1 + a sin² x_2 + b x_3⁴ sin x_1 on [−π, π]³, a = 7, b = 0.1.
fn ishigami(u: &[f64]) -> f64 {
    let [x, y, z] = [0, 1, 2].map(|k| PI * (2.0 * u[k] - 1.0));
    x.sin() + 7.0 * y.sin().powi(2) + 0.1 * z.powi(4) * x.sin()
}

fn close(found: &SobolIndices, first: &[f64], total: &[f64], within: f64) {
    for (index, (found, expected)) in
        found.first.iter().zip(first).chain(found.total.iter().zip(total)).enumerate()
    {
        assert!((found.value - expected).abs() < within, "index {index}: {found:?} against {expected}");
        // rows of a net are closer than the bootstrap of random rows believes
        assert!(
            found.lower <= *expected + 0.01 && *expected - 0.01 <= found.upper,
            "index {index}: {found:?}"
        );
    }
}

/// T. Ishigami, T. Homma, *An importance quantification technique in uncertainty analysis for computer models*, ISUMA '90, 398–403; the
/// closed forms: A. Saltelli et al., *Global sensitivity analysis: the primer* (2008): V = a²/8 + bπ⁴/5 + b²π⁸/18 + 1/2,
/// V_1 = (1 + bπ⁴/5)²/2, V_2 = a²/8, V_13 = 8b²π⁸/225.
#[test]
fn ishigami_and_homma() {
    let (a, b) = (7.0_f64, 0.1_f64);
    let v_1 = 0.5 * (1.0 + b * PI.powi(4) / 5.0).powi(2);
    let (v_2, v_13) = (a * a / 8.0, 8.0 * b * b * PI.powi(8) / 225.0);
    let variance = v_1 + v_2 + v_13;
    let printed = a * a / 8.0 + b * PI.powi(4) / 5.0 + b * b * PI.powi(8) / 18.0 + 0.5;
    assert!((variance - printed).abs() < 1e-12);
    let found = sobol_indices(&rows(ishigami, 3, 1 << 13, 1), 3, &BOOTSTRAP).unwrap();
    close(
        &found,
        &[v_1 / variance, v_2 / variance, 0.0],
        &[(v_1 + v_13) / variance, v_2 / variance, v_13 / variance],
        0.01,
    );
    assert!((found.mean - 3.5).abs() < 0.01 && (found.variance / variance - 1.0).abs() < 0.01);
    assert_eq!((found.rows, found.left_out), (1 << 13, 0));
}

/// Π (|4x_j − 2| + a_j)/(1 + a_j) with a = 0, 1, 4.5, 9, 99, 99, 99, 99 (A. Saltelli, I. M. Sobol', Reliab. Eng. Syst. Saf. 50 (1995)
/// 225–239): V_j = 1/(3(1 + a_j)²), V = Π (1 + V_j) − 1, T_j V = V_j Π_{i≠j} (1 + V_i).
#[test]
fn the_g_function() {
    let a = [0.0, 1.0, 4.5, 9.0, 99.0, 99.0, 99.0, 99.0];
    let function =
        |x: &[f64]| x.iter().zip(a).map(|(x, a)| ((4.0 * x - 2.0).abs() + a) / (1.0 + a)).product::<f64>();
    let parts = a.map(|a| 1.0 / (3.0 * (1.0 + a).powi(2)));
    let all: f64 = parts.iter().map(|part| 1.0 + part).product();
    let variance = all - 1.0;
    let total = parts.map(|part| part * all / (1.0 + part) / variance);
    let found = sobol_indices(&rows(function, 8, 1 << 13, 2), 8, &BOOTSTRAP).unwrap();
    close(&found, &parts.map(|part| part / variance), &total, 0.01);
}

/// x_1 + 2 x_2: V_j are 1/12 and 4/12, nothing is shared.
#[test]
fn a_sum_has_no_interactions() {
    let found = sobol_indices(&rows(|x| x[0] + 2.0 * x[1], 2, 1 << 10, 3), 2, &BOOTSTRAP).unwrap();
    close(&found, &[0.2, 0.8], &[0.2, 0.8], 0.005);
}

/// The share of intervals that hold the true value, on rows that are independent of each other.
#[test]
fn intervals_hold_what_they_say() {
    let values = |seed: u64| {
        let mut rows = Vec::new();
        for row in 0..400 {
            let u = |k: u64| judder_numerics::counter::uniform(seed, 4 * row + k);
            let [a, b] = [[u(0), u(1)], [u(2), u(3)]];
            rows.extend([[a[0], a[1]], [b[0], a[1]], [a[0], b[1]], b].map(|[x, y]| x + 2.0 * y));
        }
        rows
    };
    let (runs, bootstrap) = (200, Bootstrap { confidence: 0.9, ..BOOTSTRAP });
    let mut held = 0;
    for seed in 0..runs {
        let found = sobol_indices(&values(seed), 2, &bootstrap).unwrap();
        let index = found.total[0];
        held += u32::from((index.lower..=index.upper).contains(&0.2));
    }
    // of 200 runs 180, four standard errors are 17
    assert!((160..=197).contains(&held), "{held}");
}

#[test]
fn rows_that_are_not_finite_are_left_out() {
    let mut values = rows(ishigami, 3, 64, 1);
    let kept: Vec<f64> = values[..5 * 60].to_vec();
    for (row, value) in [(60, f64::NAN), (61, f64::INFINITY), (62, f64::NEG_INFINITY), (63, f64::NAN)] {
        values[5 * row + row % 5] = value;
    }
    let found = sobol_indices(&values, 3, &BOOTSTRAP).unwrap();
    assert_eq!((found.rows, found.left_out), (60, 4));
    let expected = sobol_indices(&kept, 3, &BOOTSTRAP).unwrap();
    assert_eq!((found.first, found.total), (expected.first, expected.total));
}

#[test]
fn the_seed_decides_the_intervals() {
    let values = rows(ishigami, 3, 64, 1);
    let with = |seed| sobol_indices(&values, 3, &Bootstrap { seed, ..BOOTSTRAP }).unwrap();
    assert_eq!(with(1), with(1));
    assert_ne!(with(1).first[0].lower, with(2).first[0].lower);
    assert_eq!(with(1).first[0].value, with(2).first[0].value);
}

/// Magnitudes whose squares a double cannot hold.
#[test]
fn the_unit_of_the_output_does_not_matter() {
    let values = rows(ishigami, 3, 256, 1);
    let expected = sobol_indices(&values, 3, &BOOTSTRAP).unwrap();
    for factor in [1e300, 1e-300] {
        let scaled: Vec<f64> = values.iter().map(|value| value * factor).collect();
        let found = sobol_indices(&scaled, 3, &BOOTSTRAP).unwrap();
        for (found, expected) in found.total.iter().zip(&expected.total) {
            assert!((found.value - expected.value).abs() < 1e-12 && found.upper.is_finite());
        }
    }
}

#[test]
fn what_has_no_indices_is_named() {
    let refused = |values: &[f64], inputs| sobol_indices(values, inputs, &BOOTSTRAP).unwrap_err();
    assert_eq!(refused(&[2.5; 40], 3), SensitivityError::NoVariance { mean: 2.5, rows: 8 });
    let rounded: Vec<f64> =
        (0..40).map(|k| if k % 3 == 0 { 2.5 } else { 2.5 + 2.0 * f64::EPSILON }).collect();
    assert!(matches!(refused(&rounded, 3), SensitivityError::NoVariance { rows: 8, .. }));
    let between: Vec<f64> = (0..40).map(|k| f64::from((k % 5) * (k % 5 - 4))).collect();
    assert_eq!(refused(&between, 3), SensitivityError::NoVariance { mean: 0.0, rows: 8 });
    assert_eq!(refused(&[1.0; 41], 3), SensitivityError::Shape { values: 41, row: 5 });
    assert_eq!(refused(&[1.0; 40], 0), SensitivityError::Shape { values: 40, row: 2 });
    assert_eq!(refused(&[f64::NAN; 40], 3), SensitivityError::TooFewRows { rows: 0, left_out: 8 });
    let values = rows(ishigami, 3, 8, 1);
    for (confidence, resamples) in [(0.0, 100), (1.0, 100), (f64::NAN, 100), (0.9, 1)] {
        let bootstrap = Bootstrap { confidence, resamples, seed: 1 };
        let error = sobol_indices(&values, 3, &bootstrap).unwrap_err();
        assert!(matches!(error, SensitivityError::Bootstrap { .. }), "{error}");
    }
}
