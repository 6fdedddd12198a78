//! Sweeps, families, root ranges and maps that are refused.

use super::bad_analysis::{analysis, beside_sweep};
use super::refused;

fn sweep(settings: &str) -> String {
    analysis("spectrum", &format!("sweep = {{ {settings} }}"))
}

fn map(x: &str, y: &str) -> String {
    analysis("stability-map", &format!("x = {{ {x} }}\ny = {{ {y} }}"))
}

#[test]
fn a_key_of_another_kind() {
    refused(
        &beside_sweep("spectrum", "within = { from = 1, to = 2 }"),
        "unknown key `within` in an analysis of kind `spectrum`",
        "within",
        "keys here: name, kind, sweep, family",
    );
}

#[test]
fn a_missing_end() {
    refused(
        &sweep(r#"key = "operation.velocity", from = 1e-8, points = 5"#),
        "`sweep` lacks the key `to`",
        r#"{ key = "operation.velocity", from = 1e-8, points = 5 }"#,
        "give to = …, the value at this end",
    );
}

#[test]
fn an_unknown_key_of_a_sweep() {
    refused(
        &sweep(r#"key = "operation.velocity", from = 1e-8, to = 1, point = 5"#),
        "unknown key `point` in `sweep`",
        "point",
        "did you mean `points`? keys here: key, from, to, points, scale",
    );
}

#[test]
fn a_sweep_of_a_key_that_does_not_exist() {
    refused(
        &sweep(r#"key = "operation.speed", from = 1e-8, to = 1, points = 5"#),
        "unknown swept key `operation.speed`",
        "operation.speed",
        "known: KEYS",
    );
}

#[test]
fn a_swept_key_without_its_section() {
    refused(
        &sweep(r#"key = "velocity", from = 1e-8, to = 1, points = 5"#),
        "unknown swept key `velocity`",
        "velocity",
        "did you mean `operation.velocity`? known: KEYS",
    );
}

#[test]
fn a_sweep_of_a_key_that_is_not_numeric() {
    refused(
        &sweep(r#"key = "contact.law", from = 1e-8, to = 1, points = 5"#),
        "`contact.law` is not numeric, so it cannot be swept",
        "contact.law",
        "available: KEYS",
    );
}

#[test]
fn an_empty_range() {
    refused(
        &sweep(r#"key = "operation.velocity", from = 1e-4, to = 1e-4, points = 5"#),
        "the range is empty: from and to are both 0.0001",
        r#"{ key = "operation.velocity", from = 1e-4, to = 1e-4, points = 5 }"#,
        "let `from` and `to` differ",
    );
}

#[test]
fn a_sweep_of_one_point() {
    refused(
        &sweep(r#"key = "operation.velocity", from = 1e-4, to = 1, points = 1"#),
        "a sweep has at least 2 points, not 1",
        "1",
        "count both ends",
    );
}

#[test]
fn points_that_are_no_integer() {
    refused(
        &sweep(r#"key = "operation.velocity", from = 1e-4, to = 1, points = 40.5"#),
        "`sweep.points` is a number, but must be an integer",
        "40.5",
        "",
    );
}

#[test]
fn a_log_range_through_zero() {
    refused(
        &sweep(
            r#"key = "oscillator.coupling_angle", from = "-45 deg", to = "45 deg", points = 5, scale = "log""#,
        ),
        "a logarithmic range cannot touch or pass zero: -45 deg to 45 deg",
        r#"{ key = "oscillator.coupling_angle", from = "-45 deg", to = "45 deg", points = 5, scale = "log" }"#,
        r#"let both ends have one sign, or use scale = "linear""#,
    );
}

#[test]
fn a_log_range_from_zero() {
    refused(
        &sweep(r#"key = "contact.shear_strength", from = 0, to = 1, points = 5, scale = "log""#),
        "a logarithmic range cannot touch or pass zero: 0.0 to 1.0",
        r#"{ key = "contact.shear_strength", from = 0, to = 1, points = 5, scale = "log" }"#,
        r#"let both ends have one sign, or use scale = "linear""#,
    );
}

#[test]
fn an_unknown_scale() {
    refused(
        &sweep(r#"key = "operation.velocity", from = 1e-4, to = 1, points = 5, scale = "logarithmic""#),
        "unknown scale `logarithmic`",
        "logarithmic",
        "known: linear, log",
    );
}

#[test]
fn an_end_outside_the_range_of_its_key() {
    refused(
        &sweep(r#"key = "operation.velocity", from = -1.0, to = 1, points = 5"#),
        "`sweep.from` must be positive, but is -1.0",
        "-1.0",
        "",
    );
}

#[test]
fn an_end_of_the_wrong_dimension() {
    refused(
        &sweep(r#"key = "operation.velocity", from = "1 mm", to = "2 mm/s", points = 5"#),
        "`sweep.from` must be a speed, but this is a length",
        r#""1 mm""#,
        r#"write a speed, such as "30 mm/s", or a plain number: v_d τ/R"#,
    );
}

#[test]
fn ends_of_two_forms() {
    refused(
        &sweep(r#"key = "operation.velocity", from = 1e-8, to = "2 mm/s", points = 5"#),
        "`sweep.from` and `sweep.to` mix plain numbers with units",
        r#""2 mm/s""#,
        "use plain numbers throughout, or units throughout",
    );
}

#[test]
fn a_sweep_past_the_rubbery_modulus() {
    refused(
        &sweep(r#"key = "substrate.glassy_modulus", from = "20 MPa", to = "0.1 MPa", points = 5"#),
        "the glassy modulus 1e5 Pa is not above the rubbery modulus 1e6 Pa",
        r#"{ key = "substrate.glassy_modulus", from = "20 MPa", to = "0.1 MPa", points = 5 }"#,
        r#"E∞ must be above E0; only the law "hertz" takes E∞ = E0"#,
    );
}

#[test]
fn a_family_of_the_swept_key() {
    refused(
        &beside_sweep("spectrum", r#"family = { key = "operation.velocity", values = [1e-4] }"#),
        "`operation.velocity` stands for both the sweep and the family of this analysis",
        "operation.velocity",
        "take two different quantities",
    );
}

#[test]
fn a_family_without_values() {
    refused(
        &beside_sweep("spectrum", r#"family = { key = "contact.shear_strength", values = [] }"#),
        "`family.values` is an empty list",
        "[]",
        "give at least one value, or leave the table out",
    );
}

#[test]
fn a_family_of_two_forms() {
    refused(
        &beside_sweep("spectrum", r#"family = { key = "contact.shear_strength", values = [0.1, "1 kPa"] }"#),
        "`family.values` mix plain numbers with units",
        r#""1 kPa""#,
        "use plain numbers throughout, or units throughout",
    );
}

#[test]
fn a_family_past_the_rubbery_modulus() {
    refused(
        &beside_sweep(
            "spectrum",
            r#"family = { key = "substrate.rubbery_modulus", values = ["1 MPa", "20 MPa"] }"#,
        ),
        "the glassy modulus 1e7 Pa is not above the rubbery modulus 2e7 Pa",
        r#""20 MPa""#,
        r#"E∞ must be above E0; only the law "hertz" takes E∞ = E0"#,
    );
}

#[test]
fn a_sweep_of_what_is_sought() {
    refused(
        &analysis(
            "critical-load",
            r#"sweep = { key = "operation.normal_load", from = 1e-8, to = 1, points = 5 }"#,
        ),
        "`operation.normal_load` stands for both the sweep and the sought quantity of this analysis",
        "operation.normal_load",
        "take two different quantities",
    );
}

#[test]
fn a_family_of_what_is_sought() {
    refused(
        &beside_sweep("critical-load", r#"family = { key = "operation.normal_load", values = [1e-6] }"#),
        "`operation.normal_load` stands for both the family and the sought quantity of this analysis",
        r#"{ key = "operation.normal_load", values = [1e-6] }"#,
        "take two different quantities",
    );
}

#[test]
fn a_root_range_from_zero() {
    refused(
        &beside_sweep("critical-shear-strength", "within = { from = 0, to = 1 }"),
        "`within.from` must be positive, but is 0.0",
        "0",
        "",
    );
}

#[test]
fn a_root_range_backwards() {
    refused(
        &beside_sweep("critical-shear-strength", "within = { from = 1, to = 1e-3 }"),
        "the range runs backwards: from 1.0 to 0.001",
        "{ from = 1, to = 1e-3 }",
        "exchange its two ends",
    );
}

#[test]
fn an_empty_root_range() {
    refused(
        &beside_sweep("critical-shear-strength", "within = { from = 1, to = 1 }"),
        "the range is empty: from and to are both 1.0",
        "{ from = 1, to = 1 }",
        "let `from` and `to` differ",
    );
}

#[test]
fn a_map_of_one_key() {
    refused(
        &map(
            r#"key = "substrate.retardation_time", from = "1 ms", to = "1 s", points = 5"#,
            r#"key = "substrate.relaxation_time", from = "1 ms", to = "1 s", points = 5"#,
        ),
        "`substrate.relaxation_time` stands for both the x and the y of this analysis",
        "substrate.relaxation_time",
        "take two different quantities",
    );
}

#[test]
fn a_map_of_a_thousand_million_points() {
    refused(
        &map(
            r#"key = "operation.velocity", from = 1e-8, to = 1, points = 40000"#,
            r#"key = "contact.shear_strength", from = 0, to = 1, points = 25_000"#,
        ),
        "40000 × 25000 = 1000000000 points need 14.9 GiB of memory",
        "40000",
        "the limit is 2.0 GiB: at most 134217728 points in all",
    );
}

#[test]
fn a_sweep_of_a_thousand_million_points() {
    refused(
        &sweep(r#"key = "operation.velocity", from = 1e-8, to = 1, points = 1_000_000_000"#),
        "1000000000 points need 14.9 GiB of memory",
        "1_000_000_000",
        "the limit is 2.0 GiB: at most 134217728 points in all",
    );
}

#[test]
fn an_unknown_method() {
    refused(
        &analysis(
            "stability-map",
            r#"x = { key = "operation.velocity", from = 1e-8, to = 1, points = 4 }
y = { key = "contact.shear_strength", from = 0, to = 1, points = 5 }
method = "every point""#,
        ),
        "unknown method `every point`",
        "every point",
        "did you mean `every-point`? known: adaptive, every-point",
    );
}

#[test]
fn a_flag_that_is_no_boolean() {
    refused(
        &analysis(
            "stability-map",
            r#"x = { key = "operation.velocity", from = 1e-8, to = 1, points = 4 }
y = { key = "contact.shear_strength", from = 0, to = 1, points = 5 }
boundaries = "yes""#,
        ),
        "`boundaries` is a string, but must be true or false",
        r#""yes""#,
        "",
    );
}

#[test]
fn a_name_that_leaves_the_folder() {
    refused(
        &beside_sweep("spectrum", r#"name = "../map""#),
        "`../map` cannot name an analysis",
        r#""../map""#,
        "use 1 to 100 of A-Z a-z 0-9 . _ - and no leading dot: the name becomes a file name",
    );
}

#[test]
fn an_empty_name() {
    refused(
        &beside_sweep("spectrum", r#"name = """#),
        "`` cannot name an analysis",
        r#""""#,
        "use 1 to 100 of A-Z a-z 0-9 . _ - and no leading dot: the name becomes a file name",
    );
}
