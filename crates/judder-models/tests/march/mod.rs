//! Marches of sliding cases: what they leave, how they go on, what they refuse.

use crate::stopping::Stopping;
use judder_models::sliding::MODEL;
use judder_store::StudyFolder;
use judder_study::case::file::CaseFile;
use judder_study::run::{RunOptions, RunReport, run};
use judder_study::{Silent, StudyError};
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// A short and soft pair: few modes, ramps of milliseconds.
const PAIR: &str = r#"
model = "sliding"

[[structure]]
name = "oblique"
beam = { length = "75 mm", thickness = "1.5 mm", elements = [15, 1], angle = "-30 deg", start = "guided", end = "free" }
section = "plane-stress"
width = "10 mm"
material = { youngs_modulus = "71 GPa", poisson_ratio = 0.33, density = "2770 kg/m^3" }
damping = { rayleigh = { alpha = "0.2 1/s", beta = "4e-8 s" } }
reduction = { count = 4 }

[[structure]]
name = "horizontal"
beam = { length = "100 mm", thickness = "2 mm", elements = [20, 1], angle = "0 deg", start = "clamped", end = "free" }
section = "plane-stress"
width = "20 mm"
material = { youngs_modulus = "2.38 GPa", poisson_ratio = 0.40, density = "1200 kg/m^3" }
damping = { rayleigh = { alpha = "40 1/s", beta = "4e-8 s" } }
reduction = { count = 4 }

[contact]
slider = { structure = "oblique", set = "end-lower" }
track = { structure = "horizontal", set = "upper-corners" }
friction_coefficient = 0.3

[motion]
start = "90 mm"
end = "98.5 mm"
velocity = "300 mm/s"
load = { set = "start", direction = "y", force = "-0.2 N" }
ramps = { velocity = "4 ms", load = "4 ms", friction = "4 ms", gap = "4 ms" }

[observe]
points = [{ name = "T", structure = "horizontal", set = "end-upper" }]
"#;

fn case(analyses: &str) -> CaseFile {
    judder_models::parse("case.toml", &format!("{PAIR}\n{analyses}"), &[]).unwrap()
}

fn march(name: &str, rest: &str) -> String {
    format!("[[analysis]]\nname = \"{name}\"\nkind = \"march\"\ncheckpoint_steps = 3000\n{rest}\n")
}

fn studied(analyses: &str) -> (TempDir, RunReport) {
    let folder = TempDir::new().unwrap();
    let report = run(&case(analyses), &folder.path().join("study"), &RunOptions::default(), &Silent).unwrap();
    (folder, report)
}

/// Every file below a folder with its content.
pub(crate) fn contents(folder: &Path) -> Vec<(PathBuf, Vec<u8>)> {
    let mut all = Vec::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(next) = folders.pop() {
        for entry in fs::read_dir(next).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else {
                all.push((path.strip_prefix(folder).unwrap().to_owned(), fs::read(&path).unwrap()));
            }
        }
    }
    all.sort();
    all
}

#[test]
fn all_methods_tell_what_stays() {
    let methods = [
        ("subs", "method = \"subs\""),
        ("ensubs", "method = \"ensubs\""),
        ("film", "method = \"film\""),
        ("exact", "method = \"residual-flexibility\""),
    ];
    let analyses: String = methods.iter().map(|(name, method)| march(name, method)).collect();
    let (_folder, report) = studied(&analyses);
    assert!(report.complete, "{:?}", report.messages);
    for (name, _) in methods {
        let told = &report.summary.results[name];
        let number = |key: &str| told[key].as_f64().unwrap_or_else(|| panic!("{name}: {key}"));
        assert!(number("step_s") <= number("step_limit_s"));
        // s = 8.5 mm at 300 mm/s, and half the ramp of the speed
        let duration = 8.5e-3 / 0.3 + 2e-3;
        assert!((number("steps") * number("step_s") - duration).abs() < 2.0 * number("step_s"), "{name}");
        assert!(number("peak_acceleration") > 0.0 && number("seconds") > 0.0);
        let position = number("peak_position_m");
        assert!((0.09..=0.0985).contains(&position), "{name}: {position}");
        for key in ["normal_force", "sliding_velocity"] {
            assert!(told[key]["min"].as_f64().unwrap() <= told[key]["max"].as_f64().unwrap(), "{name}");
        }
        assert!(told["bursts"].is_array());
        let counts = ["slip_steps", "stick_steps", "open_steps", "reversed_steps"].map(number);
        let settled = number("settled_s") / number("step_s");
        assert!((counts.iter().sum::<f64>() + settled - number("steps")).abs() <= 1.0, "{name}: {counts:?}");
        assert!(report.folder.join(format!("{name}-T.y.wav")).exists());
        assert!(report.folder.join(format!("figures/{name}.svg")).exists());
    }
    let peak = |name: &str| report.summary.results[name]["peak_acceleration"].as_f64().unwrap();
    assert!((peak("film") / peak("ensubs") - 1.0).abs() < 1e-3, "{} {}", peak("film"), peak("ensubs"));
}

/// Arrays lie on one time axis from the start to the end of the march, with the prescribed positions.
#[test]
fn samples_follow_the_motion() {
    let (_folder, report) = studied(&march("ensubs", "method = \"ensubs\"\nsignal = \"T.y.velocity\""));
    let dataset = StudyFolder::open(&report.folder).unwrap().read_dataset("ensubs").unwrap();
    let values = |name: &str| match &dataset.variable(name).unwrap().data {
        judder_store::VariableValues::F64(values) => values.clone(),
        _ => panic!("{name}"),
    };
    let (time, position) = (values("time"), values("position"));
    assert!(time.windows(2).all(|t| t[1] > t[0]) && time[0] >= 0.0);
    let end = 8.5e-3 / 0.3 + 2e-3;
    assert!((time[time.len() - 1] - end).abs() < 1e-5);
    for (time, position) in time.iter().zip(&position).filter(|(time, _)| **time > 4e-3) {
        assert!((position - (0.09 + 0.3 * (time - 2e-3))).abs() < 1e-12);
    }
    // of what the contact does every so many-th step is kept, shares as of all steps
    let told = &report.summary.results["ensubs"];
    let states = match &dataset.variable("state").unwrap().data {
        judder_store::VariableValues::U8(codes) => codes.clone(),
        _ => panic!("state"),
    };
    let settled = values("state_time").partition_point(|time| *time <= told["settled_s"].as_f64().unwrap());
    let after = &states[settled..];
    let keys = ["stick_steps", "slip_steps", "reversed_steps", "open_steps"];
    let counts = keys.map(|key| told[key].as_f64().unwrap());
    for (code, count) in (0..).zip(counts) {
        let kept = after.iter().filter(|state| **state == code).count() as f64 / after.len() as f64;
        assert!((kept - count / counts.iter().sum::<f64>()).abs() < 0.01, "{code}: {kept} {counts:?}");
    }
    // the velocity is the slope of what the acceleration is the slope of: trapezoids between samples
    let (acceleration, velocity) = (values("T.y"), values("T.y.velocity"));
    let step = time[1] - time[0];
    let mut sum = 0.0;
    let largest = velocity.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    for k in 1..time.len() {
        sum += 0.5 * step * (acceleration[k - 1] + acceleration[k]);
        assert!((sum - velocity[k]).abs() < 0.02 * largest, "{k}: {sum} {}", velocity[k]);
    }
}

/// The force of the last step is left out of the geometry: another march, by an error of second order in the step.
#[test]
fn the_printed_predictor_is_asked_for() {
    let step = "step = \"3e-7 s\"";
    let analyses: String = [("printed", "ensubs"), ("with-force", "ensubs"), ("printed", "film")]
        .map(|(predictor, method)| {
            let settings = format!("method = \"{method}\"\npredictor = \"{predictor}\"\n{step}");
            march(&format!("{method}-{predictor}"), &settings)
        })
        .concat();
    let (_folder, report) = studied(&analyses);
    let peak = |name: &str| report.summary.results[name]["peak_acceleration"].as_f64().unwrap();
    let (printed, own) = (peak("ensubs-printed"), peak("ensubs-with-force"));
    assert!(printed != own && (printed / own - 1.0).abs() < 0.1, "{printed} {own}");
    assert!((peak("film-printed") / printed - 1.0).abs() < 1e-3, "{} {printed}", peak("film-printed"));
    assert_eq!(report.summary.results["film-printed"]["predictor"], "printed");
}

#[test]
fn an_interrupted_march_goes_on_to_the_bit() {
    let analyses = march("film", "method = \"film\"");
    let (_whole, report) = studied(&analyses);
    let whole = contents(&report.folder.join("results.zarr"));
    let folder = TempDir::new().unwrap();
    let study = folder.path().join("study");
    for at in [2, 7, 1] {
        let stopping = Stopping::at(at);
        let stopped = run(&case(&analyses), &study, &RunOptions::default(), &stopping);
        assert!(matches!(stopped, Err(StudyError::Interrupted)), "{stopped:?}");
        assert!(study.join(".stream-film").exists());
    }
    let report = run(&case(&analyses), &study, &RunOptions::default(), &Silent).unwrap();
    assert!(report.complete && !study.join(".stream-film").exists());
    assert!(whole == contents(&study.join("results.zarr")));
}

/// The blow-up is provoked by friction that locks: c·M⁻¹e ≤ 0.
#[test]
fn a_march_that_fails_keeps_what_it_had() {
    let text = format!("{PAIR}\n{}", march("ensubs", "method = \"ensubs\""))
        .replace("friction_coefficient = 0.3", "friction_coefficient = 5.0")
        // so fast that it locks before what grows on the way there has grown
        .replace("friction = \"4 ms\"", "friction = \"0.1 ms\"");
    let file = judder_models::parse("case.toml", &text, &[]).unwrap();
    let folder = TempDir::new().unwrap();
    let report = run(&file, &folder.path().join("study"), &RunOptions::default(), &Silent).unwrap();
    assert!(!report.complete);
    let ended = &report.summary.results["ensubs"]["ended"];
    let time = ended["time_s"].as_f64().unwrap();
    assert!(time > 0.0 && time < 4e-3, "{ended}");
    assert!(ended["reason"].as_str().unwrap().contains("sprag-slip"), "{ended}");
    assert!(report.messages.iter().any(|message| message.contains("before the end of its path")));
    let dataset = StudyFolder::open(&report.folder).unwrap().read_dataset("ensubs").unwrap();
    assert!(dataset.dimension_length("time").unwrap() > 10);
}

#[test]
fn a_step_over_the_limit_is_refused() {
    let (_folder, report) = studied(&march("ensubs", "method = \"ensubs\"\nstep = \"2 us\""));
    assert!(!report.complete);
    let refused = report.refused[0].error.to_string();
    assert!(refused.contains("above the limit of stability"), "{refused}");
}

#[test]
fn a_spectrogram_shows_a_march_and_follows_its_changes() {
    let text = |step: &str| {
        march("ensubs", &format!("method = \"ensubs\"\nstep = \"{step}\""))
            + "[[analysis]]\nname = \"levels\"\nkind = \"spectrogram\"\nof = \"ensubs\"\nlength = \"2 ms\"\n"
    };
    let (folder, report) = studied(&text("3e-7 s"));
    assert!(report.complete, "{:?}", report.messages);
    let told = &report.summary.results["levels"];
    assert!(told["windows"].as_u64().unwrap() > 10);
    assert_eq!(told["reference"], "1e-6 m/s^2");
    // a window of 2 ms has lines 500 Hz apart, but for the whole number of its samples
    assert!((told["resolution_hz"].as_f64().unwrap() - 500.0).abs() < 1.0);
    let study = folder.path().join("study");
    let again = run(&case(&text("3e-7 s")), &study, &RunOptions::default(), &Silent).unwrap();
    assert_eq!(again.skipped, ["ensubs", "levels"]);
    let changed = run(&case(&text("2.5e-7 s")), &study, &RunOptions::default(), &Silent).unwrap();
    assert!(changed.skipped.is_empty() && changed.complete, "{:?}", changed.skipped);
    // a spectrum of the waterfall is a line; the first panel is the map
    let lines = |waterfall: &str| {
        let text = text("2.5e-7 s") + waterfall;
        let report = run(&case(&text), &study, &RunOptions::default(), &Silent).unwrap();
        assert_eq!(report.skipped, ["ensubs"]);
        let dataset = StudyFolder::open(&study).unwrap().read_dataset("levels").unwrap();
        MODEL.panels(&dataset).unwrap().get(1).map_or(0, |panel| panel.layers.len())
    };
    let seven = lines("waterfall = 7\n");
    assert_eq!((seven, lines("waterfall = 8\n"), lines("waterfall = 0\n")), (7, 8, 0));
}

#[test]
fn a_spectrogram_of_what_is_not_there_says_so() {
    let analyses = march("ensubs", "method = \"ensubs\"")
        + "[[analysis]]\nname = \"levels\"\nkind = \"spectrogram\"\nof = \"ensubs\"\n";
    let folder = TempDir::new().unwrap();
    let only = RunOptions { only: vec!["levels".to_owned()], fresh: false, ..RunOptions::default() };
    let report = run(&case(&analyses), &folder.path().join("study"), &only, &Silent).unwrap();
    assert!(!report.complete);
    let said = report.messages.join("\n");
    assert!(said.contains("`levels` takes the result of `ensubs`, which is not there"), "{said}");
}

/// A displacement's slope is the velocity; differences over two samples lose a tenth of it at the end of the pass band. Nothing but what is
/// asked for is kept or heard.
#[test]
fn velocities_and_displacements_are_kept_on_request() {
    let all = "method = \"ensubs\"\nsignals = { quantities = [\"displacement\", \"acceleration\", \"velocity\"] }\n";
    let analyses = march("all", &format!("{all}sound = [\"T.y.displacement\", \"normal-force\"]"))
        + &march(
            "velocity",
            "method = \"ensubs\"\nsignals = { quantities = [\"velocity\"] }\nsignal = \"normal-force\"",
        )
        + &march("usual", "method = \"ensubs\"\nsound = false");
    let (_folder, report) = studied(&analyses);
    assert!(report.complete, "{:?}", report.messages);
    let study = StudyFolder::open(&report.folder).unwrap();
    let names = |analysis: &str| -> Vec<String> {
        let dataset = study.read_dataset(analysis).unwrap();
        let points = dataset.variables().iter().filter(|variable| variable.name.starts_with("T."));
        points.map(|variable| format!("{} {}", variable.name, variable.units)).collect()
    };
    let mut found = names("all");
    found.sort();
    let expected = ["T.x", "T.y"].map(|axis| {
        [format!("{axis} m/s^2"), format!("{axis}.displacement m"), format!("{axis}.velocity m/s")]
    });
    assert_eq!(found, expected.concat());
    assert_eq!(names("velocity"), ["T.x.velocity m/s", "T.y.velocity m/s"]);
    assert_eq!(names("usual"), ["T.x m/s^2", "T.y m/s^2"]);
    let heard = |analysis: &str| match report.summary.results[analysis].get("sound") {
        Some(sounds) => sounds.as_array().unwrap().iter().map(|sound| sound["file"].clone()).collect(),
        None => Vec::new(),
    };
    assert_eq!(heard("all"), ["all-T.y.displacement.wav", "all-normal-force.wav"]);
    assert_eq!(heard("velocity"), ["velocity-normal-force.wav"]);
    assert!(heard("usual").is_empty());
    let dataset = study.read_dataset("all").unwrap();
    let values = |name: &str| match &dataset.variable(name).unwrap().data {
        judder_store::VariableValues::F64(values) => values.clone(),
        _ => panic!("{name}"),
    };
    let (time, moved, velocity) = (values("time"), values("T.y.displacement"), values("T.y.velocity"));
    let largest = velocity.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    assert!(largest > 0.0);
    for k in 1..time.len() - 1 {
        let slope = (moved[k + 1] - moved[k - 1]) / (time[k + 1] - time[k - 1]);
        assert!((slope - velocity[k]).abs() < 0.15 * largest, "{k}: {slope} {}", velocity[k]);
    }
}

/// The gain that is told is that of the file: its largest sample is 1 dB below full scale.
#[test]
fn sounds_tell_their_gain() {
    let (_folder, report) = studied(&march("ensubs", "method = \"ensubs\""));
    let sounds = report.summary.results["ensubs"]["sound"].as_array().unwrap();
    let sound: &Value = sounds.iter().find(|sound| sound["signal"] == "T.y").unwrap();
    assert_eq!(sound["sample_rate"], 48_000);
    let bytes = fs::read(report.folder.join(sound["file"].as_str().unwrap())).unwrap();
    assert_eq!(&bytes[..4], b"RIFF");
    assert!(sound["gain"].as_f64().unwrap() > 0.0);
}

/// A case of the pair that observes these points.
fn observing(points: &str) -> Result<RunReport, StudyError> {
    let own = "points = [{ name = \"T\", structure = \"horizontal\", set = \"end-upper\" }]";
    assert!(PAIR.contains(own));
    let text = format!(
        "{}\n{}",
        PAIR.replace(own, &format!("points = [{points}]")),
        march("m", "method = \"ensubs\"")
    );
    let folder = TempDir::new().unwrap();
    let file = judder_models::parse("case.toml", &text, &[]).unwrap();
    run(&file, &folder.path().join("study"), &RunOptions::default(), &Silent)
}

/// Any node can be observed by its place; the corner by its place is the corner by its name.
#[test]
fn points_go_by_their_place_too() {
    let peak = |points: &str| {
        let report = observing(points).unwrap();
        assert!(report.complete, "{:?}", report.messages);
        report.summary.results["m"]["peak_acceleration"].as_f64().unwrap()
    };
    let named = peak("{ name = \"T\", structure = \"horizontal\", set = \"end-upper\" }");
    let placed = |at: &str| peak(&format!("{{ name = \"T\", structure = \"horizontal\", at = {at} }}"));
    assert_eq!(placed("[\"100 mm\", \"1 mm\"]"), named);
    assert_eq!(placed("[\"99 mm\", \"0.8 mm\"]"), named);
    assert_ne!(placed("[\"50 mm\", \"1 mm\"]"), named);
}

#[test]
fn points_that_cannot_be_observed() {
    let told = |points: &str| observing(points).unwrap_err().to_string();
    let nowhere = told("{ name = \"T\", structure = \"horizontal\", at = [\"100 m\", \"1 mm\"] }");
    assert!(nowhere.contains("`observe.points.T.at` is (100, 0.001) m, but the nearest node"), "{nowhere}");
    let many: Vec<String> = (0..7)
        .map(|k| format!("{{ name = \"P{k}\", structure = \"horizontal\", at = [\"{k}0 mm\", \"1 mm\"] }}"))
        .collect();
    let many = told(&many.join(", "));
    assert_eq!(many, "7 points of `horizontal` are observed, but a march watches 6 of it at most");
}
