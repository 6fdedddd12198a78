//! What is asked of modes that grow, against what is known of them by other means.

use crate::{case, number, run_into};

/// μ(s) N of the belt, with the friction that would go on beyond the speed of the belt.
const FRICTION: [f64; 3] = [0.4, 0.2, 0.5];
const DAMPING: f64 = 0.05;

/// Whether the mass that leaves the belt of this speed at the end of sticking comes back to it within a period, by a Runge–Kutta method of order four.
fn comes_back(speed: f64) -> bool {
    const STEP: f64 = 2e-3;
    let [at_rest, at_speed, decay] = FRICTION;
    let acceleration =
        |x: f64, v: f64| at_speed + (at_rest - at_speed) * ((v - speed) / decay).exp() - x - DAMPING * v;
    let (mut x, mut v) = (at_rest - DAMPING * speed, speed);
    for step in 0..4000 {
        let [a, b] = [v, acceleration(x, v)];
        let [c, d] = [v + 0.5 * STEP * b, acceleration(x + 0.5 * STEP * a, v + 0.5 * STEP * b)];
        let [e, f] = [v + 0.5 * STEP * d, acceleration(x + 0.5 * STEP * c, v + 0.5 * STEP * d)];
        let [g, h] = [v + STEP * f, acceleration(x + STEP * e, v + STEP * f)];
        x += STEP / 6.0 * (a + 2.0 * c + 2.0 * e + g);
        v += STEP / 6.0 * (b + 2.0 * d + 2.0 * f + h);
        if step > 2000 && v >= speed {
            return true;
        }
    }
    false
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
    let margin = (number(&onset["fold"]) - known) / known;
    assert!((number(&onset["margin"]) - margin).abs() < 1e-6 && onset["rank"] == 1, "{onset}");
    // at a speed at which it sticks and slips by itself the mode has the same margin
    let slower = case("assembly/mass-on-falling-belt.toml", &["contact.belt.sliding.velocity=\"0.95 m/s\""]);
    let report = run_into(tempfile::tempdir().unwrap().path(), &slower, &["squeal"]);
    let told = &report.summary.results["squeal"];
    assert!(told["unstable"] == 1 && told["margin"]["knock"] == false, "{told:?}");
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
