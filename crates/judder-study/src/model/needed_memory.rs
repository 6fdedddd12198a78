//! What an analysis needs of memory, and the one refusal of what the process may not take.

use super::{Analysed, Analysis, AnalysisPlace, Refusal, placed, wanted};
use crate::case::text::CaseText;
use crate::error::StudyError;
use judder_keys::problem::Problem;
use judder_memory::{BeyondMemory, MemoryBudget, in_words};
use std::borrow::Cow;
use thiserror::Error;

/// Bytes of the program with its figures and its report: small cases of the installed package take 38 to 52 MB in all. A build without optimisation takes about
/// twice as much.
pub const PROGRAM_BYTES: u128 = 44_000_000;

/// The memory that an analysis needs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NeededMemory {
    /// Bytes at its peak, beside those of the program.
    pub beside: u128,
    /// What is known of them.
    pub bound: MemoryBound,
    /// What takes them, in words.
    pub what: Cow<'static, str>,
    /// Which keys of the analysis decide how many, by their dotted paths in it: the first that it has is to blame, the analysis where it has none.
    pub keys: &'static [&'static str],
    /// What would take less, in words.
    pub advice: &'static str,
}

/// What is known of an amount of memory before anything is computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MemoryBound {
    /// It is near that.
    About,
    /// More is never taken; how much it is depends on what is found.
    AtMost,
    /// So much is taken whatever is found; what that adds is not known.
    AtLeast,
}

/// An analysis that would take more memory than there is for it.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("{what}: {source}")]
struct BudgetProblem {
    what: Cow<'static, str>,
    advice: &'static str,
    source: BeyondMemory,
}

impl Problem for BudgetProblem {
    fn kind(&self) -> &'static str {
        "Memory"
    }

    fn label(&self) -> &'static str {
        "too much"
    }

    fn help(&self) -> Option<String> {
        Some(self.source.remedy_or(self.advice))
    }
}

impl MemoryBound {
    /// In words, before the amount.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::About => "about",
            Self::AtMost => "at most",
            Self::AtLeast => "at least",
        }
    }
}

impl NeededMemory {
    /// Of what takes little beside the program, whatever is written.
    pub const LITTLE: Self = Self {
        beside: 0,
        bound: MemoryBound::About,
        what: Cow::Borrowed("the program and this analysis"),
        keys: &[],
        advice: "free some memory",
    };

    /// Bytes at the peak of a process that does nothing else, the program included.
    #[must_use]
    pub fn bytes(&self) -> u128 {
        PROGRAM_BYTES.saturating_add(self.beside)
    }

    /// `about 1.2 GB`, the program included.
    #[must_use]
    pub fn words(&self) -> String {
        format!("{} {}", self.bound.name(), in_words(self.bytes()))
    }

    /// Refuses what the process may not take.
    fn held(self) -> Result<Self, Refusal> {
        let budget = MemoryBudget::of_whole_process();
        match budget.ask(PROGRAM_BYTES) {
            // no key of the case would change that
            Err(source) if source.shared_by == 1 => {
                let (what, advice) = (Cow::Borrowed("the program itself"), "lift that limit");
                Err(Refusal::keys(&[], BudgetProblem { what, advice, source }))
            }
            _ => self.held_against(budget),
        }
    }

    /// Refuses what this budget has not.
    ///
    /// # Errors
    /// The refusal, of the keys that decide how much it is.
    pub fn held_against(self, budget: MemoryBudget) -> Result<Self, Refusal> {
        match budget.ask(self.bytes()) {
            Ok(()) => Ok(self),
            Err(source) => {
                let Self { what, keys, advice, .. } = self;
                Err(Refusal::keys(keys, BudgetProblem { what, advice, source }))
            }
        }
    }
}

/// What an analysis needs of memory; or its refusal, before anything is computed, for what [`Analysis::fits`] says or for memory that there is not.
///
/// # Errors
/// As [`Analysis::fits`].
fn admitted<M: Analysed>(
    asked: &M::Asked,
    of: &M::Known<'_>,
) -> Result<Result<NeededMemory, Refusal>, M::Error> {
    if let Err(refusal) = asked.fits(of)? {
        return Ok(Err(refusal));
    }
    Ok(asked.memory(of)?.held())
}

/// Admits the wanted analyses of a case, each with what is known by its name.
///
/// # Errors
/// The first refusal, at its place in the case file.
pub fn admit<'a, C: Analysed>(
    case: &'a C,
    file: &'a CaseText,
    is_wanted: &'a dyn Fn(&str) -> bool,
    known: impl Fn(&'a str) -> C::Known<'a>,
) -> Result<(), StudyError> {
    for (place, asked) in wanted(case, file, is_wanted) {
        let admitted = admitted::<C>(asked, &known(place.name)).map_err(Into::into)?;
        admitted.map_err(|refusal| refusal.placed(place))?;
    }
    Ok(())
}

/// What each analysis of a case would take, in their order: what its model tells of it, and its memory.
///
/// # Errors
/// As of [`admit`], and what [`Analysis::admit`] refuses.
pub fn estimates<'a, C: Analysed>(
    case: &'a C,
    file: &'a CaseText,
    known: impl Fn(&'a str) -> C::Known<'a>,
) -> Result<Vec<(C::Estimate, NeededMemory)>, StudyError> {
    let of_one = |(AnalysisPlace { index, name, .. }, asked): (AnalysisPlace<'a>, &C::Asked)| {
        let known = known(name);
        let admitted = admitted::<C>(asked, &known).map_err(Into::into)?;
        let memory = admitted.map_err(|refusal| refusal.placed(AnalysisPlace { file, index, name }))?;
        asked.admit(&known).map_err(|error| placed(error.into(), case, file, index))?;
        Ok((asked.estimate(&known).map_err(Into::into)?, memory))
    };
    wanted(case, file, &|_| true).map(of_one).collect()
}
