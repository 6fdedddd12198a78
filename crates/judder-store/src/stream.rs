//! A dataset in the making: arrays that grow while an analysis runs, and what the analysis needs to go on after an interruption.

use std::fs::{self, File, OpenOptions};
use std::io::{self, ErrorKind, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::name::check_name;
use crate::zarr::Elsewhere;
use crate::{Dataset, StoreError, StudyFolder, Variable, VariableValues, content_hash, staging};

/// The file that says how much counts. No variable is called so, since theirs end in `.f64`.
const CHECKPOINT: &str = "checkpoint";

const VALUE_BYTES: u64 = size_of::<f64>() as u64;

/// One analysis's arrays along one dimension, appended to while it runs, never in memory as a whole.
///
/// Every append brings a checkpoint, some bytes of the caller's choice that say how to go on from there. Both are on the disk once
/// [`append`](Self::append) has returned. A run that is killed, at any instant, leaves everything up to its last whole append; what it was
/// just writing is dropped. [`finish`](Self::finish) makes it the dataset that [`StudyFolder::write_dataset`] would have written.
///
/// ```
/// use judder_store::{Dataset, StreamWriter, StudyFolder, Variable};
/// # let folder = tempfile::tempdir()?;
/// let study = StudyFolder::create(folder.path().join("study"))?;
/// let grows = |name| Variable::new(name, &["time"], &[0], Vec::<f64>::new());
/// let variables = [grows("time").units("s"), grows("normal_force").units("N").long_name("normal force N")];
/// let mut stream = StreamWriter::open(&study, "march", "hash", &variables)?;
/// assert_eq!((stream.len(), stream.checkpoint()), (0, None));
/// stream.append(b"step 2", &[&[0.0, 1e-6], &[10.0, 10.5]])?;
/// drop(stream); // or a kill
/// let stream = StreamWriter::open(&study, "march", "hash", &variables)?;
/// assert_eq!((stream.len(), stream.checkpoint()), (2, Some(&b"step 2"[..])));
/// assert_eq!(stream.values("normal_force")?, [10.0, 10.5]);
/// stream.finish(Dataset::new().attribute("step_s", 1e-6)?)?;
/// assert_eq!(study.read_dataset("march")?.dimension_length("time"), Some(2));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct StreamWriter<'a> {
    study: &'a StudyFolder,
    analysis: String,
    hash: String,
    folder: PathBuf,
    /// As described, each of length 0.
    variables: Vec<Variable>,
    files: Vec<File>,
    len: u64,
    checkpoint: Option<Vec<u8>>,
}

/// The first line of the file [`CHECKPOINT`]; the bytes of the caller follow.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
struct CheckpointHeader {
    hash: String,
    variables: Vec<String>,
    len: u64,
    checkpoint_hash: String,
}

impl<'a> StreamWriter<'a> {
    /// Takes up what an earlier run left under the same hash and names of variables, or starts anew: what another hash left, or what is
    /// damaged, is forgotten. One writer an analysis at a time.
    ///
    /// A growing variable is described by its [`Variable`] of length 0, of real numbers over the one dimension that all share; that which has
    /// the name of the dimension is its coordinate.
    ///
    /// # Errors
    /// A name that cannot be a folder, [`StoreError::CannotGrow`], [`StoreError::Duplicate`], what a [`Dataset`] refuses; failures of the file
    /// system.
    pub fn open(
        study: &'a StudyFolder,
        analysis: &str,
        hash: &str,
        variables: &[Variable],
    ) -> Result<Self, StoreError> {
        check_name("an analysis", analysis)?;
        grown(variables, 0)?;
        let folder = study.path().join(format!("{}{analysis}", staging::STREAM_PREFIX));
        let names: Vec<&str> = variables.iter().map(|variable| variable.name.as_str()).collect();
        let left = left_by_earlier_run(&folder, hash, &names)?;
        let failed = |source| StoreError::write(&folder, 0, source);
        if left.is_none() {
            start_anew(&folder, &names).map_err(failed)?;
        }
        let (len, checkpoint) = left.map_or((0, None), |(len, checkpoint)| (len, Some(checkpoint)));
        let open = |name: &&str| OpenOptions::new().write(true).open(place(&folder, name));
        let files = names.iter().map(open).collect::<Result<_, _>>().map_err(failed)?;
        let (analysis, hash, variables) = (analysis.to_owned(), hash.to_owned(), variables.to_vec());
        Ok(Self { study, analysis, hash, folder, variables, files, len, checkpoint })
    }

    /// Values of each variable so far.
    #[must_use]
    pub fn len(&self) -> u64 {
        self.len
    }

    /// Whether there are none yet.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// The last checkpoint, of this run or of an earlier one; none where there was no append.
    #[must_use]
    pub fn checkpoint(&self) -> Option<&[u8]> {
        self.checkpoint.as_deref()
    }

    /// What has been appended to a variable so far; it is read from the disk.
    ///
    /// # Errors
    /// [`StoreError::NotGrowing`], failures of the file system.
    pub fn values(&self, variable: &str) -> Result<Vec<f64>, StoreError> {
        if !self.variables.iter().any(|known| known.name == variable) {
            let known = self.variables.iter().map(|known| known.name.clone()).collect();
            return Err(StoreError::NotGrowing { variable: variable.to_owned(), known });
        }
        let path = place(&self.folder, variable);
        let mut bytes = fs::read(&path).map_err(|source| StoreError::read(&path, source))?;
        bytes.truncate((self.len * VALUE_BYTES) as usize);
        let (values, _) = bytes.as_chunks::<{ VALUE_BYTES as usize }>();
        Ok(values.iter().map(|value| f64::from_le_bytes(*value)).collect())
    }

    /// Appends a slice of new values to each variable, in their order and equally long (empty ones keep the checkpoint alone), and replaces the
    /// checkpoint.
    ///
    /// # Errors
    /// [`StoreError::SliceCount`], [`StoreError::SliceLength`], failures of the file system; what was appended before still counts, and the same
    /// append may be tried again.
    pub fn append(&mut self, checkpoint: &[u8], slices: &[&[f64]]) -> Result<(), StoreError> {
        let added = self.check_slices(slices)?;
        for ((file, variable), slice) in self.files.iter_mut().zip(&self.variables).zip(slices) {
            let bytes: Vec<u8> = slice.iter().flat_map(|value| value.to_le_bytes()).collect();
            write_at(file, self.len * VALUE_BYTES, &bytes).map_err(|source| {
                StoreError::write(&place(&self.folder, &variable.name), bytes.len() as u64, source)
            })?;
        }
        let header = CheckpointHeader {
            hash: self.hash.clone(),
            variables: self.variables.iter().map(|variable| variable.name.clone()).collect(),
            len: self.len + added,
            checkpoint_hash: content_hash(checkpoint),
        };
        let path = self.folder.join(CHECKPOINT);
        let line =
            serde_json::to_string(&header).map_err(|source| StoreError::write(&path, 0, source.into()))?;
        // the values are on the disk: from this rename on they count
        staging::write_file(self.study.path(), &path, &[line.as_bytes(), b"\n", checkpoint].concat())?;
        self.len += added;
        self.checkpoint = Some(checkpoint.to_vec());
        Ok(())
    }

    /// Makes it the group of the analysis in `results.zarr`, in place of one of that name: the grown variables, then those of `rest`, and the
    /// attributes of `rest`. One chunk (8 MiB) at a time is in memory.
    ///
    /// # Errors
    /// What a [`Dataset`] refuses, failures of the file system; the stream is then still there to be opened again.
    pub fn finish(self, rest: Dataset) -> Result<(), StoreError> {
        let mut dataset = grown(&self.variables, self.len as usize)?;
        for variable in rest.variables() {
            dataset = dataset.with(variable.clone())?;
        }
        for (name, value) in rest.attributes() {
            dataset = dataset.attribute(name, value.clone())?;
        }
        let elsewhere: Elsewhere = self
            .variables
            .iter()
            .map(|variable| (variable.name.clone(), place(&self.folder, &variable.name)))
            .collect();
        self.study.publish(&self.analysis, &self.hash, &dataset, &elsewhere)?;
        drop(self.files);
        remove(&self.folder).map_err(|source| StoreError::write(&self.folder, 0, source))
    }

    /// How many values every slice has.
    fn check_slices(&self, slices: &[&[f64]]) -> Result<u64, StoreError> {
        let (expected, found) = (self.variables.len(), slices.len());
        if expected != found {
            return Err(StoreError::SliceCount { expected, found });
        }
        let expected = slices.first().map_or(0, |slice| slice.len());
        match slices.iter().zip(&self.variables).find(|(slice, _)| slice.len() != expected) {
            Some((slice, variable)) => {
                Err(StoreError::SliceLength { variable: variable.name.clone(), expected, found: slice.len() })
            }
            None => Ok(expected as u64),
        }
    }
}

/// The described variables at a length, without their values.
fn grown(variables: &[Variable], len: usize) -> Result<Dataset, StoreError> {
    let mut dataset = Dataset::new();
    let dimension = variables.first().and_then(|first| first.dimensions.first());
    for variable in variables {
        let is_real = matches!(&variable.data, VariableValues::F64(values) if values.is_empty());
        if !is_real || variable.shape != [0] || variable.dimensions.first() != dimension {
            let dimension = dimension.map_or("time", String::as_str).to_owned();
            return Err(StoreError::CannotGrow { variable: variable.name.clone(), dimension });
        }
        dataset = dataset.joined_by(Variable { shape: vec![len], ..variable.clone() })?;
    }
    Ok(dataset)
}

/// Where the values of a variable lie.
fn place(folder: &Path, variable: &str) -> PathBuf {
    folder.join(format!("{variable}.f64"))
}

/// Length and checkpoint of an earlier run under this hash; none where there is nothing whole.
fn left_by_earlier_run(
    folder: &Path,
    hash: &str,
    variables: &[&str],
) -> Result<Option<(u64, Vec<u8>)>, StoreError> {
    let path = folder.join(CHECKPOINT);
    let mut content = match fs::read(&path) {
        Ok(content) => content,
        Err(source) if matches!(source.kind(), ErrorKind::NotFound | ErrorKind::NotADirectory) => {
            return Ok(None);
        }
        Err(source) => return Err(StoreError::read(&path, source)),
    };
    let Some(end) = content.iter().position(|byte| *byte == b'\n') else { return Ok(None) };
    let checkpoint = content.split_off(end + 1);
    let Ok(header) = serde_json::from_slice::<CheckpointHeader>(&content) else { return Ok(None) };
    let holds = |variable: &&str| {
        let bytes = fs::metadata(place(folder, variable)).map_or(0, |metadata| metadata.len());
        header.len.checked_mul(VALUE_BYTES).is_some_and(|needed| needed <= bytes)
    };
    let is_whole = header.hash == hash
        && header.variables == variables
        && header.checkpoint_hash == content_hash(&checkpoint)
        && variables.iter().all(holds);
    Ok(is_whole.then_some((header.len, checkpoint)))
}

/// A folder with nothing appended yet, in place of whatever is there.
fn start_anew(folder: &Path, variables: &[&str]) -> io::Result<()> {
    remove(folder)?;
    fs::create_dir(folder)?;
    for variable in variables {
        File::create_new(place(folder, variable))?;
    }
    staging::sync_tree(folder)
}

/// Removes a stream, the checkpoint first: a kill leaves no checkpoint without its values.
fn remove(folder: &Path) -> io::Result<()> {
    if folder.is_dir() {
        staging::remove(&folder.join(CHECKPOINT))?;
    }
    staging::remove(folder)
}

/// Writes bytes to the disk at a place, and cuts off what a torn append left beyond it, this one too.
fn write_at(file: &mut File, place: u64, bytes: &[u8]) -> io::Result<()> {
    file.set_len(place)?;
    file.seek(SeekFrom::Start(place))?;
    let written = file.write_all(bytes).and_then(|()| file.sync_all());
    if written.is_err() {
        // on a full disk a torn append would take the room of others; what fails here is cut off by the next append
        let _ = file.set_len(place);
    }
    written
}
