//! The last samples of a signal, and their weighted sum.

use multiversion::multiversion;

/// Partial sums of [`weighted_sum`]; weights come in multiples of it.
const LANES: usize = 8;

/// The last samples before now, as many as there are weights, always side by side in memory.
#[derive(Debug, Clone)]
pub(crate) struct DelayLine {
    /// Every sample twice, a length apart, so that a window of them never wraps.
    values: Vec<f64>,
    newest: usize,
}

impl DelayLine {
    /// A line of so many samples (at least one), all of one value.
    pub(crate) fn level(length: usize, value: f64) -> Self {
        Self { values: vec![value; 2 * length], newest: 0 }
    }

    /// A line with these samples, the newest first.
    pub(crate) fn holding(window: &[f64]) -> Self {
        Self { values: window.repeat(2), newest: 0 }
    }

    /// Takes a sample in; the oldest is forgotten.
    #[inline]
    pub(crate) fn push(&mut self, value: f64) {
        let length = self.values.len() / 2;
        self.newest = if self.newest == 0 { length - 1 } else { self.newest - 1 };
        self.values[self.newest] = value;
        self.values[self.newest + length] = value;
    }

    /// The samples, the newest first.
    #[inline]
    pub(crate) fn window(&self) -> &[f64] {
        &self.values[self.newest..self.newest + self.values.len() / 2]
    }
}

/// Weights with zeros behind them, to a length that [`weighted_sum`] takes whole.
pub(crate) fn padded(mut weights: Vec<f64>) -> Vec<f64> {
    weights.resize(weights.len().next_multiple_of(LANES), 0.0);
    weights
}

/// Σ w_i x_i over padded weights, in partial sums whose order is the same at every vector width.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2", "aarch64+neon"))]
pub(crate) fn weighted_sum(weights: &[f64], samples: &[f64]) -> f64 {
    let mut partial = [0.0; LANES];
    for (w, x) in weights.chunks_exact(LANES).zip(samples.chunks_exact(LANES)) {
        for lane in 0..LANES {
            partial[lane] += w[lane] * x[lane];
        }
    }
    let [a, b, c, d, e, f, g, h] = partial;
    ((a + e) + (c + g)) + ((b + f) + (d + h))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_window_holds_the_last_samples() {
        let mut line = DelayLine::level(3, 7.0);
        assert_eq!(line.window(), [7.0, 7.0, 7.0]);
        for n in 0..10 {
            line.push(f64::from(n));
        }
        assert_eq!(line.window(), [9.0, 8.0, 7.0]);
        let mut same = DelayLine::holding(line.window());
        same.push(10.0);
        assert_eq!(same.window(), [10.0, 9.0, 8.0]);
    }

    #[test]
    fn the_weighted_sum_is_the_plain_one() {
        let weights = padded((1..=13).map(f64::from).collect());
        let samples: Vec<f64> = (0..16).map(|n| f64::from(n * n)).collect();
        let plain: f64 = (0..13).map(|n| f64::from((n + 1) * n * n)).sum();
        assert_eq!(weighted_sum(&weights, &samples), plain);
    }
}
