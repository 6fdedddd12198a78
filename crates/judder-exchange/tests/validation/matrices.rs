//! One matrix in the files of SciPy (`matrices/write.py`).

use crate::file;
use judder_exchange::matrix::{Matrix, Symmetry, read_matrix};

fn read(name: &str) -> Matrix {
    read_matrix(&file("validation/matrices").join(name)).unwrap()
}

/// The entries that `write.py` gives, in the order of a [`Matrix`].
fn entries(of: impl Fn(usize, usize) -> f64) -> Vec<(usize, usize, f64)> {
    let places = (0..6_usize).flat_map(|row| (0..6_usize).map(move |column| (row, column)));
    let filled = places.filter(|(row, column)| matches!(row.abs_diff(*column), 0 | 1 | 4));
    filled.map(|(row, column)| (row, column, of(row, column))).collect()
}

fn unsymmetric(row: usize, column: usize) -> f64 {
    (row + 1) as f64 + 0.1 * (column + 1) as f64
}

#[test]
fn every_format_gives_the_same_matrix() {
    for name in [
        "sparse.mat",
        "sparse_compressed.mat",
        "full.mat",
        "full_compressed.mat",
        "sparse_73.mat",
        "sparse_73_compressed.mat",
        "full_73.mat",
        "csr.npz",
        "csc.npz",
        "coo.npz",
        "coo_array.npz",
        "dia.npz",
        "general.mtx",
        "array.mtx",
        "abaqus.mtx",
    ] {
        let matrix = read(name);
        assert_eq!((matrix.rows, matrix.columns, matrix.symmetry), (6, 6, Symmetry::General), "{name}");
        assert_eq!(matrix.entries, entries(unsymmetric), "{name}");
    }
}

/// Blocks hold zeros as well.
#[test]
fn blocks_give_it_too() {
    let mut matrix = read("bsr.npz");
    matrix.entries.retain(|(_, _, value)| *value != 0.0);
    assert_eq!(matrix.entries, entries(unsymmetric));
}

#[test]
fn triangles_become_whole() {
    let half = |sign: f64| entries(move |i, j| 0.5 * (unsymmetric(i, j) + sign * unsymmetric(j, i)));
    let symmetric = read("symmetric.mtx");
    assert_eq!((symmetric.symmetry, symmetric.asymmetry()), (Symmetry::Symmetric, 0.0));
    assert_eq!(symmetric.entries, half(1.0));
    let mut skew = half(-1.0);
    skew.retain(|(row, column, _)| row != column);
    assert_eq!(read("skew.mtx").entries, skew);
}
