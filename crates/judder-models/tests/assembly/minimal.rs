//! Minimal models of the literature as assemblies: against closed forms, printed numbers, and the models that they stand beside.

use crate::{case, number, run_into};
use judder_contact::friction::TableInterpolation;
use judder_models::parse;
use judder_models::two_degrees::case::TwoDegreesCase;
use judder_oscillator::motion::SlidingSystem;
use judder_oscillator::motion::belt::{BeltOscillator, FallingFriction, Friction};
use judder_oscillator::spectrum;
use judder_store::{StudyFolder, VariableValues};
use judder_study::case::file::CaseFile;
use serde_json::{Map, Value};
use std::collections::BTreeMap;

pub(super) fn results(file: &CaseFile) -> BTreeMap<String, Map<String, Value>> {
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), file, &[]);
    assert!(report.complete, "{:?}", report.messages);
    report.summary.results
}

/// Re and Im of every eigenvalue that was found.
fn eigenvalues(file: &CaseFile) -> Vec<[f64; 2]> {
    let results = results(file);
    assert_eq!(results["modes"]["complete"], true);
    let found = results["modes"]["eigenvalues"].as_array().unwrap();
    found.iter().map(|value| [number(&value["re"]), number(&value["im"])]).collect()
}

/// ζ = −Re λ/|λ| of the only mode.
pub(super) fn damping_ratio(file: &CaseFile) -> f64 {
    let found = eigenvalues(file);
    let [[re, im]] = found[..] else { panic!("{found:?}") };
    -re / re.hypot(im)
}

/// Re and Im of the mode that grows fastest.
pub(super) fn fastest(file: &CaseFile) -> [f64; 2] {
    eigenvalues(file).into_iter().max_by(|a, b| a[0].total_cmp(&b[0])).unwrap()
}

/// The largest growth rate, zero where none grows.
pub(super) fn fastest_growth(file: &CaseFile) -> f64 {
    fastest(file)[0].max(0.0)
}

/// VM274: ζ = μN/(2 v √(km)), printed as 4.98012e-4.
#[test]
fn friction_damps_a_mass_across_the_slip() {
    let file = case("assembly/mass-on-belt.toml", &[]);
    let (ratio, found) = (damping_ratio(&file), eigenvalues(&file));
    assert!((ratio - 0.5 / (20.0 * 2520_f64.sqrt())).abs() < 1e-14, "{ratio}");
    assert!((ratio - 4.980_12e-4).abs() < 1e-9);
    // in a sweep the spring is called by its name
    let stiffer = eigenvalues(&case("assembly/mass-on-belt.toml", &["spring.across.stiffness=\"1260 N/m\""]));
    assert!((stiffer[0][1] - 2.0 * found[0][1]).abs() < 1e-4 * found[0][1]);
}

/// VM29: N = 95.942, T = 28.783, and the spring holds with 5.76728.
#[test]
fn a_block_slides_down_an_incline() {
    let results = results(&case("assembly/block-on-incline.toml", &[]));
    let incline = &results["steady"]["contacts"]["incline"];
    let (sine, cosine) = 20_f64.to_radians().sin_cos();
    let normal = 100.0 / (cosine + 0.3 * sine);
    assert!((number(&incline["normal_force"]) - normal).abs() < 1e-10 && (normal - 95.942).abs() < 5e-4);
    let [x, y, _] = [0, 1, 2].map(|axis| number(&incline["tangential_force"][axis]));
    assert!((x.hypot(y) - 0.3 * normal).abs() < 1e-10 && (x.hypot(y) - 28.783).abs() < 5e-4);
    let held = normal * sine + x;
    // the manual cuts the last digit off
    assert!((held - 5.767_28).abs() < 1e-5, "{held}");
}

/// Hoffmann et al. 2002: the modes merge at μ = 3/4 with ω = √2, at μ = 1 one grows with Re √(−2 + i/√3).
#[test]
fn two_springs_and_a_contact_couple_their_modes() {
    let at = |friction: &str| {
        let option = format!("contact.belt.friction_coefficient={friction}");
        eigenvalues(&case("assembly/mode-coupling.toml", &[&option]))
    };
    let largest = fastest_growth(&case("assembly/mode-coupling.toml", &[]));
    assert!((largest - 0.202_071_768_8).abs() < 1e-10, "{largest}");
    // below the threshold ω² = 2 ± √(1 − 4μ/3), above it the root is imaginary
    let below = at("0.7499");
    let root = (1.0_f64 - 4.0 * 0.7499 / 3.0).sqrt();
    for ([re, im], expected) in below.iter().zip([(2.0 - root).sqrt(), (2.0 + root).sqrt()]) {
        assert!(re.abs() < 1e-10 && (im - expected).abs() < 1e-10, "{below:?}");
    }
    assert!(at("0.7501").iter().any(|[re, _]| *re > 1e-3));
}

/// Spurr 1961: N = L/(1 − μ tan ϑ), and the tip locks at μ = cot ϑ.
#[test]
fn a_leaning_strut_digs_in() {
    let steady = &results(&case("assembly/sprag-slip.toml", &[]))["steady"];
    let lean = 0.4 * 3_f64.sqrt();
    let normal = number(&steady["contacts"]["surface"]["normal_force"]);
    assert!((normal - 10.0 / (1.0 - lean)).abs() < 1e-10 * normal, "{normal}");
    let limit = number(&steady["friction_limit"]);
    assert!((limit - 1.0 / lean).abs() < 1e-10, "{limit}");
    let begins = &steady["friction_onsets"]["closed-points"];
    assert!((number(&begins["friction_coefficient"]) - 3_f64.sqrt().recip()).abs() < 1e-10, "{begins}");
    assert_eq!((begins["contact"].as_str(), begins["known"].as_bool()), (Some("surface"), Some(true)));
    // of one state alone it is found by trying both, for only the strut and the contact hold the tip
    assert_eq!(steady["uniqueness"], "unique-for-these-loads");
}

/// Of a strut without friction nothing is certified that friction would end: it says with which coefficient.
#[test]
fn a_strut_without_friction_says_with_which_it_would_dig_in() {
    let folder = tempfile::tempdir().unwrap();
    let file = case("assembly/sprag-slip.toml", &["contact.surface.friction_coefficient=0"]);
    let report = run_into(folder.path(), &file, &[]);
    assert!(report.complete && report.messages.is_empty(), "{:?}", report.messages);
    let steady = &report.summary.results["steady"];
    assert!(steady["friction_limit"].is_null() && steady["friction_limit_known"] == false);
    let begins = &steady["friction_onsets"]["closed-points"];
    assert!((number(&begins["friction_coefficient"]) - 3_f64.sqrt().recip()).abs() < 1e-10, "{begins}");
    assert!(begins["factor"].is_null() && begins["known"] == true, "{begins}");
    let page = std::fs::read_to_string(report.report.unwrap()).unwrap();
    assert!(page.contains("there is no friction"));
}

/// Why the analysis of a case has no result, and whether the input is to blame.
fn failed(file: &CaseFile) -> (String, bool) {
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), file, &[]);
    match &report.refused[..] {
        [refused] => (refused.error.to_string(), true),
        _ => (report.messages.join("; "), false),
    }
}

/// Beyond cot ϑ friction is to blame and named; a load that pulls is to blame whatever the friction.
#[test]
fn a_strut_that_has_dug_in_and_one_that_is_pulled_off_say_so() {
    let (message, is_wrong_input) =
        failed(&case("assembly/sprag-slip.toml", &["contact.surface.friction_coefficient=0.7"]));
    let expected = "steady sliding ends at 0.824786 times the friction coefficients, a coefficient of 0.57735, \
        where the contact point of `surface` at (0, 0, 0) m (point 0, counted from 0) digs in";
    assert!(message.contains(expected) && !is_wrong_input, "{message}");
    let (message, is_wrong_input) = failed(&case("assembly/sprag-slip.toml", &["load.0.force=\"10 N\""]));
    let expected = "at the nearest, of `surface` at (0, 0, 0) m with a gap of 0 m between the undeformed bodies and the normal (0, 1, 0), \
        the loads push the slider along that normal, off the track";
    assert!(message.contains(expected) && is_wrong_input, "{message}");
}

/// An assembly of one body whose matrices stand in the case, and which touches nothing.
fn asked(parameters: &str, matrices: &str, analyses: &str) -> CaseFile {
    let text = format!(
        "model = \"assembly\"\n[parameters]\n{parameters}\n[[structure]]\nname = \"body\"\n[structure.matrices]\n{matrices}\n\
         freedoms = [[\"mass\", \"x\"], [\"mass\", \"y\"]]\n{analyses}"
    );
    parse("case.toml", &text, &[]).unwrap()
}

/// The same with its modes.
fn alone(parameters: &str, matrices: &str) -> CaseFile {
    let modes =
        "[[analysis]]\nname = \"modes\"\nkind = \"eigen\"\nregion = { re = [-3.0, 3.0], im = [0.1, 3.0] }\n";
    asked(parameters, matrices, modes)
}

const MINIMAL: &str = "mass = [[1.0, 0.0], [0.0, 1.0]]\nstiffness = [[2.0, \"1 - 4*mu/3\"], [1.0, 2.0]]";
const HOPF: &str = "mass = [[1.0, 0.0], [0.0, 1.0]]\ndamping = [[\"c1\", 0.0], [0.0, \"c2\"]]\n\
    stiffness = [[2.0, \"1 - 4/3*mu\"], [1.0, 2.4]]";

/// The eigenvalues of a two-degrees case at a friction coefficient.
fn of_two_degrees(file: &CaseFile, friction: f64) -> Vec<[f64; 2]> {
    let case = file.case.of::<TwoDegreesCase>().unwrap();
    let mut values = case.values();
    values[0] = friction;
    let reduced = case.matrices(&values).unwrap().reduced().unwrap();
    let all = spectrum::eigenvalues(&reduced).unwrap();
    all.iter().filter(|value| value.im > 0.1).map(|value| [value.re, value.im]).collect()
}

/// The benchmarks of two-degrees cases, with the same expressions in an assembly: the same eigenvalues.
#[test]
fn benchmarks_of_two_degrees_are_assemblies() {
    for (name, rest, matrices) in
        [("minimal-mode-coupling", "", MINIMAL), ("damped-hopf", "c1 = 0.02\nc2 = 0.002", HOPF)]
    {
        let other = case(&format!("benchmarks/{name}.toml"), &[]);
        for friction in [0.0, 0.3, 0.7, 0.85, 1.0, 1.5] {
            let expected = of_two_degrees(&other, friction);
            let found = eigenvalues(&alone(&format!("mu = {friction}\n{rest}"), matrices));
            assert_eq!(found.len(), expected.len(), "{name} at {friction}: {found:?}");
            for [re, im] in expected {
                let off = found.iter().map(|own| (own[0] - re).hypot(own[1] - im)).fold(9.0, f64::min);
                assert!(off < 1e-10, "{name} at {friction}: {off}");
            }
        }
    }
}

/// Critical values of two-degrees cases, which Hurwitz' determinants tell, are onsets of assemblies, which eigenvalues tell.
#[test]
fn critical_values_of_two_degrees_are_onsets_of_assemblies() {
    let sweep = "[[analysis]]\nname = \"sweep\"\nkind = \"eigen-sweep\"\nregion = { re = [-3.0, 3.0], im = [0.1, 3.0] }\n\
        sweep = { key = \"parameters.mu\", from = 0.0, to = 1.5, points = 16 }\n";
    for (name, parameters, matrices) in [
        ("minimal-mode-coupling", "mu = 1.0", MINIMAL),
        ("damped-hopf", "mu = 0.7\nc1 = 0.02\nc2 = 0.002", HOPF),
    ] {
        let other = case(&format!("benchmarks/{name}.toml"), &[]);
        let expected =
            &run_into(tempfile::tempdir().unwrap().path(), &other, &["critical"]).summary.results["critical"];
        let found = &results(&asked(parameters, matrices, sweep))["sweep"];
        let [onset] = &found["onsets"].as_array().unwrap()[..] else { panic!("{found:?}") };
        assert_eq!(expected["critical"].as_array().unwrap().len(), 1);
        let [value, frequency] = ["critical", "frequency"].map(|key| number(&expected[key][0]));
        assert!((number(&onset["value"]) - value).abs() < 1e-10, "{name}: {onset} {value}");
        let angular = std::f64::consts::TAU * number(&onset["frequency_hz"]);
        // where undamped modes merge frequencies part as the root of the distance
        let off = if name == "damped-hopf" { 1e-10 } else { 1e-5 };
        assert!((angular - frequency).abs() < off, "{name}: {onset} {frequency}");
    }
}

/// Their maps say of the same points that they are unstable.
#[test]
fn maps_of_two_degrees_are_maps_of_assemblies() {
    let axes = "x = { key = \"parameters.mu\", from = 0.5, to = 1.0, points = 11 }\n\
        y = { key = \"parameters.c2\", from = 1e-4, to = 1.0, points = 9, scale = \"log\" }\n";
    let map = format!(
        "[[analysis]]\nname = \"map\"\nkind = \"stability-map\"\nregion = {{ re = [-3.0, 3.0], im = [0.1, 3.0] }}\n{axes}"
    );
    let other = case("benchmarks/damped-hopf.toml", &["analysis.map.x.points=11", "analysis.map.y.points=9"]);
    let unstable = |file: &CaseFile, stable: &[u8]| -> Vec<bool> {
        let folder = tempfile::tempdir().unwrap();
        run_into(folder.path(), file, &["map"]);
        let dataset = StudyFolder::open(folder.path()).unwrap().read_dataset("map").unwrap();
        let VariableValues::U8(codes) = &dataset.variable("stability").unwrap().data else { panic!("codes") };
        codes.iter().map(|code| !stable.contains(code)).collect()
    };
    // stable and marginal; nothing is unresolved
    let expected = unstable(&other, &[0, 5]);
    assert!(expected.len() == 99 && expected.contains(&true) && expected.contains(&false));
    assert_eq!(unstable(&asked("mu = 0.7\nc1 = 0.02\nc2 = 0.002", HOPF, &map), &[0, 1]), expected);
}

/// Structure cases take the same arrays, and vary their parameters.
#[test]
fn a_structure_case_takes_arrays_too() {
    let region = "region = { re = [-3.0, 3.0], im = [0.1, 3.0] }";
    let text = format!(
        "model = \"structure\"\n[parameters]\nmu = 1.0\n[matrices]\nmass = [[1.0, 0.0], [0.0, 1.0]]\n\
         stiffness = [[2.0, \"1 - 4*mu/3\"], [1.0, 2.0]]\nfreedoms = [[\"mass\", \"x\"], [\"mass\", \"y\"]]\n\
         [[analysis]]\nname = \"modes\"\nkind = \"eigen\"\n{region}\n\
         [[analysis]]\nname = \"sweep\"\nkind = \"eigen-sweep\"\n{region}\n\
         sweep = {{ key = \"parameters.mu\", values = [0.0, 0.6, 1.0] }}\n\
         [[analysis]]\nname = \"receptance\"\nkind = \"receptance\"\nband = [\"0.1 Hz\", \"0.2 Hz\"]\npoints = 3\n\
         excited = {{ set = \"mass\", direction = \"y\" }}\nobserved = {{ set = \"mass\", direction = \"x\" }}\n"
    );
    let file = parse("case.toml", &text, &[]).unwrap();
    assert!((fastest_growth(&file) - 0.202_071_768_8).abs() < 1e-10);
    assert_eq!(results(&file)["sweep"]["unstable"], serde_json::json!([false, false, true]));
    let idle = text.replace("1 - 4*mu/3", "1 - 4/3");
    let refused = parse("case.toml", &idle, &[]).unwrap_err();
    assert_eq!(refused.to_string(), "no factor and no entry of a matrix contains the parameter `mu`");
}

/// The damped Hopf point in closed form: the growth rate of an assembly passes zero there.
#[test]
fn the_damped_hopf_point_is_that_of_an_assembly() {
    let (c1, c2) = (0.02_f64, 0.002_f64);
    let r = (c1 * 2.4 + c2 * 2.0) / (c1 + c2);
    let threshold = 0.75 * (1.0 + c1 * c2 * 0.16 / (c1 + c2).powi(2) + r * c1 * c2);
    assert!((threshold - 0.759_988_264_5).abs() < 1e-10);
    let growth = |friction: f64| {
        let parameters = format!("mu = {friction:?}\nc1 = {c1:?}\nc2 = {c2:?}");
        let found = eigenvalues(&alone(&parameters, HOPF));
        found.iter().map(|own| own[0]).fold(f64::NEG_INFINITY, f64::max)
    };
    assert!(growth(threshold).abs() < 1e-10);
    assert!(growth(threshold - 1e-6) < -1e-8 && growth(threshold + 1e-6) > 1e-8);
}

/// The linear part of the belt of the literature: place and eigenvalue of steady sliding as an assembly.
#[test]
fn steady_sliding_on_the_belt_is_an_assembly() {
    let law = FallingFriction::exponential([1.0, 0.5], 0.5);
    let stribeck = FallingFriction { viscous: 0.1, exponent: 2.0, ..law };
    let table = Friction::table(vec![0.0, 1.2, 1.8], vec![1.0, 0.6, 0.7], TableInterpolation::Monotone);
    let frictions: [(&str, Friction); 3] = [
        ("{ at_rest = 1.0, at_speed = 0.5, decay_speed = \"0.5 m/s\" }", law.into()),
        (
            "{ at_rest = 1.0, at_speed = 0.5, decay_speed = \"0.5 m/s\", viscous = \"0.1 s/m\", exponent = 2 }",
            stribeck.into(),
        ),
        (
            "{ velocity = [\"0 m/s\", \"1.2 m/s\", \"1.8 m/s\"], coefficient = [1.0, 0.6, 0.7], interpolation = \"monotone\" }",
            table.unwrap(),
        ),
    ];
    let points = [0.5, 1.0, 1.5, 2.0].into_iter().flat_map(|v| frictions.iter().map(move |own| (v, own)));
    for (velocity, (written, friction)) in points {
        let text = format!(
            "model = \"assembly\"\n[[structure]]\nname = \"body\"\n[structure.matrices]\nmass = [[1, 0], [0, 1]]\n\
             damping = [[0.1, 0], [0, 0]]\nstiffness = [[1, 0], [0, 0]]\nfreedoms = [[\"mass\", \"x\"], [\"mass\", \"y\"]]\n\
             [[contact]]\nname = \"belt\"\nslider = {{ structure = \"body\", set = \"mass\" }}\n\
             track = {{ plane = {{ normal = [0, 1] }} }}\nsliding = {{ velocity = \"{velocity} m/s\", direction = [1, 0] }}\n\
             friction_coefficient = {written}\n\
             [[load]]\nstructure = \"body\"\nset = \"mass\"\ndirection = \"y\"\nforce = \"-1 N\"\n\
             [[analysis]]\nname = \"steady\"\nkind = \"steady-sliding\"\n\
             [[analysis]]\nname = \"modes\"\nkind = \"eigen\"\nregion = {{ re = [-2.0, 2.0], im = [0.01, 2.0] }}\n"
        );
        let file = parse("case.toml", &text, &[]).unwrap();
        let results = results(&file);
        let belt = BeltOscillator::new(0.05, 1.0, velocity, friction.clone()).unwrap();
        let ([displacement, _], damping) = (belt.steady_sliding(), belt.equivalent_damping());
        // on a spring of 1 N/m friction is the displacement
        let force = number(&results["steady"]["contacts"]["belt"]["tangential_force"][0]);
        assert!((force - displacement).abs() < 1e-10, "{force} {displacement}");
        let found = &results["modes"]["eigenvalues"][0];
        let (re, im) = (number(&found["re"]), number(&found["im"]));
        assert!((re + damping).abs() < 1e-10, "{re} {damping}");
        assert!((im - (1.0 - damping * damping).sqrt()).abs() < 1e-10, "{im}");
    }
}

/// A spring of 100 N/m takes 1 N of 3 N until a plane 10 mm below, at rest and smooth, takes the others.
#[test]
fn a_plane_lies_its_gap_off_the_slider() {
    let text = "model = \"assembly\"\n\n[[structure]]\nname = \"block\"\n\n[structure.matrices]\nmass = [[1]]\nstiffness = [[100]]\nfreedoms = [[\"mass\", \"y\"]]\n\n\
         [[contact]]\nname = \"floor\"\nslider = { structure = \"block\", set = \"mass\" }\ntrack = { plane = { normal = [0, 1], gap = \"10 mm\" } }\n\
         sliding = { velocity = \"0 m/s\", direction = [1, 0] }\nfriction_coefficient = 0\n\n[[load]]\nstructure = \"block\"\nset = \"mass\"\ndirection = \"y\"\nforce = \"-3 N\"\n\n\
         [[analysis]]\nname = \"steady\"\nkind = \"steady-sliding\"\n";
    let steady = results(&parse("case.toml", text, &[]).unwrap());
    let floor = &steady["steady"]["contacts"]["floor"];
    assert!((number(&floor["normal_force"]) - 2.0).abs() < 1e-12, "{floor}");
}
