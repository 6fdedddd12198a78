//! Sweeps: many points, computed chunk by chunk, by any number of processes on one folder, without a coordinator.
//!
//! In the order in which the data flows:
//!
//! - [`SweepLayout`] (`layout.rs`): the points of a sweep, how they are cut into chunks, and which quantities each point has.
//! - [`ChunkPoints`] (`points.rs`): the points of one chunk.
//! - `shard.rs`: the values of one chunk as one shard of the Zarr array `values`.
//! - [`PointFailure`] (`record.rs`), [`ChunkDamage`] (`damage.rs`): the record behind the shard, by which a chunk says whose it is and which of its
//!   points failed.
//! - `encode.rs`: shard and record, the file of a chunk.
//! - `group.rs`: the group of a sweep in `results.zarr`, the same bytes whoever begins it.
//! - [`ChunkClaim`] (`claim.rs`): the right to compute one chunk.
//! - [`SweepChunks`] (`chunks.rs`): the chunks on the disk: listed, read, verified.
//! - [`SweepStore`] (`store.rs`): the same held: claimed, written.
//! - `sampled.rs`: some of the points, from the group alone.

mod chunks;
mod claim;
mod damage;
mod encode;
mod group;
mod layout;
mod points;
mod record;
mod sampled;
mod shard;
mod store;

pub use chunks::{ChunkFile, ChunkState, StoredChunk, SweepChunks, SweepFailure};
pub(crate) use claim::PREFIX;
pub use claim::{ChunkClaim, ClaimAnswer};
pub use damage::ChunkDamage;
pub(crate) use group::{frame, has_frame, mend};
pub(crate) use layout::{CHUNKS, is_chunk};
pub use layout::{SweepDimension, SweepLayout, SweepQuantity};
pub use points::ChunkPoints;
pub use record::PointFailure;
pub(crate) use sampled::read_points;
pub use store::SweepStore;
