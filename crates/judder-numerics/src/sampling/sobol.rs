//! Sobol' sequences with random access and scrambling.

use super::SamplingError;
use super::joe_kuo::POLYNOMIALS;
use crate::counter;

/// The most dimensions of a [`SobolSequence`].
pub const DIMENSIONS_LIMIT: usize = POLYNOMIALS.len() + 1;

/// The direction numbers of a dimension: as many as an index has bits.
const BITS: usize = 64;

/// A Sobol' sequence in the unit cube: its first 2^m points fill every dimension, and most pairs of dimensions, evenly.
///
/// x_i = ⊕ g_k v_k over the bits g_k of the Gray code i ⊕ ⌊i/2⌋ (I. A. Antonov, V. M. Saleev, *USSR Comput. Math. Math. Phys.* 19
/// (1980) 252–256), v_k the direction numbers of Joe and Kuo (2008). Any point is reached at once; 2⁵³ differ.
///
/// [`SobolSequence::scrambled`] permutes the digits of each dimension, each by what stands before it, after A. B. Owen, *Randomly
/// permuted (t,m,s)-nets and (t,s)-sequences* (1995): what was evenly filled remains so, and each point is uniformly distributed over
/// seeds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SobolSequence {
    directions: Vec<[u64; BITS]>,
    /// Of each dimension; empty where nothing is scrambled.
    scrambles: Vec<Scramble>,
}

impl SobolSequence {
    /// The sequence as it is: its first point is the origin, every coordinate k/2⁵³ in [0, 1).
    ///
    /// # Errors
    /// [`SamplingError::Dimensions`] for none, or more than [`DIMENSIONS_LIMIT`].
    pub fn new(dimensions: usize) -> Result<Self, SamplingError> {
        if !(1..=DIMENSIONS_LIMIT).contains(&dimensions) {
            return Err(SamplingError::Dimensions { dimensions, most: DIMENSIONS_LIMIT });
        }
        let directions = (0..dimensions).map(direction_numbers).collect();
        Ok(Self { directions, scrambles: Vec::new() })
    }

    /// The sequence scrambled by a seed: every coordinate (k + ½)/2⁵² in the open interval (0, 1). The same seed gives the same points.
    ///
    /// # Errors
    /// As [`SobolSequence::new`].
    pub fn scrambled(dimensions: usize, seed: u64) -> Result<Self, SamplingError> {
        let scrambles = (0..dimensions as u64).map(|dimension| Scramble::new(seed, dimension));
        Ok(Self { scrambles: scrambles.collect(), ..Self::new(dimensions)? })
    }

    /// The number of dimensions.
    #[must_use]
    pub fn dimensions(&self) -> usize {
        self.directions.len()
    }

    /// A coordinate of the point of this index, counted from 0; NaN beyond the dimensions.
    #[must_use]
    pub fn coordinate(&self, index: u64, dimension: usize) -> f64 {
        let Some(directions) = self.directions.get(dimension) else { return f64::NAN };
        let mut rest = index ^ (index >> 1);
        let mut digits = 0;
        while rest != 0 {
            digits ^= directions[rest.trailing_zeros() as usize];
            rest &= rest - 1;
        }
        match self.scrambles.get(dimension) {
            None => (digits >> 11) as f64 / (1_u64 << 53) as f64,
            // 53 bits, the last of them set: the middle of a cell, exact in a double
            Some(scramble) => ((scramble.permuted(digits) >> 11) | 1) as f64 / (1_u64 << 53) as f64,
        }
    }
}

/// v_1, v_2, … of a dimension counted from 0, the binary point before the highest bit.
fn direction_numbers(dimension: usize) -> [u64; BITS] {
    let Some((coefficients, initial)) = dimension.checked_sub(1).and_then(|row| POLYNOMIALS.get(row)) else {
        // the first dimension mirrors the digits of the index
        return std::array::from_fn(|k| 1 << (BITS - 1 - k));
    };
    let degree = initial.len();
    let mut directions = [0; BITS];
    for k in 0..BITS {
        directions[k] = match initial.get(k) {
            Some(m) => u64::from(*m) << (BITS - 1 - k),
            None => {
                let first = directions[k - degree] ^ (directions[k - degree] >> degree);
                let used = (1..degree).filter(|j| (coefficients >> (degree - 1 - j)) & 1 == 1);
                used.fold(first, |sum, j| sum ^ directions[k - j])
            }
        };
    }
    directions
}

/// A permutation of binary fractions that flips each digit by what stands before it, and by nothing else.
///
/// The hash of S. Laine and T. Karras, *Stratified sampling for stochastic transparency* (2011), which B. Burley, *Practical
/// hash-based Owen scrambling* (J. Comput. Graph. Tech. 9 (2020) 4) applies to mirrored digits: sums, and products with even numbers,
/// carry from lower bits to higher ones only. Here on 64 bits, with the multipliers drawn from the seed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Scramble {
    keys: [u64; 2 * ROUNDS],
}

/// Rounds of the hash, each a sum and a product.
const ROUNDS: usize = 4;

impl Scramble {
    fn new(seed: u64, dimension: u64) -> Self {
        let stream = counter::bits(seed, dimension);
        Self { keys: std::array::from_fn(|k| counter::bits(stream, k as u64)) }
    }

    fn permuted(self, digits: u64) -> u64 {
        let mut x = digits.reverse_bits();
        for round in self.keys.chunks_exact(2) {
            x = x.wrapping_add(round[0]);
            x ^= x.wrapping_mul(round[1] & !1);
        }
        x.reverse_bits()
    }
}
