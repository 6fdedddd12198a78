//! How loud a signal is about each moment.

/// √2 times the rms over a window about each sample, `window` samples long and odd (an even number is taken as one more): the amplitude, for a sine
/// of some periods a window. At the ends of the signal the window is what is left of it.
///
/// Sums are of squares alone, never differences, so that a quiet stretch beside a loud one is as exact as the loud one.
#[must_use]
pub fn envelope(signal: &[f64], window: usize) -> Vec<f64> {
    let half = window / 2;
    let block = 2 * half + 1;
    let squares = || signal.iter().map(|x| x * x);
    let mut from_start: Vec<f64> = squares().collect();
    for chunk in from_start.chunks_mut(block) {
        for n in 1..chunk.len() {
            chunk[n] += chunk[n - 1];
        }
    }
    let mut to_end: Vec<f64> = squares().collect();
    for chunk in to_end.chunks_mut(block) {
        for n in (1..chunk.len()).rev() {
            chunk[n - 1] += chunk[n];
        }
    }
    // any window that is whole spans one block or touches two; one cut by an end of the signal begins or ends with it
    let mean_square = |n: usize| {
        let (first, last) = (n.saturating_sub(half), (n + half).min(signal.len() - 1));
        let sum = if first / block != last / block {
            to_end[first] + from_start[last]
        } else if first.is_multiple_of(block) {
            from_start[last]
        } else {
            to_end[first]
        };
        sum / (last - first + 1) as f64
    };
    (0..signal.len()).map(|n| (2.0 * mean_square(n)).sqrt()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::f64::consts::TAU;

    proptest! {
        #[test]
        fn it_is_the_plain_sum(signal in prop::collection::vec(-9.0..9.0_f64, 0..80), window in 0..30_usize) {
            let found = envelope(&signal, window);
            prop_assert_eq!(found.len(), signal.len());
            for (n, found) in found.iter().enumerate() {
                let piece = &signal[n.saturating_sub(window / 2)..(n + window / 2 + 1).min(signal.len())];
                let plain = (2.0 * piece.iter().map(|x| x * x).sum::<f64>() / piece.len() as f64).sqrt();
                prop_assert!((found - plain).abs() < 1e-13 * (1.0 + plain), "{n}: {found} {plain}");
            }
        }
    }

    #[test]
    fn a_sine_has_its_amplitude_and_silence_beside_noise_is_silent() {
        let sine: Vec<f64> = (0..1000).map(|n| 3.0 * (TAU * f64::from(n) / 25.0).sin()).collect();
        assert!(envelope(&sine, 1001)[500..].iter().all(|a| (a - 3.0).abs() < 0.1));
        let mut burst = vec![0.0; 3000];
        burst[1000..2000].fill(1e9);
        let quiet = envelope(&burst, 101);
        assert!(quiet[..949].iter().chain(&quiet[2051..]).all(|a| *a == 0.0));
    }
}
