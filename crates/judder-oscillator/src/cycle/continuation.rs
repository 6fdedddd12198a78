//! Branches of cycles along a parameter, through folds and changes of the pattern.
//!
//! Pseudo-arclength continuation (H. B. Keller, 1977) on the return map. Where a cycle begins to touch a guard, the return
//! map has a kink: the next point lies on a smooth piece with a derivative of its own, which Newton's method uses.

mod doubled;
mod place;
mod touching;

use super::CycleError;
use super::newton::{CycleGuess, Shooting, scaled};
use super::return_map::{Return, return_map, returned_state};
use super::shooting::{Cycle, finished, shoot};
use crate::motion::{ContactState, SlidingSystem};
use doubled::Halves;
use judder_numerics::dense::Triangles;
use place::{BranchPlace, Outing, neighbour};
use std::array::from_fn;
use std::fmt;

/// How a branch is followed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Continuation<const N: usize> {
    /// How each cycle is sought.
    pub shooting: Shooting<N>,
    /// The parameter's range; the branch ends where it leaves it.
    pub range: (f64, f64),
    /// The first and the longest step along the branch, in scales of the state and of the parameter.
    pub steps: (f64, f64),
    /// The most points.
    pub points: usize,
    /// The length of the parameter that counts as much as one scale of the state.
    pub parameter_scale: f64,
}

/// A cycle on a branch.
#[derive(Debug, Clone, PartialEq)]
pub struct BranchPoint<const N: usize> {
    /// The parameter.
    pub parameter: f64,
    /// The cycle.
    pub cycle: Cycle<N>,
    /// The unit tangent's component along the parameter: its sign changes at a fold.
    pub slope: f64,
}

/// Why a branch ends.
#[derive(Debug, Clone, PartialEq)]
pub enum BranchEnd {
    /// It left the range of the parameter.
    Range,
    /// It has as many points as were asked for.
    Points,
    /// It shrank to steady sliding: a Hopf point.
    SteadySliding,
    /// It came back to its first cycle.
    Closed,
    /// Its two halves became one: the cycles from which its period has doubled.
    Halves,
    /// Its cycles come to touch a guard beyond which the return map jumps: no neighbour on the other side is a cycle.
    Grazing {
        /// The contact states of the motions beyond.
        pattern: Vec<ContactState>,
        /// By how much the return jumps, in scales.
        jump: f64,
    },
    /// No next cycle could be found, with the last reason.
    Lost(CycleError),
}

impl fmt::Display for BranchEnd {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Range => formatter.write_str("leaves the range"),
            Self::Points => formatter.write_str("goes on: as many cycles as were asked for"),
            Self::SteadySliding => formatter.write_str("shrinks to steady sliding"),
            Self::Closed => formatter.write_str("comes back to where it began"),
            Self::Halves => formatter.write_str("comes to cycles of half as many oscillations"),
            Self::Grazing { pattern, .. } => {
                let words: Vec<String> = pattern.iter().map(ToString::to_string).collect();
                let beyond = words.join(", ");
                write!(
                    formatter,
                    "grazes: beyond, motions go through {beyond}, and their return jumps away from the cycle"
                )
            }
            Self::Lost(error) => write!(formatter, "lost: {error}"),
        }
    }
}

/// Cycles along a parameter.
#[derive(Debug, Clone, PartialEq)]
pub struct CycleBranch<const N: usize> {
    /// In the order in which they were found.
    pub points: Vec<BranchPoint<N>>,
    /// Where the parameter turns.
    pub folds: Vec<Fold>,
    /// Where the pattern of contact states changes, because the cycle touches a guard.
    pub pattern_changes: Vec<PatternChange>,
    /// Why it ends.
    pub end: BranchEnd,
}

/// A turn of the parameter along a branch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fold {
    /// Index of the point before it.
    pub after: usize,
    /// The parameter at the turn.
    pub parameter: f64,
    /// Whether it turns smoothly; otherwise with a kink, where the pattern changes too.
    pub is_smooth: bool,
}

/// Two neighbours on a branch with different patterns of contact states.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PatternChange {
    /// Index of the point before it.
    pub after: usize,
    /// The parameters of the two.
    pub between: (f64, f64),
}

/// A step that fails below it stands before a kink of the branch.
const KINK: f64 = 1e-5;

/// A branch that makes so many steps in a row below this length crawls.
const SHORT_STEPS: usize = 24;
const SHORT: f64 = 1e-4;

struct Walk<'a, F, const N: usize> {
    system_at: &'a F,
    options: &'a Continuation<N>,
    oscillations: usize,
    scales: [f64; N],
}

/// The branch through a cycle, starting towards rising (`direction` = 1) or falling (−1) values of the parameter.
///
/// `system_at` makes the oscillator at a value of the parameter.
///
/// # Errors
/// The first cycle or its tangent cannot be had; later failures end the branch with their reason.
pub fn continue_branch<S: SlidingSystem<N>, const N: usize>(
    system_at: &impl Fn(f64) -> Result<S, CycleError>,
    parameter: f64,
    cycle: ([f64; N], usize),
    direction: f64,
    options: &Continuation<N>,
) -> Result<CycleBranch<N>, CycleError> {
    let system = system_at(parameter)?;
    let first = shoot(&system, cycle.0, cycle.1, &options.shooting)?;
    let walk = Walk { system_at, options, oscillations: first.oscillations, scales: system.scales() };
    let mut place = walk.first_place(&first, parameter, direction)?;
    let mut outing = Outing::from(place.clone());
    let first = BranchPoint { parameter, cycle: first, slope: place.tangent[N] };
    let mut halves = Halves::of(&walk, &first);
    let mut branch =
        CycleBranch { points: vec![first], folds: vec![], pattern_changes: vec![], end: BranchEnd::Points };
    let (mut step, mut short_steps) = (options.steps.0, 0);
    while branch.points.len() < options.points {
        match walk.next(&place, step).and_then(|found| neighbour(&branch, &place, step, found)) {
            Ok(found) => {
                let (next, next_place) = walk.away_from_the_kink(&place, step, &branch, found);
                let stretch = match next.cycle.iterations {
                    ..=6 => 1.4,
                    7 | 8 => 1.0,
                    _ => 0.7,
                };
                step = (step * stretch).min(options.steps.1);
                walk.note_changes(&mut branch, &next, &place);
                branch.points.push(next);
                place = next_place;
            }
            Err(_) if step > KINK => step *= 0.4,
            Err(error) => match walk.round_the_kink(&place, &branch) {
                Some(found) => {
                    let (next, next_place) = walk.away_from_the_kink(&place, options.steps.0, &branch, found);
                    walk.note_changes(&mut branch, &next, &place);
                    branch.points.push(next);
                    place = next_place;
                    step = options.steps.0;
                }
                None => {
                    branch.end = walk.grazing(&place, &branch).unwrap_or(BranchEnd::Lost(error));
                    break;
                }
            },
        }
        short_steps = if step < SHORT { short_steps + 1 } else { 0 };
        let crawls = short_steps >= SHORT_STEPS;
        let grazing = if crawls { walk.grazing(&place, &branch) } else { None };
        let end = grazing.or_else(|| walk.end_of(&branch)).or_else(|| outing.end(&place, &branch));
        if let Some(end) = end.or_else(|| halves.end(&walk, &mut branch)) {
            branch.end = end;
            break;
        }
    }
    Ok(branch)
}

impl<S: SlidingSystem<N>, F: Fn(f64) -> Result<S, CycleError>, const N: usize> Walk<'_, F, N> {
    fn first_place(
        &self,
        cycle: &Cycle<N>,
        parameter: f64,
        direction: f64,
    ) -> Result<BranchPlace, CycleError> {
        let mut at: Vec<f64> = (0..N).map(|i| cycle.start[i] / self.scales[i]).collect();
        at.push(parameter / self.options.parameter_scale);
        let mut upwards = vec![0.0; N + 1];
        upwards[N] = direction;
        let tangent = self.tangent(&at, &cycle.around, &upwards)?;
        Ok(BranchPlace { at, tangent })
    }

    fn end_of(&self, branch: &CycleBranch<N>) -> Option<BranchEnd> {
        /// Of the largest amplitude on the branch: what is smaller has shrunk to its Hopf point.
        const AT_REST: f64 = 1e-4;
        let last = branch.points.last()?;
        let (from, to) = self.options.range;
        if last.parameter < from || last.parameter > to {
            return Some(BranchEnd::Range);
        }
        let amplitude = |point: &BranchPoint<N>| point.cycle.around.measures.amplitude();
        let largest = branch.points.iter().map(amplitude).fold(0.0, f64::max);
        (amplitude(last) < AT_REST * largest).then_some(BranchEnd::SteadySliding)
    }

    fn parameter(&self, at: &[f64]) -> f64 {
        at[N] * self.options.parameter_scale
    }

    fn around(&self, at: &[f64]) -> Result<(S, Return<N>), CycleError> {
        let Shooting { settings, longest, .. } = self.options.shooting;
        let system = (self.system_at)(self.parameter(at))?;
        let around = return_map(&system, self.state(at), self.oscillations, settings, longest)?;
        Ok((system, around))
    }

    fn state(&self, at: &[f64]) -> [f64; N] {
        from_fn(|i| at[i] * self.scales[i])
    }

    /// P(u) − u in scales.
    fn residual(&self, at: &[f64], returned: &[f64; N]) -> [f64; N] {
        from_fn(|i| returned[i] / self.scales[i] - at[i])
    }

    /// The residual when the parameter alone has moved.
    fn residual_beside(&self, at: &[f64], by: f64) -> Result<[f64; N], CycleError> {
        let Shooting { settings, longest, .. } = self.options.shooting;
        let system = (self.system_at)((at[N] + by) * self.options.parameter_scale)?;
        let returned = returned_state(&system, self.state(at), self.oscillations, settings, longest)?;
        Ok(self.residual(at, &returned))
    }

    /// The derivative of the residual by state and parameter, above a last row of the caller's.
    fn bordered(&self, at: &[f64], around: &Return<N>, last: &[f64]) -> Result<Triangles, CycleError> {
        /// Of the root of a step's tolerance: wide enough for the digits of a return, narrow enough to end before a guard that is near.
        const DIFFERENCE: f64 = 0.03;
        let by = DIFFERENCE * self.options.shooting.settings.relative.sqrt();
        let (above, below) = (self.residual_beside(at, by)?, self.residual_beside(at, -by)?);
        let derivative = scaled(&around.derivative, &self.scales);
        let mut matrix = Vec::with_capacity((N + 1) * (N + 1));
        for (i, row) in derivative.iter().enumerate() {
            matrix.extend(row.iter().enumerate().map(|(j, d)| d - f64::from(u8::from(i == j))));
            matrix.push((above[i] - below[i]) / (2.0 * by));
        }
        matrix.extend_from_slice(last);
        Triangles::new(N + 1, matrix).ok_or(CycleError::Singular)
    }

    /// The unit tangent of the branch that agrees in direction with `before`.
    fn tangent(&self, at: &[f64], around: &Return<N>, before: &[f64]) -> Result<Vec<f64>, CycleError> {
        let mut tangent = vec![0.0; N + 1];
        tangent[N] = 1.0;
        self.bordered(at, around, before)?.solve(&mut tangent);
        let length = tangent.iter().fold(0.0, |sum, t| sum + t * t).sqrt();
        if !length.is_finite() || length == 0.0 {
            return Err(CycleError::Singular);
        }
        Ok(tangent.iter().map(|t| t / length).collect())
    }

    /// The next cycle, a step along the tangent away.
    fn next(&self, from: &BranchPlace, step: f64) -> Result<(BranchPoint<N>, BranchPlace), CycleError> {
        let shooting = &self.options.shooting;
        let mut at: Vec<f64> = from.at.iter().zip(&from.tangent).map(|(p, t)| p + step * t).collect();
        let mut residual = f64::NAN;
        for iteration in 0..=shooting.iterations {
            let (system, around) = self.around(&at)?;
            let missed = self.residual(&at, &around.state);
            residual = missed.iter().fold(0.0, |largest: f64, m| largest.max(m.abs()));
            if residual <= shooting.tolerance {
                let tangent = self.tangent(&at, &around, &from.tangent)?;
                let guess = CycleGuess { start: self.state(&at), around, residual };
                let cycle = finished(&system, self.oscillations, guess, iteration)?;
                let point = BranchPoint { parameter: self.parameter(&at), cycle, slope: tangent[N] };
                return Ok((point, BranchPlace { at, tangent }));
            }
            let mut correction: Vec<f64> = missed.iter().map(|m| -m).chain([0.0]).collect();
            self.bordered(&at, &around, &from.tangent)?.solve(&mut correction);
            let size = correction.iter().fold(0.0, |largest: f64, c| largest.max(c.abs()));
            if !size.is_finite() || size > 2.0 * step {
                break;
            }
            for (p, c) in at.iter_mut().zip(&correction) {
                *p += c;
            }
        }
        Err(CycleError::NotConverged { iterations: shooting.iterations, residual })
    }

    /// Notes a fold and a change of the pattern between the branch's last point and the next.
    fn note_changes(&self, branch: &mut CycleBranch<N>, next: &BranchPoint<N>, from: &BranchPlace) {
        let Some(last) = branch.points.last() else { return };
        let after = branch.points.len() - 1;
        let keeps_pattern = last.cycle.around.pattern == next.cycle.around.pattern;
        let was_kink = branch.pattern_changes.last().is_some_and(|change| change.after + 1 == after);
        if !keeps_pattern {
            branch.pattern_changes.push(PatternChange { after, between: (last.parameter, next.parameter) });
        }
        if last.slope * next.slope < 0.0 {
            let there = BranchPlace { at: self.scaled_place(next), tangent: Vec::new() };
            let parameter = self.turn(from, last, next, from.distance(&there));
            branch.folds.push(Fold { after, parameter, is_smooth: keeps_pattern && !was_kink });
        }
    }

    fn scaled_place(&self, point: &BranchPoint<N>) -> Vec<f64> {
        let state = (0..N).map(|i| point.cycle.start[i] / self.scales[i]);
        state.chain([point.parameter / self.options.parameter_scale]).collect()
    }

    /// The extreme of the parameter between two points: ever shorter steps from this side of the turn.
    fn turn(&self, from: &BranchPlace, last: &BranchPoint<N>, next: &BranchPoint<N>, length: f64) -> f64 {
        const SHORTEST: f64 = 1e-6;
        let rises = last.slope > 0.0;
        let further = |a: f64, b: f64| if rises { a.max(b) } else { a.min(b) };
        let mut extreme = further(last.parameter, next.parameter);
        let mut place = from.clone();
        let mut step = 0.5 * length;
        while step > SHORTEST {
            match self.next(&place, step) {
                Ok((point, there)) => {
                    extreme = further(extreme, point.parameter);
                    if (point.slope > 0.0) == rises {
                        place = there;
                    } else {
                        step *= 0.5;
                    }
                    if point.slope.abs() < 1e-6 {
                        break;
                    }
                }
                Err(_) => step *= 0.5,
            }
        }
        extreme
    }
}
