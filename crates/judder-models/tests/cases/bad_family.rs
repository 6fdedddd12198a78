//! Families of complex modes that are refused.

use super::help_of;
use super::structure::{FILES, MATRICES, with_files};

/// The message, place and help of a second parameter with a `family`.
fn family(lines: &str, message: &str, place: &str, help: &str) {
    let with_load = MATRICES.replacen("speed = 2", "speed = 2\nload = 1\nidle = 1", 1).replacen(
        "factor = \"speed\"",
        "factor = \"speed/load\"",
        1,
    );
    let error = with_files(&FILES, &format!("{with_load}family = {lines}\n"), &[]).unwrap_err();
    let found = error.to_string();
    assert!(found.ends_with(message), "{found}");
    assert_eq!((error.place(), help_of(&error).as_str()), (place, help));
}

#[test]
fn families_that_cannot_be() {
    family(
        "{ key = \"parameters.laod\", values = [1] }",
        "unknown swept key `parameters.laod`",
        "parameters.laod",
        "did you mean `parameters.load`? known: parameters.speed, parameters.load, parameters.idle",
    );
    family(
        "{ key = \"parameters.speed\", values = [1] }",
        "`parameters.speed` stands for both the sweep and the family of this analysis",
        "parameters.speed",
        "take two different quantities",
    );
    family(
        "{ key = \"parameters.load\", values = [] }",
        "`family.values` is an empty list",
        "[]",
        "give at least one value, or leave the table out",
    );
    family(
        "{ key = \"parameters.idle\", values = [1] }",
        "no factor and no entry of a matrix contains the parameter `idle`",
        "parameters.idle",
        "sweep a parameter that a factor or an entry contains",
    );
    family(
        "{ key = \"parameters.load\", values = [1, 0] }",
        "the factor of `G.npz` is inf, at speed = 1, load = 0",
        "0",
        "a factor must be finite: mind division by zero",
    );
}
