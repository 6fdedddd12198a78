//! The content of the file of a chunk: its shard and the record behind it.

use std::path::PathBuf;

use super::layout::{SweepLayout, VALUES};
use super::record::{self, PointFailure};
use super::shard;
use crate::StoreError;

impl SweepLayout {
    /// The content of the file of a chunk: same values, same bytes, on every machine. For those who compute where the study is not; see
    /// [`SweepStore::write_encoded`](crate::SweepStore::write_encoded).
    ///
    /// `values` holds those of all quantities of the first point, then of the second, in the order of [`position`](crate::ChunkPoints::position). Every
    /// NaN is stored as the same.
    ///
    /// # Errors
    /// [`StoreError::NoSuchChunk`], [`StoreError::ChunkSize`], [`StoreError::FailureOutside`].
    pub fn encode(
        &self,
        chunk: usize,
        values: &[f64],
        failures: &[PointFailure],
    ) -> Result<Vec<u8>, StoreError> {
        let points = self.points(chunk)?;
        let expected = points.count() * self.quantities().len();
        if values.len() != expected {
            let sweep = self.name().to_owned();
            return Err(StoreError::ChunkSize { sweep, chunk, expected, found: values.len() });
        }
        if let Some(outside) = failures.iter().find(|failure| failure.index >= points.count()) {
            let (sweep, index, points) = (self.name().to_owned(), outside.index, points.count());
            return Err(StoreError::FailureOutside { sweep, chunk, index, points });
        }
        let shard =
            shard::encode(self, &points, values).map_err(|refusal| StoreError::DatasetUnwritable {
                path: PathBuf::from(self.name()).join(VALUES),
                source: refusal.into(),
            })?;
        Ok(record::appended(shard, self, chunk, points.count(), failures))
    }
}
