//! The motion.

use super::arrays::{growing, rest};
use super::blocks::OngoingMotion;
use super::content::SoughtContent;
use super::driven::{MotionDrive, with_absolute, with_drive};
use super::levels;
use super::recorded::Recorded;
use super::settings::AssemblyMarch;
use super::start::MotionState;
use crate::assembly::AssemblySubject;
use crate::error::ModelError;
use crate::samples::{Finished, Samples};
use crate::sliding::march::sound::{SoundFile, sound_of};
use judder_assembly::row::Row;
use judder_assembly::steady::SteadySliding;
use judder_nonsmooth::march::NonsmoothMarch;
use judder_nonsmooth::statistics::Statistics;
use judder_store::Dataset;
use judder_study::kept::StudyPlace;
use judder_study::model::Task;
use judder_study::outcome::Outcome;

/// Marches, or goes on where an interrupted run was, and tells.
pub(super) fn run(
    of: &AssemblySubject<'_>,
    asked: &AssemblyMarch,
    task: Task<'_>,
) -> Result<Outcome, ModelError> {
    let drive = MotionDrive::new(of, asked)?;
    let steady = of.steady_to_march()?;
    let first = match drive.course.starts_as_given() {
        true => None,
        false => Some(of.steady_at_first(&drive.course)?),
    };
    let begins = Begins { steady: &steady, first: first.as_ref().unwrap_or(&steady) };
    let mut motion = started(of, asked, begins, &drive, task.own.place)?;
    motion.march_on(task.progress)?;
    let sounds = sounds(of, &motion)?;
    let (heard, files): (Vec<_>, Vec<_>) =
        sounds.into_iter().map(|own| (own.told, (own.name, own.bytes))).unzip();
    let levels = motion.levels(of, asked.transient)?;
    let of_octaves = levels::variables(&levels);
    let told = motion.told(of, asked, heard, levels)?;
    let bands = [motion.recorded.rate(), motion.recorded.pass_band()];
    let rest = of_octaves.into_iter().try_fold(rest(of, asked, bands, told.frequency_hz)?, Dataset::with)?;
    let times = if drive.is_none() { Vec::new() } else { motion.samples.values("time")? };
    // a difference of velocities is that amid them
    let lag = 0.5 * asked.step + asked.march().velocities_lag();
    let watched = of.built.watched.iter();
    let observed = watched.map(|own| Ok((own.name.clone(), motion.samples.values(&own.name)?)));
    let rest = with_absolute(with_drive(rest, &drive, &times)?, &drive, &times, lag, observed);
    let mut rest = rest?;
    if let Some(ended) = &motion.ended {
        rest = rest.attribute("ended", ended.reason.clone())?;
    }
    let mut outcome = Outcome {
        checks: motion.checks(asked),
        missing: usize::from(motion.march.record().unsolved > 0) + usize::from(motion.ended.is_some()),
        warnings: [
            of.doubts(&steady),
            drive.warnings(of, asked),
            motion.warnings(asked, !of.built.travelling.is_empty()),
        ]
        .concat(),
        files,
        ..Outcome::of(&told)?
    };
    match motion.samples.finish(rest)? {
        Finished::Stored => outcome.is_stored = true,
        Finished::Whole(dataset) => outcome.dataset = *dataset,
    }
    Ok(outcome)
}

/// The accelerations of the observed points as sound.
fn sounds(of: &AssemblySubject<'_>, motion: &OngoingMotion<'_, '_>) -> Result<Vec<SoundFile>, ModelError> {
    let rate = motion.recorded.rate();
    let watched = of.built.watched.iter();
    watched
        .map(|own| sound_of(of.name, &own.name, "m/s^2", motion.samples.values(&own.name)?, rate))
        .collect()
}

/// Contact points of each contact.
fn points_of(of: &AssemblySubject<'_>) -> Vec<usize> {
    of.built.assembly.interfaces.iter().map(|interface| interface.points.len()).collect()
}

/// What a motion begins with.
#[derive(Clone, Copy)]
struct Begins<'a> {
    /// Steady sliding with the case's own values,
    steady: &'a SteadySliding,
    /// and with those that the course starts with.
    first: &'a SteadySliding,
}

/// A motion before its first step.
fn started<'a, 'b>(
    of: &AssemblySubject<'a>,
    asked: &AssemblyMarch,
    Begins { steady, first }: Begins<'_>,
    drive: &MotionDrive,
    place: Option<StudyPlace<'b>>,
) -> Result<OngoingMotion<'a, 'b>, ModelError> {
    let lag = asked.march().velocities_lag();
    let state = MotionState::new(of, [steady, first], asked.start.as_ref(), lag)?;
    let watched: Vec<Row> = of.built.watched.iter().map(|own| own.row.clone()).collect();
    let mut march =
        NonsmoothMarch::travelling(&of.built.assembly, &of.built.travelling, &watched, asked.march())?;
    let forces = [steady, first].into_iter().flat_map(|own| &own.points);
    let largest = forces.map(|point| point.normal_force.abs()).fold(0.0, f64::max);
    march.set_force_scale(if largest > 0.0 { largest } else { 1.0 });
    if !drive.is_none() {
        march.follow(drive.course.clone(), &drive.excitations)?;
    }
    march.start(&state.displacement, &state.velocity);
    let guess: Vec<[f64; 2]> =
        first.points.iter().map(|point| [point.normal_force, point.friction_force]).collect();
    march.guess(&guess);
    let energy = march.energy();
    Ok(OngoingMotion {
        content: SoughtContent::new(of, steady, &march, asked.modes),
        recorded: Recorded::new(&march, &points_of(of), watched.len(), asked.sample_rate.0)?,
        statistics: Statistics::new(steady.points.len()),
        settled: march.works(),
        first_energy: energy.kinetic + energy.potential,
        seconds: 0.0,
        ended: None,
        steps: asked.steps(),
        block: asked.block(),
        march,
        // of what cannot start nothing stays
        samples: Samples::open(place, growing(of))?,
    })
}
