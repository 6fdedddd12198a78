//! How probable conditions on the quantities of a sweep are.

use super::file;
use crate::{number, run_into};
use std::path::Path;

/// Modes of the minimal model couple above μ = 3/4, so that a quarter of what is evenly distributed between 0 and 1 does; the idle key has nothing to do with it.
#[test]
fn a_probability_is_that_of_the_known_share() {
    let text = std::fs::read_to_string(
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/benchmarks/minimal-mode-coupling.toml"),
    );
    let text = text
        .unwrap()
        .replace("[parameters]", "[parameters]\nidle = 1.0")
        .replace("4*mu/3", "4*mu/3 + 0*idle");
    let sweep = |more: &str| {
        format!(
            r#"{text}
[[sweep]]
name = "how-probable"
method = "sobol"
points = 512
over = [{{ key = "parameters.mu", from = 0.0, to = 1.0 }}, {{ key = "parameters.idle", from = 0.0, to = 1.0 }}]
quantities = ["growth_rate", "verdict"]
probabilities = [
  {{ quantity = "growth_rate", above = 1e-6 }},
  {{ quantity = "growth_rate", above = -1.0, below = 1e-6 }},
  {{ quantity = "verdict", is = "unstable" }},
]
{more}"#
        )
    };
    let told = |more: &str| {
        let file = judder_models::parse("how.toml", &sweep(more), &[]).unwrap();
        run_into(tempfile::tempdir().unwrap().path(), &file, &["how-probable"]).summary.results["how-probable"].clone()
    };
    let plain = told("");
    let listed = plain["probabilities"].as_array().unwrap();
    for (own, share) in listed.iter().zip([0.25, 0.75, 0.25]) {
        let [value, from, to] = ["value", "from", "to"].map(|key| number(&own[key]));
        assert!((value - share).abs() < 2e-3 && from <= share && share <= to, "{own}");
        assert!(own["count"] == 512 && own["unknown"] == 0, "{own}");
    }
    assert_eq!(listed[1]["condition"], "-1 < growth_rate < 1e-6");
    // of rows of sensitivity the independent points count, two of each; what holds is decided by μ alone
    let rows = told("sensitivity = true");
    let own = &rows["probabilities"][0];
    assert!(own["count"] == 1024 && (number(&own["value"]) - 0.25).abs() < 4e-3, "{own}");
    let indices = &rows["sensitivity"]["growth_rate > 1e-6"];
    assert!((number(&indices["first"]["parameters.mu"]["value"]) - 1.0).abs() < 0.05, "{indices}");
    assert!(number(&indices["total"]["parameters.idle"]["value"]) == 0.0, "{indices}");
}

/// Points without steady sliding may be anything: the interval reaches from none to all of them.
#[test]
fn what_is_not_known_of_a_point_widens_the_interval() {
    let sweep = r#"
[[sweep]]
name = "loads"
method = "sobol"
points = 64
over = [{ key = "operation.normal_load", from = 1e-4, to = 1e12, scale = "log" }]
quantities = ["growth_rate"]
probabilities = [{ quantity = "growth_rate", below = 1e9 }, { quantity = "growth_rate", above = 1e9 }]
"#;
    let report = run_into(tempfile::tempdir().unwrap().path(), &file(sweep), &[]);
    assert!(!report.complete);
    let told = &report.summary.results["loads"];
    let failed = number(&told["failed"]);
    assert!(failed > 0.0 && failed < 64.0, "{told:?}");
    for (own, share) in told["probabilities"].as_array().unwrap().iter().zip([1.0, 0.0]) {
        let [value, from, to] = ["value", "from", "to"].map(|key| number(&own[key]));
        assert!(number(&own["unknown"]) == failed && number(&own["count"]) == 64.0 - failed, "{own}");
        let [none, all] = [0.0, failed / 64.0].map(|unknown| share * (1.0 - failed / 64.0) + unknown);
        assert!(value == share && from <= none && all <= to + 1e-12 && to - from >= failed / 64.0, "{own}");
    }
}
