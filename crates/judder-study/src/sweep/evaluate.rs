//! The points of a chunk.

use super::plan::{StoredColumn, SweepPlan};
use super::scalars::number_at;
use crate::analyses::run_alone;
use crate::error::StudyError;
use crate::fault::fault_told;
use crate::model::{OperatingPoints, OperatingQuantity, Prepared, placed};
use crate::outcome::{CheckRecord, Outcome};
use crate::progress::{Progress, Untold};
use judder_memory::{BeyondMemory, Crowded, MemoryBudget};
use judder_store::{PointFailure, StoredChunk};
use std::borrow::Cow;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::Instant;

/// How the reason of a point begins that has values which a check doubts.
pub(super) const DOUBTFUL: &str = "doubtful: ";

/// What came of some points.
pub(super) struct Tried {
    /// Of one of them, s.
    pub(super) seconds: f64,
    /// How many they are.
    pub(super) points: usize,
    /// Of those that failed, why.
    pub(super) reasons: Vec<String>,
}

/// Why something of a point is missing or doubtful, where it is.
type PointAnswer = Result<Option<String>, StudyError>;

/// Why a chunk was not computed to its end.
pub(super) enum ChunkStop {
    /// With fewer at once it can be.
    Crowded(Crowded),
    /// What went wrong.
    Failed(StudyError),
}

impl From<StudyError> for ChunkStop {
    fn from(error: StudyError) -> Self {
        Self::Failed(error)
    }
}

/// A plan, ready to compute points.
pub struct Evaluator<'a> {
    pub(super) plan: Cow<'a, SweepPlan>,
    way: EvaluationWay,
    /// The quantities of the operating point, in the order of their columns.
    wanted: Vec<OperatingQuantity>,
}

/// How the operating point comes about.
enum EvaluationWay {
    /// The points share what takes time to make.
    Shared(Box<dyn OperatingPoints>),
    /// The case is read anew; what it shares with the case of the file is taken from there.
    Anew(Prepared),
}

impl<'a> Evaluator<'a> {
    /// Makes what all points share.
    ///
    /// # Errors
    /// A case that cannot be prepared, a file of it that has changed, [`StudyError::Interrupted`].
    pub fn new(plan: &'a SweepPlan, progress: &dyn Progress) -> Result<Self, StudyError> {
        Self::made(Cow::Borrowed(plan), progress)
    }

    /// The same with a plan of its own.
    ///
    /// # Errors
    /// As of [`new`](Self::new).
    pub fn owned(plan: SweepPlan, progress: &dyn Progress) -> Result<Evaluator<'static>, StudyError> {
        Evaluator::made(Cow::Owned(plan), progress)
    }

    fn made(plan: Cow<'a, SweepPlan>, progress: &dyn Progress) -> Result<Self, StudyError> {
        let way = way(&plan, progress)?;
        // what was read just now is what the hash tells of
        plan.check_files()?;
        let wanted = plan.operating_quantities();
        Ok(Self { plan, way, wanted })
    }

    /// Computes all points of a chunk.
    ///
    /// # Errors
    /// [`StudyError::Interrupted`], a chunk that is not there, a file of the case that cannot be read or is another one than before.
    pub fn chunk(&self, chunk: usize, progress: &dyn Progress) -> Result<StoredChunk, StudyError> {
        self.chunk_of(chunk, progress, |point| point())
    }

    /// The same where so many chunks are computed at once, whose points share the memory of the process.
    ///
    /// # Errors
    /// As of [`chunk`](Self::chunk), and a point that needs more than its part.
    pub(super) fn chunk_among(
        &self,
        at_once: u64,
        chunk: usize,
        progress: &dyn Progress,
    ) -> Result<StoredChunk, ChunkStop> {
        // whichever thread was refused memory, this one puts the chunk off
        let note = |error: &StudyError| error.beyond_memory().into_iter().for_each(BeyondMemory::note);
        self.chunk_of(chunk, progress, |point| {
            let noted = || point().inspect_err(note);
            Ok(MemoryBudget::shared_or_crowded(at_once, noted).map_err(ChunkStop::Crowded)??)
        })
    }

    /// Computes all points of a chunk, each as `held` has it done.
    fn chunk_of<E: From<StudyError>>(
        &self,
        chunk: usize,
        progress: &dyn Progress,
        held: impl Fn(&mut dyn FnMut() -> PointAnswer) -> Result<Option<String>, E>,
    ) -> Result<StoredChunk, E> {
        let points = self.plan.layout().points(chunk).map_err(StudyError::from)?;
        let (count, width) = (points.count(), self.plan.columns.len());
        let mut values = vec![f64::NAN; count * width];
        let mut failures = Vec::new();
        for (index, row) in values.chunks_exact_mut(width).enumerate() {
            // asking takes longer than an operating point
            if (index % 64 == 0 || matches!(self.way, EvaluationWay::Anew(_))) && progress.interrupted() {
                return Err(StudyError::Interrupted.into());
            }
            if let Some(reason) = held(&mut || self.point(&points.position(index), row, progress))? {
                failures.push(PointFailure { index, reason });
            }
        }
        if let EvaluationWay::Anew(_) = self.way {
            self.plan.check_files()?;
        }
        Ok(StoredChunk { values, failures })
    }

    /// Computes points evenly over the sweep, as many as fit into a while.
    ///
    /// # Errors
    /// [`StudyError::Interrupted`].
    pub(super) fn tried(&self, progress: &dyn Progress) -> Result<Tried, StudyError> {
        /// As many as are tried, and how long (s).
        const TRIED: usize = 1000;
        const WHILE: f64 = 0.5;
        let lengths = self.plan.layout().dimensions();
        let began = Instant::now();
        let mut row = vec![f64::NAN; self.plan.columns.len()];
        let (mut done, mut reasons) = (0, Vec::new());
        while done < TRIED && (done == 0 || began.elapsed().as_secs_f64() < WHILE) {
            // along the diagonal of the grid
            let part = (done as f64 * 0.618_033_988_749_895).fract();
            let position: Vec<usize> =
                lengths.iter().map(|dimension| (part * dimension.length as f64) as usize).collect();
            let reason = self.point(&position, &mut row, progress)?;
            reasons.extend(reason.filter(|reason| !reason.starts_with(DOUBTFUL)));
            done += 1;
        }
        Ok(Tried { seconds: began.elapsed().as_secs_f64() / done as f64, points: done, reasons })
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
            if let StoredColumn::Key(k) = column {
                *value = at[*k];
            }
        }
        // a fault of ours at one point must not take the others with it
        let computed = catch_unwind(AssertUnwindSafe(|| match &self.way {
            EvaluationWay::Shared(points) => {
                self.fill_points(row, points.at(&at, &self.wanted)?);
                Ok(ToldOutcome::default())
            }
            EvaluationWay::Anew(prepared) => self.anew(prepared, &at, row, progress),
        }));
        match computed {
            Ok(Ok(told)) => Ok(told.reason()),
            Ok(Err(error)) if is_passing(&error) => Err(error),
            Ok(Err(error)) => Ok(Some(failed(&self.plan.columns, row, &told(&error)))),
            Err(panic) => Ok(Some(failed(&self.plan.columns, row, &fault_told(&*panic)))),
        }
    }

    fn fill_points(&self, row: &mut [f64], values: Vec<f64>) {
        let columns = self.plan.columns.iter().zip(row);
        let of_point = columns.filter(|(column, _)| matches!(column, StoredColumn::Point(_)));
        of_point.zip(values).for_each(|((_, place), value)| *place = value);
    }

    /// Reads the case anew and runs what the columns ask for; gives back what is missing or doubtful.
    fn anew(
        &self,
        prepared: &Prepared,
        at: &[f64],
        row: &mut [f64],
        progress: &dyn Progress,
    ) -> Result<ToldOutcome, StudyError> {
        let file = self.plan.file.at(&self.plan.sweep, at)?;
        let mut told = ToldOutcome::default();
        if !self.wanted.is_empty() {
            let (values, doubts) = file.case.operating_point(&self.wanted, &Untold(progress))?;
            self.fill_points(row, values);
            told.doubts = doubts;
        }
        let wanted = self.plan.analyses();
        if wanted.is_empty() {
            return Ok(told);
        }
        let names: Vec<&str> = wanted.iter().map(|(_, name)| *name).collect();
        let paths: Vec<&str> = self.plan.sweep.axes.iter().map(|axis| axis.path.as_str()).collect();
        let prepared = file.case.preflight_at(&file, &|name| names.contains(&name), prepared, &paths)?;
        for (index, name) in wanted {
            match run_alone(&file.case, &prepared, index, &Untold(progress)) {
                Ok(outcome) => self.fill_scalars(index, name, &outcome, row, &mut told),
                Err(error) if is_passing(&error) => return Err(error),
                // the quantities of the others stand
                Err(error) => {
                    told.missing
                        .push(format!("{name}: {}", self::told(&placed(error, &*file.case, &file, index))));
                }
            }
        }
        Ok(told)
    }

    /// Takes the numbers out of the results of an analysis, and what is to be said of them.
    fn fill_scalars(
        &self,
        own: usize,
        name: &str,
        outcome: &Outcome,
        row: &mut [f64],
        told: &mut ToldOutcome,
    ) {
        for (column, value) in self.plan.columns.iter().zip(row) {
            let StoredColumn::Scalar { index, steps, .. } = column else { continue };
            if *index == own {
                match number_at(&outcome.scalars, steps) {
                    Ok(number) => *value = number,
                    Err(reason) => told.missing.push(format!("{name}: {reason}")),
                }
            }
        }
        told.take(name, outcome);
    }
}

impl SweepPlan {
    /// The analyses that are run at every point, by position and name.
    pub(super) fn analyses(&self) -> Vec<(usize, &str)> {
        let of = |column: &'_ StoredColumn| match column {
            StoredColumn::Scalar { index, .. } => Some(*index),
            _ => None,
        };
        let wanted: std::collections::BTreeSet<usize> = self.columns.iter().filter_map(of).collect();
        let name = |index: usize| {
            self.columns.iter().find_map(|column| match column {
                StoredColumn::Scalar { index: own, name, .. } if *own == index => Some(name.as_str()),
                _ => None,
            })
        };
        wanted.into_iter().filter_map(|index| Some((index, name(index)?))).collect()
    }
}

/// What is to be said of a point that has an outcome.
#[derive(Default)]
struct ToldOutcome {
    /// Results that are not there: the point has failed, whatever else it has.
    missing: Vec<String>,
    /// Reasons to doubt those that are.
    doubts: Vec<String>,
}

impl ToldOutcome {
    fn take(&mut self, name: &str, outcome: &Outcome) {
        if outcome.missing > 0 {
            self.missing.push(format!("{name}: {} of its results are missing", outcome.missing));
        }
        let failures = outcome.checks.iter().filter_map(CheckRecord::failure);
        self.doubts.extend(failures.map(|failure| format!("{name}: {failure}")));
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

fn way(plan: &SweepPlan, progress: &dyn Progress) -> Result<EvaluationWay, StudyError> {
    let model = &plan.file.case;
    if plan.analyses().is_empty()
        && let Some(points) = model.operating_points(&plan.sweep, &Untold(progress))?
    {
        return Ok(EvaluationWay::Shared(points));
    }
    let names: Vec<&str> = plan.analyses().iter().map(|(_, name)| *name).collect();
    Ok(EvaluationWay::Anew(model.preflight(&plan.file, &|name| names.contains(&name))?))
}

/// Whether an error is not of the point: another time, or with more memory, it may be computed.
fn is_passing(error: &StudyError) -> bool {
    let is_of_machine = matches!(
        error,
        StudyError::Interrupted
            | StudyError::Store(_)
            | StudyError::Unreadable { .. }
            | StudyError::FileChanged { .. }
    );
    is_of_machine || error.beyond_memory().is_some()
}

/// The reason of a point without values; what was computed of it goes too.
fn failed(columns: &[StoredColumn], row: &mut [f64], reason: &str) -> String {
    for (column, value) in columns.iter().zip(row) {
        if !matches!(column, StoredColumn::Key(_)) {
            *value = f64::NAN;
        }
    }
    reason.to_owned()
}

/// An error in one line: where the file is to blame, what is wrong without the excerpt. Where a file lies is no matter of the point, and
/// may differ from worker to worker.
fn told(error: &StudyError) -> String {
    if let StudyError::File { path, reason } = error {
        return format!("{}: {reason}", path.file_name().unwrap_or_default().to_string_lossy());
    }
    error.to_string().lines().next().unwrap_or_default().to_owned()
}
