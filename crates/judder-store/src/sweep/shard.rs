//! The values of one chunk as one shard of the Zarr array `values`.
//!
//! The index stands at the start; behind it comes one inner chunk a quantity, so that a reader of one quantity reads little else.

use std::num::NonZeroU64;
use std::path::Path;
use std::sync::Arc;

use zarrs::array::chunk_key_encoding::DefaultChunkKeyEncoding;
use zarrs::array::codec::{
    BytesCodec, Crc32cCodec, ShardingCodec, ShardingCodecBuilder, ShardingIndexLocation, SubchunkWriteOrder,
    ZstdCodec,
};
use zarrs::array::{
    Array, ArrayBuilder, ArrayBytes, ArrayToBytesCodecTraits, CodecError, CodecOptions, FillValue,
    ZARR_NAN_F64, data_type,
};
use zarrs::filesystem::FilesystemStore;

use super::layout::{ChunkPoints, SweepLayout, VALUES};
use crate::zarr::{COMPRESSION_LEVEL, WriteFailure};
use crate::{StoreError, Variable};

const VALUE_BYTES: usize = size_of::<f64>();

/// The array `values`, of which nothing is written yet.
pub(super) fn build_array(
    store: &Arc<FilesystemStore>,
    layout: &SweepLayout,
    values: &Variable,
) -> Result<Array<FilesystemStore>, WriteFailure> {
    let shape: Vec<u64> = values.shape.iter().map(|&length| length as u64).collect();
    ArrayBuilder::new(shape, layout.chunk_shape(), data_type::float64(), ZARR_NAN_F64)
        .array_to_bytes_codec(Arc::new(codec(layout)))
        // One folder for all chunks: one list tells which are done.
        .chunk_key_encoding(DefaultChunkKeyEncoding::new_dot())
        .dimension_names(Some(values.dimensions.iter().map(String::as_str)))
        .build(store.clone(), &format!("/{VALUES}"))
        .map_err(|refusal| WriteFailure::Refused(refusal.into()))
}

/// The shard of a chunk; `values` are those of its points, quantities fastest.
pub(super) fn encode(
    layout: &SweepLayout,
    points: &ChunkPoints,
    values: &[f64],
) -> Result<Vec<u8>, StoreError> {
    let shape = layout.chunk_shape();
    let mut padded = vec![ZARR_NAN_F64; shape.iter().product::<u64>() as usize];
    for (row, place) in rows(layout, points).enumerate() {
        let row = &values[row * place.len()..(row + 1) * place.len()];
        for (slot, value) in padded[place].iter_mut().zip(row).filter(|(_, value)| !value.is_nan()) {
            *slot = *value;
        }
    }
    let bytes: Vec<u8> = padded.iter().flat_map(|value| value.to_ne_bytes()).collect();
    let encoded = codec(layout).encode(
        ArrayBytes::new_flen(bytes),
        &counts(&shape),
        &data_type::float64(),
        &FillValue::from(ZARR_NAN_F64),
        &options(),
    );
    let encoded = encoded.map_err(|refusal| StoreError::DatasetUnwritable {
        path: Path::new(layout.name()).join(VALUES),
        source: refusal.into(),
    })?;
    Ok(encoded.into_owned())
}

/// The values of a chunk from its shard.
pub(super) fn decode(
    layout: &SweepLayout,
    points: &ChunkPoints,
    shard: &[u8],
) -> Result<Vec<f64>, CodecError> {
    let decoded = codec(layout).decode(
        shard.into(),
        &counts(&layout.chunk_shape()),
        &data_type::float64(),
        &FillValue::from(ZARR_NAN_F64),
        &options(),
    )?;
    let bytes = decoded.into_fixed()?;
    let (padded, _) = bytes.as_chunks::<VALUE_BYTES>();
    let rows = rows(layout, points).filter_map(|place| padded.get(place));
    Ok(rows.flatten().map(|value| f64::from_ne_bytes(*value)).collect())
}

/// Where the values of each row of points, along the last dimension, stand in a chunk of full size.
fn rows(layout: &SweepLayout, points: &ChunkPoints) -> impl Iterator<Item = std::ops::Range<usize>> {
    let quantities = layout.quantities().len();
    let length = points.shape.last().map_or(0, |along| along * quantities);
    let count = points.count() / points.shape.last().copied().unwrap_or(1);
    let full: Vec<usize> = layout.dimensions().iter().map(|dimension| dimension.chunk).collect();
    let shape = points.shape.clone();
    (0..count).map(move |row| {
        let (mut rest, mut stride, mut start) = (row, full.last().copied().unwrap_or(1) * quantities, 0);
        for (along, full) in shape.iter().zip(&full).rev().skip(1) {
            start += rest % along * stride;
            rest /= along;
            stride *= full;
        }
        start..start + length
    })
}

fn codec(layout: &SweepLayout) -> ShardingCodec {
    let mut inner = counts(&layout.chunk_shape());
    if let Some(quantities) = inner.last_mut() {
        *quantities = NonZeroU64::MIN;
    }
    ShardingCodecBuilder::new(inner, &data_type::float64())
        .array_to_bytes_codec(Arc::new(BytesCodec::little()))
        .bytes_to_bytes_codecs(vec![
            Arc::new(ZstdCodec::new(COMPRESSION_LEVEL, false)),
            Arc::new(Crc32cCodec::new()),
        ])
        .index_array_to_bytes_codec(Arc::new(BytesCodec::little()))
        .index_bytes_to_bytes_codecs(vec![Arc::new(Crc32cCodec::new())])
        .index_location(ShardingIndexLocation::Start)
        .build()
        // Else the inner chunks stand in the order in which threads come to them.
        .with_subchunk_write_order(SubchunkWriteOrder::C)
}

/// The caller computes several chunks at once; one is done by one thread.
fn options() -> CodecOptions {
    CodecOptions::default().with_concurrent_target(1)
}

fn counts(shape: &[u64]) -> Vec<NonZeroU64> {
    shape.iter().filter_map(|&length| NonZeroU64::new(length)).collect()
}
