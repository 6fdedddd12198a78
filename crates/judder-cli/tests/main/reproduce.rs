//! `judder reproduce`.

use crate::desk::Desk;

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
    desk.succeed(&["report", "out/reproduce/oscillator-paper"]);
}
