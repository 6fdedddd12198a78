//! Cycles that begin at one that another study has stored.

use crate::{number, run_into};
use judder_keys::error::CaseError;
use judder_store::StudyFolder;
use judder_study::Silent;
use judder_study::case::file::CaseFile;
use judder_study::run::{RunOptions, RunReport, run};
use serde_json::Value;
use std::path::{Path, PathBuf};

/// The small block with one analysis, in a file of a folder.
fn block(folder: &Path, name: &str, analysis: &str, set: &[&str]) -> Result<CaseFile, Box<CaseError>> {
    let small = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/small/assembly-cycle.toml");
    let text = std::fs::read_to_string(small).unwrap();
    let bodies = text.split("[[analysis]]").next().unwrap();
    let path = folder.join(format!("{name}.toml"));
    std::fs::write(&path, format!("{bodies}[[analysis]]\nname = \"own\"\n{analysis}\n")).unwrap();
    let set: Vec<String> = set.iter().map(|own| (*own).to_owned()).collect();
    judder_models::read(path.to_str().unwrap(), &set).map_err(Box::new)
}

/// An analysis of it, in a folder.
fn first_of(folder: &Path, study: &str, analysis: &str) -> RunReport {
    run_into(&folder.join(study), &block(folder, study, analysis, &[]).unwrap(), &["own"])
}

/// Its cycle with so many harmonics, in the folder `first`.
fn first(folder: &Path, harmonics: usize) -> (PathBuf, Value) {
    let study = folder.join("first");
    let file = block(folder, "first", &format!("kind = \"limit-cycle\"\nharmonics = {harmonics}"), &[]);
    let report = run_into(&study, &file.unwrap(), &["own"]);
    assert!(report.complete, "{:?}", report.messages);
    (study, Value::Object(report.summary.results["own"].clone()))
}

const START: &str = "start = { study = \"first\", analysis = \"own\" }";

fn started(folder: &Path, lines: &str, set: &[&str]) -> Result<RunReport, String> {
    let file = block(folder, "second", &format!("{lines}\n{START}"), set).map_err(|own| own.to_string())?;
    run(&file, &folder.join("second"), &RunOptions::default(), &Silent).map_err(|own| own.to_string())
}

/// Where nothing has changed there is nothing to do: all that is told and stored is as it was, but for rounding.
#[test]
fn a_cycle_begins_at_itself() {
    let folder = tempfile::tempdir().unwrap();
    let (study, expected) = first(folder.path(), 15);
    let report = started(folder.path(), "kind = \"limit-cycle\"\nharmonics = 15", &[]).unwrap();
    assert!(report.complete, "{:?}", report.messages);
    let told = &report.summary.results["own"];
    let close = |a: &Value, b: &Value| (number(a) / number(b) - 1.0).abs() < 1e-10;
    for key in ["frequency_hz", "normal_force_mean", "friction_force_mean", "left_out", "between_samples"] {
        assert!(close(&told[key], &expected[key]), "{key}: {} {}", told[key], expected[key]);
    }
    assert!(close(
        &told["levels"]["edge.y"]["acceleration_rms"],
        &expected["levels"]["edge.y"]["acceleration_rms"]
    ));
    // the phase too
    let [own, stored] = [folder.path().join("second"), study].map(|folder| {
        let dataset = StudyFolder::open(folder).unwrap().read_dataset("own").unwrap();
        super::cycles::array(&dataset, "point_friction_force")
    });
    let largest = stored.iter().fold(0.0_f64, |most, own| most.max(own.abs()));
    assert!(own.iter().zip(&stored).all(|(a, b)| (a - b).abs() < 1e-10 * largest));
    // no mode was followed
    assert!(told["motions"] == 0 && told["amplitude"].is_null() && told["attracts"].is_null());
}

/// With other harmonics it is the cycle that the mode leads to with as many; with another friction that of this friction.
#[test]
fn a_cycle_goes_on_with_other_harmonics_and_keys() {
    let folder = tempfile::tempdir().unwrap();
    let (_, coarse) = first(folder.path(), 5);
    let friction = "contact.sole.friction_coefficient=0.42";
    for (harmonics, set) in [(15, &[][..]), (3, &[]), (9, &[friction])] {
        let lines = format!("kind = \"limit-cycle\"\nharmonics = {harmonics}");
        let report = started(folder.path(), &lines, set).unwrap();
        let told = &report.summary.results["own"];
        assert!(report.complete && told["harmonics"] == harmonics, "{:?}", report.messages);
        let of_mode = block(folder.path(), "third", &lines, set).unwrap();
        let of_mode = run_into(&folder.path().join("third"), &of_mode, &["own"]);
        let expected = &of_mode.summary.results["own"];
        let off = number(&told["frequency_hz"]) / number(&expected["frequency_hz"]) - 1.0;
        // what is left out is weighed at another frequency
        assert!(off.abs() < 1e-4, "{harmonics}: {off}");
        assert!(told["frequency_hz"] != coarse["frequency_hz"]);
    }
    let branch = "kind = \"bifurcation\"\nsweep = { key = \"contact.sole.friction_coefficient\", from = 0.4, to = 0.42, points = 2 }\nharmonics = 5\ncycles = 2\nstability = false";
    let report = started(folder.path(), branch, &[]).unwrap();
    assert!(number(&report.summary.results["own"]["rms"][0]) > 0.0, "{:?}", report.messages);
}

/// What the file holds is part of what is asked: the same file computes nothing again, another one does.
#[test]
fn a_cycle_depends_on_the_study_that_it_begins_at() {
    let folder = tempfile::tempdir().unwrap();
    first(folder.path(), 5);
    let lines = "kind = \"limit-cycle\"\nharmonics = 5";
    let hash = || started(folder.path(), lines, &[]).unwrap().summary.analyses["own"].hash.clone();
    let before = hash();
    assert_eq!(before, hash());
    first(folder.path(), 7);
    assert_ne!(before, hash());
}

#[test]
fn studies_without_a_cycle_to_begin_at() {
    let folder = tempfile::tempdir().unwrap();
    let lines = "kind = \"limit-cycle\"\nharmonics = 5";
    let refused = |lines: &str, set: &[&str], start: &str| -> String {
        let file = match block(folder.path(), "second", &format!("{lines}\nstart = {start}"), set) {
            Err(error) => return error.to_string(),
            Ok(file) => file,
        };
        let options = RunOptions::default();
        run(&file, &folder.path().join("second"), &options, &Silent).unwrap_err().to_string()
    };
    let there = "{ study = \"first\", analysis = \"own\" }";
    let place = folder.path().join("first");
    let place = place.display();
    let missing = refused(lines, &[], there);
    assert_eq!(missing, format!("`start.study` names `{place}`, which does not exist"));
    std::fs::create_dir(folder.path().join("first")).unwrap();
    let foreign = refused(lines, &[], there);
    assert_eq!(foreign, format!("`start.study` names `{place}`, which is a folder, not that of a study"));

    let (study, _) = first(folder.path(), 5);
    let other = refused(lines, &[], "{ study = \"first\", analysis = \"cycle\" }");
    assert_eq!(other, "the study `first` has no results of `cycle`, but of `own`");
    let both = refused(lines, &[], "{ study = \"first\", analysis = \"own\", march = { step = \"1 us\" } }");
    assert_eq!(both, "`start.study` together with `start.march`: both say the same thing");
    let none = refused(lines, &[], "{ }");
    assert_eq!(none, "`start` lacks the key `march`");
    let half = refused(lines, &[], "{ study = \"first\" }");
    assert_eq!(half, "`start` lacks the key `analysis`");
    let foot = refused(lines, &["structure.foot.block.cells=[6, 2]"], there);
    assert_eq!(
        foot,
        "the stored cycle is one of other contact points: 5 of `sole`, in the plane; the case has 7 of `sole`, in the plane"
    );

    // an analysis of another kind, and one that has found nothing
    let none = first_of(folder.path(), "none", "kind = \"limit-cycle\"\nlargest_amplitude = 0.6");
    assert!(!none.complete);
    let steady = first_of(folder.path(), "steady", "kind = \"steady-sliding\"");
    assert!(steady.complete);
    for (study, expected) in [
        ("none", "`own` of the study has found no cycle, or is not one of an assembly"),
        (
            "steady",
            "`own` of the study is a `steady-sliding`: a cycle begins at one that a `limit-cycle` has found",
        ),
    ] {
        assert_eq!(refused(lines, &[], &format!("{{ study = \"{study}\", analysis = \"own\" }}")), expected);
    }
    let branch = "kind = \"bifurcation\"\nsweep = { key = \"contact.sole.friction_coefficient\", from = 0.4, to = 0.42, points = 2 }";
    assert_eq!(refused(branch, &["structure.foot.block.cells=[6, 2]"], there), foot);

    // damaged, cut short, without a part, without what its group is
    let group = study.join("results.zarr/own");
    let forces = group.join("point_force_harmonics");
    let chunk = files(&forces).into_iter().find(|own| !own.ends_with("zarr.json")).unwrap();
    let whole = std::fs::read(&chunk).unwrap();
    let mut flipped = whole.clone();
    flipped[whole.len() / 2] ^= 1;
    let told = |part: &str, what: &str| {
        format!(
            "the study `first` at which the cycle begins is damaged: `results.zarr/own/point_force_harmonics{part}` cannot be read ({what}); \
             run the case of that study again with `-o {place}`, or name another study"
        )
    };
    let part = format!("/{}", chunk.strip_prefix(&forces).unwrap().display());
    std::fs::write(&chunk, &flipped).unwrap();
    assert_eq!(refused(lines, &[], there), told(&part, "its content is not what was written"));
    // without a manifest only the parts themselves say so
    std::fs::remove_file(study.join("manifest.json")).unwrap();
    for damaged in [&flipped[..], &whole[..whole.len() / 2]] {
        std::fs::write(&chunk, damaged).unwrap();
        assert_eq!(refused(lines, &[], there), told("", "the checksum is invalid"));
    }
    std::fs::remove_file(&chunk).unwrap();
    let missing = refused(lines, &[], there);
    assert!(
        missing.contains("cannot be read (a part is missing: ") && missing.contains("`first`"),
        "{missing}"
    );
    std::fs::write(&chunk, &whole).unwrap();
    std::fs::write(group.join("zarr.json"), "{}").unwrap();
    let bare = refused(lines, &[], there);
    assert!(
        bare.contains("`results.zarr/own` cannot be read (its metadata do not list its arrays)"),
        "{bare}"
    );
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap().map(|own| own.unwrap().path());
    entries.flat_map(|path| if path.is_dir() { files(&path) } else { vec![path] }).collect()
}
