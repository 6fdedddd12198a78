//! The mode that is meant, its cycle, what is to be said of it.

use super::arrays::dataset;
use super::checks::{INSTANTS, checks};
use super::contributions::with_contributions;
use super::search::{CycleOfMode, differentiated};
use super::settings::{CycleMethod, LOWEST, ModeCycle, USUAL_STEPS};
use super::stability::KnownStability;
use super::told::{ToldCycleMode, ToldModeCycle, scalars};
use crate::assembly::AssemblySubject;
use crate::assembly::meant_mode::{fastest, near_frequency};
use crate::assembly::periodic::components;
use crate::error::ModelError;
use crate::measured_growth::far_off;
use crate::sliding::march::sound::{AUDIO_RATE, SoundFile, sound_of};
use judder_assembly::linearised::{Linearised, LinearisedTerms};
use judder_assembly::steady::SteadySliding;
use judder_cycles::CyclesError;
use judder_cycles::contributions::ModeContributions;
use judder_cycles::cycle::AssemblyCycle;
use judder_cycles::shooting::{ShootingSettings, ShotCycle, shoot};
use judder_cycles::stability::{FloquetMultipliers, HILL_ROWS, shot_multipliers};
use judder_structure::complex_modes::{ComplexMode, Verdict};
use judder_study::Progress;
use judder_study::outcome::{CheckRecord, Outcome};
use std::f64::consts::TAU;

/// How long a cycle is heard, in s, and up to which share of the rate of the samples.
const HEARD: (f64, f64) = (1.0, 0.45);

pub(super) fn run(
    of: &AssemblySubject<'_>,
    asked: &ModeCycle,
    progress: &dyn Progress,
) -> Result<Outcome, ModelError> {
    let steady = of.steady_to_march()?;
    let mut outcome = Outcome { warnings: of.doubts(&steady), ..Outcome::default() };
    let sought = sought(of, asked, &steady, &mut outcome.warnings, progress)?;
    let mut mode = ToldCycleMode::new(asked, &sought);
    let cycle = match sought.cycle() {
        None => {
            outcome.dataset = dataset(of, &sought, None)?;
            outcome.missing = 1;
            outcome.warnings.extend(sought.reason().map(|reason| format!("no limit cycle: {reason}")));
            None
        }
        Some(cycle) => {
            let known = (&steady, &sought, cycle);
            Some(told(of, asked, known, (&mut outcome, &mut mode), progress)?)
        }
    };
    outcome.scalars = scalars(&mode, cycle.as_ref());
    Ok(outcome)
}

/// What is told of a cycle; what else there is of it goes to the outcome and to what is told of its mode.
fn told(
    of: &AssemblySubject<'_>,
    asked: &ModeCycle,
    (steady, sought, cycle): (&SteadySliding, &CycleOfMode<'_>, &AssemblyCycle<'_>),
    (outcome, mode): (&mut Outcome, &mut ToldCycleMode),
    progress: &dyn Progress,
) -> Result<ToldModeCycle, ModelError> {
    let stability = KnownStability::of(&cycle.balance, &cycle.motion, asked.solver.stability, progress)?
        .and_by_hill(&cycle.balance, &cycle.motion, HILL_ROWS, progress)?;
    outcome.dataset = dataset(of, sought, Some(&stability))?;
    let unconverged = sought.unconverged();
    outcome.missing = usize::from(unconverged.is_some());
    let words = unconverged.into_iter().chain(words_of(sought, cycle)).chain(stability.doubt());
    outcome.warnings.extend(words);
    progress.go_on()?;
    let about = Linearised::new(&of.built.assembly, steady, LinearisedTerms::default())?;
    let made_of = match ModeContributions::of(cycle, &about, sought.eigenvalue.im)? {
        Ok(made_of) => {
            outcome.dataset = with_contributions(std::mem::take(&mut outcome.dataset), &made_of)?;
            Some(made_of)
        }
        Err(error) => {
            outcome.missing += 1;
            outcome.warnings.push(format!("of which modes the cycle is made up is not known: {error}"));
            None
        }
    };
    let power = cycle.power(INSTANTS)?;
    let (harmonics, points) = (cycle.balance.series().harmonics(), cycle.points.len());
    let which = format!("{harmonics} harmonics, {points} points");
    outcome.checks = checks(&which, cycle.motion.residual.into(), power.imbalance().into());
    let shot = match shot(of, asked, cycle, progress)? {
        Some(Ok(shot)) => {
            outcome.checks.push(comes_back(cycle, &shot.0));
            Some(shot)
        }
        Some(Err(reason)) => {
            outcome.missing += 1;
            mode.not_by_the_march(&reason);
            outcome.warnings.push(format!("{reason}; what is told is the cycle by harmonics"));
            None
        }
        None => None,
    };
    let sounds = sounds(of, cycle)?;
    let (heard, files): (Vec<_>, Vec<_>) =
        sounds.into_iter().map(|own| (own.told, (own.name, own.bytes))).unzip();
    outcome.files = files;
    let known = (&power, &stability, made_of.as_ref());
    ToldModeCycle::new(of, sought, cycle, known, heard, shot.as_ref())
}

/// The cycle along the motions of the mode that is meant, or where it is to be sought in place of that.
fn sought<'a>(
    of: &AssemblySubject<'a>,
    asked: &ModeCycle,
    steady: &SteadySliding,
    warnings: &mut Vec<String>,
    progress: &dyn Progress,
) -> Result<CycleOfMode<'a>, ModelError> {
    let settings = asked.solver.settings(components(of)?);
    let built = of.built;
    if let Some(start) = &asked.start {
        let found = start.cycle(of, steady, &settings, progress)?;
        let about = Linearised::new(&built.assembly, steady, LinearisedTerms::default())?;
        let beside = found.as_ref().ok().map(|cycle| near_frequency(&about, cycle.frequency()));
        let mode = match beside {
            Some(Ok(mode)) => mode,
            _ => fastest(&about, LOWEST)?.0,
        };
        return Ok(CycleOfMode::near(mode.eigenvalue.value, found, &settings));
    }
    let mode = mode(of, asked, steady, warnings)?;
    if mode.eigenvalue.verdict() == Verdict::Marginal {
        warnings.push(
            "the mode neither grows nor decays within its error: as long as the contact does not change its state all motions of it are periodic, and what is told is one of them".to_owned(),
        );
    }
    progress.go_on()?;
    CycleOfMode::new(&built.assembly, steady, mode.eigenvalue.value, &settings, progress)
}

/// The mode that is meant.
fn mode(
    of: &AssemblySubject<'_>,
    asked: &ModeCycle,
    steady: &SteadySliding,
    warnings: &mut Vec<String>,
) -> Result<ComplexMode, ModelError> {
    let about = Linearised::new(&of.built.assembly, steady, LinearisedTerms::default())?;
    if let Some(frequency) = asked.frequency {
        let mode = near_frequency(&about, frequency)?;
        warnings.extend(far_off(mode.eigenvalue.value.im, frequency));
        return Ok(mode);
    }
    let (mode, highest) = fastest(&about, asked.modes.unwrap_or(LOWEST))?;
    if mode.eigenvalue.verdict() == Verdict::Stable {
        warnings.push(format!(
            "no mode up to {:.1} Hz grows: meant is the one that decays most slowly, and a cycle of it is a knock of its shape that suffices",
            highest / TAU,
        ));
    }
    Ok(mode)
}

/// That motions of its shape leave a cycle.
fn words_of(sought: &CycleOfMode<'_>, cycle: &AssemblyCycle<'_>) -> Option<String> {
    let knock = "motions of its shape leave it on both sides: smaller ones decay, larger ones grow";
    let turned = "motions of its shape leave it although small ones grow: they grow to another motion";
    let words = if sought.eigenvalue.re > 0.0 { turned } else { knock };
    (cycle.attracts == Some(false)).then(|| words.to_owned())
}

/// A cycle by a march, with its multipliers where they were asked for and are told by it.
type ShotWithMultipliers = (ShotCycle, Option<FloquetMultipliers>);

/// The same cycle by a march that comes back, where it is asked for; in words why there is none.
fn shot(
    of: &AssemblySubject<'_>,
    asked: &ModeCycle,
    cycle: &AssemblyCycle<'_>,
    progress: &dyn Progress,
) -> Result<Option<Result<ShotWithMultipliers, String>>, ModelError> {
    if asked.method != CycleMethod::Shooting {
        return Ok(None);
    }
    progress.go_on()?;
    let settings =
        ShootingSettings { steps: asked.steps.unwrap_or(USUAL_STEPS), ..ShootingSettings::default() };
    let (assembly, go_on) = (&of.built.assembly, &|| !progress.interrupted());
    let near = (&cycle.balance, &cycle.motion);
    match shoot(assembly, near.0, near.1, &settings, go_on) {
        Ok(shot) => {
            let multipliers = match asked.solver.stability {
                true => shot_multipliers(assembly, near, (&shot, &settings), go_on)?,
                false => None,
            };
            Ok(Some(Ok((shot, multipliers))))
        }
        Err(error @ (CyclesError::NotReturned { .. } | CyclesError::Singular)) => {
            Ok(Some(Err(error.to_string())))
        }
        Err(error) => Err(error.into()),
    }
}

/// The two ways share neither unknowns nor the treatment of the contact.
fn comes_back(cycle: &AssemblyCycle<'_>, shot: &ShotCycle) -> CheckRecord {
    /// What frequencies may differ, of themselves.
    const AGREE: f64 = 1e-3;
    CheckRecord::new(
        "a march comes back with the period that harmonics have",
        format!("frequencies, {} steps of a period, of themselves", shot.statistics.steps()),
        (shot.frequency / cycle.frequency() - 1.0).abs().into(),
        AGREE,
    )
}

/// The accelerations of the observed points as sound; none of which no harmonic can be heard.
fn sounds(of: &AssemblySubject<'_>, cycle: &AssemblyCycle<'_>) -> Result<Vec<SoundFile>, ModelError> {
    let rate = f64::from(AUDIO_RATE);
    let audible = (TAU * HEARD.1 * rate / cycle.frequency()).floor() as usize;
    if audible == 0 {
        return Ok(Vec::new());
    }
    let of_row = |own: &crate::assembly::build::WatchedRow| {
        let acceleration = differentiated(cycle, &cycle.followed(&own.row)?, 2);
        let at = |sample: usize| {
            let tau = cycle.frequency() * sample as f64 / rate;
            let harmonics = acceleration.chunks_exact(2).take(audible).zip(1..);
            harmonics
                .map(|(own, h)| {
                    own[0] * libm::cos(f64::from(h) * tau) + own[1] * libm::sin(f64::from(h) * tau)
                })
                .sum()
        };
        let values: Vec<f64> = (0..(HEARD.0 * rate) as usize).map(at).collect();
        sound_of(of.name, &own.name, "m/s^2", values, rate)
    };
    of.built.watched.iter().map(of_row).collect()
}
