//! The basin of steady sliding by knocks: impulses at an observed point, marched until it is clear what becomes of them.

use super::settings::Knocks;
use crate::assembly::AssemblySubject;
use crate::assembly::march::settings::SchemeWord;
use crate::error::ModelError;
use judder_assembly::row::Row;
use judder_assembly::steady::SteadySliding;
use judder_nonsmooth::energy::{EnergyAboutSliding, EnergyWindows};
use judder_nonsmooth::march::NonsmoothMarch;
use judder_numerics::counter::uniform;
use judder_numerics::share::wilson;
use judder_store::{Dataset, Results, Variable};
use judder_structure::complex_modes::{ComplexMode, Verdict};
use judder_structure::factor::SymmetricFactor;
use judder_study::Progress;
use judder_study::kept::KeptLines;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// What becomes of a knock, by its code, in the order in which they are drawn.
pub(super) const FATES: [(u8, &str); 3] =
    [(SETTLES, "settles to steady sliding"), (VIBRATES, "keeps vibrating"), (OPEN, "undecided")];
const SETTLES: u8 = 0;
const VIBRATES: u8 = 1;
const OPEN: u8 = 2;

/// The share of the duration from which on energies are compared.
const FROM: f64 = 0.6;
/// What of the energy of the first half of them is left in the second at most where a motion settles, and of its energy at first at most where it has settled.
const KEEPS: f64 = 0.95;
const GONE: f64 = 1e-6;
/// The share of the rate of small motions at which the energy of one that keeps vibrating may fall.
const SLOWER: f64 = 0.1;
/// By what power of e the energy of small motions falls over all windows at least, where a motion is told from them.
const LONG: f64 = 1.0;
/// Steps between two questions whether to go on.
const PATIENCE: u64 = 100;

/// A knock and what became of it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
struct KnockedMotion {
    sample: usize,
    /// In N s.
    impulse: f64,
    fate: u8,
    /// The mean energy about steady sliding in the last window, in J.
    energy: f64,
    /// Whether every step was solved.
    is_solved: bool,
}

/// All knocks.
pub(super) struct SampledKnocks {
    motions: Vec<KnockedMotion>,
}

/// What is told of them.
#[derive(Clone, Results)]
pub(super) struct ToldKnocks {
    /// the observed point and direction
    at: String,
    /// between which sizes impulses were drawn, evenly and of either sign, in N s
    impulse: [f64; 2],
    samples: usize,
    seed: u64,
    /// how long each motion is
    duration_s: f64,
    /// knocks that settle to steady sliding
    settle: usize,
    /// knocks that keep vibrating
    vibrate: usize,
    /// those of which it is not clear after the duration
    undecided: usize,
    /// the share of those that keep vibrating among those that are decided
    share: Option<f64>,
    /// its 95 % interval; what is undecided may be either
    interval: [f64; 2],
    /// the smallest impulse that keeps vibrating, in N s
    smallest_that_vibrates: Option<f64>,
    /// the largest that settles, in N s
    largest_that_settles: Option<f64>,
}

/// What is known of small motions about steady sliding.
#[derive(Debug, Clone, Copy)]
pub(super) struct KnownSmallMotions {
    /// Whether some of the band grow.
    pub(super) grows: bool,
    /// Whether it is proven that the band has no other modes.
    pub(super) complete: bool,
    /// The least rate at which the energy of one that decays falls, in 1/s; none where none decays.
    pub(super) slowest: Option<f64>,
}

impl KnownSmallMotions {
    /// What the modes of a band say, all of them where that is proven.
    pub(super) fn new(modes: &[ComplexMode], complete: bool) -> Self {
        // what creeps away without swinging grows as well
        let grows = modes.iter().any(|mode| mode.eigenvalue.verdict() == Verdict::Unstable);
        let rates = modes.iter().map(|mode| -2.0 * mode.eigenvalue.value.re).filter(|rate| *rate > 0.0);
        Self { grows, complete, slowest: rates.reduce(f64::min) }
    }
}

/// Marches from every knock; those of an interrupted run are known.
pub(super) fn knocked(
    of: &AssemblySubject<'_>,
    asked: &Knocks,
    steady: &SteadySliding,
    small: KnownSmallMotions,
    (kept, progress): (KeptLines<'_>, &dyn Progress),
) -> Result<SampledKnocks, ModelError> {
    let watched = of.built.watched.iter().find(|own| own.name == asked.at);
    let unknown = || ModelError::Unsupported(format!("there is no observed point `{}`", asked.at));
    let unit = knock(of, &watched.ok_or_else(unknown)?.row)?;
    let settings = SchemeWord::Moreau.march(asked.step);
    let mut march = NonsmoothMarch::new(&of.built.assembly, &[], settings)?;
    let largest = steady.points.iter().map(|point| point.normal_force.abs()).fold(0.0, f64::max);
    march.set_force_scale(if largest > 0.0 { largest } else { 1.0 });
    march.start(&steady.displacement, &vec![0.0; steady.displacement.len()]);
    let energy = EnergyAboutSliding::new(&of.built.assembly, steady, &march)?;
    let follower = KnockFollower { asked, steady, unit, energy, small, progress };
    let known: BTreeMap<usize, KnockedMotion> =
        kept.known::<KnockedMotion>().into_iter().map(|motion| (motion.sample, motion)).collect();
    // all of them, so that of several errors the first is told
    let motions: Vec<Result<KnockedMotion, ModelError>> = (0..asked.samples)
        .into_par_iter()
        .map(|sample| match known.get(&sample) {
            Some(motion) => Ok(*motion),
            None => {
                let motion = follower.follow(&mut march.clone(), sample)?;
                kept.add(&motion);
                Ok(motion)
            }
        })
        .collect();
    Ok(SampledKnocks { motions: motions.into_iter().collect::<Result<_, _>>()? })
}

/// The velocities of the freedoms by an impulse of 1 N s along a form, M⁻¹ rᵀ.
fn knock(of: &AssemblySubject<'_>, row: &Row) -> Result<Vec<f64>, ModelError> {
    let mut velocity = vec![0.0; of.built.assembly.size()];
    row.entries().iter().for_each(|(freedom, value)| velocity[*freedom] += value);
    SymmetricFactor::new(&of.built.assembly.mass)?.solve(&mut velocity);
    match velocity.iter().all(|own| own.is_finite()) {
        true => Ok(velocity),
        false => Err(ModelError::Unsupported("what has no mass cannot be knocked".to_owned())),
    }
}

/// What follows the motions after knocks.
struct KnockFollower<'a> {
    asked: &'a Knocks,
    steady: &'a SteadySliding,
    /// Velocities by 1 N s.
    unit: Vec<f64>,
    energy: EnergyAboutSliding,
    small: KnownSmallMotions,
    progress: &'a dyn Progress,
}

impl KnockFollower<'_> {
    /// The impulse of a sample, which depends on the seed and on the sample alone.
    fn impulse(&self, sample: usize) -> f64 {
        let ([from, to], seed) = (self.asked.impulse, self.asked.seed as u64);
        let size = from + (to - from) * uniform(seed, 2 * sample as u64);
        if uniform(seed, 2 * sample as u64 + 1) < 0.5 { -size } else { size }
    }

    fn follow(&self, march: &mut NonsmoothMarch<'_>, sample: usize) -> Result<KnockedMotion, ModelError> {
        let (impulse, points) = (self.impulse(sample), &self.steady.points);
        let velocity: Vec<f64> = self.unit.iter().map(|own| impulse * own).collect();
        march.start(&self.steady.displacement, &velocity);
        let forces: Vec<[f64; 2]> =
            points.iter().map(|point| [point.normal_force, point.friction_force]).collect();
        march.guess(&forces);
        let first = self.energy.of(march);
        let steps = (self.asked.duration / self.asked.step).ceil().max(1.0) as u64;
        let from = (FROM * steps as f64) as u64;
        let mut windows = EnergyWindows::new(steps - from);
        let (mut motion, mut has_changed) = (Vec::new(), false);
        for step in 0..steps {
            if step % PATIENCE == 0 {
                self.progress.go_on()?;
            }
            march.advance()?;
            if step < from {
                continue;
            }
            windows.add(step - from, self.energy.of(march));
            let now = (0..points.len()).map(|point| march.motion(point));
            if step == from {
                motion = now.collect();
            } else {
                has_changed |= now.zip(&motion).any(|(now, before)| now != *before);
            }
        }
        let is_solved = march.record().unsolved == 0;
        let fate =
            if is_solved { self.small.fate(first, &windows, self.asked.step, has_changed) } else { OPEN };
        let [_, last] = windows.halves();
        Ok(KnockedMotion { sample, impulse, fate, energy: last, is_solved })
    }
}

impl KnownSmallMotions {
    /// What becomes of a motion by its energy at first and at the end, and whether points change what they do there.
    fn fate(self, first: f64, windows: &EnergyWindows, step: f64, has_changed: bool) -> u8 {
        let [earlier, last] = windows.halves();
        if !(earlier.is_finite() && last.is_finite()) {
            return OPEN;
        }
        let decays = self.complete && !self.grows;
        let keeps = || match (self.slowest, windows.fastest_fall()) {
            _ if self.grows => last >= KEEPS * earlier,
            (Some(rate), Some(fall)) => {
                let is_long = rate * step * windows.steps() as f64 >= LONG;
                is_long && has_changed && fall / step <= SLOWER * rate
            }
            _ => false,
        };
        match decays {
            // nothing of the kind comes back
            true if last <= GONE * first => SETTLES,
            // small motions decay as their modes do
            true if !has_changed && last < KEEPS * earlier => SETTLES,
            _ if keeps() => VIBRATES,
            _ => OPEN,
        }
    }
}

impl SampledKnocks {
    fn count(&self, fate: u8) -> usize {
        self.motions.iter().filter(|own| own.fate == fate).count()
    }

    /// Knocks of which not every step was solved.
    pub(super) fn unsolved(&self) -> usize {
        self.motions.iter().filter(|own| !own.is_solved).count()
    }

    pub(super) fn told(&self, asked: &Knocks) -> ToldKnocks {
        let [settle, vibrate, undecided] = [SETTLES, VIBRATES, OPEN].map(|fate| self.count(fate));
        let sizes =
            |fate: u8| self.motions.iter().filter(move |own| own.fate == fate).map(|own| own.impulse.abs());
        let decided = settle + vibrate;
        ToldKnocks {
            at: asked.at.clone(),
            impulse: asked.impulse,
            samples: asked.samples,
            seed: asked.seed as u64,
            duration_s: asked.duration,
            settle,
            vibrate,
            undecided,
            share: (decided > 0).then(|| vibrate as f64 / decided as f64),
            interval: [wilson(vibrate, asked.samples)[0], wilson(vibrate + undecided, asked.samples)[1]],
            smallest_that_vibrates: sizes(VIBRATES).reduce(f64::min),
            largest_that_settles: sizes(SETTLES).reduce(f64::max),
        }
    }

    /// Whether some keep vibrating.
    pub(super) fn vibrates(&self) -> bool {
        self.count(VIBRATES) > 0
    }

    /// What is to be said of them.
    pub(super) fn warning(&self) -> Option<String> {
        let (undecided, all) = (self.count(OPEN), self.motions.len());
        (undecided > 0).then(|| {
            format!("what becomes of {undecided} of {all} knocks is not clear: they need a longer duration, steps that are all solved, and a band that is proven to have no other modes")
        })
    }

    /// Impulses, fates, energies.
    pub(super) fn variables(&self, dataset: Dataset) -> Result<Dataset, ModelError> {
        let along = |name: &str, of: fn(&KnockedMotion) -> f64| {
            let values: Vec<f64> = self.motions.iter().map(of).collect();
            Variable::new(name, &["knock"], &[values.len()], values)
        };
        let fates: Vec<u8> = self.motions.iter().map(|own| own.fate).collect();
        let impulse = along("impulse", |own| own.impulse).units("N s").long_name("impulse of the knock");
        let energy = along("knock_energy", |own| own.energy)
            .units("J")
            .long_name("mean energy about steady sliding in the last fifth of the motion after the knock");
        Ok(dataset
            .with(impulse.attribute("label", "Impulse of the knock (N s)"))?
            .with(energy.attribute("label", "Energy at the end (J)"))?
            .with(
                Variable::classes("knock_fate", &["knock"], &[fates.len()], fates, &FATES)
                    .long_name("what becomes of the knock"),
            )?)
    }
}
