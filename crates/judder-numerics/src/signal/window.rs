//! Windows: how a piece of a signal is faded in and out before its spectrum is taken.

use std::f64::consts::TAU;

/// A window, by its cosines (F. J. Harris, *On the use of windows for harmonic analysis with the discrete Fourier transform*, Proc. IEEE 66
/// (1978) 51–83).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Window {
    /// No fading: the sharpest lines, the widest skirts.
    Rectangular,
    /// 0.5 − 0.5 cos: the usual choice.
    #[default]
    Hann,
    /// 0.54 − 0.46 cos: nearer skirts lower, far ones higher.
    Hamming,
    /// 0.42 − 0.5 cos + 0.08 cos 2: lower skirts, wider lines.
    Blackman,
    /// Four terms of Harris, his "minimum" ones: side lobes 92 dB below the line, which is as wide as they cost.
    BlackmanHarris,
    /// Five terms (G. D'Antona and A. Ferrero, *Digital signal processing for measurement systems*, 2006, p. 70): wide lines whose heights
    /// are true between the frequencies, for amplitudes.
    FlatTop,
}

impl Window {
    /// Σ (−1)^k a_k cos(k x), its coefficients.
    fn cosines(self) -> &'static [f64] {
        match self {
            Self::Rectangular => &[1.0],
            Self::Hann => &[0.5, 0.5],
            Self::Hamming => &[0.54, 0.46],
            Self::Blackman => &[0.42, 0.5, 0.08],
            Self::BlackmanHarris => &[0.358_75, 0.488_29, 0.141_28, 0.011_68],
            Self::FlatTop => &[0.215_578_95, 0.416_631_58, 0.277_263_158, 0.083_578_947, 0.006_947_368],
        }
    }

    /// Its weights for so many samples, periodic (sample N would repeat sample 0), so that their centre is sample N/2.
    #[must_use]
    pub fn weights(self, length: usize) -> Vec<f64> {
        (0..length).map(|n| self.at_angle(TAU * n as f64 / length as f64)).collect()
    }

    /// Its weight at a share of its length, from 0 to 1.
    #[must_use]
    pub fn at(self, share: f64) -> f64 {
        self.at_angle(TAU * share)
    }

    fn at_angle(self, angle: f64) -> f64 {
        let terms = self.cosines().iter().zip(0_u32..);
        terms
            .map(|(a, k)| {
                if k % 2 == 0 {
                    a * libm::cos(f64::from(k) * angle)
                } else {
                    -a * libm::cos(f64::from(k) * angle)
                }
            })
            .sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The mean of a periodic window is a_0; the mean square a_0² + Σ a_k²/2 (Harris, coherent and incoherent gain).
    #[test]
    fn gains_are_those_of_the_cosines() {
        for window in [
            Window::Rectangular,
            Window::Hann,
            Window::Hamming,
            Window::Blackman,
            Window::BlackmanHarris,
            Window::FlatTop,
        ] {
            let weights = window.weights(64);
            let a = window.cosines();
            let mean = weights.iter().sum::<f64>() / 64.0;
            let square = weights.iter().map(|w| w * w).sum::<f64>() / 64.0;
            let expected = a[0] * a[0] + 0.5 * a[1..].iter().map(|a| a * a).sum::<f64>();
            assert!((mean - a[0]).abs() < 1e-14 && (square - expected).abs() < 1e-14, "{window:?}");
            assert!((1..32).all(|n| (weights[n] - weights[64 - n]).abs() < 1e-14));
        }
    }

    /// The side lobes of Blackman and Harris lie 92 dB below (Harris, Table 1); those of Blackman 58 dB.
    #[test]
    fn side_lobes_are_where_harris_has_them() {
        let side_lobe = |window: Window, first: f64| {
            let response = |bin: f64| -> f64 {
                let turn = |n: usize| TAU * bin * (n as f64 - 128.0) / 256.0;
                window.weights(256).iter().enumerate().map(|(n, w)| w * turn(n).cos()).sum()
            };
            let line = response(0.0);
            let beyond = (0..400).map(|k| response(first + 0.05 * f64::from(k)).abs());
            20.0 * (beyond.fold(0.0, f64::max) / line).log10()
        };
        assert!((side_lobe(Window::BlackmanHarris, 4.0) + 92.0).abs() < 0.5);
        assert!((side_lobe(Window::Blackman, 3.0) + 58.0).abs() < 0.5);
        assert!((Window::Hann.at(0.5) - 1.0).abs() < 1e-15 && Window::Hann.at(0.0).abs() < 1e-15);
    }
}
