//! Two structures in sliding contact.
//!
//! - `system`: from the keys of a case to a slider on its track.
//! - `blame`: which key is to blame for what an analysis found.
//! - [`coupled_pair`]: the pair for whoever marches it by himself.
//! - [`shapes`]: the shapes in which the pair swings at any position, on all points of both structures.
//! - `check`: what `judder check` shows; `cost`: what steps, values and freedoms take; `pair_size`: what the pair takes of memory.
//! - A folder each: `modes`, `locus`, `growth`, `march`, `spectrogram`.

mod blame;
pub mod case;
mod check;
mod cost;
pub mod coupled_pair;
pub mod growth;
pub mod locus;
pub mod march;
pub mod modes;
mod pair_size;
pub mod shapes;
pub mod spectrogram;
pub(crate) mod system;

use crate::error::ModelError;
use crate::estimate::Estimate;
use crate::measured_growth;
use crate::sliding::case::{SlidingCase, SlidingSections};
use crate::told_quantities::quantities;
use judder_keys::declared::Settings;
use judder_keys::document::{Data, Node};
use judder_keys::error::Fault;
use judder_keys::file_reference::FileReference;
use judder_study::StudyError;
use judder_study::case::analysis::{Kinds, Planned};
use judder_study::case::text::CaseText;
use judder_study::model::{Analysed, Analysis, Case, Model, Prepared, Refusal, Task, admit};
use judder_study::outcome::Outcome;
use judder_study::registry::{KindTables, ModelKind, Template};
use judder_study::resolve::Resolved;
use spectrogram::settings::check_references;
use std::path::Path;
use std::sync::Arc;
use system::ReducedPair;

/// The kinds of analyses.
pub(crate) static KINDS: Kinds<Option<SlidingCase>, Arc<dyn Analysis<SlidingCase>>> =
    Kinds::new(&[modes::KIND, locus::KIND, march::KIND, growth::KIND, spectrogram::KIND]);

/// A pair, and the name of an analysis of it.
pub struct SlidingSubject<'a> {
    case: &'a SlidingCase,
    system: &'a ReducedPair,
    name: &'a str,
}

impl Analysed for SlidingCase {
    const NAME: &'static str = MODEL.name;

    type Asked = dyn Analysis<Self>;
    type Subject<'a> = SlidingSubject<'a>;
    type Known<'a> = SlidingSubject<'a>;
    type Estimate = Estimate;
    type Error = ModelError;

    fn analyses(&self) -> &[Planned<Arc<Self::Asked>>] {
        &self.analyses
    }

    fn blame(error: &ModelError) -> Option<Refusal> {
        blame::blame(error)
    }
}

/// The pair, where the wanted analyses are admitted.
fn fitting(
    case: &SlidingCase,
    system: ReducedPair,
    file: &CaseText,
    is_wanted: &dyn Fn(&str) -> bool,
) -> Result<Prepared, StudyError> {
    admit(case, file, is_wanted, |name| SlidingSubject { case, system: &system, name })?;
    Ok(Prepared::new(Arc::new(system)))
}

/// Reads a case from the root of its tree; files are relative to `folder`.
fn read(root: &Node, folder: &Path) -> Result<SlidingCase, Fault> {
    let case = case::read(root, folder)?;
    if let Some(Node { data: Data::List(nodes), .. }) = root.entry("analysis") {
        check_references(&case.analyses, &case.points, nodes)?;
    }
    Ok(case)
}

/// The model.
pub const MODEL: ModelKind = ModelKind {
    name: "sliding",
    read: |root, folder| read(root, folder).map(Case::new),
    doc: "one structure slides along another",
    declared: SlidingSections::declarations,
    swept: Vec::new,
    prose: include_str!("reference.md"),
    template: Template { name: "beams-paper", text: include_str!("template.toml"), lines: |_| String::new() },
    kinds: || KINDS.entries(),
    operating_quantities: &[],
    tables: &[
        KindTables::new(locus::KIND.name, |told| locus::tables::report(told.results)),
        KindTables::new(march::KIND.name, |told| march::tables::report(told.results)),
        KindTables::new(growth::KIND.name, |told| {
            quantities("Growth of the mode", told.results, measured_growth::TOLD)
        }),
        KindTables::new(spectrogram::KIND.name, |told| {
            quantities("The loudest", told.results, crate::spectrogram::TOLD)
        }),
        KindTables::new(modes::KIND.name, |told| crate::structure::modes::tables::report(told.results)),
    ],
};

impl Model for SlidingCase {
    fn files(&self) -> Vec<&FileReference> {
        SlidingCase::files(self)
    }

    fn resolved(&self) -> serde_json::Value {
        SlidingCase::resolved(self)
    }

    fn prepared(&self) -> Result<Prepared, StudyError> {
        let made = ReducedPair::new(self).map_err(ModelError::from)?;
        Ok(Prepared::new(Arc::new(made)))
    }

    fn preflight(&self, file: &CaseText, is_wanted: &dyn Fn(&str) -> bool) -> Result<Prepared, StudyError> {
        let system = ReducedPair::new(self).map_err(|uncoupled| uncoupled.placed(file))?;
        fitting(self, system, file, is_wanted)
    }

    fn preflight_at(
        &self,
        file: &CaseText,
        is_wanted: &dyn Fn(&str) -> bool,
        known: &Prepared,
        keys: &[&str],
    ) -> Result<Prepared, StudyError> {
        let Some(known) = known.get::<ReducedPair>() else { return self.preflight(file, is_wanted) };
        let system = known.swept(self, keys).map_err(|uncoupled| uncoupled.placed(file))?;
        fitting(self, system, file, is_wanted)
    }

    fn run(&self, index: usize, task: Task<'_>) -> Result<Outcome, StudyError> {
        if task.progress.interrupted() {
            return Err(StudyError::Interrupted);
        }
        let own = &self.analyses[index];
        let system = match task.prepared.get::<ReducedPair>() {
            Some(system) => system,
            None => Arc::new(ReducedPair::new(self).map_err(ModelError::from)?),
        };
        let subject = SlidingSubject { case: self, system: &system, name: &own.name };
        let mut outcome = own.kind.run(&subject, task)?;
        outcome.warnings.extend(system.warnings.iter().cloned());
        Ok(outcome)
    }

    fn resolve(&self, file: &CaseText, resolved: serde_json::Value) -> Result<Resolved, StudyError> {
        Ok(check::resolve(file, self, resolved)?)
    }
}
