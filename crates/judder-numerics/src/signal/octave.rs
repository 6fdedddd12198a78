//! The mean square of a signal in octave bands.

use super::error::{SignalError, finite, positive};
use super::spectrum::Transform;
use super::window::Window;
use std::f64::consts::SQRT_2;

/// Centres of bands, 1000 Hz · 2^k.
const OCTAVES: std::ops::RangeInclusive<i32> = -5..=6;
/// Lines of the spectrum that a band has at least: then the window's skirts are small beside it.
const LINES: f64 = 8.0;

/// What a signal has in a band of an octave.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OctaveBand {
    /// The geometric mean of its edges f/√2 and √2 f, in Hz.
    pub centre: f64,
    /// In the unit of the signal squared; none of a band that reaches beyond the pass band, or is too narrow to be told in so short a signal.
    pub mean_square: Option<f64>,
}

/// The mean square of a signal, its mean taken out, in octave bands about 1000 Hz · 2^k from 31.25 Hz to 64 kHz (exact midband frequencies of IEC 61260-1 to
/// the base two); the signal is what it was up to `pass_band` (Hz).
///
/// Pieces under Hann's window, each half of the next, are transformed (P. D. Welch, IEEE Trans. Audio Electroacoust. 15, 1967): the power density S of a
/// line is 2 |X|²/(f_s Σ w²), and a band has Σ S Δf of its lines, of which there are eight at least. Pieces are as long as the lowest band asks for, or the signal
/// is short. A pure tone is told with its whole mean square where it lies two lines or more within a band.
///
/// # Errors
/// A rate that is not positive, a sample that is not finite.
pub fn octave_bands(
    signal: &[f64],
    sample_rate: f64,
    pass_band: f64,
) -> Result<Vec<OctaveBand>, SignalError> {
    positive("the sample rate", sample_rate)?;
    finite(signal)?;
    let centres = || OCTAVES.map(|octave| 1000.0 * 2_f64.powi(octave));
    let narrowest = centres().next().unwrap_or(1.0) / SQRT_2;
    let length = signal.len().min((LINES * sample_rate / narrowest).ceil() as usize);
    let between = sample_rate / length as f64;
    let known = |centre: f64| SQRT_2 * centre <= pass_band && centre / SQRT_2 >= LINES * between;
    if !centres().any(known) {
        return Ok(centres().map(|centre| OctaveBand { centre, mean_square: None }).collect());
    }
    let density = mean_density(signal, sample_rate, length);
    let band = |centre: f64| {
        let line = |edge: f64| (edge / between).ceil() as usize;
        let own = line(centre / SQRT_2)..line(SQRT_2 * centre).min(density.len());
        OctaveBand { centre, mean_square: known(centre).then(|| density[own].iter().sum::<f64>() * between) }
    };
    Ok(centres().map(band).collect())
}

/// The power density of each line, averaged over pieces of this length.
fn mean_density(signal: &[f64], sample_rate: f64, length: usize) -> Vec<f64> {
    let mean = signal.iter().sum::<f64>() / signal.len() as f64;
    let weights = Window::Hann.weights(length);
    let squares: f64 = weights.iter().map(|weight| weight * weight).sum();
    let mut transform = Transform::new(length);
    let mut density = vec![0.0; length / 2 + 1];
    let pieces = || signal.windows(length).step_by((length / 2).max(1));
    for piece in pieces() {
        let spectrum = transform.of(piece.iter().zip(&weights).map(|(x, w)| (x - mean) * w));
        density.iter_mut().zip(spectrum).for_each(|(sum, line)| *sum += line.norm_sqr());
    }
    let scale = 2.0 / (sample_rate * squares * pieces().count() as f64);
    density.iter_mut().for_each(|own| *own *= scale);
    density
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::octave_bands;
    use crate::counter::uniform;
    use std::f64::consts::TAU;

    const RATE: f64 = 40e3;

    fn levels(signal: &[f64], pass_band: f64) -> Vec<(f64, Option<f64>)> {
        let bands = octave_bands(signal, RATE, pass_band).unwrap();
        bands.iter().map(|band| (band.centre, band.mean_square)).collect()
    }

    /// A sine has half its amplitude squared, all in one band.
    #[test]
    fn tones_are_in_their_bands() {
        let of = |n: usize, [amplitude, frequency]: [f64; 2]| {
            amplitude * (TAU * frequency * n as f64 / RATE).sin()
        };
        let signal: Vec<f64> =
            (0..80_000).map(|n| 5.0 + of(n, [3.0, 440.0]) + of(n, [0.01, 4321.0])).collect();
        for (centre, found) in levels(&signal, 16e3) {
            let expected = match centre {
                500.0 => Some(4.5),
                4000.0 => Some(5e-5),
                16000.0.. => None,
                _ => Some(0.0),
            };
            match (found, expected) {
                (Some(found), Some(expected)) => {
                    assert!((found - expected).abs() < 1e-3 * expected + 1e-7, "{centre}: {found}");
                }
                _ => assert_eq!(found, expected, "{centre}"),
            }
        }
    }

    /// White noise has in each band what the band is of half the rate: 3 dB more an octave up, 1/√(B T) of it uncertain.
    #[test]
    fn noise_rises_by_three_decibels_an_octave() {
        let signal: Vec<f64> = (0..400_000).map(|n| uniform(7, n) - 0.5).collect();
        for (centre, found) in levels(&signal, 0.5 * RATE) {
            if let Some(found) = found {
                let width = centre * (2_f64.sqrt() - 0.5_f64.sqrt());
                let expected = width / (0.5 * RATE) / 12.0;
                let uncertain = 5.0 / (width * 10.0).sqrt() + 0.5 / (width * 0.36);
                assert!((found / expected - 1.0).abs() < uncertain, "{centre}: {found} {expected}");
            }
        }
    }

    /// A hundredth of a second has lines of 100 Hz: a band of eight is that about 2 kHz, not that about 1 kHz.
    #[test]
    fn what_a_short_signal_does_not_tell_is_unknown() {
        let told = levels(&vec![1.0; 400], 20e3);
        let known: Vec<f64> =
            told.iter().filter(|(_, found)| found.is_some()).map(|(centre, _)| *centre).collect();
        assert_eq!(known, [2000.0, 4000.0, 8000.0]);
        assert!(levels(&[], 20e3).iter().chain(&levels(&[1.0; 9], 20e3)).all(|(_, found)| found.is_none()));
        assert!(octave_bands(&[f64::NAN], RATE, RATE).is_err() && octave_bands(&[1.0], 0.0, 1.0).is_err());
    }
}
