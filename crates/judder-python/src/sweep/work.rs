//! How the work of a sweep is done beside the interpreter.

use super::PySweep;
use crate::errors;
use crate::pool;
use crate::watched::{Manner, Watched, WorkWatch, is_ctrl_c, watched};
use judder_study::StudyError;
use judder_study::run::{RunOptions, SweepWork, run};
use judder_study::sweep::Evaluator;
use pyo3::exceptions::PyIndexError;
use pyo3::prelude::*;
use std::path::Path;
use std::sync::{Arc, TryLockError};
use std::thread;
use std::time::Duration;

/// How long to wait before looking again whether another thread has made what all points share.
const PAUSE: Duration = Duration::from_millis(5);

impl PySweep {
    /// The outcome of watched work on the threads of this sweep.
    pub(super) fn done<T: Send>(
        &self,
        py: Python<'_>,
        stop: Option<Py<PyAny>>,
        work: impl FnOnce(&WorkWatch) -> Result<T, StudyError> + Send,
    ) -> PyResult<T> {
        let pool = self.pool.clone().map_or_else(|| pool::of(0).map(Arc::new), Ok);
        let manner = Manner { pool: Some(pool.map_err(errors::system)?), stop, ..Manner::default() };
        settled(py, watched(py, &manner, work)?)
    }

    /// Runs this sweep alone of its case.
    pub(super) fn ran(
        &self,
        py: Python<'_>,
        manner: &Manner,
        folder: &Path,
        sweeps: SweepWork,
    ) -> PyResult<(Vec<String>, bool)> {
        let options = RunOptions { only: vec![self.name().to_owned()], sweeps, ..RunOptions::default() };
        let report =
            settled(py, watched(py, manner, |watch| run(self.plan.file(), folder, &options, watch))?)?;
        // where it is whole what its results lack is told by the study
        let lacking = if report.parted.is_empty() { Vec::new() } else { report.lacking };
        Ok(([report.notes, lacking].concat(), report.report.is_some()))
    }

    /// Refuses a point that a chunk has not.
    pub(super) fn check_point(&self, chunk: usize, index: usize) -> PyResult<()> {
        let points = self.plan.layout().points(chunk).map_err(|error| errors::store(&error))?;
        let count = points.count();
        if index < count { Ok(()) } else { Err(no_point(chunk, index, count)) }
    }

    /// What all points share. It is made once, and on no thread of the pool is it waited for: one that waits there might have
    /// taken up this very call amid the making.
    pub(super) fn evaluator(
        &self,
        py: Python<'_>,
        stop: Option<Py<PyAny>>,
    ) -> PyResult<Arc<Evaluator<'static>>> {
        let mut made = loop {
            match self.evaluator.try_lock() {
                Ok(made) => break made,
                Err(TryLockError::Poisoned(made)) => break made.into_inner(),
                Err(TryLockError::WouldBlock) => {
                    py.check_signals()?;
                    py.detach(|| thread::sleep(PAUSE));
                }
            }
        };
        if let Some(evaluator) = &*made {
            return Ok(Arc::clone(evaluator));
        }
        let evaluator = Arc::new(self.done(py, stop, |watch| Evaluator::owned(self.plan.clone(), watch))?);
        Ok(Arc::clone(made.insert(evaluator)))
    }
}

/// The result of watched work that can be interrupted.
fn settled<T>(py: Python<'_>, done: Watched<Result<T, StudyError>>) -> PyResult<T> {
    if matches!(done.result, Err(StudyError::Interrupted))
        && done.stopped.as_ref().is_none_or(|stop| is_ctrl_c(py, stop))
    {
        return Err(errors::interrupted(&StudyError::Interrupted.to_string()));
    }
    done.settled(|error| errors::study(&error))
}

/// A point that a chunk has not.
fn no_point(chunk: usize, index: usize, count: usize) -> PyErr {
    PyIndexError::new_err(format!("chunk {chunk} has {count} points, there is no point {index}"))
}
