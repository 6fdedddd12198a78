//! Motion with stick, slip and lift-off, of the oscillator and of a mass on a belt.
//!
//! - `model`: the two of them. `si`: what their units are in SI.
//! - `counted`: what they take, counted over their beginnings.
//! - `becomes`: what motions settle to. `doubts`: what makes them doubtful. `amplitude_spectrum`: how they swing.
//! - `pictures`: their figures. `tables`: those of reports.
//! - A folder each: `history` (kind `motion`), `limit_cycle`, `bifurcation`, `basin`.

mod amplitude_spectrum;
pub mod basin;
pub mod becomes;
pub mod bifurcation;
pub(crate) mod counted;
pub(crate) mod doubts;
pub mod history;
pub mod limit_cycle;
pub(crate) mod model;
pub mod pictures;
pub mod settings;
pub(crate) mod si;
pub(crate) mod tables;

use crate::error::ModelError;
use crate::estimate::{Estimate, cost, memory_of_points, point_bytes};
use crate::sliding::march::sound::AUDIO_RATE;
use crate::sweep::Sweep;
use crate::swept_keys::SweptKeys;
use counted::{CountedMotions, ProbedMotions};
use judder_keys::numeric_key::Form;
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

    /// How, for a look at the beginnings.
    fn probed(&self) -> ProbedMotions<'_, S::Key>;

    /// Puts its settings into a canonical form.
    fn write(&self, json: &mut Map<String, Json>);

    /// Whether it becomes a sound.
    fn is_heard(&self) -> bool {
        false
    }

    /// The key that it varies.
    fn swept(&self) -> Option<&Sweep<S::Key>> {
        None
    }
}

/// A case whose motion can be followed.
pub(crate) trait MotionCase: Analysed<Estimate = Estimate, Error = ModelError> {
    /// Its keys.
    type Keys: SweptKeys;

    /// What a step of its motion takes, s.
    const STEP: f64;

    /// The name of an analysis.
    fn name<'a>(known: &'a Self::Known<'_>) -> &'a str;

    /// The seconds of a unit of the time of its motions, where they have any.
    fn second(known: &Self::Known<'_>) -> Option<f64>;

    /// What the motions of an analysis take; `None` where none can be followed yet.
    fn counted<A: MotionOf<Self::Keys>>(asked: &A, known: &Self::Known<'_>) -> Option<CountedMotions>;

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

    fn memory(&self, known: &C::Known<'_>) -> Result<NeededMemory, ModelError> {
        let size = self.0.size();
        let keys = &["points", "samples", "sweep.points"];
        let following = self.0.probed().following;
        let second = C::second(known);
        let each = if second.is_some() { point_bytes::MOTION_IN_SI } else { point_bytes::MOTION };
        let of_points = memory_of_points(size.points as u128, each, keys);
        if let Some(second) = second.filter(|_| self.0.is_heard()) {
            let unit = if following.duration.form == Form::Si { 1.0 } else { second };
            let heard = (following.duration.number * unit * f64::from(AUDIO_RATE)) as u128;
            let of_sound = heard.saturating_mul(point_bytes::HEARD);
            let beside = of_points.beside.saturating_add(of_sound);
            return Ok(match of_sound < of_points.beside {
                true => NeededMemory { beside, ..of_points },
                false => NeededMemory {
                    beside,
                    what: format!("a sound of {heard} samples").into(),
                    keys: &["sound"],
                    advice: "hear the motion over a shorter `duration`, or leave out `sound`",
                    ..of_points
                },
            });
        }
        // what a look at their beginnings would take is more than changes of shorter ones do
        let long = if following.duration.form == Form::Group { 5e4 } else { 10.0 };
        if size.ends != MotionEnd::Duration || following.duration.number < long {
            return Ok(of_points);
        }
        let changes = C::counted(&self.0, known).map_or(0.0, |own| own.changes * own.longest) as u128;
        let of_changes = changes.saturating_mul(point_bytes::CHANGE);
        if of_changes < of_points.beside {
            return Ok(NeededMemory { beside: of_points.beside.saturating_add(of_changes), ..of_points });
        }
        Ok(NeededMemory {
            beside: of_points.beside.saturating_add(of_changes),
            what: format!("about {changes} changes of the contact state").into(),
            keys: &["duration"],
            advice: "follow the motion over a shorter `duration`",
            ..of_points
        })
    }

    fn estimate(&self, known: &C::Known<'_>) -> Result<Estimate, ModelError> {
        let counted = C::counted(&self.0, known).unwrap_or(CountedMotions::USUAL);
        Ok(self.0.size().estimate(C::name(known), &counted, C::STEP))
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.0.write(json);
    }
}

/// Time in which a motion usually settles, in radians.
pub(crate) const USUAL_TIME: f64 = 1000.0;

/// What an analysis of motion follows.
pub(crate) struct MotionSize {
    /// Points that are kept.
    points: usize,
    motions: usize,
    /// How long each is followed.
    ends: MotionEnd,
    /// Whether branches of cycles are followed as well.
    branches: bool,
}

/// When a motion has been followed long enough.
#[derive(Clone, Copy, PartialEq)]
enum MotionEnd {
    /// After its duration.
    Duration,
    /// When it has settled.
    Settled,
    /// When two rounds tell that it has settled to the same, each more exactly than the one before.
    Confirmed,
}

/// What a round to a hundredth of the tolerance takes of the one before: the steps of a method of fifth order, 100^{1/5}.
const FINER_ROUND: f64 = 2.5;
/// Rounds after the first, at most.
const FINER_ROUNDS: i32 = 3;

impl MotionSize {
    /// What it would take, with so many seconds a step.
    fn estimate(&self, name: &str, counted: &CountedMotions, step: f64) -> Estimate {
        let branches = if self.branches { cost::BRANCH_STEPS } else { 0.0 };
        let rest = cost::MOTION_FIGURES + self.points as f64 * cost::MOTION_POINT;
        let over = |radians: f64| (self.motions as f64 * radians * counted.steps + branches) * step + rest;
        let all_rounds: f64 = (0..=FINER_ROUNDS).map(|round| FINER_ROUND.powi(round)).sum();
        let (usual, most) = match self.ends {
            MotionEnd::Duration => (counted.longest, None),
            MotionEnd::Settled => (counted.settled + counted.left(), Some(counted.longest)),
            // one that settles late is irregular, or goes through all rounds before it is told
            MotionEnd::Confirmed => (
                (1.0 + FINER_ROUND) * counted.settled + all_rounds * counted.left(),
                Some(all_rounds * counted.longest),
            ),
        };
        Estimate {
            name: name.to_owned(),
            points: self.points,
            seconds: over(usual),
            seconds_at_most: most.map(over),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn motions_that_settle_late_take_longer() {
        let size = |ends| MotionSize { points: 0, motions: 42, ends, branches: false };
        let seconds = |ends, counted: &CountedMotions| {
            let Estimate { seconds, seconds_at_most, .. } = size(ends).estimate("diagram", counted, 1e-6);
            (seconds - cost::MOTION_FIGURES, seconds_at_most.map(|most| most - cost::MOTION_FIGURES))
        };
        let early = CountedMotions { steps: 10.0, changes: 0.0, settled: 1000.0, open: 0.0, longest: 5000.0 };
        let (plain, most) = seconds(MotionEnd::Settled, &early);
        assert!((plain - 0.42).abs() < 1e-12 && (most.unwrap() - 5.0 * plain).abs() < 1e-12);
        assert!((seconds(MotionEnd::Duration, &early).0 - 5.0 * plain).abs() < 1e-12);
        // a second round to a hundredth of the tolerance; at most 5000 radians and four rounds
        let (usual, most) = seconds(MotionEnd::Confirmed, &early);
        assert!((usual - 3.5 * plain).abs() < 1e-12, "{usual}");
        let rounds = 1.0 + 2.5 + 2.5 * 2.5 + 2.5 * 2.5 * 2.5;
        assert!((most.unwrap() - 5.0 * rounds * plain).abs() < 1e-9, "{most:?}");
        // of those that have not settled half of what is left is added, and all their rounds
        let late = CountedMotions { open: 0.5, ..early };
        assert!((seconds(MotionEnd::Settled, &late).0 - 2.0 * plain).abs() < 1e-12);
        assert!((seconds(MotionEnd::Confirmed, &late).0 - (3.5 + rounds) * plain).abs() < 1e-9);
    }
}
