//! A sphere on rubber at the tip of a beam.

use crate::{case, number, run_into};

/// Eq. (3) is a matter of each mode, so maps and sweeps say at how many of their points it decides; a point of a map is the case of its values.
#[test]
fn maps_and_sweeps_say_where_modes_are_too_fast_for_the_law() {
    let folder = tempfile::tempdir().unwrap();
    let sets = [
        "analysis.map.x={ key = \"contact.tip.sliding.velocity\", values = [\"10 mm/s\", \"1 m/s\"] }",
        "analysis.map.y={ key = \"contact.tip.asperity.shear_strength\", values = [0.002, 0.2] }",
        "analysis.map.boundaries=false",
        "analysis.lock-in.sweep={ key = \"substrate.retardation_time\", values = [\"0.1 ms\", \"2 ms\"] }",
    ];
    let file = case("assembly/sphere-on-beam.toml", &sets);
    let report = run_into(folder.path(), &file, &["map", "lock-in", "modes"]);
    let results = &report.summary.results;
    assert_eq!(number(&results["map"]["unresolved"]), 0.0);
    assert_eq!(number(&results["map"]["unstable_fraction"]), 0.75);
    assert_eq!(number(&results["map"]["beyond_quasi_steady"]), 0.0);
    assert_eq!(results["lock-in"]["unit"], "s");
    // ω τ is 0.13 at 206 Hz and 0.1 ms, and twenty times that at 2 ms
    let of_sweep = report.messages.iter().find(|message| message.contains("at 1 of 2 values"));
    assert!(of_sweep.is_some_and(|message| message.contains("eq. (3)")), "{:?}", report.messages);
    let beyond = results["modes"]["beyond_quasi_steady"].as_array().unwrap();
    assert_eq!(beyond.iter().map(|told| number(&told["mode"])).collect::<Vec<_>>(), [3.0, 4.0, 5.0]);
}
