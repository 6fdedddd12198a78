//! `[[sweep]]`: the case at many points, and what is kept of each.
//!
//! An analysis asks something at one operating point; a sweep asks it at many. A point is the case read anew with the swept keys set,
//! so that any number of any model can be swept, those within analyses too.
//!
//! - [`design`]: which points, computed from their index alone.
//! - [`quantity_path`]: what is kept of them; `known_result`: whether there is such a result.
//! - [`condition`]: of what it tells how probable it is.
//! - `asked`: its keys; `read`, `read_axis`, `trial`: reading, and the case at a point.
//! - [`problem`]: what can be wrong with all of it, beyond types, units and ranges.

pub(crate) mod asked;
pub mod condition;
pub mod design;
mod known_result;
pub mod problem;
pub mod quantity_path;
pub(crate) mod read;
mod read_axis;
mod trial;

pub(crate) use read::read_sweeps;
pub(crate) use trial::at;

use crate::case::key_sweep;
use crate::case::scale::Spacing;
use condition::SweptCondition;
use design::Sampler;
use judder_keys::Settings;
use judder_keys::declared::{Number, Whole};
use judder_keys::dimension::Dimension;
use judder_keys::numeric_key::Range;
use quantity_path::QuantityPath;

/// Whole numbers that every reader of JSON keeps.
pub const SEEDS: Whole = Whole { from: 0, to: (1 << 53) - 1 };

/// A sweep of the whole case.
#[derive(Debug, Clone, PartialEq)]
pub struct StudySweep {
    /// Unique among sweeps and analyses, safe as the name of a folder.
    pub name: String,
    /// How the points are chosen.
    pub method: Design,
    /// The swept keys in the order of the case file; never empty, no two of one number.
    pub axes: Vec<SweptKey>,
    /// What is kept of every point; never empty, no two alike.
    pub quantities: Vec<QuantityPath>,
    /// The points of a unit of work, where the case says.
    pub chunk: Option<usize>,
    /// The sensitivity that is asked for; with it, points come in rows, see [`StudySweep::row`].
    pub sensitivity: Option<Sensitivity>,
    /// Of what the probability is asked for; none of what is not drawn.
    pub conditions: Vec<SweptCondition>,
    /// Whether setting the swept keys in the case gives the same operating point as reading the case anew.
    pub is_set: bool,
    sampler: Sampler,
    kept_values: Vec<Vec<f64>>,
    shape: Vec<u64>,
    points: u64,
}

/// How the points of a sweep are chosen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Design {
    /// All combinations of the values of every key.
    Grid,
    /// The first values of all keys, then the second values, and so on.
    List,
    /// A Latin hypercube.
    LatinHypercube {
        /// How many points; with sensitivity, how many rows.
        points: u64,
        /// Which of all such hypercubes.
        seed: u64,
    },
    /// A scrambled Sobol' sequence; most even where the number of points is a power of two.
    Sobol {
        /// How many points; with sensitivity, how many rows.
        points: u64,
        /// Which scrambling.
        seed: u64,
    },
}

impl Design {
    /// The seed; `None` where nothing is drawn.
    pub fn seed(self) -> Option<u64> {
        match self {
            Self::Grid | Self::List => None,
            Self::LatinHypercube { seed, .. } | Self::Sobol { seed, .. } => Some(seed),
        }
    }
}

/// A number of the case that a sweep varies.
#[derive(Debug, Clone, PartialEq)]
pub struct SweptKey {
    /// Its dotted path, such as `operation.velocity`.
    pub path: String,
    /// The dimension of its values; a plain number has none, a group neither.
    pub dimension: Dimension,
    /// How values are spaced.
    pub scale: Spacing,
    /// Its values, in SI units or plain numbers.
    pub values: SweptValues,
}

/// The values of a swept key.
#[derive(Debug, Clone, PartialEq)]
pub enum SweptValues {
    /// These; never empty.
    Listed(Vec<f64>),
    /// A number of values, at least 2, evenly spaced on the scale, both ends included.
    Spaced {
        /// The first.
        from: f64,
        /// The last.
        to: f64,
        /// How many.
        points: u64,
    },
    /// Any between two ends, evenly distributed on the scale.
    Between {
        /// The value at the coordinate 0.
        from: f64,
        /// The value at the coordinate 1.
        to: f64,
    },
}

impl SweptKey {
    /// A value with its unit.
    pub fn text(&self, value: f64) -> String {
        key_sweep::shown(value, self.dimension)
    }

    /// The smallest and the largest value.
    pub fn range(&self) -> [f64; 2] {
        match &self.values {
            SweptValues::Listed(values) => {
                values.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
                    [low.min(*value), high.max(*value)]
                })
            }
            SweptValues::Spaced { from, to, .. } | SweptValues::Between { from, to } => {
                [from.min(*to), from.max(*to)]
            }
        }
    }
}

/// How the sensitivity of the quantities to the swept keys is estimated.
#[derive(Debug, Clone, Copy, PartialEq, Settings)]
pub struct Sensitivity {
    /// Confidence of the intervals.
    #[key(rule = Number { dimension: Dimension::NUMBER, range: Range::Interval { above: 0.0, up_to: 0.9999 } }, default = 0.95)]
    pub confidence: f64,
    /// Bootstrap resamples from which they are taken.
    #[key(rule = Whole { from: 100, to: 1_000_000 }, default = 1000)]
    pub resamples: usize,
}
