//! How the points of a sweep are spaced.

use judder_keys::Choice;
use judder_numerics::decade::power_of_ten;

/// How the points of a sweep are spaced.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Choice)]
#[choice(what = "scale")]
pub enum Spacing {
    /// Equal steps.
    Linear,
    /// Equal ratios.
    Log,
}

/// The value of point `index` of `points` from one end to the other: the ends exact, and powers of ten exact.
pub fn spaced(ends: [f64; 2], points: u64, scale: Spacing, index: u64) -> f64 {
    match scale {
        Spacing::Log if index > 0 && index + 1 < points => {
            let exponents = ends.map(|end| libm::log10(end.abs()));
            power_of_ten(evenly(exponents, points, index)).copysign(ends[0])
        }
        _ => evenly(ends, points, index),
    }
}

/// Point `index` of `points` with equal steps between them, the ends exact.
pub fn evenly([from, to]: [f64; 2], points: u64, index: u64) -> f64 {
    let last = points.saturating_sub(1).max(1);
    if index == 0 {
        return from;
    }
    if index >= last {
        return to;
    }
    // multiplied before divided, so that whole exponents stay whole
    let step = (to - from) * index as f64 / last as f64;
    let part = index as f64 / last as f64;
    if step.is_finite() { from + step } else { from * (1.0 - part) + to * part }
}
