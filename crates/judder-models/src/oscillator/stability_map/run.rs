//! Verdict and mechanism over two keys (Figs. 9, 10).

use super::arrays::{MapOverAxes, NORMAL_FORCE, ToldStabilityMap, WORDS};
use super::{MapArrays, incomplete, knock, overlays, within_law};
use crate::axis;
use crate::checks;
use crate::error::ModelError;
use crate::oscillator::case::OscillatorCase;
use crate::oscillator::key_plane::{KeyAxis, KeyPlane};
use crate::oscillator::keys::OscillatorKey;
use crate::oscillator::steady_states::{SteadyState, validity_warnings};
use crate::sweep::{StabilityMapAnalysis, Sweep};
use judder_oscillator::Contact;
use judder_oscillator::map::{DecisionMethod, OperatingPlane, StabilityMap};
use judder_oscillator::mechanism::StabilityClass;
use judder_store::Results;
use judder_study::Progress;
use judder_study::axis::SweptAxis;
use judder_study::kept::KeptLines;
use judder_study::outcome::Outcome;

/// Points along each side of the grid on which checks are made and the law's range of validity is looked at.
const CHECKED_SIDE: usize = 24;

pub(crate) fn run(
    case: &OscillatorCase,
    contact: &Contact,
    settings: &StabilityMapAnalysis<OscillatorKey>,
    (kept, progress): (KeptLines<'_>, &dyn Progress),
) -> Result<Outcome, ModelError> {
    let (x, y) = (axis::of_key(&settings.x), axis::of_key(&settings.y));
    let side = |sweep: &Sweep<OscillatorKey>, axis: &SweptAxis| KeyAxis {
        key: sweep.key,
        form: sweep.form,
        values: axis.values.clone(),
    };
    let plane = KeyPlane { inputs: case.inputs, x: side(&settings.x, &x), y: side(&settings.y, &y) };
    let method = settings.options.method;
    let (map, seconds) = plane.decide(contact, method);
    progress.advance();
    if progress.interrupted() {
        return Err(ModelError::Interrupted);
    }
    let growth = match method {
        DecisionMethod::EveryPoint => Some(plane.growth_rates(contact, progress)?),
        DecisionMethod::Adaptive => None,
    };
    let overlays = if settings.options.boundaries {
        overlays::trace(contact, case, settings, progress)?
    } else {
        Vec::new()
    };
    progress.advance();
    let states = checked_states(contact, &plane);
    let mut outcome = Outcome {
        scalars: ToldStabilityMap::new(&map, NORMAL_FORCE, seconds, &overlays).scalars(),
        dataset: MapArrays { x: &x, y: &y, map: &map, growth, overlays: &overlays, words: &WORDS }
            .dataset()?,
        warnings: validity_warnings(contact, states.iter().map(|(state, _)| state)),
        checks: checks::steady_sliding(contact, &states.iter().map(|(state, _)| *state).collect::<Vec<_>>()),
        missing: map.count(StabilityClass::Unresolved),
        ..Outcome::default()
    };
    outcome.checks.push(checks::map_against_points(&states, &map));
    outcome.checks.extend(overlays::check(&overlays));
    outcome.warnings.extend(incomplete(&overlays));
    outcome.warnings.extend(unresolved_warning(&map));
    let over = MapOverAxes { x: &x, y: &y, map: &map };
    if !contact.law.is_formula() {
        let codes = plane.within_law(contact, &map, method, &|| progress.interrupted());
        within_law::add(&mut outcome, over, codes.ok_or(ModelError::Interrupted)?)?;
    }
    if settings.global_margin {
        knock::add(&mut outcome, case, contact, settings, over, (kept, progress))?;
    }
    Ok(outcome)
}

/// How many points of a map have no answer, where there are such.
pub(crate) fn unresolved_warning(map: &StabilityMap) -> Option<String> {
    let missing = map.count(StabilityClass::Unresolved);
    let all = map.classes.len();
    (missing > 0).then(|| format!("{missing} of {all} points have no answer; they are drawn hatched"))
}

/// Column and row of the points of a coarse grid over a map.
pub(crate) fn checked_points(columns: usize, rows: usize) -> impl Iterator<Item = (usize, usize)> {
    let lines = |count: usize| {
        let last = CHECKED_SIDE.min(count) - 1;
        (0..=last).map(move |k| k * (count - 1) / last.max(1))
    };
    lines(rows).flat_map(move |row| lines(columns).map(move |column| (column, row)))
}

/// Steady states on a coarse grid over the plane, each with its grid point.
fn checked_states(contact: &Contact, plane: &KeyPlane) -> Vec<(SteadyState, (usize, usize))> {
    checked_points(plane.columns(), plane.rows())
        .filter_map(|(column, row)| {
            SteadyState::new(contact, &plane.inputs(column, row)).ok().map(|state| (state, (column, row)))
        })
        .collect()
}
