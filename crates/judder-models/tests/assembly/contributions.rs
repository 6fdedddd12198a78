//! Of which modes limit cycles are made up.

use super::cycles::array;
use crate::{case, number, run_into};
use judder_store::StudyFolder;
use judder_study::run::RunReport;

const BRAKE: &str = "assembly/lumped-brake.toml";

/// A case of which an analysis takes the place of its own.
fn with_cycle(name: &str, replace: &[(&str, &str)], analysis: &str) -> (RunReport, judder_store::Dataset) {
    let text = std::fs::read_to_string(format!("{}/../../cases/{name}", env!("CARGO_MANIFEST_DIR"))).unwrap();
    let mut bodies = text.split("[[analysis]]").next().unwrap().to_owned();
    for (from, to) in replace {
        assert!(bodies.contains(from), "{from}");
        bodies = bodies.replace(from, to);
    }
    let observed = if bodies.contains("[observe]") {
        ""
    } else {
        "[observe]\npoints = [{ name = \"mass\", structure = \"slider\", set = \"mass\" }]\n"
    };
    let text = format!("{bodies}{observed}[[analysis]]\nname = \"own\"\nkind = \"limit-cycle\"\n{analysis}");
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &judder_models::parse("case.toml", &text, &[]).unwrap(), &["own"]);
    (report, StudyFolder::open(folder.path()).unwrap().read_dataset("own").unwrap())
}

/// Frequencies and shares that are told.
fn told(results: &serde_json::Map<String, serde_json::Value>) -> Vec<[f64; 2]> {
    let own = results["mode_contributions"].as_array().unwrap_or_else(|| panic!("{results:?}"));
    own.iter().map(|own| [number(&own["frequency_hz"]), number(&own["share"])]).collect()
}

fn mean_square(values: &[f64]) -> f64 {
    values.iter().map(|own| own * own).sum::<f64>() / values.len() as f64
}

/// Without friction the stiffness of the minimal model is [[2, 1], [1, 2]]: its modes swing along (1, ±1)/√2 with √3 and 1 rad/s. Shares are those of the mean squares of the velocities along these.
#[test]
fn shares_are_those_of_the_velocities_along_the_modes() {
    let damped = ("mass = [[1, 0], [0, 1]]", "mass = [[1, 0], [0, 1]]\ndamping = [[0.2, 0], [0, 0.1]]");
    let (report, dataset) = with_cycle("assembly/mode-coupling.toml", &[damped], "harmonics = 15\n");
    let results = &report.summary.results["own"];
    let [x, y] = ["mass.x.velocity", "mass.y.velocity"].map(|name| array(&dataset, name));
    let along = |sign: f64| {
        mean_square(&x.iter().zip(&y).map(|(x, y)| (x + sign * y) / 2.0_f64.sqrt()).collect::<Vec<_>>())
    };
    let all = mean_square(&x) + mean_square(&y);
    let told = told(results);
    println!("{told:?}, left over {}", results["contributions_left_over"]);
    let expected = [(1.0, along(-1.0) / all), (3.0_f64.sqrt(), along(1.0) / all)];
    assert_eq!(told.len(), 2);
    for (own, (omega, share)) in told.iter().zip(expected) {
        assert!((own[0] * std::f64::consts::TAU / omega - 1.0).abs() < 1e-9, "{own:?} {omega}");
        assert!((own[1] - share).abs() < 1e-9 && share > 0.05, "{own:?} {share}");
    }
    assert!(number(&results["contributions_left_over"]) < 1e-9);
    assert_eq!(array(&dataset, "mode_contribution"), [told[0][1], told[1][1]]);
    assert_eq!(array(&dataset, "mode_frequency"), [told[0][0], told[1][0]]);
}

/// Where a cycle begins it has the shape of its mode, and is made up as `eigen` says that the mode is.
#[test]
fn a_small_cycle_is_made_up_as_its_mode_is() {
    let made_of = |eta: &str| {
        let file = case(BRAKE, &[&format!("parameters.eta={eta}"), "analysis.cycle.harmonics=7"]);
        let report = run_into(tempfile::tempdir().unwrap().path(), &file, &["modes", "cycle"]);
        let [modes, cycle] = ["modes", "cycle"].map(|name| &report.summary.results[name]);
        let parents = modes["growing"][0]["parents"].as_array().unwrap();
        let told = told(cycle);
        assert_eq!((parents.len(), told.len()), (2, 2));
        let apart = parents.iter().map(|parent| {
            let [at, share] = ["frequency_hz", "share"].map(|key| number(&parent[key]));
            let own = told.iter().find(|own| (own[0] / at - 1.0).abs() < 1e-9).unwrap();
            (own[1] - share).abs()
        });
        let apart = apart.fold(0.0, f64::max);
        println!("{eta}: {told:?}, {parents:?}, {apart:.1e} apart");
        apart
    };
    // the mode grows below 0.1979
    let (far, near) = (made_of("0.02"), made_of("0.197"));
    assert!(near < 0.1 * far, "{near} {far}");
}

/// A mass that sticks and slips, slower than it swings, has one mode, and all of its cycle is this mode's.
#[test]
fn a_body_with_one_mode_has_no_other() {
    let analysis = "harmonics = 25\n";
    let (report, _) = with_cycle("assembly/mass-on-falling-belt.toml", &[("1.2 m/s", "0.9 m/s")], analysis);
    let results = &report.summary.results["own"];
    let told = told(results);
    assert_eq!(told.len(), 1, "{told:?}");
    assert!((told[0][0] * std::f64::consts::TAU - 1.0).abs() < 1e-9 && (told[0][1] - 1.0).abs() < 1e-9);
    assert!(number(&results["contributions_left_over"]) < 1e-9);
}
