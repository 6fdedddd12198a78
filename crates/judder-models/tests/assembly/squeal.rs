//! What is asked of modes that grow, against what is known of them by other means.

use super::marches::left;
use crate::stopping::Stopping;
use crate::{case, number, run_into};
use judder_study::run::{RunOptions, run};
use judder_study::{Silent, StudyError};

/// μ(s) N of the belt, with the friction that would go on beyond the speed of the belt.
const FRICTION: [f64; 3] = [0.4, 0.2, 0.5];
const DAMPING: f64 = 0.05;

/// Whether the mass reaches the speed of the belt after a while, from this place and velocity, by a Runge–Kutta method of order four; until then it slides.
fn reaches_the_belt(speed: f64, start: [f64; 2], [after, until]: [usize; 2]) -> bool {
    const STEP: f64 = 2e-3;
    let [at_rest, at_speed, decay] = FRICTION;
    let acceleration =
        |x: f64, v: f64| at_speed + (at_rest - at_speed) * ((v - speed) / decay).exp() - x - DAMPING * v;
    let [mut x, mut v] = start;
    for step in 0..until {
        let [a, b] = [v, acceleration(x, v)];
        let [c, d] = [v + 0.5 * STEP * b, acceleration(x + 0.5 * STEP * a, v + 0.5 * STEP * b)];
        let [e, f] = [v + 0.5 * STEP * d, acceleration(x + 0.5 * STEP * c, v + 0.5 * STEP * d)];
        let [g, h] = [v + STEP * f, acceleration(x + STEP * e, v + STEP * f)];
        x += STEP / 6.0 * (a + 2.0 * c + 2.0 * e + g);
        v += STEP / 6.0 * (b + 2.0 * d + 2.0 * f + h);
        if step > after && v >= speed {
            return true;
        }
    }
    false
}

/// Whether the mass that leaves the belt of this speed at the end of sticking comes back to it within a period.
fn comes_back(speed: f64) -> bool {
    reaches_the_belt(speed, [FRICTION[0] - DAMPING * speed, speed], [2000, 4000])
}

/// The impulse from which on a mass of 1 kg on a belt of this speed is caught by it, knocked from steady sliding.
fn least_knock(speed: f64) -> f64 {
    let [at_rest, at_speed, decay] = FRICTION;
    let steady = at_speed + (at_rest - at_speed) * (-speed / decay).exp();
    let [mut from, mut to] = [0.0, speed];
    for _ in 0..30 {
        let middle = 0.5 * (from + to);
        match reaches_the_belt(speed, [steady, middle], [0, 100_000]) {
            true => to = middle,
            false => from = middle,
        }
    }
    from
}

/// Stick and slip end where the mass just comes back to its belt; steady sliding begins where friction no longer feeds what damping takes.
#[test]
fn the_margin_of_a_mass_on_a_belt_is_that_of_its_slip() {
    let [mut from, mut to] = [1.3, 1.8];
    for _ in 0..40 {
        let middle = 0.5 * (from + to);
        if comes_back(middle) { from = middle } else { to = middle }
    }
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &case("assembly/mass-on-falling-belt.toml", &[]), &["squeal"]);
    assert!(report.complete, "{:?}", report.messages);
    let told = &report.summary.results["squeal"];
    assert!(told["unstable"] == 0 && told["margin"]["knock"] == true);
    let onset = &told["margin"]["onsets"][0];
    let [at_rest, at_speed, decay] = FRICTION;
    let known = decay * ((at_rest - at_speed) / (DAMPING * decay)).ln();
    assert!((number(&onset["onset"]) - known).abs() < 1e-8 && onset["grows_above"] == false, "{onset}");
    assert!((number(&onset["fold"]) / from - 1.0).abs() < 1e-3, "{onset} {from}");
    // beyond its onset the branch has cycles that motions leave, and those with stick that a knock leads to
    let stable = onset["stable"].as_array().unwrap();
    assert_eq!(stable.len(), onset["looked_at"].as_array().unwrap().len());
    assert!(stable.contains(&true.into()) && stable.contains(&false.into()), "{onset}");
    assert!(onset["stability"].as_str().unwrap().starts_with("beyond the onset "), "{onset}");
    let page = std::fs::read_to_string(folder.path().join("report.html")).unwrap();
    assert!(page.contains("motions near its cycles"));
    // knocks that suffice are those that the mass needs to be caught by the belt
    let knocks = &told["knocks"];
    let least = least_knock(1.2);
    let [vibrates, settles] =
        ["smallest_that_vibrates", "largest_that_settles"].map(|key| number(&knocks[key]));
    assert!(settles < 1.02 * least && vibrates > 0.98 * least, "{knocks} {least}");
    let share = 1.0 - least / 1.2;
    let interval = ["0", "1"].map(|end| number(&knocks["interval"][end.parse::<usize>().unwrap()]));
    assert!(interval[0] < share && share < interval[1] && knocks["undecided"] == 0, "{knocks} {share}");
    let margin = (number(&onset["fold"]) - known) / known;
    assert!((number(&onset["margin"]) - margin).abs() < 1e-6 && onset["rank"] == 1, "{onset}");
    // at a speed at which it sticks and slips by itself the mode has the same margin
    let slower = case("assembly/mass-on-falling-belt.toml", &["contact.belt.sliding.velocity=\"0.95 m/s\""]);
    let report = run_into(tempfile::tempdir().unwrap().path(), &slower, &["squeal"]);
    let told = &report.summary.results["squeal"];
    assert!(told["unstable"] == 1 && told["margin"]["knock"].is_null(), "{told:?}");
    assert!(
        (number(&told["modes"][0]["margin"]) - margin).abs() < 1e-3
            && told["modes"][0]["rank_by_margin"] == 1
    );
    assert!(told["margin"]["onsets"][0]["mode"] == 1);
    let reason =
        "no cycles that begin at the onsets of the range are known to reach the case; others are not sought";
    assert_eq!(told["margin"]["knock_reason"], reason);
}

/// A range that ends before the cycles do leaves the margin unknown, which is said.
#[test]
fn a_margin_beyond_the_range_is_not_guessed() {
    let range = "analysis.squeal.margin.to=\"1.3 m/s\"";
    let report = run_into(
        tempfile::tempdir().unwrap().path(),
        &case("assembly/mass-on-falling-belt.toml", &[range]),
        &["squeal"],
    );
    let told = &report.summary.results["squeal"]["margin"];
    assert!(told["unknown"] == 1 && told["largest"].is_null() && told["knock"] == true, "{told:?}");
    let onset = &told["onsets"][0];
    assert!(onset["margin"].is_null() && onset["fold"].is_null() && number(&onset["reaches"]) > 1.25);
    let said = "how far the cycles reach beyond the onset at contact.belt.sliding.velocity = 1.03972";
    assert!(report.messages.iter().any(|own| own.contains(said)), "{:?}", report.messages);
}

/// Derivatives of the growth rate are those of the modes of cases with other numbers, and the same on one thread.
#[test]
fn cures_are_what_other_numbers_of_the_case_do() {
    let text =
        std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/small/assembly-cycle.toml"))
            .unwrap();
    let with = |more: &str| judder_models::parse("case.toml", &format!("{text}{more}"), &[]).unwrap();
    let modes = "\n[[analysis]]\nname = \"modes\"\nkind = \"eigen\"\nband = [\"1 kHz\", \"8 kHz\"]\n";
    let all = |key: &str, value: &str| -> Vec<f64> {
        let set = [format!("{key}={value}")];
        let file = judder_models::parse("case.toml", &format!("{text}{modes}"), &set).unwrap();
        let report = run_into(tempfile::tempdir().unwrap().path(), &file, &["modes"]);
        let values = report.summary.results["modes"]["eigenvalues"].as_array().unwrap().clone();
        values.iter().map(|own| number(&own["re"])).collect()
    };
    // of the case one mode grows
    let growth = |key: &str, value: &str| all(key, value).into_iter().fold(f64::NEG_INFINITY, f64::max);
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &with(""), &["squeal"]);
    let told = &report.summary.results["squeal"];
    let keys = told["cures"]["keys"].as_array().unwrap();
    assert_eq!(keys.len(), 3, "{told:?}");
    let before = number(&told["cures"]["growth_rate"]);
    let helps: Vec<(bool, f64)> = keys
        .iter()
        .map(|own| (number(&own["growth_rate_at_change"]) > 0.2 * before, number(&own["change"]).abs()))
        .collect();
    assert!(helps.is_sorted_by(|a, b| (!a.0 && b.0) || a.0 == b.0 && a.1 <= b.1), "{helps:?}");
    // what is told of a change is what the case with the number changed so far has
    for (key, unit) in [
        ("contact.sole.normal.stiffness", "N/m^3"),
        ("structure.foot.damping.rayleigh.beta", "s"),
        ("structure.foot.material.youngs_modulus", "Pa"),
    ] {
        let own = keys.iter().find(|own| own["key"] == key).unwrap();
        let value = number(&own["value"]) * (1.0 + number(&own["change"]));
        let found = number(&own["growth_rate_at_change"]);
        let values = all(key, &format!("\"{value:e} {unit}\""));
        assert!(values.iter().any(|other| (other - found).abs() < 1e-6 * before), "{own} {values:?}");
        let growing = values.iter().filter(|other| **other > 0.0).count();
        assert_eq!(own["unstable_at_change"], growing, "{own} {values:?}");
        assert_eq!(own["cured"].as_bool().unwrap(), found < 0.0, "{own}");
        assert_eq!(own["at_change"].as_str().unwrap().starts_with("cured"), found < 0.0, "{own}");
    }
    for (key, [low, high]) in [
        ("contact.sole.normal.stiffness", ["\"1.98e9 N/m^3\"", "\"2.02e9 N/m^3\""]),
        ("structure.foot.damping.rayleigh.beta", ["\"4.95e-7 s\"", "\"5.05e-7 s\""]),
    ] {
        let own = keys.iter().find(|own| own["key"] == key).unwrap();
        let derivative = (growth(key, high) - growth(key, low)) / 0.02;
        assert!((number(&own["growth_by_change"]) / derivative - 1.0).abs() < 5e-3, "{own} {derivative}");
        let change = -number(&told["cures"]["growth_rate"]) / number(&own["growth_by_change"]);
        assert!((number(&own["change"]) / change - 1.0).abs() < 1e-12, "{own}");
    }
    let alone = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let again = alone.install(|| run_into(tempfile::tempdir().unwrap().path(), &with(""), &["squeal"]));
    assert_eq!(&again.summary.results["squeal"], told);
    // all dampings, moduli and stiffnesses that the case gives
    let usual = text.replace("cures = [", "cures = true # [");
    let report = run_into(
        tempfile::tempdir().unwrap().path(),
        &judder_models::parse("case.toml", &usual, &[]).unwrap(),
        &["squeal"],
    );
    let all = report.summary.results["squeal"]["cures"]["keys"].as_array().unwrap();
    assert_eq!(all.len(), 4, "{all:?}");
}

const BELT: &str = "assembly/mass-on-falling-belt.toml";

/// Overrides that leave no onset in the range, and knocks that are few and small.
const NO_ONSET: [&str; 5] = [
    "analysis.squeal.margin.from=\"1.1 m/s\"",
    "analysis.squeal.margin.to=\"1.3 m/s\"",
    "analysis.squeal.margin.points=3",
    "analysis.squeal.knocks.impulse=[\"0 N s\", \"0.1 N s\"]",
    "analysis.squeal.knocks.samples=4",
];

/// Where no mode begins to grow nothing is known of knocks that small ones do not show, and of cures that there are none to be had.
#[test]
fn without_an_onset_and_a_mode_that_grows_it_is_told_why_nothing_is_listed() {
    let file = case(BELT, &[&NO_ONSET[..], &["analysis.squeal.cures=true"]].concat());
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &file, &["squeal"]);
    let told = &report.summary.results["squeal"];
    let margin = &told["margin"];
    assert!(margin["knock"].is_null() && margin["onsets"].as_array().unwrap().is_empty(), "{margin}");
    let reason = "no mode begins to grow within the range, and cycles are followed from onsets alone";
    assert_eq!(margin["knock_reason"], reason);
    assert!(told["knocks"]["settle"] == 4 && told["knocks"]["undecided"] == 0, "{told:?}");
    let cures = &told["cures"];
    assert!(cures["frequency_hz"].is_null() && cures["keys"].as_array().unwrap().is_empty(), "{cures}");
    let band = [0, 1].map(|end: usize| number(&told["band_hz"][end]));
    assert!((band[0] - 0.1).abs() < 1e-12 && (band[1] - 0.4).abs() < 1e-12, "{band:?}");
    let none = "no mode from 0.1 to 0.4 Hz, the band that is asked for, grows";
    assert_eq!(cures["reason"], none);
    let said = format!("no cures are listed: {none}");
    assert!(report.messages.iter().any(|own| own.contains(&said)), "{:?}", report.messages);
    let page = std::fs::read_to_string(folder.path().join("report.html")).unwrap();
    assert!(page.contains(&format!("none is listed: {none}")));
    assert!(page.contains("none from 0.1 to 0.4 Hz; others are not sought"));
    // of panels there is that of the knocks alone
    let picture = std::fs::read_to_string(folder.path().join("figures/squeal.svg")).unwrap();
    assert!(picture.contains("what is left of the energy of knocks") && !picture.contains("how loud"));
    assert!(!picture.contains("how fast modes grow") && !picture.contains("before their onset"));
}

/// A case of matrices has no dampings and moduli to be named, but entries.
#[test]
fn a_case_of_matrices_tells_which_numbers_can_be_named() {
    let slower = "contact.belt.sliding.velocity=\"0.95 m/s\"";
    let told = |cures: &str| {
        let cures = format!("analysis.squeal.cures={cures}");
        let file = case(BELT, &[&NO_ONSET[..], &[slower, cures.as_str()]].concat());
        let report = run_into(tempfile::tempdir().unwrap().path(), &file, &["squeal"]);
        report.summary.results["squeal"]["cures"].clone()
    };
    let usual = told("true");
    let reason = usual["reason"].as_str().unwrap();
    assert!(reason.starts_with("the case gives none of cubic_stiffness, alpha"), "{reason}");
    let named = reason.split('"').nth(1).unwrap();
    assert!(named.starts_with("structure.block.matrices"), "{reason}");
    assert!(number(&usual["growth_rate"]) > 0.0 && usual["keys"].as_array().unwrap().is_empty());
    // σ = (N Δμ/v₀ exp(−v/v₀) − c)/2m: its derivative by the relative change of c is −c/2
    let own = told("[\"structure.block.matrices.damping.0.0\"]");
    assert!((number(&own["keys"][0]["growth_by_change"]) + 0.5 * DAMPING).abs() < 1e-6, "{own}");
}

/// A number that moves nothing of the mode is told to do so, and no change of it as a cure.
#[test]
fn a_number_of_another_body_is_no_cure() {
    let small =
        std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/small/assembly-cycle.toml"))
            .unwrap();
    let other = "[[structure]]\nname = \"other\"\nmatrices = { mass = [[1]], stiffness = [[\"idle\"]], freedoms = [[\"mass\", \"x\"]] }\n";
    let text = small
        .replacen("[[structure]]", &format!("[parameters]\nidle = 4.0\n\n{other}\n[[structure]]"), 1)
        .replace("cures = [", "cures = [\"parameters.idle\", ");
    let without: String = text
        .lines()
        .filter(|line| !line.starts_with("margin") && !line.starts_with("knocks"))
        .map(|line| format!("{line}\n"))
        .collect();
    let file = judder_models::parse("case.toml", &without, &[]).unwrap();
    let report = run_into(tempfile::tempdir().unwrap().path(), &file, &["squeal"]);
    let cures = &report.summary.results["squeal"]["cures"];
    let keys = cures["keys"].as_array().unwrap();
    let own = keys.iter().find(|own| own["key"] == "parameters.idle").unwrap();
    assert!(own["growth_by_change"] == 0.0 && own["change"].is_null() && own["smooth"] == true, "{own}");
    assert_eq!(own["reason"], "the growth rate does not follow it");
    assert!(keys.last() == Some(own) && own["cured"].is_null() && own["at_change"] == "", "{cures}");
}

/// Two masses on one belt begin to grow at speeds of their own; each onset is that of the mode which swings as fast.
#[test]
fn each_onset_is_that_of_the_mode_with_its_frequency() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/assembly/mass-on-falling-belt.toml");
    let text = std::fs::read_to_string(path).unwrap();
    let block = &text[text.find("[[structure]]").unwrap()..text.find("[[load]]").unwrap()];
    let load = &text[text.find("[[load]]").unwrap()..text.find("[observe]").unwrap()];
    let other = |part: &str| {
        part.replace("block", "other")
            .replace("\"belt\"", "\"second-belt\"")
            .replace("stiffness = [[1,", "stiffness = [[2,")
            .replace("damping = [[0.05,", "damping = [[0.04,")
            .replace("\"1.2 m/s\"", "\"0.9 m/s\"")
    };
    let text = text
        .replace("[observe]", &format!("{}{}[observe]", other(block), other(load)))
        .replace("\"1.2 m/s\"", "\"0.9 m/s\"")
        .replace("margin_harmonics = 25", "margin_harmonics = 7");
    let along = "margin = { key = \"friction\", from = 0.4, to = 1.2, points = 9 }\n";
    let lines = text.lines().filter(|line| !line.starts_with("knocks") && !line.starts_with("margin ="));
    let text: String = lines.map(|line| format!("{line}\n")).collect::<String>() + along;
    let file = judder_models::parse("case.toml", &text, &[]).unwrap();
    let report = run_into(tempfile::tempdir().unwrap().path(), &file, &["squeal"]);
    let told = &report.summary.results["squeal"];
    let onsets = told["margin"]["onsets"].as_array().unwrap();
    assert!(told["unstable"] == 2 && onsets.len() == 2, "{told:?}");
    // N Δμ/v₀ exp(−v/v₀) factor = c
    let [at_rest, at_speed, decay] = FRICTION;
    let fall = (at_rest - at_speed) / decay * (-0.9 / decay).exp();
    for (own, (damping, stiffness, mode)) in onsets.iter().zip([(0.04, 2.0_f64, 2), (0.05, 1.0, 1)]) {
        assert!((number(&own["onset"]) - damping / fall).abs() < 1e-6, "{own}");
        let frequency = stiffness.sqrt() / std::f64::consts::TAU;
        assert!((number(&own["frequency_hz"]) - frequency).abs() < 1e-6 && own["mode"] == mode, "{own}");
    }
}

/// Modes are followed along the cells of a mesh, but no cycles, which need every value between.
#[test]
fn cells_of_a_mesh_are_swept_by_modes_and_refused_for_margins() {
    let small =
        std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/small/assembly-cycle.toml"))
            .unwrap();
    let key = "{ key = \"structure.foot.block.cells.0\", values = [4, 5, 6] }";
    let sweep = format!(
        "\n[[analysis]]\nname = \"finer\"\nkind = \"eigen-sweep\"\nband = [\"1 kHz\", \"8 kHz\"]\nsweep = {key}\n"
    );
    let file = judder_models::parse("case.toml", &format!("{small}{sweep}"), &[]).unwrap();
    let report = run_into(tempfile::tempdir().unwrap().path(), &file, &["finer"]);
    assert!(report.complete, "{:?}", report.messages);
    let margin = small.replace(
        "margin = { key = \"friction\", from = 0.2, to = 1.2, points = 11 }",
        &format!("margin = {key}"),
    );
    let refused = judder_models::parse("case.toml", &margin, &[]).unwrap_err().to_string();
    assert!(refused.contains("what follows it needs every value between the ends"), "{refused}");
}

/// Knocks that were followed before an interruption are kept, and what is stored in the end is the same to the bit.
#[test]
fn interrupted_knocks_go_on_to_the_bit() {
    // without multipliers, so that most looks whether to go on are those of the knocks
    let file = case(BELT, &["analysis.squeal.stability=false"]);
    let options = RunOptions { only: vec!["squeal".to_owned()], ..RunOptions::default() };
    let (whole, study) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    let patient = Stopping::at(usize::MAX);
    let at_once = run(&file, whole.path(), &options, &patient).unwrap();
    let stopping = Stopping::at(2 * patient.looks() / 3);
    assert!(matches!(run(&file, study.path(), &options, &stopping), Err(StudyError::Interrupted)));
    let kept = std::fs::read_to_string(study.path().join(".scratch-of-squeal")).unwrap();
    let knocks = kept.lines().filter(|line| line.contains("\"of\":\"knocks\"")).count();
    assert!(knocks > 4 && knocks < 40, "{kept}");
    let resumed = run(&file, study.path(), &options, &Silent).unwrap();
    assert_eq!(resumed.summary.results, at_once.summary.results);
    assert!(left(study.path()) == left(whole.path()));
}

/// A body that swings on without damping, below the band and once in 200 s: in windows of 80 s its kinetic energies are as 0.76 to 1, its whole energy is the same, so that it is not told to settle.
#[test]
fn a_slow_motion_that_does_not_decay_is_not_told_to_settle() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/assembly/mass-on-falling-belt.toml");
    let turn = std::f64::consts::TAU / 200.0;
    let slow = format!(
        "[[structure]]\nname = \"slow\"\nmatrices = {{ mass = [[1]], stiffness = [[{}]], freedoms = [[\"mass\", \"x\"]] }}\n",
        turn * turn
    );
    let text = std::fs::read_to_string(path)
        .unwrap()
        .replace("[observe]", &format!("{slow}\n[observe]"))
        .replace("points = [{", "points = [{ name = \"slow\", structure = \"slow\", set = \"mass\" }, {")
        .replace("at = \"mass.x\"", "at = \"slow.x\"")
        .replace("samples = 40", "samples = 2")
        .replace("step = \"25 ms\", duration = \"2000 s\"", "step = \"10 ms\", duration = \"400 s\"");
    let lines = text.lines().filter(|line| !line.starts_with("margin"));
    let text: String = lines.map(|line| format!("{line}\n")).collect();
    let file = judder_models::parse("case.toml", &text, &[]).unwrap();
    let report = run_into(tempfile::tempdir().unwrap().path(), &file, &["squeal"]);
    let knocks = &report.summary.results["squeal"]["knocks"];
    assert!(knocks["undecided"] == 2 && knocks["settle"] == 0, "{knocks}");
    let said = "what becomes of 2 of 2 knocks is not clear";
    assert!(report.messages.iter().any(|own| own.contains(said)), "{:?}", report.messages);
}

/// A mass that bounces on a spring with little damping: no mode grows and friction is constant, so that every knock settles in the end. At 7 s and at 60 s some motions have lost little of their energy
/// over the last fifths, and none of them may be told to keep vibrating.
#[test]
fn a_bounce_that_decays_slowly_is_not_told_to_keep_vibrating() {
    let text = |duration: &str| {
        format!(
            r#"
title = "A mass that bounces on a spring"
model = "assembly"
[[structure]]
name = "mass"
matrices = {{ mass = [[1, 0], [0, 1]], stiffness = [[1000, 0], [0, 0]], damping = [[0.1, 0], [0, 0.05]], freedoms = [["mass", "x"], ["mass", "y"]] }}
[[contact]]
name = "belt"
slider = {{ structure = "mass", set = "mass" }}
track = {{ plane = {{ normal = [0, 1] }} }}
sliding = {{ velocity = "1 m/s", direction = [1, 0] }}
normal = {{ point_stiffness = "3000 N/m" }}
friction_coefficient = 0.1
[[load]]
structure = "mass"
set = "mass"
direction = "y"
force = "-10 N"
[observe]
points = [{{ name = "mass", structure = "mass", set = "mass" }}]
[[analysis]]
name = "squeal"
kind = "squeal"
band = ["4 Hz", "12 Hz"]
knocks = {{ at = "mass.y", impulse = ["1 N s", "2 N s"], samples = 10, step = "1 ms", duration = "{duration}" }}
"#
        )
    };
    for duration in ["7 s", "15 s", "30 s", "60 s"] {
        let file = judder_models::parse("case.toml", &text(duration), &[]).unwrap();
        let report = run_into(tempfile::tempdir().unwrap().path(), &file, &["squeal"]);
        let knocks = &report.summary.results["squeal"]["knocks"];
        assert_eq!(knocks["vibrate"], 0, "{duration}: {knocks}");
    }
}
