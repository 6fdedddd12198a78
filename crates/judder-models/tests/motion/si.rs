//! Motions of cases that are written in SI.

use crate::{case, number, run_into};
use judder_store::{StudyFolder, VariableValues};
use serde_json::{Map, Value};

/// The oscillator paper's oscillator at 0.1 mm/s, with what is said of its operation.
fn text(operation: &str, analysis: &str) -> String {
    format!("model = \"oscillator\"\n[operation]\n{operation}\n[[analysis]]\n{analysis}\n")
}

fn results(folder: &std::path::Path, operation: &str, analysis: &str, name: &str) -> Map<String, Value> {
    let file = judder_models::parse("case.toml", &text(operation, analysis), &[]).unwrap();
    run_into(folder, &file, &[]).summary.results[name].clone()
}

const IN_GROUPS: &str = "velocity = 1e-4\nnormal_load = 1e-6";
/// v_d = 1e-4 R/τ; F_n = 1e-6 E0* R², E0* = 1 MPa/(1 − ν²).
const IN_SI: &str = "velocity = \"0.1 mm/s\"\nnormal_load = \"0.13333333333333333 mN\"";

/// x0 = F_n/k_x = 8/3 µm, and a unit of time is 1/ω_nx = 25 ms.
#[test]
fn a_motion_in_si_is_that_in_groups_times_its_units() {
    let asked = "kind = \"motion\"\nduration = 100.0\npoints = 512";
    let folders = [tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap()];
    let groups = results(folders[0].path(), IN_GROUPS, asked, "motion");
    let si = results(folders[1].path(), IN_SI, asked, "motion");
    assert!(!groups.contains_key("rms_m"));
    assert!((number(&si["rms"]) / number(&groups["rms"]) - 1.0).abs() < 1e-6);
    assert!((number(&si["rms_m"]) / number(&si["rms"]) / (8e-6 / 3.0) - 1.0).abs() < 1e-12);
    assert!((number(&si["period_s"]) / number(&si["period"]) / 0.025 - 1.0).abs() < 1e-12);
    assert!((number(&si["frequency_hz"]) * number(&si["period_s"]) - 1.0).abs() < 1e-12);
    let table = std::fs::read_to_string(folders[1].path().join("motion.csv")).unwrap();
    let head = table.lines().next().unwrap();
    assert!(
        head.starts_with("time,x,y,") && head.contains("time [s],x [m],y [m],velocity_x [m/s]"),
        "{head}"
    );
    let page = std::fs::read_to_string(folders[1].path().join("report.html")).unwrap();
    assert!(page.contains("(µm)") && page.contains("Frequency (Hz)"));
    let page = std::fs::read_to_string(folders[0].path().join("report.html")).unwrap();
    assert!(!page.contains("(µm)"));
}

/// A motion that is followed for 2.5 s, half of which is heard at 48 kHz, 3 bytes a sample.
#[test]
fn a_motion_in_si_can_be_heard() {
    let folder = tempfile::tempdir().unwrap();
    let asked = "kind = \"motion\"\nduration = \"2.5 s\"\npoints = 512\nsound = true";
    let told = results(folder.path(), IN_SI, asked, "motion");
    assert_eq!(told["sound"][0]["file"], "motion-velocity_x.wav");
    let bytes = std::fs::read(folder.path().join("motion-velocity_x.wav")).unwrap();
    let seconds = bytes.len() as f64 / (3.0 * 48e3);
    assert!(bytes.starts_with(b"RIFF") && (1.2..1.3).contains(&seconds), "{seconds}");
}

/// Growth rates in 1/s and frequencies in Hz are those in groups times ω_nx = 40 rad/s, and over 2π.
#[test]
fn a_spectrum_in_si_tells_hertz() {
    let folder = tempfile::tempdir().unwrap();
    let asked = "kind = \"spectrum\"\nsweep = { key = \"contact.shear_strength\", from = 0.001, to = 0.1, points = 3 }";
    let told = results(folder.path(), IN_SI, asked, "spectrum");
    for k in 0..3 {
        let (growth, per_second) = (number(&told["growth_rate"][k]), number(&told["growth_rate_per_s"][k]));
        assert!((per_second / growth / 40.0 - 1.0).abs() < 1e-12);
        let fastest = told["eigenvalues"][k].as_array().unwrap();
        let fastest = fastest.iter().find(|own| number(&own[0]) == growth).unwrap();
        let hertz = number(&fastest[1]).abs() * 40.0 / std::f64::consts::TAU;
        assert!((number(&told["frequency_hz"][k]) / hertz - 1.0).abs() < 1e-12);
    }
    let dataset = StudyFolder::open(folder.path()).unwrap().read_dataset("spectrum").unwrap();
    assert_eq!(dataset.attributes()["si_units"]["second"], 0.025);
    let attributes = &dataset.variable("eigenvalues").unwrap().attributes;
    assert_eq!((&attributes["si_unit"], &attributes["si_factor"]), (&"1/s".into(), &40.0.into()));
}

/// x0 = F_n/k_x grows with the load along which a diagram goes: its arrays in SI are stored, and it is drawn in µm.
#[test]
fn a_diagram_along_the_load_is_in_si_too() {
    let folder = tempfile::tempdir().unwrap();
    let asked = "kind = \"bifurcation\"\nsweep = { key = \"operation.normal_load\", from = \"0.1 mN\", to = \"0.2 mN\", points = 2 }\nduration = 300.0";
    let told = results(folder.path(), IN_SI, asked, "bifurcation");
    let dataset = StudyFolder::open(folder.path()).unwrap().read_dataset("bifurcation").unwrap();
    let in_si = dataset.variable("rms_si").unwrap();
    let VariableValues::F64(values) = &in_si.data else { panic!("numbers") };
    assert_eq!(in_si.units, "m");
    let in_metres: Vec<f64> = told["rms_m"].as_array().unwrap().iter().map(number).collect();
    assert_eq!(values, &in_metres);
    let load = |k: usize| number(&told["rms_m"][k]) / number(&told["rms"][k]);
    assert!((load(1) / load(0) - 2.0).abs() < 1e-12 && load(0) > 0.0);
    assert!(std::fs::read_to_string(folder.path().join("report.html")).unwrap().contains("rms of $x$ (µm)"));
}

/// Over a cycle of the belt in SI the damper of 1 N s/m takes ∮ c v² dt, summed here over the samples of the table in m/s; what friction feeds in is lost there.
#[test]
fn energies_of_a_belt_in_si_are_in_joules() {
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &case("benchmarks/belt-in-si.toml", &[]), &["cycle"]);
    let told = &report.summary.results["cycle"];
    let energy = |key: &str| number(&told["energy_j"][key]);
    let table = std::fs::read_to_string(folder.path().join("cycle.csv")).unwrap();
    let head: Vec<&str> = table.lines().next().unwrap().split(',').collect();
    let column = |name: &str| -> Vec<f64> {
        let place = head.iter().position(|own| *own == name).unwrap();
        table.lines().skip(1).map(|row| row.split(',').nth(place).unwrap().parse().unwrap()).collect()
    };
    let (time, velocity) = (column("time [s]"), column("velocity_x [m/s]"));
    let pieces = time.windows(2).zip(velocity.windows(2));
    let lost: f64 = pieces.map(|(t, v)| 0.5 * (t[1] - t[0]) * (v[0] * v[0] + v[1] * v[1])).sum();
    assert!((energy("damping") / -lost - 1.0).abs() < 1e-5, "{} {lost}", energy("damping"));
    assert!((energy("friction") + energy("damping")).abs() < 1e-5 * lost, "{} {lost}", energy("friction"));
    let page = std::fs::read_to_string(folder.path().join("report.html")).unwrap();
    assert!(page.contains("in SI (µJ)") && page.contains("energy (−)"));
    let place = |what: &str| page.find(what).unwrap_or_else(|| panic!("{what}"));
    assert!(place("The motion") < place("Every number, by its key"), "what was asked stands first");
}

/// The unit of energy of the oscillator is k_x x0² = 50 N/m (8/3 µm)².
#[test]
fn energies_of_an_oscillator_in_si_are_those_in_groups_times_their_unit() {
    let folder = tempfile::tempdir().unwrap();
    let told = results(folder.path(), IN_SI, "kind = \"motion\"\nduration = 100.0\npoints = 512", "motion");
    let unit = 50.0 * (8e-6_f64 / 3.0).powi(2);
    for key in ["substrate", "friction", "damping", "change"] {
        let (group, joules) = (number(&told["energy"][key]), number(&told["energy_j"][key]));
        assert!((joules / group / unit - 1.0).abs() < 1e-12, "{key}: {joules} {group}");
    }
}
