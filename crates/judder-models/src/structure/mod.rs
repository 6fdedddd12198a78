//! One linear structure alone.
//!
//! - `build`: from the keys of a case to matrices.
//! - `undamped`: mass and stiffness, without damping and friction.
//! - `solved_size`: what solving it needs of memory.
//! - `fields`, `shapes`, `shape_panels`: shapes as files, as arrays, as pictures. `vectors`: those of imported matrices on their freedoms.
//! - `check`: what `judder check` shows.
//! - A folder each: `modes`, `reduction`, `eigen`, `eigen_sweep`, `receptance`.

pub(crate) mod build;
pub mod case;
mod check;
pub mod eigen;
pub mod eigen_sweep;
mod fields;
pub mod modes;
pub mod receptance;
pub mod reduction;
pub(crate) mod shape_panels;
pub(crate) mod shapes;
pub(crate) mod solved_size;
pub(crate) mod undamped;
pub(crate) mod vectors;

use crate::error::ModelError;
use crate::structure::case::scope::StructureScope;
use crate::structure::case::{StructureCase, StructureSections};
use crate::told_quantities::quantities;
use build::Structure;
use judder_keys::declared::Settings;
use judder_keys::file_reference::FileReference;
use judder_study::StudyError;
use judder_study::case::analysis::{Kinds, Planned};
use judder_study::case::text::CaseText;
use judder_study::model::{Analysed, Analysis, Case, Model, Prepared, Task, admit};
use judder_study::outcome::Outcome;
use judder_study::registry::{KindTables, ModelKind, Template};
use judder_study::resolve::Resolved;
use std::sync::Arc;

/// The kinds of analyses.
pub(crate) static KINDS: Kinds<StructureScope, Arc<dyn Analysis<StructureCase>>> =
    Kinds::new(&[modes::KIND, reduction::KIND, eigen::KIND, eigen_sweep::KIND, receptance::KIND]);

/// A structure, and the name under which an analysis of it leaves files.
pub struct StructureSubject<'a> {
    case: &'a StructureCase,
    structure: &'a Structure,
    name: &'a str,
}

impl Analysed for StructureCase {
    const NAME: &'static str = MODEL.name;

    type Asked = dyn Analysis<Self>;
    type Subject<'a> = StructureSubject<'a>;
    type Known<'a> = StructureSubject<'a>;
    /// What is asked, in words.
    type Estimate = String;
    type Error = ModelError;

    fn analyses(&self) -> &[Planned<Arc<Self::Asked>>] {
        &self.analyses
    }
}

/// The structure, where the wanted analyses are admitted.
fn fitting(
    case: &StructureCase,
    prepared: Prepared,
    file: &CaseText,
    is_wanted: &dyn Fn(&str) -> bool,
) -> Result<Prepared, StudyError> {
    let Some(structure) = prepared.get::<Structure>() else { return Ok(prepared) };
    admit(case, file, is_wanted, |name| StructureSubject { case, structure: &structure, name })?;
    Ok(prepared)
}

/// The model.
pub const MODEL: ModelKind = ModelKind {
    name: "structure",
    read: |root, folder| case::read(root, folder).map(Case::new),
    doc: "one linear structure alone",
    declared: StructureSections::declarations,
    swept: Vec::new,
    prose: include_str!("reference.md"),
    template: Template { name: "structure", text: include_str!("template.toml"), lines: |_| String::new() },
    kinds: || KINDS.entries(),
    operating_quantities: &[],
    tables: &[
        KindTables::new(eigen::KIND.name, |told| eigen::tables::report(told.results)),
        KindTables::new(eigen_sweep::KIND.name, |told| eigen_sweep::tables::report(told.results)),
        KindTables::new(receptance::KIND.name, |told| {
            quantities("The receptance", told.results, receptance::TOLD)
        }),
        KindTables::new(reduction::KIND.name, |told| reduction::tables::report(told.results)),
        KindTables::new(modes::KIND.name, |told| modes::tables::report(told.results)),
    ],
};

impl Model for StructureCase {
    fn files(&self) -> Vec<&FileReference> {
        StructureCase::files(self)
    }

    fn resolved(&self) -> serde_json::Value {
        StructureCase::resolved(self)
    }

    fn prepared(&self) -> Result<Prepared, StudyError> {
        let made = Structure::new(self).map_err(ModelError::from)?;
        Ok(Prepared::new(Arc::new(made)))
    }

    fn preflight(&self, file: &CaseText, is_wanted: &dyn Fn(&str) -> bool) -> Result<Prepared, StudyError> {
        let structure = Structure::new(self).map_err(|unbuilt| unbuilt.placed(file))?;
        fitting(self, Prepared::new(Arc::new(structure)), file, is_wanted)
    }

    fn preflight_at(
        &self,
        file: &CaseText,
        is_wanted: &dyn Fn(&str) -> bool,
        known: &Prepared,
        keys: &[&str],
    ) -> Result<Prepared, StudyError> {
        let is_of_analyses = keys.iter().all(|key| key.starts_with("analysis."));
        if is_of_analyses {
            fitting(self, known.clone(), file, is_wanted)
        } else {
            self.preflight(file, is_wanted)
        }
    }

    fn run(&self, index: usize, task: Task<'_>) -> Result<Outcome, StudyError> {
        if task.progress.interrupted() {
            return Err(StudyError::Interrupted);
        }
        let own = &self.analyses[index];
        let structure = match task.prepared.get::<Structure>() {
            Some(structure) => structure,
            None => Arc::new(Structure::new(self).map_err(ModelError::from)?),
        };
        let subject = StructureSubject { case: self, structure: &structure, name: &own.name };
        let progress = task.progress;
        let mut outcome = own.kind.run(&subject, task)?;
        progress.advance();
        outcome.warnings.extend(structure.warnings.iter().cloned());
        Ok(outcome)
    }

    fn resolve(&self, file: &CaseText, resolved: serde_json::Value) -> Result<Resolved, StudyError> {
        Ok(check::resolve(file, self, resolved)?)
    }
}
