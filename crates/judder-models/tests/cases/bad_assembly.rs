//! Assembly cases that are refused.

use super::refused;
use judder_models::parse;
use judder_study::StudyError;

/// The block on a plane of `cases/assembly`, as a text to be spoilt.
const BLOCK: &str = include_str!("../../../../cases/assembly/block-on-plane.toml");
/// The pad on a strip.
const PAD: &str = include_str!("../../../../cases/assembly/pad-on-disc-strip.toml");

/// A case in which one text stands for another, which is there.
fn spoilt(case: &str, from: &str, to: &str) -> String {
    assert!(case.contains(from), "{from}");
    case.replacen(from, to, 1)
}

/// What a case is refused for when its bodies are brought together.
fn unassembled(text: &str) -> (String, String) {
    let file = parse("case.toml", text, &[]).expect("it reads");
    let refused = file.case.preflight(&file, &|_| true).map(drop).expect_err("it is refused");
    let place = match &refused {
        StudyError::Case(error) => error.place().to_owned(),
        _ => String::new(),
    };
    (refused.to_string(), place)
}

#[test]
fn structures_that_slide_on_themselves_or_are_called_alike() {
    refused(
        &spoilt(PAD, "track = { structure = \"strip\"", "track = { structure = \"pad\""),
        "`pad` cannot slide on itself",
        "{ structure = \"pad\", set = \"y-max\" }",
        "let one structure slide on another, or on track = { plane = { normal = [0, 1] } }",
    );
    refused(
        &spoilt(PAD, "name = \"pad\"", "name = \"strip\""),
        "two structures are called `strip`",
        "[[structure]]",
        "give each structure a `name` of its own",
    );
}

#[test]
fn vectors_without_a_direction() {
    refused(
        &spoilt(BLOCK, "normal = [0, 1]", "normal = [0, 0]"),
        "`contact.sole.track.plane.normal` has no direction: all its numbers are zero",
        "{ normal = [0, 0] }",
        "give a vector such as [0, 1] in the plane, [0, 0, 1] in space",
    );
}

#[test]
fn loads_with_a_direction_too_many_and_without_one() {
    let help = "forces and displacements have a direction = \"x\", \"y\" or \"z\"; a pressure acts against the surface";
    refused(
        &spoilt(BLOCK, "direction = \"y\"\n", ""),
        "a load of `displacement` needs a `direction`",
        "[[load]]",
        help,
    );
    refused(
        &spoilt(PAD, "pressure = \"1 MPa\"", "direction = \"y\"\npressure = \"1 MPa\""),
        "a load of `pressure` has no `direction`",
        "\"y\"",
        help,
    );
}

#[test]
fn laws_whose_numbers_make_none() {
    let table = "friction_coefficient = { velocity = [\"0 m/s\", \"1 m/s\"], coefficient = [0.3] }";
    refused(
        &spoilt(BLOCK, "friction_coefficient = 0.5", table),
        "the coefficients of a friction table: there are 1, but must be 2",
        "{ velocity = [\"0 m/s\", \"1 m/s\"], coefficient = [0.3] }",
        "",
    );
}

#[test]
fn bodies_that_cannot_touch() {
    let cases = [
        (spoilt(BLOCK, "\"1 m/s\"", "\"0 m/s\""), "interface `sole` does not slide at (0, 0, 0)"),
        (
            spoilt(BLOCK, "direction = [1, 0]", "direction = [0, 1]"),
            "interface `sole` does not slide at (0, 0, 0)",
        ),
        (
            spoilt(BLOCK, "normal = [0, 1]", "normal = [0, -1]"),
            "the plane's normal (0, -1, 0) points the wrong way",
        ),
        (
            spoilt(BLOCK, "element = \"quad4\", ", ""),
            "a surface of eight-node quadrilaterals cannot be in contact",
        ),
        (spoilt(BLOCK, "set = \"y-min\"", "set = \"bottom\""), "there is no set of nodes named `bottom`"),
        (
            spoilt(BLOCK, "fixed = [\"x\", \"y\"]", "fixed = [\"x\"]"),
            "`y-max` of `block` is not held along y",
        ),
        (spoilt(PAD, "\"8 mm\"]", "\"80 mm\"]"), "no node of `pad.y-min` lies opposite `strip.y-max`"),
        (
            spoilt(PAD, "set = \"y-max\" }\nsliding", "set = \"y-min\" }\nsliding"),
            "no node of `pad.y-min` lies opposite",
        ),
    ];
    for (text, expected) in cases {
        let (message, place) = unassembled(&text);
        assert!(message.starts_with(expected), "{message}");
        assert!(!place.is_empty(), "{message} has no place");
    }
    let side = "[[contact]]\nname = \"side\"\nslider = { structure = \"block\", set = \"x-min\" }\ntrack = { plane = { normal = [1, 0] } }\n\
        sliding = { velocity = \"1 m/s\", direction = [0, 1] }\nfriction_coefficient = 0.1\n\n[[load]]";
    let (message, place) = unassembled(&spoilt(BLOCK, "[[load]]", side));
    assert!(message.starts_with("the contacts `sole` and `side` share node 0 of `block`"), "{message}");
    assert_eq!(place, "{ structure = \"block\", set = \"x-min\" }");
}
