//! The points of a chunk.

use super::plan::{Column, SweepPlan};
use super::point_quantity::{PointQuantity, PointState, linear_values};
use super::scalars::number_at;
use crate::analyses::{self, Prepared};
use crate::bridge;
use crate::computed_law::NO_POINTS;
use crate::door;
use crate::error::StudyError;
use crate::outcome::Outcome;
use crate::progress::Progress;
use judder_case::{Case, Form, LawName, OscillatorCase, OscillatorInputs, OscillatorKey, Value};
use judder_oscillator::Contact;
use judder_store::PointFailure;
use std::any::Any;
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::Instant;

/// How the reason of a point begins that has values which a check doubts.
pub(super) const DOUBTFUL: &str = "doubtful: ";

/// What a chunk holds: every column of its points, point after point, and which points failed.
#[derive(Debug, Clone)]
pub struct ChunkValues {
    /// Point-major.
    pub values: Vec<f64>,
    /// By index in the chunk.
    pub failures: Vec<PointFailure>,
}

/// A plan, ready to compute points.
pub struct Evaluator<'a> {
    pub(super) plan: Cow<'a, SweepPlan>,
    way: Way,
}

/// How the operating point comes about.
enum Way {
    /// The swept keys are set in the inputs of the case: law and material stay what they are.
    Inputs(Box<SetInputs>),
    /// The case is read anew; what it shares with the case of the file is taken from there.
    Anew(Prepared),
}

/// The inputs of the case, the keys that are set in them, and the contact of all points.
struct SetInputs {
    inputs: OscillatorInputs,
    keys: Vec<(OscillatorKey, Form)>,
    law: LawName,
    contact: Contact,
}

impl SetInputs {
    /// The inputs with these values.
    fn at(&self, values: &[f64]) -> Result<OscillatorInputs, StudyError> {
        let mut inputs = self.inputs;
        for ((key, form), value) in self.keys.iter().zip(values) {
            inputs.set(*key, Value { number: *value, form: *form });
        }
        inputs.check(self.law).map_err(|cause| StudyError::Unsupported(cause.to_string()))?;
        Ok(inputs)
    }
}

impl<'a> Evaluator<'a> {
    /// Makes what all points share.
    ///
    /// # Errors
    /// A case that cannot be prepared, [`StudyError::Interrupted`].
    pub fn new(plan: &'a SweepPlan, progress: &dyn Progress) -> Result<Self, StudyError> {
        Ok(Self { way: way(plan, progress)?, plan: Cow::Borrowed(plan) })
    }

    /// The same with a plan of its own.
    ///
    /// # Errors
    /// As of [`new`](Self::new).
    pub fn owned(plan: SweepPlan, progress: &dyn Progress) -> Result<Evaluator<'static>, StudyError> {
        Ok(Evaluator { way: way(&plan, progress)?, plan: Cow::Owned(plan) })
    }

    /// Computes all points of a chunk.
    ///
    /// # Errors
    /// [`StudyError::Interrupted`], a chunk that is not there.
    pub fn chunk(&self, chunk: usize, progress: &dyn Progress) -> Result<ChunkValues, StudyError> {
        let points = self.plan.layout().points(chunk)?;
        let (count, width) = (points.count(), self.plan.columns.len());
        let mut values = vec![f64::NAN; count * width];
        let mut failures = Vec::new();
        for (index, row) in values.chunks_exact_mut(width).enumerate() {
            // asking takes longer than an operating point
            if (index % 64 == 0 || matches!(self.way, Way::Anew(_))) && progress.interrupted() {
                return Err(StudyError::Interrupted);
            }
            if let Some(reason) = self.point(&points.position(index), row, progress)? {
                failures.push(PointFailure { index, reason });
            }
        }
        Ok(ChunkValues { values, failures })
    }

    /// Computes points evenly over the sweep, as many as fit into a while, and gives the seconds of one.
    ///
    /// # Errors
    /// [`StudyError::Interrupted`].
    pub(super) fn seconds_of_a_point(&self, progress: &dyn Progress) -> Result<f64, StudyError> {
        /// As many as are tried, and how long (s).
        const TRIED: usize = 1000;
        const WHILE: f64 = 0.5;
        let lengths = self.plan.layout().dimensions();
        let began = Instant::now();
        let mut row = vec![f64::NAN; self.plan.columns.len()];
        let mut done = 0;
        while done < TRIED && (done == 0 || began.elapsed().as_secs_f64() < WHILE) {
            // along the diagonal of the grid
            let part = (done as f64 * 0.618_033_988_749_895).fract();
            let position: Vec<usize> =
                lengths.iter().map(|dimension| (part * dimension.length as f64) as usize).collect();
            self.point(&position, &mut row, progress)?;
            done += 1;
        }
        Ok(began.elapsed().as_secs_f64() / done as f64)
    }

    /// Computes the point at a position into the columns of its row; gives back why something of it is missing or doubtful.
    ///
    /// # Errors
    /// [`StudyError::Interrupted`].
    pub(super) fn point(
        &self,
        position: &[usize],
        row: &mut [f64],
        progress: &dyn Progress,
    ) -> Result<Option<String>, StudyError> {
        let at = self.plan.values_at(position);
        for (column, value) in self.plan.columns.iter().zip(&mut *row) {
            if let Column::Key(k) = column {
                *value = at[*k];
            }
        }
        // a fault of ours at one point must not take the others with it
        let computed = catch_unwind(AssertUnwindSafe(|| match &self.way {
            Way::Inputs(set) => {
                let inputs = set.at(&at)?;
                self.operating_point(&set.contact, &inputs, row).map(|()| Told::default())
            }
            Way::Anew(prepared) => self.anew(prepared, &at, row, progress),
        }));
        match computed {
            Ok(Ok(told)) => Ok(told.reason()),
            // not of the point: another time it may be computed
            Ok(Err(error @ (StudyError::Interrupted | StudyError::Store(_)))) => Err(error),
            Ok(Err(error)) => Ok(Some(failed(&self.plan.columns, row, &told(&error)))),
            Err(panic) => Ok(Some(failed(&self.plan.columns, row, &panicked(&*panic)))),
        }
    }

    fn operating_point(
        &self,
        contact: &Contact,
        inputs: &OscillatorInputs,
        row: &mut [f64],
    ) -> Result<(), StudyError> {
        let state = PointState::new(contact, inputs)?;
        self.fill_points(row, |quantity| state.value(quantity));
        Ok(())
    }

    fn fill_points(&self, row: &mut [f64], of: impl Fn(&PointQuantity) -> f64) {
        for (column, value) in self.plan.columns.iter().zip(row) {
            if let Column::Point(quantity) = column {
                *value = of(quantity);
            }
        }
    }

    /// Reads the case anew and runs what the columns ask for; gives back what is missing or doubtful.
    fn anew(
        &self,
        prepared: &Prepared,
        at: &[f64],
        row: &mut [f64],
        progress: &dyn Progress,
    ) -> Result<Told, StudyError> {
        let file = self.plan.file.at(&self.plan.sweep, at)?;
        if self.plan.columns.iter().any(|column| matches!(column, Column::Point(_))) {
            self.point_of_case(&file.case, row, progress)?;
        }
        let mut outcomes: BTreeMap<usize, Outcome> = BTreeMap::new();
        let wanted = self.plan.analyses();
        if !wanted.is_empty() {
            let names: Vec<&str> = wanted.iter().map(|(_, name)| *name).collect();
            let paths: Vec<&str> = self.plan.sweep.axes.iter().map(|axis| axis.path.as_str()).collect();
            let prepared = door::check_at(&file, |name| names.contains(&name), (prepared, &paths))?;
            for (index, _) in wanted {
                let outcome = analyses::run_alone((&file.case, &prepared), index, &Within(progress))
                    .map_err(|error| door::placed(error, &file, index))?;
                outcomes.insert(index, outcome);
            }
        }
        let mut told = Told::default();
        for (column, value) in self.plan.columns.iter().zip(row) {
            let Column::Scalar { index, name, steps } = column else { continue };
            match outcomes.get(index).map(|outcome| number_at(&outcome.scalars, steps)) {
                Some(Ok(number)) => *value = number,
                Some(Err(reason)) => told.missing.push(format!("{name}: {reason}")),
                None => {}
            }
        }
        for (name, outcome) in self.plan.analyses().iter().map(|(_, name)| name).zip(outcomes.values()) {
            told.take(name, outcome);
        }
        Ok(told)
    }

    /// The quantities of the operating point of a case that was read anew.
    fn point_of_case(&self, case: &Case, row: &mut [f64], progress: &dyn Progress) -> Result<(), StudyError> {
        match case {
            Case::Oscillator(case) => {
                let case = bridge::with_material(case)?;
                let contact = bridge::contact(&case, NO_POINTS, &Within(progress))?.contact;
                self.operating_point(&contact, &case.inputs, row)
            }
            Case::TwoDegrees(case) => {
                let values = linear_values(case)?;
                self.fill_points(row, |quantity| values.of(quantity));
                Ok(())
            }
            // no quantity of other models gets through the plan
            _ => Ok(()),
        }
    }
}

impl SweepPlan {
    /// The analyses that are run at every point, by position and name.
    pub(super) fn analyses(&self) -> Vec<(usize, &str)> {
        let of = |column: &'_ Column| match column {
            Column::Scalar { index, .. } => Some(*index),
            _ => None,
        };
        let wanted: std::collections::BTreeSet<usize> = self.columns.iter().filter_map(of).collect();
        let name = |index: usize| {
            self.columns.iter().find_map(|column| match column {
                Column::Scalar { index: own, name, .. } if *own == index => Some(name.as_str()),
                _ => None,
            })
        };
        wanted.into_iter().filter_map(|index| Some((index, name(index)?))).collect()
    }
}

/// What is to be said of a point that has an outcome.
#[derive(Default)]
struct Told {
    /// Results that are not there: the point has failed, whatever else it has.
    missing: Vec<String>,
    /// Reasons to doubt those that are.
    doubts: Vec<String>,
}

impl Told {
    fn take(&mut self, name: &str, outcome: &Outcome) {
        if outcome.missing > 0 {
            self.missing.push(format!("{name}: {} of its results are missing", outcome.missing));
        }
        self.doubts.extend(outcome.checks.iter().filter(|check| !check.passed()).map(|check| {
            format!("{name}: check failed: {}: {:.1e}, at most {:.0e}", check.name, check.figure, check.limit)
        }));
        self.doubts.extend(outcome.warnings.iter().map(|warning| format!("{name}: {warning}")));
    }

    /// Why something of the point is missing, else why it is doubtful.
    fn reason(self) -> Option<String> {
        match (self.missing.is_empty(), self.doubts.is_empty()) {
            (true, true) => None,
            (true, false) => Some(format!("{DOUBTFUL}{}", self.doubts.join("; "))),
            (false, _) => Some(self.missing.join("; ")),
        }
    }
}

fn way(plan: &SweepPlan, progress: &dyn Progress) -> Result<Way, StudyError> {
    let only_points = plan.analyses().is_empty();
    if let (Case::Oscillator(case), Some(keys), true) = (&plan.file.case, &plan.sweep.oscillator, only_points)
        && stays(case, keys)
    {
        let contact = bridge::contact(case, NO_POINTS, &Within(progress))?.contact;
        let set = SetInputs { inputs: case.inputs, keys: keys.clone(), law: case.law, contact };
        return Ok(Way::Inputs(Box::new(set)));
    }
    let names: Vec<&str> = plan.analyses().iter().map(|(_, name)| *name).collect();
    Ok(Way::Anew(door::check(&plan.file, |name| names.contains(&name))?))
}

/// Whether law and material are the same at every point.
fn stays(case: &OscillatorCase, keys: &[(OscillatorKey, Form)]) -> bool {
    let of_substrate = |key: OscillatorKey| key.entry().section() == "substrate";
    let moves = keys.iter().any(|(key, _)| of_substrate(*key));
    case.substrate.decided_by().is_none() && !(moves && case.law == LawName::Bem)
}

/// The reason of a point without values; what was computed of it goes too.
fn failed(columns: &[Column], row: &mut [f64], reason: &str) -> String {
    for (column, value) in columns.iter().zip(row) {
        if !matches!(column, Column::Key(_)) {
            *value = f64::NAN;
        }
    }
    reason.to_owned()
}

/// An error in one line: where the file is to blame, what is wrong without the excerpt.
fn told(error: &StudyError) -> String {
    error.to_string().lines().next().unwrap_or_default().to_owned()
}

fn panicked(panic: &(dyn Any + Send)) -> String {
    let text = panic.downcast_ref::<&str>().copied();
    let text = text.or_else(|| panic.downcast_ref::<String>().map(String::as_str));
    format!("a fault of the program: {}", text.unwrap_or("it gave no reason"))
}

/// The progress of what runs within a point: it can be stopped, and tells nothing.
struct Within<'a>(&'a dyn Progress);

impl Progress for Within<'_> {
    fn begin(&self, _name: &str, _steps: usize) {}
    fn expect(&self, _steps: usize) {}
    fn advance(&self) {}
    fn end(&self) {}
    fn interrupted(&self) -> bool {
        self.0.interrupted()
    }
}
