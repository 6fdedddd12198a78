//! `stability-map`: verdict and mechanism over two keys (Figs. 9, 10).

mod arrays;
mod knock;
mod overlays;

use super::axis::Axis;
use super::steady_states::{SteadyState, validity_warnings};
use crate::bridge;
use crate::checks;
use crate::error::StudyError;
use crate::outcome::Outcome;
use crate::progress::Progress;
use judder_case::{
    Form, MapMethod, OscillatorCase, OscillatorInputs, OscillatorKey, StabilityMap as MapSettings, Sweep,
};
use judder_oscillator::map::{
    AdaptiveMap, CoefficientPlane, Method, Plane, StabilityMap, SweptCoefficient, every_point,
};
use judder_oscillator::mechanism::StabilityClass;
use judder_oscillator::spectrum::{eigenvalues, growth_rate};
use judder_oscillator::{Coefficients, Contact};
use rayon::prelude::*;
use serde_json::{Map, Value, json};
use std::time::Instant;

pub(super) use arrays::{DAMPING, MapArrays};
use arrays::{NORMAL_FORCE, class_fractions};
pub(crate) use knock::{STARTS_IT, UNKNOWN};
pub(super) use overlays::{Overlay, incomplete};

/// Points along each side of the grid on which checks are made and the law's range of validity is looked at.
const CHECKED_SIDE: usize = 24;

/// The plane of any two keys: the groups are resolved at every point.
struct CasePlane<'a> {
    inputs: OscillatorInputs,
    x: (&'a Sweep<OscillatorKey>, &'a [f64]),
    y: (&'a Sweep<OscillatorKey>, &'a [f64]),
}

impl CasePlane<'_> {
    fn inputs(&self, column: usize, row: usize) -> OscillatorInputs {
        let mut inputs = self.inputs;
        self.x.0.set(&mut inputs, self.x.1[column]);
        self.y.0.set(&mut inputs, self.y.1[row]);
        inputs
    }
}

impl Plane for CasePlane<'_> {
    fn columns(&self) -> usize {
        self.x.1.len()
    }

    fn rows(&self) -> usize {
        self.y.1.len()
    }

    fn coefficients(&self, column: usize, row: usize) -> Coefficients {
        bridge::coefficients(&self.inputs(column, row))
    }
}

/// The coefficient that a sweep of this key sets directly, if it is one.
fn swept_coefficient(sweep: &Sweep<OscillatorKey>) -> Option<SweptCoefficient> {
    match (sweep.key, sweep.form) {
        (OscillatorKey::Velocity, Form::Group) => Some(SweptCoefficient::Velocity),
        (OscillatorKey::NormalLoad, Form::Group) => Some(SweptCoefficient::NormalLoad),
        (OscillatorKey::ShearStrength, Form::Group) => Some(SweptCoefficient::ShearStrength),
        _ => None,
    }
}

/// The map of a plane and the seconds that its decisions took, without the start of the threads and the layout of the memory.
fn timed<P: Plane>(contact: &Contact, plane: &P, method: Method) -> (StabilityMap, f64) {
    rayon::broadcast(|_| ());
    let layout = (method == Method::Adaptive).then(|| AdaptiveMap::new(contact, plane));
    let start = Instant::now();
    let map = layout.map_or_else(|| every_point(contact, plane), AdaptiveMap::decide);
    (map, start.elapsed().as_secs_f64())
}

/// The map of a plane, by the short way where both keys are coefficients, and its seconds.
fn decide(contact: &Contact, plane: &CasePlane<'_>, method: Method) -> (StabilityMap, f64) {
    match (swept_coefficient(plane.x.0), swept_coefficient(plane.y.0)) {
        (Some(x), Some(y)) => {
            let base = bridge::coefficients(&plane.inputs(0, 0));
            let plane = CoefficientPlane { base, x: (x, plane.x.1.to_vec()), y: (y, plane.y.1.to_vec()) };
            timed(contact, &plane, method)
        }
        _ => timed(contact, plane, method),
    }
}

pub(super) fn run(
    (case, contact): (&OscillatorCase, &Contact),
    settings: &MapSettings<OscillatorKey>,
    progress: &dyn Progress,
) -> Result<Outcome, StudyError> {
    let (x, y) = (Axis::of_oscillator(&settings.x), Axis::of_oscillator(&settings.y));
    let plane = CasePlane { inputs: case.inputs, x: (&settings.x, &x.values), y: (&settings.y, &y.values) };
    let method = match settings.method {
        MapMethod::Adaptive => Method::Adaptive,
        MapMethod::EveryPoint => Method::EveryPoint,
    };
    let (map, seconds) = decide(contact, &plane, method);
    progress.advance();
    if progress.interrupted() {
        return Err(StudyError::Interrupted);
    }
    let growth = match method {
        Method::EveryPoint => Some(growth_rates(contact, &plane, progress)?),
        Method::Adaptive => None,
    };
    let overlays =
        if settings.boundaries { overlays::trace(contact, case, settings, progress)? } else { Vec::new() };
    progress.advance();
    let states = checked_states(contact, &plane);
    let mut outcome = Outcome {
        scalars: map_scalars(&map, NORMAL_FORCE, seconds, &overlays),
        dataset: MapArrays { x: &x, y: &y, map: &map, growth, overlays: &overlays, neither: NORMAL_FORCE }
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
    if settings.global_margin {
        knock::add(&mut outcome, (case, contact), settings, (&x, &y, &map), progress)?;
    }
    Ok(outcome)
}

/// How many points of a map have no answer, where there are such.
pub(super) fn unresolved_warning(map: &StabilityMap) -> Option<String> {
    let missing = map.count(StabilityClass::Unresolved);
    let all = map.classes.len();
    (missing > 0).then(|| format!("{missing} of {all} points have no answer; they are drawn hatched"))
}

/// The growth rate at every point, row by row; NaN where there is no equilibrium.
fn growth_rates(
    contact: &Contact,
    plane: &CasePlane<'_>,
    progress: &dyn Progress,
) -> Result<Vec<f64>, StudyError> {
    let at = |column: usize, row: usize| {
        let state = SteadyState::new(contact, &plane.inputs(column, row)).ok()?;
        let system = state.linearisation.system().reduced().ok()?;
        Some(growth_rate(&eigenvalues(&system).ok()?))
    };
    let rows: Result<Vec<Vec<f64>>, StudyError> = (0..plane.rows())
        .into_par_iter()
        .map(|row| {
            if progress.interrupted() {
                return Err(StudyError::Interrupted);
            }
            let rates = (0..plane.columns()).map(|column| at(column, row).unwrap_or(f64::NAN)).collect();
            progress.advance();
            Ok(rates)
        })
        .collect();
    Ok(rows?.concat())
}

/// Column and row of the points of a coarse grid over a map.
pub(super) fn checked_points(columns: usize, rows: usize) -> impl Iterator<Item = (usize, usize)> {
    let lines = |count: usize| {
        let last = CHECKED_SIDE.min(count) - 1;
        (0..=last).map(move |k| k * (count - 1) / last.max(1))
    };
    lines(rows).flat_map(move |row| lines(columns).map(move |column| (column, row)))
}

/// Steady states on a coarse grid over the plane, each with its grid point.
fn checked_states(contact: &Contact, plane: &CasePlane<'_>) -> Vec<(SteadyState, (usize, usize))> {
    checked_points(plane.columns(), plane.rows())
        .filter_map(|(column, row)| {
            SteadyState::new(contact, &plane.inputs(column, row)).ok().map(|state| (state, (column, row)))
        })
        .collect()
}

/// What the summary says of a map and its boundaries.
pub(super) fn map_scalars(
    map: &StabilityMap,
    neither: &'static str,
    seconds: f64,
    overlays: &[Overlay],
) -> Map<String, Value> {
    let mut scalars = class_fractions(map, neither);
    scalars.insert("seconds".to_owned(), json!(seconds));
    let boundaries: Map<String, Value> =
        overlays.iter().map(|overlay| (overlay.name.to_owned(), overlay.summary())).collect();
    scalars.insert("boundaries".to_owned(), Value::Object(boundaries));
    scalars
}
