//! A study folder for a page: what it holds, and parts of its arrays. The folder is not held, and nothing outside of it is read.

mod extremes;
mod reported;
mod shown_text;

pub use reported::ReportedAnalysis;
pub use shown_text::shown_text;

use crate::case::file::CaseFile;
use crate::error::StudyError;
use crate::ledger::Keepsakes;
use crate::progress::Progress;
use crate::registry::Registry;
use crate::report;
use extremes::BinnedExtremes;
use judder_memory::MemoryBudget;
use judder_store::{CheckedFile, Status, StudyReader, Summary, Variable};
use serde_json::{Map, Value};
use shown_text::{shown_table, shown_texts, shown_variable};
use std::ops::Range;
use std::path::Path;

/// Values of a variable that are read at once at most; of more, extremes are.
pub const MOST_VALUES: usize = 1 << 24;

/// How often values are in memory on their way to a reader: as they are read, as what is told of them, as the bytes of an answer.
const COPIES: u128 = 4;

/// Entries that an array among the scalars has at most: longer ones are in the datasets.
const LISTED: usize = 64;

/// A study folder that is looked at while others may work on it. Whatever it tells is cut to what a page shows of it, as [`shown_text`] does.
#[derive(Debug, Clone)]
pub struct StudyView {
    reader: StudyReader,
    registry: Registry,
    name: String,
}

/// What a study holds.
#[derive(Debug, Clone, PartialEq)]
pub struct StudyListing {
    /// The name of the folder.
    pub name: String,
    /// The title of the case; empty where it has none.
    pub title: String,
    /// The model of the case; empty where it was not kept.
    pub model: String,
    /// The version of judder that ran last.
    pub version: String,
    /// The analyses in the order of the case, then its sweeps.
    pub analyses: Vec<AnalysisListing>,
    /// The sounds in the folder: path and bytes.
    pub sounds: Vec<(String, u64)>,
    /// Warnings that concern the case as a whole.
    pub warnings: Vec<String>,
}

/// What a study holds of an analysis.
#[derive(Debug, Clone, PartialEq)]
pub struct AnalysisListing {
    /// Its name.
    pub name: String,
    /// Its kind, as the case has it; `sweep` for a sweep.
    pub kind: String,
    /// How it ended.
    pub status: Status,
    /// Its wall time, s.
    pub seconds: f64,
    /// Its scalars and short tables.
    pub scalars: Map<String, Value>,
    /// Its warnings.
    pub warnings: Vec<String>,
    /// The attributes of its dataset.
    pub attributes: Map<String, Value>,
    /// Its variables with their shapes, without values.
    pub variables: Vec<Variable>,
}

/// Which rows of variables are wanted, by their index along the first dimension.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct RowWindow {
    /// The first; from the beginning where none is given.
    pub from: Option<usize>,
    /// The one after the last; to the end where none is given.
    pub to: Option<usize>,
    /// Where there are more, as many bins as fit, and of each the smallest, then the largest value of every column: at most so many rows,
    /// at least two.
    pub most: Option<usize>,
}

impl StudyView {
    /// Looks into the folder of a study.
    ///
    /// # Errors
    /// A folder without a study.
    pub fn open(registry: Registry, folder: &Path) -> Result<Self, StudyError> {
        let reader = StudyReader::open(folder)?;
        let name = reader.path().file_name().map(|name| name.to_string_lossy().into_owned());
        Ok(Self { reader, registry, name: name.unwrap_or_default() })
    }

    /// The name of the folder.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// What is there now.
    ///
    /// # Errors
    /// A summary or datasets that are damaged.
    pub fn listing(&self) -> Result<StudyListing, StudyError> {
        let summary = self.summary()?;
        let stored = self.reader.names()?;
        let text = |key: &str| shown_text(summary.case.get(key).and_then(Value::as_str).unwrap_or_default());
        let analyses = report::in_order(&summary).into_iter().map(|(name, record)| {
            let head = match stored.contains(name) && record.status == Status::Done {
                true => Some(self.reader.head(name)?),
                false => None,
            };
            let (attributes, variables) =
                head.map_or_else(Default::default, |head| (head.attributes, head.variables));
            Ok(AnalysisListing {
                name: shown_text(name),
                kind: shown_text(&kind(&summary, name)),
                status: shown_status(&record.status),
                seconds: record.wall_time_s,
                scalars: summary.results.get(name).map(short).unwrap_or_default(),
                warnings: shown_texts(&record.warnings),
                attributes: shown_table(&attributes),
                variables: variables.into_iter().map(shown_variable).collect(),
            })
        });
        Ok(StudyListing {
            name: self.name.clone(),
            title: text("title"),
            model: text("model"),
            version: shown_text(&summary.version),
            analyses: analyses.collect::<Result<_, StudyError>>()?,
            sounds: self.reader.files("wav")?,
            warnings: self.doubt()?.into_iter().chain(shown_texts(&summary.warnings)).collect(),
        })
    }

    /// Why the study may not be whole; nothing where a manifest says that it is.
    fn doubt(&self) -> Result<Option<String>, StudyError> {
        Ok(match self.reader.is_complete()? {
            None => Some("without `manifest.json` nothing says that this study is whole".to_owned()),
            Some(false) => {
                Some("a run is at work in this study, or was interrupted: `judder run` goes on".to_owned())
            }
            Some(true) => None,
        })
    }

    /// Chosen variables of an analysis. The window is one along the first dimension of the first of them; variables without this dimension
    /// come whole. It ends between two files where the one who asked has gone.
    ///
    /// # Errors
    /// [`StudyError::UnknownAnalysis`]; a variable that is not there or damaged; more than [`MOST_VALUES`] values of one variable,
    /// [`StudyError::Memory`] for more of all of them than there is memory for; [`StudyError::Interrupted`].
    pub fn arrays(
        &self,
        analysis: &str,
        variables: &[String],
        window: &RowWindow,
        progress: &dyn Progress,
    ) -> Result<Vec<Variable>, StudyError> {
        self.summary_with(analysis)?;
        let head = self.reader.head(analysis)?;
        let of = |name: &String| head.variables.iter().find(|variable| variable.name == *name);
        let along = variables.first().and_then(of).and_then(|variable| variable.dimensions.first());
        let window_of = |variable: &Variable| match variable.dimensions.first() == along {
            true => *window,
            false => RowWindow::default(),
        };
        let mut bytes = 0;
        for variable in variables.iter().filter_map(of) {
            let shown = ShownRows::new(variable, &window_of(variable))?;
            bytes += (shown.count * shown.width * variable.data.value_size()) as u128;
        }
        MemoryBudget::of_process().ask(bytes * COPIES).map_err(|source| StudyError::Memory {
            what: format!("the variables of `{analysis}` that are asked for"),
            source,
        })?;
        let read = |name: &String| match of(name) {
            Some(variable) => self.window(analysis, variable, &window_of(variable), progress),
            // what is not there is told as the store does
            None => Ok(self.reader.read_rows(analysis, name, 0..0)?),
        };
        variables.iter().map(|name| read(name).map(shown_variable)).collect()
    }

    /// A sound of the listing, to be handed on as it is read.
    ///
    /// # Errors
    /// A path that the listing does not have, a file of another size than was written.
    pub fn sound(&self, path: &str) -> Result<CheckedFile, StudyError> {
        Ok(self.reader.open_file(path, "wav")?)
    }

    /// The case of the study, read from what the study kept of it. Files that it names are sought in the study folder: a case of other
    /// files than those that a run has kept there cannot be read.
    ///
    /// # Errors
    /// [`StudyError::NoResults`] where none was kept; what is wrong with the case.
    pub fn case_file(&self) -> Result<CaseFile, StudyError> {
        self.case_file_at(&self.reader.path().join(format!("{}.toml", self.name)).to_string_lossy())
    }

    /// As [`StudyView::case_file`], with the files that it names sought beside a case file of this name.
    ///
    /// # Errors
    /// As of [`StudyView::case_file`].
    pub fn case_file_at(&self, name: &str) -> Result<CaseFile, StudyError> {
        let kept = Keepsakes::of(&self.summary()?);
        if kept.source.is_empty() {
            return Err(StudyError::NoResults { folder: self.name.clone() });
        }
        Ok(CaseFile::parse(self.registry, name, &kept.source, &kept.overrides)?)
    }

    fn summary(&self) -> Result<Summary, StudyError> {
        let summary = self.reader.read_summary()?;
        summary.ok_or_else(|| StudyError::NoResults { folder: self.name.clone() })
    }

    /// The summary, which has this analysis.
    fn summary_with(&self, analysis: &str) -> Result<Summary, StudyError> {
        let summary = self.summary()?;
        if summary.analyses.contains_key(analysis) {
            return Ok(summary);
        }
        let known = summary.analyses.keys().cloned().collect();
        Err(StudyError::UnknownAnalysis { name: analysis.to_owned(), known })
    }

    fn window(
        &self,
        analysis: &str,
        head: &Variable,
        window: &RowWindow,
        progress: &dyn Progress,
    ) -> Result<Variable, StudyError> {
        progress.go_on()?;
        let ShownRows { range, width, count: shown } = ShownRows::new(head, window)?;
        if shown == range.len() {
            return Ok(self.reader.read_rows(analysis, &head.name, range)?);
        }
        let mut extremes = BinnedExtremes::new(range.clone(), shown / 2, width);
        let step = self.reader.rows_of_a_file(analysis, &head.name)?.max(1);
        let mut start = range.start;
        while start < range.end {
            progress.go_on()?;
            // each file is opened once
            let end = ((start / step + 1) * step).min(range.end);
            extremes.add(start, self.reader.read_rows(analysis, &head.name, start..end)?.data);
            start = end;
        }
        let mut shape = head.shape.clone();
        if let Some(first) = shape.first_mut() {
            *first = 2 * (shown / 2);
        }
        Ok(Variable { data: extremes.finish(), shape, ..head.clone() })
    }
}

/// Which rows of a variable are read, and how many are shown of them.
struct ShownRows {
    range: Range<usize>,
    /// Values of a row.
    width: usize,
    count: usize,
}

impl ShownRows {
    fn new(head: &Variable, window: &RowWindow) -> Result<Self, StudyError> {
        let rows = head.shape.first().copied().unwrap_or(1);
        let to = window.to.unwrap_or(rows).min(rows);
        let range = window.from.unwrap_or(0).min(to)..to;
        let width = head.shape.iter().skip(1).fold(1_usize, |width, length| width.saturating_mul(*length));
        let count = window.most.map_or(range.len(), |most| most.max(2).min(range.len()));
        if count.saturating_mul(width) > MOST_VALUES {
            let (variable, rows, most) = (head.name.clone(), count, MOST_VALUES);
            return Err(StudyError::TooManyValues { variable, rows, width, most });
        }
        Ok(Self { range, width, count })
    }
}

/// The kind of an analysis, as the case has it.
fn kind(summary: &Summary, name: &str) -> String {
    let of_list = |list: &str| summary.case.get(list).and_then(Value::as_array);
    let named = |entry: &&Value| entry.get("name").and_then(Value::as_str) == Some(name);
    if of_list("sweep").is_some_and(|sweeps| sweeps.iter().any(|sweep| named(&sweep))) {
        return "sweep".to_owned();
    }
    let analysis = of_list("analysis").and_then(|analyses| analyses.iter().find(named));
    analysis.and_then(|analysis| analysis.get("kind")?.as_str()).unwrap_or_default().to_owned()
}

/// Scalars without long arrays.
fn short(scalars: &Map<String, Value>) -> Map<String, Value> {
    let is_short = |value: &Value| value.as_array().is_none_or(|list| list.len() <= LISTED);
    let listed = scalars.iter().filter(|(_, value)| is_short(value));
    shown_table(&listed.map(|(key, value)| (key.clone(), value.clone())).collect())
}

fn shown_status(status: &Status) -> Status {
    match status {
        Status::Done => Status::Done,
        Status::Failed { reason } => Status::Failed { reason: shown_text(reason) },
    }
}
