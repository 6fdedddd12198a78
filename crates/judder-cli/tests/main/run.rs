//! `judder run` and `judder report`: what they leave, what they do again.

use std::fs;

use serde_json::Value;

use crate::desk::{CASE, Desk, files_below};

const ANALYSES: [&str; 5] = ["map", "loci", "damping", "strengths", "loads"];

#[test]
fn a_study_is_whole() {
    let desk = Desk::with_case(CASE);
    desk.succeed(&["run", "case.toml"]).says("report: out/case/report.html");
    for file in ["summary.json", "results.zarr/zarr.json", "report.html", "strengths.csv", "damping.csv"] {
        assert!(desk.path(&format!("out/case/{file}")).is_file(), "{file}");
    }
    for name in ANALYSES {
        for ending in ["svg", "png"] {
            assert!(desk.path(&format!("out/case/figures/{name}.{ending}")).is_file(), "{name}.{ending}");
        }
        assert!(desk.path(&format!("out/case/results.zarr/{name}/zarr.json")).is_file(), "{name}");
    }
}

#[test]
fn what_is_not_drawn_is_drawn_later() {
    let desk = Desk::with_case(CASE);
    desk.succeed(&["run", "case.toml", "--only", "damping", "--no-report"]);
    assert!(desk.path("out/case/damping.csv").is_file());
    let drawn = ["report.html", "figures"].map(|name| desk.path(&format!("out/case/{name}")));
    assert!(drawn.iter().all(|path| !path.exists()));
    desk.succeed(&["verify", "out/case"]);
    desk.succeed(&["report", "out/case"]);
    assert!(drawn.iter().all(|path| path.exists()));
}

#[test]
fn the_summary_has_its_keys() {
    let desk = Desk::with_case(CASE);
    let summary = desk.succeed(&["run", "case.toml", "--json"]).json();
    assert!(summary["case_hash"].is_string() && summary["version"].is_string());
    assert!(summary["wall_time_s"].as_f64().unwrap() > 0.0);
    let results = &summary["results"];
    assert_eq!(results.as_object().unwrap().len(), ANALYSES.len());
    let map = &results["map"];
    // every point that the adaptive method decided, at most all
    assert!((1..=24 * 20).contains(&map["points"].as_u64().unwrap()), "{map}");
    assert!((0.0..=1.0).contains(&map["unstable_fraction"].as_f64().unwrap()));
    assert_eq!(map["unresolved"], 0);
    assert!(map["seconds"].is_f64());
    for name in ["strengths", "loads"] {
        let critical = &results[name];
        assert_eq!(critical["value"].as_array().unwrap().len(), 5, "{name}");
        for roots in ["full", "conservative"] {
            let lists = critical[roots].as_array().unwrap();
            assert_eq!(lists.len(), 5, "{name}.{roots}");
            let ascending = |list: &Value| list.as_array().unwrap().is_sorted_by_key(Value::as_f64);
            assert!(lists.iter().all(ascending), "{name}.{roots}");
        }
    }
}

#[test]
#[ignore = "expensive: run by make validate"]
fn thresholds_carry_what_grows_from_them() {
    let speeds = ("from = 1e-5, to = 1e-2, points = 5", "from = 1e-3, to = 1e-2, points = 2");
    let followed = CASE.replace("global_margin = false", "").replace(speeds.0, speeds.1);
    let desk = Desk::with_case(&followed);
    let summary = desk.succeed(&["run", "case.toml", "--json", "--only", "strengths"]).json();
    let strengths = &summary["results"]["strengths"];
    let lengths = |name: &str| -> Vec<usize> {
        strengths[name].as_array().unwrap().iter().map(|list| list.as_array().unwrap().len()).collect()
    };
    for name in [
        "criticality",
        "stable_side",
        "amplitude_factor",
        "lyapunov_coefficient",
        "fold",
        "branch_fold",
        "reaches",
        "moving_share",
        "branch_end",
        "told",
        "search",
        "basin",
    ] {
        assert_eq!(lengths(name), lengths("full"), "{name}");
    }
    // a fold lies on the stable side, or there is none
    for (threshold, (side, fold)) in entries(strengths, "full")
        .into_iter()
        .zip(entries(strengths, "stable_side").into_iter().zip(entries(strengths, "fold")))
    {
        let Some(fold) = fold.as_f64() else { continue };
        assert_eq!(fold > threshold.as_f64().unwrap(), side == "above");
    }
}

fn entries(result: &Value, name: &str) -> Vec<Value> {
    let lists = result[name].as_array().unwrap();
    lists.iter().flat_map(|list| list.as_array().unwrap().clone()).collect()
}

#[test]
fn a_rerun_does_only_what_has_changed() {
    let desk = Desk::with_case(CASE);
    desk.succeed(&["run", "case.toml"]);
    let all = format!("done before: {}\n", ANALYSES.join(", "));
    desk.succeed(&["run", "case.toml"]).says(&all);

    // another range of one analysis concerns no other
    desk.write("case.toml", CASE.replace("points = 11", "points = 12"));
    let said = desk.succeed(&["run", "case.toml", "-v"]);
    said.says("loci: 12 of 12 steps");
    said.says("forgotten, since what they depend on has changed: loci\n");
    said.says("done before: map, damping, strengths, loads\n");

    // another load concerns all
    let said = desk.succeed(&["run", "case.toml", "-v", "--set", "operation.normal_load=2e-6"]);
    said.says("forgotten, since what they depend on has changed: damping, loads, loci, map, strengths\n");
    assert!(!said.stderr.contains("done before"), "{}", said.stderr);
    assert_eq!(
        desk.read_json("out/case/summary.json")["study"]["overrides"][0],
        "operation.normal_load=2e-6"
    );
}

/// What is left of an analysis that was taken out of the case is named by the run and by `verify`, is no damage, and goes with `--fresh`.
#[test]
fn files_of_an_earlier_case_are_named() {
    let desk = Desk::with_case(CASE);
    let run = |more: &[&str]| {
        desk.succeed(&[&["run", "case.toml", "--only", "loci", "--only", "loads"], more].concat())
    };
    run(&[]);
    let before = desk.succeed(&["verify", "out/case", "--json"]).json();
    assert_eq!(before["findings"], serde_json::json!([]));
    desk.write("case.toml", CASE.replace("\"loads\"", "\"others\""));
    let said = desk.succeed(&["run", "case.toml", "--only", "loci"]);
    said.says(
        "forgotten, since the case no longer has them: loads; their files stay until `judder run --fresh`",
    );
    said.says("done before: loci\n");
    let found = desk.succeed(&["verify", "out/case", "--json"]).json();
    let findings = found["findings"].as_array().unwrap();
    // its figure has gone: the report draws anew what there is
    let is_left = |finding: &Value| finding["kind"] == "extra" && finding["of"] == "loads";
    assert!(findings.iter().all(is_left) && !desk.path("out/case/figures/loads.svg").exists(), "{found}");
    for path in ["loads.csv", "results.zarr/loads/zarr.json"] {
        assert!(findings.iter().any(|finding| finding["path"] == path), "{path}: {found}");
    }
    let reason = findings.iter().find(|finding| is_left(finding)).unwrap()["reason"].as_str().unwrap();
    assert!(reason.contains("it is of loads of an earlier case"), "{found}");
    // it may be removed, or be anything
    std::fs::remove_file(desk.path("out/case/loads.csv")).unwrap();
    let left = desk.succeed(&["verify", "out/case", "--json"]).json();
    assert_eq!(left["findings"].as_array().unwrap().len(), findings.len() - 1);
    desk.succeed(&["run", "case.toml", "--only", "loci", "--fresh"]);
    assert_eq!(desk.succeed(&["verify", "out/case", "--json"]).json()["findings"], before["findings"]);
    assert!(!desk.path("out/case/results.zarr/loads").exists());
}

#[test]
fn only_and_fresh() {
    let desk = Desk::with_case(CASE);
    let run = |more: &[&str]| {
        let said = desk.succeed(&[&["run", "case.toml", "--json", "-v"], more].concat());
        let names: Vec<_> = said.json()["results"].as_object().unwrap().keys().cloned().collect();
        (names, said)
    };
    assert_eq!(run(&["--only", "loci"]).0, ["loci"]);
    let (names, said) = run(&["--only", "loads", "--only", "loci"]);
    assert_eq!(names, ["loads", "loci"]);
    said.says("done before: loci\n");
    let (names, said) = run(&["--fresh", "--only", "loads"]);
    assert_eq!(names, ["loads"], "all else is forgotten");
    assert!(!said.stderr.contains("done before"), "{}", said.stderr);
    assert_eq!(run(&[]).0.len(), ANALYSES.len());
}

#[test]
fn the_folder_can_be_named() {
    let desk = Desk::with_case(CASE);
    desk.succeed(&["run", "case.toml", "-o", "deep/down"]);
    assert!(desk.path("deep/down/report.html").is_file() && !desk.path("out").exists());
}

/// Sets the wall times of a summary, which no two runs share, to zero.
fn forget_times(value: &mut Value) {
    match value {
        Value::Object(object) => {
            for (key, value) in object {
                if key == "seconds" || key == "wall_time_s" {
                    *value = Value::from(0.0);
                } else {
                    forget_times(value);
                }
            }
        }
        Value::Array(list) => list.iter_mut().for_each(forget_times),
        _ => (),
    }
}

#[test]
fn the_number_of_threads_does_not_show() {
    let desk = Desk::with_case(CASE);
    let [one, two] = ["1", "2"].map(|threads| {
        desk.succeed(&["run", "case.toml", "-o", threads, "--threads", threads]);
        let mut summary = desk.read_json(&format!("{threads}/summary.json"));
        forget_times(&mut summary);
        let arrays = desk.path(&format!("{threads}/results.zarr"));
        let files = files_below(&arrays).into_iter().filter(|path| path.is_file());
        let contents: Vec<_> = files
            .map(|path| (path.strip_prefix(&arrays).unwrap().to_owned(), fs::read(&path).unwrap()))
            .collect();
        (summary, contents)
    });
    assert!(one.1.len() > ANALYSES.len());
    assert_eq!(one.0, two.0, "summary.json");
    for (first, second) in one.1.iter().zip(&two.1) {
        assert!(first == second, "{} and {} differ", first.0.display(), second.0.display());
    }
    assert_eq!(one.1.len(), two.1.len());
}

#[test]
fn the_report_is_rebuilt() {
    let desk = Desk::with_case(CASE);
    desk.succeed(&["run", "case.toml"]);
    let page = fs::read(desk.path("out/case/report.html")).unwrap();
    for file in ["report.html", "figures/map.svg"] {
        fs::remove_file(desk.path(&format!("out/case/{file}"))).unwrap();
    }
    desk.succeed(&["report", "out/case"]).says("report: out/case/report.html");
    assert!(desk.path("out/case/figures/map.svg").is_file());
    assert!(fs::read(desk.path("out/case/report.html")).unwrap() == page, "the same page as before");
}

#[test]
fn two_degrees_run_as_well() {
    let desk = Desk::with_case(
        "model = \"two-degrees\"\n[parameters]\nmu = 0.5\n[matrices]\nstiffness = [[2, \"1 - 4*mu/3\"], [1, 2]]\n\
         [[analysis]]\nname = \"onset\"\nkind = \"critical\"\n\
         sweep = { key = \"parameters.mu\", from = 0, to = 1.5 }\n",
    );
    let summary = desk.succeed(&["run", "case.toml", "--json"]).json();
    let onset = summary["results"]["onset"].to_string();
    assert!(onset.contains("0.75") || onset.contains("0.7499999"), "{onset}");
}

#[test]
fn a_missing_result_shows_in_the_exit_code() {
    // the square root has no value at two of the five points
    let desk = Desk::with_case(
        "model = \"two-degrees\"\n[parameters]\nmu = 0.5\n[matrices]\nstiffness = [[2, 0], [0, \"sqrt(mu)\"]]\n\
         [[analysis]]\nname = \"locus\"\nkind = \"spectrum\"\n\
         sweep = { key = \"parameters.mu\", from = -1, to = 1, points = 5 }\n",
    );
    let said = desk.judder(&["run", "case.toml", "--json", "-q"]);
    assert_eq!(said.code, 1);
    said.says("× a requested result is missing: locus: 2 of its results are missing: ");
    let mut told = said.json();
    let lacking = told.as_object_mut().unwrap().remove("lacking").unwrap();
    assert!(lacking[0].as_str().unwrap().starts_with("locus: 2 of its results are missing: "), "{lacking}");
    assert_eq!(told, desk.read_json("out/case/summary.json"));
    assert!(desk.path("out/case/report.html").is_file());
}

#[test]
fn a_case_without_analyses_is_a_page() {
    let desk = Desk::with_case("model = \"oscillator\"\n");
    let summary = desk.succeed(&["run", "case.toml", "--json"]).json();
    assert_eq!(summary["results"], serde_json::json!({}));
}
