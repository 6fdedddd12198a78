//! The diagnosis of modes against differences of recomputed ones.

use faer::c64;
use faer::sparse::Triplet;
use judder_structure::affine::{Factors, Family, Term};
use judder_structure::assembly::Sparse;
use judder_structure::complex_modes::{ComplexMode, Region, Settings, complex_modes};
use judder_structure::diagnosis::{Part, diagnosis, participations};
use judder_structure::modes::{Wanted, modes};

fn term(name: &str, entries: &[(usize, usize, f64)]) -> Term {
    let triplets: Vec<_> = entries.iter().map(|(i, j, v)| Triplet::new(*i, *j, *v)).collect();
    Term { name: name.to_owned(), matrix: Sparse::try_new_from_triplets(3, 3, &triplets).unwrap() }
}

/// Three masses on springs, with dampers, rotation and friction.
fn family() -> Family {
    Family::new(
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

fn modes_at(family: &Family, factors: &Factors) -> Vec<ComplexMode> {
    let problem = family.at(factors).unwrap();
    let found = complex_modes(&problem, &REGION, &Settings::default()).unwrap();
    assert!(found.complete());
    found.modes
}

#[test]
fn the_works_of_the_matrices_sum_to_the_growth_rate() {
    let modes = modes_at(&family(), &factors());
    assert_eq!(modes.len(), 3);
    for mode in &modes {
        let diagnosis = diagnosis(&family(), &factors(), mode).unwrap();
        let sum: f64 = diagnosis.influences.iter().map(|influence| influence.growth).sum();
        assert!((sum - mode.eigenvalue.value.re).abs() < 1e-12, "{sum} {}", mode.eigenvalue.value);
        assert!(diagnosis.positive_energy);
        for influence in &diagnosis.influences {
            let name = influence.name.as_str();
            match name {
                "first damper" | "second damper" => assert!(influence.growth < 0.0, "{name}"),
                "rotation" | "springs" | "mass" => assert!(influence.growth.abs() < 1e-14, "{name}"),
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
    let family = Family::new(vec![mass], vec![damper], vec![springs, friction]).unwrap();
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
    assert!(diagnosis.influences.iter().all(|i| i.part == Part::Damping || !i.is_paradox()));
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
    let components = modes(springs, problem.mass(), Wanted::Lowest(3)).unwrap().modes;
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
