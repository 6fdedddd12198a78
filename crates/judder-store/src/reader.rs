//! A study that is looked at and not held.

use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use serde_json::{Map, Value};
use zarrs::array::{Array, ArraySubset};
use zarrs::filesystem::FilesystemStore;

use crate::array::ReadFailure;
use crate::manifest::ManifestReader;
use crate::metadata::{self, HASH_ATTRIBUTE};
use crate::name::check_name;
use crate::zarr;
use crate::{CheckedFile, StoreError, Summary, Variable, folder, results, summary};

/// Folders below that of the study in which [`StudyReader::files`] looks: figures and fields lie one deep.
const DEPTH: usize = 3;

/// A study that is looked at and not held: others may work on it meanwhile, and nothing is written.
///
/// What `manifest.json` lists is compared with it as it is read: [`StoreError::Damaged`] is no race with a writer.
///
/// Whatever it reads lies in the folder: a link that leads out of it is [`StoreError::OutsideFolder`]. What is being replaced while it is
/// read is [`StoreError::DatasetUnreadable`] at worst, and whole when asked for again.
#[derive(Debug, Clone)]
pub struct StudyReader {
    root: PathBuf,
    manifest: ManifestReader,
}

/// What is known of a dataset before its values are read.
#[derive(Debug, Clone, PartialEq)]
pub struct DatasetHead {
    /// The attributes of the whole.
    pub attributes: Map<String, Value>,
    /// Its variables with their shapes, without values.
    pub variables: Vec<Variable>,
}

impl StudyReader {
    /// Looks into the folder of a study.
    ///
    /// # Errors
    /// [`StoreError::NotAFolder`], [`StoreError::NoStudy`].
    pub fn open(path: impl AsRef<Path>) -> Result<Self, StoreError> {
        let path = path.as_ref();
        folder::look(path)?;
        let root = path.canonicalize().map_err(|source| StoreError::read(path, source))?;
        Ok(Self { manifest: ManifestReader::new(&root), root })
    }

    /// Whether something says that the study is whole: `None` without a manifest, else whether a run has ended and listed all.
    ///
    /// # Errors
    /// [`StoreError::ManifestDamaged`], a failure of the file system.
    pub fn is_complete(&self) -> Result<Option<bool>, StoreError> {
        self.manifest.is_complete()
    }

    /// Where it is, without links.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.root
    }

    /// Reads `summary.json`; `None` where there is none yet.
    ///
    /// # Errors
    /// [`StoreError::SummaryUnreadable`] for a damaged or foreign one, [`StoreError::OutsideFolder`].
    pub fn read_summary(&self) -> Result<Option<Summary>, StoreError> {
        let path = self.root.join(summary::FILE);
        if path.symlink_metadata().is_ok() {
            self.inside(&path)?;
        }
        self.manifest.check(&path)?;
        summary::read(&self.root)
    }

    /// The names under which arrays are stored, sorted.
    ///
    /// # Errors
    /// A failure of the file system.
    pub fn names(&self) -> Result<Vec<String>, StoreError> {
        let results = self.root.join(results::FOLDER);
        let mut names: Vec<String> = entries(&results)?
            .into_iter()
            .filter(|(path, kind)| kind.is_dir() && path.join(metadata::FILE).is_file())
            .filter_map(|(path, _)| Some(path.file_name()?.to_str()?.to_owned()))
            .filter(|name| check_name("an analysis", name).is_ok())
            .collect();
        names.sort();
        Ok(names)
    }

    /// What is stored under a name, without the values.
    ///
    /// # Errors
    /// [`StoreError::InvalidName`], [`StoreError::NoDataset`], [`StoreError::DatasetUnreadable`], [`StoreError::OutsideFolder`].
    pub fn head(&self, name: &str) -> Result<DatasetHead, StoreError> {
        let StoredGroup { path: group, members, mut attributes } = self.group(name)?;
        attributes.remove(HASH_ATTRIBUTE);
        let coordinates = metadata::take_text(&mut attributes, "coordinates");
        let variables = members.iter().map(|member| {
            let array = self.array(&group, member)?;
            let mut variable = crate::array::read_data(&array, None)
                .and_then(|data| crate::array::with_data(member, &array, data))
                .map_err(|source| StoreError::unreadable(&group.join(member), source))?;
            variable.is_coordinate |= coordinates.split_whitespace().any(|coordinate| coordinate == member);
            Ok(variable)
        });
        Ok(DatasetHead { variables: variables.collect::<Result<_, StoreError>>()?, attributes })
    }

    /// The files in which variables that are stored under a name lie with the attributes of the whole, sorted; of variables that are not there none.
    ///
    /// # Errors
    /// As [`head`](Self::head).
    pub fn files_of(&self, name: &str, variables: &[&str]) -> Result<Vec<PathBuf>, StoreError> {
        let StoredGroup { path: group, members, .. } = self.group(name)?;
        let is_wanted = |member: &&String| variables.contains(&member.as_str());
        let mut folders: Vec<PathBuf> =
            members.iter().filter(is_wanted).map(|member| group.join(member)).collect();
        let mut found = vec![group.join(metadata::FILE)];
        while let Some(folder) = folders.pop() {
            for (path, kind) in entries(&folder)? {
                if kind.is_dir() { folders.push(path) } else { found.push(self.inside(&path)?) }
            }
        }
        found.sort();
        Ok(found)
    }

    /// Rows of a stored variable: values whose index along the first dimension is in `rows`, as far as there are such; of a scalar its
    /// value. The shape is that of what is read.
    ///
    /// # Errors
    /// As [`head`](Self::head); a part that is missing or damaged.
    pub fn read_rows(&self, name: &str, variable: &str, rows: Range<usize>) -> Result<Variable, StoreError> {
        let StoredGroup { path: group, members, .. } = self.group(name)?;
        let path = group.join(variable);
        if !members.iter().any(|member| member == variable) {
            return Err(StoreError::NoDataset { path });
        }
        let array = self.array(&group, variable)?;
        self.rows_of(&group, &array, variable, rows).map_err(|failure| match failure {
            ReadRefusal::Refused(error) => error,
            ReadRefusal::Unreadable(source) => StoreError::DatasetUnreadable { path, source },
        })
    }

    /// How many rows of a variable lie in one file; reading so many from a multiple of it on opens each file once.
    ///
    /// # Errors
    /// As [`read_rows`](Self::read_rows).
    pub fn rows_of_a_file(&self, name: &str, variable: &str) -> Result<usize, StoreError> {
        let group = self.group(name)?.path;
        let array = self.array(&group, variable)?;
        let chunk = array
            .chunk_shape(&vec![0; array.dimensionality()])
            .map_err(|source| StoreError::unreadable(&group.join(variable), source))?;
        Ok(chunk.first().map_or(1, |length| usize::try_from(length.get()).unwrap_or(usize::MAX)))
    }

    /// The files of the study that end in `.extension`, each as its path in the study with `/` between folders, and its bytes. Links are
    /// left out, the store's own files too.
    ///
    /// # Errors
    /// A failure of the file system.
    pub fn files(&self, extension: &str) -> Result<Vec<(String, u64)>, StoreError> {
        let mut found = Vec::new();
        let mut folders = vec![(self.root.clone(), String::new(), 0)];
        while let Some((folder, prefix, depth)) = folders.pop() {
            for (path, kind) in entries(&folder)? {
                let Some(name) = path.file_name().and_then(|name| name.to_str()) else { continue };
                if name.starts_with('.') || (depth == 0 && name == results::FOLDER) {
                    continue;
                }
                let relative = format!("{prefix}{name}");
                if kind.is_dir() && depth + 1 < DEPTH {
                    folders.push((path, format!("{relative}/"), depth + 1));
                } else if kind.is_file() && path.extension().is_some_and(|found| found == extension) {
                    let size = path.metadata().map_err(|source| StoreError::read(&path, source))?.len();
                    found.push((relative, size));
                }
            }
        }
        found.sort();
        Ok(found)
    }

    /// A file to read that [`files`](Self::files) lists under this extension; its content is compared with the manifest as it is read.
    ///
    /// # Errors
    /// [`StoreError::OutsideFolder`] for any other path, [`StoreError::Damaged`] for one of another size, a failure of the file system.
    pub fn open_file(&self, relative: &str, extension: &str) -> Result<CheckedFile, StoreError> {
        if !self.files(extension)?.iter().any(|(listed, _)| listed == relative) {
            return Err(StoreError::OutsideFolder { path: PathBuf::from(relative) });
        }
        self.manifest.open(&self.inside(&self.root.join(relative))?)
    }

    fn group(&self, name: &str) -> Result<StoredGroup, StoreError> {
        check_name("an analysis", name)?;
        let path = self.root.join(results::FOLDER).join(name);
        if !path.join(metadata::FILE).exists() {
            return Err(StoreError::NoDataset { path });
        }
        let group = self.inside(&path)?;
        self.inside(&group.join(metadata::FILE))?;
        self.manifest.check(&group.join(metadata::FILE))?;
        let mut content = metadata::read(&group)?;
        let members = metadata::take_members(&mut content)
            .ok_or_else(|| StoreError::unreadable(&group, "its metadata do not list its arrays"))?;
        let attributes = metadata::take_object(&mut content, "attributes").unwrap_or_default();
        let members: Vec<String> = members.into_iter().map(|(member, _)| member).collect();
        members.iter().try_for_each(|member| check_name("a variable", member))?;
        Ok(StoredGroup { path: group, members, attributes })
    }

    fn array(&self, group: &Path, variable: &str) -> Result<Array<FilesystemStore>, StoreError> {
        check_name("a variable", variable)?;
        let path = group.join(variable);
        if !path.join(metadata::FILE).exists() {
            return Err(StoreError::NoDataset { path });
        }
        self.manifest.check(&self.inside(&path.join(metadata::FILE))?)?;
        let store = FilesystemStore::new(group).map_err(|source| StoreError::unreadable(group, source))?;
        let array = crate::array::open(&Arc::new(store), variable)
            .map_err(|source| StoreError::of_array(&path, source))?;
        zarr::check_chunk_size(&array).map_err(|source| StoreError::DatasetUnreadable { path, source })?;
        Ok(array)
    }

    fn rows_of(
        &self,
        group: &Path,
        array: &Array<FilesystemStore>,
        name: &str,
        rows: Range<usize>,
    ) -> Result<Variable, ReadRefusal> {
        let mut ranges: Vec<Range<u64>> = array.shape().iter().map(|length| 0..*length).collect();
        if let Some(first) = ranges.first_mut() {
            let end = (rows.end as u64).min(first.end);
            *first = (rows.start as u64).min(end)..end;
        }
        let part = ArraySubset::new_with_ranges(&ranges);
        if !part.shape().contains(&0) {
            self.check_files(group, array, &part)?;
        }
        let data = crate::array::read_data(array, Some(&part))?;
        let mut variable = crate::array::with_data(name, array, data)?;
        variable.shape = part.shape().iter().map(|length| *length as usize).collect();
        Ok(variable)
    }

    /// Refuses a part of an array of which a file is missing, or leads out of the folder.
    fn check_files(
        &self,
        group: &Path,
        array: &Array<FilesystemStore>,
        part: &ArraySubset,
    ) -> Result<(), ReadRefusal> {
        let store = FilesystemStore::new(group).map_err(ReadFailure::from)?;
        let chunks = array.chunks_in_array_subset(part).map_err(ReadFailure::from)?;
        let chunks = chunks.ok_or_else(|| ReadFailure::from("its parts cannot be told"))?;
        for indices in &chunks.indices() {
            let path = store.key_to_fspath(&array.chunk_key(&indices));
            if !path.is_file() {
                return Err(ReadFailure::from(format!("a part is missing: {}", path.display())).into());
            }
            let path = self.inside(&path).map_err(ReadRefusal::Refused)?;
            self.manifest.check(&path).map_err(ReadRefusal::Refused)?;
        }
        Ok(())
    }

    /// The place to which a path leads, which is in the folder.
    fn inside(&self, path: &Path) -> Result<PathBuf, StoreError> {
        let real = path.canonicalize().map_err(|source| StoreError::read(path, source))?;
        if real.starts_with(&self.root) {
            Ok(real)
        } else {
            Err(StoreError::OutsideFolder { path: path.to_owned() })
        }
    }
}

/// A group of the store, inside the folder.
struct StoredGroup {
    path: PathBuf,
    /// The names of its arrays.
    members: Vec<String>,
    attributes: Map<String, Value>,
}

/// Why rows cannot be read.
enum ReadRefusal {
    Refused(StoreError),
    Unreadable(ReadFailure),
}

impl From<ReadFailure> for ReadRefusal {
    fn from(source: ReadFailure) -> Self {
        Self::Unreadable(source)
    }
}

/// What a folder holds, and of which kind each is, a link among them; nothing where there is no folder.
fn entries(folder: &Path) -> Result<Vec<(PathBuf, fs::FileType)>, StoreError> {
    let failed = |source| StoreError::read(folder, source);
    let Ok(list) = fs::read_dir(folder) else { return Ok(Vec::new()) };
    list.map(|entry| entry.and_then(|entry| Ok((entry.path(), entry.file_type()?))).map_err(failed)).collect()
}
