//! `bifurcation`: what motions settle to along one key, up and down.

use super::branches::{self, SimulatedCycle};
use super::model::Model;
use crate::analyses::axis::Axis;
use crate::error::StudyError;
use crate::outcome::{CheckRecord, Outcome};
use crate::progress::Progress;
use judder_case::{Following, MotionStart, Sweep, SweepDirection, Value as CaseValue};
use judder_oscillator::motion::attractor::{Attractor, Patience, Settled, distance, settle};
use judder_oscillator::motion::{ContactState, SlidingSystem};
use judder_store::{Dataset, Table, Variable, number};
use rayon::prelude::*;
use serde_json::{Map, json};

/// What is asked.
pub(super) struct Settings<'a, K> {
    pub(super) sweep: &'a Sweep<K>,
    pub(super) start: &'a MotionStart,
    pub(super) following: &'a Following,
    pub(super) transient: CaseValue,
    /// Whether the branches of cycles are followed as well.
    pub(super) branches: bool,
}

/// What a motion has become; the place is the number in stored results.
const BECOMES: [(u8, &str); 4] = [(0, "steady sliding"), (1, "cycle"), (2, "irregular"), (3, "lost")];
const LOST: u8 = 3;
/// A motion that starts nearer to steady sliding than this, in its scales, is moved so far from it: at rest it would stay
/// however unstable that were.
const NUDGE: f64 = 1e-3;
/// Motions of a sweep that are followed again, more exactly.
const REPEATED: usize = 8;
/// By how much more exactly.
const FINER: f64 = 1e-2;
/// What the rms of a cycle may change by then, relative.
const RMS_LIMIT: f64 = 1e-3;

/// A point of the diagram.
struct Point<const N: usize> {
    /// Why there is none, or what the motion settles to.
    attractor: Result<Attractor<N>, String>,
}

impl<const N: usize> Point<N> {
    fn becomes(&self) -> u8 {
        self.attractor.as_ref().map_or(LOST, |attractor| match attractor.settled {
            Settled::SteadySliding => 0,
            Settled::Cycle { .. } => 1,
            Settled::Irregular => 2,
        })
    }

    /// A measure of what moves: zero at rest, NaN where the motion is lost.
    fn measure(&self, value: impl Fn(&Attractor<N>) -> f64) -> f64 {
        self.attractor.as_ref().map_or(f64::NAN, |attractor| match attractor.settled {
            Settled::SteadySliding => 0.0,
            _ => value(attractor),
        })
    }

    fn rms(&self) -> f64 {
        self.measure(|attractor| attractor.measures.rms())
    }

    fn fraction(&self, contact_state: ContactState) -> f64 {
        self.measure(|attractor| attractor.measures.fraction(contact_state))
    }

    fn period(&self) -> f64 {
        match &self.attractor {
            Ok(Attractor { settled: Settled::SteadySliding, .. }) | Err(_) => f64::NAN,
            Ok(attractor) => attractor.period,
        }
    }
}

pub(super) fn run<M: Model<N>, const N: usize>(
    model: &M,
    settings: &Settings<'_, M::Key>,
    direction: SweepDirection,
    progress: &dyn Progress,
) -> Result<Outcome, StudyError> {
    let sweeps: Vec<Vec<Point<N>>> = direction
        .sweeps()
        .par_iter()
        .map(|direction| along(model, settings, *direction, progress))
        .collect::<Result<_, _>>()?;
    let diagram = Diagram { axis: M::axis(settings.sweep), directions: direction.sweeps(), sweeps: &sweeps };
    let lost = sweeps.iter().flatten().filter(|point| point.attractor.is_err()).count();
    let mut outcome = Outcome {
        scalars: diagram.scalars(&settings.sweep.path),
        dataset: diagram.dataset::<M>()?,
        table: Some(diagram.table()?),
        checks: repeated(model, settings, &sweeps)?.into_iter().collect(),
        warnings: diagram.warning().into_iter().collect(),
        missing: lost,
        ..Outcome::default()
    };
    if settings.branches {
        let simulated = diagram.cycles();
        let branches = branches::follow(model, (settings.sweep, settings.following), &simulated, progress)?;
        outcome.scalars.extend(branches.scalars());
        outcome.dataset = branches.add_arrays(outcome.dataset)?;
        outcome.checks.extend(branches.check());
        outcome.warnings.extend(branches.warnings());
    }
    Ok(outcome)
}

/// One sweep; its points stand in the order of the axis, whichever way it goes.
fn along<M: Model<N>, const N: usize>(
    model: &M,
    settings: &Settings<'_, M::Key>,
    direction: SweepDirection,
    progress: &dyn Progress,
) -> Result<Vec<Point<N>>, StudyError> {
    let mut values = settings.sweep.values();
    let backward = direction == SweepDirection::Backward;
    if backward {
        values.reverse();
    }
    let mut last = None;
    let mut points = Vec::with_capacity(values.len());
    for value in values {
        if progress.interrupted() {
            return Err(StudyError::Interrupted);
        }
        let attractor = settled(model, settings, value, last);
        // after a lost motion the next one starts as the first did
        last = attractor.as_ref().ok().map(|attractor| attractor.state);
        points.push(Point { attractor });
        progress.advance();
    }
    if backward {
        points.reverse();
    }
    Ok(points)
}

/// What the motion at one value settles to, or why it cannot be followed.
fn settled<M: Model<N>, const N: usize>(
    model: &M,
    settings: &Settings<'_, M::Key>,
    value: f64,
    last: Option<[f64; N]>,
) -> Result<Attractor<N>, String> {
    let operating = model.operating(Some((settings.sweep, value))).map_err(|error| error.to_string())?;
    let system = &operating.system;
    let mut start = last.unwrap_or_else(|| operating.start(settings.start));
    let (rest, scales) = (system.steady_sliding(), system.scales());
    if distance(&start, &rest, &scales) < NUDGE {
        start = rest;
        start[0] += NUDGE * scales[0];
    }
    let patience = Patience {
        time: operating.time(settings.following.duration),
        transient: operating.time(settings.transient),
        ..Patience::default()
    };
    settle(system, start, operating.settings(settings.following), &patience)
        .map_err(|error| error.to_string())
}

/// A few cycles followed on more exactly: their rms must stay.
fn repeated<M: Model<N>, const N: usize>(
    model: &M,
    settings: &Settings<'_, M::Key>,
    sweeps: &[Vec<Point<N>>],
) -> Result<Option<CheckRecord>, StudyError> {
    let values = settings.sweep.values();
    let cycles: Vec<(f64, &Attractor<N>)> = sweeps
        .iter()
        .flat_map(|points| values.iter().copied().zip(points))
        .filter_map(|(value, point)| Some((value, point.attractor.as_ref().ok()?)))
        .filter(|(_, attractor)| matches!(attractor.settled, Settled::Cycle { .. }))
        .collect();
    if cycles.is_empty() {
        return Ok(None);
    }
    let following =
        Following { tolerance: (FINER * settings.following.tolerance).max(1e-12), ..*settings.following };
    let finer = Settings { following: &following, ..*settings };
    let figures: Vec<f64> = cycles
        .par_iter()
        .step_by(cycles.len().div_ceil(REPEATED))
        .map(|(value, attractor)| {
            let again = settled(model, &finer, *value, Some(attractor.state));
            again.map_or(f64::INFINITY, |again| (again.measures.rms() / attractor.measures.rms() - 1.0).abs())
        })
        .collect();
    Ok(Some(CheckRecord {
        name: "the cycles stay when they are followed more exactly".to_owned(),
        compared: format!("rms of {} cycles at a hundredth of the tolerance, relative", figures.len()),
        figure: figures.into_iter().fold(0.0, f64::max),
        limit: RMS_LIMIT,
    }))
}

/// All sweeps along the axis.
struct Diagram<'a, const N: usize> {
    axis: Axis,
    directions: &'a [SweepDirection],
    sweeps: &'a [Vec<Point<N>>],
}

impl<const N: usize> Diagram<'_, N> {
    fn points(&self) -> impl Iterator<Item = &Point<N>> {
        self.sweeps.iter().flatten()
    }

    /// Every cycle that a motion has settled to.
    fn cycles(&self) -> Vec<SimulatedCycle<N>> {
        let cycle = |(value, point): (f64, &Point<N>)| {
            let attractor = point.attractor.as_ref().ok()?;
            let Settled::Cycle { oscillations } = attractor.settled else { return None };
            Some(SimulatedCycle {
                value,
                start: attractor.state,
                oscillations,
                rms: attractor.measures.rms(),
                period: attractor.period,
            })
        };
        self.places().0.into_iter().zip(self.points()).filter_map(cycle).collect()
    }

    fn values(&self, value: impl Fn(&Point<N>) -> f64) -> Vec<f64> {
        self.points().map(value).collect()
    }

    /// The swept value and the direction of every point, in their order.
    fn places(&self) -> (Vec<f64>, Vec<&'static str>) {
        let values = self.directions.iter().flat_map(|_| self.axis.values.iter().copied());
        let names = self
            .directions
            .iter()
            .flat_map(|direction| std::iter::repeat_n(direction.name(), self.axis.values.len()));
        (values.collect(), names.collect())
    }

    fn words(&self) -> Vec<&'static str> {
        self.points().map(|point| BECOMES[usize::from(point.becomes())].1).collect()
    }

    fn scalars(&self, key: &str) -> Map<String, serde_json::Value> {
        let numbers = |values: Vec<f64>| values.into_iter().map(number).collect::<Vec<_>>();
        let (value, direction) = self.places();
        Map::from_iter([
            ("key".to_owned(), json!(key)),
            ("value".to_owned(), json!(value)),
            ("direction".to_owned(), json!(direction)),
            ("rms".to_owned(), json!(numbers(self.values(Point::rms)))),
            ("becomes".to_owned(), json!(self.words())),
            ("period".to_owned(), json!(numbers(self.values(Point::period)))),
            ("stick_fraction".to_owned(), json!(numbers(self.values(|p| p.fraction(ContactState::Stick))))),
            (
                "lift_off_fraction".to_owned(),
                json!(numbers(self.values(|p| p.fraction(ContactState::LiftOff)))),
            ),
        ])
    }

    fn dataset<M: Model<N>>(&self) -> Result<Dataset, StudyError> {
        let shape = [self.directions.len(), self.axis.values.len()];
        let dimensions = ["direction", self.axis.name()];
        let over = |name: &str, long_name: &str, values: Vec<f64>| {
            Variable::new(name, &dimensions, &shape, values).units("1").long_name(long_name)
        };
        let names: Vec<String> = self.directions.iter().map(|d| d.name().to_owned()).collect();
        let becomes: Vec<u8> = self.points().map(Point::becomes).collect();
        let dataset = Dataset::new()
            .with(Variable::coordinate("direction", names).long_name("which way the key was followed"))?
            .with(self.axis.coordinate())?
            .with(over("rms", "rms of x about its mean", self.values(Point::rms)))?
            .with(over(
                "period",
                "period of a cycle, mean time of an oscillation otherwise",
                self.values(Point::period),
            ))?
            .with(over(
                "stick_fraction",
                "share of the time in stick",
                self.values(|p| p.fraction(ContactState::Stick)),
            ))?
            .with(over(
                "lift_off_fraction",
                "share of the time off the substrate",
                self.values(|p| p.fraction(ContactState::LiftOff)),
            ))?
            .with(
                Variable::classes("becomes", &dimensions, &shape, becomes, &BECOMES)
                    .long_name("what the motion settles to"),
            )?;
        Ok(self.with_section::<M>(dataset)?.attribute("kind", "bifurcation")?)
    }

    /// With the meetings of all motions with the section, where x is largest.
    fn with_section<M: Model<N>>(&self, mut dataset: Dataset) -> Result<Dataset, StudyError> {
        let (values, directions) = self.places();
        let places = values.iter().zip(&directions).zip(self.points());
        let meetings: Vec<(f64, &str, &[f64; N])> = places
            .filter_map(|((value, direction), point)| {
                Some((*value, *direction, point.attractor.as_ref().ok()?))
            })
            .flat_map(|(value, direction, attractor)| {
                attractor.returns.iter().map(move |state| (value, direction, state))
            })
            .collect();
        let count = meetings.len();
        let over =
            |name: &str, values: Vec<f64>| Variable::new(name, &["section"], &[count], values).units("1");
        dataset = dataset
            .with(over("section_value", meetings.iter().map(|m| m.0).collect()).long_name("swept value"))?
            .with(
                Variable::new(
                    "section_direction",
                    &["section"],
                    &[count],
                    meetings.iter().map(|m| m.1.to_owned()).collect::<Vec<_>>(),
                )
                .long_name("which way the key was followed"),
            )?;
        for (k, coordinate) in M::COORDINATES.into_iter().enumerate().filter(|(k, _)| *k != N / 2) {
            let values = meetings.iter().map(|m| m.2[k]).collect();
            dataset = dataset.with(
                over(&format!("section_{}", coordinate.name), values)
                    .long_name(coordinate.long_name)
                    .attribute("label", coordinate.label),
            )?;
        }
        Ok(dataset)
    }

    fn table(&self) -> Result<Table, StudyError> {
        let (value, direction) = self.places();
        let words = |words: Vec<&str>| words.into_iter().map(str::to_owned).collect::<Vec<_>>();
        Ok(Table::new()
            .column(self.axis.name(), &self.axis.quantity.unit, value)?
            .column("direction", "", words(direction))?
            .column("becomes", "", words(self.words()))?
            .column("rms", "1", self.values(Point::rms))?
            .column("period", "1", self.values(Point::period))?
            .column("stick_fraction", "1", self.values(|p| p.fraction(ContactState::Stick)))?
            .column("lift_off_fraction", "1", self.values(|p| p.fraction(ContactState::LiftOff)))?)
    }

    /// How many motions could not be followed, and why the first.
    fn warning(&self) -> Option<String> {
        let (values, directions) = self.places();
        let mut lost = self
            .points()
            .zip(values.iter().zip(directions))
            .filter_map(|(point, place)| Some((point.attractor.as_ref().err()?, place)));
        let (reason, (value, direction)) = lost.next()?;
        Some(format!(
            "{} of {} motions cannot be followed, the first at {value:e}, {direction}: {reason}",
            lost.count() + 1,
            values.len()
        ))
    }
}
