//! The matrices of a disc brake, published with BrakeSqueal 0.1 (repository nae9on/BrakeSqueal0.1). They are no part of the
//! project: without their folder nothing is shown.

use judder_exchange::matrix::{Matrix, Symmetry, read_matrix};
use judder_exchange::system::{NamedMatrix, SystemParts};
use std::path::{Path, PathBuf};

fn folder() -> Option<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2)?;
    let folder = root.join("../shared/data/disc-brake-m0");
    if folder.is_dir() {
        return Some(folder);
    }
    println!("SKIPPED: there is no folder {}", folder.display());
    None
}

/// The README beside the files says which are symmetric, skew and neither.
#[test]
fn its_matrices_have_the_size_and_symmetry_that_are_said() {
    let Some(folder) = folder() else { return };
    let read = |name: &str| -> Matrix {
        let matrix = read_matrix(&folder.join(format!("{name}.mat"))).unwrap();
        assert_eq!((matrix.rows, matrix.columns, matrix.symmetry), (4669, 4669, Symmetry::General), "{name}");
        matrix
    };
    for name in ["BMLL00", "BDLL00", "BDIWLL00", "BHLL00", "BKLL00", "BWLL00"] {
        let asymmetry = read(name).asymmetry();
        println!("{name}: max |A − Aᵀ| = {asymmetry:e} max |A|");
        assert!(asymmetry < 1e-12, "{name}: {asymmetry:e}");
    }
    let (gyroscopic, circulatory) = (read("BYLL00"), read("BKQLL00"));
    assert!(gyroscopic.skew_asymmetry() < 1e-12 && gyroscopic.asymmetry() > 1.0);
    assert!(circulatory.asymmetry() > 1e-3 && circulatory.skew_asymmetry() > 1e-3);
}

#[test]
fn they_make_one_structure() {
    let Some(folder) = folder() else { return };
    let read = |name: &str| read_matrix(&folder.join(name)).unwrap();
    let (mass, damping, stiffness) = (read("BMLL00.mat"), read("BDLL00.mat"), read("BKLL00.mat"));
    let part = |matrix| vec![NamedMatrix { name: "a file", matrix }];
    let parts = SystemParts { mass: part(&mass), damping: part(&damping), stiffness: part(&stiffness) };
    assert_eq!(parts.check(None).unwrap(), 4669);
    assert_eq!(mass.to_sparse().unwrap().compute_nnz(), mass.entries.len());
}
