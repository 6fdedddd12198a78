//! The branches of cycles through a bifurcation diagram, stable and unstable, and where steady sliding is stable.

mod results;

use crate::error::ModelError;
use crate::motion::model::Moving;
use crate::motion::settings::Following;
use crate::sweep::Sweep;
use judder_numerics::root::all_roots_from_values;
use judder_numerics::words::plain;
use judder_oscillator::cycle::shooting::Shooting;
use judder_oscillator::cycle::{
    BranchEnd, BranchPoint, Continuation, CycleBranch, CycleError, Fold, continue_branch, small_cycle,
};
use judder_oscillator::hopf::{HopfPoint, growth_rate, growth_slope, hopf_point};
use judder_study::Progress;
use judder_study::case::scale::Spacing;
pub(super) use results::ToldBranches;
use std::f64::consts::TAU;
use std::sync::atomic::{AtomicUsize, Ordering};

/// The loosest tolerance of a flight: where a cycle begins to stick, the sheets on both sides are told apart by their last digits.
const TOLERANCE: f64 = 1e-10;
/// The most steps of a flight, its longest time, the most flights and cycles in one direction: what bounds the time of a branch.
const STEPS: usize = 100_000;
const LONGEST_PERIOD: f64 = 2000.0;
const FLIGHTS: usize = 3000;
const CYCLES: usize = 400;
/// The first and the longest step along a branch, in the magnitudes of steady sliding and in parts of the sweep.
const STEP: (f64, f64) = (0.01, 4.0);
/// The part of the sweep that counts as much along a branch as a magnitude of steady sliding does.
const PART: f64 = 1.0 / 100.0;
/// Places at which the growth rate of steady sliding is looked at for changes of sign, at least.
const SAMPLES: usize = 201;
/// How far beside a change of stability, in parts of the sweep, steady sliding has two stabilities.
const CHANGE: f64 = 1e-3;
/// What rounding makes of a growth rate of zero, over ω_nx.
const ROUNDING: f64 = 1e-13;
/// Branches that are followed from simulated cycles, at most.
const FROM_SIMULATION: usize = 6;

/// A cycle that a motion of the diagram has settled to.
pub(super) struct SimulatedCycle<const N: usize> {
    pub(super) value: f64,
    pub(super) start: [f64; N],
    pub(super) oscillations: usize,
    pub(super) rms: f64,
    pub(super) period: f64,
}

/// A point of the sweep at which steady sliding changes its stability.
pub(super) struct DiagramHopf<const N: usize> {
    value: f64,
    hopf: HopfPoint<N>,
}

/// A branch of cycles; places along the sweep are values.
pub(super) struct DiagramBranch<const N: usize> {
    /// Where it starts, in words.
    from: String,
    /// Value and period of the Hopf point where it begins, if it begins at one.
    hopf: Option<(f64, f64)>,
    points: Vec<BranchPoint<N>>,
    folds: Vec<Fold>,
    /// Whether it ends at steady sliding.
    shrinks: bool,
    /// Where it ends, in words.
    end: String,
}

/// Everything beside the simulated motions.
pub(super) struct Branches<const N: usize> {
    /// Values over the sweep, and whether steady sliding is stable there; NaN growth where there is none.
    growth: Vec<(f64, f64)>,
    hopf_points: Vec<DiagramHopf<N>>,
    branches: Vec<DiagramBranch<N>>,
    /// Of every simulated cycle, whether it is stable on the branch that it lies on; `None` where it lies on none.
    simulated: Vec<Option<bool>>,
    /// Starts from which no branch could be followed, with the reasons.
    failed: Vec<String>,
}

impl<const N: usize> DiagramBranch<N> {
    /// The branch with its places told as values.
    fn at_values(mut self, value: impl Fn(f64) -> f64) -> Self {
        self.points.iter_mut().for_each(|point| point.parameter = value(point.parameter));
        self.folds.iter_mut().for_each(|fold| fold.parameter = value(fold.parameter));
        self
    }

    /// Whether a simulated cycle lies on it, and if so whether a cycle there is stable: it has as many oscillations, and rms and period
    /// of two neighbours at its value, or between them.
    fn passes(&self, cycle: &SimulatedCycle<N>) -> Option<bool> {
        let near = self.points.windows(2).filter(|pair| {
            let [a, b] = [&pair[0], &pair[1]];
            // at a fold a cycle can lie beyond both of its neighbours
            let ends = [a.parameter, b.parameter];
            let turns = self.folds.iter().map(|fold| fold.parameter);
            let turn = turns.filter(|turn| is_between(ends[0], ends[1], *turn));
            let (from, to) =
                turn.chain(ends).fold((f64::INFINITY, f64::NEG_INFINITY), |(from, to), value| {
                    (from.min(value), to.max(value))
                });
            (from..=to).contains(&cycle.value)
                && a.cycle.oscillations == cycle.oscillations
                && is_between(a.cycle.around.measures.rms(), b.cycle.around.measures.rms(), cycle.rms)
                && is_between(a.cycle.period(), b.cycle.period(), cycle.period)
        });
        let stable = near.map(|pair| pair.iter().any(|point| point.cycle.is_stable()));
        stable.reduce(|any, is_stable| any || is_stable)
    }
}

/// Whether a value lies between two others, but for what a straight line between neighbours may be off.
fn is_between(a: f64, b: f64, value: f64) -> bool {
    const SLACK: f64 = 0.03;
    let slack = SLACK * value.abs();
    (a.min(b) - slack..=a.max(b) + slack).contains(&value)
}

/// The sweep as the parameter of a continuation, which is the value or its logarithm: its place.
struct SweepLine<'a, M: Moving<N>, const N: usize> {
    model: &'a M,
    sweep: &'a Sweep<M::Key>,
    following: &'a Following,
    progress: &'a dyn Progress,
}

impl<M: Moving<N>, const N: usize> SweepLine<'_, M, N> {
    fn place(&self, value: f64) -> f64 {
        match self.sweep.scale {
            Spacing::Linear => value,
            Spacing::Log => libm::log(value.abs()),
        }
    }

    fn value(&self, place: f64) -> f64 {
        match self.sweep.scale {
            Spacing::Linear => place,
            Spacing::Log => libm::exp(place).copysign(self.sweep.from),
        }
    }

    /// Both ends, ascending.
    fn range(&self) -> (f64, f64) {
        let (from, to) = (self.place(self.sweep.from), self.place(self.sweep.to));
        (from.min(to), from.max(to))
    }

    fn part(&self) -> f64 {
        let (from, to) = self.range();
        PART * (to - from)
    }

    fn system(&self, place: f64) -> Result<M::System, CycleError> {
        Ok(self.model.operating(Some((self.sweep, self.value(place))))?.system)
    }

    fn growth_rate(&self, place: f64) -> Option<f64> {
        growth_rate(&self.system(place).ok()?).ok()
    }

    /// The branch that begins at a Hopf point, on the side on which its cycles live.
    fn branch_of(&self, place: f64, hopf: &HopfPoint<N>) -> Result<DiagramBranch<N>, CycleError> {
        let slope =
            growth_slope(|place| self.growth_rate(place), place, self.part()).ok_or(CycleError::NotBorn)?;
        // the cycles have σ/Re c₁ < 0
        let side = if (slope < 0.0) == hopf.is_subcritical() { 1.0 } else { -1.0 };
        let branch = self.budgeted(place, |system_at, options| {
            let (parameter, small) = small_cycle(&system_at, place, hopf, side, options)?;
            continue_branch(&system_at, parameter, (small.start, 1), side, options)
        })?;
        let value = |place| self.value(place);
        let branch = DiagramBranch {
            from: format!("Hopf point at {}", plain(value(place))),
            hopf: Some((value(place), TAU / hopf.frequency)),
            points: branch.points,
            folds: branch.folds,
            shrinks: branch.end == BranchEnd::SteadySliding,
            end: branch.end.to_string(),
        };
        Ok(branch.at_values(value))
    }

    /// The branch through a simulated cycle, both ways.
    fn branch_through(&self, cycle: &SimulatedCycle<N>) -> Result<DiagramBranch<N>, CycleError> {
        let place = self.place(cycle.value);
        let follow = |direction: f64| {
            self.budgeted(place, |system_at, options| {
                continue_branch(&system_at, place, (cycle.start, cycle.oscillations), direction, options)
            })
        };
        let other = follow(1.0)?;
        // a closed branch has been followed all around
        let one = if other.end == BranchEnd::Closed { None } else { Some(follow(-1.0)?) };
        let from = format!("simulated cycle at {}", plain(cycle.value));
        let end = one.as_ref().map_or(other.end.to_string(), |one| {
            format!("one way it {}; the other way it {}", one.end, other.end)
        });
        let (before, turns) = one.map_or((Vec::new(), Vec::new()), |one| (one.points, one.folds));
        let has_both = !before.is_empty();
        let points =
            before.into_iter().rev().chain(other.points.into_iter().skip(usize::from(has_both))).collect();
        let folds = turns.into_iter().rev().chain(other.folds).collect();
        let shrinks = other.end == BranchEnd::SteadySliding;
        let branch = DiagramBranch { from, hopf: None, points, folds, shrinks, end };
        Ok(branch.at_values(|place| self.value(place)))
    }

    /// Follows a branch within its budget of flights; an interruption ends it.
    fn budgeted(
        &self,
        place: f64,
        follow: impl FnOnce(&SystemAt<'_, M::System>, &Continuation<N>) -> Result<CycleBranch<N>, CycleError>,
    ) -> Result<CycleBranch<N>, CycleError> {
        let flights = AtomicUsize::new(0);
        let system_at = |place: f64| {
            let flights = flights.fetch_add(1, Ordering::Relaxed);
            if flights >= FLIGHTS || self.progress.interrupted() {
                return Err(CycleError::Stopped { flights });
            }
            self.system(place)
        };
        let following = Following {
            tolerance: self.following.tolerance.min(TOLERANCE),
            steps: self.following.steps.min(STEPS),
            ..*self.following
        };
        let value = self.value(place);
        let settings = self.model.operating(Some((self.sweep, value)))?.settings(&following);
        let tolerance = 100.0 * following.tolerance;
        let options = Continuation {
            shooting: Shooting { settings, tolerance, iterations: 12, longest: LONGEST_PERIOD },
            range: self.range(),
            steps: STEP,
            points: CYCLES,
            parameter_scale: self.part(),
        };
        self.progress.expect(1);
        let branch = follow(&system_at, &options);
        self.progress.advance();
        branch
    }
}

/// The oscillator at a place along the sweep.
type SystemAt<'a, S> = dyn Fn(f64) -> Result<S, CycleError> + 'a;

/// Follows the branches from every Hopf point of the sweep, and from the simulated cycles that lie on none of them.
///
/// # Errors
/// [`ModelError::Interrupted`].
pub(super) fn follow<M: Moving<N>, const N: usize>(
    model: &M,
    sweep: &Sweep<M::Key>,
    following: &Following,
    simulated: &[SimulatedCycle<N>],
    progress: &dyn Progress,
) -> Result<Branches<N>, ModelError> {
    let line = SweepLine { model, sweep, following, progress };
    let (from, to) = line.range();
    let last = sweep.points.max(SAMPLES) - 1;
    let places: Vec<f64> = (0..=last).map(|k| from + (to - from) * k as f64 / last as f64).collect();
    let beside = CHANGE * line.part();
    let growth_at = |place: f64| line.growth_rate(place).unwrap_or(f64::NAN);
    let growth: Vec<f64> = places.iter().map(|place| growth_at(*place)).collect();
    let mut found = Branches {
        growth: places.iter().map(|place| line.value(*place)).zip(growth.iter().copied()).collect(),
        hopf_points: Vec::new(),
        branches: Vec::new(),
        simulated: Vec::new(),
        failed: Vec::new(),
    };
    // without damping the growth rate is zero but for rounding, and changes nowhere
    let changes = |place: &f64| {
        let (below, above) = (growth_at(place - beside), growth_at(place + beside));
        below * above < 0.0 && below.abs().min(above.abs()) > ROUNDING
    };
    for place in all_roots_from_values(growth_at, &places, &growth).roots.into_iter().filter(changes) {
        found.begin_at(&line, place);
        interrupted(progress)?;
    }
    let mut tried = 0;
    for cycle in simulated {
        if tried < FROM_SIMULATION && found.stability_of(cycle).is_none() {
            tried += 1;
            let branch = line.branch_through(cycle);
            found.keep(branch, || format!("simulated cycle at {}", plain(cycle.value)));
            interrupted(progress)?;
        }
    }
    found.simulated = simulated.iter().map(|cycle| found.stability_of(cycle)).collect();
    Ok(found)
}

fn interrupted(progress: &dyn Progress) -> Result<(), ModelError> {
    if progress.interrupted() { Err(ModelError::Interrupted) } else { Ok(()) }
}

impl<const N: usize> Branches<N> {
    /// Whether a simulated cycle is stable on the branch that it lies on, if it lies on one.
    fn stability_of(&self, cycle: &SimulatedCycle<N>) -> Option<bool> {
        let known: Vec<bool> = self.branches.iter().filter_map(|branch| branch.passes(cycle)).collect();
        (!known.is_empty()).then(|| known.contains(&true))
    }

    fn keep(&mut self, branch: Result<DiagramBranch<N>, CycleError>, start: impl Fn() -> String) {
        match branch {
            Ok(branch) => self.branches.push(branch),
            Err(error) => self.failed.push(format!("{}: {error}", start())),
        }
    }

    /// Notes a Hopf point and follows its branch, unless another one has ended there.
    fn begin_at<M: Moving<N>>(&mut self, line: &SweepLine<'_, M, N>, place: f64) {
        let value = line.value(place);
        let start = || format!("change of stability at {}", plain(value));
        let hopf = match line.system(place).and_then(|system| hopf_point(&system)) {
            Ok(hopf) => hopf,
            Err(error) => return self.keep(Err(error), start),
        };
        self.hopf_points.push(DiagramHopf { value, hopf });
        let ends_here = |branch: &DiagramBranch<N>| {
            let near = |point: &BranchPoint<N>| (line.place(point.parameter) - place).abs() < line.part();
            branch.shrinks && branch.points.last().is_some_and(near)
        };
        if !self.branches.iter().any(ends_here) {
            self.keep(line.branch_of(place, &hopf), start);
        }
    }
}
