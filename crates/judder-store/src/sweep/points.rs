//! The points of one chunk.

/// The points of one chunk: a box.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ChunkPoints {
    /// Position of its first point along each dimension.
    pub first: Vec<usize>,
    /// Points along each dimension.
    pub shape: Vec<usize>,
}

impl ChunkPoints {
    /// How many points it has.
    #[must_use]
    pub fn count(&self) -> usize {
        self.shape.iter().product()
    }

    /// Position of a point along each dimension, in the whole sweep; `point` counts the points of the chunk, row-major.
    #[must_use]
    pub fn position(&self, point: usize) -> Vec<usize> {
        let within = unravelled(point, self.shape.iter().copied());
        within.iter().zip(&self.first).map(|(index, first)| index + first).collect()
    }
}

/// Row-major position along each axis.
pub(super) fn unravelled(mut index: usize, shape: impl DoubleEndedIterator<Item = usize>) -> Vec<usize> {
    let mut position: Vec<usize> = shape
        .rev()
        .map(|length| {
            let along = index % length.max(1);
            index /= length.max(1);
            along
        })
        .collect();
    position.reverse();
    position
}
