//! The points of a sweep, solved in parallel and kept.

use super::{LawSample, SolvedLawPoint, SweepObserver};
use crate::law::error::{FailedPoint, LawError};
use crate::law::limits::LawIndenter;
use crate::law::quantities::{KnotValues, PerQuantity};
use judder_numerics::parallel;
use std::collections::BTreeMap;
use std::fmt::Display;
use std::sync::atomic::{AtomicUsize, Ordering};

/// A place as its bits, depth first: positive numbers sort like their bits.
type PointBits = (u64, u64);

fn key(velocity: f64, indentation: f64) -> PointBits {
    (indentation.to_bits(), velocity.to_bits())
}

/// All that has been solved.
pub(super) struct Solving<'a, S> {
    sampler: &'a S,
    observer: &'a dyn SweepObserver,
    solved: BTreeMap<PointBits, SolvedLawPoint>,
    /// The points of the last level, in their order.
    level: Vec<SolvedLawPoint>,
}

/// What became of one point.
enum SolveAttempt {
    Solved(SolvedLawPoint),
    Failed(FailedPoint),
    Interrupted,
}

impl<'a, S, E> Solving<'a, S>
where
    S: Fn(f64, f64) -> Result<LawSample, E> + Sync,
    E: Display,
{
    pub(super) fn new(sampler: &'a S, observer: &'a dyn SweepObserver, known: &[SolvedLawPoint]) -> Self {
        let solved = known.iter().map(|point| (key(point.velocity, point.indentation), *point)).collect();
        Self { sampler, observer, solved, level: Vec::new() }
    }

    /// Solves those of the points (v̂, ŷ) that have not been.
    pub(super) fn solve(&mut self, points: &[(f64, f64)]) -> Result<(), LawError> {
        let missing: Vec<(f64, f64)> =
            points.iter().copied().filter(|(v, y)| !self.solved.contains_key(&key(*v, *y))).collect();
        self.observer.begins(missing.len());
        let done = AtomicUsize::new(0);
        let attempts: Vec<SolveAttempt> = parallel::each(&missing, |&(velocity, indentation)| {
            if self.observer.interrupted() {
                return SolveAttempt::Interrupted;
            }
            let attempt = attempt(self.sampler, velocity, indentation);
            if let SolveAttempt::Solved(point) = &attempt {
                let done = done.fetch_add(1, Ordering::Relaxed) + 1;
                self.observer.finished(point, done, missing.len());
            }
            attempt
        });
        let (mut failures, mut is_interrupted) = (Vec::new(), false);
        for attempt in attempts {
            match attempt {
                SolveAttempt::Solved(point) => {
                    self.solved.insert(key(point.velocity, point.indentation), point);
                }
                SolveAttempt::Failed(failure) => failures.push(failure),
                SolveAttempt::Interrupted => is_interrupted = true,
            }
        }
        if is_interrupted {
            return Err(LawError::Interrupted { finished: self.solved.len() });
        }
        if !failures.is_empty() {
            return Err(LawError::FailedPoints { attempted: missing.len(), failures });
        }
        self.level = points.iter().filter_map(|(v, y)| self.solved.get(&key(*v, *y)).copied()).collect();
        Ok(())
    }

    /// f, g, m at the points of the level, in their order, and the largest errors of the solutions.
    pub(super) fn values(&self, indenter: LawIndenter) -> (KnotValues, PerQuantity<f64>) {
        let mut values = KnotValues::default();
        let mut errors = PerQuantity::uniform(0.0_f64);
        for point in &self.level {
            let over = point
                .sample
                .values()
                .zip(indenter.units(point.indentation))
                .map(|(value, unit)| value / unit);
            values.force.push(over.force);
            values.area.push(over.area);
            values.friction.push(over.friction);
            errors = errors.zip(point.sample.errors()).map(|(a, b)| a.max(b));
        }
        (values, errors)
    }

    /// The points of the last level, by depth, then speed.
    pub(super) fn into_points(self) -> Vec<SolvedLawPoint> {
        self.level
    }
}

fn attempt<S, E>(sampler: &S, velocity: f64, indentation: f64) -> SolveAttempt
where
    S: Fn(f64, f64) -> Result<LawSample, E>,
    E: Display,
{
    let failed = |cause: String| SolveAttempt::Failed(FailedPoint { velocity, indentation, cause });
    match sampler(velocity, indentation) {
        Err(cause) => failed(cause.to_string()),
        Ok(sample) => {
            let is_value = |value: f64| value > 0.0 && value.is_finite();
            let is_error = |value: f64| value >= 0.0 && value.is_finite();
            if sample.values().into_array().into_iter().all(is_value)
                && sample.errors().into_array().into_iter().all(is_error)
            {
                SolveAttempt::Solved(SolvedLawPoint { velocity, indentation, sample })
            } else {
                failed(format!("the solution is not positive and finite: {sample:?}"))
            }
        }
    }
}
