//! A finished sweep as an outcome: what its summary says, its table, what the user has to know.

use super::evaluate::DOUBTFUL;
use super::indices::indices;
use super::plan::{StoredColumn, SweepPlan};
use super::probabilities::ConditionCount;
use super::statistics::ColumnStatistics;
use crate::error::StudyError;
use crate::outcome::Outcome;
use crate::progress::Progress;
use judder_numerics::words::plain;
use judder_store::{StoredChunk, SweepStore, Table};
use serde_json::{Map, Value, json};
use std::collections::BTreeMap;

/// Failures that the summary shows one by one.
const SHOWN: usize = 20;
/// The most points that become a table.
const ROWS: usize = 100_000;

/// What a sweep says whose chunks are all there.
///
/// # Errors
/// A chunk that is missing or cannot be read, [`StudyError::Interrupted`].
pub(crate) fn finish(
    plan: &SweepPlan,
    store: &SweepStore,
    progress: &dyn Progress,
) -> Result<Outcome, StudyError> {
    let law = told_of_law(plan, progress)?;
    let mut read = ChunkReading::new(plan);
    let chunks = plan.layout().chunk_count();
    progress.begin(&format!("{}, summary", plan.layout().name()), chunks);
    let taken = (0..chunks).try_for_each(|chunk| {
        if progress.interrupted() {
            return Err(StudyError::Interrupted);
        }
        read.take(chunk, &store.read(chunk)?)?;
        progress.advance();
        Ok(())
    });
    progress.end();
    taken?;
    let mut outcome = read.outcome(progress)?;
    outcome.warnings.extend(law);
    Ok(outcome)
}

/// The chunks of a sweep as they are read, one after the other.
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
                let unit = if quantity.units.is_empty() { "1" } else { &quantity.units };
                table = table.column(&quantity.name, unit, values.clone())?;
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
