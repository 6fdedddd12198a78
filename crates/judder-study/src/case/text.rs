//! The text of a case with its `--set` options: what it is called, and where in it something is wrong.

use judder_keys::cause::Cause;
use judder_keys::document::{Data, Node, apply_override, parse, refuse_unknown_parameters};
use judder_keys::error::{CaseError, Fault, Place, Sources};
use std::fs::File;
use std::io::{ErrorKind, Read};
use std::path::{Path, PathBuf};

/// The text of a case, as given.
#[derive(Debug, Clone)]
pub struct CaseText {
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
}

/// The most that a case file may hold, bytes: 1 MiB.
pub const CASE_BYTES_LIMIT: u64 = 1 << 20;

impl CaseText {
    /// The text of the file at `path`.
    pub(crate) fn read(path: &Path, overrides: &[String]) -> Result<Self, CaseError> {
        let origin = path.display().to_string();
        let bytes = read_bytes(path).map_err(|cause| CaseError::without_place(cause, &origin))?;
        let text = String::from_utf8(bytes).map_err(|error| {
            let offset = error.utf8_error().valid_up_to();
            CaseError::without_place(Cause::Binary { name: origin.clone(), offset }, &origin)
        })?;
        Ok(Self { path: Some(path.to_owned()), ..Self::new(&origin, &text, overrides) })
    }

    /// This text; `origin`, a path or any word, is what errors call it.
    pub(crate) fn new(origin: &str, text: &str, overrides: &[String]) -> Self {
        let name = Path::new(origin).file_stem().map_or(origin.into(), |stem| stem.to_string_lossy());
        let (name, origin, text) = (name.into_owned(), origin.to_owned(), text.to_owned());
        Self { name, path: None, origin, text, overrides: overrides.to_vec() }
    }

    /// The folder to which the files of the case are relative.
    pub(crate) fn folder(&self) -> PathBuf {
        Path::new(&self.origin).parent().unwrap_or(Path::new("")).to_owned()
    }

    /// What it says, with the options grafted onto it.
    pub(crate) fn tree(&self) -> Result<Node, Fault> {
        let mut root = parse(&self.text)?;
        if matches!(&root.data, Data::Table(table) if table.entries.is_empty()) {
            return Err(Cause::Empty { name: self.origin.clone() }.at(root.place));
        }
        let given = root.clone();
        for (index, option) in self.overrides.iter().enumerate() {
            apply_override(&mut root, index + 1, option)?;
        }
        refuse_unknown_parameters(&given, &root, &self.overrides)?;
        Ok(root)
    }

    /// As an error that shows the place in text or option.
    pub(crate) fn faulty(&self, fault: Fault) -> CaseError {
        Sources::new(&self.origin, &self.text, &self.overrides).error(fault)
    }

    /// The error of an analysis, by its index, that shows only when its numbers are looked at: at the first of these keys that
    /// the analysis has, or at the analysis.
    pub fn analysis_error(&self, index: usize, keys: &[&str], cause: impl Into<Cause>) -> CaseError {
        let cause = cause.into();
        let place = self.tree().ok().and_then(|root| place(&root, index, keys));
        match place {
            Some(place) => self.faulty(cause.at(place)),
            None => CaseError::without_place(cause, &self.origin),
        }
    }

    /// An error that shows only when more than the case is looked at, its files or its numbers: at this dotted path, where an item of a
    /// list goes by its name or number, or at the last part of it that is there.
    pub fn error(&self, path: &str, cause: impl Into<Cause>) -> CaseError {
        self.error_at(path.split('.'), cause.into())
    }

    /// An error at the end of a path, or at the last step of it that is there.
    pub(crate) fn error_at<'a>(&self, steps: impl IntoIterator<Item = &'a str>, cause: Cause) -> CaseError {
        match self.tree() {
            Ok(root) => self.faulty(cause.at(place_of_path(&root, steps))),
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

/// The place of the first of these keys of an analysis, by their dotted paths in it; that of the analysis where it has none of them.
fn place(root: &Node, index: usize, keys: &[&str]) -> Option<Place> {
    let Data::Table(root) = &root.data else { return None };
    let Data::List(analyses) = &root.get("analysis")?.node.data else { return None };
    let analysis = analyses.get(index)?;
    let at = |key: &&str| key.split('.').try_fold(analysis, |node, step| node.step(step));
    Some(keys.iter().find_map(at).unwrap_or(analysis).place)
}
