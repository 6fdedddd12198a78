//! The scoreboard: every claim measured with every reading, and what becomes of it.

use super::claims::motion::{MOTION_CLAIMS, Motions, missing};
use super::claims::{CLAIMS, contact};
use super::evidence::Evidence;
use super::motion_exhibits::{OF_CAPTIONS, WAYS};
use super::readings::READINGS;
use crate::claim::{ClaimKind, ClaimLine, Measured, MeasuredClaim};
use judder_study::Progress;
use judder_study::StudyError;
use rayon::prelude::*;

/// Measures all claims: those of the sections with every reading, those about motions with every way to read section 5, then those
/// of the contact computation.
pub(super) fn measure(
    evidence: &Evidence,
    motions: &[Option<Motions>],
    progress: &dyn Progress,
) -> Result<Vec<ClaimLine>, StudyError> {
    let contacts: Vec<_> = READINGS.iter().map(|reading| reading.contact(&evidence.law)).collect();
    let lines: Result<Vec<ClaimLine>, StudyError> = CLAIMS
        .par_iter()
        .map(|claim| {
            if progress.interrupted() {
                return Err(StudyError::Interrupted);
            }
            let measured: Vec<Measured> = contacts.iter().map(claim.measure).collect();
            progress.advance();
            Ok(line(claim, measured, &OTHER_LAWS))
        })
        .collect();
    let mut lines = lines?;
    lines.extend(of_motions(motions));
    lines.extend(contact::lines(evidence));
    Ok(lines)
}

/// The laws beside the printed one, with the place of their first reading.
const OTHER_LAWS: [(usize, &str); 2] = [(2, "the corrected velocity axis"), (4, "the computed law")];
/// The speed beside the captions', likewise.
const OTHER_SPEEDS: [(usize, &str); 1] = [(OF_CAPTIONS, "the text's $v̂_{d}$ = 5 × 10^{−3}")];

/// The claims about motions, judged with the captions' speed.
pub(super) fn of_motions(motions: &[Option<Motions>]) -> Vec<ClaimLine> {
    let columns: Vec<String> = WAYS.iter().map(|way| way.plain.to_owned()).collect();
    let of = |claim: &MeasuredClaim<Motions>| {
        let measure = |found: &Option<Motions>| found.as_ref().map_or_else(missing, claim.measure);
        let measured = motions.iter().map(measure).collect();
        ClaimLine { columns: columns.clone(), ..line(claim, measured, &OTHER_SPEEDS) }
    };
    MOTION_CLAIMS.par_iter().map(of).collect()
}

/// A claim with what becomes of it: judged by the first two numbers, one for either friction load; `others` name further pairs.
fn line<T>(claim: &MeasuredClaim<T>, measured: Vec<Measured>, others: &[(usize, &'static str)]) -> ClaimLine {
    let holds: Vec<bool> = measured.iter().map(|m| m.holds).collect();
    let (verdict, with) = match (claim.kind, holds[0], holds[1]) {
        (ClaimKind::Misprint, true, true) => ("misprint", ""),
        (ClaimKind::Misprint, _, _) | (ClaimKind::Statement, false, false) => ("open", ""),
        (ClaimKind::Statement, true, true) => ("agrees", ""),
        (ClaimKind::Statement, true, false) => ("agrees", "Only with $F_{n} μ_{visc}$. "),
        (ClaimKind::Statement, false, true) => ("agrees", "Only with $F_{k} μ_{visc}$. "),
    };
    let named = |wanted: bool| -> Vec<&str> {
        let with = |first: usize| holds[first] || holds[first + 1];
        others.iter().filter(|(first, _)| with(*first) == wanted).map(|(_, name)| *name).collect()
    };
    let beside = match (claim.kind, verdict) {
        (ClaimKind::Statement, "agrees") => added(" Not so with ", &named(false), " or "),
        (ClaimKind::Statement, "open") => added(" It holds with ", &named(true), " and "),
        _ => String::new(),
    };
    ClaimLine {
        place: claim.place.to_owned(),
        says: claim.says.to_owned(),
        ours: measured.into_iter().map(|m| m.ours).collect(),
        verdict: verdict.to_owned(),
        why: format!("{with}{}{beside}", claim.why),
        holds,
        columns: Vec::new(),
    }
}

/// A sentence about some readings; nothing where there are none.
fn added(beginning: &str, laws: &[&str], between: &str) -> String {
    if laws.is_empty() { String::new() } else { format!("{beginning}{}.", laws.join(between)) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::oscillator::evidence::computed;
    use judder_study::Silent;

    /// The verdicts on section 5, from motions as a quick run makes them.
    #[test]
    #[ignore = "expensive: run by make validate"]
    fn the_verdicts_on_the_motions() {
        let folder = tempfile::tempdir().unwrap();
        let lines = crate::oscillator::quick_motions(folder.path()).unwrap();
        let judged: Vec<(&str, &str, &[bool])> = lines
            .iter()
            .map(|line| (line.place.as_str(), line.verdict.as_str(), &line.holds[..OF_CAPTIONS]))
            .collect();
        let expected: [(&str, &str, &[bool]); 11] = [
            ("Eq. (3), §5", "agrees", &[true, true]),
            ("§5", "agrees", &[true, true]),
            ("§5, Fig. 11", "agrees", &[false, true]),
            ("§5, Fig. 11", "agrees", &[true, true]),
            // with F_n μ_visc an irregular motion dies out on one of the two ways: rounding decides on which
            ("Fig. 11", "agrees", &[false, true]),
            ("§5, Fig. 11", "agrees", &[true, true]),
            ("§5, Fig. 12", "agrees", &[false, true]),
            ("§5, Fig. 12", "agrees", &[false, true]),
            ("§5, Fig. 12", "open", &[false, false]),
            ("§5, Fig. 12", "agrees", &[true, true]),
            ("§5, Fig. 12c", "agrees", &[true, true]),
        ];
        assert_eq!(judged, expected);
        // the captions' speed with the contact force is the paper's: no other way comes near it
        let count = |way: usize| lines.iter().filter(|line| line.holds[way]).count();
        assert_eq!(count(1), 10);
        assert!([0, 2, 3].into_iter().all(|way| count(way) < 8));
    }

    /// The verdicts as the book tells them, in the order of the paper.
    #[test]
    fn the_verdicts() {
        let mut lines = measure(&computed(), &[const { None }; 4], &Silent).unwrap();
        lines.truncate(CLAIMS.len());
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
