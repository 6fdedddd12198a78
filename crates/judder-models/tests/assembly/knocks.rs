//! What becomes of knocks where forces bend and where modes grow outside the band, against integrations of the same equations.

use crate::run_into;
use judder_study::run::RunReport;
use serde_json::Value;

/// A mass pressed on two plates, each of which drags along the normal of the other; one stiffens about 1.5 mm. Steady sliding is stable, and so is a cycle around it.
fn brake(damping: f64, analysis: &str) -> String {
    format!(
        r#"
title = "Two motions that last"
model = "assembly"
[[structure]]
name = "brake"
matrices = {{ mass = [[1, 0], [0, 1]], damping = [[{damping}, 0], [0, {damping}]], freedoms = [["mass", "x"], ["mass", "y"]] }}
[[contact]]
name = "stiffening"
slider = {{ structure = "brake", set = "mass" }}
track = {{ plane = {{ normal = [1, 0] }} }}
sliding = {{ velocity = "10 m/s", direction = [0, 1] }}
normal = {{ point_cubic = {{ stiffness = "142000 N/m", cubic_stiffness = "3e11 N/m^3", about = "1.5 mm" }} }}
friction_coefficient = 0.2
[[contact]]
name = "linear"
slider = {{ structure = "brake", set = "mass" }}
track = {{ plane = {{ normal = [0, 1] }} }}
sliding = {{ velocity = "10 m/s", direction = [-1, 0] }}
normal = {{ point_stiffness = "222066 N/m" }}
friction_coefficient = 0.2
[[load]]
structure = "brake"
set = "mass"
direction = "x"
force = "-1158.88 N"
[[load]]
structure = "brake"
set = "mass"
direction = "y"
force = "-578.2 N"
[observe]
points = [{{ name = "mass", structure = "brake", set = "mass" }}]
[[analysis]]
{analysis}
"#
    )
}

/// The root mean square of the velocity of that mass over the last second of so many seconds after a knock along x, by a Runge–Kutta method of order four.
fn rms_after(damping: f64, impulse: f64, seconds: usize) -> f64 {
    const STEP: f64 = 5e-5;
    const FRICTION: f64 = 0.2;
    let cube = |off: f64| 3e11 * off.powi(3);
    let force = |closure: f64| match closure > 0.0 {
        true => 142_000.0 * closure + cube(closure - 1.5e-3) - cube(-1.5e-3),
        false => 0.0,
    };
    let slope = |[x, y, u, v]: [f64; 4]| {
        let [first, second] = [force(-x), 222_066.0 * (-y).max(0.0)];
        [
            u,
            v,
            first - FRICTION * second - 1158.88 - damping * u,
            second + FRICTION * first - 578.2 - damping * v,
        ]
    };
    let ahead =
        |q: [f64; 4], d: [f64; 4], step: f64| std::array::from_fn::<f64, 4, _>(|k| q[k] + step * d[k]);
    let mut q = [0.0; 4];
    // Newton's method from where the cube is flat
    q[0] = -1.5e-3;
    for _ in 0..50 {
        let second = 578.2 - FRICTION * force(-q[0]);
        let off = force(-q[0]) - FRICTION * second - 1158.88;
        q = [
            q[0] + off / ((142_000.0 + 9e11 * (-q[0] - 1.5e-3).powi(2)) * 1.04),
            -second / 222_066.0,
            0.0,
            0.0,
        ];
    }
    q[2] = impulse;
    let per_second = (1.0 / STEP) as usize;
    let mut sum = 0.0;
    for step in 0..seconds * per_second {
        let a = slope(q);
        let b = slope(ahead(q, a, 0.5 * STEP));
        let c = slope(ahead(q, b, 0.5 * STEP));
        let d = slope(ahead(q, c, STEP));
        q = std::array::from_fn(|k| q[k] + STEP / 6.0 * (a[k] + 2.0 * b[k] + 2.0 * c[k] + d[k]));
        if step >= (seconds - 1) * per_second {
            sum += (q[2] * q[2] + q[3] * q[3]) * STEP;
        }
    }
    sum.sqrt()
}

fn told(text: &str) -> (RunReport, Value) {
    let file = judder_models::parse("case.toml", text, &[]).unwrap();
    let report = run_into(tempfile::tempdir().unwrap().path(), &file, &["squeal"]);
    let knocks = report.summary.results["squeal"]["knocks"].clone();
    (report, knocks)
}

fn says(report: &RunReport, words: &str) -> bool {
    report.messages.iter().any(|own| own.contains(words))
}

/// A motion that shrinks to an outer cycle is not told to settle however smoothly it falls; followed longer it keeps vibrating, and a small one settles.
#[test]
fn a_smooth_motion_that_shrinks_to_a_cycle_keeps_vibrating() {
    let knocks = |damping: f64, impulse: &str, duration: &str| {
        brake(
            damping,
            &format!(
                "name = \"squeal\"\nkind = \"squeal\"\nband = [\"40 Hz\", \"120 Hz\"]\n\
             knocks = {{ at = \"mass.x\", impulse = {impulse}, samples = 4, step = \"1e-4 s\", duration = \"{duration}\" }}"
            ),
        )
    };
    assert!(rms_after(4.0, 1.4, 6) > 0.2 && rms_after(4.0, 2.5, 6) > 0.2);
    let (report, short) = told(&knocks(4.0, "[\"1.4 N s\", \"2.5 N s\"]", "0.63 s"));
    assert!(short["settle"] == 0 && short["small_motions"] == "decay at all frequencies", "{short}");
    assert!(short["vibrate"] == 4 || says(&report, "may fall to another motion"), "{:?}", report.messages);
    let (_, long) = told(&knocks(4.0, "[\"1.4 N s\", \"2.5 N s\"]", "4 s"));
    assert!(long["vibrate"] == 4 && long["undecided"] == 0, "{long}");
    assert!(rms_after(12.0, 0.03, 6) < 1e-6 && rms_after(12.0, 0.0461, 6) > 0.2);
    let (_, both) = told(&knocks(12.0, "[\"0.01 N s\", \"0.03 N s\"]", "4 s"));
    assert!(both["settle"] == 4, "{both}");
}

/// A third mass on a soft spring decays in the band, while a mode above it grows: no knock settles.
#[test]
fn a_mode_that_grows_outside_the_band_lets_no_knock_settle() {
    let text = brake(
        4.0,
        "name = \"squeal\"\nkind = \"squeal\"\nband = [\"25 Hz\", \"40 Hz\"]\n\
         knocks = { at = \"side.y\", impulse = [\"0.01 N s\", \"0.1 N s\"], samples = 3, step = \"1e-4 s\", duration = \"2 s\" }\n\
         [[analysis]]\nname = \"modes\"\nkind = \"eigen\"\nband = [\"0 Hz\", \"120 Hz\"]",
    )
    .replace("mass = [[1, 0], [0, 1]]", "mass = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]")
    .replace("[[4, 0], [0, 4]]", "[[4, 0, 0], [0, 4, 0], [0, 0, 4]], stiffness = [[0, 0, 0], [0, 100, -100], [0, -100, 40000]]")
    .replace("[\"mass\", \"y\"]]", "[\"mass\", \"y\"], [\"side\", \"y\"]]")
    .replace("points = [", "points = [{ name = \"side\", structure = \"brake\", set = \"side\" }, ")
    .replace("friction_coefficient = 0.2", "friction_coefficient = 0.3");
    let file = judder_models::parse("case.toml", &text, &[]).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &file, &["squeal", "modes"]);
    let results = &report.summary.results;
    assert!(
        results["modes"]["unstable"] == 1 && results["squeal"]["unstable"] == 0,
        "{:?}",
        results["modes"]
    );
    let knocks = &results["squeal"]["knocks"];
    assert_eq!(knocks["settle"], 0, "{knocks}");
    assert!(knocks["small_motions"].as_str().unwrap().starts_with("grow at "), "{knocks}");
    assert!(knocks["undecided"] == 0 || says(&report, "so that none settles"), "{:?}", report.messages);
}

/// Loads that lift a mass off that nothing but its contacts holds are told to.
#[test]
fn points_that_all_lift_off_are_told_to() {
    let steady = brake(12.0, "name = \"steady\"\nkind = \"steady-sliding\"");
    for (first, second, said) in [
        ("600 N", "600 N", "no contact point is closed in steady sliding"),
        ("-600 N", "5000 N", "with 1 of 2 contact points closed"),
    ] {
        let text = steady.replace("-1158.88 N", first).replace("-578.2 N", second);
        let file = judder_models::parse("case.toml", &text, &[]).unwrap();
        let report = run_into(tempfile::tempdir().unwrap().path(), &file, &["steady"]);
        let reasons: Vec<String> = report.refused.iter().map(|own| own.error.to_string()).collect();
        assert!(reasons.concat().contains(said), "{reasons:?}");
    }
}

/// Loads that press less than where the spring is softest: a step of Newton's method from there leads past lift-off, where nothing holds the mass.
#[test]
fn a_spring_that_is_soft_where_the_search_begins_has_its_steady_sliding() {
    let text = brake(12.0, "name = \"steady\"\nkind = \"steady-sliding\"")
        .replace("-1158.88 N", "-600 N")
        .replace("-578.2 N", "-1006 N");
    let file = judder_models::parse("case.toml", &text, &[]).unwrap();
    let report = run_into(tempfile::tempdir().unwrap().path(), &file, &["steady"]);
    assert!(report.complete, "{:?}", report.messages);
    let told = report.summary.results["steady"].to_owned();
    // N₁ = 600 N + μ N₂, N₂ = 1006 N − μ N₁
    let first = (600.0 + 0.2 * 1006.0) / 1.04;
    let second = 1006.0 - 0.2 * first;
    let text = serde_json::to_string(&told).unwrap();
    for own in [first, second] {
        assert!(text.contains(&format!("{own:.6}")[..8]), "{own}: {text}");
    }
}
