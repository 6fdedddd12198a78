//! Damaged files are read or refused, never more: every file of the validation, cut, overwritten, with numbers exchanged.

use crate::file;
use judder_exchange::ExchangeError;
use judder_exchange::matrix::{Matrix, read_stored_matrix};
use judder_exchange::mesh_file::{MeshFile, read_mesh};
use proptest::prelude::*;
use std::fs;
use std::path::PathBuf;

/// Numbers that stand where others should.
const NUMBERS: [&str; 12] = [
    "0",
    "-1",
    "1",
    "7",
    "4294967296",
    "18446744073709551615",
    "99999999999999999999999",
    "1e308",
    "nan",
    "inf",
    "",
    "x",
];

/// What happens to a file; places are shares of its length.
#[derive(Debug, Clone)]
enum Damage {
    Cut(f64),
    Overwrite(f64, Vec<u8>),
    Insert(f64, Vec<u8>),
    Repeat(f64, f64),
    /// The word at a place becomes one of [`NUMBERS`].
    Word(f64, usize),
}

fn damage() -> impl Strategy<Value = Damage> {
    let share = || 0.0..1.0;
    prop_oneof![
        share().prop_map(Damage::Cut),
        (share(), prop::collection::vec(any::<u8>(), 1..9))
            .prop_map(|(at, bytes)| Damage::Overwrite(at, bytes)),
        (share(), prop::collection::vec(any::<u8>(), 1..9)).prop_map(|(at, bytes)| Damage::Insert(at, bytes)),
        (share(), share()).prop_map(|(from, to)| Damage::Repeat(from, to)),
        (share(), 0..NUMBERS.len()).prop_map(|(at, number)| Damage::Word(at, number)),
        (share(), 0..NUMBERS.len()).prop_map(|(at, number)| Damage::Word(at, number)),
    ]
}

impl Damage {
    fn done_to(&self, bytes: &[u8]) -> Vec<u8> {
        let place = |share: f64| (share * bytes.len() as f64) as usize;
        let mut done = bytes.to_vec();
        match self {
            Self::Cut(at) => done.truncate(place(*at)),
            Self::Overwrite(at, with) => {
                let at = place(*at);
                let end = (at + with.len()).min(bytes.len());
                done.splice(at..end, with.iter().copied());
            }
            Self::Insert(at, with) => {
                let at = place(*at);
                done.splice(at..at, with.iter().copied());
            }
            Self::Repeat(from, to) => {
                let (from, to) = (place(from.min(*to)), place(from.max(*to)));
                done.splice(to..to, bytes[from..to].iter().copied());
            }
            Self::Word(at, number) => {
                let at = place(*at);
                let ends_word = |byte: &u8| byte.is_ascii_whitespace() || *byte == b',';
                let start = bytes[..at].iter().rposition(ends_word).map_or(0, |end| end + 1);
                let end = bytes[at..].iter().position(ends_word).map_or(bytes.len(), |length| at + length);
                done.splice(start..end, NUMBERS[*number].bytes());
            }
        }
        done
    }
}

/// The files of a folder of the validation with one of these extensions.
fn samples(folder: &str, extensions: &[&str]) -> Vec<PathBuf> {
    let entries = fs::read_dir(file("validation").join(folder)).unwrap();
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| extensions.iter().any(|own| path.extension().is_some_and(|found| found == *own)));
    paths.sort();
    assert!(!paths.is_empty());
    paths
}

fn refused(error: &ExchangeError, path: &std::path::Path) {
    assert_eq!(error.path(), Some(path));
    assert!(error.to_string().len() < 1000, "{error}");
}

fn check_matrix(matrix: &Matrix) {
    let inside = |(row, column, value): &(usize, usize, f64)| {
        *row < matrix.rows && *column < matrix.columns && value.is_finite()
    };
    assert!(matrix.entries.iter().all(inside));
    assert!(matrix.entries.windows(2).all(|pair| (pair[0].0, pair[0].1) < (pair[1].0, pair[1].1)));
    matrix.to_sparse().unwrap();
}

fn check_mesh(found: &MeshFile) {
    let mesh = &found.mesh;
    mesh.check().unwrap();
    let elements = mesh.elements();
    assert_eq!((found.node_labels.len(), found.element_labels.len()), (mesh.nodes.len(), elements));
    assert!(mesh.node_sets.values().flatten().all(|node| *node < mesh.nodes.len()));
    assert!(mesh.element_sets.values().flatten().all(|element| *element < elements));
    for name in mesh.node_sets.keys().chain(mesh.side_sets.keys()).chain(mesh.element_sets.keys()) {
        found.nodes_of(name).unwrap();
    }
    assert!(mesh.side_sets.values().flatten().all(|side| side.element < elements));
    let _ = found.materials_of_blocks();
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, ..ProptestConfig::default() })]

    #[test]
    fn damaged_matrices_are_read_or_refused(
        sample in prop::sample::select(samples("matrices", &["mtx", "mat", "npz"])),
        damages in prop::collection::vec(damage(), 1..4),
    ) {
        let bytes = damages.iter().fold(fs::read(&sample).unwrap(), |bytes, own| own.done_to(&bytes));
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join(sample.file_name().unwrap());
        fs::write(&path, bytes).unwrap();
        match read_stored_matrix(&path) {
            Ok(matrix) => check_matrix(&matrix),
            Err(error) => refused(&error, &path),
        }
    }

    #[test]
    fn damaged_meshes_are_read_or_refused(
        sample in prop::sample::select(samples("meshes", &["msh", "inp"])),
        damages in prop::collection::vec(damage(), 1..4),
    ) {
        let bytes = damages.iter().fold(fs::read(&sample).unwrap(), |bytes, own| own.done_to(&bytes));
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join(sample.file_name().unwrap());
        fs::write(&path, bytes).unwrap();
        match read_mesh(&path) {
            Ok(found) => check_mesh(&found),
            Err(error) => refused(&error, &path),
        }
    }
}
