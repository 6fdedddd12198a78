//! A claim of a paper, what it is measured on, and its line of the scoreboard.

use judder_report::page;
use serde::{Deserialize, Serialize};

/// What kind of line a claim is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum ClaimKind {
    /// It agrees where we find what the paper says.
    Statement,
    /// The print is wrong and the right value known; the measurement shows the right value.
    Misprint,
}

/// A claim of the paper, and what it is measured on.
pub(crate) struct MeasuredClaim<T> {
    pub(crate) place: &'static str,
    pub(crate) says: &'static str,
    pub(crate) kind: ClaimKind,
    pub(crate) measure: fn(&T) -> Measured,
    pub(crate) why: &'static str,
}

/// What we find with one reading.
pub(crate) struct Measured {
    /// Our number, in a few characters.
    pub(crate) ours: String,
    /// Whether it is what the paper says (for a misprint: what we say instead).
    pub(crate) holds: bool,
}

/// One line of the scoreboard.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct ClaimLine {
    /// Where it stands in the paper.
    pub place: String,
    /// What the paper says.
    pub says: String,
    /// What we find, with each reading.
    pub ours: Vec<String>,
    /// Whether each of them is what the paper says; empty where the line is judged as a whole.
    #[serde(default)]
    pub holds: Vec<bool>,
    /// Heads of our numbers, where they are not those of the other lines.
    #[serde(default)]
    pub columns: Vec<String>,
    /// `agrees`, `misprint` or `open`.
    pub verdict: String,
    /// Why, in one line.
    pub why: String,
}

pub(crate) const fn statement<T>(
    place: &'static str,
    says: &'static str,
    measure: fn(&T) -> Measured,
    why: &'static str,
) -> MeasuredClaim<T> {
    MeasuredClaim { place, says, kind: ClaimKind::Statement, measure, why }
}

pub(crate) const fn misprint<T>(
    place: &'static str,
    says: &'static str,
    measure: fn(&T) -> Measured,
    why: &'static str,
) -> MeasuredClaim<T> {
    MeasuredClaim { place, says, kind: ClaimKind::Misprint, measure, why }
}

pub(crate) fn measured(ours: impl Into<String>, holds: bool) -> Measured {
    Measured { ours: ours.into(), holds }
}

/// A number with three digits, in the markup of the page.
pub(crate) fn short(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    if (0.01..1000.0).contains(&value.abs()) {
        let digits = 2 - libm::log10(value.abs().max(1e-2)).floor() as i32;
        return format!("{value:.*}", digits.max(0) as usize).replace('-', "−");
    }
    let text = format!("{value:.2e}");
    match text.split_once('e') {
        Some((mantissa, exponent)) => format!("{mantissa} × 10^{{{exponent}}}").replace('-', "−"),
        None => text,
    }
}

/// Some lines of the scoreboard as a block of the page, with these readings and their heads, of which the verdict is about the first.
pub(crate) fn block(lines: &[ClaimLine], columns: &[(usize, &str)], judged: usize) -> page::Scoreboard {
    let verdict = |word: &str| match word {
        "agrees" => page::ClaimVerdict::Agrees,
        "misprint" => page::ClaimVerdict::Misprint,
        _ => page::ClaimVerdict::Open,
    };
    let rows = lines.iter().map(|line| page::Claim {
        place: line.place.clone(),
        says: line.says.clone(),
        ours: columns.iter().map(|(k, _)| line.ours.get(*k).cloned().unwrap_or_default()).collect(),
        verdict: verdict(&line.verdict),
        why: line.why.clone(),
    });
    page::Scoreboard {
        ours: columns.iter().map(|(_, head)| (*head).to_owned()).collect(),
        judged,
        rows: rows.collect(),
    }
}
