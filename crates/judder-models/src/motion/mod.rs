//! Motion with stick, slip and lift-off, of the oscillator and of a mass on a belt.
//!
//! - `model`: the two of them. `si`: what their units are in SI.
//! - `becomes`: what motions settle to. `amplitude_spectrum`: how they swing.
//! - `pictures`: their figures. `tables`: those of reports.
//! - A folder each: `history` (kind `motion`), `limit_cycle`, `bifurcation`, `basin`.

mod amplitude_spectrum;
pub mod basin;
pub mod becomes;
pub mod bifurcation;
pub mod history;
pub mod limit_cycle;
pub(crate) mod model;
pub mod pictures;
pub mod settings;
pub(crate) mod si;
pub(crate) mod tables;

use crate::error::ModelError;
use crate::estimate::{Estimate, cost, memory_of_points, point_bytes};
use crate::sweep::Sweep;
use crate::swept_keys::SweptKeys;
use judder_keys::numeric_key::{Form, Value};
use judder_store::Declared;
use judder_study::model::{Analysed, Analysis, NeededMemory, Task};
use judder_study::outcome::Outcome;
use model::Moving;
use serde_json::{Map, Value as Json};
use std::fmt;

/// An analysis of motion, of a model with these keys.
pub(crate) trait MotionOf<S: SweptKeys>: Clone + fmt::Debug + Send + Sync + 'static {
    /// How many steps it announces to its progress.
    fn announced(&self) -> usize {
        1
    }

    /// The keys of its summary.
    fn summary_keys(&self) -> Vec<Declared>;

    /// Computes it.
    fn run<M: Moving<N, Key = S::Key>, const N: usize>(
        &self,
        model: &M,
        task: Task<'_>,
    ) -> Result<Outcome, ModelError>;

    /// What it follows.
    fn size(&self) -> MotionSize;

    /// Puts its settings into a canonical form.
    fn write(&self, json: &mut Map<String, Json>);

    /// The key that it varies.
    fn swept(&self) -> Option<&Sweep<S::Key>> {
        None
    }
}

/// A case whose motion can be followed.
pub(crate) trait MotionCase:
    for<'a> Analysed<Known<'a> = &'a str, Estimate = Estimate, Error = ModelError>
{
    /// Its keys.
    type Keys: SweptKeys;

    /// What a radian of its motion takes, s.
    const RADIAN: f64;

    /// Runs an analysis of motion on the model of the case.
    fn follow<A: MotionOf<Self::Keys>>(
        asked: &A,
        of: &Self::Subject<'_>,
        task: Task<'_>,
    ) -> Result<Outcome, ModelError>;
}

/// An analysis of motion as one of a case.
#[derive(Debug, Clone)]
pub struct MotionAnalysis<A>(pub A);

impl<C: MotionCase, A: MotionOf<C::Keys>> Analysis<C> for MotionAnalysis<A> {
    fn steps(&self) -> usize {
        self.0.announced()
    }

    fn summary_keys(&self) -> Vec<Declared> {
        self.0.summary_keys()
    }

    fn run(&self, of: &C::Subject<'_>, task: Task<'_>) -> Result<Outcome, ModelError> {
        C::follow(&self.0, of, task)
    }

    fn memory(&self, _: &&str) -> Result<NeededMemory, ModelError> {
        let keys = &["points", "samples", "sweep.points"];
        Ok(memory_of_points(self.0.size().points as u128, point_bytes::MOTION, keys))
    }

    fn estimate(&self, name: &&str) -> Result<Estimate, ModelError> {
        Ok(self.0.size().estimate(name, C::RADIAN))
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.0.write(json);
    }
}

/// Time in which a motion usually settles, in radians.
pub(crate) const USUAL_TIME: f64 = 1000.0;

/// The time in which a motion usually settles that is followed for so long at most, in radians.
fn settling(longest: Value) -> f64 {
    if longest.form == Form::Group { USUAL_TIME.min(longest.number) } else { USUAL_TIME }
}

/// What an analysis of motion follows.
pub(crate) struct MotionSize {
    /// Points that are kept.
    points: usize,
    motions: usize,
    /// How long each is followed, in radians.
    time: f64,
    /// Within what time each settles, in radians, of motions that are followed until they do and on from there more exactly.
    settle_within: Option<f64>,
    /// Whether branches of cycles are followed as well.
    branches: bool,
}

/// What a round to a hundredth of the tolerance takes of the one before: the steps of a method of fifth order, 100^{1/5}.
const FINER_ROUND: f64 = 2.5;
/// Rounds after the first, at most.
const FINER_ROUNDS: i32 = 3;

impl MotionSize {
    /// So many motions over this time, each a point.
    fn of_motions(motions: usize, time: f64) -> Self {
        Self { points: motions, motions, time, settle_within: None, branches: false }
    }

    /// So many motions, each a point, that are followed until they have settled, for so long at most, and on from there until two rounds tell the same.
    fn of_settling(motions: usize, longest: Value) -> Self {
        let settle_within = (longest.form == Form::Group).then_some(longest.number);
        Self { settle_within, ..Self::of_motions(motions, settling(longest)) }
    }

    /// What it would take, with so many seconds a radian.
    fn estimate(&self, name: &str, radian: f64) -> Estimate {
        // what a branch costs is its flights, which take their radians
        let branches = if self.branches { cost::BRANCHES * radian / cost::RADIAN } else { 0.0 };
        let over =
            |time: f64, rounds: f64| self.motions as f64 * time * rounds * radian + branches + cost::FIGURE;
        let all_rounds = (0..=FINER_ROUNDS).map(|round| FINER_ROUND.powi(round)).sum();
        let usual_rounds = if self.settle_within.is_some() { 1.0 + FINER_ROUND } else { 1.0 };
        Estimate {
            name: name.to_owned(),
            points: self.points,
            seconds: over(self.time, usual_rounds),
            seconds_at_most: self.settle_within.map(|longest| over(longest, all_rounds)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn motions_that_settle_late_take_longer() {
        let seconds = |size: MotionSize| {
            let Estimate { seconds, seconds_at_most, .. } = size.estimate("diagram", cost::RADIAN);
            (seconds - cost::FIGURE, seconds_at_most.map(|most| most - cost::FIGURE))
        };
        let (plain, none) = seconds(MotionSize::of_motions(42, USUAL_TIME));
        assert!((plain - 0.42).abs() < 1e-12 && none.is_none());
        // a second round to a hundredth of the tolerance; at most 5000 radians and four rounds
        let (usual, most) = seconds(MotionSize::of_settling(42, Value::group(5000.0)));
        assert!((usual - 3.5 * plain).abs() < 1e-12, "{usual}");
        let rounds = 1.0 + 2.5 + 2.5 * 2.5 + 2.5 * 2.5 * 2.5;
        assert!((most.unwrap() - 5.0 * rounds * plain).abs() < 1e-9, "{most:?}");
    }
}
