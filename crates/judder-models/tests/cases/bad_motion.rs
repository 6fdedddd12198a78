//! Analyses of motion that are refused.

use super::bad_analysis::{analysis, beside_sweep};
use super::refused;

#[test]
fn a_coordinate_that_the_model_does_not_have() {
    refused(
        "model = \"belt\"\n[[analysis]]\nkind = \"motion\"\nstart = { x = 1, velocity_y = 0 }",
        "unknown key `velocity_y` in `start`",
        "velocity_y",
        "did you mean `velocity_x`? keys here: disturbance, x, velocity_x",
    );
}

#[test]
fn a_start_that_says_nothing() {
    refused(
        &analysis("motion", "start = {}"),
        "`start` lacks the key `disturbance`",
        "{}",
        "give disturbance = 0.2, or x = …, the coordinates of the start",
    );
}

#[test]
fn a_disturbance_beside_a_state() {
    refused(
        &analysis("limit-cycle", "start = { disturbance = 0.1, x = 17.5 }"),
        "`start.x` together with `start.disturbance`: both say the same thing",
        "17.5",
        "keep `start.disturbance` or `start.x`",
    );
}

#[test]
fn a_transient_that_leaves_nothing() {
    refused(
        &analysis("motion", "duration = 100\ntransient = 100.0"),
        "the transient of 100.0 leaves nothing of the duration of 100.0",
        "100.0",
        "let `transient` be shorter than `duration`",
    );
}

#[test]
fn times_of_two_forms() {
    refused(
        &analysis("motion", "duration = \"5 s\"\ntransient = 10"),
        "`duration` and `transient` mix plain numbers with units",
        "10",
        "use plain numbers throughout, or units throughout",
    );
}

#[test]
fn a_time_with_a_unit_on_a_belt() {
    refused(
        "model = \"belt\"\n[[analysis]]\nkind = \"motion\"\nduration = \"5 s\"",
        "`duration` is a string, but must be a plain number",
        "\"5 s\"",
        "",
    );
}

#[test]
fn a_tolerance_below_rounding() {
    refused(
        &analysis("limit-cycle", "tolerance = 1e-15"),
        "`tolerance` must be above 1e-14 and at most 0.01, but is 1e-15",
        "1e-15",
        "",
    );
}

#[test]
fn a_basin_without_ranges() {
    refused(
        &analysis("basin", ""),
        "an analysis of kind `basin` lacks the key `within`",
        "[[analysis]]",
        "give within = { x = [from, to], velocity_x = [from, to] }, the ranges of the starts",
    );
    refused(
        &analysis("basin", "within = {}"),
        "`within` lacks the key `x`",
        "{}",
        "give x = [from, to], the range of a coordinate",
    );
}

#[test]
fn a_range_that_is_none() {
    refused(
        &analysis("basin", "within = { x = [2, 1] }"),
        "the range runs backwards: from 2.0 to 1.0",
        "[2, 1]",
        "exchange its two ends",
    );
    refused(
        &analysis("basin", "within = { x = [1, 2, 3] }"),
        "`within.x` has 3 entries, but must have two numbers, [from, to]",
        "[1, 2, 3]",
        "give two numbers, [from, to]",
    );
}

#[test]
fn a_direction_that_is_none() {
    refused(
        &analysis(
            "bifurcation",
            "sweep = { key = \"operation.velocity\", from = 1e-5, to = 1e-3, points = 5 }\ndirection = \"up\"",
        ),
        "unknown direction `up`",
        "up",
        "known: both, forward, backward",
    );
}

#[test]
fn branches_and_margins_that_are_neither_true_nor_false() {
    let sweep = "sweep = { key = \"operation.velocity\", from = 1e-5, to = 1e-3, points = 5 }";
    refused(
        &analysis("bifurcation", &format!("{sweep}\nbranches = \"yes\"")),
        "`branches` is a string, but must be true or false",
        "\"yes\"",
        "",
    );
    refused(
        &analysis("critical-load", &format!("{sweep}\nglobal_margin = 1")),
        "`global_margin` is an integer, but must be true or false",
        "1",
        "",
    );
}

#[test]
fn a_margin_of_a_kind_that_has_none() {
    refused(
        &beside_sweep("spectrum", "global_margin = true"),
        "unknown key `global_margin` in an analysis of kind `spectrum`",
        "global_margin",
        "keys here: name, kind, sweep, family",
    );
    refused(
        "model = \"two-degrees\"\n[parameters]\nmu = 1\nc = 1\n[matrices]\nstiffness = [[1, 0], [0, 1]]\n[[analysis]]\n\
         kind = \"stability-map\"\nglobal_margin = true\n\
         x = { key = \"parameters.mu\", from = 0, to = 1, points = 2 }\ny = { key = \"parameters.c\", from = 0, to = 1, points = 2 }",
        "unknown key `global_margin` in an analysis of kind `stability-map`",
        "global_margin",
        "keys here: name, kind, x, y, method, boundaries",
    );
}

#[test]
fn no_steps_at_all() {
    refused(
        &analysis("motion", "steps = 0"),
        "`steps` must be a whole number from 1 to 1000000000000, but is 0",
        "0",
        "give a number from 1 to 1000000000000",
    );
}

#[test]
fn a_key_of_another_model() {
    refused(
        "model = \"belt\"\n[friction]\nshear_strength = 1\n",
        "unknown key `shear_strength` in [friction]",
        "shear_strength",
        "keys here: at_rest, at_speed, decay_speed, viscous, exponent, velocity, coefficient, file, interpolation",
    );
    refused(
        "model = \"contact\"\n[[analysis]]\nkind = \"basin\"\n",
        "the analysis kind `basin` belongs to another model",
        "basin",
        "available: contact, contact-law, fit, modulus, transient",
    );
}

#[test]
fn friction_of_a_belt_that_cannot_be() {
    let belt = |friction: &str| format!("model = \"belt\"\n[friction]\n{friction}\n");
    let table = "velocity = [0, 1]\ncoefficient = [1.0, 0.5]";
    refused(
        &belt(&format!("{table}\nat_rest = 1.0")),
        "`friction.velocity` together with `friction.at_rest`: both say the same thing",
        "[0, 1]",
        "keep `friction.at_rest` or `friction.velocity`",
    );
    refused(
        &belt("velocity = [\"0 m/s\", \"1 m/s\"]\ncoefficient = [1.0, 0.5]"),
        "`friction.velocity` has a unit, but the case is in units of its mass and its natural frequency",
        "[\"0 m/s\", \"1 m/s\"]",
        "give both: mass = \"1 kg\", stiffness = \"100 N/m\"; then every key of the case has its unit",
    );
    refused(
        &belt("velocity = [1, 0]\ncoefficient = [1.0, 0.5]"),
        "the speeds of the table of friction must ascend, but 0 follows 1",
        "[1, 0]",
        "list them from the smallest to the largest, none twice",
    );
    refused(&belt("exponent = 0.5"), "`friction.exponent` must be from 1 to 10, but is 0.5", "0.5", "");
    let sweep = "sweep = { key = \"friction.at_rest\", from = 0.5, to = 2, points = 5 }";
    refused(
        &belt(&format!("{table}\n[[analysis]]\nkind = \"bifurcation\"\n{sweep}")),
        "`friction.at_rest` has no meaning with a table of friction",
        "friction.at_rest",
        "leave `friction.at_rest` out",
    );
}

#[test]
fn a_belt_with_units_here_and_none_there() {
    let units = "model = \"belt\"\n[oscillator]\nmass = \"1 kg\"\nstiffness = \"100 N/m\"\n";
    let whole = format!(
        "{units}[friction]\ndecay_speed = \"5 mm/s\"\n[operation]\nvelocity = \"15 mm/s\"\nnormal_force = \"0.1 N\"\n"
    );
    let analysis = |own: &str| format!("{whole}[[analysis]]\n{own}\n");
    assert!(
        super::parse(&analysis("kind = \"motion\"\nduration = \"2 s\"\nstart = { x = \"1 mm\" }"), &[])
            .is_ok()
    );
    let both = "give both: mass = \"1 kg\", stiffness = \"100 N/m\"; then every key of the case has its unit";
    refused(
        "model = \"belt\"\n[operation]\nvelocity = \"15 mm/s\"\n",
        "`operation.velocity` has a unit, but the case is in units of its mass and its natural frequency",
        "\"15 mm/s\"",
        both,
    );
    refused(
        "model = \"belt\"\noscillator = { mass = \"1 kg\" }\n",
        "the case gives one of `oscillator.mass` and `oscillator.stiffness` alone",
        "{ mass = \"1 kg\" }",
        both,
    );
    refused(
        &whole.replace("\"15 mm/s\"", "15"),
        "`operation.velocity` needs a unit, as `oscillator.mass` and `oscillator.stiffness` have one",
        "15",
        "write velocity = \"30 mm/s\"",
    );
    refused(
        &analysis("kind = \"motion\"\nstart = { x = 1 }"),
        "`start.x` needs a unit: it has no dimensionless form",
        "1",
        "write a length, such as \"10 mm\"",
    );
    refused(
        &analysis(
            "kind = \"bifurcation\"\nsweep = { key = \"operation.velocity\", from = 1, to = 2, points = 3 }",
        ),
        "`operation.velocity` needs a unit, as `oscillator.mass` and `oscillator.stiffness` have one",
        "{ key = \"operation.velocity\", from = 1, to = 2, points = 3 }",
        "write velocity = \"30 mm/s\"",
    );
    refused(
        "model = \"belt\"\n[[analysis]]\nkind = \"motion\"\nduration = \"2 s\"\n",
        "`duration` is a string, but must be a plain number",
        "\"2 s\"",
        "",
    );
    refused(
        "model = \"belt\"\n[[analysis]]\nkind = \"bifurcation\"\nsweep = { key = \"oscillator.mass\", from = \"1 kg\", to = \"2 kg\", points = 3 }\n",
        "`oscillator.mass` has no meaning with a case without units",
        "oscillator.mass",
        "leave `oscillator.mass` out",
    );
}

#[test]
fn a_sound_of_what_has_no_seconds() {
    let said = "`sound` is asked of a motion in groups, which has no seconds";
    let asked = "kind = \"motion\"\nduration = 100\nsound = true";
    for (case, help) in [
        (
            "model = \"belt\"\n",
            "give both: mass = \"1 kg\", stiffness = \"100 N/m\"; then every key of the case has its unit",
        ),
        (
            "model = \"oscillator\"\n[operation]\nvelocity = 1e-4\nnormal_load = 1e-6\n",
            "give `operation.velocity` or `operation.normal_load` in SI",
        ),
    ] {
        refused(&format!("{case}[[analysis]]\n{asked}\n"), said, "true", help);
    }
    let silent = "model = \"belt\"\n[[analysis]]\nkind = \"motion\"\nsound = false\n";
    assert!(super::parse(silent, &[]).is_ok());
}

#[test]
fn friction_in_a_file_that_cannot_be_used() {
    let folder = tempfile::tempdir().unwrap();
    let message = |content: &str| {
        std::fs::write(folder.path().join("mu.csv"), content).unwrap();
        let path = folder.path().join("case.toml");
        std::fs::write(&path, "model = \"belt\"\n[friction]\nfile = \"mu.csv\"\n").unwrap();
        judder_models::read(&path, &[]).map(|_| ()).unwrap_err().to_string()
    };
    for (content, said) in [
        ("", "there are no numbers"),
        ("0,1\n1,0.5\n", "must be a header such as `speed,coefficient`"),
        (
            "speed [m/s],coefficient\n0,1\n",
            "`friction.velocity` has a unit, but the case is in units of its mass",
        ),
        ("speed,coefficient\n0,1\n0,0.5\n", "the speeds of the table of friction must ascend"),
        ("speed,coefficient\n0,-1\n", "a friction coefficient is -1: it must be finite and not negative"),
        (
            "speed [mm/s],coefficient\n-30,1\n",
            "the speeds of the table of friction must be zero or positive, but one is -30 mm/s",
        ),
        ("speed,coefficient\n0,x\n", "`x` in line 2 is no finite number"),
    ] {
        let message = message(content);
        assert!(message.contains(said), "{message}");
    }
}

#[test]
fn a_width_with_a_unit() {
    refused(
        &analysis("engines", "width = { from = \"1 mm/s\", to = 1 }"),
        "`width.from` is a string, but must be a plain number",
        "\"1 mm/s\"",
        "",
    );
}

#[test]
fn engines_on_a_belt() {
    refused(
        "model = \"belt\"\n[[analysis]]\nkind = \"engines\"",
        "the analysis kind `engines` belongs to another model",
        "engines",
        "available: motion, limit-cycle, bifurcation, basin",
    );
}
