//! Analyses that are interrupted or killed, and go on from what they have kept.

use crate::march::contents;
use crate::stopping::Stopping;
use judder_study::case::file::CaseFile;
use judder_study::run::{RunOptions, RunReport, run};
use judder_study::{Progress, Silent, StudyError};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};
use std::{env, fs, thread};

/// An analysis of a small case, with so many points that it can be stopped among them.
struct Kept {
    case: &'static str,
    name: &'static str,
    set: &'static str,
}

const LOCUS: Kept = Kept { case: "sliding.toml", name: "locus", set: "analysis.locus.positions.points=400" };
/// Values at which there is no pair: every value by itself, then those that follow each other.
const BROKEN_LOCUS: Kept = Kept {
    case: "sliding.toml",
    name: "locus-friction",
    set: "analysis.locus-friction.sweep={key=\"motion.load.force\",from=\"-0.4 N\",to=\"0.1 N\",points=21}",
};
const SWEEP: Kept =
    Kept { case: "assembly.toml", name: "friction", set: "analysis.friction.sweep.points=40" };
const CURVES: Kept = Kept {
    case: "matrices.toml",
    name: "full",
    set: "analysis.full.sweep={key=\"parameters.mu\",from=0.0,to=1.2,points=31}",
};
const PROJECTED: Kept =
    Kept { case: "matrices.toml", name: "projected", set: "analysis.projected.sweep.points=60" };

impl Kept {
    fn case(&self) -> CaseFile {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/small").join(self.case);
        judder_models::read(path, &[self.set.to_owned()]).unwrap()
    }

    fn run(&self, study: &Path, progress: &dyn Progress) -> Result<RunReport, StudyError> {
        let options = RunOptions { only: vec![self.name.to_owned()], ..RunOptions::default() };
        run(&self.case(), study, &options, progress)
    }

    /// What is kept, line by line.
    fn lines(&self, study: &Path) -> Vec<String> {
        let path = study.join(format!(".scratch-of-{}", self.name));
        fs::read_to_string(path).unwrap_or_default().lines().map(str::to_owned).collect()
    }

    /// Asserts that a study that was disturbed is one that was not.
    fn assert_same(&self, study: &Path, whole: &Path) {
        let results = |study: &Path| -> Vec<(PathBuf, Vec<u8>)> {
            let all = contents(study).into_iter();
            all.filter(|(path, _)| {
                path.starts_with("results.zarr") || path.ends_with(format!("{}.csv", self.name))
            })
            .collect()
        };
        let (found, expected) = (results(study), results(whole));
        assert!(expected.len() > 2 && found == expected, "{}", self.name);
        assert!(self.lines(study).is_empty(), "{}", self.name);
    }
}

#[test]
fn an_interrupted_analysis_goes_on_to_the_bit() {
    for kept in [LOCUS, BROKEN_LOCUS, SWEEP, CURVES, PROJECTED] {
        let (whole, study) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
        let patient = Stopping::at(usize::MAX);
        let at_once = kept.run(whole.path(), &patient).unwrap();
        // who runs analyses takes the last step of each that is left
        assert!(patient.steps() <= 1, "{}: {} steps are left", kept.name, patient.steps());
        let lines_at = |share: usize| {
            let stopped = kept.run(study.path(), &Stopping::at(share * patient.looks() / 4));
            assert!(matches!(stopped, Err(StudyError::Interrupted)), "{}: {stopped:?}", kept.name);
            kept.lines(study.path())
        };
        let (first, second) = (lines_at(1), lines_at(2));
        assert!(second.len() > 4 && second.starts_with(&first), "{}: {}", kept.name, second.len());
        let known: BTreeSet<&String> = first.iter().collect();
        let again = second[first.len()..].iter().filter(|line| known.contains(line)).count();
        assert_eq!(again, 0, "{}: computed again, of {} known", kept.name, known.len());
        let resumed = kept.run(study.path(), &Silent).unwrap();
        assert_eq!(resumed.summary.results, at_once.summary.results);
        kept.assert_same(study.path(), whole.path());
    }
}

/// A changed case does not believe what was kept of another.
#[test]
fn what_is_kept_is_of_its_case() {
    let (whole, study) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    let patient = Stopping::at(usize::MAX);
    SWEEP.run(whole.path(), &patient).unwrap();
    let other = Kept { set: "contact.sole.friction_coefficient=0.25", ..SWEEP };
    SWEEP.run(study.path(), &Stopping::at(3 * patient.looks() / 4)).unwrap_err();
    assert!(SWEEP.lines(study.path()).len() > 4);
    let fresh = tempfile::tempdir().unwrap();
    let changed = other.run(study.path(), &Silent).unwrap();
    assert_eq!(changed.summary.results, other.run(fresh.path(), &Silent).unwrap().summary.results);
    other.assert_same(study.path(), fresh.path());
}

const CHILD_FOLDER: &str = "JUDDER_TEST_KILLED_ANALYSIS";
const KILLED: [Kept; 2] = [
    Kept { set: "analysis.locus.positions.points=800", ..LOCUS },
    Kept { set: "analysis.friction.sweep.points=60", ..SWEEP },
];

/// Kills a process at various moments after it has kept something more, and goes on from what it left.
#[test]
fn a_killed_analysis_goes_on_to_the_bit() {
    for kept in KILLED {
        let folder = tempfile::tempdir().unwrap();
        let (study, whole) = (folder.path().join("study"), folder.path().join("whole"));
        let at_once = kept.run(&whole, &Silent).unwrap();
        for moment in 0..3 {
            let before = kept.lines(&study).len();
            let mut child = Command::new(env::current_exe().unwrap())
                .args(["--exact", "kept::until_killed", "--ignored"])
                .env(CHILD_FOLDER, &study)
                .env("JUDDER_TEST_KILLED_NAME", kept.name)
                .stdout(Stdio::null())
                .spawn()
                .unwrap();
            let waited = Instant::now();
            while kept.lines(&study).len() < before + 8 && waited.elapsed() < Duration::from_secs(60) {
                thread::sleep(Duration::from_millis(1));
            }
            thread::sleep(Duration::from_millis(3 * moment));
            assert!(child.try_wait().unwrap().is_none(), "the child ended by itself");
            child.kill().unwrap();
            child.wait().unwrap();
            assert!(
                kept.lines(&study).len() >= before + 8
                    && !study.join("results.zarr").join(kept.name).exists()
            );
        }
        let resumed = kept.run(&study, &Silent).unwrap();
        assert_eq!(resumed.summary.results, at_once.summary.results);
        kept.assert_same(&study, &whole);
    }
}

#[test]
#[ignore = "run and killed by a_killed_analysis_goes_on_to_the_bit"]
fn until_killed() {
    let (Some(folder), Ok(name)) = (env::var_os(CHILD_FOLDER), env::var("JUDDER_TEST_KILLED_NAME")) else {
        return;
    };
    for kept in KILLED.iter().filter(|kept| kept.name == name) {
        kept.run(Path::new(&folder), &Silent).unwrap();
    }
}
