//! What a sweep would take, from a few of its points.

use super::evaluate::{Evaluator, Tried};
use super::plan::SweepPlan;
use crate::error::StudyError;
use crate::progress::Progress;
use crate::text::{columns, short};
use judder_store::SweepChunks;
use serde_json::{Value, json};
use std::path::Path;

/// What one sweep would take.
#[derive(Debug, Clone, PartialEq)]
pub struct SweepEstimate {
    /// Its name.
    pub name: String,
    /// All its points.
    pub points: u64,
    /// All its chunks.
    pub chunks: usize,
    /// The chunks that are in the study folder already.
    pub done: usize,
    /// Seconds of one point on one thread, measured.
    pub seconds_per_point: f64,
    /// How many points were tried for that.
    pub tried: usize,
    /// How many of them failed.
    pub failed: usize,
    /// Why the first of them did.
    pub first_failure: Option<String>,
    /// Threads that work on chunks.
    pub threads: usize,
    /// Bytes of a chunk in memory, times the threads, in the making.
    pub memory: u64,
    /// Bytes of all values on the disk, before compression.
    pub stored: u64,
    /// What to do about more chunks than a folder takes well.
    pub advice: Option<String>,
}

impl SweepEstimate {
    /// Measures a few points of a sweep; writes nothing, and looks into the study folder where there is one.
    ///
    /// # Errors
    /// A case that cannot be prepared, a folder with a sweep of another case, [`StudyError::Interrupted`].
    pub fn new(plan: &SweepPlan, folder: &Path, progress: &dyn Progress) -> Result<Self, StudyError> {
        let layout = plan.layout();
        let Tried { seconds, points, reasons } = Evaluator::new(plan, progress)?.tried(progress)?;
        let chunk = layout.dimensions().iter().map(|dimension| dimension.chunk as u64).product::<u64>();
        let row = 8 * layout.quantities().len() as u64;
        let threads = rayon::current_num_threads();
        // values, their columns apart, and the compressed file
        let memory = 3 * chunk * row * threads as u64;
        let there = SweepChunks::look(folder, layout)?.map(|chunks| chunks.done_chunks()).transpose()?;
        let done = there.unwrap_or_default().into_iter().filter(|done| *done).count();
        Ok(Self {
            name: layout.name().to_owned(),
            points: plan.sweep().points(),
            chunks: layout.chunk_count(),
            done,
            seconds_per_point: seconds,
            tried: points,
            failed: reasons.len(),
            first_failure: reasons.into_iter().next(),
            threads,
            memory,
            stored: plan.sweep().points() * row,
            advice: plan.advice(),
        })
    }

    /// Seconds of what is left, on all threads.
    #[must_use]
    pub fn seconds(&self) -> f64 {
        let left = (self.chunks - self.done) as f64 / self.chunks as f64;
        left * self.points as f64 * self.seconds_per_point / self.threads as f64
    }

    /// For `--json`.
    #[must_use]
    pub fn json(&self) -> Value {
        json!({
            "name": self.name, "points": self.points, "chunks": self.chunks, "chunks_done": self.done,
            "seconds_per_point": self.seconds_per_point, "points_tried": self.tried,
            "points_failed": self.failed, "first_failure": self.first_failure, "threads": self.threads, "seconds": self.seconds(),
            "memory_bytes": self.memory, "stored_bytes": self.stored,
        })
    }

    /// For the terminal.
    #[must_use]
    pub fn text(&self) -> String {
        let rows = [
            ("points", self.points.to_string()),
            ("chunks", format!("{} ({} done)", self.chunks, self.done)),
            ("time of a point", format!("{} s", short(self.seconds_per_point))),
            ("time left", format!("{} on {} threads", duration(self.seconds()), self.threads)),
            ("memory", bytes(self.memory)),
            ("on the disk, at most", bytes(self.stored)),
        ];
        let mut rows: Vec<Vec<String>> = rows.map(|(name, value)| vec![name.to_owned(), value]).to_vec();
        if let Some(reason) = &self.first_failure {
            let failed = format!("{} of {} points; the first: {reason}", self.failed, self.tried);
            rows.push(vec!["failed when tried".to_owned(), failed]);
        }
        let advice = self.advice.as_ref().map(|advice| format!("  {advice}\n")).unwrap_or_default();
        format!("{}\n{}{advice}", self.name, columns(&rows))
    }
}

fn duration(seconds: f64) -> String {
    match seconds {
        s if s < 120.0 => format!("{s:.1} s"),
        s if s < 7200.0 => format!("{:.1} min", s / 60.0),
        s if s < 172_800.0 => format!("{:.1} h", s / 3600.0),
        s => format!("{:.1} days", s / 86_400.0),
    }
}

fn bytes(count: u64) -> String {
    let count = count as f64;
    let units = [(1e12, "TB"), (1e9, "GB"), (1e6, "MB"), (1e3, "kB")];
    match units.iter().find(|(size, _)| count >= *size) {
        Some((size, unit)) => format!("{:.1} {unit}", count / size),
        None => format!("{count} B"),
    }
}
