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
        let mut sequence = Self::new(dimensions)?;
        sequence.scrambles = (0..dimensions as u64).map(|dimension| Scramble::new(seed, dimension)).collect();
        Ok(sequence)
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
/// The principle of S. Laine and T. Karras, *Stratified sampling for stochastic transparency* (2011), which B. Burley, *Practical
/// hash-based Owen scrambling* (J. Comput. Graph. Tech. 9 (2020) 4) applies to mirrored digits: sums, products with odd numbers, and
/// exclusive sums with an even multiple carry from lower bits to higher ones only, and can be undone. Here on 64 bits, with the
/// multipliers drawn from the seed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Scramble {
    rounds: [[u64; 2]; ROUNDS],
}

/// Rounds of the hash; after three of them no correlation of flips shows, one is to spare.
const ROUNDS: usize = 4;

impl Scramble {
    fn new(seed: u64, dimension: u64) -> Self {
        let stream = counter::bits(seed, dimension);
        let key = |k: usize| counter::bits(stream, k as u64);
        Self { rounds: std::array::from_fn(|round| [key(2 * round), key(2 * round + 1)]) }
    }

    fn permuted(&self, digits: u64) -> u64 {
        let mut x = digits.reverse_bits();
        for [addend, factors] in &self.rounds {
            x = x.wrapping_add(*addend).wrapping_mul(factors | 1);
            x ^= x.wrapping_mul((factors >> 1) & !1);
        }
        x.reverse_bits()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `scipy.stats.qmc.Sobol(128, scramble=False)` of SciPy 1.17.1: dimensions 0, 1, 2, 63, 100, 127.
    #[test]
    fn points_are_those_of_scipy() {
        let expected = [
            (1000, [0.2197265625, 0.0966796875, 0.5185546875, 0.4462890625, 0.7685546875, 0.5439453125]),
            (
                123_456_789,
                [
                    0.9758977368474007,
                    0.792431928217411,
                    0.006405912339687347,
                    0.2532354071736336,
                    0.5352772399783134,
                    0.6704075857996941,
                ],
            ),
        ];
        let sequence = SobolSequence::new(DIMENSIONS_LIMIT).unwrap();
        for (index, values) in expected {
            let found = [0, 1, 2, 63, 100, 127].map(|dimension| sequence.coordinate(index, dimension));
            assert_eq!(found, values);
        }
        assert!((0..128).all(|dimension| sequence.coordinate(0, dimension) == 0.0));
        assert!((0..128).all(|dimension| sequence.coordinate(1, dimension) == 0.5));
        assert!(sequence.coordinate(1, 128).is_nan());
    }

    /// Whether a digit is flipped is even, and independent of whether it is under a neighbouring prefix: four standard errors.
    #[test]
    fn a_flip_tells_nothing_of_another() {
        let seeds = 20_000;
        for digit in [1, 2, 4, 8, 16, 32, 50] {
            for other in (0..digit).rev().take(4) {
                let (mut flips, mut alike) = (0, 0);
                for seed in 0..seeds {
                    let scramble = Scramble::new(seed, 3);
                    let prefix = counter::bits(77, seed) & !(u64::MAX >> digit);
                    let flip = |prefix: u64| (scramble.permuted(prefix) >> (63 - digit)) & 1;
                    let (first, second) = (flip(prefix), flip(prefix ^ (1 << (63 - other))));
                    flips += first;
                    alike += u64::from(first == second);
                }
                let error = (seeds as f64 / 4.0).sqrt();
                for count in [flips, alike] {
                    let away = (count as f64 - seeds as f64 / 2.0) / error;
                    assert!(away.abs() < 4.0, "digit {digit} beside {other}: {away}");
                }
            }
        }
    }

    #[test]
    fn there_are_no_dimensions_without_direction_numbers() {
        for dimensions in [0, DIMENSIONS_LIMIT + 1] {
            let refused = SamplingError::Dimensions { dimensions, most: 128 };
            assert_eq!(SobolSequence::new(dimensions), Err(refused));
            assert_eq!(SobolSequence::scrambled(dimensions, 1), Err(refused));
        }
    }
}
