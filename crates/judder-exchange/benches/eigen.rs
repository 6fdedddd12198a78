//! The complex modes of the disc brake in a folder, at one speed and over a hundred, as one line of JSON: the Rust side of
//! `benches/compare_eigen.py`.
//!
//! `eigen FOLDER`, with the matrices of G. Gräbner and others, ZAMM 2016, as MATLAB files.

use faer::c64;
use faer::sparse::{SparseColMat, Triplet};
use judder_exchange::matrix::read_matrix;
use judder_structure::affine::{AffineFamily, Factors, Term};
use judder_structure::complex_modes::{ComplexModeSettings, Region, complex_modes};
use judder_structure::eigen_sweep::{SweepMethod, eigen_sweep};
use judder_structure::quadratic::Quadratic;
use std::error::Error;
use std::f64::consts::TAU;
use std::hint::black_box;
use std::path::Path;
use std::time::Instant;

const REGION: Region = Region { re: [-50.0, 1000.0], im: [0.0, 20000.0] };
const POINTS: usize = 100;
/// Every so many points the full answer stands beside the projected one.
const CHECKED: usize = 11;
const TOLERANCE: f64 = 1e-7;
/// As many as the peer takes.
const REPEATS: usize = 2;

fn family(folder: &Path) -> Result<AffineFamily, Box<dyn Error>> {
    let terms = |names: &[&str]| -> Result<Vec<Term>, Box<dyn Error>> {
        let read = |name: &&str| -> Result<Term, Box<dyn Error>> {
            let matrix = read_matrix(&folder.join(format!("{name}.mat")))?.to_sparse()?;
            Ok(Term { name: (*name).to_owned(), matrix })
        };
        names.iter().map(read).collect()
    };
    Ok(AffineFamily::new(
        terms(&["BMLL00"])?,
        terms(&["BDLL00", "BYLL00", "BDIWLL00", "BHLL00"])?,
        terms(&["BKLL00", "BKQLL00", "BWLL00"])?,
    )?)
}

fn factors(speed: f64) -> Factors {
    Factors {
        mass: vec![1.0],
        damping: vec![1.0, speed, 1.0 / speed - 1.0, 1.0 / (TAU * 1600.0)],
        stiffness: vec![1.0, 1.0, speed * speed - 1.0],
    }
}

/// The least wall time of some calls, in seconds, and the last result.
fn least<T>(repeats: usize, mut work: impl FnMut() -> T) -> (f64, T) {
    let mut timed = || {
        let start = Instant::now();
        let result = black_box(work());
        (start.elapsed().as_secs_f64(), result)
    };
    let first = timed();
    (1..repeats).fold(first, |(seconds, _), _| {
        let (again, result) = timed();
        (seconds.min(again), result)
    })
}

/// Seconds to factor λ²M + λC + K at the shifts, one after the other.
fn floor(problem: &Quadratic, shifts: &[c64]) -> Result<f64, Box<dyn Error>> {
    let mut matrices = Vec::new();
    for shift in shifts {
        let parts = [
            (problem.mass(), shift * shift),
            (problem.damping(), *shift),
            (problem.stiffness(), c64::new(1.0, 0.0)),
        ];
        let entries = parts.iter().flat_map(|(matrix, factor)| {
            (0..matrix.ncols()).flat_map(move |column| {
                let values = matrix.row_idx_of_col(column).zip(matrix.val_of_col(column));
                values.map(move |(row, value)| Triplet::new(row, column, factor * *value))
            })
        });
        let entries: Vec<_> = entries.collect();
        matrices.push(SparseColMat::try_new_from_triplets(problem.size(), problem.size(), &entries)?);
    }
    let (seconds, factored) =
        least(3, || matrices.iter().try_for_each(|matrix| matrix.sp_lu().map(|lu| drop(black_box(lu)))));
    factored.map_err(|error| format!("{error:?}"))?;
    Ok(seconds)
}

fn main() -> Result<(), Box<dyn Error>> {
    // cargo passes `--bench`
    let Some(folder) = std::env::args().skip(1).find(|argument| !argument.starts_with("--")) else {
        eprintln!("SKIPPED: name the folder with the matrices of the disc brake");
        return Ok(());
    };
    let family = family(Path::new(&folder))?;
    let problem = family.at(&factors(TAU))?;
    let (seconds, found) =
        least(REPEATS, || complex_modes(&problem, &REGION, &ComplexModeSettings::default()));
    let found = found?;
    let floor = floor(&problem, &found.shifts)?;
    let values: Vec<[f64; 2]> =
        found.modes.iter().map(|mode| [mode.eigenvalue.value.re, mode.eigenvalue.value.im]).collect();
    let speeds = (0..POINTS).map(|k| TAU * (1.0 + 3.0 * k as f64 / (POINTS - 1) as f64));
    let points: Vec<Factors> = speeds.map(factors).collect();
    // the shown errors here are those of the methods alone
    let exact = ComplexModeSettings { data_precision: 0.0, ..ComplexModeSettings::default() };
    let fast = SweepMethod::Projected { tolerance: TOLERANCE };
    let (sweep_seconds, sweep) = least(1, || eigen_sweep(&family, &points, &REGION, &exact, fast));
    let sweep = sweep?;
    let (mut largest, mut compared) = (0.0_f64, 0);
    for k in (0..POINTS).step_by(CHECKED) {
        let full = complex_modes(&family.at(&points[k])?, &REGION, &exact)?;
        if full.modes.len() != sweep.points[k].eigenvalues.len() {
            return Err(format!("point {k}: the two ways differ in the number of eigenvalues").into());
        }
        for (a, b) in sweep.points[k].eigenvalues.iter().zip(&full.modes) {
            let apart = (a.eigenvalue.value - b.eigenvalue.value).norm();
            largest = largest.max(apart / (a.eigenvalue.error + b.eigenvalue.error));
            compared += 1;
        }
    }
    println!(
        "{{\"seconds\": {seconds}, \"floor_seconds\": {floor}, \"complete\": {}, \"eigenvalues\": {values:?}, \"points\": {POINTS}, \
         \"sweep_seconds\": {sweep_seconds}, \"basis\": {}, \"samples\": {}, \"on_their_own\": {}, \"compared\": {compared}, \
         \"largest_share_of_shown_error\": {largest}}}",
        found.complete(),
        sweep.basis.unwrap_or(0),
        sweep.samples.len(),
        sweep.points.iter().filter(|point| point.full).count(),
    );
    Ok(())
}
