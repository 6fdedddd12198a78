//! Where a value stands on an axis: ranges from data, and the way from a value to a fraction of the axis.

use crate::axis::{Axis, LARGEST, SMALLEST, Scale, drawable};

/// A range narrower than this, relative to its values, is widened: its ticks could not be told apart.
const NARROWEST: f64 = 1e-10;

/// An axis whose range is settled.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PlacedAxis {
    pub(crate) scale: Scale,
    pub(crate) from: f64,
    pub(crate) to: f64,
}

impl PlacedAxis {
    /// The axis over its own range, or over the finite values with `padding` (a share of the range) at both ends.
    pub(crate) fn new(axis: &Axis, values: impl Iterator<Item = f64>, padding: f64) -> Self {
        let scale = axis.scale;
        if let Some((from, to)) = axis.range {
            return Self { scale, from, to };
        }
        let (low, high) = values
            .filter(|value| drawable(scale, *value))
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
        if low > high {
            let (from, to) = if scale == Scale::Log { (0.1, 10.0) } else { (0.0, 1.0) };
            return Self { scale, from, to };
        }
        Self::around(scale, low, high, padding)
    }

    /// The range from `low` to `high`, widened to one that can be drawn.
    fn around(scale: Scale, low: f64, high: f64, padding: f64) -> Self {
        let (first, last) = (stretch(scale, low), stretch(scale, high));
        let narrow = match scale {
            Scale::Log => last - first < 1e-6,
            _ => high - low <= NARROWEST * high.abs().max(low.abs()).max(SMALLEST),
        };
        let pad = match scale {
            _ if !narrow => padding * (last - first),
            Scale::Log => 0.5,
            Scale::Linear if high.abs().max(low.abs()) < SMALLEST => 0.5,
            Scale::Linear => 0.1 * first.abs().max(last.abs()),
            Scale::SymmetricLog { .. } => 0.5,
        };
        let clamp = |value: f64| match scale {
            Scale::Log => value.clamp(1.0 / LARGEST, LARGEST),
            _ => value.clamp(-LARGEST, LARGEST),
        };
        let end =
            |stretched: f64, exact: f64| if pad == 0.0 { exact } else { clamp(shrink(scale, stretched)) };
        Self { scale, from: end(first - pad, low), to: end(last + pad, high) }
    }

    /// Where `value` stands: 0 at the first end, 1 at the last, beyond them outside; `None` where it has no place.
    pub(crate) fn fraction(&self, value: f64) -> Option<f64> {
        if !drawable(self.scale, value) {
            return None;
        }
        let (first, last) = (stretch(self.scale, self.from), stretch(self.scale, self.to));
        Some((stretch(self.scale, value) - first) / (last - first))
    }

    /// Whether the range contains `value`, with a hair's width at the ends.
    pub(crate) fn contains(&self, value: f64) -> bool {
        self.fraction(value).is_some_and(|fraction| (-1e-9..=1.0 + 1e-9).contains(&fraction))
    }
}

/// The value in the measure in which the axis is even.
pub(crate) fn stretch(scale: Scale, value: f64) -> f64 {
    match scale {
        Scale::Linear => value,
        Scale::Log => libm::log10(value),
        Scale::SymmetricLog { linear } if value.abs() <= linear => value / linear,
        Scale::SymmetricLog { linear } => {
            value.signum() * (1.0 + libm::log10(value.abs()) - libm::log10(linear))
        }
    }
}

/// The inverse of [`stretch`].
fn shrink(scale: Scale, stretched: f64) -> f64 {
    match scale {
        Scale::Linear => stretched,
        Scale::Log => libm::exp10(stretched),
        Scale::SymmetricLog { linear } if stretched.abs() <= 1.0 => stretched * linear,
        Scale::SymmetricLog { linear } => {
            stretched.signum() * libm::exp10(stretched.abs() - 1.0 + libm::log10(linear))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_symmetric_log_axis_goes_there_and_back() {
        let scale = Scale::SymmetricLog { linear: 1e-3 };
        for value in [-1e5, -1e-3, -2e-4, 0.0, 5e-4, 1e-3, 7.0] {
            let back = shrink(scale, stretch(scale, value));
            assert!((back - value).abs() <= 1e-12 * value.abs(), "{value} came back as {back}");
        }
    }

    #[test]
    fn ends_stand_at_zero_and_one() {
        let axis = PlacedAxis::new(&Axis::log(""), [1e-8, 1e2].into_iter(), 0.0);
        assert_eq!((axis.from, axis.to), (1e-8, 1e2));
        assert_eq!(axis.fraction(1e-8), Some(0.0));
        assert_eq!(axis.fraction(1e-3), Some(0.5));
        assert_eq!(axis.fraction(-1.0), None);
        assert_eq!(axis.fraction(f64::NAN), None);
    }
}
