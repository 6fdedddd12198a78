//! `bifurcation`: what motions settle to along one key, up and down.

use super::branches::{self, ToldBranches};
use super::diagram::{SweptDiagram, ToldDiagram};
use super::point::{SettledPoint, Settling};
use crate::error::ModelError;
use crate::motion::becomes::CYCLE;
use crate::motion::bifurcation::SweepDirection;
use crate::motion::doubts;
use crate::motion::model::Moving;
use crate::motion::settings::{Following, MotionStart};
use crate::sweep::Sweep;
use judder_keys::numeric_key::Value as CaseValue;
use judder_numerics::parallel;
use judder_numerics::piecewise::MarchError;
use judder_oscillator::cycle::settle_confirmed;
use judder_oscillator::motion::attractor::Patience;
use judder_store::{Declared, Results};
use judder_study::Progress;
use judder_study::kept::{KeptLines, KeptResults};
use judder_study::outcome::{CheckRecord, Outcome};

/// What is asked.
pub(crate) struct DiagramSettings<'a, K> {
    pub(crate) sweep: &'a Sweep<K>,
    pub(crate) start: &'a MotionStart,
    pub(crate) following: &'a Following,
    pub(crate) transient: CaseValue,
    /// Whether the branches of cycles are followed as well.
    pub(crate) branches: bool,
}

/// Motions of a sweep that are followed again, more exactly.
const REPEATED: usize = 8;
/// By how much more exactly.
const FINER: f64 = 1e-2;
/// What the rms of a cycle may change by then, relative.
const RMS_LIMIT: f64 = 1e-3;

pub(crate) fn run<M: Moving<N>, const N: usize>(
    model: &M,
    settings: &DiagramSettings<'_, M::Key>,
    direction: SweepDirection,
    kept: KeptLines<'_>,
    progress: &dyn Progress,
) -> Result<Outcome, ModelError> {
    let sweeps: Vec<Vec<SettledPoint>> = parallel::try_each(direction.sweeps(), |direction| {
        along(model, settings, *direction, kept, progress)
    })?;
    let units = |value: f64| model.operating(Some((settings.sweep, value))).ok()?.si;
    let diagram = SweptDiagram {
        axis: M::axis(settings.sweep),
        directions: direction.sweeps(),
        sweeps: &sweeps,
        si: settings.sweep.values().into_iter().map(units).collect(),
    };
    let lost = sweeps.iter().flatten().filter(|point| point.is_err()).count();
    let told = diagram.told(&settings.sweep.path);
    let values = settings.sweep.values().into_iter();
    let beyond = doubts::beyond_law_along::<M, N>(
        values.filter_map(|value| model.operating(Some((settings.sweep, value))).ok()),
    );
    let mut outcome = Outcome {
        scalars: told.scalars(),
        dataset: diagram.dataset(&M::COORDINATES)?,
        table: Some(diagram.table(&told)?),
        checks: repeated(model, settings, &sweeps, progress)?.into_iter().collect(),
        warnings: beyond.into_iter().chain(diagram.warnings()).collect(),
        missing: lost,
        ..Outcome::default()
    };
    if settings.branches {
        let simulated = diagram.cycles();
        let branches = branches::follow(model, settings.sweep, settings.following, &simulated, progress)?;
        outcome.scalars.extend(branches.told(units).scalars());
        outcome.dataset = branches.add_arrays(outcome.dataset)?;
        outcome.checks.extend(branches.check());
        outcome.warnings.extend(branches.warnings());
    }
    outcome.dataset = diagram.with_si(outcome.dataset, units)?;
    Ok(outcome)
}

/// The keys of the summary, with branches or without.
pub(crate) fn summary_keys(has_branches: bool) -> Vec<Declared> {
    let mut keys = ToldDiagram::declared();
    if has_branches {
        keys.extend(ToldBranches::declared());
    }
    keys
}

/// One sweep; its points stand in the order of the axis, whichever way it goes.
fn along<M: Moving<N>, const N: usize>(
    model: &M,
    settings: &DiagramSettings<'_, M::Key>,
    direction: SweepDirection,
    kept: KeptLines<'_>,
    progress: &dyn Progress,
) -> Result<Vec<SettledPoint>, ModelError> {
    let kept = KeptResults::<SettledPoint>::of(direction.name(), kept);
    let mut places: Vec<(usize, f64)> = settings.sweep.values().into_iter().enumerate().collect();
    let backward = direction == SweepDirection::Backward;
    if backward {
        places.reverse();
    }
    let mut points: Vec<SettledPoint> = Vec::with_capacity(places.len());
    for (place, value) in places {
        // after a lost motion the next one starts as the first did
        let last = points.last().and_then(|point| point.as_ref().ok());
        points.push(kept.at(place as u64, || settled(model, settings, value, last, progress))?);
        progress.advance();
    }
    if backward {
        points.reverse();
    }
    Ok(points)
}

/// What the motion at one value settles to, or why it cannot be followed.
fn settled<M: Moving<N>, const N: usize>(
    model: &M,
    settings: &DiagramSettings<'_, M::Key>,
    value: f64,
    last: Option<&Settling>,
    progress: &dyn Progress,
) -> Result<SettledPoint, ModelError> {
    let operating = match model.operating(Some((settings.sweep, value))) {
        Ok(operating) => operating,
        Err(error) => return Ok(Err(error.to_string())),
    };
    let system = &operating.system;
    let last = last.and_then(|last| <[f64; N]>::try_from(last.state.as_slice()).ok());
    let start = operating.off_rest(last.unwrap_or_else(|| operating.start(settings.start)));
    let patience = Patience {
        time: operating.time(settings.following.duration),
        transient: operating.time(settings.transient),
        ..Patience::default()
    };
    let stepping = operating.settings(settings.following);
    match settle_confirmed(system, start, stepping, &patience, &|| progress.interrupted()) {
        Err(MarchError::Interrupted { .. }) => Err(ModelError::Interrupted),
        settled => Ok(settled
            .map(|confirmed| Settling::of(&confirmed, M::memory(system).as_ref()))
            .map_err(|error| error.to_string())),
    }
}

/// A few cycles followed on more exactly: their rms must stay.
fn repeated<M: Moving<N>, const N: usize>(
    model: &M,
    settings: &DiagramSettings<'_, M::Key>,
    sweeps: &[Vec<SettledPoint>],
    progress: &dyn Progress,
) -> Result<Option<CheckRecord>, ModelError> {
    let values = settings.sweep.values();
    let cycles: Vec<(f64, &Settling)> = sweeps
        .iter()
        .flat_map(|points| values.iter().copied().zip(points))
        .filter_map(|(value, point)| Some((value, point.as_ref().ok()?)))
        .filter(|(_, settling)| settling.becomes == CYCLE)
        .collect();
    if cycles.is_empty() {
        return Ok(None);
    }
    let following =
        Following { tolerance: (FINER * settings.following.tolerance).max(1e-12), ..*settings.following };
    let finer = DiagramSettings { following: &following, ..*settings };
    let some: Vec<_> = cycles.iter().step_by(cycles.len().div_ceil(REPEATED)).collect();
    let figures: Vec<f64> = parallel::try_each(&some, |(value, settling)| {
        let again = settled(model, &finer, *value, Some(settling), progress)?;
        Ok::<_, ModelError>(again.map_or(f64::INFINITY, |again| (again.rms / settling.rms - 1.0).abs()))
    })?;
    Ok(Some(CheckRecord::new(
        "the cycles stay when they are followed more exactly",
        format!("rms of {} cycles at a hundredth of the tolerance, relative", figures.len()),
        figures.into_iter().collect(),
        RMS_LIMIT,
    )))
}
