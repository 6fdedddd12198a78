//! Oscillator cases that are read.

use std::f64::consts::{FRAC_PI_4, PI};

use super::parse;
use judder_keys::keys::Keys;
use judder_keys::numeric_key::{Form, Value};
use judder_models::oscillator::case::OscillatorCase;
use judder_models::oscillator::inputs::{OscillatorInputs, TimeForm};
use judder_models::oscillator::keys::OscillatorKey;
use judder_models::oscillator::law_name::LawName;
use judder_models::oscillator::settings::SHEAR_STRENGTH_WITHIN;
use judder_models::oscillator::settings::{CriticalThresholds, SoughtThresholds};
use judder_models::sweep::StabilityMapAnalysis;
use judder_oscillator::FrictionLoad;
use judder_oscillator::map::DecisionMethod;
use judder_study::case::scale::Spacing;

/// The case of the interface, word for word, with the first analysis of its second example.
const INTERFACE: &str = r#"title = "Fig. 9a of the oscillator paper"
model = "oscillator"

[substrate]
rubbery_modulus  = "1 MPa"
glassy_modulus   = "10 MPa"
retardation_time = "10 ms"        # the paper's τ (creep); or relaxation_time = "1 ms"; or  prony = [{ time = "…", compliance = "… 1/Pa" }, …]
poisson_ratio    = 0.5

[indenter]
radius = "10 mm"

[contact]
law = "oscillator-paper"          # as printed; or "oscillator-paper-corrected", "hertz", "bem", { file = "law.json" }
shear_strength = 0.01             # τ0/E0*
friction_load = "normal-load"     # F_n μ_visc as printed, or "contact-force": F_k μ_visc

[oscillator]                      # the defaults are eq. (14)
damping_x = 0.01
damping_y = 0.01
frequency_ratio = 1.0             # Ω
coupling = 1.0                    # η
coupling_angle = "45 deg"         # α
natural_frequency = "40 rad/s"    # ω_nx
stiffness_x = "50 N/m"            # k_x

[operation]
velocity = 1e-4                   # v_d τ / R
normal_load = 1e-6                # F_n / (E0* R²)

[[analysis]]
name = "map"
kind = "stability-map"
x = { key = "operation.velocity", from = 1e-8, to = 1e2, points = 400, scale = "log" }
y = { key = "contact.shear_strength", from = 1e-4, to = 1.0, points = 400, scale = "log" }
method = "adaptive"               # or "every-point"

[[analysis]]
name = "thresholds"
kind = "critical-shear-strength"
sweep  = { key = "operation.velocity", from = 1e-8, to = 1e2, points = 21, scale = "log" }
within = { from = 1e-6, to = 1e3 }        # where roots are sought
"#;

fn oscillator(text: &str, overrides: &[&str]) -> OscillatorCase {
    parse(text, overrides).unwrap().of::<OscillatorCase>().expect("its model").clone()
}

#[test]
fn the_case_of_the_interface_says_the_papers_values() {
    let case = oscillator(INTERFACE, &[]);
    assert_eq!(case.title, "Fig. 9a of the oscillator paper");
    assert_eq!(case.inputs, OscillatorInputs::default());
    assert_eq!((case.law, case.friction_load), (LawName::OscillatorPaper, FrictionLoad::NormalLoad));
    let map: &StabilityMapAnalysis<OscillatorKey> = case.analyses[0].settings().unwrap();
    assert_eq!((map.x.key, map.y.key), (OscillatorKey::Velocity, OscillatorKey::ShearStrength));
    assert_eq!((map.x.from, map.x.to, map.x.points, map.x.scale), (1e-8, 1e2, 400, Spacing::Log));
    assert_eq!(
        (map.options.method, map.options.boundaries, map.y.form),
        (DecisionMethod::Adaptive, true, Form::Group)
    );
    let CriticalThresholds { within, family, .. } = case.analyses[1].settings().unwrap();
    assert_eq!((within.from, within.to, family.is_none()), (1e-6, 1e3, true));
    assert_eq!(
        case.analyses.iter().map(|analysis| analysis.name.as_str()).collect::<Vec<_>>(),
        ["map", "thresholds"]
    );
}

#[test]
fn a_case_of_one_line_is_the_papers() {
    let case = oscillator("model = \"oscillator\"", &[]);
    assert_eq!(format!("{case:?}"), format!("{:?}", OscillatorCase::default()));
    for entry in OscillatorKey::ALL {
        assert!(entry.rule.range.contains(case.inputs.number(entry.key)), "{}", entry.path);
    }
}

#[test]
fn options_win_over_the_file_and_later_ones_over_earlier_ones() {
    let options = [
        "operation.velocity=30 mm/s",
        "contact.law=hertz",
        "oscillator.damping_x=0.1",
        "oscillator.damping_x = 0.2",
        "title = \"x = 1\"",
    ];
    let case = oscillator(INTERFACE, &options);
    assert_eq!(case.inputs.get(OscillatorKey::Velocity), Value::si(0.03));
    assert_eq!(case.inputs.get(OscillatorKey::DampingX), Value::group(0.2));
    assert_eq!((case.law, case.title.as_str()), (LawName::Hertz, "x = 1"));
}

#[test]
fn units_are_parsed_at_the_door() {
    let text = r#"
        model = "oscillator"
        operation = { velocity = "30 mm/s", normal_load = "0.2 mN" }
        contact = { shear_strength = "5 kPa", friction_load = "contact-force" }
        oscillator = { natural_frequency = "7 kHz", coupling_angle = "30 deg", stiffness_x = "3.5 kN/m", coupling = 2 }
    "#;
    let case = oscillator(text, &[]);
    let number = |key| case.inputs.number(key);
    assert_eq!(number(OscillatorKey::Velocity), 0.03);
    assert_eq!(number(OscillatorKey::NormalLoad), 2e-4);
    assert_eq!(number(OscillatorKey::ShearStrength), 5e3);
    assert_eq!(number(OscillatorKey::NaturalFrequency), 14e3 * PI);
    assert!((number(OscillatorKey::CouplingAngle) - PI / 6.0).abs() < 1e-15);
    assert_eq!(number(OscillatorKey::StiffnessX), 3500.0);
    assert_eq!(case.inputs.get(OscillatorKey::Coupling), Value::group(2.0));
    assert_eq!(case.friction_load, FrictionLoad::ContactForce);
}

#[test]
fn the_three_forms_of_the_relaxation_agree() {
    let forms = [
        ("retardation_time = \"10 ms\"", TimeForm::Retardation),
        ("relaxation_time = \"1 ms\"", TimeForm::Relaxation),
        ("prony = [{ time = \"10 ms\", compliance = \"9e-7 1/Pa\" }]", TimeForm::Prony { compliance: 9e-7 }),
    ];
    for (text, form) in forms {
        let case = oscillator(&format!("model = \"oscillator\"\n[substrate]\n{text}\n"), &[]);
        assert_eq!(case.time_form(), form);
        let near = |key, expected: f64| (case.inputs.number(key) / expected - 1.0).abs() < 1e-9;
        assert!(near(OscillatorKey::RetardationTime, 0.01), "{text}");
        assert!(near(OscillatorKey::RelaxationTime, 1e-3), "{text}");
        assert!(near(OscillatorKey::GlassyModulus, 1e7), "{text}");
    }
}

#[test]
fn equal_moduli_are_for_hertz() {
    let text = "model = \"oscillator\"\n[substrate]\nglassy_modulus = \"1 MPa\"\n";
    assert_eq!(oscillator(text, &["contact.law=hertz"]).law, LawName::Hertz);
    assert!(parse(text, &[]).is_err());
}

#[test]
fn a_sweep_sets_its_key() {
    let text = r#"
        model = "oscillator"
        [[analysis]]
        kind = "critical-shear-strength"
        sweep = { key = "oscillator.coupling_angle", from = "0 deg", to = "90 deg", points = 3 }
        family = { key = "substrate.relaxation_time", values = ["1 ms", "2 ms"] }
    "#;
    let case = oscillator(text, &[]);
    let asked: &CriticalThresholds = case.analyses[0].settings().unwrap();
    let CriticalThresholds { sought, sweep, within, family, global_margin } = asked;
    assert_eq!(*sought, SoughtThresholds::ShearStrength);
    assert_eq!((case.analyses[0].name.as_str(), *global_margin), ("critical-shear-strength", true));
    assert_eq!((within.from, within.to), SHEAR_STRENGTH_WITHIN);
    let mut inputs = case.inputs;
    sweep.set(&mut inputs, sweep.values()[1]);
    assert!((inputs.number(OscillatorKey::CouplingAngle) - FRAC_PI_4).abs() < 1e-15);
    let family = family.as_ref().unwrap();
    family.set(&mut inputs, family.values[1]);
    assert_eq!(inputs.number(OscillatorKey::RetardationTime), 0.02);
}

#[test]
fn the_resolved_case_holds_every_key_and_the_same_bytes_each_time() {
    let json = parse(INTERFACE, &[]).unwrap().resolved();
    for entry in OscillatorKey::ALL {
        assert!(!json[entry.section()][entry.name()].is_null(), "{}", entry.path);
    }
    assert_eq!(json["substrate"]["relaxation_time"], serde_json::json!({ "value": 0.001, "unit": "s" }));
    assert_eq!(json["analysis"][0]["x"]["to"], 100.0);
    let other = format!("# a comment\n{}", INTERFACE.replace("\"10 mm\"", "\"1 cm\""));
    assert_eq!(json.to_string(), parse(&other, &[]).unwrap().resolved().to_string());
    assert_ne!(json, parse(INTERFACE, &["operation.velocity=2e-4"]).unwrap().resolved());
}

#[test]
fn a_file_is_named_by_its_stem() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("fig-9a.toml");
    std::fs::write(&path, INTERFACE).unwrap();
    let file = judder_models::read(&path, &["contact.law=hertz".to_owned()]).unwrap();
    assert_eq!((file.name.as_str(), file.text.as_str()), ("fig-9a", INTERFACE));
}

#[test]
fn a_byte_order_mark_and_windows_line_ends_are_no_obstacle() {
    let text = format!("\u{feff}{}", INTERFACE.replace('\n', "\r\n"));
    assert_eq!(oscillator(&text, &[]).analyses.len(), 2);
}

#[test]
fn conditions_between_keys_are_checked_where_both_vary() {
    let text = r#"
        model = "oscillator"
        [[analysis]]
        kind = "stability-map"
        x = { key = "substrate.rubbery_modulus", from = "1 MPa", to = "20 MPa", points = 3 }
        y = { key = "substrate.glassy_modulus", from = "30 MPa", to = "50 MPa", points = 3 }
        [[analysis]]
        kind = "spectrum"
        sweep = { key = "substrate.rubbery_modulus", from = "1 MPa", to = "20 MPa", points = 3 }
        family = { key = "substrate.glassy_modulus", values = ["30 MPa"] }
    "#;
    assert_eq!(oscillator(text, &[]).analyses.len(), 2);
    assert!(parse(&text.replace("from = \"30 MPa\"", "from = \"15 MPa\""), &[]).is_err());
    assert!(parse(&text.replace("[\"30 MPa\"]", "[\"15 MPa\"]"), &[]).is_err());
}
