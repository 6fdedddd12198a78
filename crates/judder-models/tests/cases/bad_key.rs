//! Keys and values that are refused.

use super::refused;

fn key(text: &str) -> String {
    format!("model = \"oscillator\"\n{text}\n")
}

#[test]
fn an_unknown_section() {
    refused(
        &key(r#"[oscilator]
damping_x = 0.1"#),
        "unknown key `oscilator` in an oscillator case",
        "oscilator",
        "did you mean `oscillator`? keys here: title, model, substrate, indenter, contact, oscillator, operation, analysis, sweep",
    );
}

#[test]
fn an_unknown_key() {
    refused(
        &key(r#"[operation]
velocty = 1e-4"#),
        "unknown key `velocty` in [operation]",
        "velocty",
        "did you mean `velocity`? keys here: velocity, normal_load",
    );
}

#[test]
fn a_section_that_is_no_table() {
    refused(&key("operation = 3"), "`operation` is an integer, but must be a table", "3", "");
}

#[test]
fn a_wrong_unit() {
    refused(
        &key(r#"[operation]
velocity = "30 mm""#),
        "`operation.velocity` must be a speed, but this is a length",
        r#""30 mm""#,
        r#"write a speed, such as "30 mm/s", or a plain number: v_d τ/R"#,
    );
}

#[test]
fn a_wrong_unit_of_a_key_without_group() {
    refused(
        &key(r#"[indenter]
radius = "10 ms""#),
        "`indenter.radius` must be a length, but this is a time",
        r#""10 ms""#,
        r#"write a length, such as "10 mm""#,
    );
}

#[test]
fn a_unit_that_does_not_exist() {
    refused(
        &key(r#"[operation]
velocity = "30 mm/fortnight""#),
        "`operation.velocity` is not a speed: unknown unit `fortnight`",
        "fortnight",
        r#"write a speed, such as "30 mm/s"; known units: m g s min h N Pa J W K mol degC Hz rpm rad deg, with the prefixes p n µ (or u) m c k M G"#,
    );
}

#[test]
fn a_text_without_number() {
    refused(
        &key(r#"[operation]
velocity = "fast""#),
        "`operation.velocity` is not a speed: a quantity begins with a number",
        "fast",
        r#"write a speed, such as "30 mm/s""#,
    );
}

#[test]
fn a_number_in_quotes() {
    refused(
        &key(r#"[operation]
velocity = "1e-4""#),
        "`operation.velocity` must be a speed, but this is a plain number",
        r#""1e-4""#,
        r#"without quotes it is v_d τ/R; with a unit, a speed, such as "30 mm/s""#,
    );
}

#[test]
fn a_plain_number_that_needs_a_unit() {
    refused(
        &key(r#"[substrate]
rubbery_modulus = 1e6"#),
        "`substrate.rubbery_modulus` needs a unit: it has no dimensionless form",
        "1e6",
        r#"write a stress, such as "1 MPa""#,
    );
}

#[test]
fn an_angle_without_unit() {
    refused(
        &key(r#"[oscillator]
coupling_angle = 45"#),
        "`oscillator.coupling_angle` needs a unit: it has no dimensionless form",
        "45",
        r#"write an angle, such as "45 deg""#,
    );
}

#[test]
fn a_unit_on_a_pure_number() {
    refused(
        &key(r#"[oscillator]
damping_x = "1 N""#),
        "`oscillator.damping_x` is a string, but must be a plain number",
        r#""1 N""#,
        "",
    );
}

#[test]
fn a_list_in_place_of_a_number() {
    refused(
        &key(r#"[operation]
velocity = [1e-4]"#),
        r#"`operation.velocity` is a list, but must be a plain number (v_d τ/R) or a speed in quotes, such as "30 mm/s""#,
        "[1e-4]",
        "",
    );
}

#[test]
fn a_negative_stiffness() {
    refused(
        &key(r#"[oscillator]
stiffness_x = "-50 N/m""#),
        "`oscillator.stiffness_x` must be positive, but is -50 N/m",
        r#""-50 N/m""#,
        "",
    );
}

#[test]
fn not_a_number() {
    refused(
        &key(r#"[operation]
velocity = nan"#),
        "`operation.velocity` is not a finite number",
        "nan",
        "nan, inf and numbers beyond 1e308 are not values of a case",
    );
}

#[test]
fn an_infinity() {
    refused(
        &key(r#"[contact]
shear_strength = inf"#),
        "`contact.shear_strength` is not a finite number",
        "inf",
        "nan, inf and numbers beyond 1e308 are not values of a case",
    );
}

#[test]
fn a_number_beyond_the_range() {
    refused(
        &key(r#"[contact]
shear_strength = 1e400"#),
        "`contact.shear_strength` is not a finite number",
        "1e400",
        "nan, inf and numbers beyond 1e308 are not values of a case",
    );
}

#[test]
fn a_quantity_beyond_the_range() {
    refused(
        &key(r#"[operation]
normal_load = "1e400 N""#),
        "`operation.normal_load` is not a force: the number is too large",
        "1e400 N",
        r#"write a force, such as "0.2 N""#,
    );
}

#[test]
fn an_incompressible_limit_passed() {
    refused(
        &key(r#"[substrate]
poisson_ratio = 0.51"#),
        "`substrate.poisson_ratio` must be above -1 and at most 0.5, but is 0.51",
        "0.51",
        "",
    );
}

#[test]
fn a_glassy_modulus_below_the_rubbery_one() {
    refused(
        &key(r#"[substrate]
glassy_modulus = "0.5 MPa""#),
        "the glassy modulus 5e5 Pa is not above the rubbery modulus 1e6 Pa",
        r#""0.5 MPa""#,
        r#"E∞ must be above E0; only the law "hertz" takes E∞ = E0"#,
    );
}

#[test]
fn two_times() {
    refused(
        &key(r#"[substrate]
retardation_time = "10 ms"
relaxation_time = "1 ms""#),
        "`substrate.relaxation_time` together with `substrate.retardation_time`: both say the same thing",
        r#""1 ms""#,
        "keep `substrate.retardation_time` or `substrate.relaxation_time`",
    );
}

#[test]
fn a_prony_term_beside_the_glassy_modulus() {
    refused(
        &key(r#"[substrate]
glassy_modulus = "10 MPa"
prony = [{ time = "10 ms", compliance = "9e-7 1/Pa" }]"#),
        "`substrate.prony` together with `substrate.glassy_modulus`: both say the same thing",
        r#"[{ time = "10 ms", compliance = "9e-7 1/Pa" }]"#,
        "keep `substrate.glassy_modulus` or `substrate.prony`",
    );
}

#[test]
fn two_prony_terms() {
    refused(
        &key(r#"[substrate]
prony = [{ time = "10 ms", compliance = "1e-7 1/Pa" }, { time = "1 s", compliance = "2e-7 1/Pa" }]"#),
        "the law `oscillator-paper` knows one retardation time only, this substrate has several",
        r#"[{ time = "10 ms", compliance = "1e-7 1/Pa" }, { time = "1 s", compliance = "2e-7 1/Pa" }]"#,
        "give one term, or compute the law for this substrate: law = \"bem\"",
    );
}

#[test]
fn a_prony_term_that_is_too_soft() {
    refused(
        &key(r#"[substrate]
prony = [{ time = "10 ms", compliance = "1e-6 1/Pa" }]"#),
        "the prony compliance 1e-6 1/Pa is not below 1/E0 = 1e-6 1/Pa",
        r#"[{ time = "10 ms", compliance = "1e-6 1/Pa" }]"#,
        "1/E∞ = 1/E0 − compliance must be positive",
    );
}

#[test]
fn a_prony_term_without_compliance() {
    refused(
        &key(r#"[substrate]
prony = [{ time = "10 ms" }]"#),
        "a prony term lacks the key `compliance`",
        r#"{ time = "10 ms" }"#,
        r#"give compliance = "1e-7 1/Pa""#,
    );
}

#[test]
fn an_unknown_law() {
    refused(
        &key(r#"[contact]
law = "oscillator-papr""#),
        "unknown contact law `oscillator-papr`",
        "oscillator-papr",
        "did you mean `oscillator-paper`? known: oscillator-paper, oscillator-paper-corrected, hertz, bem",
    );
}

#[test]
fn a_law_from_a_file_that_is_not_there() {
    refused(
        &key(r#"[contact]
law = { file = "law.json" }"#),
        "`contact.law.file` names `law.json`, which does not exist",
        r#""law.json""#,
        "a path in a case is relative to the folder of the case file",
    );
}

#[test]
fn a_law_of_the_wrong_type() {
    refused(
        &key(r#"[contact]
law = 1"#),
        "`contact.law` is an integer, but must be a string",
        "1",
        "",
    );
}

#[test]
fn an_unknown_friction_load() {
    refused(
        &key(r#"[contact]
friction_load = "contact""#),
        "unknown friction load `contact`",
        "contact",
        "known: normal-load, contact-force",
    );
}

#[test]
fn a_title_that_is_no_text() {
    refused(&key("title = 3"), "`title` is an integer, but must be a string", "3", "");
}

/// A cylinder, whose law is one of a layer.
#[test]
fn a_cylinder_without_what_it_needs() {
    let line = |substrate: &str, law: &str, length: &str| {
        key(&format!(
            "substrate = {{ {substrate} }}\ncontact = {{ law = \"{law}\" }}\nindenter = {{ shape = \"cylinder\"{length} }}"
        ))
    };
    let (thickness, length) = ("thickness = \"2 mm\"", ", length = \"0.6 m\"");
    refused(
        &line("", "bem", length),
        "a cylinder needs `substrate.thickness`: on a half-space its depth depends on how far away it is measured",
        "\"cylinder\"",
        "give the thickness of the layer, which a rigid base holds",
    );
    refused(
        &line(thickness, "oscillator-paper-corrected", length),
        "the law `oscillator-paper-corrected` is not one of a cylinder",
        "\"cylinder\"",
        "compute it on the layer of the case: law = \"bem\"",
    );
    refused(
        &line(thickness, "bem", ""),
        "[indenter] lacks the key `length`",
        "{ shape = \"cylinder\" }",
        "give length = \"0.6 m\", across the sliding",
    );
}

#[test]
fn what_only_a_cylinder_has() {
    for (text, name, place) in [
        ("substrate = { thickness = \"2 mm\" }", "thickness", "\"2 mm\""),
        ("indenter = { length = \"0.6 m\" }", "length", "\"0.6 m\""),
    ] {
        refused(
            &key(text),
            &format!("`{name}` is of a line contact, not of the shape `paraboloid`"),
            place,
            "leave it out, or set indenter.shape = \"cylinder\"",
        );
    }
}

#[test]
fn a_radius_that_would_make_another_law() {
    let text = "substrate = { thickness = \"2 mm\" }\ncontact = { law = \"bem\" }\n\
        indenter = { shape = \"cylinder\", length = \"0.6 m\" }\n[[analysis]]\nkind = \"spectrum\"\n\
        sweep = { key = \"indenter.radius\", from = \"1 mm\", to = \"10 mm\", points = 3 }";
    refused(
        &key(text),
        "`indenter.radius` cannot be swept: the law of a cylinder, which is computed for one radius on one layer, decides it",
        "indenter.radius",
        "sweep another key, or run the case once a value with `--set`",
    );
}
