//! Finished studies that were damaged afterwards: what `verify` finds, what `run` and `report` make of them.

mod mutated;

use judder_store::{Finding, StoreError, verify};
use judder_study::Silent;
use judder_study::StudyError;
use judder_study::case::file::CaseFile;
use judder_study::report::stored;
use judder_study::run::{RunOptions, RunReport, run};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// Two analyses, a sound, a sweep of three chunks.
const CASE: &str = r#"
model = "oscillator"
[contact]
shear_strength = "40 kPa"
[substrate]
rubbery_modulus = "1 MPa"
glassy_modulus = "10 MPa"
retardation_time = "5 ms"
[operation]
velocity = "5 mm/s"
normal_load = "0.2 N"
[[analysis]]
name = "spectrum"
kind = "spectrum"
sweep = { key = "operation.velocity", from = "1 mm/s", to = "1 m/s", points = 4, scale = "log" }
[[analysis]]
name = "motion"
kind = "motion"
duration = "0.2 s"
points = 64
sound = true
[[sweep]]
name = "speeds"
over = [{ key = "operation.velocity", from = "1 mm/s", to = "1 m/s", points = 6, scale = "log" }]
quantities = ["growth_rate", "verdict"]
chunk = 2
"#;

fn case() -> CaseFile {
    judder_models::parse("case.toml", CASE, &[]).unwrap()
}

fn run_in(folder: &Path) -> RunReport {
    // figures and page are drawn anew by every run
    let options = RunOptions { without_report: true, ..RunOptions::default() };
    run(&case(), folder, &options, &Silent).unwrap()
}

fn all(_: &str, _: u64) -> bool {
    true
}

/// The files of a study by their paths in it, but for its lock.
fn contents(study: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let (mut found, mut folders) = (BTreeMap::new(), vec![study.to_owned()]);
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if !path.ends_with(".judder.lock") {
                found.insert(path.strip_prefix(study).unwrap().to_owned(), fs::read(&path).unwrap());
            }
        }
    }
    found
}

fn written(study: &Path, files: &BTreeMap<PathBuf, Vec<u8>>) {
    for (path, content) in files {
        let path = study.join(path);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, content).unwrap();
    }
    fs::write(study.join(".judder.lock"), "").unwrap();
}

/// A content with one of its digits another, so that JSON stays JSON; with another byte where it has none.
fn other_number(content: &[u8], seed: usize) -> Vec<u8> {
    let mut changed = content.to_vec();
    let digits: Vec<usize> = (0..content.len()).filter(|k| content[*k].is_ascii_digit()).collect();
    match digits.get(seed % digits.len().max(1)) {
        Some(place) => changed[*place] = if content[*place] == b'7' { b'3' } else { b'7' },
        None => changed[seed % content.len()] ^= 1,
    }
    changed
}

/// A file as it is after an accident; none where it is gone.
fn damaged(files: &BTreeMap<PathBuf, Vec<u8>>, path: &Path, how: usize) -> Option<Vec<u8>> {
    let content = &files[path];
    match how % 5 {
        0 => Some(other_number(content, how * 31 + content.len() / 2)),
        1 => Some(content[..content.len() / 2].to_vec()),
        2 => {
            let other = files.iter().find(|(other, own)| *other > path && own != &content);
            Some(other.map_or_else(Vec::new, |(_, own)| own.clone()))
        }
        3 => None,
        _ => Some(Vec::new()),
    }
}

/// Damages one file after another, as many as are left of every so many, each in so many ways.
fn tried(every: usize, ways: usize) {
    let study = FinishedStudy::new();
    for (index, path) in study.files.keys().enumerate().filter(|(index, _)| index % every == 0) {
        (index..index + ways).for_each(|way| study.try_damages(&[(path, way)]));
    }
}

/// Damages files two at a time, so many pairs that each file is in one: what is done for one damage must not hide another.
fn tried_in_pairs(rounds: usize) {
    let study = FinishedStudy::new();
    let paths: Vec<&PathBuf> = study.files.keys().collect();
    for round in 0..rounds {
        for (index, path) in paths.iter().enumerate().filter(|(index, _)| index % 2 == round % 2) {
            let other = paths[(index + 1 + 5 * round) % paths.len()];
            // without both nothing says that the folder is a study
            if [*path, other]
                .iter()
                .all(|own| own.ends_with("manifest.json") || own.ends_with("summary.json"))
            {
                continue;
            }
            study.try_damages(&[(path, index + round), (other, index + 3 * round)]);
        }
    }
}

/// A study that was run to its end, by the contents of its files.
struct FinishedStudy {
    files: BTreeMap<PathBuf, Vec<u8>>,
}

impl FinishedStudy {
    fn new() -> Self {
        let origin = tempfile::tempdir().unwrap();
        assert!(run_in(origin.path()).complete);
        let sound = verify(origin.path(), all).unwrap();
        assert!(sound.is_sound(), "{sound:?}");
        Self { files: contents(origin.path()) }
    }

    /// Damages files in a copy, each in a way: `verify` has to find them, and a run to compute what they are of again.
    fn try_damages(&self, damages: &[(&PathBuf, usize)]) {
        let what = format!("{damages:?}");
        let folder = tempfile::tempdir().unwrap();
        written(folder.path(), &self.files);
        for (path, way) in damages {
            let place = folder.path().join(path);
            match damaged(&self.files, path, *way) {
                Some(content) => fs::write(&place, content).unwrap(),
                None => fs::remove_file(&place).unwrap(),
            }
        }
        let found = verify(folder.path(), all);
        let is_found = |path: &Path| match &found {
            Ok(found) => found.findings.iter().any(|finding| Path::new(finding.path()) == path),
            Err(StoreError::NoManifest { .. } | StoreError::ManifestDamaged { .. }) => true,
            Err(_) => false,
        };
        assert!(damages.iter().all(|(path, _)| is_found(path)), "{what}: {found:?}");
        self.assert_mended(folder.path(), &what);
    }

    /// A run leaves the results as they were, and a sound study.
    fn assert_mended(&self, folder: &Path, what: &str) {
        let again = run_in(folder);
        assert!(again.complete, "{what}: {:?}", again.messages);
        let is_result = |path: &Path| {
            path.starts_with("results.zarr")
                || path.extension().is_some_and(|end| end == "csv" || end == "wav")
        };
        let now = contents(folder);
        for (own, expected) in self.files.iter().filter(|(own, _)| is_result(own)) {
            assert!(now.get(own) == Some(expected), "{what}: {} is another", own.display());
        }
        let found = verify(folder, all).unwrap();
        assert!(found.is_sound() && found.findings.is_empty(), "{what}: {found:?}");
        // as many as there were: nothing has fallen off the list
        assert_eq!(found.sound, now.len() - 1, "{what}");
    }
}

#[test]
fn what_is_damaged_is_found_and_computed_again_to_the_byte() {
    tried(3, 1);
}

#[test]
fn one_damage_hides_no_other() {
    tried_in_pairs(1);
}

#[test]
#[ignore = "minutes: every file in every way"]
fn every_file_in_every_way() {
    tried(1, 5);
    tried_in_pairs(20);
}

/// A chunk from a study of another case, and all of them under metadata of that case: damage of this study, whose list says what was written.
#[test]
fn chunks_of_another_case_are_computed_again() {
    let (study, other) = (FinishedStudy::new(), tempfile::tempdir().unwrap());
    let changed = CASE.replace("40 kPa", "41 kPa");
    let file = judder_models::parse("case.toml", &changed, &[]).unwrap();
    let options = RunOptions { without_report: true, ..RunOptions::default() };
    run(&file, other.path(), &options, &Silent).unwrap();
    let others = contents(other.path());
    let of_sweep = |path: &&PathBuf| path.starts_with("results.zarr/speeds");
    let chunks: Vec<&PathBuf> = study.files.keys().filter(|path| path.ends_with("values/c.1.0")).collect();
    assert_eq!(chunks.len(), 1);
    for taken in [chunks, study.files.keys().filter(of_sweep).collect()] {
        let folder = tempfile::tempdir().unwrap();
        written(folder.path(), &study.files);
        taken.iter().for_each(|path| fs::write(folder.path().join(path), &others[*path]).unwrap());
        study.assert_mended(folder.path(), "chunks of another case");
    }
}

/// A run was killed between storing an analysis and removing what that had kept.
#[test]
fn what_a_done_analysis_kept_while_it_ran_is_removed() {
    let study = FinishedStudy::new();
    let folder = tempfile::tempdir().unwrap();
    written(folder.path(), &study.files);
    fs::write(folder.path().join(".scratch-of-motion"), "kept").unwrap();
    fs::create_dir(folder.path().join(".stream-motion")).unwrap();
    study.assert_mended(folder.path(), "what was kept");
}

/// The arrays of one analysis are damaged: the other results stay, and the user is told.
#[test]
fn one_result_is_computed_again_and_the_others_stay() {
    let folder = tempfile::tempdir().unwrap();
    run_in(folder.path());
    let sound = folder.path().join("motion.wav");
    let sound = if sound.exists() {
        sound
    } else {
        contents(folder.path())
            .into_keys()
            .map(|own| folder.path().join(own))
            .find(|own| own.extension().is_some_and(|end| end == "wav"))
            .unwrap()
    };
    fs::remove_file(&sound).unwrap();
    let again = run_in(folder.path());
    assert!(sound.exists());
    assert_eq!(again.skipped, ["spectrum", "speeds"]);
    assert!(
        again.messages.iter().any(|line| line.starts_with("motion: is damaged and does not count")),
        "{:?}",
        again.messages
    );
    assert!(!run_in(folder.path()).messages.iter().any(|line| line.contains("is damaged")));
}

/// A number that was edited in the summary is not drawn.
#[test]
fn a_report_is_not_drawn_of_what_is_damaged() {
    let folder = tempfile::tempdir().unwrap();
    run_in(folder.path());
    stored(folder.path()).unwrap();
    let place = folder.path().join("summary.json");
    let text = fs::read_to_string(&place).unwrap();
    let edited = text.replacen("\"growth_rate\": [\n", "\"growth_rate\": [\n  1.0,\n", 1);
    assert_ne!(edited, text);
    fs::write(&place, edited).unwrap();
    let refused = stored(folder.path()).map(drop).unwrap_err();
    assert!(matches!(refused, StudyError::Store(StoreError::Damaged { .. })), "{refused}");
    fs::write(&place, text).unwrap();
    fs::remove_file(folder.path().join("manifest.json")).unwrap();
    let refused = stored(folder.path()).map(drop).unwrap_err();
    assert!(matches!(refused, StudyError::Store(StoreError::NoManifest { .. })), "{refused}");
    let findings = verify(folder.path(), all)
        .map(|found| found.findings.iter().any(|own| matches!(own, Finding::Extra { .. })));
    assert!(matches!(findings, Err(StoreError::NoManifest { .. })));
}

/// A run was killed while it stored an analysis that the case then lost: the next run says so once, and `verify` takes it for what was left.
#[test]
fn what_a_killed_run_left_of_an_analysis_that_is_gone_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let without = CASE.replace("name = \"spectrum\"", "name = \"others\"");
    let file = judder_models::parse("case.toml", &without, &[]).unwrap();
    let options = RunOptions { without_report: true, ..RunOptions::default() };
    run(&file, folder.path(), &options, &Silent).unwrap();
    // arrays that are whole, and on no list yet
    let others = contents(&folder.path().join("results.zarr/others"));
    written(&folder.path().join("results.zarr/spectrum"), &others);
    fs::remove_file(folder.path().join("results.zarr/spectrum/.judder.lock")).unwrap();
    assert!(!verify(folder.path(), all).unwrap().is_sound());
    let told = run(&file, folder.path(), &options, &Silent).unwrap().forgotten.told();
    let expected =
        "forgotten, since the case no longer has them: spectrum; their files stay until `judder run --fresh`";
    assert_eq!(told, [expected]);
    let found = verify(folder.path(), all).unwrap();
    assert!(found.is_sound() && found.findings.len() == others.len(), "{found:?}");
    assert!(found.findings.iter().all(|own| (own.kind(), own.of()) == ("extra", Some("spectrum"))));
    assert!(run(&file, folder.path(), &options, &Silent).unwrap().forgotten.told().is_empty());
}
