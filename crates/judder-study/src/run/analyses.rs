//! The analyses of a case, one at a time, from where an interrupted run has left it.

use crate::case::file::CaseFile;
use crate::error::StudyError;
use crate::kept::{KeptLines, StudyPlace};
use crate::model::{Case, Prepared, Task, placed};
use crate::outcome::Outcome;
use crate::progress::Progress;
use crate::version::version;
use judder_store::{Scratch, StudyFolder, content_hash};
use serde_json::Value;

/// All that the analyses of a case are run with.
pub(super) struct AnalysisRunner<'a> {
    pub(super) file: &'a CaseFile,
    pub(super) prepared: &'a Prepared,
    pub(super) store: &'a StudyFolder,
    /// The names of the analyses with their hashes.
    pub(super) all: &'a [(String, String)],
    /// The hash of what they share that takes long to compute.
    pub(super) shared: Option<&'a str>,
}

impl AnalysisRunner<'_> {
    /// Runs an analysis from where an interrupted run has left it; its scratch can go when the outcome is stored.
    pub(super) fn run(
        &self,
        index: usize,
        progress: &dyn Progress,
    ) -> Result<(Result<Outcome, StudyError>, Scratch), StudyError> {
        let Self { file, store, all, .. } = self;
        let (name, hash) = &all[index];
        progress.begin(name, file.case.steps(index));
        let scratch = store.scratch(name, hash)?;
        // a line that cannot be kept costs a rerun, no result
        let keep = |line: &str| {
            let _ = scratch.keep(line);
        };
        let shared = self.shared.map(|of| store.shared_scratch(SHARED, of)).transpose()?;
        let keep_shared = |line: &str| {
            let _ = shared.as_ref().map(|shared| shared.keep(line));
        };
        let place = StudyPlace { study: store, analysis: name, hash, all };
        let own = KeptLines { lines: scratch.lines(), keep: &keep, place: Some(place) };
        let lines = shared.as_ref().map_or(&[][..], Scratch::lines);
        let of_shared = KeptLines { lines, keep: &keep_shared, place: None };
        let task = Task { shared: of_shared, own, ..Task::alone(self.prepared, progress) };
        let outcome = file.case.run(index, task);
        progress.end();
        Ok((outcome.map_err(|error| placed(error, &*file.case, file, index)), scratch))
    }

    /// Forgets what they share once no analysis needs it.
    pub(super) fn discard_shared(&self) -> Result<(), StudyError> {
        let Some(shared) = self.shared else { return Ok(()) };
        for (name, hash) in self.all {
            if !self.store.is_done(name, hash)? {
                return Ok(());
            }
        }
        Ok(self.store.shared_scratch(SHARED, shared)?.discard()?)
    }
}

/// Where that is kept: a contact law is what takes long.
const SHARED: &str = "law";

/// The hash of what that depends on which a case has computed once for all its analyses; `None` where it has nothing such.
pub(super) fn shared(case: &Case, resolved: &Value) -> Option<String> {
    let of: Value = [version().into()].into_iter().chain(case.shared(resolved)?).collect();
    Some(content_hash(of.to_string().as_bytes()))
}
