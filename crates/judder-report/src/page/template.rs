//! From the page as data to HTML, through the templates in `templates/`.

use super::{Claim, ClaimVerdict, Page, PageBlock, PageSection, PageTable, Scoreboard};
use crate::error::ReportError;
use crate::figure::Figure;
use crate::markup;
use crate::svg::svg;
use crate::typeface::{BOLD_WEB, ITALIC_WEB, REGULAR_WEB};
use crate::wire;
use askama::Template;
use base64::{Engine, engine::general_purpose::STANDARD};
use std::collections::BTreeSet;

const STYLE: &str = include_str!("../../assets/page/page.css");
/// The interactive chart, built from the sources of the page of `judder explore`.
const CHART: &str = include_str!("../../assets/chart/chart.js");
const CHART_STYLE: &str = include_str!("../../assets/chart/chart.css");

#[derive(Template)]
#[template(path = "page.html")]
struct PageTemplate<'a> {
    page: &'a Page,
    sections: Vec<(&'a PageSection, Vec<String>)>,
    style: &'a str,
    regular: String,
    italic: String,
    bold: String,
    chart: &'a str,
    chart_style: &'a str,
    interactive: bool,
}

#[derive(Template)]
#[template(path = "block.html")]
struct BlockTemplate<'a> {
    block: &'a PageBlock,
    /// Blocks inside this one, already written.
    inner: Vec<String>,
    figure: Option<DrawnFigure>,
}

/// A figure as it stands on the page.
struct DrawnFigure {
    number: usize,
    svg: String,
    json: String,
}

impl BlockTemplate<'_> {
    /// Number of claims of a scoreboard with this verdict.
    fn claims(&self, verdict: ClaimVerdict) -> usize {
        match self.block {
            PageBlock::Scoreboard(board) => board.rows.iter().filter(|row| row.verdict == verdict).count(),
            _ => 0,
        }
    }

    /// The readings that the verdict is about, or all others, each with its head.
    fn readings<'b>(
        &self,
        board: &'b Scoreboard,
        claim: &'b Claim,
        is_judged: bool,
    ) -> impl Iterator<Item = (&'b str, &'b str)> {
        let all = board.ours.iter().zip(&claim.ours).enumerate();
        let own = all.filter(move |(k, _)| (*k < board.judged) == is_judged);
        own.map(|(_, (head, cell))| (head.as_str(), cell.as_str()))
    }

    fn has_others(&self, board: &Scoreboard) -> bool {
        board.ours.len() > board.judged
    }

    /// Whether a column of a table holds numbers, judged by its first row.
    fn has_numbers(&self, table: &PageTable, column: &usize) -> bool {
        table.rows.first().and_then(|row| row.get(*column)).is_some_and(|cell| is_number(cell))
    }

    /// Number of checks that passed, or that did not.
    fn checks(&self, passed: bool) -> usize {
        match self.block {
            PageBlock::Checks(checks) => checks.iter().filter(|check| check.passed == passed).count(),
            _ => 0,
        }
    }
}

/// The page as one HTML file that asks for nothing outside itself; the same bytes for the same page.
///
/// Figures are interactive charts; without scripts, on paper and while loading they are the drawings of [`crate::svg`].
///
/// # Errors
/// What [`ReportError`] says of a figure, or of two figures of the same name.
pub fn html(page: &Page) -> Result<String, ReportError> {
    let mut writer = Writer { page, names: BTreeSet::new() };
    let sections = page
        .sections
        .iter()
        .map(|section| Ok((section, writer.blocks(&section.blocks)?)))
        .collect::<Result<Vec<_>, ReportError>>()?;
    let interactive = !writer.names.is_empty();
    let template = PageTemplate {
        page,
        sections,
        style: STYLE,
        regular: STANDARD.encode(REGULAR_WEB),
        italic: STANDARD.encode(ITALIC_WEB),
        bold: STANDARD.encode(BOLD_WEB),
        chart: CHART,
        chart_style: CHART_STYLE,
        interactive,
    };
    template.render().map_err(|error| writer.failed(&error))
}

/// Writes blocks and keeps count of the figures.
struct Writer<'a> {
    page: &'a Page,
    names: BTreeSet<String>,
}

impl Writer<'_> {
    fn blocks(&mut self, blocks: &[PageBlock]) -> Result<Vec<String>, ReportError> {
        blocks.iter().map(|block| self.block(block)).collect()
    }

    fn block(&mut self, block: &PageBlock) -> Result<String, ReportError> {
        let inner = match block {
            PageBlock::Details(details) => self.blocks(&details.blocks)?,
            _ => Vec::new(),
        };
        let figure = match block {
            PageBlock::Figure(figure) => Some(self.figure(figure)?),
            _ => None,
        };
        BlockTemplate { block, inner, figure }.render().map_err(|error| self.failed(&error))
    }

    fn figure(&mut self, figure: &Figure) -> Result<DrawnFigure, ReportError> {
        if !self.names.insert(figure.name.clone()) {
            return Err(ReportError::SameName { name: figure.name.clone() });
        }
        let (svg, json) = (svg(figure)?, wire::json(figure)?);
        Ok(DrawnFigure { number: self.names.len(), svg, json: inside_script(&json) })
    }

    fn failed(&self, error: &askama::Error) -> ReportError {
        ReportError::Page { title: self.page.title.clone(), reason: error.to_string() }
    }
}

/// JSON in which no browser finds the end of the script element it stands in; `<` occurs in its strings only.
fn inside_script(json: &str) -> String {
    json.replace('<', "\\u003c")
}

/// Whether a cell is a number (perhaps with signs and powers of ten around it) and is set flush right.
fn is_number(cell: &str) -> bool {
    let bare = markup::plain(cell);
    let digits = bare.chars().filter(char::is_ascii_digit).count();
    digits > 0 && bare.chars().all(|c| c.is_ascii_digit() || " .,+-−–×e±%<>≤≥≈∞".contains(c))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scripts_cannot_be_ended_from_inside() {
        assert_eq!(inside_script("\"</script>\""), "\"\\u003c/script>\"");
        let script = CHART.to_lowercase();
        assert!(!script.contains("</script") && !script.contains("<!--"), "cannot stand inside a page");
        assert!(!CHART_STYLE.to_lowercase().contains("</style"), "cannot stand inside a page");
    }

    #[test]
    fn numbers_are_told_from_words() {
        for cell in ["1.5", "−3 × 10^{−2}", "≈ 7e-8", "12 %"] {
            assert!(is_number(cell), "{cell}");
        }
        for cell in ["", "–", "mode 1", "0.2 N"] {
            assert!(!is_number(cell), "{cell}");
        }
    }
}
