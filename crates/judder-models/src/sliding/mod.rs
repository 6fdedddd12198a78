//! Two structures in sliding contact.
//!
//! - `system`: from the keys of a case to a slider on its track.
//! - `blame`: which key is to blame for what an analysis found.
//! - [`coupled_pair`]: the pair for whoever marches it by himself.
//! - [`shapes`]: the shapes in which the pair swings at any position, on all points of both structures.
//! - `check`: what `judder check` shows; `cost`: what steps, values and freedoms take.
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
pub(crate) mod reference;
pub(crate) mod resolved;
pub(crate) mod schema;
pub mod shapes;
pub mod spectrogram;
mod system;

use crate::error::ModelError;
use crate::estimate::Estimate;
use crate::sliding::case::{SlidingCase, SystemKeys};
use judder_keys::declared::Settings;
use judder_keys::error::CaseError;
use judder_keys::file_reference::FileReference;
use judder_store::Declared;
use judder_study::StudyError;
use judder_study::case::analysis::Kind;
use judder_study::case::analysis::names;
use judder_study::case::file::{Case, CaseFile};
use judder_study::model::{Analysed, Analysis, Model, Place, Prepared, Task};
use judder_study::outcome::Outcome;
use judder_study::registry::{ModelKind, entries};
use judder_study::resolve::Resolved;
use std::sync::Arc;
use system::SlidingSystem;

/// The kinds of analyses.
pub(crate) static KINDS: [Kind<SlidingCase, Arc<dyn Analysis<SlidingCase>>>; 5] =
    [modes::KIND, locus::KIND, march::KIND, growth::KIND, spectrogram::KIND];

/// A pair, and the name of an analysis of it.
pub struct Subject<'a> {
    case: &'a SlidingCase,
    system: &'a SlidingSystem,
    name: &'a str,
}

impl Analysed for SlidingCase {
    type Subject<'a> = Subject<'a>;
    type Known<'a> = Subject<'a>;
    type Estimate = Estimate;
    type Error = ModelError;
}

/// The pair, where what the wanted analyses keep fits.
fn fitting(
    (case, system): (&SlidingCase, SlidingSystem),
    file: &CaseFile,
    is_wanted: &dyn Fn(&str) -> bool,
) -> Result<Prepared, ModelError> {
    for (index, own) in case.analyses.iter().enumerate().filter(|(_, own)| is_wanted(&own.name)) {
        let subject = Subject { case, system: &system, name: &own.name };
        let place = Place { file, index, name: &own.name };
        own.kind.fits(&subject)?.map_err(|refusal| refusal.placed(place))?;
    }
    Ok(Prepared::new(Arc::new(system)))
}

/// The model.
pub(crate) const MODEL: ModelKind = ModelKind {
    name: "sliding",
    read: |root, folder| case::read(root, folder).map(Case::new),
    declared: SystemKeys::declarations,
    swept: Vec::new,
    schema: schema::case,
    reference: reference::section,
    kinds: || entries(&KINDS),
    operating_quantities: &[],
};

impl Model for SlidingCase {
    fn name(&self) -> &'static str {
        MODEL.name
    }

    fn analysis_names(&self) -> Vec<&str> {
        names(&self.analyses)
    }

    fn takes_up(&self, analysis: &str) -> Vec<&str> {
        let found = self.analyses.iter().find(|own| own.name == analysis);
        found.map_or_else(Vec::new, |found| found.kind.takes_up())
    }

    fn summary_keys(&self, index: usize) -> Vec<Declared> {
        self.analyses[index].kind.summary_keys()
    }

    fn files(&self) -> Vec<&FileReference> {
        SlidingCase::files(self)
    }

    fn resolved(&self) -> serde_json::Value {
        resolved::case(self)
    }

    fn prepared(&self) -> Result<Prepared, StudyError> {
        let made = SlidingSystem::new(self).map_err(ModelError::from)?;
        Ok(Prepared::new(Arc::new(made)))
    }

    fn preflight(&self, file: &CaseFile, is_wanted: &dyn Fn(&str) -> bool) -> Result<Prepared, StudyError> {
        let system = SlidingSystem::new(self).map_err(|uncoupled| uncoupled.placed(file))?;
        Ok(fitting((self, system), file, is_wanted)?)
    }

    fn preflight_at(
        &self,
        file: &CaseFile,
        is_wanted: &dyn Fn(&str) -> bool,
        (known, keys): (&Prepared, &[&str]),
    ) -> Result<Prepared, StudyError> {
        let Some(known) = known.get::<SlidingSystem>() else { return self.preflight(file, is_wanted) };
        let system = known.swept(self, keys).map_err(|uncoupled| uncoupled.placed(file))?;
        Ok(fitting((self, system), file, is_wanted)?)
    }

    fn steps(&self, index: usize) -> usize {
        self.analyses[index].kind.steps()
    }

    fn run(&self, index: usize, task: Task<'_>) -> Result<Outcome, StudyError> {
        if task.progress.interrupted() {
            return Err(StudyError::Interrupted);
        }
        let own = &self.analyses[index];
        let system = match task.prepared.get::<SlidingSystem>() {
            Some(system) => system,
            None => Arc::new(SlidingSystem::new(self).map_err(ModelError::from)?),
        };
        let subject = Subject { case: self, system: &system, name: &own.name };
        let mut outcome = own.kind.run(&subject, task)?;
        outcome.warnings.extend(system.warnings.iter().cloned());
        Ok(outcome)
    }

    fn blamed(&self, error: &StudyError, place: Place<'_>) -> Option<CaseError> {
        let (own, error) = (&self.analyses.get(place.index)?.kind, ModelError::of(error)?);
        let refusal = own.blame(error).or_else(|| blame::blame(error))?;
        Some(refusal.placed(place))
    }

    fn resolve(&self, file: &CaseFile) -> Result<Resolved, StudyError> {
        Ok(check::resolve(file, self)?)
    }
}
