//! Every check of the shipped cases compares numbers: here those that take a second or two, in the other modules what they run themselves.

use crate::{case, run_into};
use judder_store::Summary;

/// The checks of a study that did not count a number.
pub(crate) fn without_numbers(summary: &Summary) -> Vec<String> {
    let kept = summary.extra["study"]["checks"].as_object().unwrap();
    let all = kept
        .iter()
        .flat_map(|(name, checks)| checks.as_array().unwrap().iter().map(move |check| (name, check)));
    all.filter(|(_, check)| check["numbers"].as_u64().is_none_or(|numbers| numbers == 0))
        .map(|(name, check)| format!("{name}: {}", check["name"]))
        .collect()
}

/// Cases and which of their analyses.
const CASES: [(&str, &[&str]); 13] = [
    ("beams-paper/oblique.toml", &[]),
    ("benchmarks/belt.toml", &["cycle", "motion"]),
    ("benchmarks/block.toml", &[]),
    ("benchmarks/damped-hopf.toml", &[]),
    ("benchmarks/minimal-mode-coupling.toml", &[]),
    ("benchmarks/ring.toml", &[]),
    ("oscillator-paper/fig-4.toml", &[]),
    ("oscillator-paper/fig-6.toml", &[]),
    ("oscillator-paper/fig-7.toml", &[]),
    ("oscillator-paper/fig-8.toml", &[]),
    ("oscillator-paper/fig-9a.toml", &[]),
    ("oscillator-paper/fig-12.toml", &[]),
    ("oscillator-paper/fig-13.toml", &[]),
];

/// That they do is asserted of every run.
#[test]
fn checks_of_shipped_cases_compare_numbers() {
    for (name, only) in CASES {
        let folder = tempfile::tempdir().unwrap();
        let report = run_into(folder.path(), &case(name, &[]), only);
        assert!(report.complete, "{name}: {:?}", report.messages);
        let checked = report.summary.extra["study"]["checks"].as_object().unwrap();
        assert!(name.contains("minimal") || checked.values().any(|checks| checks != &serde_json::json!([])));
    }
}
