//! The diagnosis of modes against differences of recomputed ones.

use faer::c64;
use faer::sparse::Triplet;
use judder_numerics::counter::uniform;
use judder_structure::affine::{AffineFamily, Factors, Term};
use judder_structure::assembly::Sparse;
use judder_structure::complex_modes::{ComplexMode, ComplexModeSettings, Region, complex_modes};
use judder_structure::diagnosis::{EnergySign, MatrixSum, diagnosis, participations};
use judder_structure::modes::{WantedModes, modes};

fn term(name: &str, entries: &[(usize, usize, f64)]) -> Term {
    let triplets: Vec<_> = entries.iter().map(|(i, j, v)| Triplet::new(*i, *j, *v)).collect();
    Term { name: name.to_owned(), matrix: Sparse::try_new_from_triplets(3, 3, &triplets).unwrap() }
}

/// Three masses on springs, with dampers, rotation and friction.
fn family() -> AffineFamily {
    AffineFamily::new(
        vec![term("mass", &[(0, 0, 1.0), (1, 1, 1.5), (2, 2, 0.8)])],
        vec![
            term("first damper", &[(0, 0, 1.0)]),
            term("second damper", &[(1, 1, 1.0), (1, 2, -1.0), (2, 1, -1.0), (2, 2, 1.0)]),
            term("rotation", &[(0, 1, 1.0), (1, 0, -1.0)]),
        ],
        vec![
            term("springs", &[(0, 0, 5.0), (0, 1, -1.0), (1, 0, -1.0), (1, 1, 7.0), (2, 2, 9.0)]),
            term("friction", &[(0, 1, 1.0), (1, 2, -0.4), (2, 1, 0.1)]),
        ],
    )
    .unwrap()
}

fn factors() -> Factors {
    Factors { mass: vec![1.0], damping: vec![0.03, 0.05, 0.2], stiffness: vec![1.0, 1.7] }
}

const REGION: Region = Region { re: [-2.0, 2.0], im: [0.5, 6.0] };

fn modes_at(family: &AffineFamily, factors: &Factors) -> Vec<ComplexMode> {
    let problem = family.at(factors).unwrap();
    let found = complex_modes(&problem, &REGION, &ComplexModeSettings::default()).unwrap();
    assert!(found.complete());
    found.modes
}

#[test]
fn the_works_of_the_matrices_sum_to_the_growth_rate() {
    let modes = modes_at(&family(), &factors());
    assert_eq!(modes.len(), 3);
    for mode in &modes {
        let diagnosis = diagnosis(&family(), &factors(), mode).unwrap();
        let sum: f64 = diagnosis.influences.iter().map(|influence| influence.growth.unwrap()).sum();
        assert!((sum - mode.eigenvalue.value.re).abs() < 1e-12, "{sum} {}", mode.eigenvalue.value);
        assert!(diagnosis.energy.sign() == EnergySign::Positive && diagnosis.balance < 1e-14);
        for influence in &diagnosis.influences {
            let (name, growth) = (influence.name.as_str(), influence.growth.unwrap());
            match name {
                "first damper" | "second damper" => assert!(growth < 0.0, "{name}"),
                "rotation" | "springs" | "mass" => assert!(growth.abs() < 1e-14, "{name}"),
                _ => assert_eq!(name, "friction"),
            }
        }
    }
}

/// Central differences of the recomputed eigenvalues.
#[test]
fn sensitivities_are_the_differences_of_recomputed_eigenvalues() {
    const STEP: f64 = 1e-5;
    let (family, at) = (family(), factors());
    for (k, mode) in modes_at(&family, &at).iter().enumerate() {
        let diagnosis = diagnosis(&family, &at, mode).unwrap();
        for (number, influence) in diagnosis.influences.iter().enumerate() {
            let moved = |step: f64| -> c64 {
                let mut factors = at.clone();
                match number {
                    0 => factors.mass[0] += step,
                    1..=3 => factors.damping[number - 1] += step,
                    _ => factors.stiffness[number - 4] += step,
                }
                modes_at(&family, &factors)[k].eigenvalue.value
            };
            let expected = (moved(STEP) - moved(-STEP)) / (2.0 * STEP);
            let apart = (influence.sensitivity - expected).norm();
            assert!(apart < 1e-8, "{}: {} {expected}", influence.name, influence.sensitivity);
        }
    }
}

/// Two modes that friction couples, one of them damped: damping one mode alone moves the threshold of flutter down (N. Hoffmann and
/// L. Gaul, *Effects of damping on mode-coupling instability in friction induced oscillations*, ZAMM 83, 2003).
#[test]
fn damping_of_one_mode_alone_is_a_paradox() {
    let mass = Term { name: "mass".to_owned(), matrix: two([(0, 0, 1.0), (1, 1, 1.0)]) };
    let damper = Term { name: "damper".to_owned(), matrix: two([(0, 0, 1.0)]) };
    let springs = Term { name: "springs".to_owned(), matrix: two([(0, 0, 2.0), (1, 1, 1.0)]) };
    let friction = Term { name: "friction".to_owned(), matrix: two([(0, 1, 1.0), (1, 0, -1.0)]) };
    let family = AffineFamily::new(vec![mass], vec![damper], vec![springs, friction]).unwrap();
    let at = |damping: f64| Factors { mass: vec![1.0], damping: vec![damping], stiffness: vec![1.0, 0.49] };
    let growth = |damping: f64| {
        let growths = modes_at(&family, &at(damping)).into_iter().map(|mode| mode.eigenvalue.value.re);
        growths.fold(f64::NEG_INFINITY, f64::max)
    };
    assert!(growth(0.2) > growth(0.1) && growth(0.1) > 0.0);
    let modes = modes_at(&family, &at(0.1));
    let unstable = modes.iter().find(|mode| mode.eigenvalue.value.re > 0.0).unwrap();
    let diagnosis = diagnosis(&family, &at(0.1), unstable).unwrap();
    let paradoxes: Vec<&str> =
        diagnosis.influences.iter().filter(|i| i.is_paradox()).map(|i| i.name.as_str()).collect();
    assert_eq!(paradoxes, ["damper"]);
    assert!(diagnosis.influences.iter().all(|i| i.part == MatrixSum::Damping || !i.is_paradox()));
}

fn two<const N: usize>(entries: [(usize, usize, f64); N]) -> Sparse {
    let triplets: Vec<_> = entries.iter().map(|(i, j, v)| Triplet::new(*i, *j, *v)).collect();
    Sparse::try_new_from_triplets(2, 2, &triplets).unwrap()
}

#[test]
fn the_shares_of_all_undamped_modes_sum_to_one() {
    let (family, at) = (family(), factors());
    let problem = family.at(&at).unwrap();
    let springs = &family.stiffness()[0].matrix;
    let components = modes(springs, problem.mass(), WantedModes::Lowest(3)).unwrap().modes;
    for mode in modes_at(&family, &at) {
        let shares = participations(problem.mass(), &components, &mode);
        let sum: f64 = shares.iter().map(|p| p.share).sum();
        assert!((sum - 1.0).abs() < 1e-12, "{sum}");
        assert!(shares.iter().all(|p| (0.0..=1.0 + 1e-12).contains(&p.assurance)));
    }
    // without friction, rotation and damping a mode is its own component
    let still = Factors { mass: vec![1.0], damping: vec![0.0; 3], stiffness: vec![1.0, 0.0] };
    for (k, mode) in modes_at(&family, &still).iter().enumerate() {
        let shares = participations(problem.mass(), &components, mode);
        assert!((shares[k].share - 1.0).abs() < 1e-12 && (shares[k].assurance - 1.0).abs() < 1e-12);
    }
}

/// A square matrix of random entries between −1 and 1, with a part of it and of its transpose.
fn random(seed: u64, size: usize, mirrored: f64) -> Vec<(usize, usize, f64)> {
    let entry = |i: usize, j: usize| 2.0 * uniform(seed, (i * size + j) as u64) - 1.0;
    let places = (0..size).flat_map(|i| (0..size).map(move |j| (i, j)));
    places.map(|(i, j)| (i, j, 0.5 * (entry(i, j) + mirrored * entry(j, i)))).collect()
}

fn named(name: &str, size: usize, entries: &[(usize, usize, f64)]) -> Term {
    let triplets: Vec<_> = entries.iter().map(|(i, j, v)| Triplet::new(*i, *j, *v)).collect();
    Term { name: name.to_owned(), matrix: Sparse::try_new_from_triplets(size, size, &triplets).unwrap() }
}

/// Random masses on springs that push as well as pull, with rotation, dampers and friction; its modes that grow.
fn growing(seed: u64, factors: &Factors) -> (AffineFamily, Vec<ComplexMode>) {
    let size = 2 + (seed % 5) as usize;
    let masses: Vec<_> = (0..size).map(|i| (i, i, 0.5 + uniform(seed + 1, i as u64))).collect();
    let dampers: Vec<_> = (0..size).map(|i| (i, i, 0.2 + uniform(seed + 2, i as u64))).collect();
    let family = AffineFamily::new(
        vec![named("mass", size, &masses)],
        vec![named("rotation", size, &random(seed + 3, size, -1.0)), named("dampers", size, &dampers)],
        vec![
            named("springs", size, &random(seed + 4, size, 1.0)),
            named("friction", size, &random(seed + 5, size, -1.0)),
        ],
    )
    .unwrap();
    let region = Region { re: [1e-2, 8.0], im: [-1e-3, 8.0] };
    let found =
        complex_modes(&family.at(factors).unwrap(), &region, &ComplexModeSettings::default()).unwrap();
    (family, found.modes)
}

/// What grows where nothing does work has no energy (σ E is the power of all matrices), and its growth is no matrix's: random
/// conservative systems with rotation, whose growth is divergence or gyroscopic flutter, and real growth under friction without damping.
#[test]
fn what_grows_without_work_has_no_energy_to_divide_by() {
    let (mut conservative, mut divergent) = (0, 0);
    for seed in 0..60 {
        for (rotation, friction) in [(3.0, 0.0), (0.0, 0.0), (0.0, 1.5)] {
            let at =
                Factors { mass: vec![1.0], damping: vec![rotation, 0.0], stiffness: vec![1.0, friction] };
            let (family, modes) = growing(100 * seed, &at);
            for mode in &modes {
                let value = mode.eigenvalue.value;
                let told = diagnosis(&family, &at, mode).unwrap();
                assert!(told.balance < 1e-13, "{seed} {value}: {}", told.balance);
                let (sign, is_real) = (told.energy.sign(), value.im.abs() < 1e-9);
                if friction > 0.0 && !is_real {
                    assert!(sign != EnergySign::None, "{seed} {value}: {:?}", told.energy);
                    continue;
                }
                conservative += usize::from(friction == 0.0);
                divergent += usize::from(friction > 0.0);
                assert!(sign == EnergySign::None, "{seed} {friction} {value}: {:?}", told.energy);
                assert!(told.energy.growth_error().is_none() && told.energy.share.abs() < 1e-11);
                assert!(told.influences.iter().all(|own| own.growth.is_none() && !own.is_paradox()));
            }
        }
    }
    // the test would say nothing without either
    assert!(conservative > 100 && divergent > 20, "{conservative} {divergent}");
}

/// Dampers that fade: the energy fades with them, and the growths keep to the error that is told until they are not told at all.
#[test]
fn growths_over_a_small_energy_are_as_good_as_is_told() {
    let (mut told_growths, mut none) = (0, 0);
    for seed in 0..20 {
        for damping in [1e-1, 1e-4, 1e-7, 1e-10, 1e-13] {
            let at = Factors { mass: vec![1.0], damping: vec![2.0, damping], stiffness: vec![1.0, 0.0] };
            let (family, modes) = growing(100 * seed, &at);
            for mode in &modes {
                let told = diagnosis(&family, &at, mode).unwrap();
                let Some(error) = told.energy.growth_error() else {
                    none += 1;
                    continue;
                };
                told_growths += 1;
                let growth: f64 = told.influences.iter().filter_map(|own| own.growth).sum();
                let value = mode.eigenvalue.value;
                assert!(
                    (growth - value.re).abs() <= error * value.norm(),
                    "{seed} {damping}: {growth} {value}"
                );
                // dampers take energy out: what grows has a negative one
                assert!(told.energy.sign() == EnergySign::Negative, "{seed} {damping}: {:?}", told.energy);
                assert!(damping < 1e-3 || error < 1e-6, "{error}");
            }
        }
    }
    assert!(told_growths > 50 && none > 20, "{told_growths} {none}");
}

/// Freedoms without mass that a negative damper drives: no kinetic energy, of which nothing can be a share.
#[test]
fn no_mode_takes_part_in_one_without_kinetic_energy() {
    let family = AffineFamily::new(
        vec![named("mass", 2, &[(0, 0, 1.0)])],
        vec![named("damper", 2, &[(0, 0, 0.1), (1, 1, -1.0)])],
        vec![named("springs", 2, &[(0, 0, 4.0), (1, 1, 3.0)])],
    )
    .unwrap();
    let at = Factors { mass: vec![1.0], damping: vec![1.0], stiffness: vec![1.0] };
    let problem = family.at(&at).unwrap();
    let region = Region { re: [1.0, 5.0], im: [-0.1, 3.0] };
    let found = complex_modes(&problem, &region, &ComplexModeSettings::default()).unwrap().modes;
    assert!(found.len() == 1 && (found[0].eigenvalue.value - 3.0).norm() < 1e-12);
    let components = modes(problem.stiffness(), problem.mass(), WantedModes::Lowest(1)).unwrap().modes;
    assert!(participations(problem.mass(), &components, &found[0]).is_empty());
}
