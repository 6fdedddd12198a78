//! One dataset as one group of a Zarr v3 store: an array a variable, compressed with zstd, each chunk with a checksum.

use std::collections::BTreeMap;
use std::error::Error;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use num_complex::Complex64;
use serde_json::{Map, Value};
use zarrs::array::codec::{Crc32cCodec, ZstdCodec};
use zarrs::array::{
    Array, ArrayBuilder, ArrayError, ArrayMetadataOptions, ArraySubset, CodecError, CodecOptions, DataType,
    Element, FillValue, data_type,
};
use zarrs::filesystem::FilesystemStore;
use zarrs::storage::StorageError;

use crate::array::{self, ReadFailure};
use crate::group_store::{GroupStore, WrittenFiles};
use crate::metadata::{self, HASH_ATTRIBUTE};
use crate::{Dataset, StoreError, Variable, VariableValues, plain};

/// A chunk is one file: large enough that a map of 1000 × 1000 is one, small enough to be read alone from a large one.
const CHUNK_BYTES: u64 = 8 << 20;

/// No store of ours has chunks beyond this; damaged metadata that says so must not be believed.
const LARGEST_CHUNK_BYTES: u64 = 1 << 30;

pub(crate) const COMPRESSION_LEVEL: i32 = 3;

/// Files with the values of variables of real numbers or codes that are too long for memory, by the names of the variables; each number is eight bytes,
/// the least significant first, each code one.
pub(crate) type Elsewhere = BTreeMap<String, PathBuf>;

/// Why a group could not be written.
pub(crate) enum WriteFailure {
    /// The file system failed.
    Io(io::Error),
    /// The array library refused.
    Refused(Box<dyn Error + Send + Sync>),
}

impl From<io::Error> for WriteFailure {
    fn from(source: io::Error) -> Self {
        Self::Io(source)
    }
}

impl From<StorageError> for WriteFailure {
    fn from(failure: StorageError) -> Self {
        match failure {
            // The library shares its errors; ours own theirs, with the same code.
            StorageError::IOError(source) => Self::Io(match source.raw_os_error() {
                Some(code) => io::Error::from_raw_os_error(code),
                None => io::Error::new(source.kind(), source.to_string()),
            }),
            other => Self::Refused(other.into()),
        }
    }
}

impl From<ArrayError> for WriteFailure {
    fn from(failure: ArrayError) -> Self {
        match failure {
            ArrayError::StorageError(storage) | ArrayError::CodecError(CodecError::StorageError(storage)) => {
                storage.into()
            }
            other => Self::Refused(other.into()),
        }
    }
}

/// Writes a dataset as the group in `folder`, which must not exist yet; gives back its files.
pub(crate) fn write_group(
    folder: &Path,
    hash: &str,
    dataset: &Dataset,
    elsewhere: &Elsewhere,
) -> Result<WrittenFiles, WriteFailure> {
    write_group_by(folder, hash, dataset, |store, variable| match elsewhere.get(&variable.name) {
        Some(path) => write_from_file(store, variable, path),
        None => write_variable(store, variable),
    })
}

/// The same, where `write` stores a variable and returns the metadata of its array.
pub(crate) fn write_group_by(
    folder: &Path,
    hash: &str,
    dataset: &Dataset,
    write: impl Fn(&Arc<GroupStore>, &Variable) -> Result<Value, WriteFailure>,
) -> Result<WrittenFiles, WriteFailure> {
    judder_disk::create_folder(folder)?;
    put_group_by(&group_store(folder)?, folder, hash, dataset, write)
}

/// The files that [`write_group_by`] writes; nothing is written.
pub(crate) fn files_of_group_by(
    folder: &Path,
    hash: &str,
    dataset: &Dataset,
    write: impl Fn(&Arc<GroupStore>, &Variable) -> Result<Value, WriteFailure>,
) -> Result<WrittenFiles, WriteFailure> {
    let store = GroupStore::told(folder).map_err(|refusal| WriteFailure::Refused(refusal.into()))?;
    put_group_by(&Arc::new(store), folder, hash, dataset, write)
}

fn put_group_by(
    store: &Arc<GroupStore>,
    folder: &Path,
    hash: &str,
    dataset: &Dataset,
    write: impl Fn(&Arc<GroupStore>, &Variable) -> Result<Value, WriteFailure>,
) -> Result<WrittenFiles, WriteFailure> {
    let group = describe_group_by(store, hash, dataset, write)?;
    store.put(folder.join(metadata::FILE), &metadata::content(&group))?;
    Ok(store.written())
}

/// The store in a folder, to write a group or to describe it.
pub(crate) fn group_store(folder: &Path) -> Result<Arc<GroupStore>, WriteFailure> {
    GroupStore::new(folder).map(Arc::new).map_err(|refusal| WriteFailure::Refused(refusal.into()))
}

/// The metadata of the group of a dataset, where `describe` returns that of the array of a variable in its store.
pub(crate) fn describe_group_by(
    store: &Arc<GroupStore>,
    hash: &str,
    dataset: &Dataset,
    describe: impl Fn(&Arc<GroupStore>, &Variable) -> Result<Value, WriteFailure>,
) -> Result<Map<String, Value>, WriteFailure> {
    let mut members = Map::new();
    for variable in dataset.variables() {
        members.insert(variable.name.clone(), describe(store, variable)?);
    }
    Ok(metadata::group(group_attributes(hash, dataset), Some(members)))
}

/// Writes one variable and returns the metadata of its array.
pub(crate) fn write_variable(store: &Arc<GroupStore>, variable: &Variable) -> Result<Value, WriteFailure> {
    match &variable.data {
        VariableValues::F64(values) => write_array(store, variable, values),
        VariableValues::Complex(values) => write_array(store, variable, values),
        VariableValues::I64(values) => write_array(store, variable, values),
        VariableValues::U8(values) => write_array(store, variable, values),
        VariableValues::Text(values) => write_array(store, variable, values),
    }
}

/// The metadata of the array that [`write_variable`] writes; nothing is written.
pub(crate) fn describe_variable(store: &Arc<GroupStore>, variable: &Variable) -> Result<Value, WriteFailure> {
    array_metadata(&build_array(store, variable)?)
}

/// Writes the values of one variable and returns the metadata of its array.
fn write_array<T: Element>(
    store: &Arc<GroupStore>,
    variable: &Variable,
    values: &[T],
) -> Result<Value, WriteFailure> {
    let array = create_array(store, variable)?;
    if !values.is_empty() {
        array.store_array_subset_opt(&array.subset_all(), values, &with_empty_chunks())?;
    }
    array_metadata(&array)
}

/// Writes a variable whose values lie in a file, as many rows at a time as a chunk has, and returns the metadata of its array.
fn write_from_file(store: &Arc<GroupStore>, variable: &Variable, path: &Path) -> Result<Value, WriteFailure> {
    let array = create_array(store, variable)?;
    let value_size = variable.data.value_size() as u64;
    let chunk = chunk_shape(array.shape(), value_size).first().copied().unwrap_or(1);
    let mut ranges: Vec<_> = array.shape().iter().map(|length| 0..*length).collect();
    let rows = ranges.first().map_or(0, |rows| rows.end);
    let row_size = ranges.iter().skip(1).map(|range| range.end).product::<u64>() * value_size;
    let mut file = plain::open(path)?;
    let mut first = 0;
    while first < rows {
        let next = (first + chunk).min(rows);
        let mut bytes = vec![0; ((next - first) * row_size) as usize];
        file.read_exact(&mut bytes)?;
        if let Some(rows) = ranges.first_mut() {
            *rows = first..next;
        }
        let subset = ArraySubset::new_with_ranges(&ranges);
        if let VariableValues::U8(_) = variable.data {
            array.store_array_subset_opt(&subset, &bytes[..], &with_empty_chunks())?;
        } else {
            let numbers = bytes.as_chunks().0.iter();
            let values: Vec<f64> = numbers.map(|number| f64::from_le_bytes(*number)).collect();
            array.store_array_subset_opt(&subset, &values[..], &with_empty_chunks())?;
        }
        first = next;
    }
    array_metadata(&array)
}

/// Chunks of fill values are stored too, so that a missing file is a damage and not a result.
fn with_empty_chunks() -> CodecOptions {
    CodecOptions::default().with_store_empty_chunks(true)
}

/// The library's signature would show up among the attributes in a notebook.
fn plain_metadata() -> ArrayMetadataOptions {
    ArrayMetadataOptions::default().with_include_zarrs_metadata(false)
}

/// Writes the metadata of an array.
pub(crate) fn store_metadata(array: &Array<GroupStore>) -> Result<(), WriteFailure> {
    array.store_metadata_opt(&plain_metadata()).map_err(WriteFailure::from)
}

pub(crate) fn array_metadata(array: &Array<GroupStore>) -> Result<Value, WriteFailure> {
    serde_json::to_value(array.metadata_opt(&plain_metadata()))
        .map_err(|refusal| WriteFailure::Refused(refusal.into()))
}

/// An array without values yet.
fn create_array(store: &Arc<GroupStore>, variable: &Variable) -> Result<Array<GroupStore>, WriteFailure> {
    let array = build_array(store, variable)?;
    store_metadata(&array)?;
    Ok(array)
}

/// An array of which nothing is written yet.
fn build_array(store: &Arc<GroupStore>, variable: &Variable) -> Result<Array<GroupStore>, WriteFailure> {
    let shape: Vec<u64> = variable.shape.iter().map(|&length| length as u64).collect();
    let chunk_shape = chunk_shape(&shape, variable.data.value_size() as u64);
    let (data_type, fill_value) = kind(&variable.data);
    ArrayBuilder::new(shape, chunk_shape, data_type, fill_value)
        .bytes_to_bytes_codecs(vec![
            Arc::new(ZstdCodec::new(COMPRESSION_LEVEL, false)),
            Arc::new(Crc32cCodec::new()),
        ])
        .dimension_names(Some(variable.dimensions.iter().map(String::as_str)))
        .attributes(variable.told())
        .build(store.clone(), &format!("/{}", variable.name))
        .map_err(|refusal| WriteFailure::Refused(refusal.into()))
}

/// Type and fill value of an array.
fn kind(data: &VariableValues) -> (DataType, FillValue) {
    match data {
        VariableValues::F64(_) => (data_type::float64(), f64::NAN.into()),
        VariableValues::Complex(_) => (data_type::complex128(), Complex64::new(f64::NAN, f64::NAN).into()),
        VariableValues::I64(_) => (data_type::int64(), i64::MIN.into()),
        VariableValues::U8(_) => (data_type::uint8(), u8::MAX.into()),
        VariableValues::Text(_) => (data_type::string(), "".into()),
    }
}

/// Halves the longest axis until a chunk has at most [`CHUNK_BYTES`].
fn chunk_shape(shape: &[u64], value_size: u64) -> Vec<u64> {
    let mut chunk: Vec<u64> = shape.iter().map(|&length| length.max(1)).collect();
    while chunk.iter().product::<u64>().saturating_mul(value_size) > CHUNK_BYTES {
        match chunk.iter_mut().max() {
            Some(longest) => *longest = longest.div_ceil(2),
            None => break,
        }
    }
    chunk
}

fn group_attributes(hash: &str, dataset: &Dataset) -> Map<String, Value> {
    let mut attributes = dataset.attributes().clone();
    let auxiliary: Vec<&str> = dataset
        .variables()
        .iter()
        .filter(|variable| variable.is_coordinate && variable.dimensions != [variable.name.as_str()])
        .map(|variable| variable.name.as_str())
        .collect();
    if !auxiliary.is_empty() {
        // The CF convention's list, which makes coordinates of variables that are no dimension's own.
        attributes.insert("coordinates".into(), auxiliary.join(" ").into());
    }
    attributes.insert(HASH_ATTRIBUTE.into(), hash.into());
    attributes
}

/// The hash under which the group in `folder` was written; `None` where there is no sound group.
pub(crate) fn stored_hash(folder: &Path) -> Option<String> {
    let mut group = metadata::read(folder).ok()?;
    let mut attributes = metadata::take_object(&mut group, "attributes")?;
    Some(metadata::take_text(&mut attributes, HASH_ATTRIBUTE))
}

/// The attributes of the group in `folder`.
pub(crate) fn read_attributes(folder: &Path) -> Result<Map<String, Value>, StoreError> {
    Ok(metadata::take_object(&mut metadata::read(folder)?, "attributes").unwrap_or_default())
}

/// Reads the group in `folder` back.
pub(crate) fn read_group(folder: &Path) -> Result<Dataset, StoreError> {
    read_group_by(folder, read_variable)
}

/// The same, where `read` gives back a variable of the store by its name.
pub(crate) fn read_group_by(
    folder: &Path,
    read: impl Fn(&Arc<FilesystemStore>, &str) -> Result<Variable, ReadFailure>,
) -> Result<Dataset, StoreError> {
    let mut group = metadata::read(folder)?;
    let members = metadata::take_members(&mut group)
        .ok_or_else(|| StoreError::unreadable(folder, "its metadata do not list its arrays"))?;
    let mut attributes = metadata::take_object(&mut group, "attributes").unwrap_or_default();
    attributes.remove(HASH_ATTRIBUTE);
    let coordinates = metadata::take_text(&mut attributes, "coordinates");
    let coordinates: Vec<&str> = coordinates.split_whitespace().collect();

    let store = FilesystemStore::new(folder).map_err(|source| StoreError::unreadable(folder, source))?;
    let store = Arc::new(store);
    let damaged = |source| StoreError::unreadable(folder, source);
    let mut variables = Vec::with_capacity(members.len());
    for name in members.keys() {
        let mut variable =
            read(&store, name).map_err(|source| StoreError::of_array(&folder.join(name), source))?;
        variable.is_coordinate |= coordinates.contains(&name.as_str());
        variables.push(variable);
    }
    let mut dataset = Dataset::new();
    for variable in in_agreement(variables) {
        let path = folder.join(&variable.name);
        dataset = dataset.with(variable).map_err(|source| StoreError::unreadable(&path, source))?;
    }
    for (name, value) in attributes {
        dataset = dataset.attribute(&name, value).map_err(damaged)?;
    }
    Ok(dataset)
}

/// The variables of a group, those last whose lengths along their dimensions are not those of most others: what does not fit is theirs. They keep
/// their order where all agree.
fn in_agreement(mut variables: Vec<Variable>) -> Vec<Variable> {
    let mut known: BTreeMap<(&str, usize), usize> = BTreeMap::new();
    for variable in &variables {
        for (dimension, length) in variable.dimensions.iter().zip(&variable.shape) {
            *known.entry((dimension, *length)).or_default() += 1;
        }
    }
    let most = |dimension: &str, length: usize| {
        let own = known.get(&(dimension, length));
        known.iter().all(|((other, _), count)| *other != dimension || Some(count) <= own)
    };
    let is_odd = |variable: &Variable| {
        variable.dimensions.iter().zip(&variable.shape).any(|(dimension, length)| !most(dimension, *length))
    };
    let odd: Vec<bool> = variables.iter().map(is_odd).collect();
    let mut odd = odd.into_iter();
    variables.sort_by_cached_key(|_| odd.next());
    variables
}

pub(crate) fn read_variable(store: &Arc<FilesystemStore>, name: &str) -> Result<Variable, ReadFailure> {
    let array = array::open(store, name)?;
    check_chunks(store, &array)?;
    let data = array::read_data(&array, Some(&array.subset_all()))?;
    array::with_data(name, &array, data)
}

/// Refuses an array with chunks of absurd size.
pub(crate) fn check_chunk_size(array: &Array<FilesystemStore>) -> Result<(), ReadFailure> {
    let origin = vec![0; array.dimensionality()];
    let values =
        array.chunk_shape(&origin)?.iter().try_fold(1_u64, |count, length| count.checked_mul(length.get()));
    if values.is_none_or(|count| count > LARGEST_CHUNK_BYTES / 16) {
        return Err("its metadata ask for chunks of absurd size".into());
    }
    Ok(())
}

/// Refuses an array with a chunk missing, which would otherwise read as fill values, or of absurd size.
fn check_chunks(store: &FilesystemStore, array: &Array<FilesystemStore>) -> Result<(), ReadFailure> {
    check_chunk_size(array)?;
    if array.shape().contains(&0) {
        return Ok(());
    }
    for indices in &ArraySubset::new_with_shape(array.chunk_grid_shape().to_vec()).indices() {
        let chunk = store.key_to_fspath(&array.chunk_key(&indices));
        if !chunk.is_file() {
            return Err(format!("a part is missing: {}", chunk.display()).into());
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chunks_are_whole_where_small_and_bounded_where_large() {
        assert_eq!(chunk_shape(&[1000, 1000], 8), [1000, 1000]);
        assert_eq!(chunk_shape(&[], 8), Vec::<u64>::new());
        assert_eq!(chunk_shape(&[0, 5], 8), [1, 5]);
        let large = chunk_shape(&[20_000, 3, 7000], 16);
        assert!(large.iter().product::<u64>() * 16 <= CHUNK_BYTES);
        assert!(large.iter().product::<u64>() * 16 > CHUNK_BYTES / 4);
    }
}
