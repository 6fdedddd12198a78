//! Contact cases that are read, and the substrates that oscillator cases share with them.

use super::parse;
use judder_contact::indenter::Roughness;
use judder_keys::numeric_key::{Form, Value};
use judder_models::contact::case::ContactCase;
use judder_models::contact::settings::{
    ContactSettings, FitSettings, LawMethod, LawSettings, LoadingSettings, ModulusSettings,
};
use judder_models::contact::settings::{LAW_ACCURACY, LAW_INDENTATION, LAW_VELOCITY};
use judder_models::contact::shape::ShapeSettings;
use judder_models::contact::transient::settings::{IndenterMotion, OscillationSettings, TransientSettings};
use judder_models::is_number;
use judder_models::oscillator::case::OscillatorCase;
use judder_models::oscillator::keys::OscillatorKey;
use judder_models::oscillator::law_name::LawName;
use judder_models::substrate::continuous::{Density, LogNormal, PowerLaw, TermChoice};
use judder_models::substrate::temperature::{Shift, Wlf};
use judder_models::substrate::{FitTerms, RelaxationSource};

fn contact(text: &str) -> ContactCase {
    parse(&format!("model = \"contact\"\n{text}"), &[])
        .unwrap()
        .of::<ContactCase>()
        .expect("its model")
        .clone()
}

#[test]
fn a_continuous_spectrum_with_its_density_and_terms() {
    let read = |continuous: &str| {
        let case = contact(&format!("substrate = {{ continuous = {{ {continuous} }} }}"));
        let RelaxationSource::Continuous(source) = case.substrate.source else { panic!("another source") };
        (source, case.inputs)
    };
    let (source, _) = read("log_normal = { median = \"10 ms\", width = 1.5 }");
    assert_eq!(source.density(), Density::LogNormal(LogNormal { median: 0.01, width: 1.5 }));
    assert_eq!(source.terms(), TermChoice::Within(1e-3));
    let (source, _) = read("power_law = { from = \"1 us\", to = \"1 s\", exponent = 0.3 }, terms = 7");
    assert_eq!(source.density(), Density::PowerLaw(PowerLaw { from: 1e-6, to: 1.0, exponent: 0.3 }));
    assert_eq!(source.terms(), TermChoice::Given(7));
    // τ𝒞 = 0.3e-6 1/Pa over three e-foldings is 0.9e-6 1/Pa in all
    let last = 1e-3 * 3.0_f64.exp();
    let (_, inputs) = read(&format!(
        "samples = [{{ time = \"1 ms\", density = \"0.3e-3 1/Pa/s\" }}, {{ time = \"{last} s\", density = \"{} 1/Pa/s\" }}]",
        0.3e-6 / last
    ));
    assert!((inputs.number(OscillatorKey::GlassyModulus) / 1e7 - 1.0).abs() < 1e-9);
}

#[test]
fn the_memory_limit_of_an_analysis_goes_before_that_of_the_case() {
    let case = contact(
        "memory_limit = \"512 MiB\"\n[[analysis]]\nkind = \"contact-law\"\n[[analysis]]\n\
                kind = \"contact\"\nvelocity = 1\nindentation = 0.1\nmemory_limit = \"2 GiB\"",
    );
    let law: &LawSettings = case.analyses[0].settings().unwrap();
    let single: &ContactSettings = case.analyses[1].settings().unwrap();
    assert_eq!([law.memory.bytes, single.memory.bytes], [512 << 20, 2 << 30]);
}

#[test]
fn a_case_of_one_line_is_the_papers_substrate_under_a_paraboloid() {
    let case = contact("");
    assert_eq!(
        (&case.shape, &case.substrate.source),
        (&ShapeSettings::Paraboloid, &RelaxationSource::OneTime)
    );
    assert_eq!(case.inputs.number(OscillatorKey::GlassyModulus), 1e7);
}

#[test]
fn one_contact_by_indentation_and_by_load() {
    let case = contact(
        r#"
        [indenter]
        shape = "sphere"
        [[analysis]]
        kind = "contact"
        velocity = 1
        indentation = "0.1 mm"
        accuracy = 1e-2
        cells = 128
        domain = 0.5
        [[analysis]]
        name = "pressed"
        kind = "contact"
        velocity = "30 mm/s"
        load = 1e-4
        "#,
    );
    let settings = |index: usize| *case.analyses[index].settings::<ContactSettings>().unwrap();
    let (first, second) = (settings(0), settings(1));
    assert_eq!(
        (first.velocity, first.loading()),
        (Value::group(1.0), LoadingSettings::Indentation(Value::si(1e-4)))
    );
    assert_eq!((first.accuracy, first.cells(), first.domain), (1e-2, Some(128), Some(Value::group(0.5))));
    assert_eq!(
        (second.velocity, second.loading()),
        (Value::si(0.03), LoadingSettings::Load(Value::group(1e-4)))
    );
    assert_eq!((second.accuracy, second.cells(), second.domain), (1e-3, None, None));
}

#[test]
fn a_law_takes_the_papers_ranges_and_the_method_of_its_shape() {
    let law = |shape: &str, settings: &str| {
        let case = contact(&format!(
            "[indenter]\nshape = \"{shape}\"\n[[analysis]]\nkind = \"contact-law\"\n{settings}"
        ));
        case.analyses[0].settings::<LawSettings>().unwrap().clone()
    };
    let default = law("paraboloid", "");
    assert_eq!((default.velocity, default.indentation), (LAW_VELOCITY, LAW_INDENTATION));
    assert_eq!((default.accuracy, default.method), (LAW_ACCURACY, LawMethod::Collapse));
    let given = law("sphere", "velocity = { from = \"1 mm/s\", to = \"1 m/s\" }\naccuracy = 0.05");
    assert_eq!((given.velocity.form, given.velocity.to, given.method), (Form::Si, 1.0, LawMethod::Sweep));
    assert_eq!(given.accuracy, 0.05);
    let values = law("sphere", "velocity = { from = 1e-2, to = 1e2, points = 5 }").velocity.values();
    assert_eq!(values, [1e-2, 1e-1, 1.0, 10.0, 100.0]);
}

#[test]
fn a_fit_and_a_modulus() {
    let case = contact(
        r#"
        [[analysis]]
        kind = "fit"
        [[analysis]]
        kind = "modulus"
        frequency = { from = "1 Hz", to = "1 kHz", points = 7 }
        "#,
    );
    let fit: &FitSettings = case.analyses[0].settings().unwrap();
    assert_eq!(fit.reading.velocity_scale, 0.01);
    let modulus: &ModulusSettings = case.analyses[1].settings().unwrap();
    let range = modulus.frequency.as_ref().unwrap();
    assert!((range.from - 2.0 * std::f64::consts::PI).abs() < 1e-15);
    assert_eq!((range.points, range.form), (7, Form::Si));
}

#[test]
fn both_series_of_one_material_have_one_glassy_modulus_and_one_mean_time() {
    let creep = contact(r#"substrate = { prony = [{ time = "10 ms", compliance = "0.9e-6 1/Pa" }] }"#);
    let relaxation = contact(r#"substrate = { relaxation = [{ time = "1 ms", modulus = "9 MPa" }] }"#);
    for case in [&creep, &relaxation] {
        let near = |key, expected: f64| (case.inputs.number(key) / expected - 1.0).abs() < 1e-12;
        assert!(near(OscillatorKey::GlassyModulus, 1e7) && near(OscillatorKey::RetardationTime, 1e-2));
    }
    let two = contact(
        r#"
        [substrate]
        prony = [{ time = "1 ms", compliance = "3e-7 1/Pa" }, { time = "1 s", compliance = "1e-7 1/Pa" }]
        "#,
    );
    assert!((two.inputs.number(OscillatorKey::RetardationTime) - 0.25075).abs() < 1e-15);
    assert_eq!(two.substrate.source.terms(), Some(2));
}

#[test]
fn a_temperature_comes_with_its_shift() {
    let case = contact(
        r#"
        [substrate]
        temperature = "40 degC"
        shift = { wlf = { c1 = 17.4, c2 = "51.6 K", reference_temperature = "25 °C" } }
        "#,
    );
    let temperature = case.substrate.temperature.unwrap();
    assert!((temperature.temperature - 313.15).abs() < 1e-12);
    let Shift::Wlf(Wlf { first, second, reference }) = temperature.shift else { panic!() };
    assert_eq!((first, second.0), (17.4, 51.6));
    assert!((reference - 298.15).abs() < 1e-12);
}

#[test]
fn files_are_relative_to_the_case_file() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("data")).unwrap();
    for name in ["rubber.csv", "height.npy"] {
        std::fs::write(folder.path().join("data").join(name), "").unwrap();
    }
    let path = folder.path().join("case.toml");
    let text = r#"
        model = "contact"
        substrate = { dma = { file = "data/rubber.csv", terms = 9 } }
        indenter = { shape = { heights = "data/height.npy", spacing = "2 um", unit = "1 nm", periodic = true } }
    "#;
    std::fs::write(&path, text).unwrap();
    let file = judder_models::read(&path, &[]).unwrap();
    let case = file.case.of::<ContactCase>().unwrap();
    let RelaxationSource::Dma { file: data, terms, rubbery_modulus: None } = &case.substrate.source else {
        panic!()
    };
    assert_eq!((data.given.as_str(), *terms), ("data/rubber.csv", FitTerms::Given(9)));
    assert_eq!(data.path, folder.path().join("data/rubber.csv"));
    let ShapeSettings::Heights(heights) = &case.shape else { panic!() };
    assert_eq!((heights.spacing, heights.unit, heights.periodic), (Some(2e-6), 1e-9, true));
    assert_eq!(file.case.files().len(), 2);
}

#[test]
fn a_rough_surface_has_its_defaults() {
    let case = contact(
        r#"
        [indenter]
        shape = { rough = { period = "1 mm", cells = 100, hurst = 0.8, rms_slope = 0.1 } }
        "#,
    );
    let ShapeSettings::Rough(rough) = case.shape else { panic!() };
    assert_eq!((rough.roll_off(), rough.cut_off(), rough.seed), (1e-3, 4e-5, 0));
    assert_eq!(rough.roughness(), Roughness::Slope(0.1));
}

#[test]
fn an_oscillator_takes_a_series_with_a_computed_law() {
    let text = r#"
        model = "oscillator"
        [substrate]
        prony = [{ time = "1 ms", compliance = "3e-7 1/Pa" }, { time = "1 s", compliance = "1e-7 1/Pa" }]
        [contact]
        law = "bem"
    "#;
    let case = parse(text, &[]).unwrap().of::<OscillatorCase>().unwrap().clone();
    assert_eq!((case.law, case.substrate.source.terms()), (LawName::Bem, Some(2)));
}

#[test]
fn a_computed_law_takes_an_accuracy() {
    let law = |value: &str| parse(&format!("model = \"oscillator\"\n[contact]\nlaw = {value}\n"), &[]);
    let accuracy = |value: &str| {
        let case = law(value).unwrap().of::<OscillatorCase>().unwrap().clone();
        assert_eq!(case.law, LawName::Bem);
        case.law_accuracy
    };
    assert_eq!(accuracy("\"bem\""), 1e-2);
    assert_eq!(accuracy("{ computed = true }"), 1e-2);
    assert_eq!(accuracy("{ computed = true, accuracy = 3e-3 }"), 3e-3);
    let resolved = law("{ computed = true, accuracy = 3e-3 }").unwrap().resolved();
    assert_eq!(resolved["contact"]["law"]["accuracy"], 3e-3);
    for (wrong, said) in [
        ("{ computed = false }", "`computed` of `contact.law` must be true"),
        ("{ computed = true, accuracy = 0.5 }", "accuracy"),
        ("{ computed = true, file = \"law.json\" }", "a law is computed or read"),
        ("{ file = \"law.json\", accuracy = 1e-3 }", "a file has the accuracy that it has"),
    ] {
        let error = law(wrong).unwrap_err().to_string();
        assert!(error.contains(said), "{wrong}: {error}");
    }
}

#[test]
fn a_law_from_a_file_is_found_beside_the_case() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("law.json"), "{}").unwrap();
    let path = folder.path().join("case.toml");
    std::fs::write(&path, "model = \"oscillator\"\n[contact]\nlaw = { file = \"law.json\" }\n").unwrap();
    let case = judder_models::read(&path, &[]).unwrap().case.of::<OscillatorCase>().unwrap().clone();
    assert_eq!((case.law, case.law_file.unwrap().given), (LawName::File, "law.json".to_owned()));
}

#[test]
fn the_resolved_case_says_what_was_taken() {
    let case = parse("model = \"contact\"\n[[analysis]]\nkind = \"fit\"\n", &[]).unwrap().resolved();
    assert_eq!(case["indenter"]["shape"], "paraboloid");
    assert_eq!(case["analysis"][0]["velocity"]["to"], 1e4);
    assert_eq!(case["substrate"]["glassy_modulus"], serde_json::json!({ "value": 1e7, "unit": "Pa" }));
    assert!(case["oscillator"].is_null());
}

#[test]
fn the_motions_of_a_transient() {
    let case = contact(
        r#"
        [[analysis]]
        kind = "transient"
        motion = "start"
        velocity = "30 mm/s"
        indentation = 1e-2
        oscillation = { amplitude = 1e-3, frequency = 0.4 }
        duration = "50 ms"
        [[analysis]]
        name = "to-and-fro"
        kind = "transient"
        motion = "reciprocation"
        amplitude = "1 mm"
        frequency = "20 Hz"
        load = 1e-4
        duration = 10
        cells = 32
        "#,
    );
    let settings = |index: usize| *case.analyses[index].settings::<TransientSettings>().unwrap();
    let (first, second) = (settings(0), settings(1));
    let wave = OscillationSettings { amplitude: Value::group(1e-3), frequency: Value::group(0.4) };
    assert_eq!((first.motion(), first.oscillation), (IndenterMotion::Start(Value::si(0.03)), Some(wave)));
    assert_eq!((first.duration, first.cells), (Value::si(0.05), 64));
    let IndenterMotion::Reciprocation(wave) = second.motion() else { panic!() };
    assert!((wave.frequency.number - 40.0 * std::f64::consts::PI).abs() < 1e-12);
    assert_eq!((second.loading(), second.cells), (LoadingSettings::Load(Value::group(1e-4)), 32));
}

/// Numbers alone: no files, words or lists.
#[test]
fn the_numbers_of_substrate_and_indenter_go_by_their_paths() {
    for path in [
        "substrate.temperature",
        "substrate.shift.wlf.c2",
        "substrate.continuous.log_normal.median",
        "indenter.shape.unit",
        "indenter.shape.rough.period",
    ] {
        assert!(is_number(path), "{path}");
    }
    for path in ["substrate.dma.file", "substrate.dma.terms", "indenter.shape", "indenter.shape.heights"] {
        assert!(!is_number(path), "{path}");
    }
}
