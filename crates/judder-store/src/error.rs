//! What can go wrong with a study folder.

use std::error::Error;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

use crate::{ChunkDamage, FileDamage, OversizedFile, lock_sign};

/// Why something could not be stored or read back. Every variant names the place and says what would be right.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum StoreError {
    /// The output folder, or a part of its path, is a file.
    #[error("{}: a study needs a folder, and this is a file (or runs through one); name another place with -o", path.display())]
    NotAFolder {
        /// The folder that was asked for.
        path: PathBuf,
    },
    /// The way to the output folder is not text in UTF-8, as arrays need it.
    #[error("{}: the way to this folder is not text in UTF-8, and arrays cannot be stored there; name another place with -o", path.display())]
    PathNotText {
        /// The folder that was asked for.
        path: PathBuf,
    },
    /// The folder holds someone's files and no study.
    #[error("{}: not a study and not empty (it holds `{holds}`); name a new or an empty folder with -o, so that nothing of yours is overwritten", path.display())]
    ForeignFolder {
        /// The folder that was asked for.
        path: PathBuf,
        /// One of the files that stand in the way: the first by name.
        holds: String,
    },
    /// There is no study to open.
    #[error("{}: no study here; `judder run` makes one", path.display())]
    NoStudy {
        /// The folder that was asked for.
        path: PathBuf,
    },
    /// The folder for figures and page of another study holds a study itself.
    #[error("{}: holds a study, whose own report would be lost; name a new or an empty folder with -o", path.display())]
    HoldsStudy {
        /// The folder that was asked for.
        path: PathBuf,
    },
    /// Another process writes into this study.
    #[error("{}: another judder ({}) is at work in this study; wait until it ends, or name another folder with -o", path.display(), holder(path))]
    Locked {
        /// The study folder.
        path: PathBuf,
    },
    /// The disk, a quota or the largest permitted file is exhausted. What stood at `path` before still stands.
    #[error("{}: no room for {} ({source}); {}, then run again: what is done is kept", path.display(), room(*bytes), roomier(source))]
    DiskFull {
        /// What was to be written.
        path: PathBuf,
        /// How many bytes were to be written (before compression, for a dataset).
        bytes: u64,
        /// What the system said.
        source: io::Error,
    },
    /// The user may not write here.
    #[error("{}: not writable ({source}); change its permissions or name another folder with -o", path.display())]
    NotWritable {
        /// What was to be written.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// A folder has the name of a file of the study, and is not empty.
    #[error("{}: a folder stands in the place of a file of the study; move it away, or remove it", path.display())]
    FolderInPlace {
        /// The folder.
        path: PathBuf,
    },
    /// Any other failure of the file system.
    #[error("{}: could not {action}: {source}", path.display())]
    FileSystem {
        /// What was to be done, as a verb: `read`, `write`, `lock`.
        action: &'static str,
        /// The file or folder concerned.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// `summary.json` is damaged or was made by something else.
    #[error("{}: not a summary of judder ({source}); of a study with a `manifest.json` `judder run` computes it anew, else `judder run --fresh` replaces it, and -o names another folder", path.display())]
    SummaryUnreadable {
        /// The summary.
        path: PathBuf,
        /// Where and why reading stopped.
        source: serde_json::Error,
    },
    /// A document of a study that is longer than any that judder writes.
    #[error("{}: this file has {size} bytes, and such a file of judder at most {largest}; `judder run` computes anew what is damaged", path.display())]
    Oversized {
        /// The file.
        path: PathBuf,
        /// Its size in bytes.
        size: u64,
        /// The most that one has.
        largest: u64,
    },
    /// A summary that JSON cannot hold, such as a wall time that is not a number.
    #[error("{}: this summary cannot be written as JSON: {source}", path.display())]
    SummaryUnwritable {
        /// The summary.
        path: PathBuf,
        /// What JSON cannot hold.
        source: serde_json::Error,
    },
    /// `manifest.json` is damaged or was made by something else.
    #[error("{}: this list of what the study holds is damaged, so that nothing says that the study is whole; `judder run` computes it anew", path.display())]
    ManifestDamaged {
        /// The manifest.
        path: PathBuf,
    },
    /// A study without `manifest.json`.
    #[error("{}: without `manifest.json` nothing says that this study is whole: it is damaged, or of an older judder; `judder run` computes it anew", path.display())]
    NoManifest {
        /// The study folder.
        path: PathBuf,
    },
    /// A file of a study is not as it was written.
    #[error("{}: {damage}; `judder run` computes this result again and keeps the others, `judder verify` lists all that is damaged", path.display())]
    Damaged {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        damage: FileDamage,
    },
    /// A file of a study cannot be read, which says nothing of what it holds.
    #[error("{}: cannot be read ({reason}), which does not say that it is damaged; make it readable, or remove it: `judder run` then computes its result again", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// What the system said.
        reason: String,
    },
    /// A study tells of results of which nothing says that they are whole.
    #[error("{}: `{name}` was being written when a run ended, or the study is damaged: `manifest.json` does not list it; `judder run` computes it", path.display())]
    NotListed {
        /// The study folder.
        path: PathBuf,
        /// The analysis or sweep.
        name: String,
    },
    /// An analysis has no stored arrays.
    #[error("{}: no results stored here; run this analysis first", path.display())]
    NoDataset {
        /// The group of the analysis.
        path: PathBuf,
    },
    /// Stored arrays are damaged, or of a form that judder does not write.
    #[error("{}: stored results cannot be read ({source}); `judder run` computes them again where `judder verify` calls them damaged, `judder run --fresh` computes all anew", path.display())]
    DatasetUnreadable {
        /// The group, array or metadata file concerned.
        path: PathBuf,
        /// What was found.
        source: Box<dyn Error + Send + Sync>,
    },
    /// The array library refused a dataset.
    #[error("{}: results cannot be encoded: {source}", path.display())]
    DatasetUnwritable {
        /// The group concerned.
        path: PathBuf,
        /// The refusal.
        source: Box<dyn Error + Send + Sync>,
    },
    /// A name that cannot be a file name everywhere.
    #[error(
        "`{name}` cannot name {what}: use up to 200 of the letters A-Z and a-z, digits, `_`, `-` and `.`, starting with neither `.` nor `__` (and not `zarr.json`)"
    )]
    InvalidName {
        /// What was to be named, with its article: `a variable`.
        what: &'static str,
        /// The name.
        name: String,
    },
    /// Two things of one name.
    #[error("there are two {what}s named `{name}`; each needs a name of its own")]
    Duplicate {
        /// What is named: `variable`, `dimension`, `column`.
        what: &'static str,
        /// The name.
        name: String,
    },
    /// A variable whose shape does not fit its data or its dimension names.
    #[error(
        "variable `{variable}`: {found} values do not fill the shape {shape:?} over the dimensions {dimensions:?}"
    )]
    ShapeMismatch {
        /// The variable.
        variable: String,
        /// Its dimension names.
        dimensions: Vec<String>,
        /// Its shape.
        shape: Vec<usize>,
        /// How many values it holds.
        found: usize,
    },
    /// Two variables that disagree about the length of a dimension.
    #[error(
        "variable `{variable}`: dimension `{dimension}` has length {found} here and {expected} in `{before}`"
    )]
    DimensionConflict {
        /// The variable that was added last.
        variable: String,
        /// The dimension.
        dimension: String,
        /// A variable that was added before.
        before: String,
        /// Its length there.
        expected: usize,
        /// Its length in this variable.
        found: usize,
    },
    /// A variable named as a dimension that is not the coordinate of that dimension.
    #[error(
        "variable `{variable}` has the name of a dimension, so it must be that dimension's coordinate: one-dimensional, over `{variable}` alone"
    )]
    NotACoordinate {
        /// The variable.
        variable: String,
    },
    /// An attribute by which CF readers would change the values.
    #[error(
        "`{owner}`: the attribute `{attribute}` has a meaning of its own to readers of the store; choose another name"
    )]
    ReservedAttribute {
        /// The variable, or `dataset`.
        owner: String,
        /// The attribute.
        attribute: String,
    },
    /// A unit that readers would take for dates.
    #[error(
        "variable `{variable}`: readers of the store turn the unit `{units}` into dates; write the symbol (`s`, `ms`, `min`, `h`)"
    )]
    DateUnits {
        /// The variable.
        variable: String,
        /// Its unit.
        units: String,
    },
    /// A variable that cannot grow.
    #[error(
        "variable `{variable}` cannot grow: describe it as an array of real numbers or codes, of length 0 along its first dimension and longer along the others"
    )]
    CannotGrow {
        /// The variable.
        variable: String,
    },
    /// A variable that does not grow was asked for.
    #[error("no variable `{variable}` of real numbers grows here; there are {}", known.join(", "))]
    NotGrowing {
        /// The variable.
        variable: String,
        /// Those that grow.
        known: Vec<String>,
    },
    /// New values for more or fewer variables than grow.
    #[error("there are {found} slices of new values for {expected} growing variables; each needs one")]
    SliceCount {
        /// How many variables grow.
        expected: usize,
        /// How many slices there are.
        found: usize,
    },
    /// New values of another kind than the variable is of.
    #[error(
        "variable `{variable}`: real numbers and codes are not of one kind; give those that it was described with"
    )]
    SliceKind {
        /// The variable.
        variable: String,
    },
    /// New values that are no whole rows, or would leave variables of different lengths.
    #[error(
        "variable `{variable}`: {found} new values, where {expected} would be whole rows and as many as of the first variable of that dimension"
    )]
    SliceLength {
        /// The variable.
        variable: String,
        /// New values that would fit.
        expected: usize,
        /// New values of this one.
        found: usize,
    },
    /// A sweep without points, or without anything to store for them.
    #[error("the sweep `{sweep}` has no {what}; each of its dimensions needs a point, each point a quantity")]
    EmptySweep {
        /// The sweep.
        sweep: String,
        /// What is missing: `quantities`.
        what: String,
    },
    /// A sweep that no memory holds.
    #[error("the sweep `{sweep}` is too large: a chunk may have 1 GiB of values; make its chunks smaller")]
    SweepTooLarge {
        /// The sweep.
        sweep: String,
    },
    /// A chunk that the sweep has not.
    #[error("the sweep `{sweep}` has {count} chunks, counted from 0; there is no chunk {chunk}")]
    NoSuchChunk {
        /// The sweep.
        sweep: String,
        /// The chunk that was asked for.
        chunk: usize,
        /// How many there are.
        count: usize,
    },
    /// Values that do not fill a chunk.
    #[error(
        "chunk {chunk} of the sweep `{sweep}` takes {expected} values (quantities × points), not {found}"
    )]
    ChunkSize {
        /// The sweep.
        sweep: String,
        /// The chunk.
        chunk: usize,
        /// How many values it takes.
        expected: usize,
        /// How many there were.
        found: usize,
    },
    /// A failure of a point that the chunk has not.
    #[error(
        "chunk {chunk} of the sweep `{sweep}` has {points} points, counted from 0; point {index} cannot fail"
    )]
    FailureOutside {
        /// The sweep.
        sweep: String,
        /// The chunk.
        chunk: usize,
        /// The point.
        index: usize,
        /// How many there are.
        points: usize,
    },
    /// The group of a sweep belongs to another case.
    #[error("{}: holds a sweep of another case (its hash is {found}, that of this case {expected}); name another folder with -o, or compute anew with `judder run --fresh`", path.display())]
    ForeignSweep {
        /// The group.
        path: PathBuf,
        /// The hash of this case.
        expected: String,
        /// The hash of the group.
        found: String,
    },
    /// The group of a sweep was begun by another build.
    #[error("{}: holds a sweep that judder {found} computes, and this is judder {expected}, of which nobody has said that its numbers are the same; go on with judder {found}, name another folder with -o, or compute anew with `judder run --fresh`", path.display())]
    OtherBuild {
        /// The group.
        path: PathBuf,
        /// This build.
        expected: String,
        /// The build that began the sweep.
        found: String,
    },
    /// The group of a sweep has the right hash and another layout.
    #[error("{}: holds this sweep with other chunks, coordinates or quantities, as another version of judder lays it out; name another folder with -o, or compute anew with `judder run --fresh`", path.display())]
    OtherLayout {
        /// The group.
        path: PathBuf,
    },
    /// A chunk of another case lies among those of this one.
    #[error("{}: is a chunk of another case (its hash is {found}, that of this case {expected}); remove it, name another folder with -o, or compute anew with `judder run --fresh`", path.display())]
    ForeignChunk {
        /// The file of the chunk.
        path: PathBuf,
        /// The hash of this case.
        expected: String,
        /// The hash of the chunk.
        found: String,
    },
    /// A chunk is not as it was written.
    #[error("{}: this chunk is damaged: {damage}; `judder run` computes it again", path.display())]
    DamagedChunk {
        /// The file of the chunk.
        path: PathBuf,
        /// What is wrong with it.
        damage: ChunkDamage,
    },
    /// A chunk is not computed yet.
    #[error("{}: this chunk is not there; `judder run` computes it", path.display())]
    MissingChunk {
        /// Where its file will be.
        path: PathBuf,
    },
    /// A column that is longer or shorter than the first one.
    #[error("column `{column}` has {found} rows, the columns before have {expected}")]
    ColumnLength {
        /// The column.
        column: String,
        /// Rows of the columns before.
        expected: usize,
        /// Rows of this column.
        found: usize,
    },
    /// A folder of the study is a link, through which nothing is written.
    #[error("{}: a link stands in the place of a folder of the study, and nothing is written through it; remove it, or name another folder with -o", path.display())]
    LinkInPlace {
        /// The link.
        path: PathBuf,
    },
    /// A file that is not a plain place inside the study folder.
    #[error("{}: give a relative path that stays inside the study folder and is none of the store's own files", path.display())]
    OutsideFolder {
        /// The path that was asked for.
        path: PathBuf,
    },
}

/// What there is no room for: who makes a file or syncs it writes no bytes.
fn room(bytes: u64) -> String {
    match bytes {
        0 => "it".to_owned(),
        1 => "1 byte".to_owned(),
        bytes => format!("{bytes} bytes"),
    }
}

/// What makes room.
fn roomier(source: &io::Error) -> &'static str {
    match source.kind() {
        ErrorKind::FileTooLarge => "let larger files be written (`ulimit -f`)",
        _ => "free some space or name a folder on another disk",
    }
}

impl StoreError {
    /// Sorts a failed write of `bytes` bytes by what the user can do about it.
    pub(crate) fn write(path: &Path, bytes: u64, source: io::Error) -> Self {
        let path = path.to_owned();
        match source.kind() {
            ErrorKind::StorageFull | ErrorKind::QuotaExceeded | ErrorKind::FileTooLarge => {
                Self::DiskFull { path, bytes, source }
            }
            ErrorKind::PermissionDenied | ErrorKind::ReadOnlyFilesystem => Self::NotWritable { path, source },
            ErrorKind::IsADirectory => Self::FolderInPlace { path },
            _ => Self::FileSystem { action: "write", path, source },
        }
    }

    /// Whether something else stands where one file should be written; others can be.
    #[must_use]
    pub fn is_of_one_file(&self) -> bool {
        matches!(self, Self::FolderInPlace { .. } | Self::LinkInPlace { .. } | Self::OutsideFolder { .. })
    }

    /// What is wrong with a file of a study.
    pub(crate) fn of_damage(path: PathBuf, damage: FileDamage) -> Self {
        match damage {
            FileDamage::Unreadable(reason) => Self::Unreadable { path, reason },
            damage => Self::Damaged { path, damage },
        }
    }

    /// A failed read.
    pub(crate) fn read(path: &Path, source: io::Error) -> Self {
        let path = path.to_owned();
        match OversizedFile::of(&source) {
            Some(OversizedFile { size, largest }) => Self::Oversized { path, size, largest },
            None => Self::FileSystem { action: "read", path, source },
        }
    }

    /// A failed read of an array; an error of this crate stays what it is.
    pub(crate) fn of_array(path: &Path, source: Box<dyn Error + Send + Sync>) -> Self {
        match source.downcast() {
            Ok(own) => *own,
            Err(source) => Self::DatasetUnreadable { path: path.to_owned(), source },
        }
    }

    /// Stored results that make no sense.
    pub(crate) fn unreadable(path: &Path, source: impl Into<Box<dyn Error + Send + Sync>>) -> Self {
        Self::DatasetUnreadable { path: path.to_owned(), source: source.into() }
    }
}

/// Who holds the study, where that is known.
fn holder(study: &Path) -> String {
    lock_sign(study).holder.unwrap_or_else(|| "nobody knows which".to_owned())
}
