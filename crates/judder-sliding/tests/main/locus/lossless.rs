//! Pairs that cannot grow, pairs with equal modes, and how far eigenvalues may be off.

use judder_numerics::counter::uniform;
use judder_sliding::SlidingError;
use judder_sliding::characteristic::PairCharacteristic;
use judder_sliding::coupling::{Coupling, Feedback};
use judder_sliding::dense_forms::ThreeField;
use judder_sliding::spectrum::{Spectrum, WantedEigenvalues};
use judder_sliding::zones::zones;
use num_complex::Complex64;

/// Frequencies of modes in groups of up to six, each group with one damping, none for every third.
fn grouped(seed: u64, modes: usize) -> (Vec<f64>, Vec<f64>) {
    let drawn = |list: u64, k: usize| uniform(seed, 1000 * list + k as u64);
    let (mut eigenvalues, mut damping) = (Vec::new(), Vec::new());
    for group in 0.. {
        let (frequency, ratio) = (1.0 + 30.0 * drawn(1, group), 0.02 * drawn(2, group));
        let own = if group % 3 == 0 { 0.0 } else { ratio * frequency };
        for _ in 0..1 + (6.0 * drawn(3, group).powi(2)) as usize {
            eigenvalues.push(frequency * frequency);
            damping.push(own);
        }
        if eigenvalues.len() >= modes {
            return (eigenvalues, damping);
        }
    }
    unreachable!()
}

/// Numbers between −1 and 1, some of them zero: modes that the contact does not move.
fn row(seed: u64, which: u64, modes: usize) -> Vec<f64> {
    let entry = |k: usize| {
        let place = 1000 * which + k as u64;
        if uniform(seed + 7, place) < 0.2 { 0.0 } else { 2.0 * uniform(seed, place) - 1.0 }
    };
    (0..modes).map(entry).collect()
}

/// A contact without friction that turns on the modes as the parameter grows: c = e, damping never negative. Nothing grows, whatever the
/// frequencies, equal or not, moved by the contact or not, damped or not; growth rates are below their errors, and no zone is told.
#[test]
fn lossless_pairs_have_no_unstable_zones() {
    let mut undamped = 0;
    for seed in 0..60 {
        let (eigenvalues, damping) = grouped(seed, 4 + (seed % 7) as usize);
        let modes = eigenvalues.len();
        let (one, other) = (row(seed, 10, modes), row(seed, 11, modes));
        let family = |at: f64| -> Result<PairCharacteristic, SlidingError> {
            let turned: Vec<f64> = one.iter().zip(&other).map(|(a, b)| at.cos() * a + at.sin() * b).collect();
            let coupling =
                Coupling { compatibility: turned.clone(), equilibrium: turned, feedback: Vec::new() };
            PairCharacteristic::new(&coupling, &eigenvalues, &damping)
        };
        let count = (modes - 1).min(6);
        let found = zones(&family, &[[0.1, 0.6], [0.6, 1.2]], count, 1e-3).unwrap();
        assert_eq!(found.zones, [], "{seed}");
        let spectrum = Spectrum::new(&family(0.4).unwrap(), 0.4, WantedEigenvalues::Lowest(count)).unwrap();
        assert!(spectrum.eigenvalues.iter().zip(&spectrum.errors).all(|(s, error)| s.re <= *error), "{seed}");
        undamped += spectrum.eigenvalues.iter().filter(|s| s.re.abs() < 1e-12).count();
    }
    // the test would say nothing without eigenvalues on the axis
    assert!(undamped > 40, "{undamped}");
}

/// Equal modes, up to six of a frequency, with friction and feedbacks: as many eigenvalues as full matrices have, none besides.
#[test]
fn all_eigenvalues_of_equal_modes_are_found() {
    const LIMIT: f64 = 24.0;
    let mut repeated = 0;
    for seed in 100..300_u64 {
        let (eigenvalues, damping) = grouped(seed, 5 + (seed % 9) as usize);
        let modes = eigenvalues.len();
        let feedback = (0..seed % 4).map(|k| Feedback {
            row: row(seed, 20 + k, modes),
            column: row(seed, 30 + k, modes),
            follows_velocity: k % 2 == 0,
        });
        let compatibility = row(seed, 10, modes);
        let equilibrium =
            compatibility.iter().zip(row(seed, 11, modes)).map(|(c, aside)| c + 0.3 * aside).collect();
        let coupling = Coupling { compatibility, equilibrium, feedback: feedback.collect() };
        if coupling.mobility() < 1e-2 {
            continue;
        }
        let function = PairCharacteristic::new(&coupling, &eigenvalues, &damping).unwrap();
        let dense =
            ThreeField::new(&coupling, &eigenvalues, &damping).unwrap().primal_spectrum(0.37).unwrap();
        // none so near to a border that rounding decides
        let border = |s: &Complex64| (s.im - LIMIT).abs().min((s.re.abs() - LIMIT).abs());
        if dense.iter().any(|s| border(s) < 1e-3) {
            continue;
        }
        let expected: Vec<Complex64> =
            dense.into_iter().filter(|s| s.im > -1e-6 && s.im <= LIMIT && s.re.abs() <= LIMIT).collect();
        let found = Spectrum::new(&function, 0.0, WantedEigenvalues::Below(LIMIT));
        let found = found.unwrap_or_else(|error| panic!("{seed}: {error}")).eigenvalues;
        assert_eq!(found.len(), expected.len(), "{seed}: {found:?} {expected:?}");
        let mut left = expected;
        for s in &found {
            let distance = |k: &usize| (left[*k] - s).norm();
            let nearest = (0..left.len()).min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap();
            assert!(distance(&nearest) < 1e-4, "{seed}: {s} {left:?}");
            left.swap_remove(nearest);
        }
        repeated += found.windows(2).filter(|pair| (pair[1] - pair[0]).norm() < 1e-9).count();
    }
    // the test would say nothing without equal ones
    assert!(repeated > 200, "{repeated}");
}

/// Frequencies, dampings and shapes moved at random by a relative 1e-9: no eigenvalue moves farther than its error says, which is that of a
/// relative 1e-12, and most move no less than a hundredth of it.
#[test]
fn errors_bound_what_disturbed_numbers_do() {
    const DISTURBANCE: f64 = 1e-9;
    let (mut all, mut near) = (0, 0);
    for seed in 400..460_u64 {
        let modes = 5 + (seed % 6) as usize;
        let eigenvalues: Vec<f64> =
            (0..modes).map(|k| (1.0 + 30.0 * uniform(seed, 5000 + k as u64)).powi(2)).collect();
        let damping: Vec<f64> = eigenvalues.iter().map(|own| 0.01 * own.sqrt()).collect();
        let rows: Vec<Vec<f64>> = (0..4).map(|which| row(seed, 10 + which, modes)).collect();
        let spectrum = |by: f64| {
            let moved = |list: &[f64], stream: u64| -> Vec<f64> {
                let of = |k: usize| 1.0 + by * (2.0 * uniform(seed + 1, 1000 * stream + k as u64) - 1.0);
                list.iter().enumerate().map(|(k, value)| value * of(k)).collect()
            };
            let [c, aside, r, b] = [0, 1, 2, 3].map(|k| moved(&rows[k], 90 + k as u64));
            let feedback = Feedback { row: r, column: b, follows_velocity: seed % 2 == 0 };
            let equilibrium = c.iter().zip(&aside).map(|(c, aside)| c + 0.3 * aside).collect();
            let coupling = Coupling { compatibility: c, equilibrium, feedback: vec![feedback] };
            let function =
                PairCharacteristic::new(&coupling, &moved(&eigenvalues, 98), &moved(&damping, 99)).unwrap();
            Spectrum::new(&function, 0.0, WantedEigenvalues::Below(25.0))
        };
        let (Ok(still), Ok(moved)) = (spectrum(0.0), spectrum(DISTURBANCE)) else { continue };
        if still.eigenvalues.len() != moved.eigenvalues.len() {
            continue;
        }
        for (s, error) in still.eigenvalues.iter().zip(&still.errors) {
            let away = moved.eigenvalues.iter().map(|other| (other - s).norm()).fold(f64::INFINITY, f64::min);
            // c, and through it e, may each be moved
            let allowed = 3.0 * error * DISTURBANCE / 1e-12;
            assert!(away <= allowed, "{seed} {s}: {away:e} {allowed:e}");
            all += 1;
            near += usize::from(away > 0.01 * allowed);
        }
    }
    assert!(all > 200 && 2 * near > all, "{near} of {all}");
}
