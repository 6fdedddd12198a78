//! Verdicts on made-up results.

use super::*;
use serde_json::{Value, json};

fn found(results: Value) -> StoredResults {
    StoredResults::of_results(serde_json::from_value(results).unwrap())
}

/// The line about costs is measured: 30 % less agrees, 8 % less, 60 % less and more do not, nor does what was not timed.
#[test]
fn costs_are_those_of_the_run() {
    let with = |ensubs: f64, film: f64| {
        let marched = |seconds: f64| json!({ "steps": 1_000_000, "seconds": seconds });
        line(&CHEAPER, &found(json!({ "ensubs": marched(ensubs), "film": marched(film) })))
    };
    for (ensubs, verdict, told) in [
        (0.7, "agrees", "30 % less"),
        (0.92, "open", "8 % less"),
        (0.4, "open", "60 % less"),
        (1.05, "open", "5 % more"),
    ] {
        let own = with(ensubs, 1.0);
        assert_eq!(own.verdict, verdict, "{:?}", own.ours);
        assert!(own.ours[0].starts_with(told) && own.ours[0].contains("varies"), "{:?}", own.ours);
    }
    let own = line(&CHEAPER, &found(json!({ "ensubs": { "steps": 1000, "seconds": 1.0 } })));
    assert_eq!((own.verdict.as_str(), own.ours[0].as_str()), ("open", "no times of both"));
}

/// Every exponent that is told is judged, and none else is told.
#[test]
fn what_is_told_of_exponents_is_judged() {
    let zone = |nepers: f64| PassedZone {
        from: 0.08,
        to: 0.081,
        peak: 0.0805,
        frequency: 3.5e3,
        growth: 100.0,
        nepers,
    };
    let own = exponents(&[(zone(4.0), 4.1), (zone(1.4), 2.3)]);
    assert!(own.holds && own.ours == "e^{4.10} at 80 mm, promised e^{4.00}", "{}", own.ours);
    assert!(!exponents(&[(zone(4.0), 4.1), (zone(3.0), 2.4)]).holds);
    assert!(!exponents(&[(zone(1.4), 1.4)]).holds && !exponents(&[]).holds);
}

/// One burst outside the zones, however quiet, is against the claim.
#[test]
fn every_burst_must_belong_to_a_zone() {
    let with = |quiet: f64| {
        let burst = |position: f64, peak: f64| json!({ "position_m": position, "frequency_hz": 3520.0, "peak": peak });
        let zone = json!({ "from_m": 0.08, "to_m": 0.082, "frequency_hz": 3523.0, "max_growth_rate": 90.0 });
        let film = json!({ "bursts": [burst(0.0815, 9.0), burst(quiet, 1.0)] });
        line(&FILM_BURSTS, &found(json!({ "film": film, "locus-deformed": { "unstable": [zone] } })))
    };
    let (inside, outside) = (with(0.0825), with(0.07));
    assert_eq!((inside.verdict.as_str(), outside.verdict.as_str()), ("agrees", "open"));
    assert!(outside.ours[0].starts_with("1 of 2 bursts"), "{:?}", outside.ours);
}

/// Without results no claim agrees.
#[test]
fn nothing_agrees_without_results() {
    let agreeing: Vec<ClaimLine> =
        lines(&found(json!({}))).into_iter().filter(|line| line.verdict != "open").collect();
    assert_eq!(agreeing, []);
}
