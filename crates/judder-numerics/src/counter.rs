//! Even random numbers by place: the n-th number of a seed is computed from n alone, in any order and on any thread.

/// The n-th number, counted from 0, of the sequence of this seed, evenly distributed over [0, 1).
///
/// SplitMix64 (G. L. Steele, D. Lea, C. H. Flood, *Fast splittable pseudorandom number generators*, OOPSLA 2014), whose state
/// advances by a constant, so that any place of the sequence is reached at once.
#[must_use]
pub fn uniform(seed: u64, n: u64) -> f64 {
    // 53 bits fill a double exactly
    (bits(seed, n) >> 11) as f64 / (1_u64 << 53) as f64
}

/// The 64 bits from which [`uniform`] makes its number.
pub(crate) fn bits(seed: u64, n: u64) -> u64 {
    const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;
    let mut z = seed.wrapping_add(GOLDEN.wrapping_mul(n.wrapping_add(1)));
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The first numbers for the seed 1234567 that Vigna's `splitmix64.c` prints.
    #[test]
    fn the_sequence_is_that_of_the_reference() {
        let expected = [
            6_457_827_717_110_365_317,
            3_203_168_211_198_807_973,
            9_817_491_932_198_370_423,
            4_593_380_528_125_082_431,
            16_408_922_859_458_223_821,
        ];
        assert_eq!([0, 1, 2, 3, 4].map(|n| bits(1_234_567, n)), expected);
    }

    #[test]
    fn the_numbers_are_even() {
        let count = 100_000;
        let (mut sum, mut squares) = (0.0, 0.0);
        for n in 0..count {
            let u = uniform(5, n);
            assert!((0.0..1.0).contains(&u));
            sum += u;
            squares += u * u;
        }
        // the standard errors are 9e-4 and 9.4e-4
        assert!((sum / count as f64 - 0.5).abs() < 4e-3 && (squares / count as f64 - 1.0 / 3.0).abs() < 4e-3);
    }
}
