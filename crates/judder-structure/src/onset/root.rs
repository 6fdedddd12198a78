//! Roots of smooth functions that cost an eigenproblem a value, between values at which they are known.

use std::cmp::Ordering::{Greater, Less};
use std::ops::ControlFlow;

/// A function at one value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct RootSample {
    pub(super) at: f64,
    /// NaN where it is not the same function.
    pub(super) value: f64,
    /// How far that may be off.
    pub(super) error: f64,
    /// Of the mode that it is of, in Hz.
    pub(super) frequency: f64,
}

/// Samples of a function, of which two have a root between them, or one is it.
pub(super) struct SampledRoot {
    samples: Vec<RootSample>,
    root: RootSample,
}

impl SampledRoot {
    /// Follows a function to the root between two values, to a precision or until `suffices` says so of a sample; `None` where
    /// it has the same sign at both, or is not the same function throughout.
    ///
    /// Inverse quadratic interpolation where that is safe, halving elsewhere (T. R. Chandrupatla, Advances in Engineering
    /// Software 28, 1997, 145).
    pub(super) fn between<E>(
        ends: [RootSample; 2],
        precision: f64,
        suffices: &dyn Fn(&RootSample) -> bool,
        function: &mut dyn FnMut(f64) -> Result<RootSample, E>,
    ) -> Result<Option<Self>, E> {
        let [mut behind, mut here] = ends;
        let signs = [behind, here].map(|own| own.value.partial_cmp(&0.0));
        if !matches!(signs, [Some(Less), Some(Greater)] | [Some(Greater), Some(Less)]) {
            return Ok(None);
        }
        let mut samples = ends.to_vec();
        let mut share = here.value / (here.value - behind.value);
        loop {
            let next = function(here.at + share * (behind.at - here.at))?;
            if !next.value.is_finite() {
                return Ok(None);
            }
            samples.push(next);
            let before = if (next.value > 0.0) == (here.value > 0.0) {
                here
            } else {
                std::mem::replace(&mut behind, here)
            };
            here = next;
            match next_share(&here, &behind, &before, precision) {
                ControlFlow::Continue(to_next) if !suffices(&here) => share = to_next,
                _ => break,
            }
        }
        let root = if here.value.abs() <= behind.value.abs() { here } else { behind };
        Ok(Some(Self { samples, root }))
    }

    /// That the first of two samples is the root.
    pub(super) fn at_first(ends: [RootSample; 2]) -> Self {
        Self { samples: ends.to_vec(), root: ends[0] }
    }

    pub(super) fn root(&self) -> RootSample {
        self.root
    }

    /// The least error of a sample; NaN where none is known.
    pub(super) fn least_error(&self) -> f64 {
        self.samples.iter().map(|own| own.error).fold(f64::NAN, f64::min)
    }

    /// The slope at the root: that of the parabola through it and the samples beside it that are farther away than this.
    pub(super) fn slope(&self, apart: f64) -> f64 {
        let root = self.root;
        let distance = |own: &&RootSample| (own.at - root.at).abs();
        let beside = |is_there: &dyn Fn(&&RootSample) -> bool| {
            let there = self.samples.iter().filter(|own| distance(own) >= apart).filter(is_there);
            there.min_by(|a, b| distance(a).total_cmp(&distance(b)))
        };
        let secant = |a: &RootSample, b: &RootSample| (b.value - a.value) / (b.at - a.at);
        match (beside(&|own| own.at < root.at), beside(&|own| own.at > root.at)) {
            (Some(low), Some(high)) => {
                let (chord, slope) =
                    (secant(low, high), secant(low, &root) + secant(&root, high) - secant(low, high));
                if slope * chord > 0.0 { slope } else { chord }
            }
            (Some(one), None) | (None, Some(one)) => secant(one, &root),
            (None, None) => f64::NAN,
        }
    }
}

/// Where between the latest sample and the one behind the root the next is taken, as a share of their distance; a break where that is
/// below the precision.
fn next_share(
    here: &RootSample,
    behind: &RootSample,
    before: &RootSample,
    precision: f64,
) -> ControlFlow<(), f64> {
    let width = (behind.at - here.at).abs();
    let floor = precision.max(4.0 * f64::EPSILON * here.at.abs().max(behind.at.abs()));
    if here.value == 0.0 || width <= floor {
        return ControlFlow::Break(());
    }
    let (x, f) = (
        (here.at - behind.at) / (before.at - behind.at),
        (here.value - behind.value) / (before.value - behind.value),
    );
    let is_safe = f * f < x && (1.0 - f).powi(2) < 1.0 - x;
    let share = if is_safe {
        let (a, b, c) = (here.value, behind.value, before.value);
        a / (b - a) * (c / (b - c))
            + (before.at - here.at) / (behind.at - here.at) * (a / (c - a)) * (b / (c - b))
    } else {
        0.5
    };
    // a step of at least half of the precision brings the samples together from both sides
    let least = 0.5 * floor / width;
    ControlFlow::Continue(share.clamp(least, 1.0 - least))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(function: fn(f64) -> f64, error: f64) -> (f64, f64, usize) {
        let sampled = |at: f64| RootSample { at, value: function(at), error, frequency: 0.0 };
        let mut count = 0;
        let root = SampledRoot::between(
            [sampled(0.0), sampled(1.0)],
            1e-10,
            &|own: &RootSample| own.value.abs() <= 1e-2 * own.error,
            &mut |at| {
                count += 1;
                Ok::<_, ()>(sampled(at))
            },
        );
        let root = root.unwrap().unwrap();
        (root.root().at, root.slope(5e-4), count)
    }

    #[test]
    fn smooth_functions_take_few_samples() {
        let (at, slope, count) = found(|x| (3.0 * x).exp() - 2.0, 0.0);
        assert!((at - 2.0_f64.ln() / 3.0).abs() < 1e-10 && (slope - 6.0).abs() < 0.5, "{at} {slope}");
        assert!(count <= 9, "{count}");
        let (at, _, count) = found(|x| 1e-2 * x * x + x - 0.4, 1e-4);
        assert!((at - 0.398_4).abs() < 1e-4 && count <= 2, "{at} {count}");
    }

    #[test]
    fn steep_functions_and_jumps_are_followed_to_the_precision() {
        let (at, _, count) = found(|x| (x - 0.3).cbrt(), 0.0);
        assert!((at - 0.3).abs() < 2e-10 && count < 70, "{at} {count}");
        let (at, _, count) = found(|x| if x < 0.7 { -1.0 } else { 0.1 }, 0.0);
        assert!((at - 0.7).abs() < 2e-10 && count < 70, "{at} {count}");
    }
}
