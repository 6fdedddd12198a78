//! The spectrum of a motion.

use judder_fourier::real_forward;
use judder_numerics::complex::ElementaryComplex;
use std::f64::consts::TAU;

/// Angular frequencies and one-sided amplitudes of evenly spaced values about their mean, under Hann's window: a sine that
/// lasts shows its own amplitude. Empty for fewer than four values.
pub(super) fn amplitude_spectrum(values: &[f64], step: f64) -> (Vec<f64>, Vec<f64>) {
    let count = values.len();
    if count < 4 {
        return (Vec::new(), Vec::new());
    }
    let mean = values.iter().sum::<f64>() / count as f64;
    let window = |k: usize| 0.5 - 0.5 * libm::cos(TAU * k as f64 / count as f64);
    let mut input: Vec<f64> = values.iter().enumerate().map(|(k, v)| window(k) * (v - mean)).collect();
    let transform = real_forward(count);
    let mut output = transform.make_output_vec();
    // lengths agree: both vectors are the planner's own
    if transform.process(&mut input, &mut output).is_err() {
        return (Vec::new(), Vec::new());
    }
    // the window's sum is half the count, and half of a sine's amplitude lies at negative frequencies
    let amplitude = output.iter().map(|c| 4.0 * c.modulus() / count as f64).collect();
    let frequency = (0..output.len()).map(|k| TAU * k as f64 / (count as f64 * step)).collect();
    (frequency, amplitude)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sine_shows_its_amplitude_at_its_frequency() {
        let (count, step) = (1000, 0.05);
        let frequency = TAU * 40.0 / (count as f64 * step);
        let values: Vec<f64> =
            (0..count).map(|k| 7.0 + 0.3 * (frequency * k as f64 * step + 0.4).sin()).collect();
        let (frequencies, amplitudes) = amplitude_spectrum(&values, step);
        assert_eq!((frequencies.len(), amplitudes.len()), (501, 501));
        assert!((frequencies[40] - frequency).abs() < 1e-12 && (amplitudes[40] - 0.3).abs() < 1e-12);
        assert!(amplitudes[0] < 1e-12 && amplitudes[45] < 1e-12);
    }

    #[test]
    fn too_few_values_have_none() {
        assert!(amplitude_spectrum(&[1.0, 2.0, 3.0], 0.1).0.is_empty());
    }
}
