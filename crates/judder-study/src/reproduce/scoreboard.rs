//! The scoreboard: every claim measured with every reading, and what becomes of it.

use super::claims::{CLAIMS, Claim, Kind};
use super::readings::READINGS;
use crate::error::StudyError;
use crate::progress::Progress;
use judder_report::page;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

/// What we find with one reading.
pub(super) struct Measured {
    /// Our number, in a few characters.
    pub(super) ours: String,
    /// Whether it is what the paper says (for a misprint: what we say instead).
    pub(super) holds: bool,
}

/// One line of the scoreboard.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ClaimLine {
    /// Where it stands in the paper.
    pub place: String,
    /// What the paper says.
    pub says: String,
    /// What we find, with each reading.
    pub ours: Vec<String>,
    /// `agrees`, `misprint` or `open`.
    pub verdict: String,
    /// Why, in one line.
    pub why: String,
}

/// Measures all claims.
pub(super) fn measure(progress: &dyn Progress) -> Result<Vec<ClaimLine>, StudyError> {
    let contacts: Vec<_> = READINGS.iter().map(super::readings::Reading::contact).collect();
    CLAIMS
        .par_iter()
        .map(|claim| {
            if progress.interrupted() {
                return Err(StudyError::Interrupted);
            }
            let measured: Vec<Measured> = contacts.iter().map(claim.measure).collect();
            progress.advance();
            Ok(line(claim, measured))
        })
        .collect()
}

fn line(claim: &Claim, measured: Vec<Measured>) -> ClaimLine {
    let holds: Vec<bool> = measured.iter().map(|m| m.holds).collect();
    let (verdict, with) = match (claim.kind, holds[0], holds[1]) {
        (Kind::Misprint, true, true) => ("misprint", ""),
        (Kind::Misprint, _, _) | (Kind::Statement, false, false) => ("open", ""),
        (Kind::Statement, true, true) => ("agrees", ""),
        (Kind::Statement, true, false) => ("agrees", "Only with $F_{n} μ_{visc}$. "),
        (Kind::Statement, false, true) => ("agrees", "Only with $F_{k} μ_{visc}$. "),
    };
    let corrected = match (claim.kind, verdict, holds[2], holds[3]) {
        (Kind::Statement, "agrees", false, false) => " Not so with the corrected velocity axis.",
        (Kind::Statement, "open", true, _) | (Kind::Statement, "open", _, true) => {
            " It holds with the corrected velocity axis."
        }
        _ => "",
    };
    ClaimLine {
        place: claim.place.to_owned(),
        says: claim.says.to_owned(),
        ours: measured.into_iter().map(|m| m.ours).collect(),
        verdict: verdict.to_owned(),
        why: format!("{with}{}{corrected}", claim.why),
    }
}

/// The scoreboard as a block of the page.
pub(super) fn block(lines: &[ClaimLine]) -> page::Scoreboard {
    let verdict = |word: &str| match word {
        "agrees" => page::Verdict::Agrees,
        "misprint" => page::Verdict::Misprint,
        _ => page::Verdict::Open,
    };
    let rows = lines.iter().map(|line| page::Claim {
        place: line.place.clone(),
        says: line.says.clone(),
        ours: line.ours.clone(),
        verdict: verdict(&line.verdict),
        why: line.why.clone(),
    });
    page::Scoreboard { ours: READINGS.iter().map(|r| r.label.to_owned()).collect(), rows: rows.collect() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::progress::Silent;

    /// The verdicts as the book tells them, in the order of the paper.
    #[test]
    fn the_verdicts() {
        let lines = measure(&Silent).unwrap();
        let odd: Vec<(&str, &str)> = lines
            .iter()
            .filter(|line| line.verdict != "agrees")
            .map(|line| (line.place.as_str(), line.verdict.as_str()))
            .collect();
        let expected = [
            ("§2.1, Fig. 3a", "open"),
            ("Eq. (12)", "misprint"),
            ("Eq. (16)", "misprint"),
            ("Eq. (17)", "misprint"),
            ("§4.1", "misprint"),
            ("Eq. (24), §4.2", "misprint"),
            ("§4.2, Fig. 6", "misprint"),
            ("Eqs. (27), (28)", "misprint"),
            ("§4.3, Fig. 9a", "open"),
            ("§4.3, Fig. 9b", "open"),
            ("§4.3", "misprint"),
            ("§5", "misprint"),
        ];
        assert_eq!(odd, expected);
        let only_contact_force = lines.iter().filter(|line| line.why.starts_with("Only with $F_{k}")).count();
        assert_eq!(only_contact_force, 2, "the sign change of Fig. 4 and the threshold of section 5");
    }
}
