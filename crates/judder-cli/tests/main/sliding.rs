//! Sliding cases: the template, and what is refused of it.

use crate::desk::Desk;

#[test]
fn the_template_is_checked() {
    let desk = Desk::new();
    desk.write("case.toml", desk.succeed(&["new", "beams-paper"]).stdout);
    let shown = desk.succeed(&["check", "case.toml"]).stdout;
    for words in
        ["structure.oblique.beam.start", "guided", "motion.ramps.load", "101 values", "analysis.ensubs.step"]
    {
        assert!(shown.contains(words), "{words:?} is not in\n{shown}");
    }
    let checked = desk.succeed(&["check", "case.toml", "--json"]).json();
    assert_eq!(checked["case"]["motion"]["velocity"]["value"], 0.03);
}

#[test]
fn a_swept_key_that_is_not_there_is_shown_in_the_case() {
    let desk = Desk::new();
    let template = desk.succeed(&["new", "beams-paper"]).stdout;
    desk.write("case.toml", template.replace("key = \"contact.friction", "key = \"contact.frction"));
    let message = "`contact.frction_coefficient` cannot be swept: unknown key";
    desk.refused(&["check", "case.toml"], message, "did you mean `friction_coefficient`?");
}

/// A coarse pair, which runs in a moment.
const PAIR: &str = r#"
model = "sliding"

[[structure]]
name = "slider"
beam = { length = "75 mm", thickness = "1.5 mm", elements = [15, 1], angle = "-30 deg", start = "guided" }
width = "10 mm"
material = { youngs_modulus = "71 GPa", poisson_ratio = 0.33, density = "2770 kg/m^3" }
damping = { structural = { loss_factor = 0.001, reference_frequency = "3.5 kHz" } }
reduction = { count = 6 }

[[structure]]
name = "track"
beam = { length = "100 mm", thickness = "2 mm", elements = [20, 1], start = "clamped" }
width = "20 mm"
material = { youngs_modulus = "2.38 GPa", poisson_ratio = 0.40, density = "1200 kg/m^3" }
damping = { rayleigh = { alpha = "40 1/s", beta = "4e-8 s" } }
reduction = { count = 6 }

[contact]
slider = { structure = "slider", set = "end-lower" }
track = { structure = "track", set = "upper-corners" }

[motion]
end = "90 mm"
load = { set = "start" }

[observe]
points = [{ name = "T", structure = "track", set = "end-upper" }]

[[analysis]]
name = "modes"
kind = "modes"
structure = "track"
count = 5

[[analysis]]
name = "locus"
kind = "locus"
count = 10
positions = { from = "20 mm", to = "80 mm", points = 13 }

[[analysis]]
name = "friction"
kind = "locus"
configuration = "deformed"
count = 10
at = "52 mm"
sweep = { key = "contact.friction_coefficient", from = 0.5, to = 0.1, points = 5 }

[[analysis]]
name = "growth"
kind = "growth"
method = "ensubs"
position = "52 mm"
frequency = "400 Hz"
step = "2e-7 s"
"#;

/// The summary keys that stay, their shapes, the checks.
#[test]
fn a_pair_runs() {
    let desk = Desk::with_case(PAIR);
    let summary = desk.succeed(&["run", "case.toml", "--json"]).json();
    let results = &summary["results"];
    assert_eq!(results["modes"]["frequencies_hz"].as_array().unwrap().len(), 5);
    let lengths = |name: &str, key: &str| {
        let rows = results[name][key].as_array().unwrap();
        assert!(rows.iter().all(|row| row.as_array().unwrap().len() == 10), "{name} {key}");
        rows.len()
    };
    assert_eq!(results["locus"]["position_m"][12], 0.08);
    assert_eq!(results["friction"]["value"][0], 0.5);
    for (name, rows) in [("locus", 13), ("friction", 5)] {
        assert_eq!((lengths(name, "frequencies_hz"), lengths(name, "growth_rates")), (rows, rows));
        assert!(
            results[name]["unstable"].is_array() && results[name]["missing"].as_array().unwrap().is_empty()
        );
    }
    let number = |key: &str| results["growth"][key].as_f64().unwrap();
    assert!((number("measured") / number("predicted") - 1.0).abs() < 1e-2, "{}", results["growth"]);
    assert!((number("frequency_hz") / 400.0 - 1.0).abs() < 0.5);
    let checks = &summary["study"]["checks"];
    for (name, count) in [("locus", 3), ("friction", 3), ("growth", 2)] {
        assert_eq!(checks[name].as_array().unwrap().len(), count, "{checks}");
    }
    for file in ["locus.csv", "friction.csv", "figures/locus.svg", "figures/friction.png"] {
        assert!(desk.path(&format!("out/case/{file}")).is_file(), "{file}");
    }
    // the same bytes on one thread
    desk.succeed(&["run", "case.toml", "--threads", "1", "-o", "alone", "--only", "locus"]);
    let table = |folder: &str| std::fs::read(desk.path(&format!("{folder}/locus.csv"))).unwrap();
    assert!(table("out/case") == table("alone"));
}

#[test]
fn a_check_knows_the_pair() {
    let desk = Desk::with_case(PAIR);
    let checked = desk.succeed(&["check", "case.toml", "--json"]).json();
    // 20 free nodes of the edge by two, six modes; u_y of A, C by two, six modes
    let structures = checked["structures"].as_array().unwrap();
    assert_eq!((&structures[0]["kept_freedoms"], &structures[1]["kept_freedoms"]), (&3.into(), &40.into()));
    assert_eq!(checked["pair"]["degrees_of_freedom"], 55);
    assert_eq!(checked["pair"]["side"], "left");
    for method in ["subs", "ensubs", "film", "residual-flexibility"] {
        assert!(checked["step_limits_s"][method].as_f64().unwrap() > 1e-8, "{method}");
    }
    assert_eq!(checked["estimate"].as_array().unwrap().len(), 4);
}

/// What only the structures can tell is shown where the case says it.
#[test]
fn what_cannot_slide_is_shown_in_the_case() {
    let wrong = [
        (
            "set = \"end-lower\"",
            "set = \"end-lowr\"",
            "no set of nodes named `end-lowr`",
            "did you mean `end-lower`?",
        ),
        (
            "set = \"end-lower\"",
            "set = \"end\"",
            "`contact.slider` names 3 nodes, but must name one",
            "end-lower",
        ),
        ("set = \"end-upper\"", "set = \"end\"", "`observe.points.T` names 3 nodes", "end-lower"),
        (
            "end = \"90 mm\"",
            "end = \"120 mm\"",
            "`motion.end` is 0.12 m, but the track goes from 0 to 0.1 m",
            "first and the last",
        ),
        (
            "load = { set = \"start\" }",
            "load = { set = \"start\", direction = \"x\" }",
            "`start` is held along x",
            "free it",
        ),
        ("start = \"guided\"", "start = \"free\"", "move along y each on its own", "tie them"),
        (
            "set = \"upper-corners\"",
            "set = \"end-upper\"",
            "the track `end-upper` is no edge",
            "nodes of one edge",
        ),
        ("step = \"2e-7 s\"", "step = \"1e-4 s\"", "above the limit of stability", "leave `step` out"),
        ("position = \"52 mm\"", "position = \"520 mm\"", "`position` is 0.52 m", "first and the last"),
    ];
    for (right, wrong, message, help) in wrong {
        let desk = Desk::with_case(&PAIR.replacen(right, wrong, 1));
        for command in [&["run", "case.toml", "--only", "growth"][..], &["check", "case.toml"]] {
            refused(&desk, command, (wrong, message, help));
        }
    }
}

/// The exit code, what is wrong, where, and what would be right.
fn refused(desk: &Desk, command: &[&str], (wrong, message, help): (&str, &str, &str)) {
    let said = desk.judder(command);
    assert_eq!(said.code, 2, "{wrong}: {}", said.stderr);
    said.says(message);
    said.says(help);
    said.says("case.toml:");
}

/// What only a run finds: no mode near a frequency, a load that pulls the slider off, friction that locks it.
#[test]
fn what_only_a_run_finds_is_shown_in_the_case() {
    let wrong = [
        (
            "frequency = \"400 Hz\"",
            "frequency = \"400 MHz\"",
            "no mode of the coupled pair swings near",
            "a locus shows",
        ),
        ("frequency = \"400 Hz\"", "frequency = \"4 Hz\"", "there is none up to 6.0 Hz", "a locus shows"),
        (
            "load = { set = \"start\" }",
            "load = { set = \"start\", force = \"1 N\" }",
            "pulls the slider off",
            "mind the sign",
        ),
        (
            "[contact]",
            "[contact]\nfriction_coefficient = 9",
            "sprag-slip at 0.052 m",
            "a smaller friction coefficient",
        ),
    ];
    for (right, wrong, message, help) in wrong {
        let desk = Desk::with_case(&PAIR.replacen(right, wrong, 1));
        refused(&desk, &["run", "case.toml", "--only", "growth"], (wrong, message, help));
    }
}

/// A gap without a ramp is refused before a march starts, a load that lifts off is said with what was computed.
#[test]
fn a_march_that_cannot_touch_says_so() {
    let march = short("[[analysis]]\nname = \"film\"\nkind = \"march\"\nmethod = \"film\"\n");
    for gap in ["1 um", "-1 um"] {
        let text = march.replace("[contact]", &format!("[contact]\ninitial_gap = \"{gap}\""));
        let desk = Desk::with_case(&text.replace(", gap = \"4 ms\"", ", gap = \"0 s\""));
        for command in ["run", "check"] {
            refused(
                &desk,
                &[command, "case.toml"],
                (gap, "closed in one step it would be a kick", "give motion.ramps.gap a time"),
            );
        }
    }
    let desk = Desk::with_case(
        &march.replace("load = { set = \"start\" }", "load = { set = \"start\", force = \"1 N\" }"),
    );
    let said = desk.succeed(&["run", "case.toml"]);
    said.says("the load pulls the slider off the track");
    said.says("the contact was open");
    let told = &desk.read_json("out/case/summary.json")["results"]["film"];
    assert!(told["open_steps"].as_u64().unwrap() > 0 && told["normal_force"]["max"] == 0.0, "{told}");
}

/// `modes` shows what the reduction of each structure costs; it only stiffens.
#[test]
fn modes_stand_beside_those_of_the_reduction() {
    let desk = Desk::with_case(PAIR);
    let said = desk.succeed(&["run", "case.toml", "--only", "modes"]);
    said.says("reduced less full");
    let told = &desk.read_json("out/case/summary.json")["results"]["modes"];
    let list = |key: &str| -> Vec<f64> {
        told[key].as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect()
    };
    let (full, reduced, errors) = (list("frequencies_hz"), list("reduced_hz"), list("reduction_errors"));
    assert_eq!((reduced.len(), errors.len()), (5, 5));
    for ((full, reduced), error) in full.iter().zip(&reduced).zip(&errors) {
        assert!(*reduced >= full * (1.0 - 1e-9) && *reduced < full * 1.05, "{full} {reduced}");
        assert!((error - (reduced - full) / reduced).abs() < 1e-12);
        said.says(&format!("{reduced:.7}"));
    }
    assert!(errors[4] > errors[0], "{errors:?}");
}

/// The coarse pair with these analyses alone, and ramps of milliseconds.
fn short(analyses: &str) -> String {
    let (pair, _) = PAIR.split_once("[[analysis]]").unwrap();
    let ramps = "[motion]\nvelocity = \"300 mm/s\"\nstart = \"84 mm\"\n\
                 ramps = { velocity = \"4 ms\", load = \"4 ms\", friction = \"4 ms\", gap = \"4 ms\" }";
    format!("{}\n{analyses}", pair.replace("[motion]", ramps))
}

/// The last part of a path: the keys that stay, the files, and a spectrogram of what was stored.
#[test]
fn a_march_runs_and_is_shown() {
    let desk = Desk::with_case(&short(
        "[[analysis]]\nname = \"film\"\nkind = \"march\"\nmethod = \"film\"\n\n\
         [[analysis]]\nname = \"levels\"\nkind = \"spectrogram\"\nof = \"film\"\n",
    ));
    let summary = desk.succeed(&["run", "case.toml", "--json"]).json();
    let told = &summary["results"]["film"];
    for key in ["steps", "step_s", "step_limit_s", "seconds", "peak_acceleration", "peak_position_m"] {
        assert!(told[key].as_f64().is_some_and(|value| value > 0.0), "{key}: {told}");
    }
    for key in ["normal_force", "sliding_velocity"] {
        assert!(told[key]["min"].as_f64().unwrap() <= told[key]["max"].as_f64().unwrap(), "{key}");
    }
    assert!(told["bursts"].is_array() && told["stick_steps"].is_u64() && told["open_steps"].is_u64());
    assert!(summary["results"]["levels"]["peak_level_db"].is_f64());
    for file in ["film.csv", "film-T.y.wav", "figures/film.svg", "figures/levels.png", "results.zarr/film"] {
        assert!(desk.path(&format!("out/case/{file}")).exists(), "{file}");
    }
}

#[test]
fn wrong_marches_are_refused() {
    let march = "[[analysis]]\nname = \"film\"\nkind = \"march\"\nmethod = \"film\"\n";
    let desk = Desk::with_case(&short(&format!("{march}step = \"2 us\"\n")));
    let said = desk.judder(&["run", "case.toml"]);
    assert_eq!(said.code, 2, "{}", said.stderr);
    said.says("above the limit of stability");
    let desk = Desk::with_case(&short(&format!("{march}signal = \"T.z\"\n")));
    desk.refused(&["run", "case.toml"], "unknown signal `T.z`", "T.y");
}

/// A slider that locks on its way: what was computed before stays, and the exit code says that something is missing.
#[test]
fn a_march_that_ends_before_its_path_says_where() {
    let march = "[[analysis]]\nname = \"ensubs\"\nkind = \"march\"\nmethod = \"ensubs\"\n";
    let desk = Desk::with_case(&short(march));
    let said = desk.judder(&["run", "case.toml", "--set", "contact.friction_coefficient=5", "--json"]);
    assert_eq!(said.code, 1, "{}", said.stderr);
    said.says("before the end of its path");
    let ended = &desk.read_json("out/case/summary.json")["results"]["ensubs"]["ended"];
    assert!(ended["reason"].as_str().unwrap().contains("sprag-slip"), "{ended}");
    assert!(desk.path("out/case/results.zarr/ensubs").exists());
}
