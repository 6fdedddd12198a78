//! What a sweep stores, under which hash, in which chunks.

use crate::axis::SweptAxis;
use crate::case::file::CaseFile;
use crate::case::scale::Spacing;
use crate::case::study_sweep::quantity_path::{QuantityPath, QuantitySource, QuantityStep};
use crate::case::study_sweep::{Design, StudySweep, SweptKey, SweptValues};
use crate::error::StudyError;
use crate::input_file::KnownFile;
use crate::labels;
use crate::model::{OperatingQuantity, OperatingWork};
use crate::version::version;
use judder_memory::MemoryBudget;
use judder_store::{SweepDimension, SweepLayout, SweepQuantity, Variable};
use std::sync::Arc;

/// The most points of a chunk where the case does not say, when only the operating point is asked for: a fraction of a second.
const POINTS_OF_POINTS: u64 = 1 << 17;
/// The same where thresholds are sought, or the case is read anew, at every point.
const POINTS_OF_SEARCHES: u64 = 1 << 12;
/// The same where analyses are run at every point.
const POINTS_OF_ANALYSES: u64 = 64;
/// Into how many chunks a small sweep is cut, so that there is work for every thread.
const PARTS: u64 = 16;
/// The most chunks that a sweep is cut into where the case does not say: each is a file, and all lie in one folder.
const MOST_CHUNKS: u64 = 1 << 16;
/// Bytes of values that a chunk may have for that.
const MOST_BYTES: u64 = 1 << 26;
/// From so many files on many file systems take a folder badly.
const MANY_FILES: usize = 200_000;
/// Fewer operating points than this are not worth a file, fewer searches than a part of it.
const FEWEST: u64 = 1 << 12;
const FEWEST_SEARCHES: u64 = 1 << 8;

/// Bytes that a value of a key of a grid takes: as it is computed, as a coordinate, and as that is written.
const VALUE_BYTES: u128 = 24;

/// Bytes that a value takes of which sensitivities are found: as it is kept, and the copies of one quantity at a time, which count as one quantity more. Measured of two
/// quantities at 2 097 152 points 19.
const SENSITIVITY_BYTES: u128 = 20;

/// What one column of the stored values is.
#[derive(Debug, Clone)]
pub(super) enum StoredColumn {
    /// The value of a swept key, by its position.
    Key(usize),
    /// A quantity of the operating point.
    Point(OperatingQuantity),
    /// A scalar of an analysis, by the position of the analysis in the case.
    Scalar { index: usize, name: String, steps: Vec<QuantityStep>, unit: String },
}

/// A sweep of a case with the layout of its results.
#[derive(Debug, Clone)]
pub struct SweepPlan {
    /// Shared by all plans of a case: it has all sweeps.
    pub(super) file: Arc<CaseFile>,
    pub(super) sweep: StudySweep,
    pub(super) columns: Vec<StoredColumn>,
    layout: SweepLayout,
    /// The files of the case, as they are in the hash.
    files: Vec<KnownFile>,
}

impl SweepPlan {
    /// The plan of a sweep of a case; `hash` names all that its values depend on, `files` is what of it is read again.
    ///
    /// # Errors
    /// A sweep that cannot be stored.
    pub(crate) fn new(
        file: &Arc<CaseFile>,
        sweep: &StudySweep,
        hash: &str,
        files: &[KnownFile],
    ) -> Result<Self, StudyError> {
        check_memory(sweep, MemoryBudget::of_process())?;
        // a grid has its keys as dimensions
        let keys = if sweep.method == Design::Grid { 0 } else { sweep.axes.len() };
        let mut columns: Vec<StoredColumn> = (0..keys).map(StoredColumn::Key).collect();
        columns.extend(sweep.quantities.iter().map(column));
        let layout = layout(file, sweep, &columns, hash)?;
        Ok(Self { file: Arc::clone(file), sweep: sweep.clone(), columns, layout, files: files.to_vec() })
    }

    /// The case that is swept.
    #[must_use]
    pub fn file(&self) -> &CaseFile {
        &self.file
    }

    /// The sweep.
    #[must_use]
    pub fn sweep(&self) -> &StudySweep {
        &self.sweep
    }

    /// How its results are stored.
    #[must_use]
    pub fn layout(&self) -> &SweepLayout {
        &self.layout
    }

    /// The quantities of the operating point that it asks for.
    pub(super) fn operating_quantities(&self) -> Vec<OperatingQuantity> {
        operating_quantities(&self.columns)
    }

    /// Refuses to go on where a file of the case is not what it was: the hash would tell of another one.
    ///
    /// # Errors
    /// [`StudyError::FileChanged`], [`StudyError::Unreadable`].
    pub(super) fn check_files(&self) -> Result<(), StudyError> {
        self.files.iter().try_for_each(KnownFile::check)
    }

    /// The number of a point in the whole sweep, from its position along each dimension.
    pub(super) fn number(&self, position: &[usize]) -> u64 {
        let lengths = self.layout.dimensions().iter().map(|dimension| dimension.length);
        position.iter().zip(lengths).fold(0, |sum, (at, length)| sum * length as u64 + *at as u64)
    }

    /// The values of the swept keys at a position.
    pub(super) fn values_at(&self, position: &[usize]) -> Vec<f64> {
        self.sweep.values_of(self.number(position))
    }

    /// What to do about more chunks than a folder takes well; `None` where they are fewer.
    pub(crate) fn advice(&self) -> Option<String> {
        let count = self.layout.chunk_count();
        (count > MANY_FILES).then(|| {
            format!("{count} chunks are as many files in one folder, which many file systems take badly: ask for a larger `chunk`")
        })
    }

    /// How a swept key is called.
    pub(super) fn key(&self, k: usize) -> labels::SweptQuantity {
        label(&self.file, &self.sweep, k)
    }
}

/// Whether the values of the keys of a grid, which its results are told by, fit into memory, or those of all quantities that a sensitivity is found from.
fn check_memory(sweep: &StudySweep, budget: MemoryBudget) -> Result<(), StudyError> {
    if sweep.method != Design::Grid {
        if sweep.sensitivity.is_none() {
            return Ok(());
        }
        let (points, quantities) = (u128::from(sweep.points()), sweep.quantities.len() as u128);
        return budget.ask(points * (quantities + 1) * SENSITIVITY_BYTES).map_err(|source| {
            let what = format!(
                "the sensitivities of {quantities} quantities at {points} points of the sweep `{}`",
                sweep.name
            );
            StudyError::Memory { what, source }
        });
    }
    let values = grid_values(sweep);
    budget.ask(values * VALUE_BYTES).map_err(|source| {
        let what = format!("the {values} values of the keys of the sweep `{}`", sweep.name);
        StudyError::Memory { what, source }
    })
}

/// Refuses sweeps whose plans, which are made all at once, fit into memory by themselves only.
pub(crate) fn check_together(sweeps: &[&StudySweep]) -> Result<(), StudyError> {
    let grids: Vec<_> = sweeps.iter().filter(|sweep| sweep.method == Design::Grid).collect();
    let values: u128 = grids.iter().map(|sweep| grid_values(sweep)).sum();
    let asked = if grids.len() > 1 { values * VALUE_BYTES } else { 0 };
    MemoryBudget::of_process().ask(asked).map_err(|source| {
        let what = format!("the {values} values of the keys of {} sweeps", grids.len());
        StudyError::Memory { what, source }
    })
}

/// How many values the keys of a grid have.
fn grid_values(sweep: &StudySweep) -> u128 {
    sweep.axes.iter().filter_map(SweptKey::count).map(u128::from).sum()
}

fn column(quantity: &QuantityPath) -> StoredColumn {
    match &quantity.source {
        QuantitySource::Analysis { index, name, steps, unit } => {
            let (name, steps, unit) = (name.clone(), steps.clone(), unit.clone());
            StoredColumn::Scalar { index: *index, name, steps, unit }
        }
        QuantitySource::Point { quantity } => StoredColumn::Point(*quantity),
    }
}

fn layout(
    file: &CaseFile,
    sweep: &StudySweep,
    columns: &[StoredColumn],
    hash: &str,
) -> Result<SweepLayout, StudyError> {
    let shape: Vec<usize> = sweep.shape().iter().map(|length| *length as usize).collect();
    let chunk = chunk_shape(&shape, target(file, sweep, columns));
    let named = sweep.dimensions().into_iter().map(str::to_owned);
    let dimensions = named
        .zip(shape.iter().zip(&chunk))
        .map(|(name, (length, chunk))| SweepDimension { name, length: *length, chunk: *chunk })
        .collect();
    let asked = sweep.quantities.iter().map(|quantity| quantity.text.as_str());
    let keys = columns.len() - sweep.quantities.len();
    let texts = (0..keys).map(|k| sweep.axes[k].path.as_str()).chain(asked);
    let quantities =
        columns.iter().zip(texts).map(|(column, text)| described(file, sweep, column, text)).collect();
    let mut layout = SweepLayout::new(&sweep.name, hash, dimensions, quantities)?
        .attribute("kind", "sweep")?
        .build(version())?
        .attribute("method", sweep.method.name())?
        .attribute("keys", sweep.axes.iter().map(|axis| axis.path.clone()).collect::<Vec<_>>())?
        .attribute(
            "key_labels",
            (0..sweep.axes.len()).map(|k| label(file, sweep, k).label).collect::<Vec<_>>(),
        )?
        .attribute("scales", sweep.axes.iter().map(|axis| axis.scale.name()).collect::<Vec<_>>())?;
    if let Some(seed) = sweep.method.seed() {
        layout = layout.attribute("seed", seed)?;
    }
    if sweep.method == Design::Grid {
        for k in 0..sweep.axes.len() {
            layout = layout.with(coordinate(file, sweep, k))?;
        }
    }
    Ok(layout)
}

/// The points that a chunk should have: decided by the case alone, so that every process cuts alike.
fn target(file: &CaseFile, sweep: &StudySweep, columns: &[StoredColumn]) -> usize {
    let within = points_of_a_chunk(file, sweep, columns);
    let points = sweep.chunk.unwrap_or(chosen_points(sweep.points(), columns.len(), within) as usize).max(1);
    points.next_multiple_of(sweep.row() as usize)
}

/// The points of a chunk where the case does not say: a part of the whole, between the fewest and the most, and more where there were too many chunks.
fn chosen_points(all: u64, columns: usize, [fewest, most]: [u64; 2]) -> u64 {
    let row = (columns.max(1) * size_of::<f64>()) as u64;
    let for_fewer_chunks = all.div_ceil(MOST_CHUNKS).min(MOST_BYTES / row);
    all.div_ceil(PARTS).clamp(fewest, most).max(for_fewer_chunks)
}

/// The fewest and the most points that a chunk should have, by what a point takes.
fn points_of_a_chunk(file: &CaseFile, sweep: &StudySweep, columns: &[StoredColumn]) -> [u64; 2] {
    if columns.iter().any(|column| matches!(column, StoredColumn::Scalar { .. })) {
        return [1, POINTS_OF_ANALYSES];
    }
    match file.case.operating_work(sweep, &operating_quantities(columns)) {
        OperatingWork::Law => [1, 1],
        OperatingWork::Search => [FEWEST_SEARCHES, POINTS_OF_SEARCHES],
        OperatingWork::Point => [FEWEST, POINTS_OF_POINTS],
    }
}

/// The quantities of the operating point among columns, in their order.
fn operating_quantities(columns: &[StoredColumn]) -> Vec<OperatingQuantity> {
    let of = |column: &StoredColumn| match column {
        StoredColumn::Point(quantity) => Some(*quantity),
        _ => None,
    };
    columns.iter().filter_map(of).collect()
}

/// The last dimensions whole, as many as go into `target` points, and a part of the one before them.
fn chunk_shape(shape: &[usize], target: usize) -> Vec<usize> {
    let mut left = target.max(1);
    let mut chunk: Vec<usize> = shape
        .iter()
        .rev()
        .map(|length| {
            let taken = left.min(*length).max(1);
            left /= taken;
            taken
        })
        .collect();
    chunk.reverse();
    chunk
}

/// A column as the store describes it.
fn described(file: &CaseFile, sweep: &StudySweep, column: &StoredColumn, text: &str) -> SweepQuantity {
    match column {
        StoredColumn::Key(k) => {
            let quantity = label(file, sweep, *k);
            SweepQuantity::new(text, &quantity.unit, &labels::plain(&quantity.label))
        }
        StoredColumn::Point(own) => {
            let codes: Vec<(u8, &str)> = (0..).zip(own.flags.iter().copied()).collect();
            SweepQuantity::new(text, own.units, own.long_name).flags(&codes)
        }
        StoredColumn::Scalar { name, unit, .. } => SweepQuantity::new(
            text,
            unit,
            &format!("{} of `{name}`", text[name.len() + 1..].replace('_', " ")),
        ),
    }
}

/// How a swept key is called.
fn label(file: &CaseFile, sweep: &StudySweep, k: usize) -> labels::SweptQuantity {
    let key = &sweep.axes[k];
    if sweep.is_set { file.case.swept_label(key) } else { labels::any_key(&key.path, key.dimension) }
}

/// The coordinate of a dimension of a grid.
fn coordinate(file: &CaseFile, sweep: &StudySweep, k: usize) -> Variable {
    let axis = &sweep.axes[k];
    let count = axis.count().unwrap_or(0);
    let values: Vec<f64> = (0..count).map(|index| axis.value(index)).collect();
    let scale = match axis.values {
        SweptValues::Listed(_) => Spacing::Linear,
        _ => axis.scale,
    };
    SweptAxis { quantity: label(file, sweep, k), values, scale, shown: None }.coordinate()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sweep_is_cut_into_no_more_chunks_than_a_folder_takes() {
        let of_analyses = [1, POINTS_OF_ANALYSES];
        assert_eq!(chosen_points(10, 2, of_analyses), 1);
        assert_eq!(chosen_points(1_000_000, 2, of_analyses), 64);
        let many = chosen_points(1_000_000_000, 2, of_analyses);
        assert!(1_000_000_000_u64.div_ceil(many) <= MOST_CHUNKS, "{many}");
        assert_eq!(chosen_points(1_000_000, 2, [1, 1]), 16, "laws, too");
        let most = chosen_points(1_000_000_000_000, 100, of_analyses);
        assert_eq!(most, MOST_BYTES / 800, "a chunk is in memory as a whole");
    }

    #[test]
    fn chunks_take_the_last_dimensions_whole() {
        assert_eq!(chunk_shape(&[1000, 400], 1 << 17), [327, 400]);
        assert_eq!(chunk_shape(&[10, 20, 30], 64), [1, 2, 30]);
        assert_eq!(chunk_shape(&[10, 20, 30], 1), [1, 1, 1]);
        assert_eq!(chunk_shape(&[5], 64), [5]);
    }
}
