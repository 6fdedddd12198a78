//! What can be wrong with the file of a chunk.

/// What is wrong with the file of a chunk. Computing the chunk again replaces it.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ChunkDamage {
    /// It does not end as a chunk does.
    #[error("it is cut off, or was written by something else")]
    NoRecord,
    /// What stands where a record should is none.
    #[error("its record is damaged")]
    Record,
    /// A chunk of this sweep in the place of another.
    #[error("it holds chunk {found}")]
    OtherChunk {
        /// The chunk that it holds.
        found: usize,
    },
    /// A chunk of another case, where the list of the study has one of this.
    #[error("it holds a chunk of another case")]
    OtherCase,
    /// Points or quantities that the layout of the sweep has not.
    #[error("it holds {points} points with {quantities} quantities")]
    OtherShape {
        /// Points that it holds.
        points: usize,
        /// Quantities of each.
        quantities: usize,
    },
    /// Values that are not those that were written.
    #[error("its values are damaged")]
    Values,
}
