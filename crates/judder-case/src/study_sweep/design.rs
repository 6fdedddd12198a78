//! Which points a sweep has: each is computed from its index alone.

use judder_numerics::sampling::{LatinHypercube, SobolSequence};

use super::{Design, StudySweep, SweptKey, SweptValues};
use crate::sweep::{Scale, spaced};

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
                spaced([*from, *to], *points, self.scale, index)
            }
            _ => f64::NAN,
        }
    }

    /// The value at a coordinate between 0 and 1, where any between two ends is taken; NaN otherwise.
    pub fn value_at(&self, coordinate: f64) -> f64 {
        let SweptValues::Between { from, to } = self.values else { return f64::NAN };
        let between = |from: f64, to: f64| from * (1.0 - coordinate) + to * coordinate;
        let value = match self.scale {
            Scale::Linear => between(from, to),
            Scale::Log => 10_f64.powf(between(from.abs().log10(), to.abs().log10())).copysign(from),
        };
        value.clamp(from.min(to), from.max(to))
    }
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
                    axis.value(here)
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
