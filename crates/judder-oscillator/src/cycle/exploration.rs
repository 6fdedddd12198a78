//! Motions beside stable steady sliding that are on no known branch: sought from many starts, followed to where they end.
//!
//! Beyond the fold of one branch cycles of others can live: of several oscillations, off the substrate for a part of the time, or none
//! at all, where a motion stays irregular. So starts are followed at places beyond all that is known. From one that does not come to
//! rest a new branch begins, which moves the limit, and the search goes on beyond that. Where no start moves nothing is proved: a
//! basin can be smaller than the starts are apart.

use super::confirmed::settle_confirmed;
use super::continuation::{Continuation, CycleBranch, continue_branch};
use super::{CycleError, shoot};
use crate::hopf::growth_rate;
use crate::motion::attractor::{Attractor, Patience, Settled, settle};
use crate::motion::{Interrupted, SlidingSystem};
use judder_numerics::parallel;
use judder_numerics::piecewise::StepSettings;
use judder_numerics::sampling::SobolSequence;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::array::from_fn;
use std::sync::atomic::{AtomicUsize, Ordering};

/// How far beyond the known motions others are sought, in scales of the parameter: on a logarithmic one at 0.95, 0.7, 0.5 and 0.3 of it.
const BEYOND: [f64; 4] = [0.05, 0.36, 0.69, 1.2];
/// How far before their end the basin is looked at.
const BEFORE: f64 = 0.05;
/// Starts at a place beside those on known cycles; those of its places differ.
const STARTS: usize = 48;
const SEED: u64 = 1;
/// Times that a new motion may move the limit.
const ROUNDS: usize = 12;
/// The smallest start, over the deflection under the load, which is 1; the largest is this many, or the velocity of the substrate.
const SMALLEST: f64 = 0.3;
const LARGEST: f64 = 10.0;
/// Local error of a step while motions are sought, relative: what is found is confirmed more exactly.
const TOLERANCE: f64 = 1e-6;
/// A motion may take so many times the steps of one flight around a cycle.
const FLIGHTS: usize = 100;
/// Steps of the parameter by which a motion is carried on, the first and the last, and the most cycles between there and its turn.
const CARRIED: (f64, f64) = (0.05, 0.005);
const POINTS: usize = 60;

/// What became of the starts at one value of the parameter.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
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

impl Look {
    /// Whether all starts came to rest, and there were some.
    #[must_use]
    pub fn is_quiet(&self) -> bool {
        self.starts > 0 && self.moved + self.undecided == 0
    }
}

/// The motions that are known beside a threshold.
#[derive(Debug, Clone, PartialEq)]
pub struct Exploration {
    /// The parameter farthest from the threshold at which a motion beside steady sliding is known.
    pub farthest: f64,
    /// Up to where from the threshold on one is known everywhere.
    pub without_a_gap: f64,
    /// How often the limit was moved.
    pub moves: usize,
    /// The basin a little before the farthest; `None` where steady sliding is not stable there.
    pub before: Option<Look>,
    /// Places beyond the farthest, where no start moved; fewer than sought where the range ends or steady sliding is not stable.
    pub beyond: Vec<Look>,
    /// Why no place further beyond was looked at.
    pub end: SearchEnd,
}

/// Why a search beyond the farthest known motion ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SearchEnd {
    /// No start moved at any of its places.
    NoneMoved,
    /// The range of the parameter ends before the next place.
    Range,
    /// Steady sliding is not stable at the next place.
    Unstable,
    /// Every round of it found a new motion.
    Rounds,
}

/// A motion that was found: where it is known, and its state at the end away from the threshold.
struct KnownMotion<const N: usize> {
    from: f64,
    to: f64,
    state: [f64; N],
}

struct CycleExplorer<'a, F, const N: usize> {
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
) -> Result<Exploration, CycleError> {
    let explorer = CycleExplorer { system_at, side: stable_side, options, interrupted };
    let mut warm = cycles;
    let mut found = Exploration {
        farthest,
        without_a_gap: farthest,
        moves: 0,
        before: None,
        beyond: Vec::new(),
        end: SearchEnd::Rounds,
    };
    while found.moves < ROUNDS {
        let (beyond, ended) = explorer.look_beyond(found.farthest, &warm)?;
        found.beyond = beyond;
        match ended {
            LookEnded::Quiet(end) => {
                found.end = end;
                break;
            }
            LookEnded::Motion(place, attractor) => {
                let known = explorer.follow(place, &attractor, found.without_a_gap)?;
                warm.push(known.state);
                found.add(&known, explorer.side, BEYOND[0] * options.parameter_scale);
            }
        }
    }
    let before = found.farthest - explorer.side * BEFORE * options.parameter_scale;
    found.before = explorer.count(before, &warm)?;
    Ok(found)
}

impl Exploration {
    /// The place farthest from the threshold up to which no start moved, and what became of all of them is known; `None` where there is
    /// none, or the search ended for want of rounds.
    #[must_use]
    pub fn quiet_to(&self) -> Option<f64> {
        let quiet = self.beyond.iter().take_while(|look| look.is_quiet());
        quiet.last().map(|look| look.parameter).filter(|_| self.end != SearchEnd::Rounds)
    }

    fn add<const N: usize>(&mut self, known: &KnownMotion<N>, side: f64, gap: f64) {
        self.moves += 1;
        self.farthest = known.to;
        // followed back to the known ones, but for what the steps of the search leave
        if (known.from - self.without_a_gap) * side < 0.5 * gap {
            self.without_a_gap = known.to;
        }
    }
}

enum SoughtCycle<const N: usize> {
    Nowhere(SearchEnd),
    Rest(Look),
    Motion(Box<Attractor<N>>),
}

/// How looking at all places beyond a limit ended.
enum LookEnded<const N: usize> {
    Quiet(SearchEnd),
    /// At the place where it was found.
    Motion(f64, Box<Attractor<N>>),
}

impl<S: SlidingSystem<N>, F: Fn(f64) -> Result<S, CycleError> + Sync, const N: usize>
    CycleExplorer<'_, F, N>
{
    /// The oscillator at a place, and how long motions are followed there; why it is not looked at outside of the range, and where
    /// steady sliding is not stable.
    fn stable(&self, place: f64) -> Result<Result<(S, Patience), SearchEnd>, CycleError> {
        /// Decay times until rest, and the bounds of what is waited.
        const DECAYS: f64 = 40.0;
        const TIME: (f64, f64) = (2e3, 2e4);
        let (from, to) = self.options.range;
        if !(from..=to).contains(&place) {
            return Ok(Err(SearchEnd::Range));
        }
        let system = (self.system_at)(place)?;
        let growth = growth_rate(&system)?;
        let time = (DECAYS / growth.abs()).clamp(TIME.0, TIME.1);
        let patience = Patience { time, transient: 0.5 * time, ..Patience::default() };
        Ok(if growth < 0.0 { Ok((system, patience)) } else { Err(SearchEnd::Unstable) })
    }

    /// How starts are followed: no more exactly than branches are.
    fn settings(&self) -> StepSettings<N> {
        let settings = self.options.shooting.settings;
        let relative = settings.relative.max(TOLERANCE);
        let ratio = relative / settings.relative;
        let absolute = settings.absolute.map(|absolute| ratio * absolute);
        StepSettings { relative, absolute, steps: FLIGHTS * settings.steps, ..settings }
    }

    /// States on known cycles, then steady sliding disturbed in every coordinate, by sizes spread evenly over their logarithm, others at
    /// `which` place.
    fn starts(system: &S, which: usize, warm: &[[f64; N]]) -> Vec<[f64; N]> {
        let rest = system.steady_sliding();
        let ratio = LARGEST.max(system.belt_velocity()) / SMALLEST;
        let Ok(sequence) = SobolSequence::scrambled(N + 1, SEED) else { return warm.to_vec() };
        let disturbed = ((which * STARTS) as u64..).take(STARTS).map(|index| {
            let size = SMALLEST * libm::pow(ratio, sequence.coordinate(index, N));
            from_fn(|i| rest[i] + size * (2.0 * sequence.coordinate(index, i) - 1.0))
        });
        warm.iter().copied().chain(disturbed).collect()
    }

    /// What became of the starts at the places beyond a limit, up to the first that does not come to rest.
    fn look_beyond(&self, limit: f64, warm: &[[f64; N]]) -> Result<(Vec<Look>, LookEnded<N>), CycleError> {
        let mut looks = Vec::new();
        for (which, distance) in BEYOND.into_iter().enumerate() {
            let place = limit + self.side * distance * self.options.parameter_scale;
            match self.look(place, which, warm)? {
                SoughtCycle::Nowhere(why) => return Ok((looks, LookEnded::Quiet(why))),
                SoughtCycle::Rest(look) => looks.push(look),
                SoughtCycle::Motion(attractor) => return Ok((looks, LookEnded::Motion(place, attractor))),
            }
        }
        Ok((looks, LookEnded::Quiet(SearchEnd::NoneMoved)))
    }

    /// The first start at a place that does not come to rest.
    fn look(&self, place: f64, which: usize, warm: &[[f64; N]]) -> Result<SoughtCycle<N>, CycleError> {
        let (system, patience) = match self.stable(place)? {
            Ok(stable) => stable,
            Err(why) => return Ok(SoughtCycle::Nowhere(why)),
        };
        let starts = Self::starts(&system, which, warm);
        let settings = self.settings();
        let undecided = AtomicUsize::new(0);
        let moving = starts.par_iter().find_map_first(|start| {
            match settle_confirmed(&system, *start, settings, &patience, self.interrupted) {
                Ok(told) if told.is_confirmed => {
                    Some(told.attractor).filter(|found| found.settled != Settled::SteadySliding)
                }
                _ => {
                    undecided.fetch_add(1, Ordering::Relaxed);
                    None
                }
            }
        });
        // where none moves every start was followed, so that their number does not depend on the threads
        let undecided = undecided.into_inner();
        Ok(match moving {
            Some(attractor) => SoughtCycle::Motion(Box::new(attractor)),
            None => SoughtCycle::Rest(Look { parameter: place, starts: starts.len(), moved: 0, undecided }),
        })
    }

    /// What becomes of all starts at a place.
    fn count(&self, place: f64, warm: &[[f64; N]]) -> Result<Option<Look>, CycleError> {
        let Ok((system, patience)) = self.stable(place)? else { return Ok(None) };
        let starts = Self::starts(&system, BEYOND.len(), warm);
        let settings = self.settings();
        let fates: Vec<Option<bool>> = parallel::each(&starts, |start| {
            let settled = settle(&system, *start, settings, &patience, self.interrupted).ok()?;
            Some(settled.settled != Settled::SteadySliding)
        });
        let count = |fate: Option<bool>| fates.iter().filter(|f| **f == fate).count();
        Ok(Some(Look {
            parameter: place,
            starts: starts.len(),
            moved: count(Some(true)),
            undecided: count(None),
        }))
    }

    /// The motion away from the threshold to its end, and back as far as to `known`.
    fn follow(&self, place: f64, attractor: &Attractor<N>, known: f64) -> Result<KnownMotion<N>, CycleError> {
        let (from, _) = self.carry(place, attractor, -self.side, known)?;
        let (from_end, to_end) = self.options.range;
        let end = if self.side > 0.0 { to_end } else { from_end };
        let (last, carried) = self.carry(place, attractor, self.side, end)?;
        // the last step may be one that steady sliding does not stay stable over
        let (to, state) = match (end - last).abs() < CARRIED.1 * self.options.parameter_scale {
            true => (end, carried.state),
            false => self.turn(last, &carried)?.unwrap_or((last, carried.state)),
        };
        Ok(KnownMotion { from, to: to.clamp(from_end, to_end), state })
    }

    /// A motion carried on step by step, up to `end` at most: the last place at which it moves, and what it is there.
    fn carry(
        &self,
        from: f64,
        attractor: &Attractor<N>,
        direction: f64,
        end: f64,
    ) -> Result<(f64, Attractor<N>), CycleError> {
        let (mut place, mut carried) = (from, attractor.clone());
        let scale = self.options.parameter_scale;
        let mut step = CARRIED.0;
        while step >= CARRIED.1 && !(self.interrupted)() && (end - place) * direction > 0.0 {
            let beyond = place + direction * step * scale;
            let next = if (end - beyond) * direction > 0.0 { beyond } else { end };
            let moved = match self.stable(next)? {
                Err(_) => None,
                Ok((system, patience)) => {
                    settle_confirmed(&system, carried.state, self.settings(), &patience, self.interrupted)
                        .ok()
                        .filter(|told| told.attractor.settled != Settled::SteadySliding)
                }
            };
            match moved {
                Some(told) => (place, carried) = (next, told.attractor),
                None => step *= 0.5,
            }
        }
        Ok((place, carried))
    }

    /// Where the branch of a stable cycle turns, a little beyond the last place to which it was carried, with a cycle before that; `None`
    /// where the motion is no stable cycle, or its turn is not found.
    fn turn(&self, place: f64, attractor: &Attractor<N>) -> Result<Option<(f64, [f64; N])>, CycleError> {
        let Settled::Cycle { oscillations } = attractor.settled else { return Ok(None) };
        let system = (self.system_at)(place)?;
        let Ok(cycle) = shoot(&system, attractor.state, oscillations, &self.options.shooting) else {
            return Ok(None);
        };
        let end = place + self.side * CARRIED.0 * self.options.parameter_scale;
        let options =
            Continuation { range: (place.min(end), place.max(end)), points: POINTS, ..*self.options };
        let start = (cycle.start, cycle.oscillations);
        let branch = continue_branch(self.system_at, place, start, self.side, &options);
        Ok(branch.ok().filter(|_| cycle.is_stable()).and_then(|branch| first_turn(&branch)))
    }
}

/// The first turn of a branch with the cycle before it, if all cycles up to there are stable.
fn first_turn<const N: usize>(branch: &CycleBranch<N>) -> Option<(f64, [f64; N])> {
    let fold = branch.folds.first()?;
    let before = branch.points.get(..=fold.after)?;
    let last = before.last().filter(|_| before.iter().all(|point| point.cycle.is_stable()))?;
    Some((fold.parameter, last.cycle.start))
}
