//! The smallest and the largest value of all steps, with the step.

use super::bits;
use serde::{Deserialize, Serialize};

/// Running extremes of a quantity, and the first steps at which it took them. NaN is neither small nor large.
///
/// ```
/// use judder_numerics::signal::extremes::Extremes;
/// let mut force = Extremes::default();
/// for (step, value) in [3.0, -1.0, 5.0, -1.0].into_iter().enumerate() {
///     force.update(step as u64, value);
/// }
/// assert_eq!(force.minimum(), Some((1, -1.0)));
/// assert_eq!(force.maximum(), Some((2, 5.0)));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Extremes {
    #[serde(with = "bits")]
    smallest: f64,
    smallest_at: u64,
    #[serde(with = "bits")]
    largest: f64,
    largest_at: u64,
}

impl Default for Extremes {
    fn default() -> Self {
        Self { smallest: f64::INFINITY, smallest_at: 0, largest: f64::NEG_INFINITY, largest_at: 0 }
    }
}

impl Extremes {
    /// Takes the value of a step in.
    #[inline]
    pub fn update(&mut self, step: u64, value: f64) {
        if value < self.smallest {
            (self.smallest, self.smallest_at) = (value, step);
        }
        if value > self.largest {
            (self.largest, self.largest_at) = (value, step);
        }
    }

    /// The step of the smallest value, and that value; none before the first.
    #[must_use]
    pub fn minimum(&self) -> Option<(u64, f64)> {
        (self.smallest < f64::INFINITY).then_some((self.smallest_at, self.smallest))
    }

    /// The step of the largest value, and that value; none before the first.
    #[must_use]
    pub fn maximum(&self) -> Option<(u64, f64)> {
        (self.largest > f64::NEG_INFINITY).then_some((self.largest_at, self.largest))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn nothing_has_no_extremes_and_survives_a_checkpoint() {
        let mut none = Extremes::default();
        none.update(0, f64::NAN);
        assert_eq!((none.minimum(), none.maximum()), (None, None));
        let kept = serde_json::to_string(&none).unwrap();
        assert_eq!(serde_json::from_str::<Extremes>(&kept).unwrap(), none);
    }

    proptest! {
        #[test]
        fn they_are_those_of_the_whole(values in prop::collection::vec(-1e9..1e9_f64, 1..60), cut in 0..60_usize) {
            let mut running = Extremes::default();
            for (step, value) in values.iter().enumerate() {
                if step == cut {
                    running = serde_json::from_str(&serde_json::to_string(&running).unwrap()).unwrap();
                }
                running.update(step as u64, *value);
            }
            let smallest = values.iter().copied().fold(f64::INFINITY, f64::min);
            let largest = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            let first = |wanted: f64| values.iter().position(|value| *value == wanted).unwrap() as u64;
            prop_assert_eq!(running.minimum(), Some((first(smallest), smallest)));
            prop_assert_eq!(running.maximum(), Some((first(largest), largest)));
        }
    }
}
