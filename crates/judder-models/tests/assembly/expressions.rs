//! Numbers of an assembly that are expressions of parameters, against the case with the numbers put in.

use super::minimal::results;
use crate::{number, run_into};
use judder_models::parse;
use judder_study::case::file::CaseFile;

const WARM: &str = include_str!("../../../../cases/sweeps/warm-squeal.toml");

/// What each expression of the case is at a temperature, as a case file would have it.
fn put_in(text: &str, temperature: f64) -> String {
    let softer = libm::exp(-0.004 * (temperature - 20.0));
    let numbers = [
        (
            "{ expression = \"20*exp(-0.004*(temperature - 20))\", unit = \"MPa\" }",
            format!("\"{} MPa\"", 20.0 * softer),
        ),
        (
            "{ expression = \"0.5 + 0.005*(temperature - 20)\", unit = \"us\" }",
            format!("\"{} us\"", 0.5 + 0.005 * (temperature - 20.0)),
        ),
        (
            "{ expression = \"2*exp(-0.004*(temperature - 20))\", unit = \"GN/m^3\" }",
            format!("\"{} GN/m^3\"", 2.0 * softer),
        ),
        ("\"0.4 - 0.004*(temperature - 20)\"", format!("{}", 0.4 - 0.004 * (temperature - 20.0))),
    ];
    numbers.iter().fold(text.to_owned(), |text, (expression, number)| {
        assert_eq!(text.matches(expression).count(), 1, "{expression}");
        text.replace(expression, number)
    })
}

/// The case without its sweep, and with these of its analyses.
fn with_analyses(text: &str, wanted: &[&str]) -> String {
    let (body, _) = text.split_once("[[sweep]]").unwrap();
    let (head, analyses) = body.split_once("[[analysis]]").unwrap();
    let kept = analyses.split("[[analysis]]");
    let kept = kept.filter(|own| wanted.iter().any(|name| own.contains(&format!("name = \"{name}\""))));
    kept.fold(head.to_owned(), |text, own| format!("{text}[[analysis]]{own}"))
}

fn read(text: &str, options: &[&str]) -> CaseFile {
    let options: Vec<String> = options.iter().map(|own| (*own).to_owned()).collect();
    parse("case.toml", text, &options).unwrap()
}

/// Eigenvalues at 50 °C are those of the case with the numbers of 50 °C put in, to the bit.
#[test]
fn expressions_are_the_numbers_that_they_give() {
    let text = with_analyses(WARM, &["modes"]);
    let expressed = results(&read(&text, &["parameters.temperature=50"]));
    let put = results(&read(&put_in(&text, 50.0), &[]));
    assert!(!expressed["modes"]["eigenvalues"].as_array().unwrap().is_empty());
    assert_eq!(expressed["modes"]["eigenvalues"], put["modes"]["eigenvalues"]);
    let warm = results(&read(&text, &[]));
    assert_ne!(warm["modes"]["eigenvalues"], put["modes"]["eigenvalues"]);
}

/// The temperature at which the last mode ceases to grow is one at which a mode of the case with the numbers put in neither grows nor decays.
#[test]
fn a_sweep_over_the_temperature_finds_where_nothing_grows_any_more() {
    let results = results(&read(&with_analyses(WARM, &["onset"]), &[]));
    let onsets = results["onset"]["onsets"].as_array().unwrap();
    assert!(!onsets.is_empty());
    let last = onsets.iter().map(|own| number(&own["value"])).fold(f64::MIN, f64::max);
    let growth = |temperature: f64| {
        let text = put_in(&with_analyses(WARM, &["modes"]), temperature);
        super::minimal::fastest(&read(&text, &[]))[0]
    };
    assert!(growth(last - 1.0) > 0.0 && growth(last + 1.0) < 0.0, "{last}");
    assert!(growth(last).abs() < 1e-3 * growth(last - 1.0), "{} at {last}", growth(last));
}

/// The block squeals when it is cold and not when it is hot, and its cycle is that of the case with the numbers put in, to the bit.
#[test]
fn an_uncertain_temperature_has_a_probability_of_squeal() {
    let text = with_analyses(WARM, &["squeal"]);
    let probability = |from: f64, to: f64| {
        let sweep = format!(
            r#"
[[sweep]]
name = "uncertain"
method = "sobol"
points = 4
over = [{{ key = "parameters.temperature", from = {from:?}, to = {to:?} }}]
quantities = ["squeal.unstable"]
probabilities = [{{ quantity = "squeal.unstable", above = 0 }}]
"#
        );
        let folder = tempfile::tempdir().unwrap();
        let report = run_into(folder.path(), &read(&format!("{text}{sweep}"), &[]), &["uncertain"]);
        let told = report.summary.results["uncertain"]["probabilities"][0].clone();
        assert!(told["count"] == 4 && told["unknown"] == 0, "{told}");
        number(&told["value"])
    };
    assert_eq!([probability(5.0, 11.0), probability(76.0, 83.0)], [1.0, 0.0]);
    let expressed = results(&read(&text, &["parameters.temperature=8"]));
    let put = results(&read(&put_in(&text, 8.0), &[]));
    assert!(expressed["squeal"]["level_db"].is_number());
    assert_eq!(expressed["squeal"]["level_db"], put["squeal"]["level_db"]);
}

/// The growth rate follows a temperature through all expressions that have it: its derivative is that of the numbers that they give.
#[test]
fn a_parameter_has_the_derivatives_of_all_that_follows_it() {
    let cures = |paths: &str| format!("harmonics = 7\ncures = [{paths}]");
    let text = with_analyses(WARM, &["squeal"]);
    let text = text.replace(
        "harmonics = 7",
        &cures("\"parameters.temperature\", \"structure.foot.material.youngs_modulus\", \"contact.sole.friction_coefficient\", \"contact.sole.normal.stiffness\", \"structure.foot.damping.rayleigh.beta\""),
    );
    let results = results(&read(&text, &[]));
    let keys = results["squeal"]["cures"]["keys"].as_array().unwrap();
    let of = |key: &str| keys.iter().find(|own| own["key"] == key).unwrap();
    let gain = |key: &str| number(&of(key)["growth_by_change"]);
    assert!((number(&of("structure.foot.material.youngs_modulus")["value"]) - 20e6).abs() < 1e-6);
    // relative changes of the numbers with one of the temperature, at 20 °C
    let chain = -0.08
        * (gain("structure.foot.material.youngs_modulus") + gain("contact.sole.normal.stiffness"))
        - 0.2 * gain("contact.sole.friction_coefficient")
        + 0.2 * gain("structure.foot.damping.rayleigh.beta");
    let own = gain("parameters.temperature");
    assert!((own - chain).abs() < 1e-3 * own.abs(), "{own} {chain}");
}
