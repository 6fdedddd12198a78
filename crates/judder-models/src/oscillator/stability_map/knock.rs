//! The third region of a map: steady sliding is stable, but a knock starts a cycle.

use super::super::margins::{
    self, KeptMargins, Margin, MarginCrossing, MarginOnset, MotionSearch, fold_check,
};
use super::arrays::MapOverAxes;
use crate::axis::range;
use crate::bridge;
use crate::error::ModelError;
use crate::oscillator::case::OscillatorCase;
use crate::oscillator::inputs::OscillatorInputs;
use crate::oscillator::keys::OscillatorKey;
use crate::sweep::{StabilityMapAnalysis, Sweep};
use judder_numerics::parallel;
use judder_oscillator::Contact;
use judder_oscillator::critical::{ParameterRange, RangeScale, thresholds};
use judder_oscillator::map::StabilityMap;
use judder_oscillator::mechanism::StabilityClass;
use judder_store::{Results, Variable};
use judder_study::Progress;
use judder_study::axis::SweptAxis;
use judder_study::kept::KeptLines;
use judder_study::outcome::Outcome;

/// Lines of a map along which branches are followed, at most; between them the margin is interpolated.
const FOLLOWED: usize = 30;
/// Samples of the search for thresholds, a decade and a linear range.
const SAMPLES_PER_DECADE: f64 = 40.0;
const SAMPLES: usize = 400;
/// By which factor thresholds are sought beyond both ends of a logarithmic axis: a cycle in the map may have its threshold outside.
const BEYOND: f64 = 10.0;

/// What a knock does at a stable point; the number is that in stored results.
const KNOCK: [(u8, &str); 4] = [
    (0, "point not stable"),
    (STARTS_IT, "may start a motion that is known"),
    (UNKNOWN, "unknown"),
    (NONE_MOVED, "no start of a search moved"),
];
pub(crate) const STARTS_IT: u8 = 1;
pub(crate) const UNKNOWN: u8 = 2;
pub(crate) const NONE_MOVED: u8 = 3;

/// The lines of a map along which thresholds are crossed.
struct Lines<'a> {
    contact: &'a Contact,
    inputs: OscillatorInputs,
    /// From line to line.
    across: (&'a Sweep<OscillatorKey>, &'a [f64]),
    /// Along a line.
    along: (&'a Sweep<OscillatorKey>, &'a [f64]),
    range: ParameterRange,
    /// Whether lines are columns.
    follows_y: bool,
}

/// A line with what grows from its thresholds, and with margins where branches were followed.
struct MapLine {
    onsets: Vec<Option<MarginOnset>>,
    is_followed: bool,
}

/// The stable points on one side of a threshold.
#[derive(Clone, Copy)]
struct Reach {
    threshold: f64,
    /// +1 above, −1 below.
    side: f64,
    /// Up to here a knock starts a motion.
    known_to: f64,
    /// From there up to here motions are known at some values.
    gap_to: f64,
    /// From there up to here no start of a search moved.
    quiet_to: f64,
}

impl Reach {
    /// Nothing is known beside a threshold.
    fn open(onset: &MarginOnset) -> Self {
        let (threshold, side) = (onset.threshold, onset.stable_side);
        Self { threshold, side, known_to: threshold, gap_to: threshold, quiet_to: threshold }
    }

    /// What a threshold's own margin tells.
    fn own(onset: &MarginOnset) -> Self {
        let Some(margin) = &onset.margin else { return Self::open(onset) };
        let (threshold, side) = (onset.threshold, onset.stable_side);
        let MotionSearch { known_to, farthest, quiet_to, .. } = margin.search;
        let gap_to = margin.reaches(side).unwrap_or(farthest);
        Self { threshold, side, known_to, gap_to, quiet_to: quiet_to.unwrap_or(gap_to) }
    }

    /// What a knock does at a value; `None` on the other side of the threshold.
    fn code(&self, value: f64) -> Option<(u8, Weight)> {
        let is_beyond = |place: f64| (value - place) * self.side > 0.0;
        if !is_beyond(self.threshold) {
            return None;
        }
        Some(match (is_beyond(self.known_to), is_beyond(self.gap_to), is_beyond(self.quiet_to)) {
            (false, ..) => (STARTS_IT, Weight::Known),
            (true, false, _) => (UNKNOWN, Weight::Gap),
            (true, true, false) => (NONE_MOVED, Weight::Sought),
            _ => (UNKNOWN, Weight::NotSought),
        })
    }
}

/// Of two thresholds that a point lies beside, the one that tells more of it counts.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Weight {
    NotSought,
    Sought,
    Gap,
    Known,
}

/// Between two lines whose margins differ by more than this, as a logarithm or a share of the axis, one may have a branch that the
/// other has not, and nothing is interpolated.
const JUMP: f64 = 0.2;

impl<'a> Lines<'a> {
    fn new(
        contact: &'a Contact,
        case: &OscillatorCase,
        settings: &'a StabilityMapAnalysis<OscillatorKey>,
        x: &'a SweptAxis,
        y: &'a SweptAxis,
    ) -> Self {
        let is_usual =
            |key: OscillatorKey| matches!(key, OscillatorKey::ShearStrength | OscillatorKey::NormalLoad);
        let follows_y = is_usual(settings.y.key) || !is_usual(settings.x.key);
        let (columns, rows) = ((&settings.x, x.values.as_slice()), (&settings.y, y.values.as_slice()));
        let (across, along) = if follows_y { (columns, rows) } else { (rows, columns) };
        Self { contact, inputs: case.inputs, across, along, range: searched(along.0), follows_y }
    }

    fn crossing(&self, line: usize) -> MarginCrossing<'a> {
        let mut inputs = self.inputs;
        let (across, values) = self.across;
        across.set(&mut inputs, values[line]);
        let (key, form) = (self.along.0.key, self.along.0.form);
        MarginCrossing { contact: self.contact, inputs, key, form, range: self.range }
    }

    fn count(&self) -> usize {
        self.across.1.len()
    }

    /// The lines along which branches are followed, both ends among them.
    fn followed(&self) -> Vec<usize> {
        let count = self.count().min(FOLLOWED);
        (0..count).map(|k| k * (self.count() - 1) / (count - 1).max(1)).collect()
    }

    fn line(&self, index: usize, is_followed: bool, way: (&KeptMargins<'_>, &dyn Progress)) -> MapLine {
        let crossing = self.crossing(index);
        let samples = match self.range.scale {
            RangeScale::Logarithmic => {
                (libm::log10(self.range.to / self.range.from) * SAMPLES_PER_DECADE).ceil() as usize + 1
            }
            RangeScale::Linear => SAMPLES,
        };
        let at = |value: f64| bridge::coefficients(&crossing.inputs_at(value));
        let roots = thresholds(self.contact, &self.range, samples, at).full;
        let onsets = match is_followed {
            true => crossing.onsets_with_margins(index, &roots, way),
            false => roots.iter().map(|threshold| crossing.onset(*threshold)).collect(),
        };
        MapLine { onsets, is_followed }
    }

    fn all(&self, (kept, progress): (KeptLines<'_>, &dyn Progress)) -> Result<Vec<MapLine>, ModelError> {
        let followed = self.followed();
        let kept = KeptMargins::of("lines", kept);
        progress.expect(followed.len());
        parallel::try_each_place(self.count(), |index| {
            let is_followed = followed.contains(&index);
            let line = self.line(index, is_followed, (&kept, progress));
            if is_followed {
                progress.advance();
            }
            if progress.interrupted() { Err(ModelError::Interrupted) } else { Ok(line) }
        })
    }

    /// What is known beside the thresholds of a line: its own margins, or those between its followed neighbours.
    fn reaches(&self, lines: &[MapLine], index: usize) -> Vec<Reach> {
        let line = &lines[index];
        let neighbours = || {
            let before = (0..=index).rev().find(|k| lines[*k].is_followed)?;
            let behind = (index..lines.len()).find(|k| lines[*k].is_followed)?;
            Some((before, behind))
        };
        let known = line.onsets.iter().enumerate().filter_map(|(k, onset)| Some((k, onset.as_ref()?)));
        known
            .map(|(k, onset)| {
                if line.is_followed {
                    return Reach::own(onset);
                }
                let Some((before, behind)) = neighbours() else { return Reach::open(onset) };
                let share = (index - before) as f64 / (behind - before).max(1) as f64;
                self.between(&lines[before], &lines[behind], k, line, share)
                    .unwrap_or_else(|| Reach::open(onset))
            })
            .collect()
    }

    /// The margin of a threshold between two followed lines; `None` where these do not agree in what grows from theirs.
    fn between(
        &self,
        before: &MapLine,
        behind: &MapLine,
        k: usize,
        line: &MapLine,
        share: f64,
    ) -> Option<Reach> {
        let kinds = |line: &MapLine| {
            let kind = |onset: &MarginOnset| (onset.hopf.is_subcritical(), onset.stable_side > 0.0);
            line.onsets.iter().map(|onset| onset.as_ref().map(kind)).collect::<Vec<_>>()
        };
        if kinds(before) != kinds(line) || kinds(behind) != kinds(line) {
            return None;
        }
        let (from, to) = (Reach::own(before.onsets[k].as_ref()?), Reach::own(behind.onsets[k].as_ref()?));
        let onset = line.onsets[k].as_ref()?;
        let crossing = self.crossing(0);
        let places =
            |of: fn(&Reach) -> f64| [&from, &to].map(|reach| crossing.place(reach.threshold, of(reach)));
        let value = |s: f64| crossing.value(onset.threshold, s);
        let nearer = |[a, b]: [f64; 2]| if a.abs() < b.abs() { a } else { b };
        let farther = |[a, b]: [f64; 2]| if a.abs() < b.abs() { b } else { a };
        let [known, gap, quiet] =
            [|r: &Reach| r.known_to, |r: &Reach| r.gap_to, |r: &Reach| r.quiet_to].map(places);
        let is_near = |[a, b]: [f64; 2]| (a - b).abs() <= JUMP;
        let along = |[a, b]: [f64; 2]| a + (b - a) * share;
        let is_smooth = is_near(known) && is_near(gap);
        Some(Reach {
            threshold: onset.threshold,
            side: onset.stable_side,
            known_to: value(if is_smooth { along(known) } else { nearer(known) }),
            gap_to: value(if is_smooth { along(gap) } else { farther(gap) }),
            quiet_to: value(nearer(quiet)),
        })
    }

    /// What a knock does at a value along a line, where steady sliding is stable.
    fn code(&self, reaches: &[Reach], value: f64) -> u8 {
        let codes = reaches.iter().filter_map(|reach| reach.code(value));
        codes.max_by_key(|(_, weight)| *weight).map_or(UNKNOWN, |(code, _)| code)
    }

    /// The code of every point of the map, row by row.
    fn codes(&self, lines: &[MapLine], map: &StabilityMap) -> Vec<u8> {
        let reaches: Vec<Vec<Reach>> = (0..lines.len()).map(|index| self.reaches(lines, index)).collect();
        let points = (0..map.rows).flat_map(|row| (0..map.columns).map(move |column| (column, row)));
        points
            .map(|(column, row)| {
                let (line, along) = if self.follows_y { (column, row) } else { (row, column) };
                match map.class(column, row) {
                    StabilityClass::Stable => self.code(&reaches[line], self.along.1[along]),
                    _ => 0,
                }
            })
            .collect()
    }
}

/// Where thresholds are sought along an axis, ascending.
fn searched(sweep: &Sweep<OscillatorKey>) -> ParameterRange {
    let range = range(sweep);
    let (from, to) = (range.from.min(range.to), range.from.max(range.to));
    match range.scale {
        RangeScale::Logarithmic => ParameterRange { from: from / BEYOND, to: to * BEYOND, ..range },
        RangeScale::Linear => ParameterRange { from, to, ..range },
    }
}

/// Adds the third region to a map's outcome.
pub(super) fn add(
    outcome: &mut Outcome,
    case: &OscillatorCase,
    contact: &Contact,
    settings: &StabilityMapAnalysis<OscillatorKey>,
    over: MapOverAxes<'_>,
    (kept, progress): (KeptLines<'_>, &dyn Progress),
) -> Result<(), ModelError> {
    let MapOverAxes { x, y, map } = over;
    let lines = Lines::new(contact, case, settings, x, y);
    let found = lines.all((kept, progress))?;
    let codes = lines.codes(&found, map);
    let share = |code: u8| codes.iter().filter(|c| **c == code).count() as f64 / codes.len() as f64;
    let onsets: Vec<(usize, &MarginOnset)> = found
        .iter()
        .enumerate()
        .filter(|(_, line)| line.is_followed)
        .flat_map(|(index, line)| line.onsets.iter().flatten().map(move |onset| (index, onset)))
        .collect();
    let margins: Vec<&Margin> = onsets.iter().filter_map(|(_, onset)| onset.margin.as_ref()).collect();
    let branches = margins.iter().filter_map(|margin| margin.own.as_ref());
    let told = ToldKnock {
        knock_fraction: share(STARTS_IT),
        knock_unknown_fraction: share(UNKNOWN),
        global_margin: ToldMargin {
            along: lines.along.0.path.clone(),
            lines: lines.count(),
            lines_followed: lines.followed().len(),
            thresholds_sought: [lines.range.from, lines.range.to],
            branches: branches.clone().count(),
            branches_without_a_fold: branches.filter(|own| own.is_open).count(),
            searches: margins.len(),
            searches_not_closed: margins.iter().filter(|margin| margin.search.why_open().is_some()).count(),
        },
    };
    outcome.scalars.extend(told.scalars());
    outcome.warnings.extend(margins::open(&margins, "what a knock does beyond is marked as unknown"));
    let folds = folds(&lines, &onsets);
    let dataset = std::mem::take(&mut outcome.dataset);
    let dataset = dataset.with(
        over.classes("knock", codes, &KNOCK).long_name("what a knock does where steady sliding is stable"),
    )?;
    let over = |axis: &SweptAxis, values: Vec<f64>| {
        Variable::new(&format!("fold_{}", axis.name()), &["fold"], &[values.len()], values)
            .units(&axis.quantity.unit)
            .long_name("least folds over the motions that are known")
    };
    outcome.dataset = dataset
        .with(over(x, folds.iter().map(|fold| fold.0).collect()))?
        .with(over(y, folds.iter().map(|fold| fold.1).collect()))?;
    let crossings: Vec<_> = onsets.iter().map(|(index, onset)| (lines.crossing(*index), *onset)).collect();
    let (check, warning) = fold_check(&crossings, progress);
    outcome.checks.extend(check);
    outcome.warnings.extend(warning);
    if progress.interrupted() { Err(ModelError::Interrupted) } else { Ok(()) }
}

/// What is told of knocks.
#[derive(Results)]
pub(super) struct ToldKnock {
    knock_fraction: f64,
    knock_unknown_fraction: f64,
    global_margin: ToldMargin,
}

/// What was followed to tell of knocks.
#[derive(Results)]
struct ToldMargin {
    /// the key along which lines lie
    along: String,
    lines: usize,
    lines_followed: usize,
    /// from and to
    thresholds_sought: [f64; 2],
    branches: usize,
    branches_without_a_fold: usize,
    searches: usize,
    searches_not_closed: usize,
}

/// The folds that were found, as points of the map.
fn folds(lines: &Lines<'_>, onsets: &[(usize, &MarginOnset)]) -> Vec<(f64, f64)> {
    let fold = |(index, onset): &(usize, &MarginOnset)| {
        let (line, along) = (lines.across.1[*index], onset.margin.as_ref()?.fold()?);
        Some(if lines.follows_y { (line, along) } else { (along, line) })
    };
    onsets.iter().filter_map(fold).collect()
}
