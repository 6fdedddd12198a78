//! The models that there are, and all that is asked of them without a case: how one is read, its schema, its reference, its figures.

use crate::case::analysis::KindEntry;
use crate::model::{Case, OperatingQuantity};
use crate::report_tables::on_terminal;
use crate::text::columns;
use judder_keys::cause::Cause;
use judder_keys::declared::Declaration;
use judder_keys::document::{Data, Node};
use judder_keys::error::Fault;
use judder_report::page::PageTable;
use serde_json::{Map, Value as Json};
use std::fmt;
use std::path::Path;

/// A model: how its cases are read, and what they may say.
pub struct ModelKind {
    /// Its name in a case file.
    pub name: &'static str,
    /// Reads a case from the root of its tree; files are relative to the folder.
    pub read: fn(&Node, &Path) -> Result<Case, Fault>,
    /// What a case is of, in words.
    pub doc: &'static str,
    /// What a case says beside what any case has.
    pub declared: fn() -> Vec<Declaration>,
    /// The dotted paths of the numbers that its analyses vary, where they are known beforehand.
    pub swept: fn() -> Vec<&'static str>,
    /// Its section of the book's reference, in which `{keys}` and `{analyses}` stand for tables.
    pub prose: &'static str,
    /// The commented case file of `judder new`.
    pub template: Template,
    /// Its kinds of analyses.
    pub kinds: fn() -> Vec<KindEntry>,
    /// The quantities that an operating point of it can have.
    pub operating_quantities: &'static [OperatingQuantity],
    /// What kinds of its analyses show beside figure and scalars.
    pub tables: &'static [KindTables],
}

/// Rows of cells, the head first.
pub type TableRows = Vec<Vec<String>>;

/// What tables of an analysis are made of.
#[derive(Clone, Copy)]
pub struct ToldAnalysis<'a> {
    /// What was asked, in canonical form.
    pub asked: &'a Json,
    /// What its summary says.
    pub results: &'a Map<String, Json>,
}

/// Tables of a kind of analysis.
pub struct KindTables {
    /// The kind.
    pub kind: &'static str,
    /// Those of the report.
    pub report: fn(ToldAnalysis<'_>) -> Vec<PageTable>,
    /// What the terminal shows.
    pub terminal: TerminalTable,
}

/// What a kind of analysis shows on the terminal.
pub enum TerminalTable {
    /// The first rows of the first table of its report.
    FirstOfReport,
    /// The same, and a line for each of the others.
    FirstAndLines(fn(ToldAnalysis<'_>) -> Vec<String>),
}

impl KindTables {
    /// Those of a kind whose first table is what the terminal shows, too.
    #[must_use]
    pub const fn new(kind: &'static str, report: fn(ToldAnalysis<'_>) -> Vec<PageTable>) -> Self {
        Self { kind, report, terminal: TerminalTable::FirstOfReport }
    }

    /// What the terminal shows; none where there is nothing.
    pub(crate) fn on_terminal(&self, told: ToldAnalysis<'_>) -> Option<String> {
        let rows = on_terminal((self.report)(told));
        let lines = match self.terminal {
            TerminalTable::FirstOfReport => Vec::new(),
            TerminalTable::FirstAndLines(lines) => lines(told),
        };
        let lines = lines.iter().map(|line| format!("  {line}\n"));
        Some(columns(&rows?)).map(|text| std::iter::once(text).chain(lines).collect())
    }
}

impl ModelKind {
    /// What stands at an axis of a quantity of its operating points, by its name.
    pub(crate) fn operating_label(&self, name: &str) -> Option<&'static str> {
        self.operating_quantities.iter().find(|own| own.name == name)?.label
    }
}

/// The commented case file of a model.
pub struct Template {
    /// Its name, that of the model where it is none of a paper.
    pub name: &'static str,
    /// Its text, in which `{SECTION}` stands for the numbers of a section, a line each.
    pub text: &'static str,
    /// These lines.
    pub lines: fn(&str) -> String,
}

/// The models that cases can be of.
#[derive(Clone, Copy)]
pub struct Registry(&'static [&'static ModelKind]);

impl fmt::Debug for Registry {
    /// The names of the models.
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_list().entries(self.0.iter().map(|model| model.name)).finish()
    }
}

impl Registry {
    /// These models, in the order in which they are listed.
    #[must_use]
    pub const fn new(models: &'static [&'static ModelKind]) -> Self {
        Self(models)
    }

    /// The models in their order.
    #[must_use]
    pub fn models(self) -> &'static [&'static ModelKind] {
        self.0
    }

    /// Every kind of analysis of any model.
    pub(crate) fn kinds(self) -> impl Iterator<Item = KindEntry> {
        self.0.iter().flat_map(|model| (model.kinds)())
    }

    /// The kinds of analyses of the model of this name; none where there is no such model.
    pub fn kinds_of(self, model: &str) -> impl Iterator<Item = KindEntry> {
        self.0.iter().filter(move |own| own.name == model).flat_map(|own| (own.kinds)())
    }

    /// The model whose case this canonical form is of; none where there is no such model.
    #[must_use]
    pub fn model_of(self, resolved: &Json) -> Option<&'static ModelKind> {
        let name = resolved.get("model")?.as_str()?;
        self.0.iter().copied().find(|model| model.name == name)
    }

    /// The tables of the kind of an analysis of this name, and what it was asked; none where its kind has none.
    pub(crate) fn tables<'a>(
        self,
        resolved: &'a Json,
        name: &str,
    ) -> Option<(&'static KindTables, &'a Json)> {
        let analyses = resolved.get("analysis")?.as_array()?;
        let asked = analyses.iter().find(|own| own["name"] == name)?;
        let tables = self.model_of(resolved)?.tables.iter().find(|own| asked["kind"] == own.kind)?;
        Some((tables, asked))
    }

    /// The model of a case.
    pub(crate) fn model(self, root: &Node) -> Result<&'static ModelKind, Fault> {
        let known = || self.0.iter().map(|model| model.name.to_owned()).collect();
        let said = match &root.data {
            Data::Table(table) => table.get("model").map(|entry| &entry.node),
            _ => None,
        };
        let Some(node) = said else {
            let expected = self
                .0
                .iter()
                .map(|model| format!("model = \"{}\"", model.name))
                .collect::<Vec<_>>()
                .join(" or ");
            let (key, section) = ("model".to_owned(), "the case".to_owned());
            return Err(Cause::MissingKey { key, section, expected }.at(root.place));
        };
        let name = judder_keys::section::text("model", node)?;
        if let Some(model) = self.0.iter().find(|model| model.name == name) {
            return Ok(model);
        }
        let (what, place) = ("model", node.part(0..name.len()));
        Err(Cause::UnknownName { what, name: name.to_owned(), known: known() }.at(place))
    }
}
