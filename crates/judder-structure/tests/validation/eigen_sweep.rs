//! Sweeps against branches that are known beforehand, and the fast way against the full one.

use faer::c64;
use faer::sparse::Triplet;
use judder_numerics::counter::uniform;
use judder_structure::StructureError;
use judder_structure::affine::{AffineFamily, Factors, Term};
use judder_structure::assembly::Sparse;
use judder_structure::complex_modes::{ComplexModeSettings, Region, Verdict};
use judder_structure::eigen_sweep::{SweepMethod, SweptEigenvalues, eigen_sweep, eigen_sweeps};

fn term(name: &str, size: usize, entries: impl IntoIterator<Item = (usize, usize, f64)>) -> Term {
    let triplets: Vec<_> = entries.into_iter().map(|(i, j, v)| Triplet::new(i, j, v)).collect();
    Term { name: name.to_owned(), matrix: Sparse::try_new_from_triplets(size, size, &triplets).unwrap() }
}

fn identity(size: usize) -> Term {
    term("mass", size, (0..size).map(|k| (k, k, 1.0)))
}

fn stiffness_factors(factors: impl Iterator<Item = Vec<f64>>) -> Vec<Factors> {
    factors.map(|stiffness| Factors { mass: vec![1.0], damping: vec![], stiffness }).collect()
}

/// The eigenvalue of a branch at every point.
fn values(sweep: &SweptEigenvalues, branch: usize) -> Vec<c64> {
    let of_branch = |point: &judder_structure::eigen_sweep::PointEigenvalues| {
        point.eigenvalues.iter().find(|tracked| tracked.branch == branch).map(|t| t.eigenvalue.value)
    };
    sweep.points.iter().filter_map(of_branch).collect()
}

/// Friction between two modes (N. Hoffmann and others, 2002): their frequencies meet, and from there on one grows as the other decays.
#[test]
fn two_modes_lock_in_as_two_branches() {
    const POINTS: usize = 41;
    let springs = term("springs", 2, [(0, 0, 1.5), (1, 1, 1.0)]);
    let friction = term("friction", 2, [(0, 1, 1.0), (1, 0, -1.0)]);
    let family = AffineFamily::new(vec![identity(2)], vec![], vec![springs, friction]).unwrap();
    let coupling = |k: usize| 0.5 * k as f64 / (POINTS - 1) as f64;
    let points = stiffness_factors((0..POINTS).map(|k| vec![1.0, coupling(k)]));
    let region = Region { re: [-1.0, 1.0], im: [0.1, 3.0] };
    let sweep =
        eigen_sweep(&family, &points, &region, &ComplexModeSettings::default(), SweepMethod::Full).unwrap();
    assert_eq!(sweep.branches, 2);
    for branch in 0..2 {
        assert_eq!(values(&sweep, branch).len(), POINTS, "a branch goes through");
    }
    for (k, point) in sweep.points.iter().enumerate() {
        let verdicts: Vec<Verdict> = point.eigenvalues.iter().map(|t| t.eigenvalue.verdict()).collect();
        // the frequencies meet at a coupling of a quarter
        assert_eq!(verdicts.contains(&Verdict::Unstable), coupling(k) > 0.2500001, "{k}: {verdicts:?}");
    }
    let last = &sweep.points[POINTS - 1].eigenvalues;
    assert!((last[0].eigenvalue.value.im - last[1].eigenvalue.value.im).abs() < 1e-9);
}

#[test]
fn modes_that_cross_keep_their_branches() {
    const POINTS: usize = 30;
    let held = term("held", 3, [(0, 0, 100.0), (2, 2, 900.0)]);
    let rising = term("rising", 3, [(1, 1, 1.0)]);
    let family = AffineFamily::new(vec![identity(3)], vec![], vec![held, rising]).unwrap();
    let frequency = |k: usize| 5.0 + 30.0 * k as f64 / (POINTS - 1) as f64;
    let points = stiffness_factors((0..POINTS).map(|k| vec![1.0, frequency(k).powi(2)]));
    let region = Region { re: [-1.0, 1.0], im: [1.0, 50.0] };
    let sweep =
        eigen_sweep(&family, &points, &region, &ComplexModeSettings::default(), SweepMethod::Full).unwrap();
    assert_eq!(sweep.branches, 3);
    let first: Vec<f64> = (0..3).map(|branch| values(&sweep, branch)[0].im.round()).collect();
    for (branch, first) in first.iter().enumerate() {
        for (k, value) in values(&sweep, branch).iter().enumerate() {
            let expected = if *first == 5.0 { frequency(k) } else { *first };
            assert!((value.im - expected).abs() < 1e-9, "{branch} {k}: {value} {expected}");
        }
    }
}

const CHAIN: usize = 240;

/// Masses in a row on springs, with rotation that couples neighbours and friction that is not symmetric.
fn chain() -> AffineFamily {
    let beside = |seed: u64, size: f64| {
        (0..CHAIN - 1).flat_map(move |k| {
            let value = size * (uniform(seed, k as u64) - 0.3);
            [(k, k + 1, value), (k + 1, k, -value)]
        })
    };
    let springs = (0..CHAIN).map(|k| (k, k, 2.0e6 + 1e4 * uniform(5, k as u64)));
    let springs = springs.chain((0..CHAIN - 1).flat_map(|k| [(k, k + 1, -1.0e6), (k + 1, k, -1.0e6)]));
    AffineFamily::new(
        vec![identity(CHAIN)],
        vec![
            term("damping", CHAIN, (0..CHAIN).map(|k| (k, k, 0.2))),
            term("rotation", CHAIN, beside(1, 1.0)),
        ],
        vec![term("springs", CHAIN, springs), term("friction", CHAIN, beside(2, 2.0e3))],
    )
    .unwrap()
}

fn along_the_chain(points: usize) -> Vec<Factors> {
    (0..points)
        .map(|k| {
            let speed = 1.0 + k as f64 / (points - 1) as f64;
            Factors { mass: vec![1.0], damping: vec![1.0, speed], stiffness: vec![1.0 + 0.02 * speed, speed] }
        })
        .collect()
}

const OF_THE_CHAIN: Region = Region { re: [-20.0, 20.0], im: [10.0, 165.0] };
const FAST: SweepMethod = SweepMethod::Projected { tolerance: 1e-7 };

#[test]
fn the_fast_way_is_within_its_shown_error_of_the_full_one() {
    let (family, points) = (chain(), along_the_chain(15));
    let settings = ComplexModeSettings { data_precision: 0.0, ..ComplexModeSettings::default() };
    let solved = |method| eigen_sweep(&family, &points, &OF_THE_CHAIN, &settings, method).unwrap();
    let (fast, full) = (solved(FAST), solved(SweepMethod::Full));
    let projected = fast.points.iter().filter(|point| !point.full).count();
    assert!(projected >= 10, "{projected} points, samples {:?}", fast.samples);
    assert!(fast.basis.is_some_and(|size| size < CHAIN));
    assert_eq!(fast.branches, full.branches);
    let mut shown = 0;
    for (fast, full) in fast.points.iter().zip(&full.points) {
        assert_eq!(fast.eigenvalues.len(), full.eigenvalues.len());
        for (a, b) in fast.eigenvalues.iter().zip(&full.eigenvalues) {
            let distance = (a.eigenvalue.value - b.eigenvalue.value).norm();
            let allowed = a.eigenvalue.error + b.eigenvalue.error;
            assert!(distance <= allowed, "{}: {distance:e} of {allowed:e}", a.eigenvalue.value);
            assert_eq!(a.branch, b.branch);
            shown += 1;
        }
    }
    assert!(shown > 60, "{shown} eigenvalues");
}

#[test]
fn an_eigenvalue_that_enters_begins_a_branch_in_both_ways() {
    let (family, points) = (chain(), along_the_chain(15));
    let solved_in = |region: &Region, points: &[Factors], method| {
        eigen_sweep(&family, points, region, &ComplexModeSettings::default(), method).unwrap()
    };
    // an edge that the uppermost eigenvalue crosses halfway
    let ends = [points[0].clone(), points[14].clone()];
    let ends = solved_in(&OF_THE_CHAIN, &ends, SweepMethod::Full);
    let uppermost = |k: usize| ends.points[k].eigenvalues.last().unwrap().eigenvalue.value.im;
    let narrow = Region { im: [100.0, 0.5 * (uppermost(0) + uppermost(1))], ..OF_THE_CHAIN };
    let solved = |method| solved_in(&narrow, &points, method);
    let (fast, full) = (solved(FAST), solved(SweepMethod::Full));
    assert!(fast.points.iter().any(|point| !point.full));
    let counts = |sweep: &SweptEigenvalues| {
        sweep.points.iter().map(|point| point.eigenvalues.len()).collect::<Vec<_>>()
    };
    assert_eq!(counts(&fast), counts(&full));
    assert!(counts(&full).iter().min() < counts(&full).iter().max(), "{:?}", counts(&full));
}

/// A mode of its own that rushes into the region and out again: samples are taken where the factors differ most.
#[test]
fn an_eigenvalue_that_only_two_points_have_is_found() {
    let chain = chain();
    let alone = |size: f64| {
        let entries = (0..CHAIN).map(|k| (k, k, if k == CHAIN - 1 { size } else { 0.0 }));
        term("alone", CHAIN, entries)
    };
    let cut = |matrix: &Sparse| {
        let kept = (0..CHAIN - 1).flat_map(|column| {
            let values = matrix.val_of_col(column).to_vec();
            let rows: Vec<usize> = matrix.row_idx_of_col(column).collect();
            rows.into_iter()
                .zip(values)
                .filter(|(row, _)| *row < CHAIN - 1)
                .map(move |(row, v)| (row, column, v))
        });
        term("cut", CHAIN, kept)
    };
    let of = |terms: &[Term]| terms.iter().map(|term| cut(&term.matrix)).collect::<Vec<_>>();
    let (damping, mut stiffness) = (of(chain.damping()), of(chain.stiffness()));
    stiffness.push(alone(1.0));
    let family = AffineFamily::new(vec![identity(CHAIN)], damping, stiffness).unwrap();
    let points: Vec<Factors> = along_the_chain(11)
        .into_iter()
        .enumerate()
        .map(|(k, mut factors)| {
            // at two points between the ends and the middle it swings with 80 1/s, elsewhere with 1000 1/s
            let frequency = if k == 3 || k == 4 { 80.0_f64 } else { 1000.0 };
            factors.stiffness.push(frequency.powi(2));
            factors
        })
        .collect();
    let settings = ComplexModeSettings::default();
    let fast = eigen_sweep(&family, &points, &OF_THE_CHAIN, &settings, FAST).unwrap();
    let full = eigen_sweep(&family, &points, &OF_THE_CHAIN, &settings, SweepMethod::Full).unwrap();
    for (k, (fast, full)) in fast.points.iter().zip(&full.points).enumerate() {
        assert_eq!(fast.eigenvalues.len(), full.eigenvalues.len(), "{k}");
    }
}

#[test]
fn one_basis_serves_two_parameters() {
    let family = chain();
    let at = |speed: f64, friction: f64| Factors {
        mass: vec![1.0],
        damping: vec![1.0, speed],
        stiffness: vec![1.0 + 0.01 * speed, friction],
    };
    let curve = |friction: f64| (0..6).map(|k| at(1.0 + 0.2 * f64::from(k), friction)).collect::<Vec<_>>();
    let curves: Vec<Vec<Factors>> = (0..4).map(|k| curve(0.5 + 0.5 * f64::from(k))).collect();
    let curves: Vec<&[Factors]> = curves.iter().map(Vec::as_slice).collect();
    let settings = ComplexModeSettings { data_precision: 0.0, ..ComplexModeSettings::default() };
    let solved = |method| eigen_sweeps(&family, &curves, &OF_THE_CHAIN, &settings, method).unwrap();
    let (fast, full) = (solved(FAST), solved(SweepMethod::Full));
    assert!(fast.iter().all(|sweep| sweep.points.iter().any(|point| !point.full)));
    for (fast, full) in fast.iter().zip(&full) {
        assert_eq!(fast.branches, full.branches);
        for (a, b) in fast.points.iter().zip(&full.points) {
            assert_eq!(a.eigenvalues.len(), b.eigenvalues.len());
            for (a, b) in a.eigenvalues.iter().zip(&b.eigenvalues) {
                let distance = (a.eigenvalue.value - b.eigenvalue.value).norm();
                assert!(distance <= a.eigenvalue.error + b.eigenvalue.error, "{}", a.eigenvalue.value);
            }
        }
    }
}

#[test]
fn a_sweep_does_not_depend_on_the_threads() {
    let (family, points) = (chain(), along_the_chain(9));
    let with_threads = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            eigen_sweep(&family, &points, &OF_THE_CHAIN, &ComplexModeSettings::default(), FAST).unwrap()
        })
    };
    assert_eq!(with_threads(1), with_threads(3));
}

#[test]
fn too_few_factors_are_refused() {
    let points = [Factors { mass: vec![1.0], damping: vec![1.0], stiffness: vec![1.0, 1.0] }];
    let refused =
        eigen_sweep(&chain(), &points, &OF_THE_CHAIN, &ComplexModeSettings::default(), FAST).unwrap_err();
    assert!(matches!(refused, StructureError::WrongFactors { name: "damping", found: 1, terms: 2 }));
}
