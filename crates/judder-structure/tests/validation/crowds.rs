//! Complex modes that stand in one place, many at a time, or decades apart: spectra that are known beforehand.

use super::complex_modes::{diagonal, disguised, root, sparse};
use faer::c64;
use judder_memory::{HeldMemory, MemoryBudget};
use judder_structure::StructureError;
use judder_structure::assembly::Sparse;
use judder_structure::complex_modes::{ComplexModeSettings, ComplexModes, Region, complex_modes};
use judder_structure::quadratic::Quadratic;

fn modes(problem: &Quadratic, region: &Region) -> ComplexModes {
    complex_modes(problem, region, &ComplexModeSettings::default()).unwrap()
}

/// Oscillators with two degrees of freedom that friction couples (N. Hoffmann and others, 2002), side by side, each stiffer by a factor.
fn pads(factors: &[f64]) -> Quadratic {
    let size = 2 * factors.len();
    let freedoms = || (0..size).map(|k| (k, k));
    let stiffness = factors.iter().enumerate().flat_map(|(pad, factor)| {
        [(0, 0, 2.0), (0, 1, -0.7), (1, 0, 0.4), (1, 1, 1.0)]
            .map(|(i, j, entry)| (2 * pad + i, 2 * pad + j, factor * entry))
    });
    Quadratic::new(
        sparse(size, freedoms().map(|(i, j)| (i, j, 1.0))),
        sparse(size, freedoms().map(|(i, j)| (i, j, 0.05))),
        sparse(size, stiffness),
    )
    .unwrap()
}

/// Factors of which the first are equal, or each larger by a share than the one before; the rest clearly larger.
fn factors(count: usize, equal: usize, apart: f64) -> Vec<f64> {
    let larger = |pad: usize| 0.01 * pad.saturating_sub(equal - 1) as f64;
    (0..count).map(|pad| 1.0 + apart * pad as f64 + larger(pad)).collect()
}

const APART: [f64; 5] = [0.0, 1e-14, 1e-12, 1e-8, 1e-5];

/// Every pad has two eigenvalues in the region.
#[test]
fn equal_pads_have_as_many_modes_as_there_are_pads() {
    let region = Region { re: [-2.0, 2.0], im: [0.1, 4.0] };
    for count in [1, 4, 5, 8, 12, 40] {
        for apart in APART {
            let modes = modes(&pads(&factors(count, count, apart)), &region);
            assert!(modes.complete(), "{count} pads, equal but for {apart}: {:?}", modes.gaps);
            assert_eq!(modes.modes.len(), 2 * count, "{count} pads, equal but for {apart}");
        }
    }
}

/// Too many to be solved whole: what a search finds is as much as each pad has alone, or it says that it may not be.
#[test]
#[ignore = "expensive: run by make validate"]
fn a_search_among_equal_pads_finds_all() {
    let region = Region { re: [-0.2, 0.2], im: [1.15, 1.32] };
    for (equal, apart) in [(3, 0.0), (5, 0.0), (5, 1e-12), (12, 1e-14)] {
        let factors = factors(104, equal, apart);
        let alone: usize = factors.iter().map(|factor| modes(&pads(&[*factor]), &region).modes.len()).sum();
        assert!(alone > 2 * equal);
        let found = modes(&pads(&factors), &region);
        println!("{equal} equal but for {apart}: {} of {alone}, {}", found.modes.len(), found.complete());
        assert!(found.complete() && found.modes.len() == alone, "{equal} equal but for {apart}");
    }
}

/// λ² + 0.02 λ + ω² eight times and seven others, in a full matrix; once more with a hundred others.
#[test]
fn an_eigenvalue_may_fill_more_than_half_of_the_freedoms() {
    for beside in [7, 100] {
        let frequencies: Vec<f64> =
            std::iter::repeat_n(2.0, 8).chain((0..beside).map(|k| 3.0 + 0.05 * f64::from(k))).collect();
        let of = |f: &dyn Fn(f64) -> f64| -> Sparse {
            disguised(&diagonal(&frequencies.iter().map(|w| f(*w)).collect::<Vec<f64>>()))
        };
        let problem = Quadratic::new(of(&|_| 1.0), of(&|_| 0.02), of(&|w| w * w)).unwrap();
        let modes = modes(&problem, &Region { re: [-1.0, 1.0], im: [0.5, 2.5] });
        assert!(modes.complete(), "{:?}", modes.gaps);
        assert_eq!(modes.modes.len(), 8);
        for mode in &modes.modes {
            let distance = (mode.eigenvalue.value - root(2.0, 0.005)).norm();
            assert!(distance <= mode.eigenvalue.error && !mode.eigenvalue.defective, "{:?}", mode.eigenvalue);
        }
    }
}

/// A crowd that no search can count is told, and is not called complete.
#[test]
#[ignore = "expensive: run by make validate"]
fn a_crowd_beyond_counting_is_told() {
    let frequencies = vec![2.0; 210];
    let of = |f: &dyn Fn(f64) -> f64| diagonal(&frequencies.iter().map(|w| f(*w)).collect::<Vec<f64>>());
    let problem = Quadratic::new(of(&|_| 1.0), of(&|_| 0.02), of(&|w| w * w)).unwrap();
    let modes = modes(&problem, &Region { re: [-1.0, 1.0], im: [0.5, 2.5] });
    assert!(
        !modes.modes.is_empty() && modes.complete() == (modes.modes.len() == 210),
        "{}",
        modes.modes.len()
    );
}

/// So many frequencies over five decades in one region: it is halved until its discs hold what is in them.
fn a_wide_region_is_covered(count: u32) {
    let pairs: Vec<f64> = (0..count).map(|k| 10_f64.powf(5.0 * f64::from(k) / f64::from(count))).collect();
    let of =
        |f: &dyn Fn(f64) -> f64| disguised(&diagonal(&pairs.iter().map(|w| f(*w)).collect::<Vec<f64>>()));
    let problem = Quadratic::new(of(&|_| 1.0), of(&|w| 0.02 * w), of(&|w| w * w)).unwrap();
    let modes = modes(&problem, &Region { re: [-2e4, 2e4], im: [0.5, 2e5] });
    assert!(modes.complete(), "{count}: {:?}", modes.gaps);
    assert_eq!(modes.modes.len(), pairs.len());
    for (mode, frequency) in modes.modes.iter().zip(&pairs) {
        let distance = (mode.eigenvalue.value - root(*frequency, 0.01)).norm();
        assert!(distance <= mode.eigenvalue.error, "{frequency}: {distance:e} {:?}", mode.eigenvalue);
    }
}

#[test]
fn a_wide_region_is_covered_to_its_crowded_end() {
    a_wide_region_is_covered(100);
}

#[test]
#[ignore = "expensive: run by make validate"]
fn a_wide_region_is_covered_to_an_end_of_large_crowds() {
    a_wide_region_is_covered(250);
}

/// Of a diagonal every eigenvalue is known to its own entries, however much larger others are: those outside do not count as inside.
#[test]
fn what_is_small_beside_the_rest_of_a_matrix_keeps_its_place() {
    let scales: Vec<f64> = (0..18).map(|k| 10_f64.powi(k - 9)).collect();
    let frequencies: Vec<f64> = (0..18).map(|k| 1.0 + 0.5 * f64::from(k)).collect();
    let of = |f: &dyn Fn(f64) -> f64| {
        diagonal(&scales.iter().zip(&frequencies).map(|(s, w)| s * f(*w)).collect::<Vec<f64>>())
    };
    let problem = Quadratic::new(of(&|_| 1.0), of(&|w| 0.1 * w), of(&|w| w * w)).unwrap();
    let modes = modes(&problem, &Region { re: [-2.0, 2.0], im: [0.1, 6.75] });
    assert!(modes.complete(), "{:?}", modes.gaps);
    let found: Vec<c64> = modes.modes.iter().map(|mode| mode.eigenvalue.value).collect();
    assert_eq!(found.len(), 12, "{found:?}");
    for (value, frequency) in found.iter().zip(&frequencies) {
        assert!((value - root(*frequency, 0.05)).norm() < 1e-12 * frequency, "{value}");
    }
}

/// Enough pads for a factor on a pattern; a search of a part of them.
#[test]
fn a_search_that_would_hold_too_much_is_refused_and_holds_nothing_afterwards() {
    let problem = pads(&factors(300, 1, 0.1));
    let region = Region { re: [-0.2, 0.2], im: [3.0, 3.2] };
    let within = |bytes| {
        let memory = HeldMemory::of(MemoryBudget::of_bytes(bytes));
        let settings = ComplexModeSettings { memory: memory.clone(), ..ComplexModeSettings::default() };
        let found = complex_modes(&problem, &region, &settings);
        (found, memory.take(bytes).is_ok())
    };
    let (found, given_back) = within(1 << 30);
    assert_eq!(found.unwrap(), modes(&problem, &region));
    assert!(given_back);
    // the vectors of a basis alone take as much
    let (refused, given_back) = within(100_000);
    assert!(
        matches!(&refused, Err(StructureError::BeyondMemory { beyond }) if beyond.budget == 100_000),
        "{refused:?}"
    );
    assert!(given_back);
}
