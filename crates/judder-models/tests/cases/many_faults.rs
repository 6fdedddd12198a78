//! All that is wrong with a case is told at once, in the order of the text.

use super::parse;
use judder_keys::error::CaseError;

/// The places of all that is wrong with a case, in the order in which they are told.
fn places(text: &str) -> Vec<String> {
    let (first, others) = parse(text, &[]).expect_err("the case must be refused").split();
    std::iter::once(&first).chain(&others).map(CaseError::place).map(str::to_owned).collect()
}

#[test]
fn an_analysis_with_a_bad_name_an_unknown_key_and_a_bad_value() {
    let text = r#"model = "belt"
[[analysis]]
kind = "motion"
name = "a/b"
durration = 10
points = 1
"#;
    assert_eq!(places(text), ["\"a/b\"", "durration", "1"]);
}

#[test]
fn the_name_of_an_analysis_that_is_wrong_is_taken() {
    let text = r#"model = "belt"
[[analysis]]
kind = "motion"
points = 1
[[analysis]]
kind = "motion"
"#;
    assert_eq!(places(text), ["1", "[[analysis]]"]);
}

#[test]
fn a_varied_table() {
    let text = r#"model = "two-degrees"
parameters = { mu = 0.5 }
matrices = { stiffness = [[2, "1 - mu"], [1, 2]] }
[[analysis]]
kind = "spectrum"
sweep = { key = "parameters.nu", from = 0.0, points = 1, scale = "cubic", steps = 3 }
[[analysis]]
kind = "critical"
sweep = { key = "parameters.mu", from = "x", to = "y" }
"#;
    // the key, the end that lacks, points, scale, and what is no key; then both ends
    let sweep = r#"{ key = "parameters.nu", from = 0.0, points = 1, scale = "cubic", steps = 3 }"#;
    assert_eq!(places(text), [sweep, "parameters.nu", "1", "cubic", "steps", "\"x\"", "\"y\""]);
}

#[test]
fn a_family() {
    let text = r#"model = "oscillator"
[[analysis]]
kind = "spectrum"
sweep = { key = "operation.velocity", from = 1e-8, to = 1e2, points = 21, scale = "log" }
family = { key = "operation.normal_load", values = [-1.0, 1e-3, -2.0], name = "x" }
"#;
    assert_eq!(places(text), ["-1.0", "-2.0", "name"]);
}

/// A fault of a section, of an analysis whose other settings are in order, and of a sweep.
fn of_sections_and_analyses(sections: &str, analysis: &str) -> Vec<String> {
    let sweep = "[[sweep]]\nname = \"a/b\"\nover = [{ key = \"motion.velocity\", from = 1, to = 1, points = 1 }]\nquantities = [\"x.y\"]\n";
    places(&format!("{sections}\n[[analysis]]\n{analysis}\n{sweep}"))
}

#[test]
fn sections_do_not_hide_analyses_and_sweeps() {
    let contact = "model = \"contact\"\n[indenter]\nradius = -1";
    let transient = "kind = \"transient\"\nindentation = -0.01\nstepss = 3";
    let structure = "model = \"structure\"\n[structure]\nbeam = { length = \"1 mm\", thickness = \"1 mm\", elements = [0, 1] }";
    let modes = "kind = \"modes\"\ncount = 0\ncuont = 1";
    let sliding = "model = \"sliding\"\n[motion]\nvelocity = \"x\"";
    let march = "kind = \"march\"\nmethod = \"none\"\nstepp = 1";
    let two_degrees =
        "model = \"two-degrees\"\n[parameters]\nmu = \"1 N\"\n[matrices]\nstiffness = [[2, \"mu\"], [1, 2]]";
    let spectrum = "kind = \"spectrum\"\nsweep = { key = \"parameters.mu\", from = 0, to = 0.5, points = 1 }";
    let matrices = "model = \"structure\"\n[parameters]\nsin = 1\n[matrices]\nmass = [[1]]\nstiffness = [[1]]\n\
        freedoms = [[\"mass\", \"x\"]]";
    for (sections, analysis, expected) in [
        (two_degrees, spectrum, &["\"1 N\"", "1", "\"a/b\"", "1"][..]),
        (matrices, modes, &["sin", "0", "cuont", "\"a/b\"", "1"]),
        (contact, transient, &["-1", "-0.01", "stepss", "\"a/b\"", "1"]),
        (structure, modes, &["0", "cuont", "\"a/b\"", "1"]),
        (sliding, march, &["x", "none", "stepp", "\"a/b\"", "1"]),
    ] {
        let places = of_sections_and_analyses(sections, analysis);
        let mut found = places.iter();
        for place in expected {
            assert!(found.any(|own| own == place), "{place} is not in its order among {places:?}");
        }
    }
}

#[test]
fn complex_modes_along_a_parameter() {
    let text = r#"model = "structure"
parameters = { a = 1.0 }
[matrices]
mass = [{ file = "nothing.mtx" }]
stiffness = [{ file = "nothing.mtx", factor = "a" }]
[[analysis]]
kind = "eigen-sweep"
sweep = { key = "parameters.b", values = [1.0, "x"], scale = "log" }
region = { re = [1.0, 0.0], im = [0.0, 1.0] }
tolerance = 1e-6
"#;
    let places = places(text);
    let mut found = places.iter();
    for place in ["\"nothing.mtx\"", "\"nothing.mtx\"", "\"parameters.b\"", "\"x\"", "scale", "1e-6"] {
        assert!(found.any(|own| own == place), "{place} is not in its order among {places:?}");
    }
}

#[test]
fn a_misspelt_key_is_told_once() {
    let text = "model = \"oscillator\"\n[[analysis]]\nkind = \"spectrum\"\nsweeep = 1\n";
    assert_eq!(places(text), ["sweeep"]);
}
