//! Two columns of numbers in a file of text, each with its unit in the head.

use judder_exchange::number_table::{TableColumn, read_number_table};
use judder_keys::declared::{Allowed, Setting};
use judder_keys::document::Node;
use judder_keys::error::Fault;
use judder_keys::file_reference::{FileReference, read_file_reference};
use judder_keys::numeric_key::{Form, Scaled, Value};
use judder_keys::problem::{Placed, Problem};
use judder_keys::quantity::Quantity;
use judder_keys::section::Section;
use judder_study::StudyError;
use judder_study::input_file::{text, unusable};
use serde_json::Value as Json;
use std::path::Path;
use thiserror::Error;

/// The numbers of a column and the unit in which the file has them.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct NumberColumn {
    /// The numbers.
    pub(crate) values: Vec<Value>,
    /// The unit; of plain numbers none.
    pub(crate) unit: Option<String>,
}

/// Two columns; `rules` say what each may be, `header` is what the file could begin with.
///
/// # Errors
/// [`StudyError`] for a file that cannot be read, that is no table, or whose units are others.
pub(crate) fn number_columns(
    path: &Path,
    rules: [Scaled; 2],
    header: &str,
) -> Result<[NumberColumn; 2], StudyError> {
    let found: [TableColumn; 2] =
        read_number_table(&text(path)?, header).map_err(|error| unusable(path, &error))?;
    let mut columns = found.into_iter().zip(rules).map(|(column, rule)| {
        let unit = column.unit.clone();
        let found = values(column, &rule).map(|values| NumberColumn { values, unit });
        found.map_err(|reason| unusable(path, &format!("{reason}, as in `{header}`")))
    });
    let mut next = || columns.next().unwrap_or_else(|| Ok(NumberColumn::default()));
    Ok([next()?, next()?])
}

/// The numbers of a column, in SI units where it has a unit, or why these are not known.
fn values(column: TableColumn, rule: &Scaled) -> Result<Vec<Value>, String> {
    let dimension = rule.dimension;
    let unit = match (&column.unit, dimension.is_number()) {
        (None, _) if rule.group.is_some() => {
            return Ok(column.values.into_iter().map(Value::group).collect());
        }
        (Some(unit), true) => {
            return Err(format!("a column of numbers without a unit has the unit `{unit}`"));
        }
        (None, _) => return Err(format!("the column of {dimension} has no unit in brackets")),
        (Some(unit), false) => unit,
    };
    let read = |number: f64| match Quantity::parse(&format!("{number} {unit}")) {
        Ok(found) if found.dimension == dimension => Ok(found.number),
        Ok(_) => Err(format!("`{unit}` is no unit of {dimension}")),
        Err((problem, _)) => Err(format!("`{unit}` is no unit of {dimension}: {problem}")),
    };
    // degrees Celsius have a zero of their own
    let (zero, one) = (read(0.0)?, read(1.0)?);
    let number = |value: f64| if zero == 0.0 { one * value } else { zero + (one - zero) * value };
    Ok(column.values.into_iter().map(|value| Value::si(number(value))).collect())
}

/// A file with two columns; these are there when it has been found.
#[derive(Debug, Clone, PartialEq)]
pub struct ColumnFile {
    /// The file.
    pub file: FileReference,
    /// Its columns.
    pub columns: [Vec<f64>; 2],
    /// Whether those are plain numbers or in SI units, each.
    pub forms: [Form; 2],
    /// The units in which the file has them.
    pub units: [Option<String>; 2],
}

/// What is wrong with a file of columns.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("{reason}")]
struct UnusableColumns {
    reason: String,
}

impl Problem for UnusableColumns {
    fn kind(&self) -> &'static str {
        "Columns"
    }

    fn label(&self) -> &'static str {
        "this file"
    }

    fn help(&self) -> Option<String> {
        None
    }
}

impl ColumnFile {
    /// Finds and reads the file under `key` of a section, relative to a folder.
    pub(crate) fn find(
        &mut self,
        section: &Section<'_>,
        key: &str,
        folder: &Path,
        (rules, header): ([Scaled; 2], &str),
    ) -> Result<(), Fault> {
        self.file = read_file_reference(section, key, folder)?;
        let columns = number_columns(&self.file.path, rules, header)
            .map_err(|error| UnusableColumns { reason: error.to_string() }.at(section.place_of(&[key])))?;
        self.forms = [0, 1].map(|k: usize| columns[k].values.first().map_or(Form::Group, |value| value.form));
        self.units = columns.each_ref().map(|own| own.unit.clone());
        self.columns = columns.map(|own| own.values.into_iter().map(|value| value.number).collect());
        Ok(())
    }
}

impl Setting for ColumnFile {
    type Rule = ();

    fn form((): &()) -> Allowed {
        FileReference::form(&())
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        let file = FileReference::read(section, key, node, &())?;
        Ok(Self { file, columns: [Vec::new(), Vec::new()], forms: [Form::Group; 2], units: [None, None] })
    }

    fn write(&self, (): &()) -> Json {
        self.file.write(&())
    }
}
