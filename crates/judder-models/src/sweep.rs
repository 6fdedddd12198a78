//! Sweeps, families and maps: what an analysis varies.

use crate::oscillator::inputs::OscillatorInputs;
use crate::oscillator::keys::OscillatorKey;
use judder_keys::Settings;
use judder_keys::numeric_key::{Form, Value};
use judder_oscillator::map::DecisionMethod;
use judder_study::case::scale::{Spacing, spaced};

/// What the book's reference says of them.
pub(crate) const REFERENCE: &str = include_str!("sweep/reference.md");

/// One key over a range: at least two points, both ends among them.
#[derive(Debug, Clone, PartialEq)]
pub struct Sweep<K> {
    /// The swept key.
    pub key: K,
    /// Its dotted path.
    pub path: String,
    /// The first value, a group or in SI units as `form` says.
    pub from: f64,
    /// The last value; differs from `from`, may lie below it.
    pub to: f64,
    /// The number of points, at least 2.
    pub points: usize,
    /// The spacing; with [`Spacing::Log`] both ends have one sign.
    pub scale: Spacing,
    /// Whether the values are groups or in SI units.
    pub form: Form,
}

impl<K> Sweep<K> {
    /// The value of point `index`, counted from 0: the ends exact, and powers of ten exact.
    pub fn value(&self, index: usize) -> f64 {
        spaced([self.from, self.to], self.points as u64, self.scale, index as u64)
    }

    /// All values in order.
    pub fn values(&self) -> Vec<f64> {
        (0..self.points).map(|index| self.value(index)).collect()
    }
}

impl Sweep<OscillatorKey> {
    /// Sets the swept key of one operating point.
    pub fn set(&self, inputs: &mut OscillatorInputs, value: f64) {
        inputs.set(self.key, Value { number: value, form: self.form });
    }
}

/// A parameter of a two-degrees case: its position in the list of parameters.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct ParameterKey(pub(crate) usize);

impl ParameterKey {
    /// The position of the parameter.
    pub fn index(self) -> usize {
        self.0
    }
}

impl Sweep<ParameterKey> {
    /// Sets the swept parameter among the values of all parameters; a list too short is left as it is.
    pub fn set(&self, values: &mut [f64], value: f64) {
        if let Some(parameter) = values.get_mut(self.key.0) {
            *parameter = value;
        }
    }
}

/// A few values of one key: one curve a value.
#[derive(Debug, Clone, PartialEq)]
pub struct Family<K> {
    /// The key.
    pub key: K,
    /// Its dotted path.
    pub path: String,
    /// The values in the order of the case file; never empty.
    pub values: Vec<f64>,
    /// Whether the values are groups or in SI units.
    pub form: Form,
}

impl Family<OscillatorKey> {
    /// Sets the key of one operating point.
    pub fn set(&self, inputs: &mut OscillatorInputs, value: f64) {
        inputs.set(self.key, Value { number: value, form: self.form });
    }
}

/// The range in which roots are sought: positive, from below to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Within {
    /// The lower end.
    pub from: f64,
    /// The upper end.
    pub to: f64,
    /// Whether the ends are groups or in SI units.
    pub form: Form,
}

/// A stability map over two keys.
#[derive(Debug, Clone, PartialEq)]
pub struct StabilityMapAnalysis<K> {
    /// The key along the abscissa.
    pub x: Sweep<K>,
    /// The key along the ordinate; another one than that of `x`.
    pub y: Sweep<K>,
    /// How it is made.
    pub options: MapOptions,
    /// Whether stable points at which a knock starts a cycle are told apart; of oscillator cases only.
    pub global_margin: bool,
}

/// How a stability map is made.
#[derive(Debug, Clone, Copy, PartialEq, Settings)]
pub struct MapOptions {
    /// How the points are decided.
    #[key(default = DecisionMethod::Adaptive)]
    pub method: DecisionMethod,
    /// Trace the boundary curves as well.
    #[key(default = true)]
    pub boundaries: bool,
}

/// The memory that a map needs a point, bytes; larger requests are refused beyond [`MAP_BYTES_LIMIT`].
pub const MAP_BYTES_PER_POINT: u128 = 16;

/// The memory that one analysis may take, bytes: 2 GiB.
pub const MAP_BYTES_LIMIT: u128 = 2 << 30;

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn sweep(from: f64, to: f64, points: usize, scale: Spacing) -> Sweep<ParameterKey> {
        Sweep { key: ParameterKey(0), path: "p".to_owned(), from, to, points, scale, form: Form::Group }
    }

    #[test]
    fn decades_come_out_as_written() {
        let values = sweep(1e-8, 1e2, 11, Spacing::Log).values();
        assert_eq!(values, [1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 1.0, 10.0, 100.0]);
        assert_eq!(sweep(-1.0, -100.0, 3, Spacing::Log).values(), [-1.0, -10.0, -100.0]);
        assert_eq!(sweep(-f64::MAX, f64::MAX, 3, Spacing::Linear).values()[1], 0.0);
        assert_eq!(sweep(1.0, 0.0, 5, Spacing::Linear).values(), [1.0, 0.75, 0.5, 0.25, 0.0]);
    }

    proptest! {
        #[test]
        fn points_lie_between_the_ends_in_order(from in 1e-9..1e9_f64, ratio in 1.001..1e9_f64, points in 2..60_usize, log: bool) {
            let scale = if log { Spacing::Log } else { Spacing::Linear };
            let values = sweep(from, from * ratio, points, scale).values();
            prop_assert_eq!((values[0], values[points - 1], values.len()), (from, from * ratio, points));
            prop_assert!(values.windows(2).all(|pair| pair[0] <= pair[1]));
        }
    }
}
