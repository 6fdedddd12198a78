//! Sliding cases that are refused: the message, the place and what would be right.

use super::sliding::with_analyses;
use super::structure::with_files;
use super::{help_of, parse, refused, refused_with};
use judder_models::sliding::case::SlidingCase;
use judder_models::sliding::case::problem::SlidingProblem;
use judder_models::structure::case::problem::StructureProblem;

/// The case of the beams paper with one thing changed.
fn changed(from: &str, to: &str, message: &str, place: &str, help: &str) {
    let text = with_analyses("");
    assert!(text.contains(from), "{from}");
    refused(&text.replacen(from, to, 1), message, place, help);
}

/// The case of the beams paper with another analysis.
pub(crate) fn analysis(text: &str, message: &str, place: &str, help: &str) {
    refused(&with_analyses(&format!("[[analysis]]\n{text}\n")), message, place, help);
}

#[test]
fn another_number_of_structures() {
    let text = with_analyses("");
    let (head, rest) = text.split_once("[[structure]]").unwrap();
    let (_, rest) = rest.split_once("[[structure]]").unwrap();
    let error = parse(&format!("{head}[[structure]]{rest}"), &[]).unwrap_err();
    assert_eq!(error.to_string(), "a sliding case has two structures, this one has 1");
    assert_eq!(help_of(&error), "give two tables [[structure]]: what slides, and on what it slides");
}

#[test]
fn names_of_structures() {
    changed(
        "name = \"horizontal\"",
        "name = \"beam.2\"",
        "`beam.2` cannot name a structure",
        "\"beam.2\"",
        "use 1 to 100 of A-Z a-z 0-9 _ -: keys such as structure.NAME.width contain it",
    );
    let text = with_analyses("").replace("name = \"horizontal\"", "name = \"oblique\"");
    let error = parse(&text, &[]).unwrap_err();
    assert_eq!(error.to_string(), "there are two structures named `oblique`");
    assert_eq!(help_of(&error), "give each structure a `name` of its own");
    changed(
        "track = { structure = \"horizontal\"",
        "track = { structure = \"horizontl\"",
        "unknown structure `horizontl`",
        "\"horizontl\"",
        "did you mean `horizontal`? known: oblique, horizontal",
    );
}

/// Paths name the structure, so that a message says which of the two is meant.
#[test]
fn keys_of_a_structure_are_named_with_it() {
    changed(
        "length = \"75 mm\"",
        "length = \"75 N\"",
        "`structure.oblique.beam.length` must be a length, but this is a force",
        "\"75 N\"",
        "write a length, such as \"10 mm\"",
    );
    changed(
        "alpha = \"40 1/s\", beta = \"4e-8 s\" } }",
        "alpha = \"-40 1/s\" } }",
        "`structure.horizontal.damping.rayleigh.alpha` must be zero or positive, but is -40 1/s",
        "\"-40 1/s\"",
        "",
    );
    let error = parse(&with_analyses("").replace("poisson_ratio = 0.33, ", ""), &[]).unwrap_err();
    assert_eq!(error.to_string(), "`structure.oblique.material` lacks the key `poisson_ratio`");
    changed(
        "reduction = { count = 20 }",
        "reduction = { kept = [{ nodes = [1] }] }",
        "`structure.oblique.reduction.kept` of a body names sets, not nodes",
        "[1]",
        "as in set = \"end\"",
    );
    let text = with_analyses("").replacen("beam = {", "block = { size = [] }\nbeam = {", 1);
    let error = parse(&text, &[]).unwrap_err();
    let message =
        "the structure `oblique` has `beam` and `block`, but takes one of `beam`, `block`, `disc`, `mesh`";
    assert_eq!(error.to_string(), message);
}

#[test]
fn a_structure_of_nothing() {
    let text = with_analyses("");
    let line = text.lines().find(|line| line.starts_with("beam = ")).unwrap();
    let error = parse(&text.replacen(line, "", 1), &[]).unwrap_err();
    assert_eq!(error.to_string(), "the structure `oblique` lacks the key `beam`");
    let help = "give beam = { … }, block = { … }, disc = { … }, mesh = \"file.msh\" or matrices = { … }";
    assert_eq!(help_of(&error), help);
}

#[test]
fn a_structure_of_arrays() {
    let text = with_analyses("");
    let (from, to) = (text.find("beam = {").unwrap(), text.find("reduction = { count = 20 }").unwrap());
    let arrays = "matrices = { mass = [[1]], freedoms = [[\"end\", \"y\"]] }\n";
    refused(
        &format!("{}{arrays}{}", &text[..from], &text[to..]),
        "the matrices of `oblique` are arrays, but those of a sliding case are files",
        "{ mass = [[1]], freedoms = [[\"end\", \"y\"]] }",
        "write them to files, or take `model = \"assembly\"`, whose bodies may be arrays",
    );
}

#[test]
fn a_structure_that_slides_on_itself() {
    changed(
        "track = { structure = \"horizontal\", set = \"upper-corners\" }",
        "track = { structure = \"oblique\", set = \"upper-corners\" }",
        "`oblique` is both the slider and the track",
        "{ structure = \"oblique\", set = \"upper-corners\" }",
        "let one structure slide on the other",
    );
}

#[test]
fn friction_that_cannot_be() {
    changed(
        "friction_coefficient = 0.3",
        "friction_coefficient = -0.3",
        "`contact.friction_coefficient` must be zero or positive, but is -0.3",
        "-0.3",
        "",
    );
    changed(
        "friction_coefficient = 0.3",
        "friction_coefficient = { velocity = [\"10 mm/s\", \"10 mm/s\"], coefficient = [0.4, 0.3] }",
        "the speeds of the table of friction must ascend, but 10 mm/s follows 10 mm/s",
        "[\"10 mm/s\", \"10 mm/s\"]",
        "list them from the smallest to the largest, none twice",
    );
    changed(
        "friction_coefficient = 0.3",
        "friction_coefficient = { velocity = [\"0 m/s\", \"1 m/s\"], coefficient = [0.4] }",
        "the table of friction has 2 speeds and 1 coefficients",
        "[0.4]",
        "as in { velocity = [\"0 mm/s\", \"10 mm/s\"], coefficient = [0.4, 0.3] }, as many of one as of the other",
    );
    changed(
        "interpolation = \"linear\"",
        "interpolation = \"cubic\"",
        "unknown interpolation `cubic`",
        "cubic",
        "known: linear, hermite",
    );
}

/// The direction is that from start to end; the velocity must agree with it, and nothing slides at zero.
#[test]
fn a_velocity_that_leads_elsewhere() {
    let help = "the velocity is positive where `end` lies beyond `start`, negative where it lies before it";
    for (key, value, message) in [
        ("velocity", "0 mm/s", "a velocity of 0 m/s does not lead from 0.01 m to 0.0985 m"),
        ("velocity", "-30 mm/s", "a velocity of -0.03 m/s does not lead from 0.01 m to 0.0985 m"),
        ("end", "10 mm", "a velocity of 0.03 m/s does not lead from 0.01 m to 0.01 m"),
        ("start", "99 mm", "a velocity of 0.03 m/s does not lead from 0.099 m to 0.0985 m"),
    ] {
        let option = format!("motion.{key}={value}");
        let error = parse(&with_analyses(""), &[&option]).unwrap_err();
        assert_eq!((error.to_string().as_str(), help_of(&error).as_str()), (message, help));
        assert!(key != "velocity" || error.place() == value);
    }
    changed(
        "start = \"10 mm\" ",
        "start = \"-1 mm\" ",
        "`motion.start` must be zero or positive, but is -1 mm",
        "\"-1 mm\"",
        "",
    );
}

#[test]
fn a_motion_without_a_load() {
    let text = with_analyses("");
    let line = text.lines().find(|line| line.starts_with("load = ")).unwrap();
    let error = parse(&text.replace(line, ""), &[]).unwrap_err();
    assert_eq!(error.to_string(), "[motion] lacks the key `load`");
    assert_eq!(help_of(&error), "give load = { set = \"start\", direction = \"y\", force = \"-0.2 N\" }");
    refused_with(
        &text,
        &["motion.load.direction=z"],
        "unknown direction `z`",
        "--set z",
        "did you mean `x`? known: x, y",
    );
}

#[test]
fn points_and_signals() {
    let march = "kind = \"march\"\nmethod = \"ensubs\"\n";
    let known = "known: T.x, T.y, normal-force, tangential-force, sliding-velocity";
    for signal in ["T.z", "A.y", "T.y.jerk", "T.y.velocity.x", "normal"] {
        let error =
            parse(&with_analyses(&format!("[[analysis]]\n{march}signal = \"{signal}\"\n")), &[]).unwrap_err();
        assert_eq!(error.to_string(), format!("unknown signal `{signal}`"));
        assert!(help_of(&error).ends_with(known), "{}", help_of(&error));
    }
    changed(
        "{ name = \"T\", ",
        "{ name = \"T.1\", ",
        "`T.1` cannot name a point",
        "\"T.1\"",
        "use 1 to 100 of A-Z a-z 0-9 _ -: keys such as structure.NAME.width contain it",
    );
}

#[test]
fn places_of_points() {
    let own = "set = \"end-upper\" }]";
    let both = "set = \"end-upper\", at = [\"1 mm\", \"1 mm\"] }]";
    changed(
        own,
        both,
        "`observe.points.set` together with `observe.points.at`: both say the same thing",
        "\"end-upper\"",
        "keep `observe.points.at` or `observe.points.set`",
    );
    changed(
        own,
        "at = [\"1 mm\"] }]",
        "`observe.points.at` has 1 entries, but must have two lengths, x and y",
        "[\"1 mm\"]",
        "give two lengths, x and y",
    );
}

/// What shows only when structures are built has its place by the names of the case.
#[test]
fn problems_of_a_run_have_their_place() {
    let text =
        with_analyses("[[analysis]]\nname = \"m\"\nkind = \"march\"\nmethod = \"film\"\nstep = \"4e-7 s\"\n");
    let file = judder_models::parse("case.toml", &text, &[]).unwrap();
    let found = SlidingProblem::NotOneNode { key: "contact.slider".to_owned(), found: 5 };
    let error = file.error("contact.slider.set", found);
    assert_eq!(
        (error.to_string().as_str(), error.place()),
        ("`contact.slider` names 5 nodes, but must name one", "\"end-lower\"")
    );
    let error = file.error("analysis.m.step", SlidingProblem::StepLimit { step: 4e-7, limit: 3.6e-7 });
    assert_eq!(error.to_string(), "the step 4e-7 s is above the limit of stability, 3.6e-7 s");
    let help =
        "take a step below the limit, such as \"3.2e-7 s\", or leave `step` out: the march then chooses one";
    assert_eq!(help_of(&error), help);
    assert_eq!(error.place(), "\"4e-7 s\"");
    let unknown = StructureProblem::UnknownSet { name: "x".to_owned(), known: Vec::new() };
    let error = file.error("structure.horizontal.beam.length", unknown);
    assert_eq!(error.place(), "\"100 mm\"");
}

/// A track of matrices: nodes by their numbers in the table of freedoms.
const OF_MATRICES: &str = r#"
[[structure]]
name = "horizontal"
matrices = { mass = [{ file = "M.mtx" }], stiffness = [{ file = "K.mtx", factor = "stiffer" }], freedoms = "table.csv" }
reduction = { count = 5 }
"#;

#[test]
fn structures_of_matrices() {
    let text = with_analyses("");
    let (head, rest) = text.split_once("[[structure]]                     # beam 2").unwrap();
    let (_, rest) = rest.split_once("[contact]").unwrap();
    let text = format!("{head}{OF_MATRICES}[contact]{rest}[parameters]\nstiffer = 2\n")
        .replace("set = \"upper-corners\"", "nodes = [3, 4, 5]")
        .replace("set = \"end-upper\"", "nodes = [5]");
    let files = ["M.mtx", "K.mtx", "table.csv"];
    let case = with_files(&files, &text, &[]).unwrap().of::<SlidingCase>().unwrap().clone();
    assert_eq!((case.files().len(), case.values()), (3, vec![2.0]));
    let fails = |from: &str, to: &str, message: &str| {
        assert!(text.contains(from), "{from}");
        let error = with_files(&files, &text.replace(from, to), &[]).unwrap_err();
        assert_eq!(error.to_string(), message);
    };
    fails("nodes = [5]", "nodes = [4, 5]", "`observe.points.nodes` names 2 nodes, but must name one");
    fails(
        "nodes = [3, 4, 5]",
        "nodes = [3]",
        "`contact.track` has 1 entries, but must have two nodes at least",
    );
    fails("nodes = [3, 4, 5]", "nodes = [3, 4, 3]", "the track `3, 4, 3` names node 3 twice");
    fails(
        "nodes = [3, 4, 5]",
        "set = \"edge\"",
        "matrices have no sets: `contact.track` names nodes of the table `matrices.freedoms`",
    );
    fails(
        "reduction = { count = 5 }",
        "damping = {}",
        "`damping` has no meaning with structure.horizontal.matrices",
    );
}
