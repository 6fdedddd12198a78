//! Sliding cases end to end: the locus and the growth of the beams paper, sweeps, matrices in place of a beam.

use crate::{case, number, run_into};
use judder_exchange::matrix::Matrix;
use judder_exchange::matrix_market::write_matrix_market;
use judder_store::{StudyFolder, VariableValues};
use judder_structure::assembly::{Assembled, assemble};
use judder_structure::beam::Beam;
use judder_structure::freedom::{Direction, Numbering, Supports};
use judder_structure::material::{Elastic, ElementSection};
use judder_study::Silent;
use judder_study::case::file::CaseFile;
use judder_study::resolve::resolve;
use judder_study::run::{RunOptions, RunReport, run};
use serde_json::Value;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

const PAPER: &str = "beams-paper/paper.toml";

fn result<'a>(report: &'a RunReport, name: &str) -> &'a serde_json::Map<String, Value> {
    assert!(report.messages.is_empty(), "{:?}", report.messages);
    &report.summary.results[name]
}

fn zones(result: &serde_json::Map<String, Value>) -> Vec<&Value> {
    result["unstable"].as_array().unwrap().iter().collect()
}

/// Our notes on the beams paper: undeformed, narrow zones of flutter near 6.9 and 10.57 kHz; deformed, zones at 3.52 kHz near 74, 82, 91
/// and 99 mm. Twenty positions do: zones are located between them.
#[test]
fn the_locus_of_the_beams_paper() {
    let folder = tempfile::tempdir().unwrap();
    let few = ["analysis.locus.positions.points=20", "analysis.locus-deformed.positions.points=20"];
    let report = run_into(folder.path(), &case(PAPER, &few), &["locus", "locus-deformed"]);
    assert!(report.complete);
    let undeformed = result(&report, "locus");
    assert_eq!(undeformed["position_m"].as_array().unwrap().len(), 20);
    for table in ["frequencies_hz", "growth_rates"] {
        let rows = undeformed[table].as_array().unwrap();
        assert!(rows.len() == 20 && rows.iter().all(|row| row.as_array().unwrap().len() == 20), "{table}");
    }
    for (wanted, tolerance) in [(6900.0, 60.0), (10_570.0, 60.0)] {
        let near = |zone: &&Value| (number(&zone["frequency_hz"]) - wanted).abs() < tolerance;
        let found: Vec<&Value> = zones(undeformed).into_iter().filter(near).collect();
        assert!(!found.is_empty(), "{wanted}: {:?}", undeformed["unstable"]);
        assert!(found.iter().all(|zone| number(&zone["max_growth_rate"]) > 0.0));
    }
    let deformed = zones(result(&report, "locus-deformed"));
    for wanted in [0.074, 0.082, 0.091] {
        let is_it = |zone: &&&Value| {
            (number(&zone["from_m"]) - 0.002..number(&zone["to_m"]) + 0.002).contains(&wanted)
                && (number(&zone["frequency_hz"]) - 3520.0).abs() < 40.0
        };
        assert!(deformed.iter().find(is_it).is_some(), "{wanted}: {deformed:?}");
    }
    for file in ["locus.csv", "figures/locus.svg", "figures/locus-deformed.png", "report.html"] {
        assert!(folder.path().join(file).is_file(), "{file}");
    }
}

/// The march with the contact held grows as the eigenvalue there, to a percent.
#[test]
fn growth_with_the_contact_held() {
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &case(PAPER, &[]), &["growth"]);
    let growth = result(&report, "growth");
    let [measured, predicted] = ["measured", "predicted"].map(|key| number(&growth[key]));
    assert!((measured / predicted - 1.0).abs() < 1e-2, "{measured} {predicted}");
    assert!((number(&growth["frequency_hz"]) - 3520.0).abs() < 40.0, "{growth:?}");
    // the history that it was measured in, a quarter further, and its picture
    let dataset = StudyFolder::open(folder.path()).unwrap().read_dataset("growth").unwrap();
    let values = |name: &str| match &dataset.variable(name).unwrap().data {
        VariableValues::F64(values) => values.clone(),
        _ => panic!("{name}"),
    };
    let (time, amplitude) = (values("time"), values("amplitude"));
    let until = number(&dataset.attributes()["measured_until_s"]);
    let last = time[time.len() - 1];
    assert!((1.2..1.25).contains(&(last / until)), "{last} {until}");
    // amplitudes of periods rise by the growth rate, from what the mode was started with
    let rate = (amplitude[amplitude.len() - 1] / amplitude[0]).ln() / (last - time[0]);
    assert!((rate / measured - 1.0).abs() < 0.02, "{rate} {measured}");
    let start = number(&dataset.attributes()["start_amplitude_n"]);
    assert!((amplitude[0] / start - 1.0).abs() < 0.05, "{} {start}", amplitude[0]);
    assert!(folder.path().join("figures/growth.svg").is_file());
}

/// c·M⁻¹e is straight in the friction coefficient: the slider locks beyond one of them, above 3 (our notes). That is said, and what lies
/// below is computed all the same. Without friction nothing that is damped can grow.
#[test]
fn a_sweep_tells_where_the_slider_locks() {
    let folder = tempfile::tempdir().unwrap();
    let few = [
        "analysis.locus-friction.sweep.to=8.0",
        "analysis.locus-friction.sweep.points=3",
        "analysis.locus-friction.configuration=undeformed",
        // between two nodes, where the track yields most
        "analysis.locus-friction.at=74.5 mm",
    ];
    let report = run_into(folder.path(), &case(PAPER, &few), &["locus-friction"]);
    assert!(!report.complete);
    let result = &report.summary.results["locus-friction"];
    let missing = result["missing"].as_array().unwrap();
    assert!(!missing.is_empty(), "{result:?}");
    for one in missing {
        assert!(
            number(&one["value"]) > 3.0 && one["reason"].as_str().unwrap().contains("sprag-slip"),
            "{one}"
        );
    }
    let rates = result["growth_rates"].as_array().unwrap();
    assert!(lowest(&rates[0]).iter().all(|rate| *rate < 0.0), "{}", rates[0]);
    assert!(rates[2].as_array().unwrap().iter().all(Value::is_null), "{}", rates[2]);
}

/// Where a load meets values that lift the slider off, a zone ends at the last that does not: that is said.
#[test]
fn zones_beside_values_without_a_pair_are_told() {
    let folder = tempfile::tempdir().unwrap();
    let sweep = "analysis.locus-friction.sweep={ key = \"motion.load.force\", from = \"-0.3 N\", to = \"0.1 N\", points = 5 }";
    let report = run_into(folder.path(), &case(PAPER, &[sweep]), &["locus-friction"]);
    let result = &report.summary.results["locus-friction"];
    let zones = result["unstable"].as_array().unwrap();
    let last = number(&result["missing"][0]["value"]) - 0.1;
    let cut: Vec<&Value> = zones.iter().filter(|zone| (number(&zone["to"]) - last).abs() < 1e-9).collect();
    assert!(!cut.is_empty() && cut.iter().all(|zone| zone["ends"][1] == "range"), "{zones:?}");
    let told = report.messages.iter().filter(|warning| warning.contains("goes on beyond")).count();
    assert_eq!(told, cut.len(), "{:?}", report.messages);
}

/// At the very end of the track the deformation takes the contact beyond it: the message has the key's value, not the deformed place.
#[test]
fn a_contact_held_at_the_end_is_refused_by_its_own_position() {
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &case(PAPER, &["analysis.growth.position=100 mm"]), &["growth"]);
    let told =
        format!("{:?}", report.refused.iter().map(|refused| refused.error.to_string()).collect::<Vec<_>>());
    assert!(told.contains("held at 0.1 m") && !told.contains("0.10005"), "{told}");
}

/// A key of a structure: a longer slider swings more slowly, its lowest frequency by a factor near (75/80)².
#[test]
fn a_sweep_of_a_structure_builds_it_anew() {
    let folder = tempfile::tempdir().unwrap();
    let file = small(
        "sweep = { key = \"structure.slider.beam.length\", from = \"80 mm\", to = \"70 mm\", points = 3 }\nat = \"40 mm\"",
    );
    let report = run_into(folder.path(), &file, &[]);
    let result = result(&report, "locus");
    assert_eq!((result["unit"].as_str(), number(&result["value"][0])), (Some("m"), 0.08));
    let lowest: Vec<f64> =
        result["frequencies_hz"].as_array().unwrap().iter().map(|row| number(&row[2])).collect();
    assert!(lowest[0] < lowest[1] && lowest[1] < lowest[2], "{lowest:?}");
}

/// What the branches have at one value, ascending; those that are not among the lowest there have nothing.
fn lowest(row: &Value) -> Vec<f64> {
    let there = row.as_array().unwrap().iter().filter(|value| !value.is_null());
    let mut values: Vec<f64> = there.map(number).collect();
    values.sort_by(f64::total_cmp);
    values
}

/// The track as the matrices of another program, its nodes named in disorder: the same pair, hence the same spectrum.
#[test]
fn matrices_make_the_same_track() {
    let folder = tempfile::tempdir().unwrap();
    let positions = "positions = { from = \"20 mm\", to = \"60 mm\", points = 3 }";
    let report = run_into(&folder.path().join("beam"), &small(positions), &[]);
    let expected = result(&report, "locus")["frequencies_hz"].clone();
    let nodes = write_track(folder.path());
    // the held node is in no table: positions count from the next one, 5 mm on
    let positions = "positions = { from = \"15 mm\", to = \"55 mm\", points = 3 }";
    let text = text(positions)
        .replace(TRACK, MATRICES)
        .replace("set = \"upper-corners\"", &format!("nodes = {nodes:?}"));
    let path = folder.path().join("case.toml");
    std::fs::write(&path, text).unwrap();
    let report = run_into(&folder.path().join("matrices"), &judder_models::read(path, &[]).unwrap(), &[]);
    assert!(
        report.messages.iter().all(|told| told.contains("order along the edge")),
        "{:?}",
        report.messages
    );
    let found = &report.summary.results["locus"]["frequencies_hz"];
    for (found, expected) in found.as_array().unwrap().iter().zip(expected.as_array().unwrap()) {
        let (found, expected) = (lowest(found), lowest(expected));
        assert_eq!(found.len(), 8);
        for (found, expected) in found.iter().zip(&expected) {
            assert!((found - expected).abs() < 1e-6 * expected.max(1.0), "{found} {expected}");
        }
    }
}

/// What cannot be is said before anything runs, with the key and what to do; `judder check` says the same.
fn refused(text: &str) -> String {
    let file = judder_models::parse("case.toml", text, &[]).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("study");
    let refused = run(&file, &path, &RunOptions::default(), &Silent).unwrap_err();
    assert!(!path.exists());
    let checked = resolve(&file, &Silent).err().unwrap();
    assert_eq!(refused.to_string(), checked.to_string());
    refused.to_string()
}

/// A smooth edge takes four nodes: three do not make one, and are not taken for a straight one in silence.
#[test]
fn a_smooth_edge_of_three_nodes_is_refused() {
    let positions = "positions = { from = \"20 mm\", to = \"60 mm\", points = 3 }";
    let smooth = |elements: usize| {
        text(positions)
            .replace("elements = [20, 1]", &format!("elements = [{elements}, 1]"))
            .replace("[contact]", "[contact]\ninterpolation = \"hermite\"")
            .replace("reduction = { count = 8 }", "reduction = { count = 2 }")
            .replace("count = 8", "count = 3")
    };
    let said = refused(&smooth(2));
    assert!(said.contains("`hermite` interpolation takes 4 nodes of the track, this one has 3"), "{said}");
    let file = judder_models::parse("case.toml", &smooth(3), &[]).unwrap();
    assert!(resolve(&file, &Silent).is_ok());
}

/// A micrometre a second along a tenth of a metre: a day and more of samples. The estimate of a march counts what is looked at afterwards.
#[test]
fn a_march_that_keeps_too_much_is_refused() {
    let march = "\n[[analysis]]\nname = \"march\"\nkind = \"march\"\nmethod = \"ensubs\"\n";
    let with = |velocity: &str| {
        text("at = \"40 mm\"\nsweep = { key = \"contact.friction_coefficient\", from = 0.1, to = 0.3, points = 2 }")
            .replace("end = \"90 mm\"", &format!("end = \"90 mm\"\nvelocity = \"{velocity}\""))
            + march
    };
    let said = refused(&with("1 um/s"));
    assert!(
        said.contains("samples of 5 signals, and the pair: ") && said.contains(" of memory are needed, and "),
        "{said}"
    );
    let file = judder_models::parse("case.toml", &with("0.1 m/s"), &[]).unwrap();
    let checked = resolve(&file, &Silent).unwrap().json();
    let estimate = checked["estimate"].as_array().unwrap().iter().find(|own| own["name"] == "march").unwrap();
    // 0.9 s and more at 120 kHz or more, five signals and what is copied of them
    let bytes = number(&estimate["bytes"]);
    assert!((0.9 * 120e3 * 5.0 * 8.0..4e9).contains(&bytes), "{estimate}");
    let stored = &checked["samples"]["march"];
    assert_eq!(number(&stored["bytes"]), 8.0 * number(&stored["samples"]) * number(&stored["signals"]));
    assert!(bytes > number(&stored["bytes"]), "{stored}");
}

/// A window longer than the march that it looks at, or shorter than a spectrum takes, is found before the march has been computed.
#[test]
fn a_window_that_its_march_has_not_is_refused() {
    let march = "\n[[analysis]]\nname = \"march\"\nkind = \"march\"\nmethod = \"ensubs\"\n";
    let levels = "\n[[analysis]]\nname = \"levels\"\nkind = \"spectrogram\"\nof = \"march\"\nsignal = \"normal-force\"\nlength = ";
    let positions = "positions = { from = \"20 mm\", to = \"60 mm\", points = 3 }";
    let of = |length: &str| refused(&(text(positions) + march + levels + length));
    let said = of("\"1e9 s\"\n");
    assert!(said.contains("a window is 1000000000 s long, but the march `march` takes"), "{said}");
    let said = of("\"1 us\"\n");
    assert!(said.contains(" 0 samples of the march `march`, and at least 8 are needed"), "{said}");
}

const TRACK: &str = r#"beam = { length = "100 mm", thickness = "2 mm", elements = [20, 1], start = "clamped" }
width = "20 mm"
material = { youngs_modulus = "2.38 GPa", poisson_ratio = 0.40, density = "1200 kg/m^3" }
damping = { rayleigh = { alpha = "40 1/s", beta = "4e-8 s" } }"#;

const MATRICES: &str = r#"matrices = { mass = [{ file = "M.mtx" }], stiffness = [{ file = "K.mtx" }], damping = [{ file = "M.mtx", factor = 40.0 }, { file = "K.mtx", factor = 4e-8 }], freedoms = "freedoms.csv" }"#;

/// A coarse pair of beams.
fn text(locus: &str) -> String {
    format!(
        r#"
model = "sliding"

[[structure]]
name = "slider"
beam = {{ length = "75 mm", thickness = "1.5 mm", elements = [15, 1], angle = "-30 deg", start = "guided" }}
width = "10 mm"
material = {{ youngs_modulus = "71 GPa", poisson_ratio = 0.33, density = "2770 kg/m^3" }}
damping = {{ rayleigh = {{ alpha = "0.2 1/s", beta = "4e-8 s" }} }}
reduction = {{ count = 8 }}

[[structure]]
name = "track"
{TRACK}
reduction = {{ count = 8 }}

[contact]
slider = {{ structure = "slider", set = "end-lower" }}
track = {{ structure = "track", set = "upper-corners" }}

[motion]
end = "90 mm"
load = {{ set = "start" }}

[[analysis]]
name = "locus"
kind = "locus"
configuration = "deformed"
count = 8
{locus}
"#
    )
}

pub(crate) fn small(locus: &str) -> CaseFile {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("case.toml");
    std::fs::write(&path, text(locus)).unwrap();
    judder_models::read(path, &[]).unwrap()
}

/// Writes M, K and the table of freedoms of the track; gives the numbers of the free nodes of its edge, the held one being in no table,
/// both ends first.
fn write_track(folder: &Path) -> Vec<usize> {
    let beam = Beam { length: 0.1, thickness: 0.002, elements: [20, 1], origin: [0.0; 2], angle: 0.0 };
    let mesh = beam.mesh("m").unwrap();
    let both = [Direction::X, Direction::Y];
    let fixed =
        mesh.node_sets["start"].iter().flat_map(|node| both.map(|direction| (*node, direction))).collect();
    let numbering = Numbering::new(&mesh, 2, &Supports { fixed, tied: Vec::new() }).unwrap();
    let own = (Elastic::new(2.38e9, 0.40, 1200.0).unwrap(), ElementSection::PlaneStress { thickness: 0.020 });
    let Assembled { stiffness, mass } =
        assemble(&mesh, &BTreeMap::from([("m".to_owned(), own)]), &numbering).unwrap();
    for (name, matrix) in [("M", &mass), ("K", &stiffness)] {
        let mut file = std::fs::File::create(folder.join(format!("{name}.mtx"))).unwrap();
        write_matrix_market(&mut file, &Matrix::from_sparse(matrix)).unwrap();
    }
    let mut table = "node,direction,x,y,z\n".to_owned();
    for freedom in numbering.freedoms() {
        let [x, y, z] = mesh.nodes[freedom.node];
        let along = if freedom.direction == Direction::X { "x" } else { "y" };
        writeln!(table, "{},{along},{x:?},{y:?},{z:?}", freedom.node).unwrap();
    }
    std::fs::write(folder.join("freedoms.csv"), table).unwrap();
    let mut nodes = mesh.node_sets["upper-corners"][1..].to_vec();
    let last = nodes.pop().unwrap();
    nodes.insert(1, last);
    nodes
}
