//! Motions of assemblies that are refused.

use super::bad_assembly::{BLOCK, spoilt, unassembled};
use super::refused;
use crate::with_little_memory;
use judder_models::parse;
use judder_study::{Silent, analyses};

/// The block with one analysis of these lines.
fn with_analysis(lines: &str) -> String {
    let bodies = BLOCK.split("[[analysis]]").next().unwrap_or(BLOCK);
    format!("{bodies}[[analysis]]\nname = \"m\"\n{lines}\n")
}

fn march(lines: &str) -> String {
    with_analysis(&format!("kind = \"march\"\nstep = \"1e-7 s\"\n{lines}"))
}

/// What an analysis that was read is refused for when it runs.
fn refused_running(text: &str) -> String {
    let file = parse("case.toml", text, &[]).expect("it reads");
    analyses::run(&file, 0, &Silent).expect_err("it is refused").to_string()
}

#[test]
fn starts_that_say_too_much_or_too_little() {
    let start = |start: &str| march(&format!("duration = \"1 ms\"\nstart = {start}"));
    let cases = [
        ("{ mode = 2 }", "a mode needs an `amplitude`, its largest displacement"),
        ("{ amplitude = \"1 um\" }", "an `amplitude` is that of a `mode`"),
        ("{ }", "a start has a `velocity`, or a `mode` with an `amplitude`"),
        (
            "{ mode = 2, velocity = [0, 1] }",
            "a start has either a `velocity` or a `mode` with an `amplitude`",
        ),
    ];
    for (given, message) in cases {
        refused(&start(given), message, given, "");
    }
    let two_or_three = "two or three numbers or expressions, along x, y and z";
    refused(
        &start("{ velocity = [1] }"),
        &format!("`start.velocity` has 1 entries, but must have {two_or_three}"),
        "[1]",
        &format!("give {two_or_three}"),
    );
    refused(
        &start("{ velocity = [\"1e-3*r\", 0] }"),
        "unknown symbol `r`",
        "r",
        "did you mean `x`? known symbols: x, y, z, pi; functions: sin cos tan asin acos atan sinh cosh tanh exp ln sqrt abs",
    );
}

#[test]
fn times_that_do_not_go_together() {
    refused(
        &march("duration = \"1 ms\"\ntransient = \"1 ms\""),
        "the transient takes the whole duration: nothing is left to look at",
        "\"1 ms\"",
        "",
    );
    refused(
        &march("duration = \"1e-8 s\""),
        "a step of 1e-7 s is longer than the duration of 1e-8 s",
        "\"1e-7 s\"",
        "",
    );
    refused(
        &march("duration = \"1e5 s\""),
        "1.0e12 steps are more than the 1e10 that a march may have",
        "\"1e-7 s\"",
        "",
    );
    refused(
        &march("method = \"film\"\nduration = \"1 ms\"\nrestitution = 0.5"),
        "`restitution` has no meaning with method = \"film\"",
        "0.5",
        "leave `restitution` out",
    );
    refused(
        &march("duration = \"1 ms\"\ncut_off = \"20 kHz\""),
        "`cut_off` has no meaning with method = \"moreau\"",
        "\"20 kHz\"",
        "leave `cut_off` out",
    );
}

/// One budget for each kind, one refusal in the same words, at the key that decides how much.
#[test]
fn motions_beyond_the_memory_of_the_process() {
    let spoken = |lines: &str| {
        let text = with_analysis(lines).replace("cells = [20, 10]", "cells = [4, 2]");
        with_little_memory(|| unassembled(&text))
    };
    let (message, place) = spoken("kind = \"march\"\nstep = \"1e-7 s\"\nduration = \"50 ms\"");
    assert!(
        message.contains("samples of the signals and of the states of all contact points: "),
        "{message}"
    );
    assert!(message.contains(" of memory are needed, and ") && message.contains("shared among"), "{message}");
    assert_eq!(place, "\"50 ms\"");
    let (message, place) = spoken("kind = \"limit-cycle\"\nharmonics = 9");
    assert!(
        message.contains(
            "9 harmonics of 10 components of contact forces are 190 unknowns, at 16 instants a harmonic: "
        ),
        "{message}"
    );
    assert!(message.contains(" of memory are needed, and ") && message.contains("shared among"), "{message}");
    assert_eq!(place, "9");
}

#[test]
fn an_implicitness_that_gives_energy() {
    let given = |lines: &str| march(&format!("duration = \"1 ms\"\n{lines}"));
    refused(&given("implicitness = 0.4"), "`implicitness` must be from 0.5 to 1, but is 0.4", "0.4", "");
    refused(
        &given("implicitness = 0.8\nrestitution = 0.6"),
        "impacts with `restitution` 0.6 would give energy: `implicitness` is 1/(1 + restitution) = 0.625 at most",
        "0.8",
        "",
    );
    refused(
        &given("method = \"film\"\nimplicitness = 0.8"),
        "`implicitness` has no meaning with method = \"film\"",
        "0.8",
        "leave `implicitness` out",
    );
}

#[test]
fn what_only_a_run_can_see() {
    // a block of few elements, whose modes are found at once
    let refused = |text: String| refused_running(&spoilt(&text, "cells = [20, 10]", "cells = [4, 2]"));
    let long = refused(spoilt(&march("method = \"film\"\nduration = \"1 ms\""), "1e-7 s", "1e-4 s"));
    assert!(long.contains("a step of 0.0001 s is too long"), "{long}");
    let infinite = refused(march("duration = \"1 us\"\nstart = { velocity = [\"1/(y - 0.02)\", 0] }"));
    assert!(infinite.contains("the start is inf at (0, 0.02, 0) m"), "{infinite}");
    let unknown = refused(march("duration = \"1 us\"\nstart = { mode = 40, amplitude = \"1 um\" }"));
    assert!(unknown.contains("there is no mode 40 to start with"), "{unknown}");
    let nowhere = refused(with_analysis("kind = \"growth\"\nstep = \"1e-7 s\"\nfrequency = \"100 Hz\""));
    assert!(nowhere.contains("there is no mode near 100.0 Hz"), "{nowhere}");
}

#[test]
fn cycles_that_cannot_be() {
    let cycle = |lines: &str| with_analysis(&format!("kind = \"limit-cycle\"\n{lines}"));
    refused(
        &cycle("harmonics = 3\nleft_out = 0.02"),
        "`left_out` has no meaning with `harmonics`",
        "0.02",
        "leave `left_out` out",
    );
    refused(
        &cycle(
            "modes = 3\nstart = { march = { step = \"1 us\", duration = \"1 ms\", start = { velocity = [1, 0] } } }",
        ),
        "`modes` has no meaning with `start`",
        "3",
        "leave `modes` out",
    );
    refused(
        &cycle("frequency = \"20 kHz\"\nmodes = 3"),
        "`modes` has no meaning with `frequency`",
        "3",
        "leave `modes` out",
    );
    refused(
        &cycle("method = \"shoting\""),
        "unknown method `shoting`",
        "shoting",
        "did you mean `shooting`? known: harmonic-balance, shooting",
    );
    refused(
        &cycle("steps = 512"),
        "`steps` has no meaning with method = \"harmonic-balance\"",
        "512",
        "leave `steps` out",
    );
    let branch = "kind = \"bifurcation\"\nsweep = { key = \"contact.sole.friction_coefficient\", from = 0.1, to = 0.4, points = 5 }\nharmonics = 500";
    let (message, place) = with_little_memory(|| unassembled(&with_analysis(branch)));
    assert!(message.contains("500 harmonics of 42 components of contact forces"), "{message}");
    assert_eq!(place, "500");
    let whole = "kind = \"bifurcation\"\nsweep = { key = \"structure.block.reduction.count\", from = 10, to = 20, points = 11 }";
    let reduced = with_analysis(whole).replace("[[contact]]", "reduction = { count = 15 }\n\n[[contact]]");
    refused(
        &reduced,
        "`structure.block.reduction.count` cannot be swept: what follows it needs every value between the ends, and with `structure.block.reduction.count` = 13.8197: `structure.block.reduction.count` is a number, but must be an integer",
        "\"structure.block.reduction.count\"",
        "give a key that changes without steps, such as a friction coefficient",
    );
    let by_count = "kind = \"squeal\"\nband = [\"1 kHz\", \"20 kHz\"]\nmargin = { key = \"structure.block.reduction.count\", from = 10, to = 20, points = 3 }";
    let by_count =
        with_analysis(by_count).replace("[[contact]]", "reduction = { count = 15 }\n\n[[contact]]");
    let message = parse("case.toml", &by_count, &[]).expect_err("it is refused").to_string();
    assert!(message.contains("what follows it needs every value between the ends"), "{message}");
    let (message, place) = with_little_memory(|| unassembled(&cycle("harmonics = 500")));
    assert!(
        message.contains("500 harmonics of 42 components of contact forces are 42042 unknowns"),
        "{message}"
    );
    assert_eq!(place, "500");
    let (message, _) = unassembled(&with_analysis("kind = \"squeal\"\nband = [\"1 kHz\", \"20 kHz\"]"));
    assert!(message.contains("modes are ranked by the level of observed points"), "{message}");
    let squeal =
        |keys: &str| with_analysis(&format!("kind = \"squeal\"\nband = [\"1 kHz\", \"20 kHz\"]\n{keys}"));
    let knocks = |rest: &str| {
        squeal(&format!("knocks = {{ at = \"back.y\", impulse = [\"0 N s\", \"1 N s\"], {rest} }}"))
    };
    for (keys, says) in [
        (knocks("step = \"2 s\", duration = \"1 s\""), "a step of 2 s is longer than the duration of 1 s"),
        (
            with_analysis(
                "kind = \"squeal\"\nband = [\"0 Hz\", \"20 kHz\"]\nknocks = { at = \"back.y\", impulse = [\"0 N s\", \"1 N s\"], step = \"1 us\", duration = \"1 s\" }",
            ),
            "give a band that begins above it",
        ),
        (knocks("step = \"1 ns\", duration = \"1000 s\""), "1.0e12 steps are more than the 1e10"),
        (knocks("step = \"5 us\", duration = \"1 s\""), "a step of 5e-6 s does not follow 20000 Hz"),
        (knocks("step = \"1 us\", duration = \"10 ms\""), "there are no 5 periods of 1000 Hz"),
        (
            squeal("margin = { key = \"friction\", from = -1, to = 1, points = 5 }"),
            "a factor on all friction is zero or positive",
        ),
        (squeal("margin = \"friction\""), "`margin` is a string, but must be true, or a table"),
        (
            squeal("cures = [\"contact.sole.friction_coefficient\", \"contact.sole.friction_coefficient\"]"),
            "`contact.sole.friction_coefficient` is named twice among the cures",
        ),
        (squeal("cures = [\"contact.sole.friction\"]"), "is no number that the case gives"),
        (squeal("cures = [\"structure.block.block.cells.0\"]"), "named among the cures, has no derivative"),
        (squeal("cures = \"all\""), "`cures` is a string, but must be true, or a list of dotted paths"),
    ] {
        let message = parse("case.toml", &keys, &[]).expect_err("it is refused").to_string();
        assert!(message.contains(says), "{message}");
    }
    let text = sole();
    let bodies = text.split("[[analysis]]").next().expect("it has bodies");
    let (message, _) = unassembled(&format!("{bodies}[[analysis]]\nkind = \"limit-cycle\"\n"));
    assert!(message.contains("travel along their track: no motion repeats itself there"), "{message}");
}

/// A force on the block that swings.
const SWINGS: &str =
    "forces = [{ structure = \"block\", set = \"x-min\", direction = \"x\", amplitude = \"1 N\" }]";

#[test]
fn responses_that_cannot_be() {
    let response = |lines: &str| with_analysis(&format!("kind = \"frequency-response\"\n{lines}"));
    let swings = |lines: &str| response(&format!("{SWINGS}\n{lines}"));
    refused(
        &response("frequency = [\"1 kHz\", \"2 kHz\"]"),
        "nothing swings: a response needs `forces` with an amplitude, or the acceleration of a `base`",
        "[[analysis]]",
        "",
    );
    refused(
        &swings("frequency = [\"1 kHz\", \"1000 Hz\"]"),
        "the first and the last frequency are the same: a response goes from one to another",
        "[\"1 kHz\", \"1000 Hz\"]",
        "",
    );
    let still = "base = [{ direction = \"y\", amplitude = \"0 m/s^2\" }]";
    refused(
        &response(&format!("frequency = [\"1 kHz\", \"2 kHz\"]\n{still}")),
        "nothing swings: no amplitude is other than zero",
        "[{ direction = \"y\", amplitude = \"0 m/s^2\" }]",
        "",
    );
    let (message, _) = unassembled(&swings("frequency = [\"1 kHz\", \"2 kHz\"]"));
    assert!(message.contains("nothing is observed"), "{message}");
    let observed = "\n[observe]\npoints = [{ name = \"edge\", structure = \"block\", set = \"x-min\" }]\n";
    let (message, place) = with_little_memory(|| {
        unassembled(&(swings("frequency = [\"1 kHz\", \"2 kHz\"]\nharmonics = 500") + observed))
    });
    assert!(
        message.contains("500 harmonics of 42 components of contact forces are 42042 unknowns"),
        "{message}"
    );
    assert_eq!(place, "500");
    let held = SWINGS.replace("x-min", "y-max");
    let (message, place) =
        unassembled(&(response(&format!("{held}\nfrequency = [\"1 kHz\", \"2 kHz\"]")) + observed));
    assert!(message.contains("no node of") && message.contains("is free along x"), "{message}");
    assert_eq!(place, "\"x\"");
}

#[test]
fn observed_points_that_are_not_there() {
    let observed = |points: &str| {
        march("duration = \"1 ms\"").replacen(
            "[[analysis]]",
            &format!("[observe]\npoints = [{points}]\n\n[[analysis]]"),
            1,
        )
    };
    let unknown = observed("{ name = \"edge\", structure = \"block\", set = \"nix\" }");
    let (message, place) = super::bad_assembly::unassembled(&unknown);
    assert!(message.contains("there is no set of nodes named `nix`"), "{message}");
    assert_eq!(place, "\"nix\"");
    let point = "{ name = \"edge\", structure = \"block\", set = \"x-min\" }";
    refused(
        &observed(&format!("{point}, {point}")),
        "two points are called `edge`",
        point,
        "give each point a `name` of its own",
    );
}

/// The sole that travels along a rail.
fn sole() -> String {
    std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/assembly/sole-along-rail.toml"))
        .expect("it is there")
}

#[test]
fn points_that_travel_along_no_edge() {
    let rail = "track = { structure = \"rail\", set = \"y-max\" }";
    refused(
        &spoilt(&sole(), rail, "track = { plane = { normal = [0, 1] } }"),
        "`travel` has no meaning with contact.face.track.plane",
        "\"hermite\"",
        "leave `travel` out",
    );
    refused(
        &spoilt(
            &sole(),
            "sliding = { velocity = \"2 m/s\", direction = [-1, 0] }",
            "sliding = { speed = \"2 rad/s\", axis = [0, 0, 1], centre = [\"0 m\", \"-1 m\"] }",
        ),
        "`travel` has no meaning with contact.face.sliding.axis",
        "\"hermite\"",
        "leave `travel` out",
    );
    refused(
        &spoilt(&sole(), "travel = \"hermite\"", "travel = \"cubic\""),
        "unknown interpolation `cubic`",
        "cubic",
        "known: linear, hermite",
    );
}

#[test]
fn a_way_that_is_longer_than_the_track() {
    let text = spoilt(&sole(), "duration = \"80 ms\"", "duration = \"0.2 s\"");
    let (message, place) = unassembled(&text);
    let expected = "the contact `face` travels 0.22 m and then runs off its track, after 0.11 s: shorten the duration, or begin farther from that end";
    assert_eq!((message.as_str(), place.as_str()), (expected, "\"0.2 s\""));
    // amid the motion, though it comes back
    let turns =
        "duration = \"0.3 s\"\ncourse = { speed = { times = [\"0 s\", \"0.3 s\"], factors = [2, -2] } }";
    let (message, _) = unassembled(&spoilt(&sole(), "duration = \"80 ms\"", turns));
    assert!(
        message.starts_with("the contact `face` travels 0.22 m and then runs off its track"),
        "{message}"
    );
    // by its other end
    let back = "duration = \"0.1 s\"\ncourse = { speed = { times = [\"0 s\"], factors = [-1] } }";
    let (message, _) = unassembled(&spoilt(&sole(), "duration = \"80 ms\"", back));
    assert!(
        message.starts_with("the contact `face` travels 0.06 m and then runs off its track"),
        "{message}"
    );
}
