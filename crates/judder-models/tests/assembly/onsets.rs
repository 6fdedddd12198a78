//! Where along a key modes of assemblies begin to grow.

use crate::stopping::Stopping;
use crate::{case, number, run_into};
use judder_store::StudyFolder;
use judder_study::StudyError;
use judder_study::case::file::CaseFile;
use judder_study::run::{RunOptions, run};

/// Of a coarse block: on one side of every onset without a jump one mode more grows than on the other, by all modes of the band anew.
#[test]
fn onsets_stand_where_modes_begin_to_grow() {
    let coarse = "structure.block.block.cells=[6, 3]";
    let folder = tempfile::tempdir().unwrap();
    let results = run_into(folder.path(), &case("assembly/block-on-plane.toml", &[coarse]), &["friction"])
        .summary
        .results;
    let onsets = results["friction"]["onsets"].as_array().unwrap().clone();
    assert!(onsets.iter().any(|onset| onset["jumps"] == false), "{onsets:?}");
    for onset in onsets.iter().filter(|onset| onset["jumps"] == false) {
        let value = number(&onset["value"]);
        assert!(number(&onset["error"]) < 3e-9 * value, "{onset}");
        let growing = |friction: f64| {
            let folder = tempfile::tempdir().unwrap();
            let friction = format!("contact.sole.friction_coefficient={friction:?}");
            let options = [
                coarse,
                &friction,
                "analysis.modes={ name = \"modes\", kind = \"eigen\", band = [\"1 kHz\", \"60 kHz\"], damping = false }",
            ];
            let file = case("assembly/block-on-plane.toml", &options);
            number(&run_into(folder.path(), &file, &["modes"]).summary.results["modes"]["unstable"])
        };
        let change = growing(value + 1e-6) - growing(value - 1e-6);
        assert_eq!(change, if onset["gains"] == true { -1.0 } else { 1.0 }, "{onset}");
    }
}

/// Beyond cot 60° the strut has no steady sliding: between the last value that has and the first that has none nothing is known.
#[test]
fn onsets_beside_a_value_without_steady_sliding_are_in_doubt() {
    const SWEEP: &str = "\n[[analysis]]\nname = \"sweep\"\nkind = \"eigen-sweep\"\nband = [\"1 Hz\", \"10 kHz\"]\n\
        sweep = { key = \"contact.surface.friction_coefficient\", values = [0.3, 0.5, 0.7] }\n";
    let text = include_str!("../../../../cases/assembly/sprag-slip.toml").to_owned() + SWEEP;
    let folder = tempfile::tempdir().unwrap();
    let file = judder_models::parse("case.toml", &text, &[]).unwrap();
    let options = RunOptions { only: vec!["sweep".to_owned()], ..RunOptions::default() };
    let report = run(&file, folder.path(), &options, &judder_study::Silent).unwrap();
    let doubts = &report.summary.results["sweep"]["onsets_in_doubt"];
    let [doubt] = &doubts.as_array().unwrap()[..] else { panic!("{doubts}") };
    assert_eq!((number(&doubt["from"]), number(&doubt["to"])), (0.5, 0.7));
    assert_eq!(doubt["reason"], "there is no solution at the higher of them");
    let failure = &report.summary.results["sweep"]["failures"][0];
    assert!(
        failure["reason"]
            .as_str()
            .unwrap()
            .contains(", a coefficient of 0.57735, where the contact point of `surface`"),
        "{failure}"
    );
}

/// A mass on a belt whose friction rises to a speed and falls beyond, swept over these speeds.
fn on_a_cornered_belt(values: &str) -> CaseFile {
    let text = "model = \"assembly\"\n[[structure]]\nname = \"mass\"\n[structure.matrices]\nmass = [[1, 0], [0, 1]]\nstiffness = [[100, 0], [0, 100]]\n\
        freedoms = [[\"a\", \"x\"], [\"a\", \"y\"]]\n[[contact]]\nname = \"belt\"\nslider = { structure = \"mass\", set = \"a\" }\n\
        track = { plane = { normal = [0, 1] } }\nsliding = { velocity = \"1 m/s\", direction = [1, 0] }\n\
        friction_coefficient = { velocity = [\"0 m/s\", \"1.03 m/s\", \"2 m/s\"], coefficient = [0.3, 0.5, 0.3] }\n\
        [[load]]\nstructure = \"mass\"\nset = \"a\"\ndirection = \"y\"\nforce = \"-10 N\"\n\
        [[analysis]]\nname = \"sweep\"\nkind = \"eigen-sweep\"\nband = [\"1 Hz\", \"5 Hz\"]\n\
        sweep = { key = \"contact.belt.sliding.velocity\", values = [\"0.5 m/s\", \"1.5 m/s\"] }\n";
    let own = "values = [\"0.5 m/s\", \"1.5 m/s\"]";
    judder_models::parse("case.toml", &text.replace(own, &format!("values = {values}")), &[]).unwrap()
}

/// Growth jumps at the corner of the table, from −N μ′/2m to N μ′/2m, although the point stays closed.
#[test]
fn a_corner_of_a_friction_table_is_told_as_a_jump() {
    let folder = tempfile::tempdir().unwrap();
    let file = on_a_cornered_belt("[\"0.5 m/s\", \"1.5 m/s\"]");
    let results = run_into(folder.path(), &file, &["sweep"]).summary.results;
    let onsets = results["sweep"]["onsets"].as_array().unwrap();
    let [onset] = &onsets[..] else { panic!("{onsets:?}") };
    assert!((number(&onset["value"]) - 1.03).abs() < 1e-9, "{onset}");
    assert!(onset["jumps"] == true && onset["gains"] == false, "{onset}");
}

/// Results are in SI units; tables, figures and messages have values as the case has them.
#[test]
fn a_swept_key_is_shown_in_the_unit_of_the_case() {
    let folder = tempfile::tempdir().unwrap();
    let file = on_a_cornered_belt("[\"500 mm/s\", \"1500 mm/s\"]");
    let report = run_into(folder.path(), &file, &["sweep"]);
    let told = &report.summary.results["sweep"];
    assert!(told["unit"] == "m/s" && told["shown_unit"] == "mm/s" && number(&told["value"][1]) == 1.5);
    let dataset = StudyFolder::open(folder.path()).unwrap().read_dataset("sweep").unwrap();
    let model = judder_models::REGISTRY.model_of(&file.case.resolved()).unwrap();
    let panels = model.figure("sweep", "", &dataset).unwrap().unwrap().panels;
    let label = "contact.belt.sliding.velocity (mm/s)";
    let over_key = panels.iter().filter(|own| own.x.label == label);
    assert_eq!(
        over_key.clone().count(),
        3,
        "{:?}",
        panels.iter().map(|own| &own.x.label).collect::<Vec<_>>()
    );
    let page = std::fs::read_to_string(folder.path().join("report.html")).unwrap();
    assert!(page.contains("value (mm/s)") && page.contains(">1030</td>"));
    let drawn = std::fs::read_to_string(folder.path().join("figures/sweep.svg")).unwrap();
    assert!(drawn.contains("mm/s"));
}

/// Whether the run of an analysis that is stopped at a look ends so, how often it looked, and what steps are left.
fn stopped(file: &CaseFile, analysis: &str, at: usize) -> (bool, usize, usize) {
    let progress = Stopping::at(at);
    let folder = tempfile::tempdir().unwrap();
    let options = RunOptions { only: vec![analysis.to_owned()], ..RunOptions::default() };
    let stopped = matches!(run(file, folder.path(), &options, &progress), Err(StudyError::Interrupted));
    (stopped, progress.looks(), progress.steps())
}

/// Onsets are many solutions after the values of the sweep: a run is stopped among them too.
#[test]
fn a_search_for_onsets_can_be_stopped() {
    let file = case("assembly/block-on-plane.toml", &["structure.block.block.cells=[6, 3]"]);
    let (is_stopped, looks, left) = stopped(&file, "friction", usize::MAX);
    assert!(!is_stopped && left == 0, "{left}");
    let (is_stopped, _, left) = stopped(&file, "friction", 3 * looks / 4);
    assert!(is_stopped && left == 1, "{left}");
}

/// A map that is stopped has no points that are not known: it has none.
#[test]
fn a_map_can_be_stopped() {
    let text = include_str!("../../../../cases/assembly/mode-coupling.toml").to_owned()
        + "\n[[analysis]]\nname = \"map\"\nkind = \"stability-map\"\nregion = { re = [-3.0, 3.0], im = [0.1, 3.0] }\n\
           x = { key = \"contact.belt.friction_coefficient\", from = 0.5, to = 1.0, points = 4 }\n\
           y = { key = \"contact.belt.sliding.velocity\", values = [\"1 m/s\", \"2 m/s\"] }\n";
    let file = judder_models::parse("case.toml", &text, &[]).unwrap();
    let (is_stopped, looks, left) = stopped(&file, "map", usize::MAX);
    assert!(!is_stopped && left == 0 && looks > 10, "{left} {looks}");
    for at in [3, looks - 1] {
        assert!(stopped(&file, "map", at).0, "{at} of {looks}");
    }
}
