//! The way in: a path or a text with its `--set` options becomes a validated case.

use crate::case::study_sweep::problem::SweepProblem;
use crate::case::study_sweep::{self, StudySweep, read_sweeps};
use crate::case::text::CaseText;
use crate::case::tree::CaseTree;
use crate::model::Case;
use crate::registry::Registry;
use judder_keys::declared::both;
use judder_keys::document::Node;
use judder_keys::error::{CaseError, Fault};
use std::ops::Deref;
use std::path::Path;
use std::sync::Arc;

/// A case file that was read and found valid.
#[derive(Debug, Clone)]
pub struct CaseFile {
    /// Its text, with the options.
    pub source: CaseText,
    /// The case, with the options applied.
    pub case: Case,
    /// The sweeps of the whole case, in the order of the file.
    pub sweeps: Vec<StudySweep>,
    /// What the case was read from, to read it anew at the points of a sweep.
    tree: Arc<CaseTree>,
}

impl Deref for CaseFile {
    type Target = CaseText;

    fn deref(&self) -> &CaseText {
        &self.source
    }
}

impl CaseFile {
    /// Reads and validates the case file at `path` with the options `--set key=value`.
    ///
    /// # Errors
    /// [`CaseError`] with the cause, the place in file or option, and what would be right.
    pub fn read(registry: Registry, path: impl AsRef<Path>, overrides: &[String]) -> Result<Self, CaseError> {
        Self::of(registry, CaseText::read(path.as_ref(), overrides)?)
    }

    /// Validates the text of a case file; `name`, a path or any word, is what errors call it.
    ///
    /// # Errors
    /// [`CaseError`] with the cause, the place in text or option, and what would be right.
    pub fn parse(
        registry: Registry,
        name: &str,
        text: &str,
        overrides: &[String],
    ) -> Result<Self, CaseError> {
        Self::of(registry, CaseText::new(name, text, overrides))
    }

    fn of(registry: Registry, source: CaseText) -> Result<Self, CaseError> {
        let read = || read_case(registry, &source, source.tree()?);
        let (case, sweeps, tree) = read().map_err(|fault| source.faulty(fault))?;
        Ok(Self { source, case, sweeps, tree: Arc::new(tree) })
    }

    /// The models among which it found its own.
    #[must_use]
    pub fn registry(&self) -> Registry {
        self.tree.registry
    }

    /// The case at a point of a sweep of it: read anew with the swept keys at these values, in SI units or plain numbers, one a key in
    /// the order of the sweep; with its analyses, without sweeps.
    ///
    /// # Errors
    /// [`SweepProblem`] at the swept key where there is no such case, with the keys to blame, the reason, and what would be right.
    pub fn at(&self, sweep: &StudySweep, values: &[f64]) -> Result<Self, CaseError> {
        if values.len() != sweep.axes.len() {
            let (name, expected, found) = (sweep.name.clone(), sweep.axes.len(), values.len());
            let problem = SweepProblem::ValueCount { name, expected, found };
            return Err(self.error_at(["sweep", &sweep.name], problem.into()));
        }
        let (tree, case) = study_sweep::at(&self.tree, &sweep.axes, values).map_err(|refusal| {
            let steps = sweep.steps_to(&refusal);
            self.error_at(steps.iter().map(String::as_str), refusal.problem.into())
        })?;
        Ok(Self { source: self.source.clone(), case, sweeps: Vec::new(), tree: Arc::new(tree) })
    }
}

fn read_case(
    registry: Registry,
    source: &CaseText,
    mut root: Node,
) -> Result<(Case, Vec<StudySweep>, CaseTree), Fault> {
    let sweeps = root.take("sweep");
    let tree = CaseTree { root, folder: source.folder(), registry };
    let case = tree.read();
    let read = |node| read_sweeps(&node, &tree, case.as_ref().ok());
    let sweeps = sweeps.map_or_else(|| Ok(Vec::new()), read);
    let (case, sweeps) = both(case, sweeps)?;
    Ok((case, sweeps, tree))
}

/// What is wrong with a text and its options, without these parts of the case; `None` where nothing is.
pub fn given_error(
    registry: Registry,
    name: &str,
    text: &str,
    overrides: &[String],
    without: &[&str],
) -> Option<CaseError> {
    let source = CaseText::new(name, text, overrides);
    let read = || {
        let mut root = source.tree()?;
        for part in without {
            root.take(part);
        }
        read_case(registry, &source, root)
    };
    read().err().map(|fault| source.faulty(fault))
}
