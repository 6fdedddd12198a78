//! A finished sweep as an outcome: what its summary says, its table, what the user has to know. Every chunk is read once.

use super::evaluate::DOUBTFUL;
use super::indices::indices;
use super::plan::{StoredColumn, SweepPlan};
use super::probabilities::ConditionCount;
use super::statistics::ColumnStatistics;
use crate::error::StudyError;
use crate::outcome::Outcome;
use crate::progress::Progress;
use judder_numerics::words::plain;
use judder_store::{ChunkFile, StoreError, StoredChunk, SweepChunks, Table};
use rayon::prelude::*;
use serde_json::{Map, Value, json};
use std::collections::BTreeMap;

/// Failures that the summary shows one by one.
const SHOWN: usize = 20;
/// The most points that become a table.
const ROWS: usize = 100_000;

/// Chunks that are read at a time, at most, and the bytes of their values.
const READ_AT_A_TIME: usize = 1024;
const BYTES_AT_A_TIME: usize = 1 << 28;

/// All chunks of a sweep, each read once.
pub(crate) struct SweepReading<'a> {
    chunks: ChunkReading<'a>,
    /// What the list of the study has of their files.
    pub(crate) files: Vec<ChunkFile>,
}

/// What came of reading all chunks.
pub(crate) enum ReadChunks<'a> {
    Whole(SweepReading<'a>),
    /// These are not as they were written, and what is wrong with the first.
    Damaged(Vec<usize>, StoreError),
}

/// Reads all chunks of a sweep, on all cores, and takes them in one after the other.
///
/// # Errors
/// A chunk that is missing or of another case, failures of the file system, [`StudyError::Interrupted`].
pub(crate) fn read<'a>(
    plan: &'a SweepPlan,
    store: &SweepChunks,
    progress: &dyn Progress,
) -> Result<ReadChunks<'a>, StudyError> {
    let layout = plan.layout();
    progress.begin(&format!("{}, summary", layout.name()), layout.chunk_count());
    let read = read_in_order(plan, store, progress);
    progress.end();
    read
}

fn read_in_order<'a>(
    plan: &'a SweepPlan,
    store: &SweepChunks,
    progress: &dyn Progress,
) -> Result<ReadChunks<'a>, StudyError> {
    let count = plan.layout().chunk_count();
    let (mut chunks, mut files) = (ChunkReading::new(plan), Vec::with_capacity(count));
    let (mut damaged, mut first_damage) = (Vec::new(), None);
    let bytes = plan.layout().points(0)?.count() * plan.layout().quantities().len() * size_of::<f64>();
    let stretch = (BYTES_AT_A_TIME / bytes.max(1)).clamp(1, READ_AT_A_TIME);
    for first in (0..count).step_by(stretch) {
        let stretch: Vec<_> = (first..count.min(first + stretch))
            .into_par_iter()
            .map(|chunk| progress.go_on().map(|()| (chunk, store.read_to_list(chunk))))
            .collect::<Result<_, _>>()?;
        for (chunk, content) in stretch {
            match content {
                Ok((content, file)) => {
                    chunks.take(chunk, &content)?;
                    files.push(file);
                }
                Err(error @ StoreError::DamagedChunk { .. }) => {
                    damaged.push(chunk);
                    first_damage.get_or_insert(error);
                }
                Err(error) => return Err(error.into()),
            }
            progress.advance();
        }
    }
    Ok(match first_damage {
        None => ReadChunks::Whole(SweepReading { chunks, files }),
        Some(first) => ReadChunks::Damaged(damaged, first),
    })
}

impl SweepReading<'_> {
    /// What the sweep says.
    ///
    /// # Errors
    /// [`StudyError::Interrupted`], a table that cannot be.
    pub(crate) fn outcome(self, plan: &SweepPlan, progress: &dyn Progress) -> Result<Outcome, StudyError> {
        let law = told_of_law(plan, progress)?;
        let mut outcome = self.chunks.outcome(progress)?;
        outcome.warnings.extend(law);
        Ok(outcome)
    }
}

/// The chunks of a sweep as they are taken in, one after the other.
struct ChunkReading<'a> {
    plan: &'a SweepPlan,
    columns: Vec<ColumnStatistics>,
    conditions: Vec<ConditionCount>,
    failed: usize,
    doubtful: usize,
    shown: Vec<Value>,
    /// The values of all columns, where sensitivity or a table needs them.
    kept: Vec<Vec<f64>>,
    /// The values of the keys, where a table needs them and the columns do not have them.
    keys: Vec<Vec<f64>>,
}

impl<'a> ChunkReading<'a> {
    fn new(plan: &'a SweepPlan) -> Self {
        let quantities = plan.layout().quantities();
        let columns = quantities.iter().map(ColumnStatistics::new).collect();
        let (kept, keys) = (vec![Vec::new(); quantities.len()], vec![Vec::new(); plan.sweep().axes.len()]);
        let conditions = ConditionCount::all(plan);
        Self { plan, columns, conditions, failed: 0, doubtful: 0, shown: Vec::new(), kept, keys }
    }

    fn has_table(&self) -> bool {
        self.plan.sweep().points() <= ROWS as u64
    }

    fn take(&mut self, chunk: usize, content: &StoredChunk) -> Result<(), StudyError> {
        let points = self.plan.layout().points(chunk)?;
        let keeps = self.has_table() || self.plan.sweep().sensitivity.is_some();
        for row in content.values.chunks_exact(self.columns.len()) {
            for ((statistics, kept), value) in self.columns.iter_mut().zip(&mut self.kept).zip(row) {
                statistics.take(*value);
                if keeps {
                    kept.push(*value);
                }
            }
        }
        if !self.conditions.is_empty() {
            let failed = content.failures.iter().filter(|own| !own.reason.starts_with(DOUBTFUL));
            let failed: BTreeMap<usize, &str> = failed.map(|own| (own.index, own.reason.as_str())).collect();
            let row = self.plan.sweep().row();
            for (index, values) in content.values.chunks_exact(self.columns.len()).enumerate() {
                let place = (self.plan.number(&points.position(index)) % row, row);
                let failure = failed.get(&index).copied();
                self.conditions.iter_mut().for_each(|own| own.take(place, values, failure));
            }
        }
        if self.has_table() {
            for index in 0..points.count() {
                let values = self.plan.values_at(&points.position(index));
                for (key, value) in self.keys.iter_mut().zip(values) {
                    key.push(value);
                }
            }
        }
        for failure in &content.failures {
            let is_doubtful = failure.reason.starts_with(DOUBTFUL);
            *(if is_doubtful { &mut self.doubtful } else { &mut self.failed }) += 1;
            if self.shown.len() < SHOWN {
                let values = self.plan.values_at(&points.position(failure.index));
                let axes = &self.plan.sweep().axes;
                let at: Map<String, Value> =
                    axes.iter().zip(values).map(|(axis, value)| (axis.path.clone(), json!(value))).collect();
                self.shown.push(json!({ "at": at, "reason": failure.reason }));
            }
        }
        Ok(())
    }

    fn outcome(self, progress: &dyn Progress) -> Result<Outcome, StudyError> {
        let (layout, sweep) = (self.plan.layout(), self.plan.sweep());
        let mut warnings = self.warnings();
        let statistics: Map<String, Value> = layout
            .quantities()
            .iter()
            .zip(&self.columns)
            .zip(&self.plan.columns)
            .filter(|(_, column)| !matches!(column, StoredColumn::Key(_)))
            .map(|((quantity, statistics), _)| (quantity.name.clone(), statistics.told(quantity)))
            .collect();
        let mut scalars = Map::new();
        scalars.insert("points".to_owned(), json!(sweep.points()));
        scalars.insert("chunks".to_owned(), json!(layout.chunk_count()));
        scalars.insert("failed".to_owned(), json!(self.failed));
        scalars.insert("doubtful".to_owned(), json!(self.doubtful));
        scalars.insert("quantities".to_owned(), Value::Object(statistics));
        if !self.conditions.is_empty() {
            let told: Vec<Value> = self.conditions.iter().map(|own| own.told(self.plan)).collect();
            scalars.insert("probabilities".to_owned(), Value::Array(told));
        }
        if sweep.sensitivity.is_some() {
            let (told, missed) = self.sensitivity(progress)?;
            scalars.insert("sensitivity".to_owned(), Value::Object(told));
            warnings.extend(missed);
        }
        scalars.insert("failures".to_owned(), json!(self.shown));
        let table = if self.has_table() { Some(self.table()?) } else { None };
        Ok(Outcome { scalars, is_stored: true, table, warnings, missing: self.failed, ..Outcome::default() })
    }

    fn warnings(&self) -> Vec<String> {
        let points = self.plan.sweep().points();
        let of = |count: usize, what: &str| {
            (count > 0).then(|| {
                let first = self.shown.iter().find(|own| {
                    let reason = own["reason"].as_str().unwrap_or_default();
                    reason.starts_with(DOUBTFUL) == (what == "are doubtful")
                });
                let first = first.map(|own| {
                    format!(
                        "; the first at {}: {}",
                        place(&own["at"]),
                        own["reason"].as_str().unwrap_or_default()
                    )
                });
                format!("{count} of {points} points {what}{}", first.unwrap_or_default())
            })
        };
        [of(self.failed, "failed"), of(self.doubtful, "are doubtful")].into_iter().flatten().collect()
    }

    /// The indices of every quantity that is a number, and why some have none.
    fn sensitivity(&self, progress: &dyn Progress) -> Result<(Map<String, Value>, Vec<String>), StudyError> {
        let (mut told, mut missed) = (Map::new(), Vec::new());
        let columns = self.plan.layout().quantities().iter().zip(&self.plan.columns).zip(&self.kept);
        // codes have no mean
        let numbers = columns
            .filter(|((quantity, column), _)| {
                !matches!(column, StoredColumn::Key(_)) && quantity.flags.is_empty()
            })
            .map(|((quantity, _), values)| (quantity.name.clone(), values.as_slice()));
        let conditions =
            self.conditions.iter().filter_map(|own| Some((own.words(self.plan), own.indicator()?)));
        for (name, values) in numbers.chain(conditions) {
            if progress.interrupted() {
                return Err(StudyError::Interrupted);
            }
            let found = indices(self.plan, values).unwrap_or_else(|reason| {
                missed.push(format!("no sensitivity of {name}: {reason}"));
                Value::Null
            });
            // a condition that a quantity is so has the name of that
            told.entry(name).or_insert(found);
        }
        Ok((told, missed))
    }

    fn table(&self) -> Result<Table, StudyError> {
        let mut table = Table::new();
        for (k, values) in self.keys.iter().enumerate() {
            let quantity = self.plan.key(k);
            table = table.column(&quantity.name, &quantity.unit, values.clone())?;
        }
        let columns = self.plan.layout().quantities().iter().zip(&self.plan.columns).zip(&self.kept);
        for ((quantity, column), values) in columns {
            if !matches!(column, StoredColumn::Key(_)) {
                table = table.column(&quantity.name, &quantity.units, values.clone())?;
            }
        }
        Ok(table)
    }
}

/// The values of the swept keys at a point, in words.
fn place(at: &Value) -> String {
    let values = at.as_object().into_iter().flatten();
    let words: Vec<String> = values
        .map(|(key, value)| format!("{key} = {}", value.as_f64().map_or_else(|| value.to_string(), plain)))
        .collect();
    words.join(", ")
}

/// What a finished sweep has to say of the law of its operating points.
fn told_of_law(plan: &SweepPlan, progress: &dyn Progress) -> Result<Vec<String>, StudyError> {
    let model = &plan.file.case;
    if plan.analyses().is_empty()
        && let Some(points) = model.operating_points(&plan.sweep, progress)?
    {
        return points.told(&plan.sweep);
    }
    let at = |values: &[f64]| plan.file.at(&plan.sweep, values).ok().map(|file| file.case);
    Ok(model.told_of_sweep(&plan.sweep, &at).into_iter().collect())
}
