//! Latin hypercubes with random access.

use super::SamplingError;
use crate::counter;

/// The most points of a [`LatinHypercube`].
pub const POINTS_LIMIT: u64 = 1 << 48;

/// The most dimensions of a [`LatinHypercube`].
pub const DIMENSIONS_LIMIT: usize = 1 << 16;

/// The bits of a coordinate: those of its cell and those of the place within the cell together.
const BITS: u32 = 50;

/// Rounds of the Feistel network.
const ROUNDS: usize = 8;

/// A Latin hypercube of n points (M. D. McKay, R. J. Beckman, W. J. Conover, *Technometrics* 21 (1979) 239–245): each dimension is cut
/// into n cells of one width, and each cell holds one point, at random within it.
///
/// x_i = (π(i) + u_i)/n with a permutation π and even random numbers u_i of each dimension. The permutation is a bijection by key, a
/// Feistel network on the next power of four that is walked until it comes back below n (J. Black, P. Rogaway, *Ciphers with arbitrary
/// finite domains*, CT-RSA 2002), so that any point is reached at once and nothing is kept a point.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LatinHypercube {
    points: u64,
    /// Half the bits on which the permutation works.
    half: u32,
    keys: Vec<PermutationKeys>,
}

/// What makes one dimension: the keys of the rounds of its permutation, and that of the places within cells.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct PermutationKeys {
    rounds: [u64; ROUNDS],
    place: u64,
}

impl LatinHypercube {
    /// The hypercube of these numbers of dimensions and points; the same seed gives the same points.
    ///
    /// # Errors
    /// [`SamplingError`] for no dimensions or points, or more than [`DIMENSIONS_LIMIT`] and [`POINTS_LIMIT`].
    pub fn new(dimensions: usize, points: u64, seed: u64) -> Result<Self, SamplingError> {
        if !(1..=DIMENSIONS_LIMIT).contains(&dimensions) {
            return Err(SamplingError::Dimensions { dimensions, most: DIMENSIONS_LIMIT });
        }
        if !(1..=POINTS_LIMIT).contains(&points) {
            return Err(SamplingError::Points { points, most: POINTS_LIMIT });
        }
        let half = bits_of(points - 1).div_ceil(2).max(1);
        let keys = (0..dimensions as u64).map(|dimension| {
            let key = |k: usize| counter::bits(counter::bits(seed, dimension), k as u64);
            PermutationKeys { rounds: std::array::from_fn(key), place: key(ROUNDS) }
        });
        let keys = keys.collect();
        Ok(Self { points, half, keys })
    }

    /// The number of dimensions.
    #[must_use]
    pub fn dimensions(&self) -> usize {
        self.keys.len()
    }

    /// The number of points.
    #[must_use]
    pub fn points(&self) -> u64 {
        self.points
    }

    /// A coordinate, in the open interval (0, 1), of the point of this index, counted from 0; NaN beyond dimensions and points.
    #[must_use]
    pub fn coordinate(&self, index: u64, dimension: usize) -> f64 {
        let (Some(key), true) = (self.keys.get(dimension), index < self.points) else { return f64::NAN };
        let cell = self.permuted(&key.rounds, index);
        // so few bits that the sum is exact and the quotient does not round into the next cell
        let inner = BITS - bits_of(self.points);
        let place = counter::bits(key.place, index) >> (64 - inner);
        let within = (place as f64 + 0.5) / (1_u64 << inner) as f64;
        (cell as f64 + within) / self.points as f64
    }

    fn permuted(&self, keys: &[u64; ROUNDS], index: u64) -> u64 {
        let mut x = self.encrypted(keys, index);
        while x >= self.points {
            x = self.encrypted(keys, x);
        }
        x
    }

    /// The Feistel network on `2 half` bits.
    fn encrypted(&self, keys: &[u64; ROUNDS], x: u64) -> u64 {
        let mask = (1 << self.half) - 1;
        let (mut left, mut right) = (x >> self.half, x & mask);
        for key in keys {
            (left, right) = (right, left ^ (counter::bits(*key, right) & mask));
        }
        (left << self.half) | right
    }
}

fn bits_of(number: u64) -> u32 {
    u64::BITS - number.leading_zeros()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn every_cell_of_every_dimension_holds_one_point(points in 1..2000_u64, seed: u64) {
            let cube = LatinHypercube::new(3, points, seed).unwrap();
            for dimension in 0..3 {
                let mut hit = vec![false; points as usize];
                for index in 0..points {
                    let x = cube.coordinate(index, dimension);
                    prop_assert!(x > 0.0 && x < 1.0);
                    hit[(x * points as f64) as usize] = true;
                }
                prop_assert!(hit.into_iter().all(|hit| hit));
            }
        }

        /// So many cells that a coordinate is told from the next cell by its last bits.
        #[test]
        fn the_cells_of_very_many_points_differ(points in (1_u64 << 46)..=POINTS_LIMIT, seed: u64, index: u64) {
            let cube = LatinHypercube::new(1, points, seed).unwrap();
            let index = index % points;
            let cell = cube.permuted(&cube.keys[0].rounds, index);
            prop_assert_eq!((cube.coordinate(index, 0) * points as f64) as u64, cell);
            let other = (index + 1) % points;
            prop_assert!(cube.permuted(&cube.keys[0].rounds, other) != cell);
        }
    }

    /// Every permutation of four equally often, within four standard errors: 24 counts of 24000/24.
    #[test]
    fn permutations_are_even() {
        let mut counts = std::collections::BTreeMap::new();
        for seed in 0..24_000 {
            let cube = LatinHypercube::new(1, 4, seed).unwrap();
            *counts.entry([0, 1, 2, 3].map(|k| cube.permuted(&cube.keys[0].rounds, k))).or_insert(0) += 1;
        }
        assert_eq!(counts.len(), 24);
        assert!(
            counts.values().all(|count| f64::from(count - 1000).abs() < 4.0 * 1000_f64.sqrt()),
            "{counts:?}"
        );
    }

    #[test]
    fn there_is_no_hypercube_without_points_or_dimensions() {
        let refused = |points| Err(SamplingError::Points { points, most: POINTS_LIMIT });
        assert_eq!(LatinHypercube::new(1, 0, 1), refused(0));
        assert_eq!(LatinHypercube::new(1, u64::MAX, 1), refused(u64::MAX));
        let refused = |dimensions| Err(SamplingError::Dimensions { dimensions, most: DIMENSIONS_LIMIT });
        assert_eq!(LatinHypercube::new(0, 5, 1), refused(0));
        assert_eq!(LatinHypercube::new(usize::MAX, 5, 1), refused(usize::MAX));
    }
}
