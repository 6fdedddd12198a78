//! What the report shows of an analysis: its figure and its tables, without a page around them.

use super::shown_text::{shown_page_table, shown_table, shown_variable};
use super::{MOST_VALUES, StudyView};
use crate::error::StudyError;
use crate::pictures::sweep::is_sweep;
use crate::progress::Progress;
use crate::report;
use judder_report::json;
use judder_report::page::PageTable;
use judder_store::{Dataset, DatasetHead, Summary, Variable};

/// What the report shows of an analysis beside its scalars.
#[derive(Debug)]
pub struct ReportedAnalysis {
    /// Its figure for the interactive chart, as [`judder_report::json`] writes it. `None` where its result is no picture, and for a sweep,
    /// whose points may be more than memory holds; an error where it cannot be read or drawn.
    pub figure: Result<Option<String>, StudyError>,
    /// Its tables.
    pub tables: Vec<PageTable>,
}

impl StudyView {
    /// What the report shows of an analysis. Of one that failed there is nothing.
    ///
    /// # Errors
    /// [`StudyError::UnknownAnalysis`], a damaged summary. A figure has an error of its own: damaged arrays, or [`StudyError::TooManyToDraw`]
    /// for more than [`MOST_VALUES`] values of all arrays, [`StudyError::Interrupted`] where the one who asked has gone.
    pub fn reported(&self, analysis: &str, progress: &dyn Progress) -> Result<ReportedAnalysis, StudyError> {
        let summary = self.summary_with(analysis)?;
        let tables = report::tables(self.registry, &summary, analysis);
        let tables = tables.iter().map(shown_page_table).collect();
        Ok(ReportedAnalysis { figure: self.figure(&summary, analysis, progress), tables })
    }

    fn figure(
        &self,
        summary: &Summary,
        analysis: &str,
        progress: &dyn Progress,
    ) -> Result<Option<String>, StudyError> {
        if !self.reader.names()?.iter().any(|stored| stored == analysis) {
            return Ok(None);
        }
        let head = self.reader.head(analysis)?;
        if is_sweep(&head.attributes) {
            return Ok(None);
        }
        let dataset = self.whole(analysis, head, progress)?;
        progress.go_on()?;
        let model = self.registry.model_of(&summary.case);
        let figure = report::figure_of(model, self.reader.path(), analysis, &dataset)?;
        Ok(figure.map(|figure| json(&figure)).transpose()?)
    }

    /// All arrays of an analysis.
    fn whole(
        &self,
        analysis: &str,
        head: DatasetHead,
        progress: &dyn Progress,
    ) -> Result<Dataset, StudyError> {
        let count =
            |shape: &[usize]| shape.iter().fold(1_usize, |product, length| product.saturating_mul(*length));
        let values = head.variables.iter().fold(0_usize, |sum, own| sum.saturating_add(count(&own.shape)));
        if values > MOST_VALUES {
            return Err(StudyError::TooManyToDraw { name: analysis.to_owned(), values, most: MOST_VALUES });
        }
        let mut dataset = Dataset::new();
        for (name, value) in shown_table(&head.attributes) {
            dataset = dataset.attribute(&name, value)?;
        }
        for own in head.variables {
            progress.go_on()?;
            let rows = own.shape.first().copied().unwrap_or(1);
            let read = self.reader.read_rows(analysis, &own.name, 0..rows)?;
            dataset = dataset.with(shown_variable(Variable { is_coordinate: own.is_coordinate, ..read }))?;
        }
        Ok(dataset)
    }
}
