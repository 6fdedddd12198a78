//! The strongest line in the spectrum of a piece of a signal.

use super::spectrum::Transform;
use super::window::Window;
use crate::complex::ElementaryComplex;

/// How many times finer than its own the spectrum of the piece is sampled.
const FINENESS: usize = 4;

/// The frequency (Hz) of the strongest line of a piece of a signal; `None` where there is none, as in a constant.
///
/// The mean is taken out, the piece is weighted by Hann's window and filled up with zeros to at least four times its length; the place of the
/// largest magnitude is that of the parabola through the logarithms of it and its neighbours. For a sine over many periods it is right to
/// some thousandths of 1/T, T the duration of the piece; lines nearer than 2/T are not told apart.
#[must_use]
pub fn strongest_frequency(piece: &[f64], sample_rate: f64) -> Option<f64> {
    let weights = Window::Hann.weights(piece.len());
    let total: f64 = weights.iter().sum();
    let mean = weights.iter().zip(piece).map(|(w, x)| w * x).sum::<f64>() / total;
    if !mean.is_finite() {
        return None;
    }
    let length = (FINENESS * piece.len()).next_power_of_two();
    let mut transform = Transform::new(length);
    let spectrum = transform.of(piece.iter().zip(&weights).map(|(x, w)| w * (x - mean)));
    let magnitude: Vec<f64> = spectrum.iter().map(|line| line.modulus()).collect();
    let inner = 1..magnitude.len() - 1;
    let strongest = inner.max_by(|&i, &j| magnitude[i].total_cmp(&magnitude[j]))?;
    // what rounding leaves of a constant is no line
    let floor = 1e-12 * total * piece.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
    if magnitude[strongest] <= floor || !magnitude[strongest].is_finite() {
        return None;
    }
    let [before, at, after] = [strongest - 1, strongest, strongest + 1].map(|k| libm::log(magnitude[k]));
    let curvature = before - 2.0 * at + after;
    let off = if curvature < 0.0 { 0.5 * (before - after) / curvature } else { 0.0 };
    Some((strongest as f64 + off.clamp(-0.5, 0.5)) * sample_rate / length as f64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::f64::consts::TAU;

    proptest! {
        #[test]
        fn the_frequency_of_a_sine_is_found(periods in 10.0..200.0_f64, phase in 0.0..TAU, offset in -3.0..3.0_f64) {
            let piece: Vec<f64> =
                (0..1000).map(|n| offset + (TAU * periods * f64::from(n) / 1000.0 + phase).sin()).collect();
            let found = strongest_frequency(&piece, 1000.0).unwrap();
            prop_assert!((found - periods).abs() < 5e-3, "{found} {periods}");
        }
    }

    #[test]
    fn a_constant_has_no_frequency() {
        assert_eq!(strongest_frequency(&[2.7; 100], 1.0), None);
        assert_eq!(strongest_frequency(&[0.0; 100], 1.0), None);
        assert_eq!(strongest_frequency(&[f64::NAN; 100], 1.0), None);
        assert_eq!(strongest_frequency(&[], 1.0), None);
        assert_eq!(strongest_frequency(&[1.0], 1.0), None);
    }
}
