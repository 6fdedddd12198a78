//! The basin of steady sliding by knocks: impulses at an observed point, marched until it is clear what becomes of them.

use super::settings::Knocks;
use crate::assembly::AssemblySubject;
use crate::assembly::march::settings::SchemeWord;
use crate::error::ModelError;
use judder_assembly::row::Row;
use judder_assembly::steady::SteadySliding;
use judder_nonsmooth::march::NonsmoothMarch;
use judder_numerics::counter::uniform;
use judder_numerics::share::wilson;
use judder_store::{Dataset, Results, Variable};
use judder_structure::factor::SymmetricFactor;
use judder_study::Progress;
use rayon::prelude::*;

/// What becomes of a knock, by its code, in the order in which they are drawn.
pub(super) const FATES: [(u8, &str); 3] =
    [(SETTLES, "settles to steady sliding"), (VIBRATES, "keeps vibrating"), (OPEN, "undecided")];
const SETTLES: u8 = 0;
const VIBRATES: u8 = 1;
const OPEN: u8 = 2;

/// The shares of the duration between which energies are compared.
const WINDOWS: [f64; 3] = [0.6, 0.8, 1.0];
/// What of the energy of the first window is left in the last at least where a motion keeps vibrating, and of its energy at first at most where it has settled.
const KEEPS: f64 = 0.95;
const GONE: f64 = 1e-6;
/// Steps between two questions whether to go on.
const PATIENCE: u64 = 100;

/// A knock and what became of it.
#[derive(Debug, Clone, Copy, PartialEq)]
struct KnockedMotion {
    /// In N s.
    impulse: f64,
    fate: u8,
    /// The mean kinetic energy in the last window, in J.
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
pub(super) struct KnockedMotions {
    /// Whether some of the band grow.
    pub(super) grows: bool,
    /// Whether it is proven that the band has no other modes.
    pub(super) complete: bool,
}

/// Marches from every knock.
pub(super) fn knocked(
    of: &AssemblySubject<'_>,
    asked: &Knocks,
    steady: &SteadySliding,
    small: KnockedMotions,
    progress: &dyn Progress,
) -> Result<SampledKnocks, ModelError> {
    let watched = of.built.watched.iter().find(|own| own.name == asked.at);
    let unknown = || ModelError::Unsupported(format!("there is no observed point `{}`", asked.at));
    let unit = knock(of, &watched.ok_or_else(unknown)?.row)?;
    let settings = SchemeWord::Moreau.march(asked.step);
    let mut march = NonsmoothMarch::new(&of.built.assembly, &[], settings)?;
    let largest = steady.points.iter().map(|point| point.normal_force.abs()).fold(0.0, f64::max);
    march.set_force_scale(if largest > 0.0 { largest } else { 1.0 });
    // all of them, so that of several errors the first is told
    let motions: Vec<Result<KnockedMotion, ModelError>> = (0..asked.samples)
        .into_par_iter()
        .map(|sample| {
            let [from, to] = asked.impulse;
            let size = from + (to - from) * uniform(asked.seed as u64, 2 * sample as u64);
            let is_back = uniform(asked.seed as u64, 2 * sample as u64 + 1) < 0.5;
            let impulse = if is_back { -size } else { size };
            follow(&mut march.clone(), asked, steady, &unit, (impulse, small), progress)
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

fn follow(
    march: &mut NonsmoothMarch<'_>,
    asked: &Knocks,
    steady: &SteadySliding,
    unit: &[f64],
    (impulse, small): (f64, KnockedMotions),
    progress: &dyn Progress,
) -> Result<KnockedMotion, ModelError> {
    let velocity: Vec<f64> = unit.iter().map(|own| impulse * own).collect();
    march.start(&steady.displacement, &velocity);
    let forces: Vec<[f64; 2]> =
        steady.points.iter().map(|point| [point.normal_force, point.friction_force]).collect();
    march.guess(&forces);
    let first = march.energy().kinetic;
    let steps = (asked.duration / asked.step).ceil().max(1.0) as u64;
    let [from, middle, _] = WINDOWS.map(|share| (share * steps as f64) as u64);
    let (mut sums, mut motion, mut has_changed) = ([0.0; 2], Vec::new(), false);
    for step in 0..steps {
        if step % PATIENCE == 0 {
            progress.go_on()?;
        }
        march.advance()?;
        if step < from {
            continue;
        }
        sums[usize::from(step >= middle)] += march.energy().kinetic;
        let now = (0..steady.points.len()).map(|point| march.motion(point));
        if step == from {
            motion = now.collect();
        } else {
            has_changed |= now.zip(&motion).any(|(now, before)| now != *before);
        }
    }
    let [earlier, last] = [sums[0] / (middle - from).max(1) as f64, sums[1] / (steps - middle).max(1) as f64];
    let is_solved = march.record().unsolved == 0;
    let decays = small.complete && !small.grows;
    let fate = match last >= KEEPS * earlier {
        _ if !(is_solved && earlier.is_finite() && last.is_finite()) => OPEN,
        // nothing of the kind comes back
        _ if last <= GONE * first && decays => SETTLES,
        true if has_changed || small.grows => VIBRATES,
        // small motions decay as their modes do
        false if !has_changed && decays => SETTLES,
        _ => OPEN,
    };
    Ok(KnockedMotion { impulse, fate, energy: last, is_solved })
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
            .long_name("mean kinetic energy in the last fifth of the motion after the knock");
        Ok(dataset
            .with(impulse.attribute("label", "Impulse of the knock (N s)"))?
            .with(energy.attribute("label", "Kinetic energy at the end (J)"))?
            .with(
                Variable::classes("knock_fate", &["knock"], &[fates.len()], fates, &FATES)
                    .long_name("what becomes of the knock"),
            )?)
    }
}
