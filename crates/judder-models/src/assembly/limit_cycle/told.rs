//! What is told of a cycle.

use super::contributions::ToldContribution;
use super::search::{CycleOfMode, acceleration_mean_square};
use super::settings::ModeCycle;
use super::stability::{KnownStability, with_phase};
use crate::assembly::AssemblySubject;
use crate::assembly::march::levels::level;
use crate::error::ModelError;
use crate::sliding::march::sound::ToldSound;
use judder_cycles::contributions::ModeContributions;
use judder_cycles::cycle::{AssemblyCycle, PointCycle};
use judder_cycles::power::CyclePower;
use judder_cycles::shooting::ShotCycle;
use judder_cycles::stability::FloquetMultipliers;
use judder_store::{ByName, Complex64, Declared, Results};
use serde_json::{Map, Value};
use std::f64::consts::TAU;

/// What is told of the mode.
#[derive(Results)]
pub(super) struct ToldCycleMode {
    /// how the cycle is computed
    method: &'static str,
    /// whether a cycle was found by the method that was asked for, and its harmonics leave no more of the swing of the contact forces out than `left_out` allows, or a tenth where their number is given
    converged: bool,
    /// why it is not
    #[result(optional)]
    reason: Option<String>,
    /// frequency of the mode about steady sliding, in Hz
    mode_frequency_hz: f64,
    /// its growth rate there
    #[result(unit = "1/s")]
    mode_growth_rate: f64,
    /// periodic motions of the mode that were followed
    motions: usize,
}

/// What is told of the cycle of the mode, where there is one.
#[derive(Results)]
pub(super) struct ToldModeCycle {
    /// its frequency, in Hz
    frequency_hz: f64,
    /// by how much it lies above that of the mode, over that
    #[result(unit = "1")]
    frequency_shift: f64,
    /// its amplitude over that at which the contact first changes its state; unknown where no motions of a mode were followed
    #[result(unit = "1")]
    amplitude: Option<f64>,
    /// whether motions of this shape nearby are drawn to it; where not, it is a knock of this shape that suffices; unknown where no motions of a mode were followed
    attracts: Option<bool>,
    /// whether all motions nearby are, where that is known
    stable: Option<bool>,
    /// the same in words, or why it is not known
    stability: String,
    /// what motions nearby become, as far as multipliers tell: periodic, or unknown with what it may be
    motion: &'static str,
    /// the ten largest Floquet multipliers, the one at 1 that belongs to the phase among them
    #[result(unit = "1")]
    floquet_multipliers: Option<Vec<Complex64>>,
    /// what the largest but that one may be off
    #[result(unit = "1")]
    floquet_error: Option<f64>,
    /// the same multipliers by Hill's method, where it applies
    #[result(unit = "1")]
    hill_multipliers: Option<Vec<Complex64>>,
    /// what the largest of them but the one at 1 may be off
    #[result(unit = "1")]
    hill_error: Option<f64>,
    /// how far the largest by steps and by Hill's method lie from the nearest of the other
    #[result(unit = "1")]
    multipliers_apart: Option<f64>,
    /// whether Hill's method says the same of the stability, or why steps alone say it
    second_opinion: String,
    /// harmonics that it has
    harmonics: usize,
    /// instants of a period at which points stick, slide or lift off
    samples: usize,
    /// what is left of its equations, over the largest normal force of steady sliding
    #[result(unit = "1")]
    residual: f64,
    /// the share of the swing of the contact forces that lies beyond the harmonics, as a root of energies
    #[result(unit = "1")]
    left_out: f64,
    /// the largest difference of a force from its contact law between and at the instants, over the largest normal force of steady sliding
    #[result(unit = "1")]
    between_samples: f64,
    /// why it has no more harmonics, where it should
    #[result(optional)]
    held_back: Option<String>,
    /// the velocity of the slider beside the track along the slip about its mean, as root mean square, in m/s, by contact, a list over its points
    #[result(unit = "m/s")]
    tangential_velocity_rms: ByName<Vec<f64>>,
    /// all normal forces together, on average
    #[result(unit = "N")]
    normal_force_mean: f64,
    /// the friction on the sliders along the slip, on average
    #[result(unit = "N")]
    friction_force_mean: f64,
    /// what goes into the bodies, on average, in W
    power: ToldCyclePower,
    /// what is left of the balance of energy over a period, over what contacts and bodies exchange to and fro
    #[result(unit = "1")]
    energy_balance: f64,
    /// each contact
    contacts: ByName<ContactInCycle>,
    /// the modes of frictionless contact with the largest shares in the kinetic energy of its swing, up to 20, by rising frequency
    mode_contributions: Option<Vec<ToldContribution>>,
    /// the share that they have not
    #[result(unit = "1")]
    contributions_left_over: Option<f64>,
    /// accelerations of the observed points
    levels: ByName<CycleLevel>,
    /// accelerations of the observed points as sound, as far as it can be heard
    sound: Vec<ToldSound>,
    /// the cycle by a march that comes back
    #[result(optional)]
    shooting: Option<ToldShooting>,
}

/// The cycle by a march that comes back.
#[derive(Results)]
pub(super) struct ToldShooting {
    /// its frequency, in Hz
    frequency_hz: f64,
    /// that by harmonics
    harmonics_frequency_hz: f64,
    /// what a period misses, of the swing of the state
    #[result(unit = "1")]
    residual: f64,
    /// steps of Newton's method
    iterations: usize,
    /// steps of a period
    steps: usize,
    /// the ten largest Floquet multipliers along it, the one at 1 that belongs to the phase among them, without the error of the steps that half and a quarter of these tell; unknown where that does not apply
    #[result(unit = "1")]
    floquet_multipliers: Option<Vec<Complex64>>,
    /// what the largest but that one may be off
    #[result(unit = "1")]
    floquet_error: Option<f64>,
}

/// What its points do over a period, by the march.
pub(super) fn shot_points(shot: &ShotCycle, points: usize) -> Vec<PointCycle> {
    let of = |point: usize| {
        let told = shot.statistics.of(point)?;
        Some(PointCycle {
            shares: [told.stick_share, told.slip_share, told.open_share],
            normal_force: told.normal_force_mean,
            friction_force: told.friction_force_mean,
            tangential_velocity_rms: told.tangential_velocity_rms,
        })
    };
    (0..points).map(|point| of(point).unwrap_or_default()).collect()
}

/// What goes into the bodies.
#[derive(Results)]
struct ToldCyclePower {
    /// from the friction forces
    #[result(unit = "W")]
    friction: f64,
    /// taken by the damping
    #[result(unit = "W")]
    damping: f64,
    /// from normal forces: none but of what harmonics leave out
    #[result(unit = "W")]
    impacts: f64,
    /// from the track's drive: of friction, with what becomes heat
    #[result(unit = "W")]
    drive: f64,
    /// what becomes heat where bodies slide
    #[result(unit = "W")]
    heat: f64,
    /// what contacts and bodies exchange to and fro
    #[result(unit = "W")]
    exchanged: f64,
    /// from stiffness that is not symmetric
    #[result(unit = "W", optional)]
    circulation: Option<f64>,
}

/// The points of a contact, as lists.
#[derive(Results)]
struct ContactInCycle {
    /// where each lies along x, in m
    x_m: Vec<f64>,
    /// the share of the period in which it sticks
    stick_share: Vec<f64>,
    /// in which it slides
    slip_share: Vec<f64>,
    /// in which it has lifted off
    open_share: Vec<f64>,
    /// the velocity of the slider beside the track along the slip about its mean, as root mean square
    #[result(unit = "m/s")]
    tangential_velocity_rms: Vec<f64>,
    /// its normal force, on average
    #[result(unit = "N")]
    normal_force_mean: Vec<f64>,
    /// the friction on it along the slip, on average
    #[result(unit = "N")]
    friction_force_mean: Vec<f64>,
}

/// How loud an observed point is along a direction.
#[derive(Results)]
struct CycleLevel {
    /// its acceleration, as root mean square
    #[result(unit = "m/s²")]
    acceleration_rms: f64,
    /// the same in dB re 1 µm/s²; none where it rests
    level_db: Option<f64>,
}

/// Multipliers that the summary has.
const LARGEST: usize = 10;

/// The keys of the summary.
pub(super) fn summary_keys() -> Vec<Declared> {
    [ToldCycleMode::declared(), ToldModeCycle::declared()].concat()
}

/// The summary: without a cycle what it would be told of is `null`.
pub(super) fn scalars(mode: &ToldCycleMode, cycle: Option<&ToldModeCycle>) -> Map<String, Value> {
    let mut scalars = mode.scalars();
    match cycle {
        Some(cycle) => scalars.extend(cycle.scalars()),
        None => {
            let keys = ToldModeCycle::declared().into_iter().filter(|own| !own.is_optional);
            scalars.extend(keys.map(|own| (own.name, Value::Null)));
        }
    }
    scalars
}

impl ToldCycleMode {
    /// The march did not come back.
    pub(super) fn not_by_the_march(&mut self, reason: &str) {
        self.converged = false;
        let before = self.reason.take().map_or_else(String::new, |own| format!("{own}; "));
        self.reason = Some(format!("{before}{reason}"));
    }

    pub(super) fn new(asked: &ModeCycle, sought: &CycleOfMode<'_>) -> Self {
        Self {
            method: asked.method.name(),
            converged: sought.cycle().is_some() && sought.unconverged().is_none(),
            reason: sought.reason().or_else(|| sought.unconverged()),
            mode_frequency_hz: sought.eigenvalue.im / TAU,
            mode_growth_rate: sought.eigenvalue.re,
            motions: sought.motions().len(),
        }
    }
}

impl ToldModeCycle {
    pub(super) fn new(
        of: &AssemblySubject<'_>,
        sought: &CycleOfMode<'_>,
        cycle: &AssemblyCycle<'_>,
        (power, stability, made_of): (&CyclePower, &KnownStability, Option<&ModeContributions>),
        sound: Vec<ToldSound>,
        by_the_march: Option<&(ShotCycle, Option<FloquetMultipliers>)>,
    ) -> Result<Self, ModelError> {
        let shot = by_the_march.map(|(shot, _)| shot);
        let points = shot.map_or_else(|| cycle.points.clone(), |shot| shot_points(shot, cycle.points.len()));
        let frequency = shot.map_or_else(|| cycle.frequency(), |shot| shot.frequency);
        let sum = |pick: fn(&PointCycle) -> f64| points.iter().map(pick).sum::<f64>();
        let contacts = contacts(of, &points);
        let rms = contacts.iter().map(|(name, own)| (name.clone(), own.tangential_velocity_rms.clone()));
        Ok(Self {
            frequency_hz: frequency / TAU,
            frequency_shift: frequency / sought.eigenvalue.im - 1.0,
            amplitude: sought.amplitude(),
            attracts: cycle.attracts,
            stable: stability.is_stable(),
            stability: stability.in_full(),
            motion: stability.motion(),
            floquet_multipliers: stability.multipliers().map(|all| all.into_iter().take(LARGEST).collect()),
            floquet_error: stability.error(),
            hill_multipliers: stability.hill_multipliers().map(|all| all.into_iter().take(LARGEST).collect()),
            hill_error: stability.by_hill().map(|own| own.error),
            multipliers_apart: stability.apart(),
            second_opinion: stability.second_opinion(),
            harmonics: cycle.balance.series().harmonics(),
            samples: cycle.balance.series().samples(),
            residual: cycle.motion.residual,
            left_out: cycle.quality.left_out,
            between_samples: cycle.quality.between_samples,
            held_back: sought.held_back(),
            tangential_velocity_rms: rms.collect(),
            normal_force_mean: sum(|own| own.normal_force),
            friction_force_mean: sum(|own| own.friction_force),
            power: ToldCyclePower {
                friction: power.friction,
                damping: power.damping,
                impacts: power.normal,
                drive: power.friction + power.heat,
                heat: power.heat,
                exchanged: power.exchanged,
                circulation: (power.circulation != 0.0).then_some(power.circulation),
            },
            energy_balance: power.imbalance(),
            mode_contributions: made_of.map(|own| own.modes.iter().map(ToldContribution::from).collect()),
            contributions_left_over: made_of.map(|own| own.left_over),
            levels: levels(of, cycle)?.into_iter().collect(),
            contacts: contacts.into_iter().collect(),
            sound,
            shooting: by_the_march.map(|(shot, multipliers)| ToldShooting {
                frequency_hz: shot.frequency / TAU,
                harmonics_frequency_hz: cycle.frequency() / TAU,
                residual: shot.residual,
                iterations: shot.iterations,
                steps: shot.statistics.steps() as usize,
                floquet_multipliers: multipliers
                    .as_ref()
                    .map(|own| with_phase(&own.values, own.phase).into_iter().take(LARGEST).collect()),
                floquet_error: multipliers.as_ref().map(|own| own.error),
            }),
        })
    }
}

fn contacts(of: &AssemblySubject<'_>, points: &[PointCycle]) -> Vec<(String, ContactInCycle)> {
    let mut rest = points;
    let told = of.built.assembly.interfaces.iter().map(|interface| {
        let (own, others) = rest.split_at(interface.points.len().min(rest.len()));
        rest = others;
        let list = |pick: fn(&PointCycle) -> f64| own.iter().map(pick).collect::<Vec<_>>();
        let contact = ContactInCycle {
            x_m: interface.points.iter().map(|point| point.place[0]).collect(),
            stick_share: list(|own| own.shares[0]),
            slip_share: list(|own| own.shares[1]),
            open_share: list(|own| own.shares[2]),
            tangential_velocity_rms: list(|own| own.tangential_velocity_rms),
            normal_force_mean: list(|own| own.normal_force),
            friction_force_mean: list(|own| own.friction_force),
        };
        (interface.name.clone(), contact)
    });
    told.collect()
}

/// The levels of each observed point along each direction.
fn levels(
    of: &AssemblySubject<'_>,
    cycle: &AssemblyCycle<'_>,
) -> Result<Vec<(String, CycleLevel)>, ModelError> {
    let own = of.built.watched.iter().map(|own| {
        let mean_square = acceleration_mean_square(cycle, &own.row)?;
        let level_db = Some(level(mean_square)).filter(|level| level.is_finite());
        Ok((own.name.clone(), CycleLevel { acceleration_rms: mean_square.sqrt(), level_db }))
    });
    own.collect()
}
