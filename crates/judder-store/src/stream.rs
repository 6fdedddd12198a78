//! A dataset in the making: arrays that grow while an analysis runs, and what the analysis needs to go on after an interruption.

use std::borrow::Cow;
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufReader, ErrorKind, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::name::check_name;
use crate::zarr::Elsewhere;
use crate::{
    Dataset, StoreError, StudyFolder, Variable, VariableValues, WriteUnderWay, content_hash, plain, staging,
};

/// The file that says how much counts. No variable is called so, since theirs end in `.f64` or `.u8`.
const CHECKPOINT: &str = "checkpoint";

/// What is read of a file at a time.
const READ_BYTES: usize = 1 << 20;

/// One analysis's arrays, appended to along their first dimensions while it runs, never in memory as a whole.
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
/// stream.append(b"step 2", &[[0.0, 1e-6][..].into(), [10.0, 10.5][..].into()])?;
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
    /// As described, each without a row.
    variables: Vec<Variable>,
    files: Vec<File>,
    /// Rows of each variable.
    rows: Vec<u64>,
    checkpoint: Option<Vec<u8>>,
}

/// New rows of a growing variable, one after the other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StreamSlice<'a> {
    /// Real numbers.
    F64(&'a [f64]),
    /// Codes of classes.
    U8(&'a [u8]),
}

/// The first line of the file [`CHECKPOINT`]; the bytes of the caller follow.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
struct CheckpointHeader {
    hash: String,
    variables: Vec<String>,
    rows: Vec<u64>,
    checkpoint_hash: String,
}

impl<'a> StreamWriter<'a> {
    /// Takes up what an earlier run left under the same hash and names of variables, or starts anew: what another hash left, or what is
    /// damaged, is forgotten. One writer an analysis at a time.
    ///
    /// A growing variable is described by its [`Variable`] without a row: real numbers or codes, of length 0 along its first dimension, along which it
    /// grows, and of a fixed length along the others. All that have a first dimension in common grow alike; that which has its name is its coordinate.
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
        grown(variables, &vec![0; variables.len()])?;
        let folder = study.path().join(format!("{}{analysis}", staging::STREAM_PREFIX));
        let left = left_by_earlier_run(&folder, hash, variables)?;
        let failed = |source| StoreError::write(&folder, 0, source);
        if left.is_none() {
            start_anew(&folder, variables).map_err(failed)?;
        }
        let nothing = || (vec![0; variables.len()], None);
        let (rows, checkpoint) = left.map_or_else(nothing, |(rows, checkpoint)| (rows, Some(checkpoint)));
        let open = |variable: &Variable| OpenOptions::new().write(true).open(place(&folder, variable));
        let files = variables.iter().map(open).collect::<Result<_, _>>().map_err(failed)?;
        let (analysis, hash, variables) = (analysis.to_owned(), hash.to_owned(), variables.to_vec());
        Ok(Self { study, analysis, hash, folder, variables, files, rows, checkpoint })
    }

    /// Rows of the first variable so far.
    #[must_use]
    pub fn len(&self) -> u64 {
        self.rows.first().copied().unwrap_or(0)
    }

    /// Whether it has none yet.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The last checkpoint, of this run or of an earlier one; none where there was no append.
    #[must_use]
    pub fn checkpoint(&self) -> Option<&[u8]> {
        self.checkpoint.as_deref()
    }

    /// What has been appended to a variable of real numbers so far, row after row; it is read from the disk.
    ///
    /// # Errors
    /// [`StoreError::NotGrowing`], failures of the file system.
    pub fn values(&self, variable: &str) -> Result<Vec<f64>, StoreError> {
        let (variable, rows) = self.growing(variable)?;
        let path = place(&self.folder, variable);
        let mut bytes = plain::read(&path).map_err(|source| StoreError::read(&path, source))?;
        bytes.truncate((rows * row_bytes(variable)) as usize);
        let (values, _) = bytes.as_chunks();
        Ok(values.iter().map(|value| f64::from_le_bytes(*value)).collect())
    }

    /// The value at one place of every row of a variable of real numbers, read from the disk row by row; nothing where a row has no such place.
    ///
    /// # Errors
    /// As of [`values`](Self::values).
    pub fn column(&self, variable: &str, column: usize) -> Result<Vec<f64>, StoreError> {
        let (variable, rows) = self.growing(variable)?;
        let path = place(&self.folder, variable);
        let read = || -> io::Result<Vec<f64>> {
            let mut file = BufReader::with_capacity(READ_BYTES, plain::open(&path)?);
            let mut row = vec![0; row_bytes(variable) as usize];
            let mut values = Vec::new();
            for _ in 0..rows {
                file.read_exact(&mut row)?;
                values.extend(row.as_chunks().0.get(column).map(|value| f64::from_le_bytes(*value)));
            }
            Ok(values)
        };
        read().map_err(|source| StoreError::read(&path, source))
    }

    /// A growing variable of real numbers, and how many rows it has.
    fn growing(&self, variable: &str) -> Result<(&Variable, u64), StoreError> {
        let all = || self.variables.iter().zip(&self.rows);
        let reals = || all().filter(|(known, _)| matches!(known.data, VariableValues::F64(_)));
        let found = reals().find(|(known, _)| known.name == variable);
        found.map(|(known, rows)| (known, *rows)).ok_or_else(|| StoreError::NotGrowing {
            variable: variable.to_owned(),
            known: reals().map(|(known, _)| known.name.clone()).collect(),
        })
    }

    /// Appends new rows to each variable, in their order and as many to all of one dimension (none keep the checkpoint alone), and replaces the
    /// checkpoint.
    ///
    /// # Errors
    /// [`StoreError::SliceCount`], [`StoreError::SliceKind`], [`StoreError::SliceLength`], failures of the file system; what was appended before still
    /// counts, and the same append may be tried again.
    pub fn append(&mut self, checkpoint: &[u8], slices: &[StreamSlice<'_>]) -> Result<(), StoreError> {
        let added = self.check_slices(slices)?;
        let _write = WriteUnderWay::begin();
        let files = self.files.iter_mut().zip(&self.rows);
        for ((slice, variable), (file, rows)) in slices.iter().zip(&self.variables).zip(files) {
            let bytes = slice.bytes();
            write_at(file, rows * row_bytes(variable), &bytes).map_err(|source| {
                StoreError::write(&place(&self.folder, variable), bytes.len() as u64, source)
            })?;
        }
        let rows: Vec<u64> = self.rows.iter().zip(added).map(|(rows, added)| rows + added).collect();
        let header = CheckpointHeader {
            hash: self.hash.clone(),
            variables: self.variables.iter().map(|variable| variable.name.clone()).collect(),
            rows: rows.clone(),
            checkpoint_hash: content_hash(checkpoint),
        };
        let path = self.folder.join(CHECKPOINT);
        let line =
            serde_json::to_string(&header).map_err(|source| StoreError::write(&path, 0, source.into()))?;
        // the values are on the disk: from this rename on they count
        staging::write_file(self.study.path(), &path, &[line.as_bytes(), b"\n", checkpoint].concat())?;
        self.rows = rows;
        self.checkpoint = Some(checkpoint.to_vec());
        Ok(())
    }

    /// Makes it the group of the analysis in `results.zarr`, in place of one of that name: the grown variables, then those of `rest`, and the
    /// attributes of `rest`. One chunk (8 MiB) at a time is in memory.
    ///
    /// # Errors
    /// What a [`Dataset`] refuses, failures of the file system; the stream is then still there to be opened again.
    pub fn finish(self, rest: Dataset) -> Result<(), StoreError> {
        let _write = WriteUnderWay::begin();
        let mut dataset = grown(&self.variables, &self.rows)?;
        for variable in rest.variables() {
            dataset = dataset.with(variable.clone())?;
        }
        for (name, value) in rest.attributes() {
            dataset = dataset.attribute(name, value.clone())?;
        }
        let elsewhere: Elsewhere = self
            .variables
            .iter()
            .map(|variable| (variable.name.clone(), place(&self.folder, variable)))
            .collect();
        self.study.publish(&self.analysis, &self.hash, &dataset, &elsewhere)?;
        drop(self.files);
        remove(&self.folder).map_err(|source| StoreError::write(&self.folder, 0, source))
    }

    /// How many rows each slice has.
    fn check_slices(&self, slices: &[StreamSlice<'_>]) -> Result<Vec<u64>, StoreError> {
        let (expected, found) = (self.variables.len(), slices.len());
        if expected != found {
            return Err(StoreError::SliceCount { expected, found });
        }
        let mut added: Vec<u64> = Vec::with_capacity(slices.len());
        for (variable, slice) in self.variables.iter().zip(slices) {
            let name = || variable.name.clone();
            let is_same = matches!(
                (&variable.data, slice),
                (VariableValues::F64(_), StreamSlice::F64(_)) | (VariableValues::U8(_), StreamSlice::U8(_))
            );
            if !is_same {
                return Err(StoreError::SliceKind { variable: name() });
            }
            let row = row_values(variable);
            let alike = self.variables.iter().zip(&added).find(|(other, _)| grow_alike(other, variable));
            let rows = alike.map_or(slice.len() as u64 / row, |(_, rows)| *rows);
            let (expected, found) = ((rows * row) as usize, slice.len());
            if expected != found {
                return Err(StoreError::SliceLength { variable: name(), expected, found });
            }
            added.push(rows);
        }
        Ok(added)
    }
}

impl StreamSlice<'_> {
    fn len(&self) -> usize {
        match self {
            Self::F64(values) => values.len(),
            Self::U8(values) => values.len(),
        }
    }

    fn bytes(&self) -> Cow<'_, [u8]> {
        match self {
            Self::F64(values) => values.iter().flat_map(|value| value.to_le_bytes()).collect(),
            Self::U8(values) => Cow::Borrowed(values),
        }
    }
}

impl<'a> From<&'a [f64]> for StreamSlice<'a> {
    fn from(values: &'a [f64]) -> Self {
        Self::F64(values)
    }
}

impl<'a> From<&'a [u8]> for StreamSlice<'a> {
    fn from(values: &'a [u8]) -> Self {
        Self::U8(values)
    }
}

/// Whether two variables have the dimension in common along which they grow.
fn grow_alike(a: &Variable, b: &Variable) -> bool {
    a.dimensions.first() == b.dimensions.first()
}

/// Values of a row.
fn row_values(variable: &Variable) -> u64 {
    variable.shape.iter().skip(1).map(|length| *length as u64).product()
}

fn row_bytes(variable: &Variable) -> u64 {
    row_values(variable) * variable.data.value_size() as u64
}

/// The described variables with so many rows, without their values.
fn grown(variables: &[Variable], rows: &[u64]) -> Result<Dataset, StoreError> {
    let mut dataset = Dataset::new();
    for (variable, rows) in variables.iter().zip(rows) {
        let is_kept = matches!(&variable.data, VariableValues::F64(_) | VariableValues::U8(_));
        let is_empty = variable.data.is_empty() && variable.shape.first() == Some(&0);
        let has_rows = variable.shape.iter().skip(1).all(|length| *length > 0)
            && variable.shape.len() == variable.dimensions.len();
        if !(is_kept && is_empty && has_rows) {
            return Err(StoreError::CannotGrow { variable: variable.name.clone() });
        }
        let mut shape = variable.shape.clone();
        shape.splice(..1, [*rows as usize]);
        dataset = dataset.joined_by(Variable { shape, ..variable.clone() })?;
    }
    Ok(dataset)
}

/// Where the values of a variable lie.
fn place(folder: &Path, variable: &Variable) -> PathBuf {
    let kind = if matches!(variable.data, VariableValues::U8(_)) { "u8" } else { "f64" };
    folder.join(format!("{}.{kind}", variable.name))
}

/// Rows of each variable, and the checkpoint.
type LeftRows = (Vec<u64>, Vec<u8>);

/// Rows and checkpoint of an earlier run under this hash; none where there is nothing whole.
fn left_by_earlier_run(
    folder: &Path,
    hash: &str,
    variables: &[Variable],
) -> Result<Option<LeftRows>, StoreError> {
    let path = folder.join(CHECKPOINT);
    let mut content = match plain::read(&path) {
        Ok(content) => content,
        Err(source) if matches!(source.kind(), ErrorKind::NotFound | ErrorKind::NotADirectory) => {
            return Ok(None);
        }
        Err(source) => return Err(StoreError::read(&path, source)),
    };
    let Some(end) = content.iter().position(|byte| *byte == b'\n') else { return Ok(None) };
    let checkpoint = content.split_off(end + 1);
    let Ok(header) = serde_json::from_slice::<CheckpointHeader>(&content) else { return Ok(None) };
    let holds = |(variable, rows): (&Variable, &u64)| {
        let bytes = fs::metadata(place(folder, variable)).map_or(0, |metadata| metadata.len());
        rows.checked_mul(row_bytes(variable)).is_some_and(|needed| needed <= bytes)
    };
    let names = || variables.iter().map(|variable| &variable.name);
    let is_whole = header.hash == hash
        && header.variables.iter().eq(names())
        && header.rows.len() == variables.len()
        && header.checkpoint_hash == content_hash(&checkpoint)
        && variables.iter().zip(&header.rows).all(holds);
    Ok(is_whole.then_some((header.rows, checkpoint)))
}

/// A folder with nothing appended yet, in place of whatever is there.
fn start_anew(folder: &Path, variables: &[Variable]) -> io::Result<()> {
    remove(folder)?;
    judder_disk::create_folder(folder)?;
    for variable in variables {
        judder_disk::create_new_file(&place(folder, variable))?;
    }
    staging::sync_tree(folder)
}

/// Removes a stream, the checkpoint first: a kill leaves no checkpoint without its values.
fn remove(folder: &Path) -> io::Result<()> {
    if folder.is_dir() {
        judder_disk::remove(&folder.join(CHECKPOINT))?;
    }
    judder_disk::remove(folder)
}

/// Writes bytes to the disk at a place, and cuts off what a torn append left beyond it, this one too.
fn write_at(file: &mut File, place: u64, bytes: &[u8]) -> io::Result<()> {
    judder_disk::set_length(file, place)?;
    file.seek(SeekFrom::Start(place))?;
    let written = judder_disk::write(file, bytes).and_then(|()| judder_disk::sync(file));
    if written.is_err() {
        // on a full disk a torn append would take the room of others; what fails here is cut off by the next append
        let _ = judder_disk::set_length(file, place);
    }
    written
}
