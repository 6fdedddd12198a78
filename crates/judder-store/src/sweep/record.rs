//! The record behind the shard of a chunk, by which the chunk says whose it is, that it is whole, and which of its points failed.
//!
//! A file of a chunk is the shard, the record as JSON, then 48 bytes: the BLAKE3 hash of the record (32 bytes), its length (8 bytes, the least
//! significant first), and `judderC1`. No entry of the index of a shard refers to what stands behind it, so readers of Zarr never see the record.

use serde::{Deserialize, Serialize};

use super::damage::ChunkDamage;
use super::layout::SweepLayout;
use crate::content_hash;

/// The last bytes of a chunk.
const MAGIC: &[u8; 8] = b"judderC1";

/// Hash of the record, its length, [`MAGIC`].
pub(super) const TRAILER_BYTES: usize = 48;

/// A point that has no answer, and why.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct PointFailure {
    /// Which point of its chunk, row-major.
    pub index: usize,
    /// The error, with its causes. The same point must fail with the same words wherever it is computed.
    pub reason: String,
}

/// What is found at the end of the file of a chunk.
#[derive(Debug, PartialEq)]
pub(super) enum ChunkEnd {
    /// Ours.
    Whole(Record),
    /// Ours, but not as it was written.
    Damaged(ChunkDamage),
    /// A chunk of another case.
    Foreign(String),
}

/// The record of a chunk.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Record {
    hash: String,
    chunk: usize,
    points: usize,
    quantities: usize,
    /// Size of the shard.
    bytes: usize,
    /// Hash of the shard.
    checksum: String,
    /// By index.
    pub(super) failures: Vec<PointFailure>,
}

/// The file of a chunk: its shard with its record.
pub(super) fn appended(
    mut shard: Vec<u8>,
    layout: &SweepLayout,
    chunk: usize,
    points: usize,
    failures: &[PointFailure],
) -> Vec<u8> {
    let mut failures = failures.to_vec();
    failures.sort_by_key(|failure| failure.index);
    let record = Record {
        hash: layout.hash().to_owned(),
        chunk,
        points,
        quantities: layout.quantities().len(),
        bytes: shard.len(),
        checksum: content_hash(&shard),
        failures,
    };
    // Texts and whole numbers: JSON has all of them.
    let record = serde_json::to_vec(&record).unwrap_or_default();
    shard.extend(&record);
    shard.extend(blake3::hash(&record).as_bytes());
    shard.extend((record.len() as u64).to_le_bytes());
    shard.extend(MAGIC);
    shard
}

/// The length of the record that stands before the trailer; `None` where there is no trailer.
pub(super) fn length(trailer: &[u8]) -> Option<usize> {
    let (length, _) = trailer.strip_suffix(MAGIC)?.get(32..)?.split_first_chunk()?;
    usize::try_from(u64::from_le_bytes(*length)).ok()
}

/// What the end of a file, from its record on, says; `shard` is what stands before it, in bytes.
pub(super) fn read(layout: &SweepLayout, chunk: usize, points: usize, end: &[u8], shard: u64) -> ChunkEnd {
    let Some((record, trailer)) = end.split_last_chunk::<TRAILER_BYTES>() else {
        return ChunkEnd::Damaged(ChunkDamage::NoRecord);
    };
    if !trailer.starts_with(blake3::hash(record).as_bytes()) {
        return ChunkEnd::Damaged(ChunkDamage::Record);
    }
    let Ok(record) = serde_json::from_slice::<Record>(record) else {
        return ChunkEnd::Damaged(ChunkDamage::Record);
    };
    let quantities = layout.quantities().len();
    if record.hash != layout.hash() {
        ChunkEnd::Foreign(record.hash)
    } else if record.chunk != chunk {
        ChunkEnd::Damaged(ChunkDamage::OtherChunk { found: record.chunk })
    } else if (record.points, record.quantities) != (points, quantities) {
        ChunkEnd::Damaged(ChunkDamage::OtherShape { points: record.points, quantities: record.quantities })
    } else if record.bytes as u64 != shard {
        ChunkEnd::Damaged(ChunkDamage::Values)
    } else {
        ChunkEnd::Whole(record)
    }
}

/// What the whole content of a file says, and its shard.
pub(super) fn verified<'a>(
    layout: &SweepLayout,
    chunk: usize,
    points: usize,
    content: &'a [u8],
) -> (ChunkEnd, &'a [u8]) {
    let start = content
        .split_last_chunk::<TRAILER_BYTES>()
        .and_then(|(before, trailer)| before.len().checked_sub(length(trailer)?));
    let Some((shard, end)) = start.and_then(|start| content.split_at_checked(start)) else {
        return (ChunkEnd::Damaged(ChunkDamage::NoRecord), &[]);
    };
    let found = match read(layout, chunk, points, end, shard.len() as u64) {
        ChunkEnd::Whole(record) if record.checksum != content_hash(shard) => {
            ChunkEnd::Damaged(ChunkDamage::Values)
        }
        found => found,
    };
    (found, shard)
}
