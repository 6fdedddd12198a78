//! Sines at another rate: amplitude, phase, and what must not come through.

use super::amplitude;
use judder_numerics::signal::SignalError;
use judder_numerics::signal::resample::resampled;
use proptest::prelude::*;
use std::f64::consts::TAU;

const MARCH: f64 = 1.0 / 2.4e-6;

fn sine(rate: f64, frequency: f64, seconds: f64) -> Vec<f64> {
    (0..(rate * seconds) as usize).map(|n| (TAU * (frequency * n as f64 / rate).fract()).sin()).collect()
}

#[test]
fn an_audible_sine_is_the_same_at_48_khz() {
    for frequency in [50.0, 440.0, 3520.0, 12e3, 20e3] {
        let output = resampled(&sine(MARCH, frequency, 0.1), MARCH, 48e3).unwrap();
        assert_eq!(output.len(), 4800);
        for (k, found) in output.iter().enumerate().take(4700).skip(100) {
            let expected = (TAU * frequency * k as f64 / 48e3).sin();
            assert!((found - expected).abs() < 1e-5, "{frequency} Hz: {found} {expected}");
        }
    }
}

#[test]
fn nothing_is_folded_into_what_is_heard() {
    for k in 0..200 {
        let frequency = 24e3 + (0.5 * MARCH - 24e3) * f64::from(k) / 199.0;
        let output = resampled(&sine(MARCH, frequency, 0.02), MARCH, 48e3).unwrap();
        let largest = output[100..860].iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
        assert!(largest < 1e-5, "{largest} at {frequency} Hz");
    }
}

/// From a low rate to a high one there must be no images of the old spectrum.
#[test]
fn a_higher_rate_adds_no_images() {
    let output = resampled(&sine(8000.0, 3000.0, 0.5), 8000.0, 44_100.0).unwrap();
    for image in [5000.0, 11_000.0, 13_000.0, 19_000.0] {
        let found = amplitude(&output[1000..21_000], image / 44_100.0);
        assert!(found < 1e-5, "{found} at {image} Hz");
    }
    assert!((amplitude(&output[1000..21_000], 3000.0 / 44_100.0) - 1.0).abs() < 1e-5);
}

#[test]
fn the_same_rate_leaves_a_sine_alone_and_nothing_gives_nothing() {
    let signal = sine(48e3, 1000.0, 0.05);
    let output = resampled(&signal, 48e3, 48e3).unwrap();
    assert_eq!(output.len(), signal.len());
    assert!(output[100..2300].iter().zip(&signal[100..2300]).all(|(y, x)| (y - x).abs() < 1e-5));
    assert!(resampled(&[], 1000.0, 48e3).unwrap().is_empty());
    assert_eq!(resampled(&[1.0], 1000.0, 48e3).unwrap().len(), 1);
    assert_eq!(resampled(&[1.0; 1000], 1e9, 1.0).unwrap().len(), 1, "a filter far longer than the signal");
}

#[test]
fn nonsense_is_refused() {
    assert!(matches!(resampled(&[1.0], 0.0, 48e3), Err(SignalError::OutOfRange { .. })));
    assert!(matches!(resampled(&[1.0], 48e3, f64::NAN), Err(SignalError::OutOfRange { .. })));
    let hole = resampled(&[1.0, f64::INFINITY], 48e3, 48e3);
    assert!(matches!(hole, Err(SignalError::NotFinite { index: 1, .. })));
    assert!(matches!(resampled(&[0.0; 100], 1.0, 1e9), Err(SignalError::TooLarge { .. })));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]
    #[test]
    fn a_sine_below_both_rates_keeps_amplitude_and_phase(from in 3e3..50e3_f64, to in 3e3..50e3_f64, part in 0.02..0.83_f64) {
        let frequency = part * 0.5 * from.min(to);
        let lowest = from.min(to);
        let output = resampled(&sine(from, frequency, 400.0 / lowest), from, to).unwrap();
        let margin = (60.0 * to / lowest) as usize;
        for (k, found) in output.iter().enumerate().take(output.len() - margin).skip(margin) {
            let expected = (TAU * frequency * k as f64 / to).sin();
            prop_assert!((found - expected).abs() < 1e-5, "{found} {expected}");
        }
    }
}
