//! `judder reproduce`.

use crate::desk::Desk;
use serde_json::Value;

#[test]
#[ignore = "expensive: every figure of the paper"]
fn the_oscillator_paper_is_reproduced() {
    let desk = Desk::new();
    let text = desk.succeed(&["reproduce", "--quick", "--threads", "2"]).stdout;
    assert!(text.contains("the paper says") && text.contains(" claims: agrees "), "{text}");
    assert!(!text.contains('$') && !text.contains('{'), "{text}");
    let document = desk.succeed(&["reproduce", "oscillator-paper", "--quick", "--json"]).json();
    assert_eq!(document["complete"], true);
    assert_eq!(document["folder"], "out/reproduce/oscillator-paper");
    assert!(desk.path(document["report"].as_str().unwrap()).is_file());
    for claim in document["scoreboard"].as_array().unwrap() {
        let verdict = claim["verdict"].as_str().unwrap();
        assert!(["agrees", "misprint", "open"].contains(&verdict), "{claim}");
        assert!(claim["ours"].as_object().is_some_and(|ours| !ours.is_empty()), "{claim}");
    }
    the_scoreboard_is_that_of_the_fit(&desk, &document);
    desk.succeed(&["report", "out/reproduce/oscillator-paper"]);
}

/// Summary and scoreboard show one fit: r² of the first stands in the second.
fn the_scoreboard_is_that_of_the_fit(desk: &Desk, document: &Value) {
    let summary = desk.path("out/reproduce/oscillator-paper/summary.json");
    let summary: Value = serde_json::from_str(&std::fs::read_to_string(summary).unwrap()).unwrap();
    let fit = &summary["results"]["fig-14"];
    for quantity in ["force", "area", "friction"] {
        let ending = format!("of the {quantity}");
        let is_r2 = |claim: &&Value| {
            claim["place"].as_str().unwrap().starts_with("App. B")
                && claim["says"].as_str().unwrap().ends_with(&ending)
        };
        let claim = document["scoreboard"].as_array().unwrap().iter().find(is_r2).unwrap();
        let r2 = format!("{:.4}", fit[quantity]["r2"].as_f64().unwrap());
        assert_eq!(claim["ours"]["computed, F_n μ"], r2, "{quantity}");
    }
}

#[test]
#[ignore = "expensive: the last quarter of the path by every march"]
fn the_beams_paper_is_reproduced() {
    let desk = Desk::new();
    let reproduced = || desk.succeed(&["reproduce", "beams-paper", "--quick", "--json"]).json();
    let document = reproduced();
    assert_eq!(document["complete"], true);
    // where its zones are and what EnSubs saves, the book says why
    let unsettled = ["and nowhere else", "less time than FiLM"];
    for claim in document["scoreboard"].as_array().unwrap() {
        let says = claim["says"].as_str().unwrap();
        assert!(claim["verdict"] == "agrees" || unsettled.iter().any(|end| says.contains(end)), "{claim}");
    }
    // what is done is not done again
    assert_eq!(reproduced()["scoreboard"], document["scoreboard"]);
    desk.succeed(&["report", "out/reproduce/beams-paper"]);
}
