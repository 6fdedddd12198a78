//! The runnable sliding cases show what their first comments say.

use crate::{case, number, run_into};
use judder_study::case::file::CaseFile;
use serde_json::{Map, Value};
use std::path::Path;

const FALLING: &str = "sliding/falling-friction.toml";
const CURVED: &str = "sliding/curved-edge.toml";

/// The result of one analysis that misses nothing.
fn result(file: &CaseFile, folder: &Path, name: &str) -> Map<String, Value> {
    let report = run_into(folder, file, &[name]);
    assert!(report.complete && report.messages.is_empty(), "{:?}", report.messages);
    assert!(folder.join(format!("figures/{name}.svg")).is_file(), "{name}");
    report.summary.results[name].clone()
}

fn list<'a>(result: &'a Map<String, Value>, key: &str) -> &'a [Value] {
    result[key].as_array().unwrap()
}

/// Four modes grow along the whole path; constant friction of the same size leaves less than a millimetre.
#[test]
fn falling_friction_makes_the_whole_path_unstable() {
    let folder = tempfile::tempdir().unwrap();
    let few = "analysis.locus.positions.points=20";
    let falling = result(&case(FALLING, &[few]), &folder.path().join("falling"), "locus");
    let length = |zone: &Value| number(&zone["to_m"]) - number(&zone["from_m"]);
    for wanted in [170.0, 290.0, 3530.0, 3930.0] {
        let is_it = |zone: &&Value| (number(&zone["frequency_hz"]) / wanted - 1.0).abs() < 0.02;
        let zone = list(&falling, "unstable").iter().find(is_it).unwrap_or_else(|| panic!("{wanted} Hz"));
        assert!((length(zone) - 0.01).abs() < 1e-9, "{zone}");
    }
    let constant = case(FALLING, &[few, "contact.friction_coefficient=0.31"]);
    let constant = result(&constant, &folder.path().join("constant"), "locus");
    let unstable: f64 = list(&constant, "unstable").iter().map(length).sum();
    assert!(unstable < 1e-3, "{:?}", constant["unstable"]);
}

/// Negative damping goes with the slope of the table: it falls at each of its corners, and is gone where friction is constant.
#[test]
fn growth_falls_where_the_table_becomes_flatter() {
    let folder = tempfile::tempdir().unwrap();
    let file = case(FALLING, &["analysis.velocity.sweep.points=16"]);
    let swept = result(&file, folder.path(), "velocity");
    let largest = |row: &Value| row.as_array().unwrap().iter().map(number).fold(f64::MIN, f64::max);
    for (speed, row) in list(&swept, "value").iter().zip(list(&swept, "growth_rates")) {
        let (speed, growth) = (number(speed), largest(row));
        let expected = match speed {
            _ if speed < 0.039 => 50.0..150.0,
            _ if speed > 0.041 && speed < 0.059 => 5.0..40.0,
            _ if speed > 0.061 => -1e3..0.0,
            _ => continue,
        };
        assert!(expected.contains(&growth), "{speed} m/s: {growth}");
    }
}

/// Stick and slip: the swing of the sliding velocity grows until it is as large as the velocity itself.
#[test]
fn falling_friction_ends_in_stick_and_slip() {
    let folder = tempfile::tempdir().unwrap();
    let march = result(&case(FALLING, &[]), folder.path(), "film");
    assert!(march["stick_steps"].as_u64().unwrap() > 1000, "{}", march["stick_steps"]);
    let velocity = &march["sliding_velocity"];
    assert!(number(&velocity["min"]) < 0.0 && number(&velocity["max"]) > 0.05, "{velocity}");
    let bursts = list(&march, "bursts");
    assert!(bursts.iter().any(|burst| (number(&burst["frequency_hz"]) / 3500.0 - 1.0).abs() < 0.03));
}

/// Behind each zone a burst of its frequency; its peak goes with the seed, its place does not, and without noise there is none.
#[test]
#[ignore = "expensive: run by make validate"]
fn noise_bursts_behind_the_zones_of_a_curved_edge() {
    let folder = tempfile::tempdir().unwrap();
    let march = |name: &str, set: &[&str]| result(&case(CURVED, set), &folder.path().join(name), "ensubs");
    let (own, other) = (march("own", &[]), march("other", &["motion.noise.seed=8"]));
    let silent = march("silent", &["motion.noise.force=0 N"]);
    for march in [&own, &other] {
        let bursts = list(march, "bursts");
        assert_eq!(bursts.len(), 2, "{bursts:?}");
        for (burst, place) in bursts.iter().zip([0.0837, 0.0918]) {
            assert!((number(&burst["position_m"]) - place).abs() < 3e-4, "{burst}");
            assert!((number(&burst["frequency_hz"]) - 3523.0).abs() < 40.0, "{burst}");
        }
    }
    let peak = |march: &Map<String, Value>| number(&march["peak_acceleration"]);
    assert!((peak(&other) / peak(&own) - 1.0).abs() > 0.1, "{} {}", peak(&own), peak(&other));
    assert!(peak(&silent) < 1e-2 * peak(&own), "{} {}", peak(&silent), peak(&own));
}
