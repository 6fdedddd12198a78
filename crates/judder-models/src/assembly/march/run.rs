//! The motion.

use super::arrays::dataset;
use super::content::SoughtContent;
use super::driven::{MotionDrive, with_drive};
use super::recorded::{Recorded, Signals};
use super::settings::AssemblyMarch;
use super::start::MotionState;
use crate::assembly::AssemblySubject;
use crate::assembly::build::WatchedRow;
use crate::error::ModelError;
use crate::sliding::march::sound::{SoundFile, sound_of};
use judder_assembly::row::Row;
use judder_assembly::steady::SteadySliding;
use judder_nonsmooth::march::{NonsmoothMarch, Works};
use judder_nonsmooth::statistics::Statistics;
use judder_study::Progress;
use judder_study::outcome::Outcome;
use std::time::{Duration, Instant};

/// Steps between two that progress is told of.
const LOOK: u64 = 2000;
/// How long it takes until a run hears that it shall stop, at most, but for a step.
const PATIENCE: Duration = Duration::from_millis(100);

/// A motion that has run.
pub(super) struct RunMotion<'a> {
    pub(super) march: NonsmoothMarch<'a>,
    pub(super) statistics: Statistics,
    recorded: Recorded,
    /// Works when the transient was over, in J.
    pub(super) settled: Works,
    /// The energy at the start, in J.
    pub(super) first_energy: f64,
    pub(super) seconds: f64,
    /// The modes in it, or why they are not known.
    pub(super) content: Result<SoughtContent, ModelError>,
}

/// Marches, and tells.
pub(super) fn run(
    of: &AssemblySubject<'_>,
    asked: &AssemblyMarch,
    progress: &dyn Progress,
) -> Result<Outcome, ModelError> {
    let drive = MotionDrive::new(of, asked)?;
    let steady = of.steady_to_march()?;
    let first = match drive.course.starts_as_given() {
        true => None,
        false => Some(of.steady_at_first(&drive.course)?),
    };
    let begins = Begins { steady: &steady, first: first.as_ref().unwrap_or(&steady) };
    let mut marched = march(of, asked, progress, begins, &drive)?;
    let signals = marched.recorded.signals();
    let sounds = sounds(of, &signals)?;
    let (heard, files): (Vec<_>, Vec<_>) =
        sounds.into_iter().map(|own| (own.told, (own.name, own.bytes))).unzip();
    let told = marched.told(of, asked, &signals, heard);
    let frequency = told.frequency_hz;
    let Outcome { scalars, .. } = Outcome::of(&told)?;
    let times = if drive.is_none() { Vec::new() } else { signals.time.clone() };
    let dataset = with_drive(dataset(of, asked, &marched.recorded, signals)?, &drive, &times)?;
    Ok(Outcome {
        scalars,
        dataset: match frequency {
            Some(frequency) => dataset.attribute("frequency_hz", frequency)?,
            None => dataset,
        },
        checks: marched.checks(asked),
        missing: usize::from(marched.march.record().unsolved > 0),
        warnings: [
            of.doubts(&steady),
            drive.warnings(of, asked),
            marched.warnings(!of.built.travelling.is_empty()),
        ]
        .concat(),
        files,
        ..Outcome::default()
    })
}

/// The accelerations of the observed points as sound.
fn sounds(of: &AssemblySubject<'_>, signals: &Signals) -> Result<Vec<SoundFile>, ModelError> {
    let first = signals.columns.len() - 2 * of.built.watched.len();
    let sound = |(k, own): (usize, &WatchedRow)| {
        sound_of(of.name, &own.name, "m/s^2", signals.columns[first + 2 * k].clone(), signals.rate)
    };
    of.built.watched.iter().enumerate().map(sound).collect()
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

fn march<'a>(
    of: &AssemblySubject<'a>,
    asked: &AssemblyMarch,
    progress: &dyn Progress,
    Begins { steady, first }: Begins<'_>,
    drive: &MotionDrive,
) -> Result<RunMotion<'a>, ModelError> {
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
    let mut content = SoughtContent::new(of, steady, &march, asked.modes);
    let [steps, transient] = asked.steps();
    let mut recorded = Recorded::new(&march, &points_of(of), watched.len(), asked.sample_rate.0)?;
    let mut statistics = Statistics::new(steady.points.len());
    let energy = march.energy();
    let first_energy = energy.kinetic + energy.potential;
    let mut settled = march.works();
    progress.expect((steps / LOOK) as usize);
    let start = Instant::now();
    let mut looked = start;
    for taken in 1..=steps {
        march.advance()?;
        recorded.take(&march);
        if taken > transient {
            statistics.take(&march);
            if let Ok(content) = &mut content {
                content.take(&march, taken);
            }
        } else if taken == transient {
            settled = march.works();
        }
        if taken.is_multiple_of(LOOK) {
            progress.advance();
        }
        if looked.elapsed() >= PATIENCE {
            progress.go_on()?;
            looked = Instant::now();
        }
    }
    let seconds = start.elapsed().as_secs_f64();
    Ok(RunMotion { march, statistics, recorded, settled, first_energy, seconds, content })
}
