//! Points of the unit cube against closed forms of their evenness.

use judder_numerics::counter::uniform;
use judder_numerics::sampling::{LatinHypercube, SobolSequence};

/// The square of the star discrepancy in L2 (T. T. Warnock, *Computational investigations of low-discrepancy point sets*, 1972).
fn discrepancy(points: &[Vec<f64>]) -> f64 {
    let (count, dimensions) = (points.len() as f64, points[0].len() as i32);
    let single: f64 = points.iter().map(|p| p.iter().map(|x| (1.0 - x * x) / 2.0).product::<f64>()).sum();
    let pair = |p: &[f64], q: &[f64]| p.iter().zip(q).map(|(x, y)| 1.0 - x.max(*y)).product::<f64>();
    let pairs: f64 = points.iter().map(|p| points.iter().map(|q| pair(p, q)).sum::<f64>()).sum();
    3_f64.powi(-dimensions) - 2.0 / count * single + pairs / (count * count)
}

fn points(count: u64, dimensions: usize, coordinate: impl Fn(u64, usize) -> f64) -> Vec<Vec<f64>> {
    (0..count).map(|index| (0..dimensions).map(|k| coordinate(index, k)).collect()).collect()
}

/// Even random points have on average (2^−d − 3^−d)/n; the formula of this test is held against that too. What scrambled Sobol' sequences
/// and Latin hypercubes have of it is that of SciPy 1.17.1: means over 20 seeds of `qmc.discrepancy(…, method="L2-star")` squared.
#[test]
fn points_are_more_even_than_random_ones() {
    let shares = [(1, 0.00391, 0.00391), (2, 0.0134, 0.200), (4, 0.113, 0.513), (6, 0.284, 0.702)];
    for (dimensions, share_of_sobol, share_of_cube) in shares {
        let count = 256;
        let d = dimensions as i32;
        let random = (2_f64.powi(-d) - 3_f64.powi(-d)) / count as f64;
        let mean = |of: &dyn Fn(u64) -> f64| (0..20).map(of).sum::<f64>() / 20.0;
        let of_random = mean(&|seed| {
            discrepancy(&points(count, dimensions, |index, k| {
                uniform(seed, index * dimensions as u64 + k as u64)
            }))
        });
        assert!((of_random / random - 1.0).abs() < 0.5, "{of_random} {random}");
        let of_sobol = mean(&|seed| {
            let sequence = SobolSequence::scrambled(dimensions, seed).unwrap();
            discrepancy(&points(count, dimensions, |index, k| sequence.coordinate(index, k)))
        });
        let of_cube = mean(&|seed| {
            let cube = LatinHypercube::new(dimensions, count, seed).unwrap();
            discrepancy(&points(count, dimensions, |index, k| cube.coordinate(index, k)))
        });
        for (found, expected) in [(of_sobol, share_of_sobol), (of_cube, share_of_cube)] {
            let share = found / random;
            assert!(
                (share / expected - 1.0).abs() < 0.15,
                "{dimensions} dimensions: {share}, not {expected}"
            );
        }
    }
}

/// Scrambling keeps the net: each of the first 2^m points has an interval of length 2^−m of each dimension to itself, and an elementary
/// rectangle of area 2^−m of the first two dimensions (I. M. Sobol', 1967: their t is 0).
#[test]
fn scrambled_points_remain_a_net() {
    for seed in 0..5 {
        let sequence = SobolSequence::scrambled(128, seed).unwrap();
        for m in [1, 4, 9] {
            let count = 1_u64 << m;
            let cell = |index: u64, dimension: usize, bits: u32| {
                (sequence.coordinate(index, dimension) * (1_u64 << bits) as f64) as usize
            };
            for dimension in 0..128 {
                let mut hit = vec![0; count as usize];
                (0..count).for_each(|index| hit[cell(index, dimension, m)] += 1);
                assert!(hit.iter().all(|hits| *hits == 1), "dimension {dimension}");
            }
            for first in 0..=m {
                let mut hit = vec![0; count as usize];
                for index in 0..count {
                    hit[(cell(index, 0, first) << (m - first)) + cell(index, 1, m - first)] += 1;
                }
                assert!(hit.iter().all(|hits| *hits == 1), "2^-{first} of the first dimension");
            }
        }
    }
}

/// The error of an integral falls as n^−3/2 (A. B. Owen, *Scrambled net variance for integrals of smooth functions*, Ann. Statist. 25
/// (1997) 1541–1562), up to logarithms: from 2⁶ to 2¹² points by far more than the 8 of random points.
#[test]
fn integrals_of_smooth_functions_converge_as_scrambled_nets_do() {
    let integrand = |sequence: &SobolSequence, index: u64| -> f64 {
        (0..3).map(|k| 1.0 + (sequence.coordinate(index, k) - 0.5) * (k as f64 + 1.0) / 3.0).product()
    };
    let error = |count: u64| -> f64 {
        let square = |seed: u64| {
            let sequence = SobolSequence::scrambled(3, seed).unwrap();
            let mean = (0..count).map(|index| integrand(&sequence, index)).sum::<f64>() / count as f64;
            (mean - 1.0).powi(2)
        };
        ((0..40).map(square).sum::<f64>() / 40.0).sqrt()
    };
    let order = (error(1 << 6) / error(1 << 12)).log2() / 6.0;
    assert!((1.3..1.7).contains(&order), "{order}");
}

#[test]
fn the_seed_decides_the_points() {
    let point = |seed: u64| -> [f64; 2] {
        let sequence = SobolSequence::scrambled(5, seed).unwrap();
        let cube = LatinHypercube::new(5, 1000, seed).unwrap();
        [sequence.coordinate(77, 4), cube.coordinate(77, 4)]
    };
    assert_eq!(point(3), point(3));
    assert!(point(3)[0] != point(4)[0] && point(3)[1] != point(4)[1]);
    // the same on every machine: integers alone make them
    assert_eq!(point(1), [0.7384195123865284, 0.40648975244062013]);
}
