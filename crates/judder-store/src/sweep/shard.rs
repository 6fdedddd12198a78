//! The values of one chunk as one shard of the Zarr array `values`.
//!
//! The index stands at the start; behind it comes one inner chunk a quantity, so that a reader of one quantity reads little else.

use std::error::Error;
use std::num::NonZeroU64;
use std::ops::Range;
use std::sync::Arc;

use zarrs::array::chunk_key_encoding::DefaultChunkKeyEncoding;
use zarrs::array::codec::{
    BytesCodec, Crc32cCodec, ShardingCodec, ShardingCodecBuilder, ShardingIndexLocation,
};
use zarrs::array::{
    Array, ArrayBuilder, BytesRepresentation, BytesToBytesCodecTraits, CodecError, CodecOptions,
    ZARR_NAN_F64, data_type,
};

use super::layout::{SweepLayout, VALUES};
use super::points::ChunkPoints;
use crate::Variable;
use crate::bounded_zstd::BoundedZstd;
use crate::group_store::GroupStore;
use crate::zarr::{COMPRESSION_LEVEL, WriteFailure};

const VALUE_BYTES: usize = size_of::<f64>();

/// What stands where there is no value: one NaN of all that there are.
const NOTHING: f64 = ZARR_NAN_F64;

/// The array `values`, of which nothing is written yet.
pub(super) fn build_array(
    store: &Arc<GroupStore>,
    layout: &SweepLayout,
    values: &Variable,
) -> Result<Array<GroupStore>, WriteFailure> {
    let shape: Vec<u64> = values.shape.iter().map(|&length| length as u64).collect();
    ArrayBuilder::new(shape, layout.chunk_shape(), data_type::float64(), NOTHING)
        .array_to_bytes_codec(Arc::new(codec(layout)))
        // One folder for all chunks: one list tells which are done.
        .chunk_key_encoding(DefaultChunkKeyEncoding::new_dot())
        .dimension_names(Some(values.dimensions.iter().map(String::as_str)))
        .build(store.clone(), &format!("/{VALUES}"))
        .map_err(|refusal| WriteFailure::Refused(refusal.into()))
}

/// The shard of a chunk; `values` are those of its points, quantities fastest. The bytes are those of the library, which takes five times as
/// long to pick the quantities apart.
pub(super) fn encode(
    layout: &SweepLayout,
    points: &ChunkPoints,
    values: &[f64],
) -> Result<Vec<u8>, CodecError> {
    let quantities = layout.quantities().len();
    let mut shard = vec![0; index_bytes(quantities)];
    let mut index = Vec::with_capacity(shard.len());
    for quantity in 0..quantities {
        let (mut column, mut is_empty) = (vec![NOTHING.to_le_bytes(); cells(layout)], true);
        let mut source = values.iter().skip(quantity).step_by(quantities);
        for place in rows(layout, points) {
            let slots = column.get_mut(place).unwrap_or_default();
            for (slot, value) in slots.iter_mut().zip(&mut source).filter(|(_, value)| !value.is_nan()) {
                *slot = value.to_le_bytes();
                is_empty = false;
            }
        }
        let (start, length) = if is_empty {
            (u64::MAX, u64::MAX)
        } else {
            let compressed = compression().encode(column.into_flattened().into(), &options())?;
            let checked = Crc32cCodec::new().encode(compressed, &options())?;
            shard.extend_from_slice(&checked);
            ((shard.len() - checked.len()) as u64, checked.len() as u64)
        };
        index.extend(start.to_le_bytes());
        index.extend(length.to_le_bytes());
    }
    let index = Crc32cCodec::new().encode(index.into(), &options())?;
    // room for it was left before the columns
    shard.splice(..index.len(), index.iter().copied());
    Ok(shard)
}

/// The values of a chunk from its shard.
pub(super) fn decode(
    layout: &SweepLayout,
    points: &ChunkPoints,
    shard: &[u8],
) -> Result<Vec<f64>, Box<dyn Error + Send + Sync>> {
    let quantities = layout.quantities().len();
    let mut values = vec![NOTHING; points.count() * quantities];
    let index = shard.get(..index_bytes(quantities)).ok_or("it ends before its index does")?;
    let index = Crc32cCodec::new().decode(index.into(), &BytesRepresentation::UnboundedSize, &options())?;
    let (numbers, _) = index.as_chunks::<VALUE_BYTES>();
    let (entries, _) = numbers.as_chunks::<2>();
    for (quantity, entry) in entries.iter().enumerate() {
        let [start, length] = entry.map(u64::from_le_bytes);
        if (start, length) == (u64::MAX, u64::MAX) {
            continue;
        }
        let column = usize::try_from(start).ok().and_then(|start| {
            let end = start.checked_add(usize::try_from(length).ok()?)?;
            shard.get(start..end)
        });
        let column = column.ok_or("its index refers to what is not there")?;
        let representation = BytesRepresentation::FixedSize((cells(layout) * VALUE_BYTES) as u64);
        let compressed =
            Crc32cCodec::new().decode(column.into(), &BytesRepresentation::UnboundedSize, &options())?;
        let column = compression().decode(compressed, &representation, &options())?;
        let (column, rest) = column.as_chunks::<VALUE_BYTES>();
        if column.len() != cells(layout) || !rest.is_empty() {
            return Err("one of its quantities has another size".into());
        }
        let mut target = values.iter_mut().skip(quantity).step_by(quantities);
        for place in rows(layout, points) {
            for (value, target) in column.get(place).unwrap_or_default().iter().zip(&mut target) {
                *target = f64::from_le_bytes(*value);
            }
        }
    }
    Ok(values)
}

/// Size of the index: where each quantity starts, how long it is, and a checksum.
fn index_bytes(quantities: usize) -> usize {
    quantities * 2 * VALUE_BYTES + 4
}

/// Values of one quantity in a chunk of full size.
fn cells(layout: &SweepLayout) -> usize {
    layout.dimensions().iter().map(|dimension| dimension.chunk).product()
}

/// Where each row of points, along the last dimension, stands in a chunk of full size.
fn rows(layout: &SweepLayout, points: &ChunkPoints) -> impl Iterator<Item = Range<usize>> {
    let length = points.shape.last().copied().unwrap_or(1);
    let full: Vec<usize> = layout.dimensions().iter().map(|dimension| dimension.chunk).collect();
    let shape = points.shape.clone();
    (0..points.count() / length).map(move |row| {
        let (mut rest, mut stride, mut start) = (row, full.last().copied().unwrap_or(1), 0);
        for (along, full) in shape.iter().zip(&full).rev().skip(1) {
            start += rest % along * stride;
            rest /= along;
            stride *= full;
        }
        start..start + length
    })
}

/// The codecs of the array, for its metadata.
fn codec(layout: &SweepLayout) -> ShardingCodec {
    let mut inner = counts(&layout.chunk_shape());
    if let Some(quantities) = inner.last_mut() {
        *quantities = NonZeroU64::MIN;
    }
    ShardingCodecBuilder::new(inner, &data_type::float64())
        .array_to_bytes_codec(Arc::new(BytesCodec::little()))
        .bytes_to_bytes_codecs(vec![Arc::new(compression()), Arc::new(Crc32cCodec::new())])
        .index_array_to_bytes_codec(Arc::new(BytesCodec::little()))
        .index_bytes_to_bytes_codecs(vec![Arc::new(Crc32cCodec::new())])
        .index_location(ShardingIndexLocation::Start)
        .build()
}

fn compression() -> BoundedZstd {
    BoundedZstd::new(COMPRESSION_LEVEL)
}

/// The caller computes several chunks at once; one is done by one thread.
fn options() -> CodecOptions {
    CodecOptions::default().with_concurrent_target(1)
}

fn counts(shape: &[u64]) -> Vec<NonZeroU64> {
    shape.iter().filter_map(|&length| NonZeroU64::new(length)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{SweepDimension, SweepQuantity};
    use zarrs::array::codec::SubchunkWriteOrder;
    use zarrs::array::{ArrayBytes, ArrayToBytesCodecTraits, FillValue};

    /// A sweep of 3 × 4 × 5 points with chunks of 2 × 3 × 4.
    fn layout() -> SweepLayout {
        let dimension = |(name, length, chunk): (&str, usize, usize)| {
            let name = name.to_owned();
            SweepDimension { name, length, chunk }
        };
        let dimensions = [("a", 3, 2), ("b", 4, 3), ("c", 5, 4)].map(dimension).to_vec();
        let quantities = ["q", "r", "nothing"].map(|name| SweepQuantity::new(name, "1", "")).to_vec();
        SweepLayout::new("s", "h", dimensions, quantities).unwrap()
    }

    #[test]
    fn a_shard_is_that_of_the_library() {
        let layout = layout();
        for chunk in 0..layout.chunk_count() {
            let points = layout.points(chunk).unwrap();
            let value = |point: usize| {
                points.position(point).iter().fold(0.1, |sum, along| sum * 7.0 + *along as f64)
            };
            let values: Vec<f64> =
                (0..points.count()).flat_map(|point| [value(point), -value(point), f64::NAN]).collect();
            let shard = encode(&layout, &points, &values).unwrap();

            let mut padded = vec![NOTHING; 2 * 3 * 4 * 3];
            for (point, values) in values.chunks(3).enumerate() {
                let position = points.position(point);
                let [a, b, c] = [0, 1, 2].map(|axis| position[axis] - points.first[axis]);
                padded[((a * 3 + b) * 4 + c) * 3..][..3].copy_from_slice(values);
            }
            let bytes: Vec<u8> = padded.iter().flat_map(|value| value.to_ne_bytes()).collect();
            let library = codec(&layout).with_subchunk_write_order(SubchunkWriteOrder::C).encode(
                ArrayBytes::new_flen(bytes),
                &counts(&layout.chunk_shape()),
                &data_type::float64(),
                &FillValue::from(NOTHING),
                &options(),
            );
            assert!(shard == *library.unwrap(), "chunk {chunk}");
            let decoded = decode(&layout, &points, &shard).unwrap();
            assert!(decoded.iter().zip(&values).all(|(decoded, value)| decoded.to_bits() == value.to_bits()));
        }
    }

    #[test]
    fn no_damaged_shard_is_decoded() {
        let (layout, points) = (layout(), layout().points(0).unwrap());
        let shard = encode(&layout, &points, &vec![0.5; points.count() * 3]).unwrap();
        for place in 0..shard.len() {
            let mut damaged = shard.clone();
            damaged[place] ^= 1;
            decode(&layout, &points, &damaged).unwrap_err();
            decode(&layout, &points, &shard[..place]).unwrap_err();
        }
    }
}
