//! Assembly cases with a sphere that are refused, or run with a warning.

use super::{refused, refused_with};
use judder_models::parse as parse_file;
use judder_study::analyses::run;
use judder_study::{Silent, StudyError};

/// The sphere on a beam of `cases/assembly`, as a text to be spoilt.
const SPHERE: &str = include_str!("../../../../cases/assembly/sphere-on-beam.toml");
/// Its asperity, without the key.
const ASPERITY: &str = "{ radius = \"10 mm\", law = \"oscillator-paper-corrected\", shear_strength = 0.12, friction_load = \"normal-load\" }";

/// The case with one text in place of another, which is there.
fn spoilt(from: &str, to: &str) -> String {
    assert!(SPHERE.contains(from), "{from}");
    SPHERE.replacen(from, to, 1)
}

/// The case with one text from its mark to the next empty line left out.
fn without(mark: &str) -> String {
    let (before, rest) = SPHERE.split_once(mark).expect("the mark is there");
    let (_, after) = rest.split_once("\n\n").expect("an empty line follows");
    format!("{before}{after}")
}

/// What a case is refused for when its bodies are brought together, where, and what would help.
fn unassembled(text: &str) -> [String; 3] {
    let file = parse_file("case.toml", text, &[]).expect("it reads");
    match file.case.preflight(&file, &|_| true).map(drop).expect_err("it is refused") {
        StudyError::Case(error) => [error.to_string(), error.place().to_owned(), super::help_of(&error)],
        other => panic!("{other} has no place"),
    }
}

/// The warnings of steady sliding, and how many numbers are missing.
fn warnings(overrides: &[&str]) -> Vec<String> {
    let overrides: Vec<String> = overrides.iter().map(|own| (*own).to_owned()).collect();
    let file = parse_file("case.toml", SPHERE, &overrides).unwrap();
    run(&file, 0, &Silent).unwrap().warnings
}

#[test]
fn a_sphere_beside_another_law() {
    for (key, value) in [("normal", "\"rigid\""), ("friction_coefficient", "0.3"), ("all_closed", "true")] {
        refused(
            &spoilt("asperity = ", &format!("{key} = {value}\nasperity = ")),
            &format!("`contact.tip.asperity` together with `contact.tip.{key}`: both say the same thing"),
            ASPERITY,
            &format!("keep `contact.tip.{key}` or `contact.tip.asperity`"),
        );
    }
}

#[test]
fn a_sphere_and_its_substrate_without_each_other() {
    refused(
        &without("[substrate]"),
        "`contact.tip.asperity` is a sphere on the substrate of the case, but the case has no `[substrate]`",
        ASPERITY,
        "give the case its substrate: [substrate] with rubbery_modulus, glassy_modulus, retardation_time, as in an oscillator case",
    );
    refused(
        &spoilt(&format!("asperity = {ASPERITY}"), "friction_coefficient = 0.3"),
        "no contact has a sphere that would slide on the `[substrate]`",
        "[substrate]",
        "give a contact asperity = { … }, or leave the substrate out",
    );
}

#[test]
fn laws_that_the_substrate_does_not_have() {
    let terms = "prony = [{ time = \"0.1 ms\", compliance = \"4e-7 1/Pa\" }, { time = \"1 ms\", compliance = \"3e-7 1/Pa\" }]";
    let text = SPHERE.replacen("glassy_modulus = \"10 MPa\"\n", "", 1);
    let (before, after) = text.split_once("retardation_time").unwrap();
    let (_, after) = after.split_once('\n').unwrap();
    refused(
        &format!("{before}{terms}\n{after}"),
        "the law `oscillator-paper-corrected` knows one retardation time only, this substrate has several",
        terms.strip_prefix("prony = ").unwrap(),
        "give one term, or compute the law for this substrate: law = \"bem\"",
    );
    refused(
        &spoilt("glassy_modulus = \"10 MPa\"", "glassy_modulus = \"1 MPa\""),
        "the glassy modulus 1e6 Pa is not above the rubbery modulus 1e6 Pa",
        "\"1 MPa\"",
        "E∞ must be above E0; only the law \"hertz\" takes E∞ = E0",
    );
    refused_with(
        SPHERE,
        &["substrate.relaxation_time=\"1 ms\""],
        "`substrate.relaxation_time` together with `substrate.retardation_time`: both say the same thing",
        "--set \"1 ms\"",
        "keep `substrate.retardation_time` or `substrate.relaxation_time`",
    );
    refused(
        &spoilt("\"oscillator-paper-corrected\"", "\"coulomb\""),
        "unknown contact law `coulomb`",
        "coulomb",
        "known: oscillator-paper, oscillator-paper-corrected, hertz, bem",
    );
    refused(
        &spoilt("\"oscillator-paper-corrected\"", "{ computed = false }"),
        "`computed` of `contact.tip.asperity.law` must be true, or left out",
        "false",
        "",
    );
    refused(
        &spoilt("shear_strength = 0.12", "shear_strength = -0.12"),
        "`contact.tip.asperity.shear_strength` must be zero or positive, but is -0.12",
        "-0.12",
        "",
    );
}

#[test]
fn a_sphere_that_touches_at_many_nodes() {
    let [message, place, help] = unassembled(&spoilt("set = \"end-lower\"", "set = \"end\""));
    assert_eq!(
        message,
        "`oblique.end` has 5 nodes, but the sphere of `tip` touches at one: its law is that of the whole contact"
    );
    assert_eq!(place, "{ structure = \"oblique\", set = \"end\" }");
    assert!(help.starts_with("name a set of one node"), "{help}");
}

#[test]
fn a_sphere_that_nothing_presses_or_something_else() {
    refused(
        &without("[[load]]"),
        "nothing presses the sphere of `tip`: the case has no loads, and it no `normal_load`",
        ASPERITY,
        "press with a [[load]], or give asperity a normal_load, the F_n of an oscillator case",
    );
    let [message, place, help] =
        unassembled(&spoilt("shear_strength = 0.12,", "shear_strength = 0.12, normal_load = \"0.3 N\","));
    assert_eq!(
        message,
        "the sphere of `tip` has a `normal_load` of 3.000000e-1 N, but the loads of the case press it with 2.000000e-1 N"
    );
    assert_eq!(place, "\"0.3 N\"");
    assert!(help.starts_with("leave normal_load out"), "{help}");
    // the same number twice is no contradiction
    let text = spoilt("shear_strength = 0.12,", "shear_strength = 0.12, normal_load = \"0.2 N\",");
    let file = parse_file("case.toml", &text, &[]).unwrap();
    file.case.preflight(&file, &|_| true).unwrap();
    let [message, place, _] = unassembled(&spoilt("\"-0.2 N\"", "\"0.2 N\""));
    assert!(message.starts_with("no contact point is closed in steady sliding"), "{message}");
    assert_eq!(place, ASPERITY);
}

#[test]
fn speeds_and_loads_beyond_the_law_are_told() {
    assert_eq!(warnings(&[]), [] as [&str; 0]);
    let [slow] = &warnings(&["contact.tip.sliding.velocity=\"1 nm/s\""])[..] else { panic!("one warning") };
    assert!(
        slow.starts_with("`tip`: speed v τ/R = 2e-11 is ") && slow.contains("widths from the peak"),
        "{slow}"
    );
    let [deep] = &warnings(&["load.0.force=\"-20 N\""])[..] else { panic!("one warning") };
    assert!(deep.starts_with("`tip`: indentation y/R = 0.") && deep.contains("is beyond 0.1"), "{deep}");
    let [other] = &warnings(&["substrate.glassy_modulus=\"20 MPa\""])[..] else { panic!("one warning") };
    assert!(other.contains("was fitted for E∞/E0 = 10, this substrate has E∞/E0 = 20"), "{other}");
}
