//! Bodies of an assembly that turn.

use crate::{case, number, run_into};
use serde_json::{Map, Value};

/// The pad on the turning disc in fewer cells.
pub(super) const COARSE: [&str; 3] = [
    "structure.disc.disc.cells=[3, 16, 1]",
    "structure.disc.disc.sector.cells=4",
    "structure.pad.block.cells=[3, 4, 1]",
];

/// The results of an analysis of a case.
fn modes(name: &str, analysis: &str, overrides: &[&str]) -> Map<String, Value> {
    let folder = tempfile::tempdir().unwrap();
    let results = run_into(folder.path(), &case(name, overrides), &[analysis]).summary.results;
    assert_eq!(results[analysis]["complete"], true);
    results[analysis].clone()
}

fn frequencies(results: &Map<String, Value>) -> Vec<f64> {
    let all = results["eigenvalues"].as_array().unwrap().iter();
    all.map(|own| number(&own["im"]) / std::f64::consts::TAU).collect()
}

/// Of the ring of ANSYS' VM302 in so many cells the frequency in Hz that is nearest to one.
fn nearest_of_ring(cells: [usize; 3], analysis: &str, to: f64, overrides: &[&str]) -> f64 {
    let cells = format!("structure.ring.disc.cells={cells:?}");
    let found = frequencies(&modes(
        "assembly/rotating-ring.toml",
        analysis,
        &[&[cells.as_str()], overrides].concat(),
    ));
    found.into_iter().min_by(|a, b| (a - to).abs().total_cmp(&(b - to).abs())).unwrap()
}

/// The frequencies in Hz of the ring of ANSYS' VM302 in so many cells: of two and three waves at rest, of two against its turning and along it.
pub(super) fn ring(cells: [usize; 3]) -> [f64; 4] {
    let nearest =
        |analysis: &str, to: f64, overrides: &[&str]| nearest_of_ring(cells, analysis, to, overrides);
    let at_rest = |to: f64, region: &str| {
        let region = format!("analysis.against.region={{ re = [-50.0, 50.0], im = {region} }}");
        nearest("against", to, &["structure.ring.rotation.speed=0 rpm", &region])
    };
    [
        at_rest(75.30, "[377.0, 565.0]"),
        at_rest(209.93, "[1257.0, 1445.0]"),
        nearest("against", 91.54, &[]),
        nearest("along", 411.54, &[]),
    ]
}

/// The speed in rpm at which a wave against the turning of the disc of ANSYS' VM301 stands still in space, by the line through two speeds below it.
pub(super) fn critical_speed() -> f64 {
    let lowest = |speed: &str| {
        let speed = format!("structure.disc.rotation.speed={speed}");
        frequencies(&modes("assembly/critical-speed.toml", "modes", &[&speed]))[0]
    };
    let (first, second) = (lowest("2500 rpm"), lowest("2600 rpm"));
    2500.0 + 100.0 * first / (first - second)
}

/// A coarse ring is not far from what is printed of it: the table of printed numbers has the fine one.
#[test]
fn two_waves_of_a_coarse_ring_go_against_its_turning() {
    let found = nearest_of_ring([1, 96, 1], "against", 91.54, &[]);
    assert!((found / 91.54 - 1.0).abs() < 0.02, "{found}");
}

#[test]
fn what_is_left_out_of_a_turning_body_is_named() {
    let overrides = [
        "structure.disc.disc.cells=[2, 12, 1]",
        "structure.disc.rotation.centrifugal=false",
        "structure.disc.rotation.softening=false",
        "structure.disc.damping={ rayleigh = { beta = \"1e-7 s\" } }",
        "analysis.modes.band=[\"0 Hz\", \"100 Hz\"]",
    ];
    let told = modes("assembly/critical-speed.toml", "modes", &overrides);
    let expected = [
        "convective softening of `disc`",
        "centrifugal force and stiffening of `disc`",
        "that the damping of `disc` turns with it: it damps velocities as they are seen from where `disc` does not turn",
    ];
    assert_eq!(told["left_out"], serde_json::json!(expected));
}

/// A pad of hexahedra stands on a disc that turns beneath it: modes grow, and of what makes them grow gyroscopic forces are nothing.
#[test]
fn gyroscopic_forces_do_no_work_on_what_grows_under_a_pad() {
    let told = modes("assembly/pad-on-turning-disc.toml", "modes", &COARSE);
    assert_eq!(told["left_out"], serde_json::json!([]));
    let growing = told["growing"].as_array().unwrap();
    assert!(!growing.is_empty());
    for mode in growing {
        let growth = mode["growth"].as_object().unwrap();
        let rate = number(&told["eigenvalues"][number(&mode["mode"]) as usize - 1]["re"]);
        assert!(number(&growth["disc: gyroscopic forces"]).abs() < 1e-9 * rate);
        assert!(growth.contains_key("pad: slip of the passing track"), "{growth:?}");
        let sum: f64 = growth.values().map(number).sum();
        assert!((sum - rate).abs() < 1e-6 * rate.abs().max(1.0), "{sum} of {rate}");
    }
}
