//! A decimator against what it promises, sine by sine, and against itself after an interruption.

use super::amplitude;
use judder_numerics::signal::Decimation;
use judder_numerics::signal::SignalError;
use judder_numerics::signal::decimate::{Decimator, DecimatorState};
use proptest::prelude::*;
use std::f64::consts::TAU;

/// The beams paper's march: steps of 3e-7 s, signals up to 50 kHz.
fn march() -> Decimation {
    Decimation::new(1.0 / 3e-7, 50e3, 8)
}

/// What a filter of one signal lets out.
fn one(filter: &mut Decimator, signal: impl Iterator<Item = f64>) -> Vec<f64> {
    signal.filter_map(|value| filter.push(&[value]).map(|passed| passed[0])).collect()
}

fn decimated(asked: &Decimation, signal: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut filter = Decimator::new(asked, &[0.0]).unwrap();
    one(&mut filter, signal)
}

fn sine(asked: &Decimation, frequency: f64, count: usize) -> impl Iterator<Item = f64> {
    let cycles = frequency / asked.sample_rate;
    (0..count).map(move |n| (TAU * (cycles * n as f64).fract()).sin())
}

#[test]
fn sines_of_the_pass_band_come_through_within_a_hundredth_of_a_per_cent() {
    let asked = march();
    for k in 1..=50 {
        let frequency = 1e3 * f64::from(k);
        let output = decimated(&asked, sine(&asked, frequency, 40_000));
        let found = amplitude(&output[200..], frequency / (asked.sample_rate / 8.0));
        assert!((found - 1.0).abs() < 1e-4, "{found} at {frequency} Hz");
    }
}

/// Wherever a sine beyond the stop edge ends up, all of it is 80 dB down.
#[test]
fn what_lies_beyond_and_what_would_be_folded_is_suppressed_by_80_db() {
    let asked = march();
    for k in 0..400 {
        let frequency = 62e3 + (0.5 * asked.sample_rate - 62e3) * f64::from(k) / 399.0;
        let output = decimated(&asked, sine(&asked, frequency, 6000));
        let largest = output[200..].iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
        assert!(largest < 1e-4, "{largest} at {frequency} Hz");
    }
}

#[test]
fn the_delay_is_that_of_the_time_axis() {
    let asked = march();
    let filter = Decimator::new(&asked, &[0.0]).unwrap();
    let (delay, output_rate) = (filter.delay(), filter.output_rate());
    assert!((delay * asked.sample_rate - filter.delay_in_samples() as f64).abs() < 1e-9);
    for frequency in [1e3, 7e3, 33e3] {
        let output = decimated(&asked, sine(&asked, frequency, 20_000));
        for (k, found) in output.iter().enumerate().skip(200) {
            let expected = (TAU * frequency * (k as f64 / output_rate - delay)).sin();
            assert!((found - expected).abs() < 1.1e-4, "{found} {expected}");
        }
    }
}

#[test]
fn a_row_of_filters_costs_no_more_than_was_allowed() {
    let filter = Decimator::new(&march(), &[0.0]).unwrap();
    assert!(filter.cost() < 30.0, "{}", filter.cost());
}

#[test]
fn a_level_stays_a_level_and_the_end_is_not_lost() {
    let asked = march();
    let mut filter = Decimator::new(&asked, &[123.4]).unwrap();
    let delay = filter.delay_in_samples();
    let mut output: Vec<f64> = one(&mut filter, std::iter::repeat_n(123.4, 10_000));
    output.extend(&filter.finish()[0]);
    assert_eq!(output.len(), (10_000 + delay).div_ceil(8));
    assert!(output.iter().all(|x| (x / 123.4 - 1.0).abs() < 1e-12));
    assert!(Decimator::new(&asked, &[5.0]).unwrap().finish()[0].is_empty());
}

#[test]
fn a_sample_that_is_not_finite_passes_and_is_gone() {
    let mut filter = Decimator::new(&march(), &[0.0]).unwrap();
    let output = one(&mut filter, (0..20_000).map(|n| if n == 5000 { f64::NAN } else { 1.0 }));
    assert!(output.iter().any(|x| x.is_nan()));
    assert!((output[output.len() - 1] - 1.0).abs() < 1e-12);
}

/// Signals in one filter do not touch each other: eleven at once, more than a vector takes, leave the bits that each leaves alone.
#[test]
fn many_signals_pass_as_each_would_alone() {
    let asked = march();
    let level = |signal: usize| 0.5 * signal as f64;
    let sample = |signal: usize, n: usize| ((n * (signal + 3)) as f64 * 0.01).sin() + level(signal);
    let levels: Vec<f64> = (0..11).map(level).collect();
    let mut together = Decimator::new(&asked, &levels).unwrap();
    let mut found = vec![Vec::new(); 11];
    for n in 0..3000 {
        let samples: Vec<f64> = (0..11).map(|signal| sample(signal, n)).collect();
        for (column, value) in found.iter_mut().zip(together.push(&samples).unwrap_or(&[])) {
            column.push(*value);
        }
    }
    for (signal, (column, tail)) in found.iter_mut().zip(together.finish()).enumerate() {
        column.extend(tail);
        let mut alone = Decimator::new(&asked, &[level(signal)]).unwrap();
        let mut expected = one(&mut alone, (0..3000).map(|n| sample(signal, n)));
        expected.extend(&alone.finish()[0]);
        assert_eq!(*column, expected);
    }
}

#[test]
fn nonsense_is_refused() {
    let refused = |bad: Decimation| Decimator::new(&bad, &[0.0]).unwrap_err();
    assert!(matches!(refused(Decimation { sample_rate: 0.0, ..march() }), SignalError::NotPositive { .. }));
    assert!(matches!(refused(Decimation { factor: 0, ..march() }), SignalError::OutOfRange { .. }));
    assert!(matches!(refused(Decimation { factor: 64, ..march() }), SignalError::BandEdges { .. }));
    assert!(matches!(refused(Decimation { stop_edge: 50e3, ..march() }), SignalError::BandEdges { .. }));
    assert!(matches!(
        refused(Decimation { stop_edge: 50_000.001, ..march() }),
        SignalError::TooManyTaps { .. }
    ));
    assert!(matches!(refused(Decimation { ripple: f64::NAN, ..march() }), SignalError::OutOfRange { .. }));
    let message = refused(Decimation { factor: 64, ..march() }).to_string();
    assert!(message.contains("50000 Hz") && message.contains("62000 Hz"), "{message}");
}

#[test]
fn a_state_of_another_filter_is_refused() {
    let state = Decimator::new(&march(), &[0.0]).unwrap().state();
    let other = Decimation { attenuation: 90.0, ..march() };
    assert!(matches!(Decimator::resumed(&other, &state), Err(SignalError::ForeignState { .. })));
    let text = serde_json::to_string(&state).unwrap();
    let damaged: DecimatorState = serde_json::from_str(&text.replacen("[0,", "[", 1)).unwrap();
    assert!(matches!(Decimator::resumed(&march(), &damaged), Err(SignalError::ForeignState { .. })));
}

#[test]
fn the_factor_to_a_rate_leaves_at_least_that_rate() {
    assert_eq!(Decimation::factor_to(1.0 / 3e-7, 400e3), 8);
    assert_eq!(Decimation::factor_to(1.0 / 3e-7, 1.0 / 2.4e-6), 8);
    assert_eq!(Decimation::factor_to(1000.0, 2000.0), 1);
    assert_eq!(Decimation::factor_to(1000.0, f64::NAN), 1);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]
    /// A run that is cut anywhere, and goes on from what was written, gives the same bits.
    #[test]
    fn a_continued_run_is_the_uninterrupted_one(
        factor in 1..=24_usize,
        cut in 0..1500_usize,
        signal in prop::collection::vec(-1e6..1e6_f64, 1500),
    ) {
        let pass_edge = 0.3 * 1000.0 / factor as f64;
        let asked = Decimation::new(1000.0, pass_edge, factor);
        let mut whole = Decimator::new(&asked, &[1.0]).unwrap();
        let mut expected: Vec<f64> = one(&mut whole, signal.iter().copied());
        expected.extend(&whole.finish()[0]);

        let mut before = Decimator::new(&asked, &[1.0]).unwrap();
        let mut found: Vec<f64> = one(&mut before, signal[..cut].iter().copied());
        let text = serde_json::to_string(&before.state()).unwrap();
        let state: DecimatorState = serde_json::from_str(&text).unwrap();
        prop_assert_eq!(&state, &before.state());
        let mut after = Decimator::resumed(&asked, &state).unwrap();
        found.extend(one(&mut after, signal[cut..].iter().copied()));
        found.extend(&after.finish()[0]);
        let bits = |values: &[f64]| values.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
        prop_assert_eq!(bits(&found), bits(&expected));
    }

    /// Random factors and edges keep the promise at a random frequency of each band.
    #[test]
    fn any_decimator_keeps_its_bands(factor in 1..=30_usize, edge in 0.05..0.38_f64, part in 0.0..1.0_f64) {
        let output_rate = 1000.0 / factor as f64;
        let asked = Decimation::new(1000.0, edge * output_rate, factor);
        let filter = Decimator::new(&asked, &[0.0]).unwrap();
        let settled = 2 * filter.delay_in_samples() / factor + 2;
        let count = factor * (settled + 2000);
        let passed = part * asked.pass_edge;
        let output = decimated(&asked, sine(&asked, passed.max(0.02 * output_rate), count));
        let found = amplitude(&output[settled..], passed.max(0.02 * output_rate) / output_rate);
        prop_assert!((found - 1.0).abs() < 1.1e-4, "{found} at {passed}");
        let stopped = asked.stop_edge + part * (500.0 - asked.stop_edge);
        let output = decimated(&asked, sine(&asked, stopped, count));
        prop_assert!(output[settled..].iter().all(|x| x.abs() < 1.01e-4), "{stopped}");
    }
}
