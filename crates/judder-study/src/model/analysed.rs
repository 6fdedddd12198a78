//! The analyses of a case: what a model says of them, and what follows of that whatever the model.

use super::{AnalysisPlace, NeededMemory, OperatingQuantity, Refusal, Task};
use crate::case::analysis::{AsAny, Planned, names};
use crate::case::text::CaseText;
use crate::error::StudyError;
use crate::outcome::Outcome;
use dyn_clone::DynClone;
use judder_keys::error::CaseError;
use judder_keys::file_reference::FileReference;
use judder_store::Declared;
use serde_json::{Map, Value};
use std::any::Any;
use std::fmt;
use std::sync::Arc;

/// An analysis of a model: what it announces, is refused for, computes and takes.
pub trait Analysis<M: Analysed + ?Sized>: AsAny + DynClone + fmt::Debug + Send + Sync {
    /// How many steps it announces to its progress.
    fn steps(&self) -> usize {
        1
    }

    /// How many freedoms of motion it takes at most, for a model that knows of them before it makes what has them; none where it takes any number.
    fn most_freedoms(&self) -> Option<usize> {
        None
    }

    /// Refuses what is known to be too much before anything is computed.
    ///
    /// # Errors
    /// The key to blame, and why.
    fn fits(&self, _of: &M::Known<'_>) -> Result<Result<(), Refusal>, M::Error> {
        Ok(Ok(()))
    }

    /// The memory that it needs, which [`admit`](super::admit) holds against the budget of the process.
    ///
    /// # Errors
    /// What cannot be read.
    fn memory(&self, _of: &M::Known<'_>) -> Result<NeededMemory, M::Error> {
        Ok(NeededMemory::LITTLE)
    }

    /// Refuses what its first step would refuse, for `judder check`, which computes nothing.
    ///
    /// # Errors
    /// As [`Analysis::run`].
    fn admit(&self, _of: &M::Known<'_>) -> Result<(), M::Error> {
        Ok(())
    }

    /// Computes it.
    ///
    /// # Errors
    /// [`StudyError::Interrupted`], or what it is refused for.
    fn run(&self, of: &M::Subject<'_>, task: Task<'_>) -> Result<Outcome, M::Error>;

    /// Which of its own keys is to blame for what it found; `None` where that does not depend on the kind.
    fn blame(&self, _error: &M::Error) -> Option<Refusal> {
        None
    }

    /// What it would take.
    ///
    /// # Errors
    /// What cannot be read.
    fn estimate(&self, of: &M::Known<'_>) -> Result<M::Estimate, M::Error>;

    /// The keys of its summary.
    fn summary_keys(&self) -> Vec<Declared>;

    /// The names of the analyses whose results it takes up.
    fn takes_up(&self) -> Vec<&str> {
        Vec::new()
    }

    /// The files that it names, which its case tells with its own.
    fn files(&self) -> Vec<&FileReference> {
        Vec::new()
    }

    /// Puts its settings into a canonical form.
    fn write(&self, json: &mut Map<String, Value>);
}

/// A case with its analyses, and what they have in common.
pub trait Analysed {
    /// The name of its model in a case file.
    const NAME: &'static str;
    /// The quantities of its operating point that a sweep can ask for; none without an operating point.
    const OPERATING_QUANTITIES: &'static [OperatingQuantity] = &[];
    /// Keys of its analyses that decide whether there is a result, not which: they are in no hash.
    const LIMITS: &'static [&'static str] = &[];

    /// What its model asks of an analysis.
    type Asked: Analysis<Self> + ?Sized;
    /// What they are run on.
    type Subject<'a>;
    /// What is known of it before anything is computed.
    type Known<'a>;
    /// What is told of one before it runs.
    type Estimate;
    /// What is wrong with one.
    type Error: Into<StudyError> + Any;

    /// The analyses in the order of the case file.
    fn analyses(&self) -> &[Planned<Arc<Self::Asked>>];

    /// The keys of a summary that any analysis of this case may have beside its own.
    fn common_summary_keys(&self) -> Vec<Declared> {
        Vec::new()
    }

    /// Which key is to blame for what any analysis may find; `None` where no key is.
    fn blame(_error: &Self::Error) -> Option<Refusal> {
        None
    }
}

/// What is known of the analyses of a case, whatever its model.
pub trait Analyses {
    /// The name of the model in a case file.
    fn name(&self) -> &'static str;

    /// The quantities of the operating point that a sweep can ask for; none without an operating point.
    fn operating_quantities(&self) -> &'static [OperatingQuantity];

    /// Keys of analyses that decide whether there is a result, not which.
    fn limits(&self) -> &'static [&'static str];

    /// The names of the analyses, in their order.
    fn analysis_names(&self) -> Vec<&str>;

    /// The name of the kind of an analysis, by its position.
    fn kind_name(&self, index: usize) -> &'static str;

    /// How many steps an analysis announces to its progress.
    fn steps(&self, index: usize) -> usize;

    /// The keys of the summary of an analysis, by its position.
    fn summary_keys(&self, index: usize) -> Vec<Declared>;

    /// The names of the analyses whose results an analysis takes up.
    fn takes_up(&self, analysis: &str) -> Vec<&str>;

    /// The place in the case file of what a run found wrong with an analysis; `None` where no key is to blame.
    fn blamed(&self, error: &StudyError, place: AnalysisPlace<'_>) -> Option<CaseError>;
}

impl<C: Analysed> Analyses for C {
    fn name(&self) -> &'static str {
        C::NAME
    }

    fn operating_quantities(&self) -> &'static [OperatingQuantity] {
        C::OPERATING_QUANTITIES
    }

    fn limits(&self) -> &'static [&'static str] {
        C::LIMITS
    }

    fn analysis_names(&self) -> Vec<&str> {
        names(self.analyses())
    }

    fn kind_name(&self, index: usize) -> &'static str {
        self.analyses()[index].kind_name
    }

    fn steps(&self, index: usize) -> usize {
        self.analyses()[index].kind.steps()
    }

    fn summary_keys(&self, index: usize) -> Vec<Declared> {
        [self.analyses()[index].kind.summary_keys(), self.common_summary_keys()].concat()
    }

    fn takes_up(&self, analysis: &str) -> Vec<&str> {
        let found = self.analyses().iter().find(|own| own.name == analysis);
        found.map_or_else(Vec::new, |found| found.kind.takes_up())
    }

    fn blamed(&self, error: &StudyError, place: AnalysisPlace<'_>) -> Option<CaseError> {
        let StudyError::Model(fault) = error else { return None };
        let error = (fault.as_ref() as &dyn Any).downcast_ref::<C::Error>()?;
        let own = self.analyses().get(place.index)?;
        Some(own.kind.blame(error).or_else(|| C::blame(error))?.placed(place))
    }
}

/// The analyses of a case that are wanted, by their names, each with its place in the case file.
pub fn wanted<'a, C: Analysed>(
    case: &'a C,
    file: &'a CaseText,
    is_wanted: &'a dyn Fn(&str) -> bool,
) -> impl Iterator<Item = (AnalysisPlace<'a>, &'a C::Asked)> {
    let placed = move |(index, own): (usize, &'a Planned<Arc<C::Asked>>)| {
        (AnalysisPlace { file, index, name: &own.name }, &*own.kind)
    };
    case.analyses().iter().enumerate().filter(|(_, own)| is_wanted(&own.name)).map(placed)
}
