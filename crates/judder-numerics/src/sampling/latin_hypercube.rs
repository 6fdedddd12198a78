//! Latin hypercubes with random access.

use super::SamplingError;
use crate::counter;

/// The most points of a [`LatinHypercube`].
pub const POINTS_LIMIT: u64 = 1 << 48;

/// The bits of a coordinate: those of its cell and those of the place within the cell together.
const BITS: u32 = 50;

/// Rounds of the Feistel network.
const ROUNDS: u64 = 8;

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
    keys: Vec<u64>,
}

impl LatinHypercube {
    /// The hypercube of these numbers of dimensions and points; the same seed gives the same points.
    ///
    /// # Errors
    /// [`SamplingError::Points`] for none, or more than [`POINTS_LIMIT`].
    pub fn new(dimensions: usize, points: u64, seed: u64) -> Result<Self, SamplingError> {
        if !(1..=POINTS_LIMIT).contains(&points) {
            return Err(SamplingError::Points { points, most: POINTS_LIMIT });
        }
        let half = bits_of(points - 1).div_ceil(2).max(1);
        let keys = (0..dimensions as u64).map(|dimension| counter::bits(seed, dimension)).collect();
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
        let cell = self.permuted(*key, index);
        // so few bits that the sum is exact and the quotient does not round into the next cell
        let inner = BITS - bits_of(self.points);
        let place = counter::bits(counter::bits(*key, ROUNDS), index) >> (64 - inner);
        let within = (place as f64 + 0.5) / (1_u64 << inner) as f64;
        (cell as f64 + within) / self.points as f64
    }

    fn permuted(&self, key: u64, index: u64) -> u64 {
        let mut x = self.encrypted(key, index);
        while x >= self.points {
            x = self.encrypted(key, x);
        }
        x
    }

    /// The Feistel network on `2 half` bits.
    fn encrypted(&self, key: u64, x: u64) -> u64 {
        let mask = (1 << self.half) - 1;
        let (mut left, mut right) = (x >> self.half, x & mask);
        for round in 0..ROUNDS {
            let mixed = left ^ (counter::bits(counter::bits(key, round), right) & mask);
            (left, right) = (right, mixed);
        }
        (left << self.half) | right
    }
}

fn bits_of(number: u64) -> u32 {
    u64::BITS - number.leading_zeros()
}
