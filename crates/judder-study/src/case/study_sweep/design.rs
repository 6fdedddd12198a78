//! Which points a sweep has: each is computed from its index alone.

use judder_numerics::decade::power_of_ten;
use judder_numerics::elementary::{exp, ln};
use judder_numerics::sampling::{LatinHypercube, SobolSequence};

use super::{Design, StudySweep, SweptKey, SweptValues};
use crate::case::scale::{Spacing, evenly};

/// The most points of a sweep.
pub const POINTS_LIMIT: u64 = 1_000_000_000_000;

/// What draws points in the unit cube.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Sampler {
    /// Nothing is drawn.
    None,
    LatinHypercube(LatinHypercube),
    Sobol(SobolSequence),
}

impl Sampler {
    fn coordinate(&self, index: u64, dimension: usize) -> f64 {
        match self {
            Self::None => f64::NAN,
            Self::LatinHypercube(cube) => cube.coordinate(index, dimension),
            Self::Sobol(sequence) => sequence.coordinate(index, dimension),
        }
    }
}

/// The most values of a key of a grid that are kept rather than computed again at every point.
const KEPT: u64 = 1 << 16;

/// The values of the keys of a grid, each where they are few enough to be kept.
pub(super) fn kept_values(method: Design, axes: &[SweptKey]) -> Vec<Vec<f64>> {
    let is_kept = |count: &u64| method == Design::Grid && *count <= KEPT;
    let values = |axis: &SweptKey| {
        let count = axis.count().filter(is_kept).unwrap_or(0);
        (0..count).map(|index| axis.value(index)).collect()
    };
    axes.iter().map(values).collect()
}

impl SweptKey {
    /// How many values there are; `None` for any between two ends.
    pub fn count(&self) -> Option<u64> {
        match &self.values {
            SweptValues::Listed(values) => Some(values.len() as u64),
            SweptValues::Spaced { points, .. } => Some(*points),
            SweptValues::Between { .. } => None,
        }
    }

    /// The value of this index, counted from 0, where values are counted; NaN beyond.
    pub fn value(&self, index: u64) -> f64 {
        match &self.values {
            SweptValues::Listed(values) => {
                usize::try_from(index).ok().and_then(|index| values.get(index)).copied().unwrap_or(f64::NAN)
            }
            SweptValues::Spaced { from, to, points } if index < *points => {
                let is_end = index == 0 || index + 1 == *points;
                if self.scale == Spacing::Linear || is_end {
                    return evenly([*from, *to], *points, index);
                }
                let exponents = [*from, *to].map(|end| libm::log10(end.abs()));
                rounded_power_of_ten(evenly(exponents, *points, index)).copysign(*from)
            }
            _ => f64::NAN,
        }
    }

    /// The value at a coordinate between 0 and 1, where any between two ends is taken; NaN otherwise.
    pub fn value_at(&self, coordinate: f64) -> f64 {
        let SweptValues::Between { from, to } = self.values else { return f64::NAN };
        let between = |from: f64, to: f64| from * (1.0 - coordinate) + to * coordinate;
        let ratio = to / from;
        let value = match self.scale {
            Spacing::Linear => between(from, to),
            // exp and ln have the same bits on every machine, as all points of one sweep must
            Spacing::Log if ratio.is_normal() => from * exp(coordinate * ln(ratio)),
            // ends too far apart for their ratio
            Spacing::Log => {
                rounded_power_of_ten(between(libm::log10(from.abs()), libm::log10(to.abs()))).copysign(from)
            }
        };
        value.clamp(from.min(to), from.max(to))
    }
}

/// 10^x to 15 digits: so decades come out as written, and with the same bits on every machine.
fn rounded_power_of_ten(exponent: f64) -> f64 {
    format!("{:.14e}", power_of_ten(exponent)).parse().unwrap_or(f64::NAN)
}

impl StudySweep {
    /// The number of points; with sensitivity, N (k + 2) for N rows of k keys.
    pub fn points(&self) -> u64 {
        self.points
    }

    /// The shape of the results: of a grid the numbers of values of its keys, otherwise the number of points alone.
    pub fn shape(&self) -> &[u64] {
        &self.shape
    }

    /// The names of the dimensions of the results: of a grid its keys, otherwise `sample` alone.
    pub fn dimensions(&self) -> Vec<&str> {
        match self.method {
            Design::Grid => self.axes.iter().map(|axis| axis.path.as_str()).collect(),
            _ => vec!["sample"],
        }
    }

    /// How many points belong together and should stand in one chunk: k + 2 with sensitivity, otherwise 1.
    ///
    /// A row of sensitivity (A. Saltelli et al., *Comput. Phys. Commun.* 181 (2010) 259–270, Table 2) is A, then AB_1 to AB_k, then B: A and B
    /// are the two halves of one point in twice as many dimensions, AB_j is A with key j of B.
    pub fn row(&self) -> u64 {
        if self.sensitivity.is_some() { self.axes.len() as u64 + 2 } else { 1 }
    }

    /// The values of all keys, in their order, at the point of this index, counted from 0 (of a grid row-major, the last key fastest);
    /// NaN beyond the points.
    pub fn values_of(&self, index: u64) -> Vec<f64> {
        let mut values = vec![f64::NAN; self.axes.len()];
        self.fill_values(index, &mut values);
        values
    }

    /// Writes what [`StudySweep::values_of`] gives into `values`, one a key.
    pub fn fill_values(&self, index: u64, values: &mut [f64]) {
        let keys = self.axes.len();
        if index >= self.points() {
            values.fill(f64::NAN);
            return;
        }
        let (row, member) = (index / self.row(), index % self.row());
        let mut rest = index;
        for (k, (axis, value)) in self.axes.iter().zip(values).enumerate().rev() {
            *value = match self.method {
                Design::List => axis.value(index),
                Design::Grid => {
                    let count = axis.count().unwrap_or(1);
                    let here = rest % count;
                    rest /= count;
                    let kept = self.kept_values.get(k).and_then(|values| values.get(here as usize));
                    kept.copied().unwrap_or_else(|| axis.value(here))
                }
                Design::LatinHypercube { .. } | Design::Sobol { .. } => {
                    let is_of_second = member == keys as u64 + 1 || member == k as u64 + 1;
                    let dimension = if is_of_second { keys + k } else { k };
                    axis.value_at(self.sampler.coordinate(row, dimension))
                }
            };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use judder_keys::dimension::Dimension;

    fn key(from: f64, to: f64, scale: Spacing) -> SweptKey {
        let (path, dimension) = ("a.b".to_owned(), Dimension::NUMBER);
        SweptKey { path, dimension, scale, values: SweptValues::Between { from, to } }
    }

    #[test]
    fn decades_of_a_grid_come_out_as_written() {
        for (from, to) in [(-8, 2), (-300, 300), (7, -7)] {
            let decade = |exponent: i32| -> f64 { format!("1e{exponent}").parse().unwrap() };
            let points = i32::abs_diff(from, to) + 1;
            let values = SweptValues::Spaced { from: decade(from), to: decade(to), points: points.into() };
            let key = SweptKey { values, ..key(0.0, 0.0, Spacing::Log) };
            for (index, step) in (0..u64::from(points)).zip(0..) {
                let exponent = if to > from { from + step } else { from - step };
                assert_eq!(key.value(index), decade(exponent));
            }
            assert!(key.value(points.into()).is_nan());
        }
    }

    #[test]
    fn coordinates_are_even_on_the_scale() {
        let close = |found: f64, expected: f64| (found / expected - 1.0).abs() < 1e-13;
        assert!(close(key(1e-4, 1e2, Spacing::Log).value_at(0.25), 10_f64.powf(-2.5)));
        assert!(close(key(-100.0, -1.0, Spacing::Log).value_at(0.5), -10.0));
        assert!(close(key(1e-200, 1e200, Spacing::Log).value_at(0.25), 1e-100));
        assert!(close(key(3.0, -1.0, Spacing::Linear).value_at(0.25), 2.0));
        assert_eq!(key(-f64::MAX, f64::MAX, Spacing::Linear).value_at(0.5), 0.0);
        assert!(key(0.0, 1.0, Spacing::Linear).value_at(f64::NAN).is_nan());
    }
}
