//! Verdicts at the points of a map, and the boundary between them.

use super::AssemblyMap;
use super::kept_point::{DecidedPoint, KeptMapPoint};
use super::point::{MapPoint, PointVerdict};
use crate::assembly::AssemblySubject;
use crate::assembly::swept::{SweptAssembly, beyond_laws};
use crate::error::ModelError;
use crate::key_sweep::KeySweep;
use judder_numerics::order::sort_by_number;
use judder_numerics::parallel;
use judder_store::{Dataset, Results, Variable};
use judder_structure::onset::onsets_between;
use judder_structure::quadratic::Region;
use judder_study::Progress;
use judder_study::axis::SweptAxis;
use judder_study::kept::{KeptLines, KeptResults};
use judder_study::outcome::Outcome;

/// What is told of a map.
#[derive(Results)]
pub(super) struct ToldMap {
    /// the key across
    x: String,
    /// the key upwards
    y: String,
    /// decisions made
    points: usize,
    /// share of the points that are unstable
    unstable_fraction: f64,
    /// points of which nothing is known
    unresolved: usize,
    /// why, at the first of them
    #[result(optional)]
    reason: Option<String>,
    /// points whose fastest growing mode is too fast for the law of a sphere
    #[result(optional)]
    beyond_quasi_steady: Option<usize>,
    /// wall time of the decisions
    seconds: f64,
}

pub(super) fn run(
    of: &AssemblySubject<'_>,
    settings: &AssemblyMap,
    kept: KeptLines<'_>,
    progress: &dyn Progress,
) -> Result<Outcome, ModelError> {
    let map = SolvedMap {
        family: SweptAssembly::new(of, vec![&settings.x, &settings.y], settings.damping),
        region: settings.sought.region().rectangle(),
        x: &settings.x,
        y: &settings.y,
    };
    let start = std::time::Instant::now();
    let (points, reasons) = map.points(kept, progress)?;
    let seconds = start.elapsed().as_secs_f64();
    let boundary = if settings.boundaries { map.boundary(&points, progress)? } else { Vec::new() };
    let count = |is: &dyn Fn(PointVerdict) -> bool| points.iter().filter(|point| is(point.verdict)).count();
    let unresolved = count(&|verdict| verdict == PointVerdict::Unresolved);
    let beyond = points.iter().filter(|point| point.is_beyond_laws).count();
    let unstable = count(&PointVerdict::is_unstable);
    let told = ToldMap {
        x: settings.x.path.clone(),
        y: settings.y.path.clone(),
        points: points.len(),
        unstable_fraction: unstable as f64 / points.len() as f64,
        unresolved,
        reason: reasons.first().cloned(),
        beyond_quasi_steady: of.built.spheres.iter().any(Option::is_some).then_some(beyond),
        seconds,
    };
    let warning = (unresolved > 0).then(|| {
        let why = reasons.first().map_or("eigenvalues may be missing", String::as_str);
        format!("{unresolved} of {} points are not known, the first: {why}", points.len())
    });
    Ok(Outcome {
        scalars: told.scalars(),
        dataset: map.dataset(&points, &boundary)?,
        missing: unresolved,
        warnings: warning
            .into_iter()
            .chain(doubts(&points))
            .chain(beyond_laws(beyond, unstable, WHAT))
            .collect(),
        ..Outcome::default()
    })
}

/// At how many points something is to be said of steady sliding, and the first of it.
fn doubts(points: &[MapPoint]) -> Option<String> {
    let mut doubts = points.iter().filter_map(|point| point.doubt.as_ref());
    let first = doubts.next()?;
    Some(format!("{} of {} points are in doubt, the first: {first}", 1 + doubts.count(), points.len()))
}

/// What the law of a sphere may be too slow for.
const WHAT: &str = "unstable points, for the mode that grows fastest";

/// A map as it is solved.
struct SolvedMap<'a> {
    family: SweptAssembly<'a>,
    region: Region,
    x: &'a KeySweep,
    y: &'a KeySweep,
}

impl SolvedMap<'_> {
    /// All points, row by row, those among them that an interrupted run has kept, and why some are not known.
    fn points(
        &self,
        kept: KeptLines<'_>,
        progress: &dyn Progress,
    ) -> Result<(Vec<MapPoint>, Vec<String>), ModelError> {
        let columns = self.x.values.len();
        let kept = KeptResults::<KeptMapPoint>::of("points", kept);
        let count = columns * self.y.values.len();
        let solved: Vec<DecidedPoint> = parallel::try_each_place(count, |index| {
            progress.go_on()?;
            // who runs analyses takes the last step of each
            if index > 0 {
                progress.advance();
            }
            if let Some(point) = kept.known(index as u64) {
                return Ok(point.solved());
            }
            let solved = match self.solved([index % columns, index / columns]) {
                Err(ModelError::Interrupted) => return Err(ModelError::Interrupted),
                solved => solved.map_err(|error| error.to_string()),
            };
            kept.keep(index as u64, &KeptMapPoint::new(&solved));
            Ok::<_, ModelError>(solved)
        })?;
        let (mut points, mut reasons) = (Vec::with_capacity(solved.len()), Vec::new());
        for point in solved {
            points.push(point.unwrap_or_else(|reason| {
                reasons.push(reason);
                MapPoint::UNKNOWN
            }));
        }
        Ok((points, reasons))
    }

    /// The point at a column and a row.
    fn solved(&self, [column, row]: [usize; 2]) -> Result<MapPoint, ModelError> {
        let state = self.family.state(&[self.x.values[column], self.y.values[row]])?;
        MapPoint::new(&self.family, &state, &self.region)
    }

    /// Where stability changes between neighbours of a row or of a column.
    fn boundary(&self, points: &[MapPoint], progress: &dyn Progress) -> Result<Vec<[f64; 2]>, ModelError> {
        let (columns, rows) = (self.x.values.len(), self.y.values.len());
        let across = (0..rows).flat_map(|row| (1..columns).map(move |k| [[k - 1, row], [k, row]]));
        let upwards = (0..columns).flat_map(|column| (1..rows).map(move |k| [[column, k - 1], [column, k]]));
        let pairs: Vec<[[usize; 2]; 2]> = across.chain(upwards).collect();
        // a search that was stopped has found nothing
        let between = |pair: &[[usize; 2]; 2]| {
            let found = self.between(points, *pair, progress);
            progress.go_on().map(|()| found)
        };
        let found: Vec<Option<[f64; 2]>> = parallel::try_each(&pairs, between)?;
        Ok(found.into_iter().flatten().collect())
    }

    /// Where stability changes between two neighbours; `None` where it does not, or is not known.
    fn between(
        &self,
        points: &[MapPoint],
        [one, other]: [[usize; 2]; 2],
        progress: &dyn Progress,
    ) -> Option<[f64; 2]> {
        let place = |[column, row]: [usize; 2]| [self.x.values[column], self.y.values[row]];
        let axis = usize::from(one[0] == other[0]);
        let point = |[column, row]: [usize; 2]| &points[row * self.x.values.len() + column];
        let mut ends = [one, other];
        sort_by_number(&mut ends, |own| place(*own)[axis]);
        let [low, high] = ends.map(point);
        if low.verdict.is_unstable() == high.verdict.is_unstable() {
            return None;
        }
        let is_rising = high.verdict.is_unstable();
        // of a point that was kept its modes are not
        let known = |at: [usize; 2]| {
            let solved = || self.solved(at).ok()?.stability;
            Some((place(at)[axis], point(at).stability.clone().or_else(solved)?))
        };
        let at = |value: f64| {
            let mut values = place(one);
            values[axis] = value;
            values
        };
        let [low, high] = ends.map(known);
        let found = onsets_between(&low?, &high?, &self.region, &mut |value, within| {
            progress.go_on()?;
            let state = self.family.state(&at(value))?;
            Ok::<_, ModelError>(self.family.solved_alone(&state, within)?.stability(state.pieces))
        });
        let found = found.ok()?.onsets;
        // beyond the first onset modes grow, or before the last
        let onset = if is_rising { found.first() } else { found.last() };
        onset.map(|onset| at(onset.value))
    }

    fn dataset(&self, points: &[MapPoint], boundary: &[[f64; 2]]) -> Result<Dataset, ModelError> {
        let (x, y) = (self.x.axis("x"), self.y.axis("y"));
        let shape = [y.values.len(), x.values.len()];
        let over = ["y", "x"];
        let of = |pick: fn(&MapPoint) -> f64| points.iter().map(pick).collect::<Vec<f64>>();
        let meanings = PointVerdict::ALL.map(|own| (own.code(), own.words()));
        let codes = points.iter().map(|point| point.verdict.code()).collect();
        let along = |name: &str, axis: usize, of: &SweptAxis| {
            let values: Vec<f64> = boundary.iter().map(|place| place[axis]).collect();
            Variable::new(name, &["boundary_point"], &[boundary.len()], values)
                .units(&of.quantity.unit)
                .long_name(&format!("{} where stability changes", of.quantity.label))
        };
        let stability = Variable::classes("stability", &over, &shape, codes, &meanings);
        Ok(Dataset::new()
            .with(x.coordinate())?
            .with(y.coordinate())?
            .with(stability.long_name("stability, by what feeds the fastest growing mode"))?
            .with(
                Variable::new("growth_rate", &over, &shape, of(|point| point.growth))
                    .units("1/s")
                    .long_name("growth rate of the fastest growing or slowest decaying mode"),
            )?
            .with(
                Variable::new("frequency", &over, &shape, of(|point| point.frequency))
                    .units("Hz")
                    .long_name("frequency of that mode"),
            )?
            .with(along("boundary_x", 0, &x))?
            .with(along("boundary_y", 1, &y))?)
    }
}
