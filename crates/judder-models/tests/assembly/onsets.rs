//! Where along a key modes of assemblies begin to grow.

use crate::stopping::Stopping;
use crate::{case, number, run_into};
use judder_study::StudyError;
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
    let sweep = "analysis.sweep={ name = \"sweep\", kind = \"eigen-sweep\", band = [\"1 Hz\", \"10 kHz\"], \
        sweep = { key = \"contact.surface.friction_coefficient\", values = [0.3, 0.5, 0.7] } }";
    let folder = tempfile::tempdir().unwrap();
    let options = RunOptions { only: vec!["sweep".to_owned()], ..RunOptions::default() };
    let file = case("assembly/sprag-slip.toml", &[sweep]);
    let report = run(&file, folder.path(), &options, &judder_study::Silent).unwrap();
    let doubts = &report.summary.results["sweep"]["onsets_in_doubt"];
    let [doubt] = &doubts.as_array().unwrap()[..] else { panic!("{doubts}") };
    assert_eq!((number(&doubt["from"]), number(&doubt["to"])), (0.5, 0.7));
    assert_eq!(doubt["reason"], "nothing is known at 0.7");
}

/// Onsets are many solutions after the values of the sweep: a run is stopped among them too.
#[test]
fn a_search_for_onsets_can_be_stopped() {
    let file = case("assembly/block-on-plane.toml", &["structure.block.block.cells=[6, 3]"]);
    let until = |at: usize| {
        let progress = Stopping::at(at);
        let folder = tempfile::tempdir().unwrap();
        let options = RunOptions { only: vec!["friction".to_owned()], ..RunOptions::default() };
        let stopped = matches!(run(&file, folder.path(), &options, &progress), Err(StudyError::Interrupted));
        (stopped, progress.looks(), progress.steps())
    };
    let (stopped, looks, left) = until(usize::MAX);
    assert!(!stopped && left == 0, "{left}");
    let (stopped, _, left) = until(looks - 2);
    assert!(stopped && left == 0, "{left} values of the sweep were left");
}
