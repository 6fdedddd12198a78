//! The way in: a path or a text with its `--set` options becomes a validated case.

use std::any::Any;
use std::fmt;
use std::fs::File;
use std::io::{ErrorKind, Read};
use std::ops::Deref;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::case::study_sweep::problem::SweepProblem;
use crate::case::study_sweep::{self, StudySweep, read_sweeps};
use crate::error::StudyError;
use crate::model::{Model, Task};
use crate::outcome::Outcome;
use crate::registry::Registry;
use judder_keys::cause::Cause;
use judder_keys::declared::both;
use judder_keys::document::{Data, Node, apply_override, parse};
use judder_keys::error::{CaseError, Fault, Place, Sources};

/// A case file that was read and found valid.
#[derive(Debug, Clone)]
pub struct CaseFile {
    /// The name without folder and extension.
    pub name: String,
    /// The file that it was read from; none of a text.
    pub path: Option<PathBuf>,
    /// What errors call the file: the path as given.
    pub origin: String,
    /// The text as read, without the `--set` options.
    pub text: String,
    /// The `--set` options in their order.
    pub overrides: Vec<String>,
    /// The case, with the options applied.
    pub case: Case,
    /// The sweeps of the whole case, in the order of the file.
    pub sweeps: Vec<StudySweep>,
    /// What the case was read from, to read it anew at the points of a sweep.
    tree: Arc<CaseTree>,
}

/// The values of a case file and its options, without sweeps, the folder to which its files are relative, and the models that there are.
#[derive(Clone)]
pub(crate) struct CaseTree {
    pub(crate) root: Node,
    folder: PathBuf,
    registry: Registry,
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

/// A validated case of one of the models.
#[derive(Debug, Clone)]
pub struct Case(Box<dyn Model>);

impl Case {
    /// This case of a model.
    pub fn new(case: impl Model) -> Self {
        Self(Box::new(case))
    }

    /// The case, where it is of this model.
    pub fn of<M: Model>(&self) -> Option<&M> {
        (self.0.as_ref() as &dyn Any).downcast_ref()
    }

    /// The same, to be changed.
    pub fn of_mut<M: Model>(&mut self) -> Option<&mut M> {
        (self.0.as_mut() as &mut dyn Any).downcast_mut()
    }

    /// Runs an analysis, and names its kind in the arrays that it leaves.
    ///
    /// # Errors
    /// As of [`Model::run`].
    pub fn run(&self, index: usize, task: Task<'_>) -> Result<Outcome, StudyError> {
        let mut outcome = self.0.run(index, task)?;
        outcome.dataset = outcome.dataset.headed("kind", self.kind_name(index))?;
        Ok(outcome)
    }

    /// The name of its model in a case file.
    pub fn model(&self) -> &'static str {
        self.0.name()
    }
}

impl Deref for Case {
    type Target = dyn Model;

    fn deref(&self) -> &dyn Model {
        self.0.as_ref()
    }
}

/// The most that a case file may hold, bytes: 1 MiB.
pub const CASE_BYTES_LIMIT: u64 = 1 << 20;

impl CaseFile {
    /// Reads and validates the case file at `path` with the options `--set key=value`.
    ///
    /// # Errors
    /// [`CaseError`] with the cause, the place in file or option, and what would be right.
    pub fn read(registry: Registry, path: impl AsRef<Path>, overrides: &[String]) -> Result<Self, CaseError> {
        let path = path.as_ref();
        let name = path.display().to_string();
        let bytes = read_bytes(path).map_err(|cause| CaseError::without_place(cause, &name))?;
        let text = String::from_utf8(bytes).map_err(|error| {
            let offset = error.utf8_error().valid_up_to();
            CaseError::without_place(Cause::Binary { name: name.clone(), offset }, &name)
        })?;
        Ok(Self { path: Some(path.to_owned()), ..Self::parse(registry, &name, &text, overrides)? })
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
        let sources = Sources::new(name, text, overrides);
        let read = || read_case(registry, name, read_tree(name, text, overrides)?);
        let (case, sweeps, tree) = read().map_err(|fault| sources.error(fault))?;
        let stem = Path::new(name).file_stem().map_or(name.into(), |stem| stem.to_string_lossy());
        let (name, origin) = (stem.into_owned(), name.to_owned());
        let (text, overrides, tree) = (text.to_owned(), overrides.to_vec(), Arc::new(tree));
        Ok(Self { name, path: None, origin, text, overrides, case, sweeps, tree })
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
        let (name, path, origin) = (self.name.clone(), self.path.clone(), self.origin.clone());
        let (text, overrides) = (self.text.clone(), self.overrides.clone());
        Ok(Self { name, path, origin, text, overrides, case, sweeps: Vec::new(), tree: Arc::new(tree) })
    }

    /// The error of an analysis, by its index, that shows only when its numbers are looked at: at the first of these keys that
    /// the analysis has, or at the analysis.
    pub fn analysis_error(&self, index: usize, keys: &[&str], cause: impl Into<Cause>) -> CaseError {
        let cause = cause.into();
        let place = read_tree(&self.origin, &self.text, &self.overrides)
            .ok()
            .and_then(|root| place(&root, index, keys));
        match place {
            Some(place) => Sources::new(&self.origin, &self.text, &self.overrides).error(cause.at(place)),
            None => CaseError::without_place(cause, &self.origin),
        }
    }

    /// An error that shows only when more than the case is looked at, its files or its numbers: at this dotted path, where an item of a
    /// list goes by its name or number, or at the last part of it that is there.
    pub fn error(&self, path: &str, cause: impl Into<Cause>) -> CaseError {
        self.error_at(path.split('.'), cause.into())
    }

    /// An error at the end of a path, or at the last step of it that is there.
    fn error_at<'a>(&self, steps: impl IntoIterator<Item = &'a str>, cause: Cause) -> CaseError {
        match read_tree(&self.origin, &self.text, &self.overrides) {
            Ok(root) => {
                let place = place_of_path(&root, steps);
                Sources::new(&self.origin, &self.text, &self.overrides).error(cause.at(place))
            }
            Err(_) => CaseError::without_place(cause, &self.origin),
        }
    }
}

/// The place of the last step of a path that is there.
fn place_of_path<'a>(root: &Node, steps: impl IntoIterator<Item = &'a str>) -> Place {
    let mut node = root;
    for step in steps {
        match node.step(step) {
            Some(next) => node = next,
            None => break,
        }
    }
    node.place
}

/// The bytes of a regular file of bounded size: opening a pipe or reading a device might never end.
fn read_bytes(path: &Path) -> Result<Vec<u8>, Cause> {
    let fail = |source: std::io::Error| {
        let path = path.to_owned();
        match source.kind() {
            ErrorKind::NotFound => Cause::Missing { path },
            _ => Cause::Unreadable { path, source },
        }
    };
    let metadata = std::fs::metadata(path).map_err(fail)?;
    if metadata.is_dir() {
        return Err(Cause::Folder { path: path.to_owned() });
    }
    if !metadata.is_file() {
        return Err(Cause::NotAFile { path: path.to_owned() });
    }
    let mut bytes = Vec::new();
    let mut file = File::open(path).map_err(fail)?.take(CASE_BYTES_LIMIT + 1);
    file.read_to_end(&mut bytes).map_err(fail)?;
    // a file can be longer than its metadata says: those of the system often claim no length
    let size = metadata.len().max(bytes.len() as u64);
    if size > CASE_BYTES_LIMIT {
        return Err(Cause::TooLong { path: path.to_owned(), size, limit: CASE_BYTES_LIMIT });
    }
    Ok(bytes)
}

/// The place of the first of these keys of an analysis.
fn place(root: &Node, index: usize, keys: &[&str]) -> Option<Place> {
    let Data::Table(root) = &root.data else { return None };
    let Data::List(analyses) = &root.get("analysis")?.node.data else { return None };
    let analysis = analyses.get(index)?;
    let Data::Table(table) = &analysis.data else { return None };
    let key = keys.iter().find_map(|key| table.get(key));
    Some(key.map_or(analysis.place, |entry| entry.node.place))
}

fn read_case(
    registry: Registry,
    name: &str,
    mut root: Node,
) -> Result<(Case, Vec<StudySweep>, CaseTree), Fault> {
    let sweeps = root.take("sweep");
    let folder = Path::new(name).parent().unwrap_or(Path::new("")).to_owned();
    let tree = CaseTree { root, folder, registry };
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
    let read = || {
        let mut root = read_tree(name, text, overrides)?;
        for part in without {
            root.take(part);
        }
        read_case(registry, name, root)
    };
    read().err().map(|fault| Sources::new(name, text, overrides).error(fault))
}

/// The tree of a case with the options grafted onto it.
pub(crate) fn read_tree(name: &str, text: &str, overrides: &[String]) -> Result<Node, Fault> {
    let mut root = parse(text)?;
    if matches!(&root.data, Data::Table(table) if table.entries.is_empty()) {
        return Err(Cause::Empty { name: name.to_owned() }.at(root.place));
    }
    for (index, option) in overrides.iter().enumerate() {
        apply_override(&mut root, index + 1, option)?;
    }
    Ok(root)
}
