//! Writes a study with every kind of content into the folder named on the command line; the Python tests open it with
//! `xarray`. The numbers are made up.

use std::time::Instant;

use judder_store::{
    AnalysisRecord, ClaimAnswer, Complex64, Dataset, PointFailure, Status, StoreError, StudyFolder, Summary,
    SweepDimension, SweepLayout, SweepQuantity, Table, Variable, content_hash, number,
};

const POINTS: usize = 1000;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).ok_or("name the folder to write into")?;
    let study = StudyFolder::create(&path)?;
    let hash = content_hash(b"a sample");

    let start = Instant::now();
    study.write_dataset("map", &hash, &map()?)?;
    let seconds = start.elapsed().as_secs_f64();
    eprintln!("map of {POINTS} × {POINTS} classes and growth rates: {seconds:.3} s");
    study.write_dataset("spectrum", &hash, &spectrum()?)?;
    study.write_dataset("thresholds", &hash, &thresholds()?)?;
    write_sweep(&study, &hash)?;

    study.write_table("thresholds", &Table::new().column("load", "N", vec![0.1, 1e-7, f64::NAN])?)?;
    study.write_file("figures/map.svg", b"<svg xmlns='http://www.w3.org/2000/svg'/>")?;
    study.write_summary(&summary(&hash), None)?;
    study.seal(env!("CARGO_PKG_VERSION"))?;
    Ok(())
}

/// A class map, with a growth rate that was not computed everywhere and a value for the whole.
fn map() -> Result<Dataset, StoreError> {
    let axis = |from: f64, to: f64| -> Vec<f64> {
        (0..POINTS).map(|i| from * (to / from).powf(i as f64 / (POINTS - 1) as f64)).collect()
    };
    let classes = (0..POINTS * POINTS).map(|i| ((i / POINTS + i % POINTS) / 500) as u8).collect();
    let growth = (0..POINTS * POINTS)
        .map(|i| if i % 7 == 0 { f64::NAN } else { (i as f64).sin() })
        .collect::<Vec<_>>();
    let (dimensions, shape) = (["shear_strength", "velocity"], [POINTS, POINTS]);
    let meanings = [(0, "stable"), (1, "flutter"), (2, "negative damping"), (255, "unresolved")];
    Dataset::new()
        .attribute("title", "A sample map")?
        .with(Variable::coordinate("velocity", axis(1e-8, 1e2)).units("1").long_name("speed v_d τ/R"))?
        .with(Variable::coordinate("shear_strength", axis(1e-4, 1.0)).units("1").long_name("τ₀/E₀*"))?
        .with(Variable::classes("verdict", &dimensions, &shape, classes, &meanings).long_name("verdict"))?
        .with(Variable::new("growth_rate", &dimensions, &shape, growth).units("1").long_name("Re(λ)/ω_nx"))?
        .with(Variable::new("retardation_time", &[], &[], vec![0.01]).units("s").as_coordinate())
}

/// Complex values, labels and whole numbers.
fn spectrum() -> Result<Dataset, StoreError> {
    let eigenvalues = (0..12).map(|i| Complex64::new(-0.1 * f64::from(i), f64::from(i))).collect::<Vec<_>>();
    let entries = ["c11", "ξ of the rubber", ""].map(String::from).to_vec();
    Dataset::new()
        .with(Variable::coordinate("velocity", vec![1e-4, 1e-2, 1.0]).units("30 mm/s"))?
        .with(Variable::coordinate("entry", entries))?
        .with(Variable::new("eigenvalues", &["velocity", "mode"], &[3, 4], eigenvalues).units("rad/s"))?
        .with(Variable::new("iterations", &["velocity"], &[3], vec![3_i64, -1, i64::MAX]))?
        .with(
            Variable::new("regime", &["velocity"], &[3], ["slow", "", "fast"].map(String::from).to_vec())
                .as_coordinate(),
        )
}

/// An answer without roots.
fn thresholds() -> Result<Dataset, StoreError> {
    Dataset::new()
        .with(Variable::coordinate("velocity", vec![1e-4, 1e-2]).units("1"))?
        .with(Variable::new("critical_load", &["velocity", "root"], &[2, 0], Vec::<f64>::new()).units("1"))
}

/// A sweep over two keys of which the chunk in the middle, of 5 × 3, is not computed yet, and a point has failed.
fn write_sweep(study: &StudyFolder, hash: &str) -> Result<(), StoreError> {
    let dimension = |name: &str, length, chunk| SweepDimension { name: name.to_owned(), length, chunk };
    let dimensions = vec![dimension("operation.velocity", 23, 5), dimension("contact.shear_strength", 10, 4)];
    let quantities = vec![
        SweepQuantity::new("growth_rate", "1/s", "growth rate, Re(λ)"),
        SweepQuantity::new("verdict", "", "verdict").flags(&[(0, "stable"), (1, "flutter")]),
    ];
    let layout = SweepLayout::new("robustness", hash, dimensions, quantities)?
        .with(
            Variable::coordinate("operation.velocity", (0..23).map(f64::from).collect::<Vec<_>>())
                .units("mm/s"),
        )?
        .attribute("method", "grid")?;
    let store = study.sweep(&layout)?;
    for chunk in (0..layout.chunk_count()).filter(|chunk| *chunk != 7) {
        let ClaimAnswer::Claimed(claim) = store.claim(chunk)? else { continue };
        let points = layout.points(chunk)?;
        let value =
            |point| points.position(point).iter().fold(0.0, |value, along| value * 10.0 + *along as f64);
        let mut values: Vec<f64> =
            (0..points.count()).flat_map(|point| [value(point), (point % 2) as f64]).collect();
        let mut failures = Vec::new();
        if chunk == 0 {
            values[..2].fill(f64::NAN);
            failures.push(PointFailure { index: 0, reason: "no equilibrium".to_owned() });
        }
        store.write(claim, &values, &failures)?;
    }
    Ok(())
}

fn summary(hash: &str) -> Summary {
    let done = |name: &str| {
        let (hash, warnings) = (hash.to_owned(), vec!["beyond the law's range".to_owned()]);
        (name.to_owned(), AnalysisRecord { hash, status: Status::Done, wall_time_s: 0.25, warnings })
    };
    let results = [("unstable_fraction", number(0.4)), ("largest_load", number(f64::INFINITY))];
    Summary {
        case_hash: hash.to_owned(),
        version: env!("CARGO_PKG_VERSION").to_owned(),
        wall_time_s: 0.75,
        analyses: ["map", "spectrum", "thresholds"].map(done).into(),
        results: [(
            "map".to_owned(),
            results.map(|(key, value)| (key.to_owned(), value)).into_iter().collect(),
        )]
        .into(),
        ..Summary::default()
    }
}
