//! Levels of sines, noise and chirps.

use super::noise;
use judder_numerics::signal::SignalError;
use judder_numerics::signal::spectrogram::{LevelKind, Spectrogram, SpectrogramSettings, spectrogram};
use judder_numerics::signal::window::Window;
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};

const WINDOWS: [Window; 5] =
    [Window::Rectangular, Window::Hann, Window::Hamming, Window::Blackman, Window::FlatTop];

fn settings() -> SpectrogramSettings {
    SpectrogramSettings { length: 512, ..SpectrogramSettings::new(1000.0) }
}

fn row(found: &Spectrogram, time: usize) -> &[f64] {
    &found.levels[time * found.frequencies.len()..][..found.frequencies.len()]
}

fn highest(row: &[f64]) -> usize {
    (0..row.len()).max_by(|i, j| row[*i].total_cmp(&row[*j])).unwrap()
}

#[test]
fn a_sine_of_amplitude_a_shows_its_level_under_every_window() {
    for window in WINDOWS {
        let asked = SpectrogramSettings { window, reference: 1e-6, ..settings() };
        // 64 of 512 lines, at 125 Hz
        let signal: Vec<f64> = (0..2000).map(|n| 3.0 * (TAU * f64::from(n) / 8.0 + 0.3).sin()).collect();
        let found = spectrogram(&signal, &asked).unwrap();
        let expected = 20.0 * 3e6_f64.log10();
        for time in 0..found.times.len() {
            assert_eq!(highest(row(&found, time)), 64);
            assert!((row(&found, time)[64] - expected).abs() < 1e-9, "{window:?}");
        }
        assert!((found.frequencies[64] - 125.0).abs() < 1e-12);
    }
}

/// A constant, and a signal at half the rate, have no mirror image.
#[test]
fn the_ends_of_the_spectrum_show_their_amplitude() {
    let constant = spectrogram(&[2.0; 600], &settings()).unwrap();
    assert!((row(&constant, 0)[0] - 20.0 * 2_f64.log10()).abs() < 1e-9);
    let alternating: Vec<f64> = (0..600).map(|n| if n % 2 == 0 { 2.0 } else { -2.0 }).collect();
    let found = spectrogram(&alternating, &settings()).unwrap();
    assert!((row(&found, 0)[256] - 20.0 * 2_f64.log10()).abs() < 1e-9);
    assert_eq!(found.frequencies[256], 500.0);
}

/// Half way between two lines the loss is |W(½)|/W(0): 8/(3π) for Hann, 2/π without a window (Harris 1978, scallop loss).
#[test]
fn between_two_lines_the_loss_is_that_of_the_window() {
    let losses = [(Window::Rectangular, 2.0 / PI), (Window::Hann, 8.0 / (3.0 * PI)), (Window::FlatTop, 1.0)];
    for (window, loss) in losses {
        let asked = SpectrogramSettings { window, ..settings() };
        let signal: Vec<f64> = (0..512).map(|n| (TAU * 64.5 * f64::from(n) / 512.0).sin()).collect();
        let found = row(&spectrogram(&signal, &asked).unwrap(), 0)[64];
        // the mirror image adds up to 1/(4·64.5) of the line without a window, far less with one
        assert!((found - 20.0 * loss.log10()).abs() < 0.05, "{window:?}: {found} {}", 20.0 * loss.log10());
    }
}

/// White noise of variance 1 has the density 2/f_s up to half the rate, under every window; a chi-squared mean over 12 000 lines is within 0.1 dB.
#[test]
fn noise_shows_its_power_density_under_every_window() {
    let signal: Vec<f64> = noise(3, 60_000).collect();
    for window in WINDOWS {
        let asked = SpectrogramSettings { window, kind: LevelKind::PowerDensity, overlap: 0.0, ..settings() };
        let found = spectrogram(&signal, &asked).unwrap();
        let inner = found.levels.chunks(257).flat_map(|row| &row[10..247]);
        let (sum, count) =
            inner.fold((0.0, 0.0), |(sum, count), level| (sum + 10_f64.powf(level / 10.0), count + 1.0));
        assert!((10.0 * (sum / count * 500.0_f64).log10()).abs() < 0.1, "{window:?}: {}", sum / count);
    }
}

/// Without a window the powers of all lines add up to the mean square (Parseval).
#[test]
fn the_power_densities_add_up_to_the_mean_square() {
    for length in [64, 65] {
        let signal: Vec<f64> = noise(9, length).collect();
        let asked = SpectrogramSettings {
            window: Window::Rectangular,
            kind: LevelKind::PowerDensity,
            length,
            ..settings()
        };
        let found = spectrogram(&signal, &asked).unwrap();
        let powers: f64 = found.levels.iter().map(|level| 10_f64.powf(level / 10.0)).sum();
        let square = signal.iter().map(|x| x * x).sum::<f64>() / length as f64;
        assert!((powers * 1000.0 / length as f64 / square - 1.0).abs() < 1e-10);
    }
}

/// The line of a chirp stands at its momentary frequency at the middle of each piece: times are centres.
#[test]
fn a_chirp_is_where_it_should_be() {
    let rate = 30.0;
    let asked = SpectrogramSettings { start: 2.0, length: 256, ..settings() };
    let momentary = |t: f64| 50.0 + rate * (t - 2.0);
    let signal: Vec<f64> = (0..10_000)
        .map(|n| f64::from(n) / 1000.0)
        .map(|t| (TAU * (50.0 * t + 0.5 * rate * t * t)).sin())
        .collect();
    let found = spectrogram(&signal, &asked).unwrap();
    assert!(
        (found.times[0] - 2.128).abs() < 1e-12 && (found.times[1] - found.times[0] - 0.064).abs() < 1e-12
    );
    let line = 1000.0 / 256.0;
    for (time, t) in found.times.iter().enumerate() {
        let frequency = found.frequencies[highest(row(&found, time))];
        assert!((frequency - momentary(*t)).abs() <= 0.51 * line, "{frequency} {}", momentary(*t));
    }
}

#[test]
fn silence_is_the_floor() {
    let found = spectrogram(&[0.0; 600], &SpectrogramSettings { floor: -90.0, ..settings() }).unwrap();
    assert!(found.levels.iter().all(|level| *level == -90.0));
}

#[test]
fn nonsense_is_refused() {
    let refused = |bad: SpectrogramSettings| spectrogram(&[0.0; 600], &bad).unwrap_err();
    assert!(matches!(
        refused(SpectrogramSettings { sample_rate: -1.0, ..settings() }),
        SignalError::NotPositive { .. }
    ));
    assert!(matches!(
        refused(SpectrogramSettings { reference: 0.0, ..settings() }),
        SignalError::NotPositive { .. }
    ));
    assert!(matches!(
        refused(SpectrogramSettings { overlap: 1.0, ..settings() }),
        SignalError::OutOfRange { .. }
    ));
    assert!(matches!(
        refused(SpectrogramSettings { length: 0, ..settings() }),
        SignalError::OutOfRange { .. }
    ));
    assert!(matches!(
        refused(SpectrogramSettings { length: 601, ..settings() }),
        SignalError::TooShort { .. }
    ));
    assert!(matches!(
        refused(SpectrogramSettings { floor: f64::NAN, ..settings() }),
        SignalError::OutOfRange { .. }
    ));
    let mut hole = vec![0.0; 600];
    hole[77] = f64::NAN;
    assert!(matches!(spectrogram(&hole, &settings()), Err(SignalError::NotFinite { index: 77, .. })));
}

proptest! {
    #[test]
    fn rows_and_columns_fit(count in 16..3000_usize, length in 8..300_usize, overlap in 0.0..0.99_f64) {
        prop_assume!(count >= length);
        let asked = SpectrogramSettings { length, overlap, ..settings() };
        let found = spectrogram(&vec![1.0; count], &asked).unwrap();
        prop_assert_eq!(found.levels.len(), found.times.len() * found.frequencies.len());
        prop_assert!(found.levels.iter().all(|level| level.is_finite()));
        // no piece beyond the end
        prop_assert!(*found.times.last().unwrap() + 0.5 * length as f64 / 1000.0 <= count as f64 / 1000.0 + 1e-12);
    }
}
