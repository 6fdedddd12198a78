//! Integrals of factors: how far a track has come whose speed is multiplied.

use super::{TimeFactor, TimeTable};
use std::f64::consts::PI;

/// ∫ s dt of a factor s from the start on.
#[derive(Debug, Clone, PartialEq)]
pub struct FactorIntegral {
    factor: TimeFactor,
    /// Of a table: up to each of its times, from the first on.
    before: Vec<f64>,
    /// What that is at the start.
    first: f64,
}

impl FactorIntegral {
    pub(super) fn new(factor: TimeFactor) -> Self {
        let mut before = Vec::new();
        if let TimeFactor::Table(TimeTable { times, values }) = &factor {
            before.push(0.0);
            for (times, values) in times.windows(2).zip(values.windows(2)) {
                let piece = 0.5 * (values[0] + values[1]) * (times[1] - times[0]);
                before.push(before.last().copied().unwrap_or(0.0) + piece);
            }
        }
        let mut own = Self { factor, before, first: 0.0 };
        own.first = own.at(0.0);
        own
    }

    /// How far back and how far ahead it goes until a time in s, in s.
    #[must_use]
    pub fn extent(&self, until: f64) -> [f64; 2] {
        let turns: Vec<f64> = match &self.factor {
            TimeFactor::Constant(_) | TimeFactor::Rise(_) => Vec::new(),
            TimeFactor::Table(TimeTable { times, values }) => {
                let crossing = |(times, values): (&[f64], &[f64])| {
                    (values[0] * values[1] < 0.0)
                        .then(|| times[0] + (times[1] - times[0]) * values[0] / (values[0] - values[1]))
                };
                times
                    .iter()
                    .copied()
                    .chain(times.windows(2).zip(values.windows(2)).filter_map(crossing))
                    .collect()
            }
        };
        let within = turns.into_iter().filter(|time| (0.0..until).contains(time));
        within
            .chain([until])
            .map(|time| self.at(time))
            .fold([0.0; 2], |[least, most], way| [way.min(least), way.max(most)])
    }

    /// In s, at a time in s.
    #[must_use]
    pub fn at(&self, time: f64) -> f64 {
        let whole = match &self.factor {
            TimeFactor::Constant(value) => value * time,
            TimeFactor::Rise(duration) if time < *duration => {
                0.5 * (time - duration / PI * libm::sin(PI * time / duration))
            }
            TimeFactor::Rise(duration) => time - 0.5 * duration,
            TimeFactor::Table(table) => {
                let last = table.times.partition_point(|own| *own <= time).saturating_sub(1);
                let mean = 0.5 * (table.values[last] + table.at(time));
                self.before[last] + mean * (time - table.times[last])
            }
        };
        whole - self.first
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against a sum of many small pieces, also where a table begins before or after the start.
    #[test]
    fn integrals_are_sums_of_small_pieces() {
        let table = |times: [f64; 3]| {
            TimeFactor::Table(TimeTable { times: times.to_vec(), values: vec![1.0, -0.5, 0.25] })
        };
        let factors = [
            TimeFactor::Constant(0.3),
            TimeFactor::Rise(0.7),
            TimeFactor::Rise(0.0),
            table([0.0, 0.5, 0.8]),
            table([-1.0, 0.5, 0.8]),
            table([0.2, 0.5, 0.8]),
        ];
        for factor in factors {
            let (integral, step) = (factor.integral(), 1e-4);
            assert_eq!(integral.at(0.0), 0.0);
            let (mut sum, mut extent) = (0.0, [0.0_f64; 2]);
            for k in 0..12_000 {
                sum += step * factor.at((f64::from(k) + 0.5) * step);
                let found = integral.at(f64::from(k + 1) * step);
                assert!((found - sum).abs() < 1e-6, "{factor:?} {k}: {found} {sum}");
                extent = [extent[0].min(sum), extent[1].max(sum)];
            }
            let found = integral.extent(1.2);
            assert!((0..2).all(|k| (found[k] - extent[k]).abs() < 1e-4), "{factor:?}: {found:?} {extent:?}");
        }
    }
}
