//! What is asked of modes that grow, against what is known of them by other means.

use crate::{case, number, run_into};

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
    let modes = "\n[[analysis]]\nname = \"modes\"\nkind = \"eigen\"\nband = [\"4 kHz\", \"6 kHz\"]\n";
    let growth = |key: &str, value: &str| {
        let set = [format!("{key}={value}")];
        let file = judder_models::parse("case.toml", &format!("{text}{modes}"), &set).unwrap();
        let report = run_into(tempfile::tempdir().unwrap().path(), &file, &["modes"]);
        let values = report.summary.results["modes"]["eigenvalues"].as_array().unwrap().clone();
        values.iter().map(|own| number(&own["re"])).fold(f64::NEG_INFINITY, f64::max)
    };
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &with(""), &["squeal"]);
    let told = &report.summary.results["squeal"];
    let keys = told["cures"]["keys"].as_array().unwrap();
    assert!(keys.len() == 3 && told["cures"]["check"]["holds"] == true, "{told:?}");
    let changes: Vec<f64> = keys.iter().map(|own| number(&own["change"]).abs()).collect();
    assert!(changes.is_sorted(), "{changes:?}");
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
