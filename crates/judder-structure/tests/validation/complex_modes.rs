//! Complex modes against spectra that are known beforehand.

use faer::c64;
use faer::sparse::Triplet;
use judder_numerics::counter::uniform;
use judder_structure::StructureError;
use judder_structure::assembly::Sparse;
use judder_structure::complex_modes::{ComplexModeSettings, ComplexModes, Region, Verdict, complex_modes};
use judder_structure::quadratic::Quadratic;

pub(super) fn sparse(size: usize, entries: impl IntoIterator<Item = (usize, usize, f64)>) -> Sparse {
    let triplets: Vec<_> = entries.into_iter().map(|(i, j, v)| Triplet::new(i, j, v)).collect();
    Sparse::try_new_from_triplets(size, size, &triplets).unwrap()
}

pub(super) fn diagonal(values: &[f64]) -> Sparse {
    sparse(values.len(), values.iter().enumerate().map(|(k, v)| (k, k, *v)))
}

/// L diag R with triangles L and R of their own seeds: the eigenvalues of the diagonal, vectors that are not orthogonal.
pub(super) fn disguised(diagonals: &Sparse) -> Sparse {
    const SIDES: [u64; 2] = [11, 12];
    let size = diagonals.nrows();
    let triangle = |seed: u64, lower: bool| {
        let entries = (0..size).flat_map(move |i| {
            let beside = (i.saturating_sub(3)..i).map(move |j| {
                let value = uniform(seed, (i * size + j) as u64) - 0.5;
                if lower { (i, j, value) } else { (j, i, value) }
            });
            beside.chain([(i, i, 1.0)])
        });
        sparse(size, entries)
    };
    &(&triangle(SIDES[0], true) * diagonals) * &triangle(SIDES[1], false)
}

/// Oscillators λ² + 2 ζ ω λ + ω² with their own ω and ζ, disguised; massless where the mass is zero.
fn oscillators(pairs: &[(f64, f64)], masses: Option<&[f64]>) -> Quadratic {
    let column = |f: &dyn Fn(f64, f64) -> f64| -> Vec<f64> { pairs.iter().map(|(w, z)| f(*w, *z)).collect() };
    let mass = masses.map_or_else(|| vec![1.0; pairs.len()], <[f64]>::to_vec);
    Quadratic::new(
        disguised(&diagonal(&mass)),
        disguised(&diagonal(&column(&|w, z| 2.0 * z * w))),
        disguised(&diagonal(&column(&|w, _| w * w))),
    )
    .unwrap()
}

pub(super) fn root(frequency: f64, ratio: f64) -> c64 {
    c64::new(-ratio * frequency, frequency * (1.0 - ratio * ratio).sqrt())
}

fn all_of(problem: &Quadratic, region: &Region) -> ComplexModes {
    let modes = complex_modes(problem, region, &ComplexModeSettings::default()).unwrap();
    assert!(modes.complete(), "{:?}", modes.gaps);
    for mode in &modes.modes {
        assert!(mode.eigenvalue.residual <= 1e-14 && mode.eigenvalue.left_residual <= 1e-14);
    }
    modes
}

/// Every expected eigenvalue is found within its shown error, and no other.
fn assert_spectrum(modes: &ComplexModes, expected: &[c64]) {
    let mut expected = expected.to_vec();
    expected.sort_by(|a, b| a.im.total_cmp(&b.im).then(a.re.total_cmp(&b.re)));
    assert_eq!(modes.modes.len(), expected.len());
    for (mode, expected) in modes.modes.iter().zip(expected) {
        let eigenvalue = mode.eigenvalue;
        let distance = (eigenvalue.value - expected).norm();
        assert!(distance <= eigenvalue.error, "{} {expected}: {distance:e}", eigenvalue.value);
        assert!(eigenvalue.error <= 1e-5 * expected.norm(), "{:e}", eigenvalue.error);
    }
}

#[test]
fn known_spectra_are_found_whole() {
    let pairs: Vec<(f64, f64)> =
        (1..=40).map(|k| (f64::from(k) * 25.0, 0.3 * (f64::from(k) * 0.7).sin())).collect();
    let problem = oscillators(&pairs, None);
    let region = Region { re: [-150.0, 150.0], im: [90.0, 560.0] };
    let inside = |value: &c64| value.re.abs() <= 150.0 && (90.0..=560.0).contains(&value.im);
    let expected: Vec<c64> = pairs.iter().map(|(w, z)| root(*w, *z)).filter(inside).collect();
    assert!(expected.len() > 15);
    let modes = all_of(&problem, &region);
    assert_spectrum(&modes, &expected);
    for mode in &modes.modes {
        let unstable = mode.eigenvalue.value.re > 0.0;
        assert_eq!(mode.eigenvalue.verdict() == Verdict::Unstable, unstable);
    }
}

#[test]
fn as_many_shifts_are_taken_as_the_spectrum_needs() {
    let pairs: Vec<(f64, f64)> = (1..=400).map(|k| (f64::from(k), 1e-3)).collect();
    let region = Region { re: [-1.0, 1.0], im: [0.5, 300.5] };
    let modes = all_of(&oscillators(&pairs, None), &region);
    assert!(modes.shifts.len() > 4, "{} shifts", modes.shifts.len());
    let expected: Vec<c64> = pairs[..300].iter().map(|(w, z)| root(*w, *z)).collect();
    assert_spectrum(&modes, &expected);
}

#[test]
fn double_eigenvalues_are_found_twice_with_vectors_of_their_own() {
    let pairs = [(50.0, 0.02), (50.0, 0.02), (70.0, 0.1), (90.0, -0.01), (90.0, -0.01), (200.0, 0.5)];
    let region = Region { re: [-20.0, 20.0], im: [10.0, 120.0] };
    let modes = all_of(&oscillators(&pairs, None), &region);
    let expected: Vec<c64> = pairs[..5].iter().map(|(w, z)| root(*w, *z)).collect();
    assert_spectrum(&modes, &expected);
    assert!(modes.modes.iter().all(|mode| !mode.eigenvalue.defective));
}

#[test]
fn left_and_right_vectors_are_biorthogonal() {
    let pairs = [(50.0, 0.02), (50.0, 0.02), (70.0, 0.1), (90.0, -0.01), (95.0, 0.3)];
    let problem = oscillators(&pairs, None);
    let modes = all_of(&problem, &Region { re: [-40.0, 20.0], im: [10.0, 120.0] });
    assert_eq!(modes.modes.len(), 5);
    let product = |i: usize, j: usize| -> c64 {
        let (a, b) = (&modes.modes[i], &modes.modes[j]);
        let sum = a.eigenvalue.value + b.eigenvalue.value;
        let mut total = c64::new(0.0, 0.0);
        for column in 0..problem.size() {
            for (matrix, factor) in [(problem.mass(), sum), (problem.damping(), c64::new(1.0, 0.0))] {
                for (row, value) in matrix.row_idx_of_col(column).zip(matrix.val_of_col(column)) {
                    total += a.left[row].conj() * factor * *value * b.right[column];
                }
            }
        }
        total
    };
    for i in 0..5 {
        for j in (0..5).filter(|j| *j != i) {
            let share = product(i, j).norm() / (product(i, i).norm() * product(j, j).norm()).sqrt();
            assert!(share < 1e-9, "{i} {j}: {share:e}");
        }
    }
}

/// λ² + 2 ζ ω λ + ω² on both places of a diagonal with a one beside it: one eigenvalue, one vector.
#[test]
fn a_defective_eigenvalue_on_the_axis_is_marginal() {
    let frequency = 30.0_f64;
    let identity = || disguised(&sparse(3, (0..3).map(|k| (k, k, 1.0))));
    let stiffness =
        sparse(3, [(0, 0, frequency.powi(2)), (1, 1, frequency.powi(2)), (0, 1, 5.0), (2, 2, 4.0e4)]);
    let problem = Quadratic::new(identity(), sparse(3, []), disguised(&stiffness)).unwrap();
    let modes = complex_modes(
        &problem,
        &Region { re: [-5.0, 5.0], im: [10.0, 50.0] },
        &ComplexModeSettings::default(),
    )
    .unwrap();
    assert_eq!(modes.modes.len(), 2, "{modes:?}");
    for mode in &modes.modes {
        let eigenvalue = mode.eigenvalue;
        assert!(eigenvalue.defective, "{eigenvalue:?}");
        assert_eq!(eigenvalue.verdict(), Verdict::Marginal);
        let distance = (eigenvalue.value - c64::new(0.0, frequency)).norm();
        assert!(distance <= eigenvalue.error && eigenvalue.error < 1e-2, "{distance:e} {eigenvalue:?}");
    }
}

/// Two degrees of freedom coupled by friction: N. Hoffmann, M. Fischer, R. Allgaier and L. Gaul, Mechanics Research
/// Communications 29 (2002): with m = k₁ = 1 the frequencies meet where the coupling is half the difference of the stiffnesses.
#[test]
fn mode_coupling_flutter_is_found_where_it_begins() {
    let (stiff, soft) = (1.5, 1.0);
    let at = |coupling: f64| {
        let stiffness = sparse(2, [(0, 0, stiff), (1, 1, soft), (0, 1, coupling), (1, 0, -coupling)]);
        let problem = Quadratic::new(diagonal(&[1.0, 1.0]), sparse(2, []), stiffness).unwrap();
        all_of(&problem, &Region { re: [-1.0, 1.0], im: [0.1, 3.0] })
    };
    let before = at(0.2);
    assert!(before.modes.iter().all(|mode| mode.eigenvalue.verdict() == Verdict::Marginal));
    let after = at(0.4);
    let verdicts: Vec<Verdict> = after.modes.iter().map(|mode| mode.eigenvalue.verdict()).collect();
    assert!(verdicts.contains(&Verdict::Unstable) && verdicts.contains(&Verdict::Stable));
    // λ² = −(k₁ + k₂)/2 ± √((k₁ − k₂)²/4 − c²)
    let expected = |coupling: f64| -> Vec<c64> {
        let inner = c64::new((stiff - soft).powi(2) / 4.0 - coupling * coupling, 0.0).sqrt();
        let roots = [1.0, -1.0].map(|sign| (inner * sign - 0.5 * (stiff + soft)).sqrt());
        roots.iter().map(|root| if root.im < 0.0 { -root } else { *root }).collect()
    };
    assert_spectrum(&before, &expected(0.2));
    assert_spectrum(&after, &expected(0.4));
}

#[test]
fn a_freedom_without_mass_brings_no_eigenvalues_of_its_own() {
    let pairs = [(50.0, 0.02), (60.0, 0.1), (70.0, 0.0), (90.0, 0.05)];
    let problem = oscillators(&pairs, Some(&[1.0, 1.0, 0.0, 1.0]));
    let modes = all_of(&problem, &Region { re: [-20.0, 20.0], im: [10.0, 120.0] });
    assert_spectrum(&modes, &[root(50.0, 0.02), root(60.0, 0.1), root(90.0, 0.05)]);
}

#[test]
fn a_region_without_eigenvalues_is_empty_and_complete() {
    let modes = all_of(
        &oscillators(&[(50.0, 0.02), (60.0, 0.1)], None),
        &Region { re: [-1.0, 1.0], im: [200.0, 300.0] },
    );
    assert!(modes.modes.is_empty());
}

#[test]
fn a_problem_that_is_singular_everywhere_is_refused_with_the_place() {
    let singular = || diagonal(&[1.0, 0.0]);
    let problem = Quadratic::new(singular(), singular(), singular()).unwrap();
    let region = Region { re: [-1.0, 1.0], im: [0.0, 2.0] };
    let refused = complex_modes(&problem, &region, &ComplexModeSettings::default()).unwrap_err();
    assert!(matches!(refused, StructureError::SingularEverywhere { .. }), "{refused}");
    let empty = Region { re: [1.0, -1.0], im: [0.0, 2.0] };
    let refused = complex_modes(&problem, &empty, &ComplexModeSettings::default()).unwrap_err();
    assert_eq!(
        refused.to_string(),
        "the region's range `re` goes from 1 to -1: it must rise, between finite numbers"
    );
}

#[test]
fn the_bytes_do_not_depend_on_the_threads() {
    let pairs: Vec<(f64, f64)> = (1..=60).map(|k| (f64::from(k) * 10.0, 0.01)).collect();
    let problem = oscillators(&pairs, None);
    let with_threads = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| all_of(&problem, &Region { re: [-20.0, 20.0], im: [0.0, 400.0] }))
    };
    assert_eq!(with_threads(1), with_threads(3));
}
