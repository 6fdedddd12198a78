//! One analysis at a time, from where an interrupted run has left it.

use crate::case::file::{Case, CaseFile};
use crate::error::StudyError;
use crate::kept::{Kept, Place};
use crate::ledger::VERSION;
use crate::model::{Prepared, Task, placed};
use crate::outcome::Outcome;
use crate::progress::Progress;
use judder_store::{Scratch, StudyFolder, content_hash};
use serde_json::Value;

/// All that the analyses of a case are run with.
pub(super) struct Bench<'a> {
    pub(super) file: &'a CaseFile,
    pub(super) prepared: &'a Prepared,
    pub(super) store: &'a StudyFolder,
    /// The names of the analyses with their hashes.
    pub(super) all: &'a [(String, String)],
    /// What the law depends on that they share.
    pub(super) law: Option<&'a str>,
}

impl Bench<'_> {
    /// Runs an analysis from where an interrupted run has left it; its scratch can go when the outcome is stored.
    pub(super) fn run(
        &self,
        index: usize,
        progress: &dyn Progress,
    ) -> Result<(Result<Outcome, StudyError>, Scratch), StudyError> {
        let Self { file, store, all, .. } = self;
        let (name, hash) = &all[index];
        progress.begin(name, file.case.steps(index));
        // under a name that the shared law does not have
        let scratch = store.scratch(&format!("of-{name}"), hash)?;
        // a line that cannot be kept costs a rerun, no result
        let keep = |line: &str| {
            let _ = scratch.keep(line);
        };
        let shared = self.law.map(|of| store.scratch(LAW_POINTS, of)).transpose()?;
        let keep_shared = |line: &str| {
            let _ = shared.as_ref().map(|shared| shared.keep(line));
        };
        let place = Place { study: store, analysis: name, hash, all };
        let own = Kept { lines: scratch.lines(), keep: &keep, place: Some(place) };
        let lines = shared.as_ref().map_or(&[][..], Scratch::lines);
        let of_law = Kept { lines, keep: &keep_shared, place: None };
        let task = Task { law: of_law, own, ..Task::alone(self.prepared, progress) };
        let outcome = file.case.run(index, task);
        progress.end();
        Ok((outcome.map_err(|error| placed(error, file, index)), scratch))
    }

    /// Forgets the solved contacts of the shared law once no analysis needs them.
    pub(super) fn discard_law(&self) -> Result<(), StudyError> {
        let Some(law) = self.law else { return Ok(()) };
        for (name, hash) in self.all {
            if !self.store.is_done(name, hash)? {
                return Ok(());
            }
        }
        Ok(self.store.scratch(LAW_POINTS, law)?.discard()?)
    }
}

/// Where the solved contacts of the law are kept that the analyses of an oscillator case share.
const LAW_POINTS: &str = "law";

/// The hash of what the law depends on that a case has computed for all its analyses; `None` where it has none.
pub(super) fn shared_law(case: &Case, resolved: &Value) -> Option<String> {
    let of: Value = [VERSION.into()].into_iter().chain(case.shared_law(resolved)?).collect();
    Some(content_hash(of.to_string().as_bytes()))
}
