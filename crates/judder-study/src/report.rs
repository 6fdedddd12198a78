//! Figures and page of a study folder, from what is stored in it.

use crate::error::StudyError;
use crate::fault::fault_told;
use crate::ledger::Keepsakes;
use crate::outcome::CheckRecord;
use crate::pictures;
use crate::registry::{ModelKind, Registry, ToldAnalysis};
use crate::report_tables;
use crate::version::maker;
use judder_report::page::{Check, Code, Details, PageTable};
use judder_report::{Figure, Page, PageBlock, PageSection, UndrawnFigure, html, png, svg};
use judder_store::{Dataset, Status, StudyFolder, Summary};
use serde_json::Value;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};

/// Pixels per typographic point in the PNG figures: 216 dots per inch.
const PIXELS_PER_POINT: f64 = 3.0;

/// The page of a study.
const PAGE: &str = "report.html";
/// How the paths of figures begin.
const FIGURES: &str = "figures/";

/// A study folder that has results, and what it says of them.
///
/// # Errors
/// A folder without results, or damaged results.
pub fn stored(folder: &Path) -> Result<(StudyFolder, Summary), StudyError> {
    with_results(StudyFolder::open(folder)?, folder)
}

/// The same for a study that stays as it is: figures and page go into another folder.
///
/// # Errors
/// As of [`stored`], and another folder that holds a study or files of somebody else.
pub fn stored_for(folder: &Path, output: &Path) -> Result<(StudyFolder, Summary), StudyError> {
    with_results(StudyFolder::drawn_into(folder, output)?, folder)
}

fn with_results(store: StudyFolder, folder: &Path) -> Result<(StudyFolder, Summary), StudyError> {
    let summary = store.read_summary()?.filter(|summary| !summary.analyses.is_empty());
    match summary {
        Some(summary) => {
            store.vouch(&summary)?;
            Ok((store, summary))
        }
        None => Err(StudyError::NoResults { folder: folder.display().to_string() }),
    }
}

/// Whether a file of a study, by its path in it, is drawn from others.
pub(crate) fn is_drawn(path: &str) -> bool {
    path == PAGE || path.starts_with(FIGURES)
}

/// A page that was written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct WrittenPage {
    /// Its file.
    pub path: PathBuf,
    /// The figures that it lacks.
    pub undrawn: Vec<UndrawnFigure>,
    /// Analyses and sweeps of the case that nobody has computed.
    pub not_computed: Vec<String>,
}

impl WrittenPage {
    /// The figures that it lacks, a line each.
    #[must_use]
    pub fn lacking(&self) -> Vec<String> {
        self.undrawn
            .iter()
            .map(|UndrawnFigure { name, reason }| format!("{name}: no figure: {reason}"))
            .collect()
    }
}

/// Draws all figures and the page. What cannot be read or drawn says why in its place, and takes nothing else of the page with it.
///
/// # Errors
/// A folder that cannot be written.
pub fn write(registry: Registry, store: &StudyFolder, summary: &Summary) -> Result<WrittenPage, StudyError> {
    let kept = Keepsakes::of(summary);
    // all at once: one write of the list for all files
    let drawn_before = store.begin_files(is_drawn)?;
    let mut sections = Vec::new();
    for (name, record) in in_order(summary) {
        let mut blocks = Vec::new();
        match &record.status {
            Status::Failed { reason } => blocks.push(PageBlock::text(format!("No result: {reason}"))),
            Status::Done => {
                let draw = || figures(registry, store, summary, name).map_err(|error| error.to_string());
                blocks.extend(figure_blocks(store, name, draw)?);
                let asked = guarded(name, || {
                    Ok(tables(registry, summary, name).into_iter().map(PageBlock::Table).collect())
                })?;
                let scalars = summary.results.get(name).and_then(scalar_table).map(PageBlock::Table);
                // what was asked first, then every number under its key, where somebody wants it
                let is_beside = !asked.is_empty();
                blocks.extend(asked);
                blocks.extend(scalars.map(|table| if is_beside { folded(table) } else { table }));
            }
        }
        sections.push(PageSection::new(name, blocks));
    }
    sections.push(PageSection::new("Checks", vec![PageBlock::Checks(check_rows(&kept.checks))]));
    sections.push(PageSection::new("Warnings", vec![PageBlock::Warnings(warnings(summary))]));
    sections.push(case_section(summary, &kept));
    let title =
        summary.case.get("title").and_then(Value::as_str).filter(|t| !t.is_empty()).unwrap_or("A study");
    let page = Page { title: title.to_owned(), lead: lead(summary, &kept), facts: facts(summary), sections };
    let page = WrittenPage { not_computed: not_computed(summary), ..write_page(store, &page)? };
    // what an earlier case had
    store.end_files(&drawn_before)?;
    Ok(page)
}

/// Draws all figures and the page of a study that was copied to this folder; the way to its case file was that from another.
///
/// # Errors
/// A folder without results or that cannot be written, damaged results.
pub fn write_copied(registry: Registry, folder: &Path) -> Result<WrittenPage, StudyError> {
    let (store, mut summary) = stored(folder)?;
    Keepsakes { file: None, ..Keepsakes::of(&summary) }.put(&mut summary);
    store.write_summary(&summary, None)?;
    let page = write(registry, &store, &summary)?;
    store.seal_as_before(maker())?;
    Ok(page)
}

/// Figures as blocks of the page; what cannot be read or drawn says why under this name, in place of all of them.
///
/// # Errors
/// A folder that cannot be written.
pub fn figure_blocks(
    store: &StudyFolder,
    name: &str,
    draw: impl FnOnce() -> Result<Vec<Figure>, String>,
) -> Result<Vec<PageBlock>, StudyError> {
    guarded(name, || match draw() {
        Ok(figures) => figures.into_iter().map(|figure| write_figure(store, figure)).collect(),
        Err(reason) => Ok(vec![undrawn(name, reason)]),
    })
}

fn undrawn(name: &str, reason: String) -> PageBlock {
    PageBlock::Undrawn(UndrawnFigure { name: name.to_owned(), reason })
}

/// Blocks of the page; a fault of this program says so in their place, under this name.
fn guarded(
    name: &str,
    blocks: impl FnOnce() -> Result<Vec<PageBlock>, StudyError>,
) -> Result<Vec<PageBlock>, StudyError> {
    let made = catch_unwind(AssertUnwindSafe(blocks));
    made.unwrap_or_else(|panic| Ok(vec![undrawn(name, fault_told(&*panic))]))
}

/// The figures of an analysis or a sweep. Of a sweep only what is drawn is read: the whole may not fit into memory.
fn figures(
    registry: Registry,
    store: &StudyFolder,
    summary: &Summary,
    name: &str,
) -> Result<Vec<Figure>, StudyError> {
    let model = registry.model_of(&summary.case);
    let attributes = store.read_attributes(name)?;
    if pictures::sweep::is_sweep(&attributes) {
        let choose = |dimensions: &[_]| pictures::sweep::drawn_points(&attributes, dimensions);
        let dataset = store.read_points(name, choose)?;
        let results = summary.results.get(name).cloned().unwrap_or_default();
        let drawn = pictures::sweep::figures(model, name, &dataset, &results);
        return Ok(drawn.map_err(|wrong| wrong.in_study(store.path(), name))?);
    }
    Ok(figure_of(model, store.path(), name, &store.read_dataset(name)?)?.into_iter().collect())
}

/// The figure of an analysis of the study at a path; none where its result is not a picture.
pub(crate) fn figure_of(
    model: Option<&ModelKind>,
    study: &Path,
    name: &str,
    dataset: &Dataset,
) -> Result<Option<Figure>, StudyError> {
    let drawn = model.map_or(Ok(None), |model| model.figure(name, name, dataset));
    Ok(drawn.map_err(|wrong| wrong.in_study(study, name))?)
}

/// The tables of an analysis or a sweep, beside that of its scalars.
pub(crate) fn tables(registry: Registry, summary: &Summary, name: &str) -> Vec<PageTable> {
    let Some(results) = summary.results.get(name) else { return Vec::new() };
    let of_kind = registry.tables(&summary.case, name);
    match of_kind {
        Some((tables, asked)) => (tables.report)(ToldAnalysis { asked, results }),
        None => report_tables::of_sweep(results),
    }
}

/// The analyses in the order of the case, then its sweeps.
pub(crate) fn in_order(summary: &Summary) -> Vec<(&String, &judder_store::AnalysisRecord)> {
    let listed = listed(summary);
    let mut records: Vec<_> = summary.analyses.iter().collect();
    records.sort_by_key(|(name, _)| listed.iter().position(|listed| listed == name));
    records
}

/// The names of the analyses and sweeps of the case.
fn listed(summary: &Summary) -> Vec<&str> {
    let lists = ["analysis", "sweep"];
    let lists = lists.iter().filter_map(|list| summary.case.get(list)?.as_array());
    lists.flatten().filter_map(|analysis| analysis.get("name")?.as_str()).collect()
}

/// Those of them that nobody has computed yet.
fn not_computed(summary: &Summary) -> Vec<String> {
    let names = listed(summary).into_iter().filter(|name| !summary.analyses.contains_key(*name));
    names.map(str::to_owned).collect()
}

/// What was done and what came out, in a sentence or two.
fn lead(summary: &Summary, kept: &Keepsakes) -> String {
    let done = summary.analyses.values().filter(|record| record.status == Status::Done).count();
    let checks = kept.checks.values().flatten().count();
    let passed = kept.checks.values().flatten().filter(|check| check.passed()).count();
    let warnings = warnings(summary).len();
    let has_sweeps = summary.case.get("sweep").is_some();
    let not_computed = not_computed(summary);
    let rest = match not_computed.is_empty() {
        true => String::new(),
        false => format!(" Not computed: {}.", not_computed.join(", ")),
    };
    format!(
        "{done} of {} {} done, {passed} of {checks} checks within their limits, {warnings} warnings.{rest}",
        summary.analyses.len() + not_computed.len(),
        if has_sweeps { "analyses and sweeps" } else { "analyses" },
    )
}

/// The line under the title of a page: version, hash of the case, wall time.
pub fn facts(summary: &Summary) -> Vec<(String, String)> {
    vec![
        ("judder".to_owned(), summary.version.clone()),
        ("case hash".to_owned(), summary.case_hash.chars().take(16).collect()),
        ("wall time".to_owned(), format!("{:.2} s", summary.wall_time_s)),
    ]
}

/// All warnings of a study, those of an analysis after its name.
pub fn warnings(summary: &Summary) -> Vec<String> {
    let of_analyses = summary
        .analyses
        .iter()
        .flat_map(|(name, record)| record.warnings.iter().map(move |warning| format!("{name}: {warning}")));
    summary.warnings.iter().cloned().chain(of_analyses).collect()
}

/// The checks of analyses, each after the name of its analysis.
pub fn check_rows<'a>(checks: impl IntoIterator<Item = (&'a String, &'a Vec<CheckRecord>)>) -> Vec<Check> {
    let rows = checks.into_iter().flat_map(|(name, checks)| checks.iter().map(move |check| (name, check)));
    rows.map(|(name, check)| Check {
        name: format!("{name}: {}", check.name),
        compared: check.compared.clone(),
        figure: if check.compared_nothing() { "compared nothing".to_owned() } else { figure(check.figure) },
        limit: format!("≤ {}", figure(check.limit)),
        passed: check.passed(),
    })
    .collect()
}

/// A figure of a check: counts as they are, disagreements with two digits.
fn figure(value: f64) -> String {
    if value == value.trunc() && value.abs() < 1e6 {
        return format!("{value}");
    }
    let text = format!("{value:.1e}");
    match text.split_once('e') {
        Some((mantissa, exponent)) => format!("{mantissa} × 10^{{{exponent}}}").replace('-', "−"),
        None => text,
    }
}

/// A number for a reader: whole numbers as they are, others to six digits; `summary.json` has them all.
fn six_digits(number: &serde_json::Number) -> String {
    match number.as_f64() {
        Some(value) if !number.is_i64() && !number.is_u64() => {
            let rounded: f64 = format!("{value:.5e}").parse().unwrap_or(value);
            let plain = value == 0.0 || (1e-3..1e6).contains(&value.abs());
            if plain { format!("{rounded}") } else { format!("{rounded:e}") }
        }
        _ => number.to_string(),
    }
}

fn folded(table: PageBlock) -> PageBlock {
    let summary = "Every number, by its key in `summary.json`".to_owned();
    PageBlock::Details(Details { summary, blocks: vec![table] })
}

/// The scalars of an analysis that fit a table, under their keys.
fn scalar_table(scalars: &serde_json::Map<String, Value>) -> Option<PageTable> {
    let rows: Vec<Vec<String>> = scalars
        .iter()
        .filter_map(|(name, value)| match value {
            Value::Number(number) => Some(vec![name.clone(), six_digits(number)]),
            Value::String(text) => Some(vec![name.clone(), text.clone()]),
            Value::Array(list)
                if !list.is_empty() && list.len() <= 12 && list.iter().all(Value::is_number) =>
            {
                let shown: Vec<String> = list.iter().filter_map(Value::as_number).map(six_digits).collect();
                Some(vec![name.clone(), shown.join(", ")])
            }
            _ => None,
        })
        .collect();
    (!rows.is_empty()).then(|| PageTable {
        caption: String::new(),
        head: vec!["key".to_owned(), "value".to_owned()],
        rows,
    })
}

/// The case file, what overrode it, and its canonical form.
pub fn case_section(summary: &Summary, kept: &Keepsakes) -> PageSection {
    let mut blocks =
        vec![PageBlock::Code(Code { caption: "The case file".to_owned(), text: kept.source.clone() })];
    if !kept.overrides.is_empty() {
        blocks.push(PageBlock::Code(Code {
            caption: "Set on top of it".to_owned(),
            text: kept.overrides.join("\n"),
        }));
    }
    let resolved = serde_json::to_string_pretty(&summary.case).unwrap_or_default();
    blocks.push(PageBlock::Details(Details {
        summary: "The resolved case, with every default".to_owned(),
        blocks: vec![PageBlock::Code(Code { caption: "Resolved case".to_owned(), text: resolved })],
    }));
    PageSection::new("Case", blocks)
}

/// Writes a figure as SVG and PNG, and gives it as a block of the page; a picture that cannot be drawn says why.
///
/// # Errors
/// A folder that cannot be written.
pub fn write_figure(store: &StudyFolder, figure: Figure) -> Result<PageBlock, StudyError> {
    let drawn = svg(&figure).and_then(|svg| Ok((svg, png(&figure, PIXELS_PER_POINT)?)));
    let (svg, png) = match drawn {
        Ok(drawn) => drawn,
        Err(reason) => {
            return Ok(undrawn(&figure.name, reason.to_string()));
        }
    };
    for (form, content) in [("svg", svg.as_bytes()), ("png", &png)] {
        match store.write_file(format!("{FIGURES}{}.{form}", figure.name), content) {
            Err(error) if error.is_of_one_file() => {
                return Ok(undrawn(&figure.name, error.to_string()));
            }
            written => drop(written?),
        }
    }
    Ok(PageBlock::figure(figure))
}

/// Writes `report.html`.
///
/// # Errors
/// A page that cannot be made, or a folder that cannot be written.
pub fn write_page(store: &StudyFolder, page: &Page) -> Result<WrittenPage, StudyError> {
    let path = store.write_file("report.html", html(page)?.as_bytes())?;
    Ok(WrittenPage { path, undrawn: page.undrawn(), not_computed: Vec::new() })
}
