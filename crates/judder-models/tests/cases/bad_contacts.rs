//! Contacts of assemblies that are refused: bodies that cannot touch, tracks without faces, sets apart; sizes that are doubted.

use super::bad_assembly::{BLOCK, MASS, PAD, spoilt, unassembled};
use crate::run_into;
use judder_models::parse;
use judder_study::StudyError;
use miette::Diagnostic;

#[test]
fn bodies_that_cannot_touch() {
    let cases = [
        (
            spoilt(BLOCK, "\"1 m/s\"", "\"0 m/s\""),
            "the track of `sole` is at rest: friction there may be anything that it can hold, so that nothing slides steadily",
        ),
        (
            spoilt(&spoilt(BLOCK, "\"1 m/s\"", "\"0 m/s\""), "direction = [1, 0]", "direction = [0, 1]"),
            "interface `sole` does not slide at (0, 0, 0)",
        ),
        (
            spoilt(BLOCK, "direction = [1, 0]", "direction = [0, 1]"),
            "interface `sole` does not slide at (0, 0, 0)",
        ),
        (
            spoilt(BLOCK, "normal = [0, 1]", "normal = [0, -1]"),
            "the plane's normal (0, -1, 0) points the wrong way",
        ),
        (
            spoilt(
                &spoilt(BLOCK, "normal = [0, 1]", "normal = [1, 0]"),
                "direction = [1, 0]",
                "direction = [0, 1]",
            ),
            "the plane's normal (1, 0, 0) points the wrong way: out of the track, towards the slider, it looks against the slider's surface, whose own normal is \
             (0, -1, 0) in the mean; a plane along that surface has the normal (0, 1, 0)",
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

#[test]
fn tracks_without_faces_and_normals_of_surfaces() {
    let second = "[[structure]]\nname = \"disc\"\n[structure.matrices]\nmass = [[1]]\nstiffness = [[100]]\n\
        freedoms = [[\"rim\", \"y\"]]\n\n[[spring]]";
    let two = spoilt(MASS, "[[spring]]", second);
    let track = "track = { plane = { normal = [0, 1] } }";
    let (message, place) =
        unassembled(&spoilt(&two, track, "track = { structure = \"disc\", set = \"rim\" }"));
    assert_eq!(message, "`disc.rim` has no faces that something could slide on");
    assert_eq!(place, "{ structure = \"disc\", set = \"rim\" }");
    let with_normal = "track = { structure = \"strip\", set = \"y-max\", normal = [0, 1] }";
    let (message, place) =
        unassembled(&spoilt(PAD, "track = { structure = \"strip\", set = \"y-max\" }", with_normal));
    assert_eq!(message, "a plane moves with one node, but `strip.y-max` has 61");
    assert_eq!(place, "[0, 1]");
}

/// Sets that look at each other from afar, and that lie near and look the same way: with the nearest distance, both boxes, and what helps.
#[test]
fn sets_apart_say_how_far_and_where_they_lie() {
    let refused = |text: &str| {
        let file = parse("case.toml", text, &[]).unwrap();
        let Err(StudyError::Case(error)) = file.case.preflight(&file, &|_| true).map(drop) else {
            panic!("it is refused")
        };
        (error.to_string(), error.help().map(|help| help.to_string()).unwrap_or_default())
    };
    let (message, help) = refused(&spoilt(PAD, "\"8 mm\"]", "\"80 mm\"]"));
    assert_eq!(
        message,
        "no node of `pad.y-min` lies opposite `strip.y-max` within 0.00119048 m: their nearest nodes are 0.072 m apart, `pad.y-min` lies between (0.035, 0.008, 0) and \
         (0.085, 0.008, 0) m, `strip.y-max` between (0, 0.08, 0) and (0.12, 0.08, 0) m"
    );
    assert!(help.contains("by its `origin`") && help.contains("unit = \"mm\""), "{help}");
    let (message, help) = refused(&spoilt(PAD, "set = \"y-min\" }\ntrack", "set = \"y-max\" }\ntrack"));
    assert!(message.contains("their nearest nodes are 0.0120001 m apart"), "{message}");
    assert!(help.starts_with("name the surfaces that face each other"), "{help}");
    let flat = spoilt(PAD, "\"12 mm\"], cells = [21, 5]", "\"1 mm\"], cells = [21, 1]");
    let (_, help) = refused(&spoilt(&flat, "set = \"y-min\" }\ntrack", "set = \"y-max\" }\ntrack"));
    assert!(help.starts_with("name surfaces that look at each other"), "{help}");
}

#[test]
fn a_contact_that_does_not_slide_says_what_would() {
    let (message, _) = unassembled(&spoilt(BLOCK, "direction = [1, 0]", "direction = [0, 1]"));
    assert!(
        message.ends_with(
            "give `sliding` a velocity or, at rest, a direction along the contact, or a speed about an axis that the contact is not on"
        ),
        "{message}"
    );
}

/// Only a mesh file has a unit that may have been forgotten.
#[test]
fn a_block_of_forty_metres_is_doubted_without_a_unit_that_it_lacks() {
    let text = spoilt(&spoilt(BLOCK, "\"40 mm\"", "\"40 m\""), "\"20 mm\"", "\"20 m\"");
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &parse("case.toml", &text, &[]).unwrap(), &["steady"]);
    let doubt = "`block` is 40 m long: are its lengths meant in this unit? \"40 mm\" is 0.04 m";
    assert!(report.messages.iter().any(|message| message.contains(doubt)), "{:?}", report.messages);
}

/// A block that only a plane holds, which lets it slide on: the motion is named by body and direction.
#[test]
fn what_nothing_holds_is_named() {
    let free = spoilt(BLOCK, "supports = [{ set = \"y-max\", fixed = [\"x\", \"y\"] }]\n", "");
    let text = spoilt(&free, "displacement = \"-20 um\"", "force = \"-1 kN\"");
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &parse("case.toml", &text, &[]).unwrap(), &["steady"]);
    let [refused] = &report.refused[..] else { panic!("{:?}", report.messages) };
    let message = refused.error.to_string();
    assert!(
        message.starts_with(
            "1 rigid motion is held neither by supports nor by contacts: the first moves `block`"
        ) && message.contains("along x")
            && message.ends_with("support it, or let a contact hold it"),
        "{message}"
    );
}
