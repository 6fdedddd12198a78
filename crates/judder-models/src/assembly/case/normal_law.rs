//! The normal law of a contact of a case: bodies that do not pass into each other, a law in the case, a table in a file.

use super::problem::AssemblyProblem;
use crate::number_columns::ColumnFile;
use crate::written_column::WrittenColumn;
use judder_assembly::friction::TableInterpolation;
use judder_assembly::pressure::{ForceTable, Pressure};
use judder_keys::Settings;
use judder_keys::declared::{Allowed, Number, Setting, read_settings};
use judder_keys::dimension::Dimension;
use judder_keys::document::{Data, Node};
use judder_keys::error::Fault;
use judder_keys::problem::Placed;
use judder_keys::section::{Section, word};
use serde_json::{Value as Json, json};
use std::path::Path;

/// The columns of tables of normal laws, in messages.
const CLOSURES: &str = "the closures of the table";
const FORCES: &str = "the forces of the table";
const PRESSURES: &str = "the pressures of the table";

/// The word for bodies that do not pass into each other.
const RIGID: &str = "rigid";

/// What presses.
#[derive(Debug, Clone, PartialEq)]
pub enum NormalLaw {
    /// Bodies that do not pass into each other.
    Rigid,
    /// A pressure that follows the closure.
    Compliant(Pressure),
    /// A force of each point that follows the closure by a table in a file.
    File(ForceFile),
}

/// Forces of a contact point at closures, in a file.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct ForceFile {
    /// A table in a file in place of `point_table`, with a header such as `closure [mm],force [N]`.
    pub file: ColumnFile,
    /// How the force runs between the closures.
    #[key(default = TableInterpolation::Monotone)]
    pub interpolation: TableInterpolation,
}

impl ForceFile {
    /// The law.
    pub(crate) fn pressure(&self) -> Pressure {
        let [closure, force] = self.file.columns.clone();
        Pressure::PointTable(ForceTable { closure, force, interpolation: self.interpolation })
    }
}

impl NormalLaw {
    /// Finds its file, which is relative to a folder, and refuses what makes no law.
    pub(super) fn admit(
        &mut self,
        section: &Section<'_>,
        folder: &Path,
        all_closed: bool,
    ) -> Result<(), Fault> {
        let Self::File(own) = self else { return Ok(()) };
        let Some(inner) = section.inner("normal")? else { return Ok(()) };
        let rules = [Dimension::LENGTH, Dimension::FORCE].map(|dimension| Number::any(dimension).scaled());
        own.file.find(&inner, "file", folder, (rules, "closure [mm],force [N]"))?;
        let column = |number, what| WrittenColumn::of_file(&inner, &own.file, number, what);
        check_columns(&column(0, CLOSURES), &column(1, FORCES))?;
        check_pressure(&own.pressure(), all_closed, section)
    }
}

/// Refuses columns that are no force or pressure which rises from zero with the closure.
fn check_columns(closures: &WrittenColumn<'_>, values: &WrittenColumn<'_>) -> Result<(), Fault> {
    closures.check_ascending()?;
    values.check_ascending()?;
    closures.check_zero(values)
}

/// Refuses a law in the case whose numbers make none.
pub(super) fn check_law(law: &Pressure, all_closed: bool, section: &Section<'_>) -> Result<(), Fault> {
    check_lists(law, section)?;
    check_pressure(law, all_closed, section)
}

/// Refuses columns of the case that are none.
fn check_lists(law: &Pressure, section: &Section<'_>) -> Result<(), Fault> {
    let (table, closures, (key, what, values)) = match law {
        Pressure::Table(own) => ("table", &own.closure, ("pressure", PRESSURES, &own.pressure)),
        Pressure::PointTable(own) => ("point_table", &own.closure, ("force", FORCES, &own.force)),
        _ => return Ok(()),
    };
    let Some(normal) = section.inner("normal")? else { return Ok(()) };
    normal.inner(table)?.map_or(Ok(()), |inner| {
        let closures = WrittenColumn::of_list(&inner, "closure", CLOSURES, closures);
        check_columns(&closures, &WrittenColumn::of_list(&inner, key, what, values))
    })
}

/// Refuses numbers that make no normal law, and forces of a contact that has opened.
fn check_pressure(law: &Pressure, all_closed: bool, section: &Section<'_>) -> Result<(), Fault> {
    let place = section.place_of(&["normal"]);
    law.check().map_err(|error| AssemblyProblem::Refused { reason: error.to_string() }.at(place))?;
    match law {
        Pressure::PointTable(own) if !all_closed && own.closure.iter().any(|closure| *closure < 0.0) => {
            let reason = "a contact that may open has no force at closures below zero; a spring that pulls stays closed, all_closed = true";
            Err(AssemblyProblem::Refused { reason: reason.to_owned() }.at(place))
        }
        _ => Ok(()),
    }
}

impl Setting for NormalLaw {
    type Rule = ();

    fn form((): &()) -> Allowed {
        let rigid = Allowed::Choice { words: &[(RIGID, "bodies do not pass into each other")] };
        Allowed::Either(vec![rigid, Pressure::form(&()), ForceFile::form(&())])
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        match node.data {
            Data::Table(ref table) => {
                let path = section.path(key);
                let title = format!("`{path}`");
                match table.entries.iter().any(|entry| entry.key == "file") {
                    true => read_settings(node, &path, &title).map(Self::File),
                    false => read_settings(node, &path, &title).map(Self::Compliant),
                }
            }
            _ => word(&section.path(key), "normal law", node, &[(RIGID, ())]).map(|()| Self::Rigid),
        }
    }

    fn write(&self, (): &()) -> Json {
        match self {
            Self::Rigid => json!(RIGID),
            Self::Compliant(law) => Setting::write(law, &()),
            Self::File(own) => Setting::write(own, &()),
        }
    }
}
