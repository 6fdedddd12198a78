//! The last samples of a few signals, and their weighted sums.

use multiversion::multiversion;

/// Signals that go through a filter side by side, one in each lane of a vector.
pub(crate) const LANES: usize = 8;

/// One sample of each signal.
pub(crate) type SampleFrame = [f64; LANES];

/// Partial sums of [`weighted_sum`], so that one addition need not wait for the other; weights come in multiples of it.
const PARTS: usize = 4;

/// The last frames before now, as many as there are weights, always side by side in memory.
#[derive(Debug, Clone)]
pub(crate) struct DelayLine {
    /// Every frame twice, a length apart, so that a window of them never wraps.
    frames: Vec<SampleFrame>,
    newest: usize,
}

impl DelayLine {
    /// A line of so many frames (at least one), all the same.
    pub(crate) fn level(length: usize, frame: SampleFrame) -> Self {
        Self { frames: vec![frame; 2 * length], newest: 0 }
    }

    /// A line with these frames, the newest first.
    pub(crate) fn holding(window: &[SampleFrame]) -> Self {
        Self { frames: window.repeat(2), newest: 0 }
    }

    /// Takes a frame in; the oldest is forgotten.
    #[inline]
    pub(crate) fn push(&mut self, frame: SampleFrame) {
        let length = self.frames.len() / 2;
        self.newest = if self.newest == 0 { length - 1 } else { self.newest - 1 };
        self.frames[self.newest] = frame;
        self.frames[self.newest + length] = frame;
    }

    /// The frames, the newest first.
    #[inline]
    pub(crate) fn window(&self) -> &[SampleFrame] {
        &self.frames[self.newest..self.newest + self.frames.len() / 2]
    }
}

/// Weights with zeros behind them, to a length that [`weighted_sum`] takes whole.
pub(crate) fn padded(mut weights: Vec<f64>) -> Vec<f64> {
    weights.resize(weights.len().next_multiple_of(PARTS), 0.0);
    weights
}

/// Σ w_i x_i of each signal over padded weights, in partial sums whose order is the same at every vector width.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2", "aarch64+neon"))]
pub(crate) fn weighted_sum(weights: &[f64], frames: &[SampleFrame]) -> SampleFrame {
    let mut parts = [[0.0; LANES]; PARTS];
    for (weights, frames) in weights.chunks_exact(PARTS).zip(frames.chunks_exact(PARTS)) {
        for part in 0..PARTS {
            for lane in 0..LANES {
                parts[part][lane] += weights[part] * frames[part][lane];
            }
        }
    }
    let [a, b, c, d] = parts;
    let mut sum = [0.0; LANES];
    for lane in 0..LANES {
        sum[lane] = (a[lane] + c[lane]) + (b[lane] + d[lane]);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A frame whose lanes tell each other apart.
    fn frame(value: f64) -> SampleFrame {
        std::array::from_fn(|lane| value + 1000.0 * lane as f64)
    }

    #[test]
    fn the_window_holds_the_last_frames() {
        let mut line = DelayLine::level(3, frame(7.0));
        assert_eq!(line.window(), [frame(7.0); 3]);
        for n in 0..10 {
            line.push(frame(f64::from(n)));
        }
        assert_eq!(line.window(), [frame(9.0), frame(8.0), frame(7.0)]);
        let mut same = DelayLine::holding(line.window());
        same.push(frame(10.0));
        assert_eq!(same.window(), [frame(10.0), frame(9.0), frame(8.0)]);
    }

    #[test]
    fn the_weighted_sum_is_the_plain_one() {
        let weights = padded((1..=13).map(f64::from).collect());
        let frames: Vec<SampleFrame> = (0..16).map(|n| frame(f64::from(n * n))).collect();
        let plain = |lane: f64| -> f64 {
            (0..13).map(|n| f64::from(n + 1) * (f64::from(n * n) + 1000.0 * lane)).sum()
        };
        assert_eq!(weighted_sum(&weights, &frames), std::array::from_fn(|lane| plain(lane as f64)));
    }
}
