//! How far below a threshold a knock reaches: thresholds with their folds, maps with a third region.

use crate::stopping::Stopping;
use crate::{number, run_into};
use judder_store::{StudyFolder, VariableValues};
use judder_study::StudyError;
use judder_study::case::file::CaseFile;
use judder_study::run::{RunOptions, run};
use serde_json::{Map, Value};
use std::path::Path;

/// F̃_n = 1e-6: most Hopf points are subcritical.
const HEAD: &str = "model = \"oscillator\"\n[contact]\nfriction_load = \"contact-force\"\n[operation]\nnormal_load = 1e-6\n[[analysis]]\nname = \"a\"\n";

fn parsed(analysis: &str) -> CaseFile {
    judder_models::parse("case.toml", &format!("{HEAD}{analysis}"), &[]).unwrap()
}

const THRESHOLDS: &str = "kind = \"critical-shear-strength\"\n\
    sweep = { key = \"operation.velocity\", from = 1e-3, to = 1e-2, points = 2, scale = \"log\" }\n\
    within = { from = 1e-3, to = 1e1 }";

fn entry<'a>(result: &'a Map<String, Value>, name: &str, value: usize) -> &'a Value {
    let list = result[name][value].as_array().unwrap();
    assert_eq!(list.len(), 1, "{name}");
    &list[0]
}

/// Our notes on the paper: 0.0549 and 0.1040, with turns of their own branches at 0.0126 and 0.0604; simulations change there. Below both
/// other motions live: at v̂ = 1e-3 a bounce down to the end of the range, at 1e-2 cycles of two oscillations.
#[test]
fn thresholds_carry_their_folds() {
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &parsed(THRESHOLDS), &[]);
    assert!(report.complete, "{:?}", report.messages);
    assert!(report.messages.iter().all(|message| !message.contains("check failed")), "{:?}", report.messages);
    let result = &report.summary.results["a"];
    for (k, (threshold, fold)) in [(0.0549, 0.0126), (0.1040, 0.0604)].into_iter().enumerate() {
        assert!((number(entry(result, "full", k)) - threshold).abs() < 1e-4);
        assert!((number(entry(result, "branch_fold", k)) - fold).abs() < 1e-4);
        assert_eq!(entry(result, "criticality", k), "subcritical");
        assert_eq!(entry(result, "stable_side", k), "below");
        assert_eq!(entry(result, "branch_end", k), "fold");
        assert!(number(entry(result, "lyapunov_coefficient", k)) > 0.0);
        // the cycles live below
        assert!(number(entry(result, "amplitude_factor", k)) < 0.0);
        assert!(number(entry(result, "reaches", k)) < fold);
        let basin = entry(result, "basin", k);
        assert!(basin["moving"].as_u64() > Some(0) && basin["undecided"] == 0, "{basin}");
        let share = number(entry(result, "moving_share", k));
        assert!((share * number(&basin["starts"]) - number(&basin["moving"])).abs() < 1e-9);
    }
    assert_eq!(entry(result, "fold", 0), &Value::Null);
    assert_eq!(number(entry(result, "reaches", 0)), 1e-3);
    assert_eq!(entry(result, "told", 0), "the range ends beyond");
    let fold = number(entry(result, "fold", 1));
    assert!((fold - 0.018_57).abs() < 5e-5, "{fold}");
    assert_eq!(entry(result, "told", 1), "no start moved beyond");
    let search = entry(result, "search", 1);
    assert_eq!((search["places"].as_array().unwrap().len(), &search["undecided"]), (4, &0.into()));
    let table = std::fs::read_to_string(folder.path().join("a.csv")).unwrap();
    let head = "velocity,system,threshold,criticality,stable_side,lyapunov_coefficient,amplitude_factor,fold,branch_fold,reaches,moving_share,branch_end,told";
    assert_eq!(table.lines().next().unwrap(), head);
    assert!(
        std::fs::read_to_string(folder.path().join("figures/a.svg")).unwrap().contains("least known fold")
    );
    assert!(
        std::fs::read_to_string(report.report.as_ref().unwrap())
            .unwrap()
            .contains("motions from large cycles end at the folds")
    );
}

#[test]
fn without_margins_what_grows_is_told_all_the_same() {
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &parsed(&format!("{THRESHOLDS}\nglobal_margin = false")), &[]);
    let result = &report.summary.results["a"];
    assert_eq!(entry(result, "criticality", 0), "subcritical");
    assert!(result.get("fold").is_none() && result.get("branch_end").is_none());
}

#[test]
#[ignore = "expensive: run by make validate"]
fn margins_do_not_depend_on_the_number_of_threads() {
    let results = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let folder = tempfile::tempdir().unwrap();
        pool.install(|| run_into(folder.path(), &parsed(THRESHOLDS), &[]).summary.results)
    };
    assert_eq!(results(1), results(3));
}

/// Seen from the load: between the two thresholds of F̃_n at τ̃0 = 0.05, v̂ = 1e-2 steady sliding is unstable, and cycles live on both
/// sides.
#[test]
#[ignore = "expensive: run by make validate"]
fn loads_have_margins_on_both_sides() {
    let analysis = "kind = \"critical-load\"\nwithin = { from = 1e-9, to = 1e-3 }\n\
                    sweep = { key = \"operation.velocity\", from = 1e-2, to = 2e-2, points = 2 }";
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &parsed(analysis), &[]);
    let result = &report.summary.results["a"];
    let numbers =
        |name: &str| -> Vec<f64> { result[name][0].as_array().unwrap().iter().map(number).collect() };
    let (full, fold) = (numbers("full"), numbers("fold"));
    assert_eq!(full.len(), 2);
    assert!(result["stable_side"][0].as_array().unwrap().iter().eq(["above", "below"].iter()));
    assert!(full[0] < fold[0] && fold[1] < full[1], "{full:?} {fold:?}");
}

/// The codes of an array of an analysis.
fn codes(folder: &Path, name: &str) -> Vec<u8> {
    let dataset = StudyFolder::open(folder).unwrap().read_dataset("a").unwrap();
    match &dataset.variable(name).unwrap().data {
        VariableValues::U8(codes) => codes.clone(),
        _ => Vec::new(),
    }
}

/// Points above, between and below threshold and fold at v̂ = 1e-2, on a map whose lines are all followed.
#[test]
#[ignore = "expensive: run by make validate"]
fn a_map_has_a_third_region() {
    let analysis = "kind = \"stability-map\"\nglobal_margin = true\nboundaries = false\n\
        x = { key = \"operation.velocity\", from = 1e-3, to = 1e-2, points = 3, scale = \"log\" }\n\
        y = { key = \"contact.shear_strength\", from = 1e-3, to = 1.0, points = 31, scale = \"log\" }";
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &parsed(analysis), &[]);
    assert!(report.complete, "{:?}", report.messages);
    let map = &report.summary.results["a"];
    assert_eq!(map["global_margin"]["along"], "contact.shear_strength");
    assert_eq!(map["global_margin"]["lines_followed"], 3);
    let margin = &map["global_margin"];
    assert_eq!(
        (&margin["branches"], &margin["searches"], &margin["searches_not_closed"]),
        (&3.into(), &3.into(), &0.into())
    );
    let knock = codes(folder.path(), "knock");
    let at = |line: usize, level: f64| knock[(10.0 * (level.log10() + 3.0)).round() as usize * 3 + line];
    // unstable, between fold and threshold, and at v̂ = 1e-2 beyond the fold at 0.01897 down to 0.3 of it
    let unstable = 10_f64.powf(-0.5);
    assert_eq!([at(0, unstable), at(2, unstable)], [0, 0]);
    for (line, level, code) in
        [(0, 0.02, 1), (2, 0.08, 1), (2, 0.02, 1), (2, 0.0158, 3), (2, 0.0063, 3), (2, 0.001, 2)]
    {
        assert_eq!(at(line, level), code, "{line} {level}");
    }
    // a bounce is known at v̂ = 1e-3 below a gap in which none is
    assert_eq!(at(0, 0.008), 2);
    let share = |code: u8| knock.iter().filter(|knock| **knock == code).count() as f64 / 93.0;
    assert_eq!(
        [number(&map["knock_fraction"]), number(&map["knock_unknown_fraction"])],
        [share(1), share(2)]
    );
    let figure = std::fs::read_to_string(folder.path().join("figures/a.svg")).unwrap();
    for said in ["stable, but a knock starts it", "a-knock", "no start of a search moved"] {
        assert!(figure.contains(said), "{said}");
    }
}

/// Along a key that is neither the shear strength nor the load, on a linear axis.
#[test]
fn a_map_follows_any_key() {
    let analysis = "kind = \"stability-map\"\nglobal_margin = true\nboundaries = false\n\
        x = { key = \"operation.velocity\", from = 5e-3, to = 1e-2, points = 2 }\n\
        y = { key = \"oscillator.coupling\", from = 0.5, to = 2.0, points = 16 }";
    let case = judder_models::parse(
        "case.toml",
        &format!("{HEAD}{analysis}"),
        &["contact.shear_strength=0.1".to_owned()],
    );
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &case.unwrap(), &[]);
    let map = &report.summary.results["a"];
    assert_eq!(map["global_margin"]["along"], "oscillator.coupling");
    assert!(number(&map["global_margin"]["branches"]) > 0.0, "{map:?}");
    assert!(number(&map["knock_fraction"]) + number(&map["knock_unknown_fraction"]) > 0.0, "{map:?}");
}

/// The lines of a map along which branches were followed are known to the run that goes on.
#[test]
fn an_interrupted_map_goes_on_from_its_lines() {
    let analysis = "kind = \"stability-map\"\nglobal_margin = true\nboundaries = false\n\
        x = { key = \"operation.velocity\", from = 5e-3, to = 1e-2, points = 2 }\n\
        y = { key = \"oscillator.coupling\", from = 0.5, to = 2.0, points = 16 }";
    let text = format!("{HEAD}{analysis}");
    let case = judder_models::parse("case.toml", &text, &["contact.shear_strength=0.1".to_owned()]).unwrap();
    let (whole, study) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    let patient = Stopping::at(usize::MAX);
    let mut at_once = run(&case, whole.path(), &RunOptions::default(), &patient).unwrap();
    let stopped = run(&case, study.path(), &RunOptions::default(), &Stopping::at(9 * patient.looks() / 10));
    assert!(matches!(stopped, Err(StudyError::Interrupted)), "{stopped:?}");
    let lines = std::fs::read_to_string(study.path().join(".scratch-of-a")).unwrap().lines().count();
    assert!((2..=3).contains(&lines), "{lines}: the hash, then a line each");
    let resumed = Stopping::at(usize::MAX);
    let mut report = run(&case, study.path(), &RunOptions::default(), &resumed).unwrap();
    assert!(resumed.looks() < patient.looks(), "{} {}", resumed.looks(), patient.looks());
    for report in [&mut at_once, &mut report] {
        report.summary.results.get_mut("a").unwrap().remove("seconds");
    }
    assert_eq!(report.summary.results, at_once.summary.results);
    assert_eq!(codes(study.path(), "knock"), codes(whole.path(), "knock"));
}
