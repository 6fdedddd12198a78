//! Bursts that were put in are found, and no others.

use super::noise;
use judder_numerics::signal::SignalError;
use judder_numerics::signal::bursts::{BurstSettings, bursts};
use proptest::prelude::*;
use std::f64::consts::TAU;

const RATE: f64 = 50_000.0;

fn settings() -> BurstSettings {
    BurstSettings::new(RATE)
}

/// Noise of rms 1 with sines of these starts, durations (s), amplitudes and frequencies.
fn path(seconds: f64, put_in: &[(f64, f64, f64, f64)]) -> Vec<f64> {
    let sine = |time: f64| {
        let on = put_in.iter().filter(|(start, duration, ..)| (*start..start + duration).contains(&time));
        on.map(|(start, _, amplitude, frequency)| amplitude * (TAU * frequency * (time - start)).sin())
            .sum::<f64>()
    };
    noise(1, (seconds * RATE) as usize).enumerate().map(|(n, x)| x + sine(n as f64 / RATE)).collect()
}

#[test]
fn three_loud_bursts_are_three() {
    let put_in = [(0.1, 0.01, 100.0, 3520.0), (0.4, 0.03, 140.0, 7000.0), (0.45, 0.05, 200.0, 10_500.0)];
    let found = bursts(&path(1.0, &put_in), &settings()).unwrap();
    assert_eq!(found.len(), 3, "{found:?}");
    for (burst, (start, duration, amplitude, frequency)) in found.iter().zip(put_in) {
        assert!((burst.start - start).abs() < 6e-4, "{burst:?}");
        assert!((burst.end - start - duration).abs() < 6e-4, "{burst:?}");
        assert!((burst.duration - (burst.end - burst.start)).abs() < 1e-12);
        assert!((start..=start + duration).contains(&burst.peak_time));
        // four standard deviations of the noise beside the amplitude
        assert!((burst.peak - amplitude).abs() < 4.5, "{burst:?}");
        assert!((burst.frequency.unwrap() - frequency).abs() < 2.0, "{burst:?}");
    }
}

#[test]
fn a_burst_20_db_below_the_loudest_is_found() {
    let put_in = [(0.1, 0.03, 1000.0, 3520.0), (0.5, 0.02, 100.0, 7000.0), (0.8, 0.02, 20.0, 7000.0)];
    assert_eq!(bursts(&path(1.0, &put_in), &settings()).unwrap().len(), 3);
}

#[test]
fn a_burst_that_grows_and_dies_is_one_with_its_peak() {
    let at = |n: usize| {
        let t = n as f64 / RATE - 0.2;
        let size = if t < 0.0 { (t / 0.01).exp() } else { (-t / 0.004).exp() };
        1e3 * size * (TAU * 3520.0 * t).cos()
    };
    let signal: Vec<f64> = noise(1, 20_000).enumerate().map(|(n, x)| x + at(n)).collect();
    let found = bursts(&signal, &settings()).unwrap();
    assert_eq!(found.len(), 1);
    assert!((found[0].peak_time - 0.2).abs() < 1e-4 && (found[0].peak - 1e3).abs() < 5.0);
    assert!((found[0].frequency.unwrap() - 3520.0).abs() < 5.0, "{found:?}");
    assert!(found[0].start > 0.13 && found[0].end < 0.24, "{found:?}");
}

#[test]
fn silence_has_no_bursts_and_a_constant_one_is_none_above_itself() {
    assert!(bursts(&[0.0; 5000], &settings()).unwrap().is_empty());
    assert!(bursts(&[3.0; 5000], &settings()).unwrap().is_empty());
}

#[test]
fn a_burst_in_silence_and_at_the_ends_is_found() {
    let mut signal = vec![0.0; 20_000];
    for n in (0..500).chain(19_000..20_000) {
        signal[n] = (TAU * 0.1 * n as f64).sin();
    }
    let found = bursts(&signal, &settings()).unwrap();
    assert_eq!(found.len(), 2);
    assert!(found[0].start < 1e-4 && found[1].end > 0.3998);
    assert!((found[1].frequency.unwrap() - 5000.0).abs() < 1.0);
}

#[test]
fn near_bursts_are_one_and_short_ones_none_where_that_is_asked() {
    let put_in = [(0.1, 0.02, 100.0, 3520.0), (0.13, 0.02, 100.0, 3520.0), (0.3, 0.002, 100.0, 3520.0)];
    let signal = path(0.5, &put_in);
    let count = |asked: BurstSettings| bursts(&signal, &asked).unwrap().len();
    assert_eq!(count(settings()), 3);
    assert_eq!(count(BurstSettings { minimum_distance: 0.02, ..settings() }), 2);
    assert_eq!(count(BurstSettings { minimum_duration: 0.005, ..settings() }), 2);
}

#[test]
fn each_threshold_counts() {
    let signal = path(0.5, &[(0.1, 0.02, 100.0, 3520.0), (0.3, 0.02, 20.0, 3520.0)]);
    let none = BurstSettings { below_peak: None, above_background: None, ..settings() };
    let count = |asked: BurstSettings| bursts(&signal, &asked).unwrap().len();
    assert_eq!(count(BurstSettings { below_peak: Some(6.0), ..none }), 1);
    assert_eq!(count(BurstSettings { above_background: Some(15.0), ..none }), 2);
    assert_eq!(count(BurstSettings { absolute: Some(50.0), ..none }), 1);
    assert_eq!(count(BurstSettings { absolute: Some(500.0), ..none }), 0);
    assert!(matches!(bursts(&signal, &none), Err(SignalError::NoThreshold)));
}

#[test]
fn nonsense_is_refused() {
    let refused = |bad: BurstSettings| bursts(&[0.0; 1000], &bad).unwrap_err();
    assert!(matches!(
        refused(BurstSettings { sample_rate: 0.0, ..settings() }),
        SignalError::NotPositive { .. }
    ));
    assert!(matches!(refused(BurstSettings { window: 1.0, ..settings() }), SignalError::TooShort { .. }));
    assert!(matches!(refused(BurstSettings { window: 1e-6, ..settings() }), SignalError::OutOfRange { .. }));
    assert!(matches!(
        refused(BurstSettings { hysteresis: -1.0, ..settings() }),
        SignalError::OutOfRange { .. }
    ));
    assert!(matches!(
        refused(BurstSettings { absolute: Some(0.0), ..settings() }),
        SignalError::NotPositive { .. }
    ));
    assert!(matches!(bursts(&[], &settings()), Err(SignalError::TooShort { .. })));
    assert!(matches!(bursts(&[f64::NAN; 100], &settings()), Err(SignalError::NotFinite { index: 0, .. })));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]
    /// White noise, and noise as narrow as a lightly damped mode's: an oscillator of 3.5 kHz with a bandwidth of 1 kHz.
    #[test]
    fn noise_alone_has_none(seed in any::<u64>(), is_narrow in any::<bool>()) {
        let mut past = [0.0, 0.0];
        let decay = (-TAU * 500.0 / RATE).exp();
        let turn = 2.0 * decay * (TAU * 3500.0 / RATE).cos();
        let signal: Vec<f64> = noise(seed, 50_000).map(|x| {
            let y = if is_narrow { x + turn * past[0] - decay * decay * past[1] } else { x };
            past = [y, past[0]];
            y
        }).collect();
        prop_assert!(bursts(&signal, &settings()).unwrap().is_empty());
    }

    #[test]
    fn any_two_bursts_are_found_where_they_are(
        first in 0.05..0.2_f64, pause in 0.02..0.1_f64, durations in prop::array::uniform2(0.01..0.05_f64),
        loudness in prop::array::uniform2(20.0..200.0_f64), frequency in 1000.0..20_000.0_f64,
    ) {
        let second = first + durations[0] + pause;
        let signal = path(0.5, &[(first, durations[0], loudness[0], frequency), (second, durations[1], loudness[1], frequency)]);
        let found = bursts(&signal, &settings()).unwrap();
        prop_assert_eq!(found.len(), 2);
        prop_assert!((found[0].start - first).abs() < 1.1e-3 && (found[1].start - second).abs() < 1.1e-3);
        // the noise moves the line of the quietest by a small part of its width
        prop_assert!((found[0].frequency.unwrap() - frequency).abs() < 10.0);
    }
}
