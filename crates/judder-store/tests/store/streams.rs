//! Streams: the same bytes whether written in one go, cut, killed or finished late.

use std::collections::BTreeMap;
use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread;
use std::time::Duration;

use judder_store::{Dataset, StoreError, StreamSlice, StreamWriter, StudyFolder, Variable, VariableValues};
use proptest::prelude::*;

const CHILD_FOLDER: &str = "JUDDER_TEST_KILLED_STREAM";

/// Points of a row.
const POINTS: usize = 3;
/// Steps between two rows of states.
const THIN: usize = 4;

/// Numbers over time, rows of numbers over time, rows of codes over fewer times.
fn variables() -> [Variable; 4] {
    let grows = |name| Variable::new(name, &["time"], &[0], Vec::<f64>::new());
    [
        grows("time").units("s").long_name("time t"),
        grows("force").units("N").attribute("note", 7),
        Variable::new("velocity", &["time", "point"], &[0, POINTS], Vec::<f64>::new()),
        Variable::classes("state", &["state_time", "point"], &[0, POINTS], Vec::new(), &[(0, "a"), (1, "b")]),
    ]
}

fn velocities(step: usize) -> [f64; POINTS] {
    [0, 1, 2].map(|point| force(3 * step + point))
}

/// Of every so many-th step.
fn states(step: usize) -> Option<[u8; POINTS]> {
    step.is_multiple_of(THIN).then(|| [0, 1, 2].map(|point| (step / THIN + point) as u8 % 2))
}

/// No new rows.
const NOTHING: [StreamSlice<'_>; 4] =
    [StreamSlice::F64(&[]), StreamSlice::F64(&[]), StreamSlice::F64(&[]), StreamSlice::U8(&[])];

fn time(step: usize) -> f64 {
    step as f64 * 0.1
}

fn force(step: usize) -> f64 {
    f64::from_bits((step as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 2)
}

fn rest() -> Dataset {
    Dataset::new()
        .attribute("title", "a march")
        .unwrap()
        .with(Variable::new("steps", &[], &[], vec![3_i64]))
        .unwrap()
        .with(Variable::coordinate("zone", vec![0.074, 0.082]).units("m"))
        .unwrap()
}

/// The same in memory.
fn whole(len: usize) -> Dataset {
    let values: [VariableValues; 4] = [
        (0..len).map(time).collect::<Vec<_>>().into(),
        (0..len).map(force).collect::<Vec<_>>().into(),
        (0..len).flat_map(velocities).collect::<Vec<_>>().into(),
        (0..len).filter_map(states).flatten().collect::<Vec<_>>().into(),
    ];
    let mut dataset = Dataset::new();
    for (mut variable, data) in variables().into_iter().zip(values) {
        let row: usize = variable.shape[1..].iter().product();
        variable.shape[0] = data.len() / row;
        variable.data = data;
        dataset = dataset.with(variable).unwrap();
    }
    for variable in rest().variables() {
        dataset = dataset.with(variable.clone()).unwrap();
    }
    dataset.attribute("title", "a march").unwrap()
}

/// Appends steps up to `until`, so many at a time; the checkpoint says how many steps there are.
fn append(stream: &mut StreamWriter, until: usize, at_a_time: usize) {
    while (stream.len() as usize) < until {
        let first = stream.len() as usize;
        let last = (first + at_a_time).min(until);
        let (times, forces): (Vec<f64>, Vec<f64>) =
            (first..last).map(|step| (time(step), force(step))).unzip();
        let velocities: Vec<f64> = (first..last).flat_map(velocities).collect();
        let states: Vec<u8> = (first..last).filter_map(states).flatten().collect();
        let slices =
            [StreamSlice::F64(&times), StreamSlice::F64(&forces), velocities[..].into(), states[..].into()];
        stream.append(format!("steps {last}").as_bytes(), &slices).unwrap();
    }
}

fn open(study: &StudyFolder) -> StreamWriter<'_> {
    StreamWriter::open(study, "march", "h", &variables()).unwrap()
}

/// Every file below a folder.
fn files(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut files = BTreeMap::new();
    let mut left = vec![folder.to_owned()];
    while let Some(place) = left.pop() {
        for name in crate::names(&place) {
            let entry = place.join(name);
            if entry.is_dir() {
                left.push(entry);
            } else {
                files.insert(entry.strip_prefix(folder).unwrap().to_owned(), fs::read(&entry).unwrap());
            }
        }
    }
    files
}

/// What `write_dataset` leaves of the same content.
fn in_one_go(len: usize) -> BTreeMap<PathBuf, Vec<u8>> {
    let folder = tempfile::tempdir().unwrap();
    StudyFolder::create(folder.path()).unwrap().write_dataset("march", "h", &whole(len)).unwrap();
    files(&folder.path().join("results.zarr"))
}

fn check_finished(folder: &Path, len: usize) {
    assert!(files(&folder.join("results.zarr")) == in_one_go(len));
    assert_eq!(crate::names(folder), [".judder.lock", "results.zarr"]);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]
    /// Cut after any append and opened again, also in a new process's view of the folder.
    #[test]
    fn a_stream_that_was_cut_gives_the_same_bytes(
        cuts in prop::collection::vec(0..60_usize, 0..5), at_a_time in 1..40_usize, len in 0..60_usize,
    ) {
        let folder = tempfile::tempdir().unwrap();
        for cut in cuts {
            let study = StudyFolder::create(folder.path()).unwrap();
            let mut stream = open(&study);
            let before = stream.len();
            append(&mut stream, cut.min(len), at_a_time);
            let expected = before.max(cut.min(len) as u64);
            drop(stream);
            let again = open(&study);
            prop_assert_eq!(again.len(), expected);
            let checkpoint = again.checkpoint().map(|bytes| String::from_utf8(bytes.to_vec()).unwrap());
            prop_assert_eq!(checkpoint, (expected > 0).then(|| format!("steps {expected}")));
        }
        let study = StudyFolder::create(folder.path()).unwrap();
        let mut stream = open(&study);
        append(&mut stream, len, at_a_time);
        stream.finish(rest()).unwrap();
        prop_assert!(study.read_dataset("march").unwrap() == whole(len));
        check_finished(folder.path(), len);
    }
}

/// Several chunks of rows and a part of another.
#[test]
fn a_stream_of_many_chunks_gives_the_same_bytes() {
    let folder = tempfile::tempdir().unwrap();
    let study = StudyFolder::create(folder.path()).unwrap();
    let mut stream = open(&study);
    append(&mut stream, 1_500_001, 400_000);
    stream.finish(rest()).unwrap();
    check_finished(folder.path(), 1_500_001);
    assert!(fs::read_dir(folder.path().join("results.zarr/march/velocity/c")).unwrap().count() > 2);
}

/// What is read while it grows is what was appended, and nothing else.
#[test]
fn what_was_appended_is_read_back() {
    let folder = tempfile::tempdir().unwrap();
    let study = StudyFolder::create(folder.path()).unwrap();
    let mut stream = open(&study);
    append(&mut stream, 10, 3);
    assert_eq!(stream.values("force").unwrap(), (0..10).map(force).collect::<Vec<_>>());
    assert_eq!(stream.values("velocity").unwrap(), (0..10).flat_map(velocities).collect::<Vec<_>>());
    let column: Vec<f64> = (0..10).map(|step| velocities(step)[1]).collect();
    assert_eq!(stream.column("velocity", 1).unwrap(), column);
    assert!(stream.column("velocity", POINTS).unwrap().is_empty());
    for unknown in ["state", "steps"] {
        let error = stream.column(unknown, 0).unwrap_err();
        assert!(
            matches!(&error, StoreError::NotGrowing { known, .. } if *known == ["time", "force", "velocity"])
        );
    }
}

/// What a kill can leave: values of an append whose checkpoint never came.
#[test]
fn a_torn_append_is_dropped() {
    let folder = tempfile::tempdir().unwrap();
    let study = StudyFolder::create(folder.path()).unwrap();
    let mut stream = open(&study);
    append(&mut stream, 10, 10);
    drop(stream);
    for torn in [3, 8, 801] {
        let values = folder.path().join(".stream-march/time.f64");
        let mut content = fs::read(&values).unwrap();
        content.resize(content.len() + torn, 0xee);
        fs::write(&values, content).unwrap();
        assert_eq!((open(&study).len(), open(&study).checkpoint()), (10, Some(&b"steps 10"[..])));
    }
    let mut stream = open(&study);
    append(&mut stream, 12, 1);
    stream.finish(rest()).unwrap();
    check_finished(folder.path(), 12);
}

#[test]
fn what_another_hash_or_other_variables_left_is_forgotten() {
    let folder = tempfile::tempdir().unwrap();
    let study = StudyFolder::create(folder.path()).unwrap();
    let left = |hash: &str, variables: &[Variable]| {
        append(&mut open(&study), 10, 10);
        let stream = StreamWriter::open(&study, "march", hash, variables).unwrap();
        assert_eq!((stream.len(), stream.is_empty(), stream.checkpoint()), (0, true, None));
        drop(stream);
        assert!(open(&study).is_empty());
    };
    left("other", &variables());
    left("h", &variables()[..1]);
    let [time, force, velocity, state] = variables();
    left("h", &[force, time, velocity, state]);
}

#[test]
fn what_is_damaged_is_forgotten() {
    let folder = tempfile::tempdir().unwrap();
    let study = StudyFolder::create(folder.path()).unwrap();
    let (checkpoint, values) = (".stream-march/checkpoint", ".stream-march/force.f64");
    for (file, damage) in [
        (checkpoint, &(|content: &mut Vec<u8>| content.truncate(20)) as &dyn Fn(&mut Vec<u8>)),
        (checkpoint, &|content| *content.last_mut().unwrap() ^= 1),
        (checkpoint, &Vec::clear),
        (values, &|content| content.truncate(79)),
    ] {
        append(&mut open(&study), 10, 10);
        let path = folder.path().join(file);
        let mut content = fs::read(&path).unwrap();
        damage(&mut content);
        fs::write(&path, content).unwrap();
        assert!(open(&study).is_empty());
    }
    append(&mut open(&study), 10, 10);
    fs::remove_file(folder.path().join(values)).unwrap();
    assert!(open(&study).is_empty());
}

#[test]
fn a_checkpoint_alone_is_kept_and_may_be_any_bytes() {
    let folder = tempfile::tempdir().unwrap();
    let study = StudyFolder::create(folder.path()).unwrap();
    let bytes: Vec<u8> = (0..=255).rev().collect();
    open(&study).append(&bytes, &NOTHING).unwrap();
    assert_eq!((open(&study).len(), open(&study).checkpoint()), (0, Some(&bytes[..])));
    study.forget(|_| false).unwrap();
    assert_eq!(open(&study).checkpoint(), None);
}

#[test]
fn what_cannot_grow_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let study = StudyFolder::create(folder.path()).unwrap();
    let refused = |variables: &[Variable]| StreamWriter::open(&study, "march", "h", variables).unwrap_err();
    let [time, force, _, _] = variables();
    for odd in [
        Variable::new("a", &["time"], &[0], Vec::<i64>::new()),
        Variable::new("a", &["time"], &[1], vec![1.0]),
        Variable::new("a", &["time", "node"], &[0, 0], Vec::<f64>::new()),
        Variable::new("a", &["time", "node"], &[0], Vec::<f64>::new()),
        Variable::new("a", &["node", "time"], &[3, 0], Vec::<f64>::new()),
        Variable::new("a", &[], &[], Vec::<f64>::new()),
    ] {
        let error = refused(&[time.clone(), odd]);
        assert!(matches!(&error, StoreError::CannotGrow { variable } if variable == "a"), "{error}");
    }
    assert!(matches!(refused(&[force.clone(), force.clone()]), StoreError::Duplicate { .. }));
    assert!(matches!(refused(&[force.units("seconds")]), StoreError::DateUnits { .. }));
    let refused = StreamWriter::open(&study, "a/b", "h", &variables()).unwrap_err();
    assert!(matches!(refused, StoreError::InvalidName { .. }));
}

#[test]
fn slices_that_do_not_fit_leave_the_stream_as_it_was() {
    let folder = tempfile::tempdir().unwrap();
    let study = StudyFolder::create(folder.path()).unwrap();
    let mut stream = open(&study);
    append(&mut stream, 2, 2);
    let refused = stream.append(b"x", &NOTHING[..1]).unwrap_err();
    assert!(matches!(refused, StoreError::SliceCount { expected: 4, found: 1 }), "{refused}");
    let mut refused = |at: usize, slice: StreamSlice<'_>| {
        let mut slices = [[1.0][..].into(), [1.0][..].into(), [1.0; 3][..].into(), NOTHING[3]];
        slices[at] = slice;
        stream.append(b"x", &slices).unwrap_err()
    };
    let error = refused(1, NOTHING[1]);
    assert!(matches!(error, StoreError::SliceLength { expected: 1, found: 0, .. }), "{error}");
    let error = refused(2, [1.0; 4][..].into());
    assert!(matches!(error, StoreError::SliceLength { expected: 3, found: 4, .. }), "{error}");
    let error = refused(3, [0_u8; 4][..].into());
    assert!(matches!(error, StoreError::SliceLength { expected: 3, found: 4, .. }), "{error}");
    let error = refused(3, [0.0; 3][..].into());
    assert!(matches!(&error, StoreError::SliceKind { variable } if variable == "state"), "{error}");
    assert_eq!((stream.len(), stream.checkpoint()), (2, Some(&b"steps 2"[..])));
    // a dimension of another length, and a name that is taken
    let longer = Dataset::new().with(Variable::new("a", &["time"], &[3], vec![0.0; 3])).unwrap();
    let refused = stream.finish(longer).unwrap_err();
    assert!(matches!(refused, StoreError::DimensionConflict { expected: 2, found: 3, .. }), "{refused}");
    let taken = Dataset::new().with(Variable::new("force", &[], &[], vec![0.0])).unwrap();
    assert!(matches!(open(&study).finish(taken), Err(StoreError::Duplicate { .. })));
    open(&study).finish(rest()).unwrap();
    check_finished(folder.path(), 2);
}

/// Kills a process that keeps appending, at various moments, and goes on from what it left.
#[test]
fn a_killed_run_loses_at_most_its_last_append() {
    let folder = tempfile::tempdir().unwrap();
    let mut before = 0;
    for moment in 0..12 {
        let mut child = Command::new(env::current_exe().unwrap())
            .args(["--exact", "streams::until_killed", "--ignored"])
            .env(CHILD_FOLDER, folder.path())
            .stdout(Stdio::null())
            .spawn()
            .unwrap();
        let started = folder.path().join("started");
        // so many appends, and some time amid the next one
        while fs::read_to_string(&started).map_or(0, |said| said.lines().count()) <= moment {
            thread::sleep(Duration::from_millis(1));
        }
        thread::sleep(Duration::from_micros(170 * moment as u64));
        assert!(child.try_wait().unwrap().is_none(), "the child ended by itself");
        child.kill().unwrap();
        child.wait().unwrap();
        // written after each append
        let appended: u64 = fs::read_to_string(&started).unwrap().lines().last().unwrap().parse().unwrap();
        fs::remove_file(started).unwrap();

        let study = StudyFolder::create(folder.path()).unwrap();
        let stream = open(&study);
        // the last line may have been on its way when the append was done
        assert!((appended..=appended + 7).contains(&stream.len()), "{} {appended}", stream.len());
        assert!(stream.len() >= before);
        assert_eq!(stream.checkpoint().unwrap(), format!("steps {}", stream.len()).as_bytes());
        before = stream.len();
    }
    let study = StudyFolder::create(folder.path()).unwrap();
    open(&study).finish(rest()).unwrap();
    assert!(before > 100);
    check_finished(folder.path(), before as usize);
}

#[test]
#[ignore = "run and killed by a_killed_run_loses_at_most_its_last_append"]
fn until_killed() {
    use std::io::Write;
    let Some(folder) = env::var_os(CHILD_FOLDER) else { return };
    let study = StudyFolder::create(&folder).unwrap();
    let mut stream = open(&study);
    let start = stream.len() as usize + 7;
    append(&mut stream, start, 7);
    let staged = Path::new(&folder).join("starting");
    let mut said = fs::File::create(&staged).unwrap();
    writeln!(said, "{start}").unwrap();
    fs::rename(staged, Path::new(&folder).join("started")).unwrap();
    for append_number in 1.. {
        let until = start + 7 * append_number;
        append(&mut stream, until, 7);
        // one write a line
        said.write_all(format!("{until}\n").as_bytes()).unwrap();
    }
}
