//! Motions beside stable steady sliding that are on no known branch: sought from many starts, followed to where they end.
//!
//! Beyond the fold of one branch cycles of others can live: of several oscillations, off the substrate for a part of the time, or none
//! at all, where a motion stays irregular. So starts are followed at places beyond all that is known. From one that does not come to
//! rest a new branch begins, which moves the limit, and the search goes on beyond that. Where no start moves nothing is proved: a
//! basin can be smaller than the starts are apart.

use super::confirmed::settle_confirmed;
use super::continuation::{Branch, Continuation, continue_branch};
use super::{CycleError, shoot};
use crate::hopf::growth_rate;
use crate::motion::attractor::{Attractor, Patience, Settled, settle};
use crate::motion::{Interrupted, SlidingSystem};
use judder_numerics::piecewise::Settings;
use judder_numerics::sampling::SobolSequence;
use rayon::prelude::*;
use std::array::from_fn;

/// How far beyond the known motions others are sought, in scales of the parameter: on a logarithmic one at 0.95, 0.7, 0.5 and 0.3 of it.
const BEYOND: [f64; 4] = [0.05, 0.36, 0.69, 1.2];
/// How far before their end the basin is looked at.
const BEFORE: f64 = 0.05;
/// Starts at a place beside those on known cycles.
const STARTS: usize = 48;
const SEED: u64 = 1;
/// Times that a new motion may move the limit.
const ROUNDS: usize = 12;
/// The smallest start, over the deflection under the load, which is 1; the largest is this many, or the velocity of the substrate.
const SMALLEST: f64 = 0.3;
const LARGEST: f64 = 10.0;
/// Local error of a step while motions are sought, relative: what is found is confirmed more exactly.
const TOLERANCE: f64 = 1e-6;
/// Steps of the parameter by which a motion that is no branch is carried on, the first and the last.
const CARRIED: (f64, f64) = (0.05, 0.005);

/// What became of the starts at one value of the parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Look {
    /// The parameter.
    pub parameter: f64,
    /// Starts that were followed.
    pub starts: usize,
    /// Those that came to no rest.
    pub moved: usize,
    /// Those that are lost, or whose kind is not confirmed.
    pub undecided: usize,
}

/// The motions that are known beside a threshold.
#[derive(Debug, Clone, PartialEq)]
pub struct Exploration<const N: usize> {
    /// The parameter farthest from the threshold at which a motion beside steady sliding is known.
    pub farthest: f64,
    /// Up to where from the threshold on one is known everywhere.
    pub without_a_gap: f64,
    /// The branches that were found, each from the place of its search away from the threshold.
    pub branches: Vec<Branch<N>>,
    /// How often the limit was moved.
    pub moves: usize,
    /// The basin a little before the farthest; `None` where steady sliding is not stable there.
    pub before: Option<Look>,
    /// Places beyond the farthest, where no start moved; fewer than sought where the range ends or steady sliding is not stable.
    pub beyond: Vec<Look>,
    /// Whether the search ended because no start moved, and not for want of rounds.
    pub is_closed: bool,
}

/// A motion that was found, and what is known of it away from the threshold and back.
struct Known<const N: usize> {
    from: f64,
    to: f64,
    branch: Option<Branch<N>>,
    state: [f64; N],
}

struct Explorer<'a, F, const N: usize> {
    system_at: &'a F,
    /// +1 where steady sliding is stable above the threshold, −1 where it is below.
    side: f64,
    options: &'a Continuation<N>,
    interrupted: Interrupted<'a>,
}

/// Seeks motions on the stable side of a threshold, beyond the `farthest` at which one is known; `cycles` are states on known cycles.
///
/// # Errors
/// [`CycleError::Stopped`], by `system_at`, or an oscillator without steady sliding at a value of the range.
pub fn explore<S: SlidingSystem<N>, F: Fn(f64) -> Result<S, CycleError> + Sync, const N: usize>(
    system_at: &F,
    (farthest, cycles): (f64, Vec<[f64; N]>),
    stable_side: f64,
    options: &Continuation<N>,
    interrupted: Interrupted<'_>,
) -> Result<Exploration<N>, CycleError> {
    let explorer = Explorer { system_at, side: stable_side, options, interrupted };
    let mut warm = cycles;
    let mut found = Exploration {
        farthest,
        without_a_gap: farthest,
        branches: Vec::new(),
        moves: 0,
        before: None,
        beyond: Vec::new(),
        is_closed: false,
    };
    while found.moves < ROUNDS && !found.is_closed {
        found.beyond.clear();
        found.is_closed = true;
        for distance in BEYOND {
            let place = found.farthest + explorer.side * distance * options.parameter_scale;
            match explorer.look(place, &warm)? {
                Sought::Nowhere => break,
                Sought::Rest(look) => found.beyond.push(look),
                Sought::Motion(attractor) => {
                    let known = explorer.follow(place, &attractor, found.without_a_gap)?;
                    warm.push(known.state);
                    found.add(known, explorer.side, BEYOND[0] * options.parameter_scale);
                    found.is_closed = false;
                    break;
                }
            }
        }
    }
    let before = found.farthest - explorer.side * BEFORE * options.parameter_scale;
    found.before = explorer.count(before, &warm)?;
    Ok(found)
}

impl<const N: usize> Exploration<N> {
    fn add(&mut self, known: Known<N>, side: f64, gap: f64) {
        self.moves += 1;
        self.farthest = known.to;
        // followed back to the known ones, but for what the steps of the search leave
        if (known.from - self.without_a_gap) * side < 0.5 * gap {
            self.without_a_gap = known.to;
        }
        self.branches.extend(known.branch);
    }
}

enum Sought<const N: usize> {
    /// The range ends before, or steady sliding is not stable there.
    Nowhere,
    Rest(Look),
    Motion(Box<Attractor<N>>),
}

impl<S: SlidingSystem<N>, F: Fn(f64) -> Result<S, CycleError> + Sync, const N: usize> Explorer<'_, F, N> {
    /// The oscillator at a place of the range with its starts; `None` outside, and where steady sliding is not stable.
    fn stable(&self, place: f64) -> Result<Option<(S, Patience)>, CycleError> {
        /// Decay times until rest, and the bounds of what is waited.
        const DECAYS: f64 = 40.0;
        const TIME: (f64, f64) = (2e3, 2e4);
        let (from, to) = self.options.range;
        if !(from..=to).contains(&place) {
            return Ok(None);
        }
        let system = (self.system_at)(place)?;
        let growth = growth_rate(&system)?;
        let time = (DECAYS / growth.abs()).clamp(TIME.0, TIME.1);
        let patience = Patience { time, transient: 0.5 * time, ..Patience::default() };
        Ok((growth < 0.0).then_some((system, patience)))
    }

    /// How starts are followed: no more exactly than branches are.
    fn settings(&self) -> Settings<N> {
        let settings = self.options.shooting.settings;
        let relative = settings.relative.max(TOLERANCE);
        let ratio = relative / settings.relative;
        Settings { relative, absolute: settings.absolute.map(|absolute| ratio * absolute), ..settings }
    }

    /// States on known cycles, then steady sliding disturbed in every coordinate, by sizes spread evenly over their logarithm.
    fn starts(system: &S, warm: &[[f64; N]]) -> Vec<[f64; N]> {
        let rest = system.steady_sliding();
        let ratio = LARGEST.max(system.belt_velocity()) / SMALLEST;
        let Ok(sequence) = SobolSequence::scrambled(N + 1, SEED) else { return warm.to_vec() };
        let disturbed = (0..STARTS as u64).map(|index| {
            let size = SMALLEST * ratio.powf(sequence.coordinate(index, N));
            from_fn(|i| rest[i] + size * (2.0 * sequence.coordinate(index, i) - 1.0))
        });
        warm.iter().copied().chain(disturbed).collect()
    }

    /// The first start at a place that does not come to rest.
    fn look(&self, place: f64, warm: &[[f64; N]]) -> Result<Sought<N>, CycleError> {
        let Some((system, patience)) = self.stable(place)? else { return Ok(Sought::Nowhere) };
        let starts = Self::starts(&system, warm);
        let settings = self.settings();
        let fate = |start: &[f64; N]| {
            settle_confirmed(&system, *start, settings, &patience, self.interrupted)
                .ok()
                .filter(|told| told.is_confirmed)
                .map(|told| told.attractor)
        };
        let rests = |attractor: &Attractor<N>| attractor.settled == Settled::SteadySliding;
        let moving = starts.par_iter().find_map_first(|start| fate(start).filter(|found| !rests(found)));
        if let Some(attractor) = moving {
            return Ok(Sought::Motion(Box::new(attractor)));
        }
        let undecided = starts.par_iter().filter(|start| fate(start).is_none()).count();
        Ok(Sought::Rest(Look { parameter: place, starts: starts.len(), moved: 0, undecided }))
    }

    /// What becomes of all starts at a place.
    fn count(&self, place: f64, warm: &[[f64; N]]) -> Result<Option<Look>, CycleError> {
        let Some((system, patience)) = self.stable(place)? else { return Ok(None) };
        let starts = Self::starts(&system, warm);
        let settings = self.settings();
        let fates: Vec<Option<bool>> = starts
            .par_iter()
            .map(|start| {
                let settled = settle(&system, *start, settings, &patience, self.interrupted).ok()?;
                Some(settled.settled != Settled::SteadySliding)
            })
            .collect();
        let count = |fate: Option<bool>| fates.iter().filter(|f| **f == fate).count();
        Ok(Some(Look {
            parameter: place,
            starts: starts.len(),
            moved: count(Some(true)),
            undecided: count(None),
        }))
    }

    /// The motion away from the threshold to its end, as a branch where it is a cycle; back as far as to `known`.
    fn follow(&self, place: f64, attractor: &Attractor<N>, known: f64) -> Result<Known<N>, CycleError> {
        let system = (self.system_at)(place)?;
        if let Settled::Cycle { oscillations } = attractor.settled
            && let Ok(cycle) = shoot(&system, attractor.state, oscillations, &self.options.shooting)
            && cycle.is_stable()
        {
            let (start, count) = (cycle.start, cycle.oscillations);
            let along = |direction: f64, range: (f64, f64)| {
                let options = Continuation { range, ..*self.options };
                continue_branch(self.system_at, place, (start, count), direction, &options)
            };
            let back = along(-self.side, (place.min(known), place.max(known)));
            let from = back.ok().map_or(place, |branch| stable_to(&branch, -self.side).0);
            if let Ok(branch) = along(self.side, self.options.range) {
                let (to, state) = stable_to(&branch, self.side);
                if to != place {
                    return Ok(Known { from, to: self.within(to), branch: Some(branch), state });
                }
            }
        }
        let (from, _) = self.carry(place, attractor.state, -self.side, known)?;
        let (from_end, to_end) = self.options.range;
        let end = if self.side > 0.0 { to_end } else { from_end };
        let (to, state) = self.carry(place, attractor.state, self.side, end)?;
        Ok(Known { from, to, branch: None, state })
    }

    fn within(&self, place: f64) -> f64 {
        place.clamp(self.options.range.0, self.options.range.1)
    }

    /// A motion carried on step by step, up to `end` at most: the last place at which it moves, and its state there.
    fn carry(
        &self,
        from: f64,
        state: [f64; N],
        direction: f64,
        end: f64,
    ) -> Result<(f64, [f64; N]), CycleError> {
        let (mut place, mut state) = (from, state);
        let scale = self.options.parameter_scale;
        let mut step = CARRIED.0;
        while step >= CARRIED.1 && !(self.interrupted)() && (end - place) * direction > 0.0 {
            let next = place + direction * step * scale;
            let moved = match self.stable(next)? {
                None => None,
                Some((system, patience)) => {
                    settle(&system, state, self.settings(), &patience, self.interrupted)
                        .ok()
                        .filter(|attractor| attractor.settled != Settled::SteadySliding)
                }
            };
            match moved {
                Some(attractor) => (place, state) = (next, attractor.state),
                None => step *= 0.5,
            }
        }
        Ok((place, state))
    }
}

/// How far along a direction the first cycles of a branch stay stable, to its first fold at most; with a cycle there.
fn stable_to<const N: usize>(branch: &Branch<N>, direction: f64) -> (f64, [f64; N]) {
    let fold = branch.folds.first();
    let last = fold.map_or(branch.points.len(), |fold| fold.after + 1);
    let stable = branch.points[..last].iter().take_while(|point| point.cycle.is_stable());
    let (mut place, mut state, mut count) = (f64::NAN, [f64::NAN; N], 0);
    for point in stable {
        count += 1;
        if place.is_nan() || (point.parameter - place) * direction > 0.0 {
            (place, state) = (point.parameter, point.cycle.start);
        }
    }
    match fold {
        Some(fold) if count == last => (fold.parameter, state),
        _ => (place, state),
    }
}
