//! What motions of a case take, counted over the beginnings of a few of them: how many steps a radian takes, and when they settle, no constant tells.

use super::USUAL_TIME;
use super::model::Moving;
use super::settings::{Following, MotionStart};
use crate::estimate::cost;
use crate::sweep::Sweep;
use judder_numerics::piecewise::{MarchError, StepSettings};
use judder_oscillator::motion::SlidingSystem;
use judder_oscillator::motion::attractor::{Patience, settle};
use judder_oscillator::motion::history::{LostMotion, TimeWindow, follow};

/// Steps over which a motion is looked at: a twentieth of a second or less.
const STEPS: usize = 20_000;
/// Values of a sweep at which one is.
const PLACES: usize = 7;
/// To which tolerance it is looked when motions settle: about the same at any.
const COARSE: f64 = 1e-6;

/// Motions as an analysis follows them.
pub(crate) struct ProbedMotions<'a, K> {
    pub(crate) start: MotionStart,
    pub(crate) following: Following,
    /// What is swept meanwhile.
    pub(crate) sweep: Option<&'a Sweep<K>>,
}

/// What their beginnings tell, on average.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct CountedMotions {
    /// Steps that a radian takes.
    pub(crate) steps: f64,
    /// Changes of the contact state in a radian.
    pub(crate) changes: f64,
    /// The time after which they have settled, in radians; of those that have not yet, as far as they were followed.
    pub(crate) settled: f64,
    /// The share of those that have not.
    pub(crate) open: f64,
    /// How long they are followed at most, in radians: as long as they may be, and their steps last.
    pub(crate) longest: f64,
}

impl CountedMotions {
    /// Where none could be followed.
    pub(crate) const USUAL: Self = Self {
        steps: cost::STEPS_OF_RADIAN,
        changes: 0.0,
        settled: USUAL_TIME,
        open: 0.0,
        longest: USUAL_TIME,
    };

    /// What comes to the time after which they have settled, of those that have not within the beginning: half of what is left.
    pub(crate) fn left(&self) -> f64 {
        0.5 * self.open * (self.longest - self.settled).max(0.0)
    }
}

impl<K: Copy + Sync + Send> ProbedMotions<'_, K> {
    /// What they take: without a sweep of one motion, with one of some evenly over it. `None` where none can be followed.
    pub(crate) fn counted<M: Moving<N, Key = K>, const N: usize>(&self, model: &M) -> Option<CountedMotions> {
        let spread = |sweep: &Sweep<K>| {
            let (last, count) = (sweep.points.saturating_sub(1), PLACES.min(sweep.points));
            let place = |k: usize| k * last / count.saturating_sub(1).max(1);
            (0..count).map(|k| Some(sweep.value(place(k)))).collect()
        };
        let places = self.sweep.map_or_else(|| vec![None], spread);
        let each: Vec<CountedMotions> =
            places.into_iter().filter_map(|value| self.counted_at(model, value)).collect();
        let mean =
            |of: fn(&CountedMotions) -> f64| each.iter().map(of).sum::<f64>() / each.len().max(1) as f64;
        (!each.is_empty()).then(|| CountedMotions {
            steps: mean(|own| own.steps),
            changes: mean(|own| own.changes),
            settled: mean(|own| own.settled),
            open: mean(|own| own.open),
            longest: mean(|own| own.longest),
        })
    }

    fn counted_at<M: Moving<N, Key = K>, const N: usize>(
        &self,
        model: &M,
        value: Option<f64>,
    ) -> Option<CountedMotions> {
        let operating = model.operating(self.sweep.zip(value)).ok()?;
        let (system, longest) = (&operating.system, operating.time(self.following.duration));
        let start = operating.off_rest(operating.start(&self.start));
        let coarse = Following { tolerance: self.following.tolerance.max(COARSE), ..self.following };
        let settings = |following: &Following| StepSettings { steps: STEPS, ..operating.settings(following) };
        let patience = Patience { time: longest, transient: 0.5 * longest, ..Patience::default() };
        let (settled, open) = match settle(system, start, settings(&coarse), &patience, &|| false) {
            Ok(attractor) => (attractor.time, 0.0),
            Err(MarchError::StepsSpent { time, .. }) => (time, 1.0),
            Err(_) => return None,
        };
        let [steps, changes] = of_radian(system, start, settings(&self.following), settled)?;
        let longest = longest.min(self.following.steps as f64 / steps);
        Some(CountedMotions { steps, changes, settled, open, longest })
    }
}

/// Steps of a motion over a radian and changes of its contact state, up to a time; `None` where it cannot be followed.
fn of_radian<S: SlidingSystem<N>, const N: usize>(
    system: &S,
    start: [f64; N],
    settings: StepSettings<N>,
    time: f64,
) -> Option<[f64; 2]> {
    let followed = |duration: f64| {
        let window = TimeWindow { duration, transient: 0.0, points: 2 };
        let history = follow(system, start, settings, &window, &|| false)?;
        Ok([history.steps, history.events.len()].map(|count| count as f64 / duration.max(f64::MIN_POSITIVE)))
    };
    match followed(time) {
        Ok(counts) => Some(counts),
        Err(LostMotion { source: MarchError::StepsSpent { time, .. }, .. }) => {
            let steps = STEPS as f64 / time.max(f64::MIN_POSITIVE);
            // of one that was not followed to its end no changes are known
            let [_, changes] = followed(0.5 * time).ok()?;
            Some([steps, changes])
        }
        Err(_) => None,
    }
}
