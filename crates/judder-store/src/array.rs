//! What a stored array says of itself, and its values, all or a part.

use std::error::Error;
use std::sync::Arc;

use judder_memory::MemoryBudget;
use zarrs::array::{Array, ArrayError, ArrayMetadataV3, ArraySubset, ElementOwned, data_type};
use zarrs::filesystem::FilesystemStore;
use zarrs::metadata::v3::AdditionalFieldV3;
use zarrs::storage::StoreKey;

use crate::{StoreError, Variable, VariableValues, bounded_zstd, metadata, plain};

pub(crate) type ReadFailure = Box<dyn Error + Send + Sync>;

/// Opens an array of a group, whose values are unpacked to no more than its chunks have. Its metadata are read here: the array library would read any
/// file whole.
pub(crate) fn open(store: &Arc<FilesystemStore>, name: &str) -> Result<Array<FilesystemStore>, ReadFailure> {
    bounded_zstd::bind();
    let path = store.key_to_fspath(&StoreKey::new(format!("{name}/{}", metadata::FILE))?);
    let content = plain::read_json(&path).map_err(|source| StoreError::read(&path, source))?;
    let metadata: ArrayMetadataV3 = serde_json::from_slice(&content)?;
    if metadata.additional_fields.values().any(AdditionalFieldV3::must_understand) {
        return Err("its metadata ask for what judder does not know".into());
    }
    Ok(Array::new_with_metadata(store.clone(), &format!("/{name}"), metadata.into())?)
}

/// Refuses what takes more memory than there is: a part of an array, and a chunk of it, packed and unpacked.
pub(crate) fn ask_for(array: &Array<FilesystemStore>, part: &ArraySubset) -> Result<(), ReadFailure> {
    // texts say how long they are when they are unpacked
    let width = array.data_type().fixed_size().unwrap_or(0) as u128;
    let count = |lengths: &mut dyn Iterator<Item = u64>| {
        lengths.fold(1_u128, |product, length| product.saturating_mul(u128::from(length)))
    };
    let chunk = array.chunk_shape(&vec![0; array.dimensionality()])?;
    let chunk = count(&mut chunk.iter().map(|length| length.get())).saturating_mul(2);
    let needed = count(&mut part.shape().iter().copied()).saturating_add(chunk).saturating_mul(width);
    MemoryBudget::of_process().ask(needed).map_err(|beyond| format!("{beyond}; {}", beyond.remedy()).into())
}

/// The variable of an array with these data, some or all of its own; its shape is the array's.
pub(crate) fn with_data(
    name: &str,
    array: &Array<FilesystemStore>,
    data: VariableValues,
) -> Result<Variable, ReadFailure> {
    let shape = array.shape().iter().map(|&length| usize::try_from(length)).collect::<Result<Vec<_>, _>>()?;
    let dimensions = array.dimension_names().clone().ok_or("its dimensions have no names")?;
    let dimensions =
        dimensions.into_iter().collect::<Option<Vec<_>>>().ok_or("one of its dimensions has no name")?;
    let dimensions: Vec<&str> = dimensions.iter().map(String::as_str).collect();
    let mut variable = Variable::new(name, &dimensions, &shape, data);
    variable.attributes = array.attributes().clone();
    variable.units = metadata::take_text(&mut variable.attributes, "units");
    variable.long_name = metadata::take_text(&mut variable.attributes, "long_name");
    Ok(variable)
}

/// A part of the values of an array; `None` for none of them.
pub(crate) fn read_data(
    array: &Array<FilesystemStore>,
    part: Option<&ArraySubset>,
) -> Result<VariableValues, ReadFailure> {
    if let Some(part) = part {
        ask_for(array, part)?;
    }
    Ok(match array.data_type() {
        kind if *kind == data_type::float64() => VariableValues::F64(values(array, part)?),
        kind if *kind == data_type::complex128() => VariableValues::Complex(values(array, part)?),
        kind if *kind == data_type::int64() => VariableValues::I64(values(array, part)?),
        kind if *kind == data_type::uint8() => VariableValues::U8(values(array, part)?),
        kind if *kind == data_type::string() => VariableValues::Text(values(array, part)?),
        other => return Err(format!("values of type {other:?} are none that judder writes").into()),
    })
}

fn values<T: ElementOwned>(
    array: &Array<FilesystemStore>,
    part: Option<&ArraySubset>,
) -> Result<Vec<T>, ArrayError> {
    match part.filter(|part| !part.shape().contains(&0)) {
        Some(part) => array.retrieve_array_subset(part),
        None => Ok(Vec::new()),
    }
}
