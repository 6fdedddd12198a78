//! `judder point --json`: its form, and numbers that must hold whatever the law.

use serde_json::Value;

use crate::desk::Desk;

const CASE: &str = "model = \"oscillator\"\n";

/// The document at the paper's values with these keys set.
fn point(settings: &[&str]) -> Value {
    let desk = Desk::with_case(CASE);
    let mut arguments = vec!["point", "case.toml", "--json"];
    for setting in settings {
        arguments.extend(["--set", setting]);
    }
    desk.succeed(&arguments).json()
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect()
}

fn matrix(value: &Value) -> [[f64; 2]; 2] {
    let rows: Vec<_> = value.as_array().unwrap().iter().map(numbers).collect();
    [[rows[0][0], rows[0][1]], [rows[1][0], rows[1][1]]]
}

fn eigenvalues(point: &Value) -> Vec<(f64, f64)> {
    let pairs = point["eigenvalues"].as_array().unwrap();
    pairs.iter().map(numbers).map(|pair| (pair[0], pair[1])).collect()
}

fn determinant(m: [[f64; 2]; 2]) -> f64 {
    m[0][0] * m[1][1] - m[0][1] * m[1][0]
}

fn close(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance * expected.abs().max(1e-300), "{found} is not {expected}");
}

#[test]
fn the_document_has_its_form() {
    let point = point(&[]);
    for (section, keys) in [
        ("groups", &["stiffness", "retardation_time", "radius"][..]),
        ("equilibrium", &["x", "y", "indentation"]),
        ("contact", &["force", "area", "viscoelastic_friction"]),
    ] {
        for key in keys {
            assert!(point[section][key].is_f64(), "{section}.{key}");
        }
    }
    matrix(&point["damping"]);
    matrix(&point["stiffness"]);
    let eigenvalues = eigenvalues(&point);
    assert_eq!(eigenvalues.len(), 4);
    assert!(eigenvalues.is_sorted_by_key(|(real, imaginary)| (*imaginary, *real)));
    for key in ["growth_rate", "equivalent_damping"] {
        assert!(point[key].is_f64(), "{key}");
    }
    assert_eq!(point["verdict"], "unstable");
    let mechanisms =
        ["none", "flutter", "negative-damping", "both", "normal-force-coupling", "destabilised-by-damping"];
    assert!(mechanisms.contains(&point["mechanism"].as_str().unwrap()));
    for key in ["critical_shear_strength", "critical_load"] {
        let roots = numbers(&point[key]);
        assert!(!roots.is_empty() && roots.is_sorted(), "{key}");
    }
}

#[test]
fn the_groups_are_those_of_the_papers_values() {
    // E0* = E0/(1 − ν²) = 4/3 MPa; k_x = 50 N/m, R = 10 mm, ω_nx = 40 rad/s, τ = 10 ms
    let point = point(&[]);
    close(point["groups"]["stiffness"].as_f64().unwrap(), 50.0 / (1e6 / 0.75 * 0.01), 1e-12);
    close(point["groups"]["retardation_time"].as_f64().unwrap(), 40.0 * 0.01, 1e-12);
}

#[test]
fn the_elastic_contact_is_that_of_hertz() {
    let point = point(&["contact.law=hertz"]);
    let indentation = point["equilibrium"]["indentation"].as_f64().unwrap();
    close(point["contact"]["force"].as_f64().unwrap(), 4.0 / 3.0 * indentation.powf(1.5), 1e-9);
    close(point["contact"]["area"].as_f64().unwrap(), std::f64::consts::PI * indentation, 1e-9);
    assert_eq!(point["contact"]["viscoelastic_friction"], 0.0);
}

#[test]
fn the_eigenvalues_are_those_of_the_matrices() {
    for velocity in ["1e-6", "1e-4", "1e-2", "1"] {
        let point = point(&[&format!("operation.velocity={velocity}")]);
        let (damping, stiffness) = (matrix(&point["damping"]), matrix(&point["stiffness"]));
        let eigenvalues = eigenvalues(&point);
        // det(λ² + λ C + K) = λ⁴ + a λ³ + b λ² + c λ + d
        let a = damping[0][0] + damping[1][1];
        let mixed = [[damping[0][0], damping[0][1]], [stiffness[1][0], stiffness[1][1]]];
        let other = [[stiffness[0][0], stiffness[0][1]], [damping[1][0], damping[1][1]]];
        let b = stiffness[0][0] + stiffness[1][1] + determinant(damping);
        let (c, d) = (determinant(mixed) + determinant(other), determinant(stiffness));
        let sum: f64 = eigenvalues.iter().map(|(real, _)| real).sum();
        assert!((sum + a).abs() < 1e-12 * (1.0 + a.abs()), "the sum is minus the trace of C");
        let scale = 1.0 + a.abs() + b.abs() + c.abs() + d.abs();
        for &(real, imaginary) in &eigenvalues {
            let times = |z: (f64, f64)| (z.0 * real - z.1 * imaginary, z.0 * imaginary + z.1 * real);
            let mut value = (1.0, 0.0);
            for coefficient in [a, b, c, d] {
                value = times(value);
                value.0 += coefficient;
            }
            let size = 1.0 + real.hypot(imaginary).powi(4);
            assert!(value.0.hypot(value.1) < 1e-10 * scale * size, "{velocity}: {value:?}");
        }
        let largest = eigenvalues.iter().map(|(real, _)| *real).fold(f64::MIN, f64::max);
        assert_eq!(point["growth_rate"].as_f64().unwrap(), largest);
        assert_eq!(point["verdict"] == "unstable", largest > 0.0, "{velocity}");
    }
}

/// Whether the frequencies of the undamped system have merged: (k11 − k22)² + 4 k12 k21 < 0.
fn flutters(settings: &[&str]) -> bool {
    let k = matrix(&point(settings)["stiffness"]);
    (k[0][0] - k[1][1]).powi(2) + 4.0 * k[0][1] * k[1][0] < 0.0
}

#[test]
fn the_undamped_system_changes_at_its_thresholds() {
    for velocity in ["1e-4", "1e-3"] {
        let speed = format!("operation.velocity={velocity}");
        for (key, roots) in [
            ("contact.shear_strength", "critical_shear_strength"),
            ("operation.normal_load", "critical_load"),
        ] {
            for root in numbers(&point(&[&speed])[roots]) {
                let below = flutters(&[&speed, &format!("{key}={}", 0.999 * root)]);
                let above = flutters(&[&speed, &format!("{key}={}", 1.001 * root)]);
                assert_ne!(below, above, "{key} = {root} at v = {velocity}");
            }
        }
    }
}

#[test]
fn the_text_says_the_same() {
    let desk = Desk::with_case(CASE);
    let text = desk.succeed(&["point", "case.toml"]).stdout;
    assert!(text.starts_with("unstable, by "), "{text}");
    assert!(text.contains("growth rate") && text.contains("critical load"), "{text}");
}

#[test]
fn a_point_without_contact_has_no_answer() {
    // nothing presses: refused by the case
    Desk::with_case(CASE).refused(
        &["point", "case.toml", "--set", "operation.normal_load=0"],
        "`operation.normal_load` must be positive, but is 0.0",
        "out of range",
    );
}

/// Elastic contact: c21 = 0 and c11 = 2ξ_x, so nothing but the inequality of the dampers can destabilise.
#[test]
fn unequal_dampers_are_a_mechanism_of_their_own() {
    let of = |damping_x: &str, damping_y: &str| {
        let keys = [damping_x, damping_y, "contact.law=\"hertz\"", "contact.shear_strength=0.003"];
        let point = point(&keys);
        assert_eq!(matrix(&point["damping"])[1][0], 0.0);
        [point["verdict"].clone(), point["mechanism"].clone()]
    };
    let unequal = of("oscillator.damping_x=0.05", "oscillator.damping_y=0.0005");
    assert_eq!(unequal, ["unstable", "destabilised-by-damping"]);
    let equal = of("oscillator.damping_x=0.025", "oscillator.damping_y=0.025");
    assert_eq!(equal, ["stable", "none"]);
}
