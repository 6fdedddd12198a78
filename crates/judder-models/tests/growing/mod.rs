//! What is told of modes that grow: without energy, and with friction that is a matrix of its own or not.

use crate::{number, run_into};
use judder_study::run::RunReport;
use serde_json::{Value, json};
use std::path::Path;

/// Runs a case on 2 × 2 matrices, each by its name and rows.
fn run(folder: &Path, text: &str, matrices: &[(&str, [[f64; 2]; 2])]) -> RunReport {
    for (name, [[a, b], [c, d]]) in matrices {
        let entries = format!("1 1 {a}\n1 2 {b}\n2 1 {c}\n2 2 {d}\n");
        let text = format!("%%MatrixMarket matrix coordinate real general\n2 2 4\n{entries}");
        std::fs::write(folder.join(format!("{name}.mtx")), text).unwrap();
    }
    let path = folder.join("case.toml");
    std::fs::write(&path, text).unwrap();
    run_into(&folder.join("out"), &judder_models::read(path, &[]).unwrap(), &[])
}

const IDENTITY: [[f64; 2]; 2] = [[1.0, 0.0], [0.0, 1.0]];

/// Divergence on a spring that pushes, with λ = 1, and a mass on such springs that rotates, with λ² of λ⁴ + (2.25 − 2.3) λ² + 1.3: both conserve energy,
/// so what grows has none, and the balance of power is compared all the same.
#[test]
fn conservative_growth_has_no_energy_and_says_so() {
    let skew = [[0.0, 1.5], [-1.5, 0.0]];
    for (damping, stiffness, growth) in [
        ([[0.0; 2]; 2], [[-1.0, 0.0], [0.0, 4.0]], 1.0),
        (skew, [[-1.0, 0.0], [0.0, -1.3]], (0.5 * (1.3_f64.sqrt() + 0.025)).sqrt()),
    ] {
        let folder = tempfile::tempdir().unwrap();
        let text = r#"
            model = "structure"
            [matrices]
            mass = [{ file = "M.mtx" }]
            damping = [{ file = "C.mtx" }]
            stiffness = [{ file = "K.mtx" }]
            [[analysis]]
            name = "e"
            kind = "eigen"
            region = { re = [-3.0, 3.0], im = [-0.1, 4.0] }
        "#;
        let report = run(folder.path(), text, &[("M", IDENTITY), ("C", damping), ("K", stiffness)]);
        let told = &report.summary.results["e"]["diagnosis"][0];
        assert!((number(&told["growth_rate"]) - growth).abs() < 1e-12, "{told}");
        assert_eq!(told["energy"]["sign"], "none");
        assert!(number(&told["energy"]["share"]).abs() < 1e-12);
        assert!(told["sum"].is_null() && told["positive_energy"] == false);
        assert!(told["matrices"].as_array().unwrap().iter().all(|own| own["growth"].is_null()));
        let said = report.messages.iter().filter(|message| message.contains("grows without work")).count();
        assert_eq!(said, 1, "{:?}", report.messages);
        let checks = report.summary.extra["study"]["checks"]["e"].as_array().unwrap();
        let balance = checks.iter().find(|check| check["name"].as_str().unwrap().contains("work")).unwrap();
        assert_eq!(balance["numbers"], 1);
        assert!(number(&balance["figure"]) < 1e-14, "{balance}");
        let page = std::fs::read_to_string(folder.path().join("out/report.html")).unwrap();
        assert!(page.contains("the mode grows without work"));
    }
}

/// Hoffmann's two masses at μ = 1, whose springs alone swing at 1 and √3 rad/s.
fn coupled(stiffness: &str, matrices: &[(&str, [[f64; 2]; 2])]) -> (RunReport, String) {
    let folder = tempfile::tempdir().unwrap();
    let text = format!(
        r#"
        model = "structure"
        [parameters]
        mu = 1.0
        [matrices]
        mass = [{{ file = "M.mtx" }}]
        stiffness = {stiffness}
        [[analysis]]
        name = "modes"
        kind = "modes"
        count = 2
        [[analysis]]
        name = "e"
        kind = "eigen"
        region = {{ re = [-1.0, 1.0], im = [0.1, 3.0] }}
    "#
    );
    let matrices: Vec<_> = matrices.iter().copied().chain([("M", IDENTITY)]).collect();
    let report = run(folder.path(), &text, &matrices);
    let page = std::fs::read_to_string(folder.path().join("out/report.html")).unwrap();
    (report, page)
}

fn frequencies(list: &Value, key: Option<&str>) -> Vec<f64> {
    let hertz = list.as_array().unwrap().iter().map(|own| number(key.map_or(own, |key| &own[key])));
    let mut all: Vec<f64> = hertz.map(|hertz| std::f64::consts::TAU * hertz).collect();
    all.sort_by(f64::total_cmp);
    all
}

/// The pair that couples is that of μ = 0 where the friction is a matrix whose factor a parameter sets, by itself or with others.
#[test]
fn component_modes_are_the_frictionless_pair() {
    let springs = ("K", [[2.0, 1.0], [1.0, 2.0]]);
    let friction = ("friction", [[0.0, -4.0 / 3.0], [0.0, 0.0]]);
    let sum = r#"[{ file = "K.mtx" }, { file = "friction.mtx", factor = "mu", triangle = "as-stored" }]"#;
    let (report, page) = coupled(sum, &[springs, friction]);
    let (modes, e) = (&report.summary.results["modes"], &report.summary.results["e"]);
    for found in [
        frequencies(&modes["frequencies_hz"], None),
        frequencies(&e["diagnosis"][0]["component_modes"], Some("frequency_hz")),
    ] {
        assert!((found[0] - 1.0).abs() < 1e-12 && (found[1] - 3_f64.sqrt()).abs() < 1e-12, "{found:?}");
    }
    assert_eq!(
        (&modes["modes_of"], &e["diagnosis"][0]["component_modes_of"]),
        (&json!("frictionless"), &json!("frictionless"))
    );
    assert!(
        report.messages.iter().any(|told| told.contains("without `friction.mtx`")),
        "{:?}",
        report.messages
    );
    assert!(page.contains("undamped mode 1 without friction at"));
}

/// One matrix of both: half of the friction stays in, 2 ± (1 − 2/3), and every place says of what the modes are.
#[test]
fn modes_of_a_symmetric_part_are_called_so() {
    let (report, page) = coupled(r#"[{ file = "K.mtx" }]"#, &[("K", [[2.0, 1.0 - 4.0 / 3.0], [1.0, 2.0]])]);
    let (modes, e) = (&report.summary.results["modes"], &report.summary.results["e"]);
    let found = frequencies(&modes["frequencies_hz"], None);
    assert!(
        (found[0] - (5_f64 / 3.0).sqrt()).abs() < 1e-12 && (found[1] - (7_f64 / 3.0).sqrt()).abs() < 1e-12
    );
    assert_eq!(
        (&modes["modes_of"], &e["diagnosis"][0]["component_modes_of"]),
        (&json!("symmetric-part"), &json!("symmetric-part"))
    );
    for analysis in ["modes", "e"] {
        let told =
            |message: &&String| message.starts_with(analysis) && message.contains("half of the friction");
        assert_eq!(report.messages.iter().filter(told).count(), 1, "{:?}", report.messages);
    }
    assert!(page.contains("undamped mode 1 of the symmetric part at"));
}
