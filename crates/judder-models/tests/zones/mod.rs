//! Unstable zones as they are told and drawn.

use crate::{number, run_into};
use judder_report::Layer;
use judder_store::{StudyFolder, VariableValues};
use std::f64::consts::TAU;
use std::path::Path;

fn matrix(folder: &Path, name: &str, diagonal: &[f64]) {
    let size = diagonal.len();
    let entries: String = diagonal.iter().enumerate().map(|(k, v)| format!("{0} {0} {v}\n", k + 1)).collect();
    let text = format!("%%MatrixMarket matrix coordinate real symmetric\n{size} {size} {size}\n{entries}");
    std::fs::write(folder.join(name), text).unwrap();
}

/// A mass on a track of six stiff masses, two of them alike, that nothing damps: friction that falls with speed feeds what the contact moves, and the
/// track beside the contact swings on with no growth at all. Every zone grows faster than its own error, and promises no more than its growth rate
/// all the way through it.
#[test]
fn rounding_makes_no_zones_and_promises_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let own = folder.path();
    matrix(own, "Ms.mtx", &[0.05, 0.05, 0.01, 0.01]);
    matrix(own, "Ks.mtx", &[2e3, 1.0, 1e7, 1e7]);
    matrix(own, "Mt.mtx", &[1.0; 6]);
    matrix(own, "Kt.mtx", &[1e9, 1e9, 1.04e9, 1.09e9, 1.16e9, 1.16e9]);
    std::fs::write(
        own.join("s.csv"),
        "node,direction,x,y,z\n1,x,0,0,0\n1,y,0,0,0\n2,x,0,0.02,0\n2,y,0,0.02,0\n",
    )
    .unwrap();
    let nodes = ["1,x,0.0", "1,y,0.0", "2,x,0.05", "2,y,0.05", "3,x,0.1", "3,y,0.1"];
    let table: String = nodes.iter().map(|node| format!("{node},0,0\n")).collect();
    std::fs::write(own.join("t.csv"), format!("node,direction,x,y,z\n{table}")).unwrap();
    let text = r#"
        model = "sliding"
        [[structure]]
        name = "s"
        matrices = { mass = [{ file = "Ms.mtx" }], stiffness = [{ file = "Ks.mtx" }], damping = [{ file = "Ms.mtx", factor = 4.0 }], freedoms = "s.csv" }
        [[structure]]
        name = "t"
        matrices = { mass = [{ file = "Mt.mtx" }], stiffness = [{ file = "Kt.mtx" }], freedoms = "t.csv" }
        [contact]
        slider = { structure = "s", nodes = [1] }
        track = { structure = "t", nodes = [1, 2, 3] }
        friction_coefficient = { velocity = ["0 mm/s", "50 mm/s", "200 mm/s"], coefficient = [0.5, 0.4, 0.3] }
        [motion]
        start = "10 mm"
        end = "90 mm"
        velocity = "30 mm/s"
        load = { nodes = [1], direction = "y", force = "-1 N" }
        ramps = { velocity = "0.05 s", load = "0.05 s", friction = "0.05 s", gap = "0.05 s" }
        [observe]
        points = [{ name = "C", structure = "s", nodes = [1] }]
        [[analysis]]
        name = "locus"
        kind = "locus"
        configuration = "deformed"
        count = 6
        positions = { points = 5 }
        [[analysis]]
        name = "march"
        kind = "march"
        method = "film"
        step = "2e-5 s"
        signals = { pass_band = "2 kHz", sample_rate = "10 kHz", quantities = ["displacement"] }
        signal = "C.x.displacement"
    "#;
    std::fs::write(own.join("case.toml"), text).unwrap();
    let report = run_into(&own.join("out"), &judder_models::read(own.join("case.toml"), &[]).unwrap(), &[]);
    assert!(report.complete, "{:?}", report.messages);
    let zones = report.summary.results["march"]["zones"].as_array().unwrap();
    assert!((1..=6).contains(&zones.len()), "{} zones", zones.len());
    let places: Vec<_> =
        zones.iter().map(|zone| (number(&zone["from_m"]), number(&zone["frequency_hz"]))).collect();
    assert!(places.windows(2).all(|pair| pair[0] != pair[1]), "{places:?}");
    for zone in zones {
        let (from, to) = (number(&zone["from_m"]), number(&zone["to_m"]));
        let most = number(&zone["max_growth_rate"]) * (to - from) / 0.03;
        assert!(number(&zone["max_growth_rate"]) > 1e-3, "{zone}");
        assert!(number(&zone["expected_amplification"]) <= most * (1.0 + 1e-9), "{zone} {most}");
        assert!(number(&zone["error"]) < most, "{zone}");
    }
    for zone in report.summary.results["locus"]["unstable"].as_array().unwrap() {
        assert!(number(&zone["max_growth_rate"]) > number(&zone["error"]), "{zone}");
    }
}

/// A reed on a bar, where a mode grows all along while its frequency moves: the panel of the zones draws its growth and no zero within.
#[test]
fn zones_are_drawn_with_the_growth_that_they_have() {
    let text = r#"
        model = "sliding"
        [[structure]]
        name = "reed"
        beam = { length = "60 mm", thickness = "2 mm", elements = [30, 1], angle = "-35 deg", start = "guided", end = "free" }
        width = "10 mm"
        material = { youngs_modulus = "71 GPa", poisson_ratio = 0.33, density = "2770 kg/m^3" }
        damping = { rayleigh = { ratios = [{ frequency = "500 Hz", ratio = 0.002 }, { frequency = "20 kHz", ratio = 0.01 }] } }
        reduction = { count = 10 }
        [[structure]]
        name = "bar"
        beam = { length = "150 mm", thickness = "4 mm", elements = [50, 1], angle = "0 deg", start = "clamped", end = "free" }
        width = "20 mm"
        material = { youngs_modulus = "2.4 GPa", poisson_ratio = 0.4, density = "1200 kg/m^3" }
        damping = { rayleigh = { ratios = [{ frequency = "100 Hz", ratio = 0.003 }, { frequency = "20 kHz", ratio = 0.02 }] } }
        reduction = { count = 10 }
        [contact]
        slider = { structure = "reed", set = "end-lower" }
        track = { structure = "bar", set = "upper-corners" }
        friction_coefficient = { velocity = ["0 mm/s", "50 mm/s", "200 mm/s"], coefficient = [0.45, 0.31, 0.28] }
        interpolation = "hermite"
        [motion]
        start = "40 mm"
        end = "140 mm"
        velocity = "60 mm/s"
        load = { set = "start", direction = "y", force = "-1 N" }
        [[analysis]]
        name = "locus"
        kind = "locus"
        configuration = "deformed"
        count = 8
        positions = { from = "40 mm", to = "140 mm", points = 40 }
    "#;
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &judder_models::parse("case.toml", text, &[]).unwrap(), &[]);
    assert!(report.complete, "{:?}", report.messages);
    let dataset = StudyFolder::open(folder.path()).unwrap().read_dataset("locus").unwrap();
    let reals = |name: &str| match &dataset.variable(name).unwrap().data {
        VariableValues::F64(values) => values.clone(),
        other => panic!("{other:?}"),
    };
    let VariableValues::Complex(values) = &dataset.variable("zone_path_eigenvalue").unwrap().data else {
        panic!()
    };
    let hertz = values.iter().filter(|s| s.re > 0.0).map(|s| s.im / TAU);
    let zones: Vec<(f64, f64)> = reals("zone_from").into_iter().zip(reals("zone_to")).collect();
    let wide =
        (0..zones.len()).max_by(|a, b| (zones[*a].1 - zones[*a].0).total_cmp(&(zones[*b].1 - zones[*b].0)));
    let wide = zones[wide.unwrap()];
    // the test would say nothing of a frequency that stays
    let (low, high) = hertz.fold((f64::INFINITY, 0.0_f64), |(l, h), f| (l.min(f), h.max(f)));
    assert!(wide.1 - wide.0 > 0.05 && high > 1.02 * low, "{wide:?} {low} {high}");
    let figure = judder_models::sliding::MODEL.figure("locus", "locus", &dataset).unwrap().unwrap();
    let panel = figure.panels.iter().find(|panel| panel.title == "unstable zones").unwrap();
    let mut inside = 0;
    for layer in &panel.layers {
        let Layer::Line(line) = layer else { continue };
        for (x, y) in line.x.iter().zip(&line.y).filter(|(_, y)| y.is_finite()) {
            let is_end =
                zones.iter().any(|(from, to)| [from, to].iter().any(|end| (1e3 * **end - x).abs() < 1e-6));
            assert!(is_end || *y > 0.0, "{x} mm: {y}");
            inside += usize::from(!is_end);
        }
    }
    assert!(inside > 20, "{inside}");
}
