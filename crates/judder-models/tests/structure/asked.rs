//! What is asked for by frequencies and damping ratios; vectors and shapes of matrices without places.

use super::{number, numbers};
use crate::run_into;
use judder_store::{Dataset, StudyFolder, VariableValues};
use num_complex::Complex64;
use serde_json::Value;
use std::f64::consts::TAU;

/// Two masses of 1 kg, each damped: (λ² + cₖ λ + kₖ) = 0 with cₖ = 2 ζₖ ωₖ, joined by nothing.
fn text(region: &str) -> String {
    format!(
        "model = \"structure\"\n[matrices]\nmass = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\n\
         damping = [[1, 0, 0], [0, 20, 0], [0, 0, -3]]\nstiffness = [[1e4, 0, 0], [0, 4e4, 0], [3e3, 0, 9e4]]\n\
         freedoms = [[\"a\", \"x\"], [\"b\", \"x\"], [\"b\", \"y\"]]\n[[analysis]]\nkind = \"eigen\"\nregion = {region}\n"
    )
}

fn eigen(region: &str) -> (Value, Dataset, String) {
    let folder = tempfile::tempdir().unwrap();
    let file = judder_models::parse("case.toml", &text(region), &[]).unwrap();
    let report = run_into(folder.path(), &file, &[]);
    let dataset = StudyFolder::open(folder.path()).unwrap().read_dataset("eigen").unwrap();
    let page = std::fs::read_to_string(folder.path().join("report.html")).unwrap();
    (Value::Object(report.summary.results["eigen"].clone()), dataset, page)
}

/// The ratios are 0.005, 0.05 and −0.005 at 100, 200 and 300 rad/s: of the rectangle that encloses what is asked for, that alone is told.
#[test]
fn frequencies_and_damping_ratios_ask_for_eigenvalues() {
    // the same eigenvalue found in another region differs by rounding
    let rounded = |frequency: f64| (1e6 * frequency).round() / 1e6;
    let frequencies = |region: &str| -> Vec<f64> {
        numbers_of(&eigen(region).0, "frequency_hz").into_iter().map(rounded).collect()
    };
    let all = frequencies("{ re = [-50.0, 50.0], im = [0.0, 400.0] }");
    assert_eq!(all.len(), 3);
    let within = |low: f64, high: f64| {
        frequencies(&format!("{{ frequency = [\"0 Hz\", \"60 Hz\"], damping_ratio = [{low}, {high}] }}"))
    };
    assert_eq!(within(-0.1, 0.1), all);
    assert_eq!(within(-0.01, 0.01), [all[0], all[2]]);
    // Re λ of the second lies in the rectangle, its ratio of 0.05 is too large
    assert_eq!(within(-0.01, 0.04), [all[0], all[2]]);
    assert_eq!(within(0.0, 0.06), all[..2]);
    assert_eq!(frequencies("{ frequency = [\"10 Hz\", \"20 Hz\"], damping_ratio = [-0.1, 0.1] }"), all[..1]);
    assert!((all[0] * TAU - (1e4_f64 - 0.25).sqrt()).abs() < 1e-5, "{all:?}");
}

#[test]
fn what_cannot_be_asked_for_is_refused() {
    let refused =
        |region: &str| judder_models::parse("case.toml", &text(region), &[]).unwrap_err().to_string();
    for (region, said) in [
        ("{ frequency = [\"0 Hz\", \"8 kHz\"] }", "damping_ratio"),
        ("{ frequency = [0, 8000], damping_ratio = [-0.1, 0.1] }", "needs a unit"),
        ("{ frequency = [\"0 Hz\", \"8 s\"], damping_ratio = [-0.1, 0.1] }", "must be an angular frequency"),
        ("{ frequency = [\"0 Hz\", \"8 kHz\"], damping_ratio = [-0.1, 1.0] }", "0.999"),
        ("{ frequency = [\"8 kHz\", \"8 Hz\"], damping_ratio = [-0.1, 0.1] }", ""),
        ("{ re = [-1, 1], im = [0, 1], damping_ratio = [-0.1, 0.1] }", "damping_ratio"),
    ] {
        let found = refused(region);
        assert!(found.contains(said), "{region}: {found}");
    }
}

fn numbers_of(results: &Value, key: &str) -> Vec<f64> {
    results["eigenvalues"].as_array().unwrap().iter().map(|own| number(&own[key])).collect()
}

fn vectors(dataset: &Dataset, name: &str) -> Vec<Vec<Complex64>> {
    match &dataset.variable(name).unwrap().data {
        VariableValues::Complex(values) => values.chunks(3).map(<[Complex64]>::to_vec).collect(),
        _ => panic!("complex numbers"),
    }
}

/// Right and left vectors of every mode: (λ²M + λC + K) x = 0, yᴴ (λ²M + λC + K) = 0, yᴴ (2λM + C) x = 1.
#[test]
fn vectors_of_imported_matrices_are_stored() {
    let (results, dataset, page) = eigen("{ re = [-50.0, 50.0], im = [0.0, 400.0] }");
    let (damping, stiffness) = ([1.0, 20.0, -3.0], [1e4, 4e4, 9e4]);
    let (right, left) = (vectors(&dataset, "right_vector"), vectors(&dataset, "left_vector"));
    let lambdas = numbers_of(&results, "re").into_iter().zip(numbers_of(&results, "im"));
    for ((x, y), (re, im)) in right.iter().zip(&left).zip(lambdas) {
        let lambda = Complex64::new(re, im);
        let q = |row: usize, column: usize| match (row, column) {
            (2, 0) => Complex64::from(3e3),
            (row, column) if row == column => lambda * lambda + lambda * damping[row] + stiffness[row],
            _ => Complex64::from(0.0),
        };
        let scale = lambda.norm_sqr();
        for k in 0..3 {
            let image: Complex64 = (0..3).map(|j| q(k, j) * x[j]).sum();
            let left_image: Complex64 = (0..3).map(|j| y[j].conj() * q(j, k)).sum();
            let size = y.iter().map(|y| y.norm()).fold(0.0, f64::max);
            assert!(image.norm() < 1e-10 * scale && left_image.norm() < 1e-10 * scale * size);
        }
        let product: Complex64 = (0..3).map(|k| y[k].conj() * (2.0 * lambda + damping[k]) * x[k]).sum();
        assert!((product - 1.0).norm() < 1e-9, "{product}");
        assert!((x.iter().map(|x| x.norm()).fold(0.0, f64::max) - 1.0).abs() < 1e-12);
    }
    let VariableValues::Text(names) = &dataset.variable("freedom").unwrap().data else { panic!("words") };
    assert_eq!(names, &["a x", "b x", "b y"]);
    // the fastest growing first: b along y at 300 rad/s, where nothing else moves
    let shape = &results["shapes"][0];
    assert_eq!(shape["mode"], 3);
    assert_eq!(numbers(&shape["modulus"]).iter().map(|own| own.round()).collect::<Vec<_>>(), [0.0, 0.0, 1.0]);
    assert!(page.contains("Shape of mode 3") && page.contains("b y"));
}
