//! The table of `judder reproduce`: what the paper says, what we find, the verdict.

use std::collections::BTreeMap;

use comfy_table::{ContentArrangement, Table, presets};
use judder_study::reproduce::{ClaimLine, Reproduction};
use serde_json::{Map, Value, json};

/// A verdict that needs no further word.
const AGREES: &str = "agrees";

/// The scoreboard as text of at most `width` columns: the table, then why for each claim that does not simply agree.
pub(crate) fn text(reproduction: &Reproduction, width: u16) -> String {
    let mut table = Table::new();
    table.load_preset(presets::UTF8_HORIZONTAL_ONLY);
    table.set_content_arrangement(ContentArrangement::Dynamic).set_width(width);
    let columns = reproduction.columns.iter().map(String::as_str);
    table.set_header(["where", "the paper says"].into_iter().chain(columns).chain(["verdict"]));
    for claim in &reproduction.scoreboard {
        let ours = claim.ours.iter().map(String::as_str);
        let [place, says, verdict] = [&claim.place, &claim.says, &claim.verdict].map(String::as_str);
        table.add_row([place, says].into_iter().chain(ours).chain([verdict]));
    }
    let open = reproduction.scoreboard.iter().filter(|claim| claim.verdict != AGREES);
    let reasons: Vec<_> =
        open.map(|claim| format!("{}, {}: {}\n", claim.verdict, claim.place, claim.why)).collect();
    format!("{table}\n\n{}\n{}", reasons.concat(), count(&reproduction.scoreboard))
}

/// `21 claims: 17 agrees, 2 misprint, 2 open`
fn count(claims: &[ClaimLine]) -> String {
    let mut verdicts = BTreeMap::new();
    for claim in claims {
        *verdicts.entry(claim.verdict.as_str()).or_insert(0) += 1;
    }
    let verdicts: Vec<_> =
        verdicts.into_iter().map(|(verdict, count)| format!("{count} {verdict}")).collect();
    format!("{} claims: {}\n", claims.len(), verdicts.join(", "))
}

/// The scoreboard as a document; our numbers under the names of their columns.
pub(crate) fn document(reproduction: &Reproduction) -> Value {
    let line = |claim: &ClaimLine| {
        let columns = reproduction.columns.iter().cloned();
        let ours: Map<_, _> = columns.zip(claim.ours.iter().map(|ours| json!(ours))).collect();
        json!({
            "place": claim.place, "says": claim.says, "ours": ours, "verdict": claim.verdict, "why": claim.why,
        })
    };
    json!({
        "folder": reproduction.folder,
        "report": reproduction.report,
        "complete": reproduction.complete,
        "scoreboard": reproduction.scoreboard.iter().map(line).collect::<Vec<_>>(),
    })
}
