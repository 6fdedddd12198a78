//! Marches of assemblies that are interrupted, killed, and too large.

use crate::case;
use crate::march::contents;
use crate::stopping::Stopping;
use judder_models::parse;
use judder_store::StudyFolder;
use judder_study::case::file::CaseFile;
use judder_study::run::{RunOptions, RunReport, run};
use judder_study::{Silent, StudyError};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};
use std::{env, fs, thread};

const CHILD_FOLDER: &str = "JUDDER_TEST_KILLED_MARCH";

/// 40 000 steps of a block that rattles, one sample in 25 of its signals, by one scheme.
fn rattling(name: &str) -> CaseFile {
    let set = ["duration=\"4 ms\"", "transient=\"0.5 ms\"", "checkpoint_steps=1500"];
    let set = set.map(|own| format!("analysis.{name}.{own}"));
    case("assembly/block-in-motion.toml", &set.each_ref().map(String::as_str))
}

fn only(name: &str) -> RunOptions {
    RunOptions { only: vec![name.to_owned()], ..RunOptions::default() }
}

fn run_only(name: &str, study: &Path) -> RunReport {
    run(&rattling(name), study, &only(name), &Silent).unwrap()
}

/// Arrays and sounds of a study.
pub(super) fn left(study: &Path) -> Vec<(PathBuf, Vec<u8>)> {
    let all = contents(study).into_iter();
    all.filter(|(path, _)| {
        path.starts_with("results.zarr") || path.extension().is_some_and(|own| own == "wav")
    })
    .collect()
}

/// What the summary says, but for the time on the wall.
fn told(report: &RunReport, name: &str) -> serde_json::Map<String, serde_json::Value> {
    let mut told = report.summary.results[name].clone();
    told.remove("seconds");
    told
}

#[test]
fn an_interrupted_march_goes_on_to_the_bit() {
    for name in ["implicit", "explicit"] {
        let folder = tempfile::tempdir().unwrap();
        let whole = run_only(name, &folder.path().join("whole"));
        assert!(whole.complete, "{:?}", whole.messages);
        let study = folder.path().join("study");
        for at in [2, 5, 1] {
            let stopped = run(&rattling(name), &study, &only(name), &Stopping::at(at));
            assert!(matches!(stopped, Err(StudyError::Interrupted)), "{stopped:?}");
            assert!(study.join(format!(".stream-{name}")).exists());
        }
        let cut = run_only(name, &study);
        assert!(cut.complete && !study.join(format!(".stream-{name}")).exists());
        assert_eq!(told(&cut, name), told(&whole, name));
        let (cut, whole) = (left(&study), left(&folder.path().join("whole")));
        assert!(whole.iter().any(|(path, _)| path.ends_with(format!("{name}-edge.y.wav"))));
        assert!(cut == whole);
    }
}

/// Kills a process that marches, at various moments after it has kept a state, and goes on from what it left.
#[test]
fn a_killed_march_goes_on_to_the_bit() {
    let folder = tempfile::tempdir().unwrap();
    let (study, whole) = (folder.path().join("study"), folder.path().join("whole"));
    let told_whole = told(&run_only("implicit", &whole), "implicit");
    let checkpoint = study.join(".stream-implicit/checkpoint");
    let kept = || fs::read(&checkpoint).unwrap_or_default();
    for moment in 0..4 {
        let before = kept();
        let mut child = Command::new(env::current_exe().unwrap())
            .args(["--exact", "assembly::marches::until_killed", "--ignored"])
            .env(CHILD_FOLDER, &study)
            .stdout(Stdio::null())
            .spawn()
            .unwrap();
        let waited = Instant::now();
        while kept() == before && waited.elapsed() < Duration::from_secs(60) {
            thread::sleep(Duration::from_millis(1));
        }
        thread::sleep(Duration::from_millis(3 * moment));
        assert!(child.try_wait().unwrap().is_none(), "the child ended by itself");
        child.kill().unwrap();
        child.wait().unwrap();
        assert!(!study.join("results.zarr/implicit").exists());
    }
    let cut = run_only("implicit", &study);
    assert_eq!(told(&cut, "implicit"), told_whole);
    assert!(left(&study) == left(&whole));
}

#[test]
#[ignore = "run and killed by a_killed_march_goes_on_to_the_bit"]
fn until_killed() {
    let Some(folder) = env::var_os(CHILD_FOLDER) else { return };
    run_only("implicit", Path::new(&folder));
}

/// A march that cannot go on keeps what it has: where a point runs off its track, and where the motion leaves the numbers, before its transient is over.
#[test]
fn a_march_that_ends_early_keeps_what_it_has() {
    // the force throws the sole off an end of the rail
    let force = "[{structure=\"sole\", set=\"y-min\", direction=\"x\", force={amplitude=\"3 kN\", frequency=\"102.27 Hz\"}}]";
    let force = format!("analysis.ride.forces={force}");
    let ride = case("assembly/sole-along-rail.toml", &["analysis.ride.step=\"4 us\"", force.as_str()]);
    let growing = parse("case.toml", GROWING, &[]).unwrap();
    for (file, name, reason, [least, most]) in [
        (&ride, "ride", "of interface `face` has run off the track", [1e-3, 0.08]),
        (&growing, "m", "the motion is no longer finite after", [0.3, 0.5]),
    ] {
        let folder = tempfile::tempdir().unwrap();
        let report = run(file, folder.path(), &only(name), &Silent).unwrap();
        assert!(report.summary.results.contains_key(name), "{:?} {:?}", report.refused, report.messages);
        let ended = &told(&report, name)["ended"];
        assert!(ended["reason"].as_str().unwrap().contains(reason), "{ended}");
        let time = ended["time_s"].as_f64().unwrap();
        assert!(time > least && time < most, "{time}");
        assert!(!report.complete && report.messages.iter().any(|own| own.contains("before its duration")));
        assert!(!folder.path().join(format!(".stream-{name}")).exists());
        let kept = StudyFolder::open(folder.path()).unwrap().read_dataset(name).unwrap();
        let times = kept.variable("time").unwrap().shape[0];
        assert!(times > 100 && kept.attributes()["ended"].as_str().unwrap().contains(reason), "{times}");
        assert!(folder.path().join("report.html").exists());
    }
}

/// A mass that its damper drives.
const GROWING: &str = r#"
title = "growing"
model = "assembly"

[[structure]]
name = "mass"
matrices = { mass = [[1]], damping = [[-2000]], stiffness = [[1e4]], freedoms = [["mass", "x"]] }

[observe]
points = [{ name = "mass", structure = "mass", set = "mass" }]

[[analysis]]
name = "m"
kind = "march"
step = "1e-5 s"
duration = "1 s"
transient = "0.9 s"
start = { velocity = [1, 0] }
"#;

/// Points of the sole that rise and are held within a step are given energy with θ = ½, and none with θ = 1, where the scheme takes some.
#[test]
fn contact_gives_no_energy_where_forces_are_taken_late() {
    let told = [None, Some("1.0")].map(|implicitness| {
        let theta = implicitness.map(|own| format!("analysis.ride.implicitness={own}"));
        let set: Vec<&str> = std::iter::once("analysis.ride.step=\"4 us\"").chain(theta.as_deref()).collect();
        let folder = tempfile::tempdir().unwrap();
        let report =
            run(&case("assembly/sole-along-rail.toml", &set), folder.path(), &only("ride"), &Silent).unwrap();
        assert!(told(&report, "ride")["energy_balance"].as_f64().unwrap() < 1e-10);
        let power = told(&report, "ride")["power"].clone();
        (power, report.messages)
    });
    let [(early, of_early), (late, of_late)] = &told;
    let number = |power: &serde_json::Value, key: &str| power[key].as_f64().unwrap();
    assert!(number(early, "impacts") > 0.1 && early.get("scheme").is_none(), "{early}");
    assert!(number(late, "impacts").abs() < 1e-12 && number(late, "scheme") < 0.0, "{late}");
    let gives = |messages: &[String]| messages.iter().filter(|own| own.contains("rigid contact")).count();
    assert!(
        gives(of_early) == 2 && of_early.iter().any(|own| own.contains("`implicitness`")),
        "{of_early:?}"
    );
    assert_eq!(gives(of_late), 0);
}

/// What is kept is looked at as a whole in the end: too much is refused beforehand, at its key.
#[test]
fn a_march_that_no_memory_holds_is_refused() {
    let file = case(
        "assembly/block-in-motion.toml",
        &["analysis.implicit.duration=\"1000 s\"", "analysis.implicit.step=\"1e-6 s\""],
    );
    let folder = tempfile::tempdir().unwrap();
    let marched = || run(&file, folder.path(), &only("implicit"), &Silent);
    let refused = crate::with_little_memory(marched).unwrap_err().to_string();
    assert!(
        refused.contains("5.000e8 samples") && refused.contains(" of memory are needed, and "),
        "{refused}"
    );
}

/// The highest level of a spectrogram is at a line that the march tells; what it names must be there.
#[test]
fn a_spectrogram_shows_a_march() {
    let folder = tempfile::tempdir().unwrap();
    let set = |signal: &str| {
        let own = ["analysis.implicit.duration=\"4 ms\"", "analysis.implicit.transient=\"2 ms\"", signal];
        case("assembly/block-in-motion.toml", &own)
    };
    let options =
        RunOptions { only: vec!["implicit".to_owned(), "levels".to_owned()], ..RunOptions::default() };
    let of = |signal: &str| run(&set(signal), folder.path(), &options, &Silent);
    let report = of("analysis.levels.signal=\"edge.x.velocity\"").unwrap();
    assert!(report.complete, "{:?}", report.messages);
    let told = &report.summary.results["levels"];
    let number = |key: &str| told[key].as_f64().unwrap();
    assert!(number("windows") >= 20.0 && told["reference"] == "1e-9 m/s");
    assert!(number("resolution_hz") < 2010.0 && number("peak_frequency_hz") <= 160e3);
    assert!(!told.contains_key("peak_position_m"));
    let forces = of("analysis.levels.signal=\"sole.normal_force\"").unwrap();
    assert_eq!(forces.skipped, ["implicit"]);
    assert_eq!(forces.summary.results["levels"]["reference"], "1e-6 N");
    let unknown = of("analysis.levels.signal=\"edge.z\"").unwrap_err().to_string();
    assert!(unknown.contains("edge.z"), "{unknown}");
    let march = case("assembly/block-in-motion.toml", &[]);
    let text = march.text.replace("of = \"implicit\"", "of = \"explicit\"");
    let refused = judder_models::parse("case.toml", &text, &[]).unwrap_err().to_string();
    assert!(refused.contains("explicit"), "{refused}");
}
