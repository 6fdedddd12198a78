//! What the summary of a reproduction says.

use crate::claim::ClaimLine;
use judder_store::{Status, Summary};
use judder_study::ledger::Keepsakes;

/// Where a summary keeps that it is a reproduction, and its scoreboard.
pub(crate) const KEY: &str = "reproduction";

/// How many claims and checks of a reproduction came out how, in a sentence each.
pub(crate) fn tally(lines: &[ClaimLine], kept: &Keepsakes) -> String {
    let count = |verdict: &str| lines.iter().filter(|line| line.verdict == verdict).count();
    let misprints = match count("misprint") {
        0 => String::new(),
        count => format!(" {count} are misprints whose right value is known,"),
    };
    let checks = kept.checks.values().flatten().count();
    let passed = kept.checks.values().flatten().filter(|check| check.passed()).count();
    format!(
        "Of {} claims {} agree,{misprints} {} are open. {passed} of {checks} checks are within their limits.",
        lines.len(),
        count("agrees"),
        count("open")
    )
}

/// Whether an analysis of a summary has its result.
pub(crate) fn is_done(summary: &Summary, name: &str) -> bool {
    summary.analyses.get(name).is_some_and(|record| record.status == Status::Done)
}
