//! How far below a threshold a knock reaches: thresholds with their folds, maps with a third region.

use crate::{number, run_into};
use judder_case::CaseFile;
use serde_json::{Map, Value};

/// F̃_n = 1e-6: most Hopf points are subcritical.
const HEAD: &str = "model = \"oscillator\"\n[contact]\nfriction_load = \"contact-force\"\n[operation]\nnormal_load = 1e-6\n[[analysis]]\nname = \"a\"\n";

fn parsed(analysis: &str) -> CaseFile {
    CaseFile::parse("case.toml", &format!("{HEAD}{analysis}"), &[]).unwrap()
}

const THRESHOLDS: &str = "kind = \"critical-shear-strength\"\n\
    sweep = { key = \"operation.velocity\", from = 1e-3, to = 1e-2, points = 2, scale = \"log\" }\n\
    within = { from = 1e-3, to = 1e1 }";

fn entry<'a>(result: &'a Map<String, Value>, name: &str, value: usize) -> &'a Value {
    let list = result[name][value].as_array().unwrap();
    assert_eq!(list.len(), 1, "{name}");
    &list[0]
}

/// Our notes on the paper: 0.0549 with a fold at 0.0126, and 0.1040 with a fold at 0.0604; simulations change there.
#[test]
fn thresholds_carry_their_folds() {
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &parsed(THRESHOLDS), &[]);
    assert!(report.complete, "{:?}", report.messages);
    assert!(report.messages.iter().all(|message| !message.contains("check failed")), "{:?}", report.messages);
    let result = &report.summary.results["a"];
    for (k, (threshold, fold)) in [(0.0549, 0.0126), (0.1040, 0.0604)].into_iter().enumerate() {
        assert!((number(entry(result, "full", k)) - threshold).abs() < 1e-4);
        assert!((number(entry(result, "fold", k)) - fold).abs() < 1e-4);
        assert_eq!(entry(result, "criticality", k), "subcritical");
        assert_eq!(entry(result, "stable_side", k), "below");
        assert_eq!(entry(result, "branch_end", k), "fold");
        assert!(number(entry(result, "lyapunov_coefficient", k)) > 0.0);
        // the cycles live below
        assert!(number(entry(result, "amplitude_factor", k)) < 0.0);
        assert!(number(entry(result, "reaches", k)) <= number(entry(result, "fold", k)));
    }
    let table = std::fs::read_to_string(folder.path().join("a.csv")).unwrap();
    let head = "velocity,system,threshold,criticality,stable_side,lyapunov_coefficient,amplitude_factor,fold,reaches,branch_end";
    assert_eq!(table.lines().next().unwrap(), head);
    assert!(
        std::fs::read_to_string(folder.path().join("figures/a.svg")).unwrap().contains("fold of the cycles")
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

/// Points above, between and below threshold and fold at v̂ = 1e-2, on a map whose lines are all followed.
#[test]
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
    assert_eq!((&map["global_margin"]["branches"], number(&map["knock_unknown_fraction"])), (&3.into(), 0.0));
    // on each line so many of the 31 levels 10^(−3 + k/10) lie between fold and threshold: 0.0126..0.0549, 0.0524..0.0922, 0.0604..0.1040
    let levels = |from: f64, to: f64| {
        (0..31)
            .map(|k| 10_f64.powf(-3.0 + 0.1 * f64::from(k)))
            .filter(|level| (from..to).contains(level))
            .count()
    };
    let expected = levels(0.012_62, 0.054_90) + levels(0.052_44, 0.092_20) + levels(0.060_40, 0.103_99);
    assert_eq!((number(&map["knock_fraction"]) * 93.0).round() as usize, expected);
    let figure = std::fs::read_to_string(folder.path().join("figures/a.svg")).unwrap();
    assert!(figure.contains("stable, but a knock starts it") && figure.contains("a-knock"));
    assert!(figure.contains("stable, other cycles not sought"));
}

/// Along a key that is neither the shear strength nor the load, on a linear axis.
#[test]
fn a_map_follows_any_key() {
    let analysis = "kind = \"stability-map\"\nglobal_margin = true\nboundaries = false\n\
        x = { key = \"operation.velocity\", from = 5e-3, to = 1e-2, points = 2 }\n\
        y = { key = \"oscillator.coupling\", from = 0.5, to = 2.0, points = 16 }";
    let case = CaseFile::parse(
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
