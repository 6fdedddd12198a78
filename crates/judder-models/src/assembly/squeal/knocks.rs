//! The basin of steady sliding by knocks: impulses at an observed point, marched until it is clear what becomes of them.

use super::settings::Knocks;
use super::small_motions::{FATES, KnownSmallMotions, LateMotion, OPEN, SETTLES, VIBRATES};
use crate::assembly::AssemblySubject;
use crate::assembly::march::settings::SchemeWord;
use crate::error::ModelError;
use judder_assembly::row::Row;
use judder_assembly::steady::SteadySliding;
use judder_nonsmooth::contact_problem::PointMotion;
use judder_nonsmooth::energy::{EnergyAboutSliding, EnergyWindows};
use judder_nonsmooth::march::NonsmoothMarch;
use judder_numerics::counter::uniform;
use judder_numerics::parallel;
use judder_numerics::share::wilson;
use judder_store::{Dataset, Results, Variable};
use judder_structure::factor::SymmetricFactor;
use judder_study::Progress;
use judder_study::kept::{KeptLines, KeptResults};
use serde::{Deserialize, Serialize};

/// The share of the duration from which on energies are compared.
const FROM: f64 = 0.6;
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
    /// between which sizes impulses were drawn, evenly and of either sign
    #[result(unit = "N s")]
    impulse: [f64; 2],
    samples: usize,
    seed: u64,
    /// how long each motion is
    duration_s: f64,
    /// what small motions about steady sliding do, and over which frequencies that is known
    small_motions: String,
    /// knocks that settle to steady sliding
    settle: usize,
    /// knocks that keep vibrating
    vibrate: usize,
    /// those of which it is not clear after the duration
    undecided: usize,
    /// the share of those that keep vibrating among those that are decided
    #[result(unit = "1")]
    share: Option<f64>,
    /// its 95 % interval; what is undecided may be either
    #[result(unit = "1")]
    interval: [f64; 2],
    /// the smallest impulse that keeps vibrating
    #[result(unit = "N s")]
    smallest_that_vibrates: Option<f64>,
    /// the largest that settles
    #[result(unit = "N s")]
    largest_that_settles: Option<f64>,
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
    let sliding = steady.points.iter().map(|point| match point.is_closed {
        true => (PointMotion::Slip, true),
        false => (PointMotion::Open, false),
    });
    let sliding = sliding.collect();
    let follower = KnockFollower { asked, steady, sliding, unit, energy, small, progress };
    let kept = KeptResults::of("knocks", kept);
    let motions = parallel::try_each_place(asked.samples, |sample| {
        kept.at(sample as u64, || follower.follow(&mut march.clone(), sample))
    })?;
    Ok(SampledKnocks { motions })
}

/// Whether the forces of a contact point that is closed in steady sliding bend about it.
pub(super) fn bends(of: &AssemblySubject<'_>, steady: &SteadySliding) -> Result<bool, ModelError> {
    let framed = of.built.assembly.framed()?;
    let closed = framed.iter().zip(&steady.points).filter(|(_, state)| state.is_closed);
    Ok(closed.into_iter().any(|(point, _)| !point.is_linear_in_slip()))
}

/// What every point does, and whether it slides the way it does in steady sliding.
fn done_by_points(march: &NonsmoothMarch<'_>) -> Vec<(PointMotion, bool)> {
    let contact = march.contact();
    let one = |point: usize| {
        let motion = march.motion(point);
        let is_forward = motion == PointMotion::Slip && march.velocity(point)[1] < contact.speed(point);
        (motion, is_forward)
    };
    (0..contact.points.len()).map(one).collect()
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
    /// What the points do in steady sliding.
    sliding: Vec<(PointMotion, bool)>,
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
        let (mut motion, mut changes) = (Vec::new(), false);
        for step in 0..steps {
            if step % PATIENCE == 0 {
                self.progress.go_on()?;
            }
            march.advance()?;
            if step < from {
                continue;
            }
            windows.add(step - from, self.energy.of(march));
            let now = done_by_points(march);
            if step == from {
                motion = now;
            } else {
                changes |= now != motion;
            }
        }
        let is_solved = march.record().unsolved == 0;
        let differs = changes || motion != self.sliding;
        let late = LateMotion { first, windows: &windows, step: self.asked.step, changes, differs };
        let fate = if is_solved { self.small.fate(&late) } else { OPEN };
        let [_, last] = windows.halves();
        Ok(KnockedMotion { sample, impulse, fate, energy: last, is_solved })
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

    pub(super) fn told(&self, asked: &Knocks, small: &KnownSmallMotions) -> ToldKnocks {
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
            small_motions: small.words(),
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
    pub(super) fn warnings(&self, small: &KnownSmallMotions) -> Vec<String> {
        let (undecided, all, unsolved) = (self.count(OPEN), self.motions.len(), self.unsolved());
        let of_unsolved = (unsolved > 0).then(|| format!("{unsolved} have steps that were not solved"));
        let of_others = (undecided > unsolved).then(|| small.remedy());
        let reasons: Vec<String> = of_unsolved.into_iter().chain(of_others).collect();
        let open = (undecided > 0).then(|| {
            format!("what becomes of {undecided} of {all} knocks is not clear: {}", reasons.join("; "))
        });
        open.into_iter().chain(small.doubt()).collect()
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
