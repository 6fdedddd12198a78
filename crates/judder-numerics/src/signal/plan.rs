//! Which filters in a row take a signal to a lower rate at the least cost.
//!
//! A filter before a step down need only stop what the step folds onto the bands that matter, so it is short; one sharp filter at the
//! end sets the band edges. Several stages: R. E. Crochiere and L. R. Rabiner, *Optimum FIR digital filter implementations for decimation,
//! interpolation, and narrow-band filtering*, IEEE Trans. ASSP 23 (1975) 444–456. The sharp filter may leave out all but every q-th tap;
//! its images are stopped by the filter before it: Y. Neuvo, C.-Y. Dong and S. K. Mitra, *Interpolated finite impulse response filters*,
//! IEEE Trans. ASSP 32 (1984) 563–570.

use super::decimation::Decimation;
use super::fir::LowPass;

/// The part of the ripple that the sharp filter may use, and that of all others; together a little less than all, for their product.
const SHARP_SHARE: f64 = 0.7;
const OTHERS_SHARE: f64 = 0.29;

/// The most samples between two taps of the sharp filter.
const WIDEST_SPREAD: usize = 8;

/// One filter of the row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct StagePlan {
    /// The filter; of a spread one at the rate of its taps.
    pub(crate) low_pass: LowPass,
    /// Input samples an output sample.
    pub(crate) factor: usize,
    /// Samples between two taps.
    pub(crate) spread: usize,
}

/// The row of filters with the fewest multiply-adds a sample.
pub(crate) fn cheapest(asked: &Decimation) -> Vec<StagePlan> {
    let mut best = row(asked, &[], asked.factor, 1);
    let mut least = cost(&best);
    for last in (1..=asked.factor).filter(|last| asked.factor.is_multiple_of(*last)) {
        for mut before in factorisations(asked.factor / last) {
            for image_stage in [false, true] {
                if image_stage {
                    before.push(1);
                }
                for spread in 1..=if before.is_empty() { 1 } else { WIDEST_SPREAD } {
                    let candidate = row(asked, &before, last, spread);
                    let candidate_cost = cost(&candidate);
                    if candidate.iter().all(|stage| is_possible(&stage.low_pass)) && candidate_cost < least {
                        (best, least) = (candidate, candidate_cost);
                    }
                }
            }
        }
    }
    best
}

/// All ordered factorisations into factors above 1; of 1 the empty one.
fn factorisations(number: usize) -> Vec<Vec<usize>> {
    if number == 1 {
        return vec![Vec::new()];
    }
    let mut all = Vec::new();
    for first in (2..=number).filter(|first| number.is_multiple_of(*first)) {
        for mut rest in factorisations(number / first) {
            rest.insert(0, first);
            all.push(rest);
        }
    }
    all
}

/// The filters of steps down by `before`, then the sharp one by `last` with its taps `spread`.
fn row(asked: &Decimation, before: &[usize], last: usize, spread: usize) -> Vec<StagePlan> {
    let needed = |share: f64| asked.attenuation.max(-20.0 * libm::log10(share * asked.ripple));
    let others = needed(OTHERS_SHARE / before.len().max(1) as f64);
    let mut rate = asked.sample_rate;
    let mut stages = Vec::with_capacity(before.len() + 1);
    for (index, &factor) in before.iter().enumerate() {
        let sample_rate = rate;
        rate /= factor as f64;
        let images = if index + 1 == before.len() { spread as f64 } else { 1.0 };
        // what is folded, or let through as an image, onto all below the stop band
        let stop_edge = (rate / images - asked.stop_edge).min(0.5 * sample_rate);
        let low_pass = LowPass { sample_rate, pass_edge: asked.pass_edge, stop_edge, attenuation: others };
        stages.push(StagePlan { low_pass, factor, spread: 1 });
    }
    let low_pass = LowPass {
        sample_rate: rate / spread as f64,
        pass_edge: asked.pass_edge,
        stop_edge: asked.stop_edge,
        attenuation: needed(SHARP_SHARE),
    };
    stages.push(StagePlan { low_pass, factor: last, spread });
    stages
}

fn is_possible(low_pass: &LowPass) -> bool {
    low_pass.pass_edge < low_pass.stop_edge && low_pass.stop_edge <= 0.5 * low_pass.sample_rate
}

/// Multiply-adds a sample of the input, by Kaiser's length of each filter.
fn cost(stages: &[StagePlan]) -> f64 {
    let mut inputs = 1.0;
    let mut sum = 0.0;
    for stage in stages {
        inputs *= stage.factor as f64;
        sum += stage.low_pass.cost() / inputs;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_factorisation_is_tried() {
        let mut of_twelve = factorisations(12);
        of_twelve.sort();
        let expected: [&[usize]; 8] =
            [&[2, 2, 3], &[2, 3, 2], &[2, 6], &[3, 2, 2], &[3, 4], &[4, 3], &[6, 2], &[12]];
        assert_eq!(of_twelve, expected);
    }

    /// A single filter would need some 1500 taps, 190 multiply-adds a sample.
    #[test]
    fn a_row_costs_a_fraction_of_one_filter() {
        let asked = Decimation::new(1.0 / 3e-7, 50e3, 8);
        let stages = cheapest(&asked);
        assert_eq!(stages.iter().map(|stage| stage.factor).product::<usize>(), 8);
        assert!(cost(&stages) < 25.5, "{} {stages:?}", cost(&stages));
        assert!(cost(&row(&asked, &[], 8, 1)) > 150.0);
    }

    #[test]
    fn a_signal_at_its_own_rate_is_filtered_alone() {
        let asked = Decimation { stop_edge: 150.0, ..Decimation::new(1000.0, 100.0, 1) };
        assert!(cheapest(&asked).iter().all(|stage| stage.factor == 1));
    }
}
