//! The table of `judder reproduce`: what the paper says, what we find, the verdict.

use std::collections::BTreeMap;

use comfy_table::{ContentArrangement, Table, presets};
use judder_papers::{ClaimLine, Reproduction, plain};

/// A verdict that needs no further word.
const AGREES: &str = "agrees";

/// The scoreboard as text of at most `width` columns: the table, then why for each claim that does not simply agree.
pub(crate) fn text(reproduction: &Reproduction, width: u16) -> String {
    let mut table = Table::new();
    table.load_preset(presets::UTF8_HORIZONTAL_ONLY);
    table.set_content_arrangement(ContentArrangement::Dynamic).set_width(width);
    table.set_header(["where", "the paper says", "we find", "verdict"]);
    let claims = &reproduction.scoreboard;
    for claim in claims {
        let finding = findings(reproduction.columns_of(claim), &claim.ours).join("\n");
        table.add_row([&claim.place, &claim.says, &finding, &claim.verdict].map(|cell| plain(cell)));
    }
    let doubtful = claims.iter().filter(|claim| claim.verdict != AGREES);
    let reasons: String = doubtful
        .map(|claim| format!("{}, {}: {}\n", claim.verdict, claim.place, plain(&claim.why)))
        .collect();
    format!("{table}\n\n{reasons}\n{}\n", count(claims))
}

/// Each different number once, with the readings that give it where they are not all.
fn findings(columns: &[String], ours: &[String]) -> Vec<String> {
    let mut groups: Vec<(&str, Vec<&str>)> = Vec::new();
    for (column, number) in columns.iter().zip(ours) {
        match groups.iter_mut().find(|(known, _)| known == number) {
            Some((_, names)) => names.push(column),
            None => groups.push((number, vec![column])),
        }
    }
    match groups.as_slice() {
        [(number, _)] => vec![(*number).to_owned()],
        _ => groups.iter().map(|(number, names)| format!("{number} [{}]", label(names))).collect(),
    }
}

/// Names of readings, which a line of the table keeps together.
fn label(names: &[&str]) -> String {
    let whole: Vec<_> = names.iter().map(|name| name.replace(' ', "\u{a0}")).collect();
    whole.join("; ")
}

/// `27 claims: agrees 17, misprint 8, open 2`
fn count(claims: &[ClaimLine]) -> String {
    let mut verdicts = BTreeMap::new();
    for claim in claims {
        *verdicts.entry(claim.verdict.as_str()).or_insert(0) += 1;
    }
    let verdicts: Vec<_> = verdicts.iter().map(|(verdict, count)| format!("{verdict} {count}")).collect();
    format!("{} claims: {}", claims.len(), verdicts.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn reproduction() -> Reproduction {
        let claim = |ours: [&str; 3], verdict: &str| ClaimLine {
            place: "Fig. 5".to_owned(),
            says: "$τ̃_{0}$ ≈ 10^{−2}".to_owned(),
            ours: ours.map(String::from).to_vec(),
            verdict: verdict.to_owned(),
            why: "It is $π$.".to_owned(),
            ..ClaimLine::default()
        };
        Reproduction {
            folder: "out".into(),
            report: "out/report.html".into(),
            columns: ["printed", "other load", "corrected"].map(String::from).to_vec(),
            scoreboard: vec![claim(["1", "1", "1"], "agrees"), claim(["1", "1", "2"], "open")],
            lacking: Vec::new(),
        }
    }

    #[test]
    fn equal_numbers_stand_once_with_their_readings() {
        let text = text(&reproduction(), 80).replace('\u{a0}', " ");
        let cells = |line: &str| {
            line.split("  ").map(str::trim).filter(|cell| !cell.is_empty()).map(String::from).collect()
        };
        let rows: Vec<Vec<String>> = text.lines().filter(|line| line.starts_with(' ')).map(cells).collect();
        assert_eq!(rows[1], ["Fig. 5", "τ̃_0 ≈ 10⁻²", "1", "agrees"]);
        assert_eq!(rows[2], ["Fig. 5", "τ̃_0 ≈ 10⁻²", "1 [printed; other load]", "open"]);
        assert_eq!(rows[3], ["2 [corrected]"]);
        assert!(text.ends_with("\n\nopen, Fig. 5: It is π.\n\n2 claims: agrees 1, open 1\n"), "{text}");
    }

    #[test]
    fn the_document_names_the_readings() {
        let document = reproduction().json();
        assert_eq!(
            document["scoreboard"][1]["ours"],
            json!({ "printed": "1", "other load": "1", "corrected": "2" })
        );
        assert_eq!(document["complete"], true);
    }
}
