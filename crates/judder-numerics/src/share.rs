//! How well a share is known from a sample.

/// Two-sided 95 % of a normal distribution.
const QUANTILE: f64 = 1.959_963_984_540_054;

/// The 95 % interval of a share, from so many hits of a number of independent trials (E. B. Wilson, J. Am. Stat. Assoc. 22, 1927); not numbers without trials.
#[must_use]
pub fn wilson(hits: usize, trials: usize) -> [f64; 2] {
    let (share, n) = (hits as f64 / trials as f64, trials as f64);
    let square = QUANTILE * QUANTILE / n;
    let middle = (share + 0.5 * square) / (1.0 + square);
    let half = QUANTILE * (share * (1.0 - share) / n + 0.25 * square / n).sqrt() / (1.0 + square);
    if !half.is_finite() {
        return [f64::NAN; 2];
    }
    // of none and of all the ends are 0 and 1, which rounding misses
    let low = if hits == 0 { 0.0 } else { (middle - half).max(0.0) };
    let high = if hits == trials { 1.0 } else { (middle + half).min(1.0) };
    [low, high]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// R. G. Newcombe, Statistics in Medicine 17 (1998), table I, method 3: 81 of 263, 15 of 148, 0 of 20, 1 of 29.
    #[test]
    fn the_intervals_are_those_of_the_literature() {
        for (hits, count, lower, upper) in [
            (81, 263, 0.2553, 0.3662),
            (15, 148, 0.0624, 0.1605),
            (0, 20, 0.0, 0.1611),
            (1, 29, 0.0061, 0.1718),
        ] {
            let [low, high] = wilson(hits, count);
            assert!((low - lower).abs() < 5e-5 && (high - upper).abs() < 5e-5, "{hits} {low} {high}");
        }
        for count in 1..2000 {
            assert!(wilson(0, count)[0] == 0.0 && wilson(count, count)[1] == 1.0, "{count}");
        }
        assert!(wilson(0, 0).iter().all(|end| end.is_nan()));
    }
}
