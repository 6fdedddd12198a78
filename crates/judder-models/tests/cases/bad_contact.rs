//! Contact cases that are refused, and substrates of oscillator cases.

use super::refused;

fn contact(text: &str) -> String {
    format!("model = \"contact\"\n{text}\n")
}

/// A contact case with one analysis of kind `contact`.
fn analysis(settings: &str) -> String {
    contact(&format!("[[analysis]]\nkind = \"contact\"\n{settings}"))
}

#[test]
fn a_negative_compliance() {
    refused(
        &contact(r#"substrate = { prony = [{ time = "10 ms", compliance = "-1e-7 1/Pa" }] }"#),
        "`substrate.prony.compliance` must be positive, but is -1e-7 1/Pa",
        r#""-1e-7 1/Pa""#,
        "",
    );
}

#[test]
fn compliances_beyond_the_rubbery_one() {
    refused(
        &contact(
            r#"[substrate]
prony = [{ time = "1 ms", compliance = "6e-7 1/Pa" }, { time = "1 s", compliance = "6e-7 1/Pa" }]"#,
        ),
        "the prony compliance 1.2e-6 1/Pa is not below 1/E0 = 1e-6 1/Pa",
        r#"[{ time = "1 ms", compliance = "6e-7 1/Pa" }, { time = "1 s", compliance = "6e-7 1/Pa" }]"#,
        "1/E∞ = 1/E0 − compliance must be positive",
    );
}

#[test]
fn both_times() {
    refused(
        &contact("[substrate]\nretardation_time = \"10 ms\"\nrelaxation_time = \"1 ms\""),
        "`substrate.relaxation_time` together with `substrate.retardation_time`: both say the same thing",
        r#""1 ms""#,
        "keep `substrate.retardation_time` or `substrate.relaxation_time`",
    );
}

#[test]
fn both_series() {
    refused(
        &contact(
            r#"[substrate]
relaxation = [{ time = "1 ms", modulus = "9 MPa" }]
prony = [{ time = "10 ms", compliance = "9e-7 1/Pa" }]"#,
        ),
        "`substrate.relaxation` together with `substrate.prony`: both say the same thing",
        r#"[{ time = "1 ms", modulus = "9 MPa" }]"#,
        "keep `substrate.prony` or `substrate.relaxation`",
    );
}

#[test]
fn unsorted_times() {
    refused(
        &contact(
            r#"[substrate]
relaxation = [{ time = "1 s", modulus = "1 MPa" }, { time = "1 ms", modulus = "2 MPa" }]"#,
        ),
        "the times of `substrate.relaxation` must ascend, but 0.001 s follows 1 s",
        r#"{ time = "1 ms", modulus = "2 MPa" }"#,
        "list the terms from the shortest time to the longest",
    );
}

#[test]
fn a_relaxation_term_with_a_compliance() {
    refused(
        &contact(
            r#"substrate = { relaxation = [{ time = "1 s", modulus = "1 MPa", compliance = "1e-7 1/Pa" }] }"#,
        ),
        "unknown key `compliance` in a relaxation term",
        "compliance",
        "keys here: time, modulus",
    );
}

#[test]
fn a_temperature_without_a_shift() {
    refused(
        &contact("[substrate]\ntemperature = \"40 degC\""),
        "[substrate] lacks the key `shift`",
        "[substrate]",
        "give shift = { wlf = { c1 = …, c2 = \"… K\", reference_temperature = \"… degC\" } } or shift = { arrhenius = { … } }",
    );
}

#[test]
fn a_temperature_below_absolute_zero() {
    refused(
        &contact("[substrate]\ntemperature = \"-300 degC\""),
        "`substrate.temperature` must be above absolute zero, -273.15 °C, but is -300 degC",
        r#""-300 degC""#,
        "",
    );
}

/// 51.6 °C would be read as 324.75 K.
#[test]
fn a_difference_of_temperatures_in_degrees_celsius() {
    for c2 in ["\"51.6 degC\"", "\"51.6 °C\""] {
        refused(
            &contact(&format!(
                "[substrate]\ntemperature = \"40 degC\"\nshift = {{ wlf = {{ c1 = 17.4, c2 = {c2}, reference_temperature = \"25 degC\" }} }}"
            )),
            "`substrate.shift.wlf.c2` is a difference of temperatures, but degrees Celsius have their own zero",
            c2,
            "write a difference: \"51.6 K\"",
        );
    }
}

#[test]
fn measured_data_that_are_not_there() {
    refused(
        &contact("substrate = { dma = { file = \"data.csv\" } }"),
        "`substrate.dma.file` names `data.csv`, which does not exist",
        r#""data.csv""#,
        "a path in a case is relative to the folder of the case file",
    );
}

#[test]
fn a_folder_in_place_of_heights() {
    refused(
        &contact("indenter = { shape = { heights = \".\" } }"),
        "`indenter.shape.heights` names `.`, which is a folder, not a file",
        r#"".""#,
        "a path in a case is relative to the folder of the case file",
    );
}

#[test]
fn an_unknown_shape() {
    refused(
        &contact("indenter = { shape = \"spere\" }"),
        "unknown shape `spere`",
        "spere",
        "did you mean `sphere`? known: paraboloid, sphere, cylinder",
    );
}

#[test]
fn a_rough_surface_of_two_measures() {
    refused(
        &contact(
            "indenter = { shape = { rough = { period = \"1 mm\", cells = 64, hurst = 0.8, rms_height = \"1 um\", rms_slope = 0.1 } } }",
        ),
        "`indenter.shape.rough.rms_height` and `indenter.shape.rough.rms_slope` cannot both be given: one follows from the other",
        "{ period = \"1 mm\", cells = 64, hurst = 0.8, rms_height = \"1 um\", rms_slope = 0.1 }",
        "keep `indenter.shape.rough.rms_height` or `indenter.shape.rough.rms_slope`",
    );
}

#[test]
fn waves_longer_than_the_period() {
    let rough = "{ period = \"1 mm\", cells = 64, hurst = 0.8, rms_slope = 0.1, roll_off = \"2 mm\" }";
    refused(
        &contact(&format!("indenter = {{ shape = {{ rough = {rough} }} }}")),
        "the wave lengths of `indenter.shape.rough` must descend: period 0.001 m, roll_off 0.002 m",
        rough,
        "period ≥ roll_off > cut_off ≥ two cells",
    );
}

#[test]
fn a_contact_without_loading() {
    refused(
        &analysis("velocity = 1e-2"),
        "an analysis of kind `contact` lacks the key `indentation`",
        "[[analysis]]",
        "give indentation = 1e-2 (δ/R), or load = 1e-4 (F/(E0* R²))",
    );
}

/// A cylinder on a layer with one contact.
fn on_layer(length: &str, settings: &str) -> String {
    contact(&format!(
        "substrate.thickness = \"5 mm\"\nindenter = {{ shape = \"cylinder\"{length} }}\n[[analysis]]\nkind = \"contact\"\nvelocity = 1e-2\n{settings}"
    ))
}

#[test]
fn a_cylinder_without_loading() {
    refused(
        &on_layer("", ""),
        "an analysis of kind `contact` lacks the key `indentation`",
        "[[analysis]]",
        "give indentation = 1e-2 (δ/R), or load = 1e-2 (F/(E0* R))",
    );
}

#[test]
fn a_cylinder_under_a_whole_force() {
    let told = "the load of a cylinder is a force per length, N/m, and no force of 9 N";
    refused(
        &on_layer(", length = \"90 mm\"", "load = \"9 N\""),
        told,
        "\"9 N\"",
        "over the length of this cylinder, 0.09 m, it is load = \"100 N/m\"",
    );
    refused(
        &on_layer("", "load = \"9 N\""),
        told,
        "\"9 N\"",
        "divide it by the length of the cylinder: over 100 mm it is load = \"90 N/m\"",
    );
    let told = "the load of a cylinder is a force per length, N/m, and no force of -9 N";
    let help = "divide it by the length of the cylinder: over 100 mm it is load = \"90 N/m\"";
    refused(&on_layer("", "load = \"-9 N\""), told, "\"-9 N\"", help);
    let told = "the load of a cylinder is a force per length, and `9 mm` is none";
    let help = "write a quantity such as \"50 N/m\", or a plain number, F/(E0* R)";
    refused(&on_layer("", "load = \"9 mm\""), told, "\"9 mm\"", help);
}

#[test]
fn a_contact_with_both_loadings() {
    refused(
        &analysis("velocity = 1e-2\nindentation = 1e-2\nload = 1e-4"),
        "`indentation` and `load` cannot both be given: one follows from the other",
        "1e-4",
        "keep `indentation` or `load`",
    );
}

/// A contact case with one analysis of kind `transient`.
fn transient(settings: &str) -> String {
    contact(&format!("[[analysis]]\nkind = \"transient\"\nindentation = 1e-2\nduration = 5\n{settings}"))
}

#[test]
fn a_transient_without_its_motion() {
    refused(
        &transient(""),
        "an analysis of kind `transient` lacks the key `motion`",
        "[[analysis]]",
        "give motion = \"start\", \"reciprocation\" or \"rest\"",
    );
}

#[test]
fn an_unknown_motion() {
    refused(
        &transient("motion = \"sart\""),
        "unknown motion `sart`",
        "sart",
        "did you mean `start`? known: start, reciprocation, rest",
    );
}

#[test]
fn a_speed_of_an_indenter_at_rest() {
    refused(
        &transient("motion = \"rest\"\nvelocity = 0.1"),
        "`velocity` has no meaning with motion = \"rest\"",
        "0.1",
        "leave `velocity` out",
    );
}

#[test]
fn a_reciprocation_without_a_frequency() {
    refused(
        &transient("motion = \"reciprocation\"\namplitude = 0.1"),
        "an analysis of kind `transient` lacks the key `frequency`",
        "[[analysis]]",
        "give frequency = 0.4 (ω τ), or \"20 Hz\"",
    );
}

#[test]
fn an_oscillation_of_the_depth_under_a_load() {
    refused(
        &contact(
            "[[analysis]]\nkind = \"transient\"\nmotion = \"rest\"\nload = 1e-4\nduration = 5\n\
             oscillation = { amplitude = 1e-3, frequency = 1 }",
        ),
        "`oscillation` has no meaning with `load`: it is one of the indentation",
        "{ amplitude = 1e-3, frequency = 1 }",
        "leave `oscillation` out",
    );
}

#[test]
fn an_oscillation_with_an_unknown_key() {
    refused(
        &transient("motion = \"rest\"\noscillation = { amplitude = 1e-3, frequency = 1, period = 1 }"),
        "unknown key `period` in `oscillation`",
        "period",
        "keys here: amplitude, frequency",
    );
}

#[test]
fn a_transient_of_a_cylinder() {
    refused(
        &contact("indenter = { shape = \"cylinder\" }\n[[analysis]]\nkind = \"transient\""),
        "the analysis kind `transient` is for a paraboloid or a sphere, not for the shape `cylinder`",
        "[[analysis]]",
        "the analysis kind `contact` takes any shape; this one, a paraboloid or a sphere",
    );
}

#[test]
fn an_accuracy_out_of_range() {
    refused(
        &analysis("velocity = 1e-2\nindentation = 1e-2\naccuracy = 0.5"),
        "`accuracy` must be above 0 and at most 0.2, but is 0.5",
        "0.5",
        "",
    );
}

#[test]
fn too_many_cells() {
    refused(
        &analysis("velocity = 1e-2\nindentation = 1e-2\ncells = 100000"),
        "`cells` must be a whole number from 1 to 4096, but is 100000",
        "100000",
        "give a number from 1 to 4096",
    );
}

#[test]
fn cells_that_cannot_be_halved() {
    let help =
        "give an even number, 64 at least: the grid of half as many cells says how exact the answer is";
    let cylinder = "indenter = { shape = \"cylinder\" }\n[[analysis]]\nkind = \"contact\"\nvelocity = 1e-2";
    for (text, cells) in [
        (analysis("velocity = 1e-2\nindentation = 1e-2\ncells = 50"), "50"),
        (analysis("velocity = 1e-2\nindentation = 1e-2\ncells = 65"), "65"),
        (contact(&format!("{cylinder}\nload = 1e-2\ncells = 40")), "40"),
    ] {
        let message = format!("`cells` must be a multiple of two from 64 to 4096, but is {cells}");
        refused(&text, &message, cells, help);
    }
}

#[test]
fn a_speed_that_is_a_length() {
    refused(
        &analysis("velocity = \"3 mm\"\nindentation = 1e-2"),
        "`velocity` must be a speed, but this is a length",
        r#""3 mm""#,
        r#"write a speed, such as "30 mm/s", or a plain number: v τ/R"#,
    );
}

#[test]
fn a_law_of_a_cylinder() {
    refused(
        &contact("indenter = { shape = \"cylinder\" }\n[[analysis]]\nkind = \"contact-law\""),
        "the contact law of a cylinder needs `substrate.thickness`: on a half-space its depth depends on how far away it is measured",
        "[[analysis]]",
        "give the thickness of the layer, which a rigid base holds; one `contact` may have a `load` instead",
    );
    refused(
        &contact("indenter = { shape = \"cylinder\" }\n[[analysis]]\nkind = \"fit\""),
        "the analysis kind `fit` is for a paraboloid or a sphere, not for the shape `cylinder`",
        "[[analysis]]",
        "the analysis kind `contact` takes any shape; this one, a paraboloid or a sphere",
    );
}

#[test]
fn a_depth_of_a_cylinder_on_a_half_space() {
    refused(
        &contact(
            "indenter = { shape = \"cylinder\" }\n[[analysis]]\nkind = \"contact\"\nvelocity = 1e-2\nindentation = 3e-3",
        ),
        "the indentation of a cylinder needs `substrate.thickness`: on a half-space its depth depends on how far away it is measured",
        "3e-3",
        "give the thickness of the layer, which a rigid base holds; one `contact` may have a `load` instead",
    );
}

#[test]
fn what_only_a_cylinder_has() {
    for (text, key, place) in [
        ("substrate = { thickness = \"2 mm\" }", "thickness", r#""2 mm""#),
        ("indenter = { length = \"0.6 m\" }", "length", r#""0.6 m""#),
    ] {
        refused(
            &contact(&format!("{text}\n[[analysis]]\nkind = \"modulus\"")),
            &format!("`{key}` is of a line contact, not of the shape `paraboloid`"),
            place,
            "leave it out, or set indenter.shape = \"cylinder\"",
        );
    }
}

#[test]
fn a_collapse_of_a_sphere() {
    refused(
        &contact("indenter = { shape = \"sphere\" }\n[[analysis]]\nkind = \"fit\"\nmethod = \"collapse\""),
        "the method `collapse` is exact for a paraboloid only, not for the shape `sphere`",
        r#""collapse""#,
        "leave `method` out, or use method = \"sweep\"",
    );
}

#[test]
fn a_law_of_an_elastic_substrate() {
    refused(
        &contact("substrate = { glassy_modulus = \"1 MPa\" }\n[[analysis]]\nkind = \"contact-law\""),
        "the glassy modulus 1e6 Pa is not above the rubbery modulus 1e6 Pa",
        "[[analysis]]",
        r#"E∞ must be above E0; only the law "hertz" takes E∞ = E0"#,
    );
}

#[test]
fn frequencies_that_run_backwards() {
    refused(
        &contact("[[analysis]]\nkind = \"modulus\"\nfrequency = { from = \"1 kHz\", to = \"1 Hz\" }"),
        "the range runs backwards: from 1 kHz to 1 Hz",
        "{ from = \"1 kHz\", to = \"1 Hz\" }",
        "exchange its two ends",
    );
}

#[test]
fn an_analysis_of_an_oscillator() {
    refused(
        &contact("[[analysis]]\nkind = \"stability-map\""),
        "the analysis kind `stability-map` belongs to another model",
        "stability-map",
        "available: contact, contact-law, fit, modulus, transient",
    );
}

#[test]
fn a_sweep_of_a_modulus_under_a_computed_law() {
    refused(
        r#"model = "oscillator"
contact = { law = "bem" }
[[analysis]]
kind = "spectrum"
sweep = { key = "substrate.glassy_modulus", from = "2 MPa", to = "9 MPa", points = 3 }
"#,
        "`substrate.glassy_modulus` cannot be swept: the law `bem`, which is computed for one substrate, decides it",
        "substrate.glassy_modulus",
        "sweep another key, or run the case once a value with `--set`",
    );
}

#[test]
fn a_sweep_of_a_time_beside_a_series() {
    refused(
        r#"model = "oscillator"
contact = { law = "hertz" }
substrate = { relaxation = [{ time = "1 ms", modulus = "9 MPa" }] }
[[analysis]]
kind = "spectrum"
sweep = { key = "substrate.retardation_time", from = "1 ms", to = "1 s", points = 3 }
"#,
        "`substrate.retardation_time` cannot be swept: `substrate.relaxation` decides it",
        "substrate.retardation_time",
        "sweep another key, or run the case once a value with `--set`",
    );
}
