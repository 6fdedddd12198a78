//! What a case is read from: the values of its text, anew at each point of a sweep.

use crate::model::Case;
use crate::registry::Registry;
use judder_keys::document::Node;
use judder_keys::error::Fault;
use std::fmt;
use std::path::PathBuf;

/// The values of a case file and its options, without sweeps, the folder to which its files are relative, and the models that there are.
#[derive(Clone)]
pub(crate) struct CaseTree {
    pub(crate) root: Node,
    pub(crate) folder: PathBuf,
    pub(crate) registry: Registry,
}

impl fmt::Debug for CaseTree {
    /// The folder alone: the typed case says what the tree held.
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_struct("CaseTree").field("folder", &self.folder).finish_non_exhaustive()
    }
}

impl CaseTree {
    /// The case that it gives.
    pub(crate) fn read(&self) -> Result<Case, Fault> {
        let Self { root, folder, registry } = self;
        (registry.model(root)?.read)(root, folder)
    }
}
