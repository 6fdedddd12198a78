//! A sweep of a case, chunk by chunk.

mod work;

use crate::cases::{CasePackage, CaseSource, folder_of, package_of, with_law_in};
use crate::contact::PyLaw;
use crate::errors;
use crate::pool;
use crate::watched::{Manner, watched};
use judder_store::{PointFailure, SweepStore};
use judder_study::StudyError;
use judder_study::case::file::CaseFile;
use judder_study::run::{SweepWork, plans};
use judder_study::sweep::{Evaluator, Shard, SweepEstimate, SweepPlan, joined, missing};
use numpy::{IntoPyArray, PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use pyo3::types::PyBytes;
use rayon::ThreadPool;
use rayon::prelude::*;
use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};

/// A sweep of a case: what it has, and its chunks.
#[pyclass(frozen, name = "Sweep", module = "judder._judder")]
pub(crate) struct PySweep {
    plan: SweepPlan,
    /// Threads of its own, so that a worker keeps them from call to call.
    pool: Option<Arc<ThreadPool>>,
    evaluator: Mutex<Option<Arc<Evaluator<'static>>>>,
}

#[pymethods]
impl PySweep {
    /// The sweeps of a case, in their order; with a law in place of that of the case, whose file goes into a folder.
    #[staticmethod]
    #[pyo3(signature = (case, overrides, *, threads = None, law = None))]
    fn all(
        py: Python<'_>,
        case: CaseSource,
        overrides: Vec<String>,
        threads: Option<usize>,
        law: Option<(Py<PyLaw>, PathBuf)>,
    ) -> PyResult<Vec<Self>> {
        // refuses a number of threads that no machine has
        Manner::new(None, threads)?;
        let pool = threads.map(|threads| pool::of(threads).map(Arc::new)).transpose();
        let pool = pool.map_err(errors::system)?;
        // the files that it names are read, which may take a while
        let plans = py.detach(|| {
            let file = match &law {
                Some((law, folder)) => with_law_in(folder, &case, overrides, law.get())?.0,
                None => case.read(&overrides)?,
            };
            plans_of(&file).map_err(|error| errors::study(&error))
        })?;
        let of = |plan| Self { plan, pool: pool.clone(), evaluator: Mutex::new(None) };
        Ok(plans.into_iter().map(of).collect())
    }

    #[getter]
    fn name(&self) -> &str {
        self.plan.layout().name()
    }

    /// What names all that its values depend on.
    #[getter]
    fn hash(&self) -> &str {
        self.plan.layout().hash()
    }

    #[getter]
    fn method(&self) -> &str {
        self.plan.sweep().method.name()
    }

    #[getter]
    fn points(&self) -> usize {
        self.plan.layout().point_count()
    }

    #[getter]
    fn chunks(&self) -> usize {
        self.plan.layout().chunk_count()
    }

    #[getter]
    fn shape(&self) -> Vec<usize> {
        self.plan.layout().dimensions().iter().map(|dimension| dimension.length).collect()
    }

    #[getter]
    fn chunk_shape(&self) -> Vec<usize> {
        self.plan.layout().dimensions().iter().map(|dimension| dimension.chunk).collect()
    }

    #[getter]
    fn keys(&self) -> Vec<String> {
        self.plan.sweep().axes.iter().map(|axis| axis.path.clone()).collect()
    }

    #[getter]
    fn quantities(&self) -> Vec<String> {
        self.plan.sweep().quantities.iter().map(|quantity| quantity.text.clone()).collect()
    }

    /// All that another machine needs to make this sweep.
    #[getter]
    fn package(&self) -> CasePackage {
        package_of(self.plan.file())
    }

    /// What is left of it would take, as `judder run --dry-run --json` has it.
    #[pyo3(signature = (folder = None))]
    fn estimate(&self, py: Python<'_>, folder: Option<PathBuf>) -> PyResult<String> {
        let folder = || folder_of(self.plan.file(), folder, false);
        let estimate = self.done(py, None, |watch| SweepEstimate::new(&self.plan, &folder()?, watch))?;
        Ok(estimate.json().to_string())
    }

    /// The chunks that a folder lacks.
    fn missing<'py>(&self, py: Python<'py>, folder: PathBuf) -> PyResult<Bound<'py, PyArray1<i64>>> {
        let missing = self.done(py, None, |watch| missing(&self.plan, &folder, watch))?;
        Ok(missing.into_iter().map(|chunk| chunk as i64).collect::<Vec<_>>().into_pyarray(py))
    }

    /// Makes what all points share, where it is not there yet.
    #[pyo3(signature = (*, stop = None))]
    fn prepare(&self, py: Python<'_>, stop: Option<Py<PyAny>>) -> PyResult<()> {
        self.evaluator(py, stop).map(|_| ())
    }

    /// The contents of the files of these chunks, computed one after the other.
    #[pyo3(signature = (chunks, *, stop = None))]
    fn compute<'py>(
        &self,
        py: Python<'py>,
        chunks: Vec<usize>,
        stop: Option<Py<PyAny>>,
    ) -> PyResult<Vec<Bound<'py, PyBytes>>> {
        let evaluator = self.evaluator(py, stop.as_ref().map(|stop| stop.clone_ref(py)))?;
        let contents = self.done(py, stop, |watch| {
            let content = |chunk: &usize| {
                let made = evaluator.chunk(*chunk, watch)?;
                Ok(self.plan.layout().encode(*chunk, &made.values, &made.failures)?)
            };
            chunks.iter().map(content).collect::<Result<Vec<_>, _>>()
        })?;
        Ok(contents.iter().map(|content| PyBytes::new(py, content)).collect())
    }

    /// The columns of the points of a chunk, a row a point.
    fn values<'py>(&self, py: Python<'py>, chunk: usize) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let evaluator = self.evaluator(py, None)?;
        let made = self.done(py, None, |watch| evaluator.chunk(chunk, watch))?;
        let rows = made.values.len() / self.plan.layout().quantities().len();
        made.values.into_pyarray(py).reshape([rows, self.plan.layout().quantities().len()])
    }

    /// Computes these chunks into a folder that others work on, too; those that are there now, and those that another computes.
    #[pyo3(signature = (folder, chunks, *, stop = None))]
    fn compute_into(
        &self,
        py: Python<'_>,
        folder: PathBuf,
        chunks: Vec<usize>,
        stop: Option<Py<PyAny>>,
    ) -> PyResult<(Vec<usize>, Vec<usize>)> {
        let evaluator = self.evaluator(py, stop.as_ref().map(|stop| stop.clone_ref(py)))?;
        let handed = self.done(py, stop, |watch| evaluator.chunks_into(&folder, &chunks, watch))?;
        Ok((handed.done, handed.busy))
    }

    /// The columns of one point of a chunk, and why something of it is missing.
    fn point<'py>(
        &self,
        py: Python<'py>,
        chunk: usize,
        index: usize,
    ) -> PyResult<(Bound<'py, PyArray1<f64>>, Option<String>)> {
        self.check_point(chunk, index)?;
        let evaluator = self.evaluator(py, None)?;
        let (row, reason) = self.done(py, None, |watch| evaluator.point_of(chunk, index, watch))?;
        Ok((row.into_pyarray(py), reason))
    }

    /// The columns of a point that nobody could compute.
    fn point_without_values<'py>(
        &self,
        py: Python<'py>,
        chunk: usize,
        index: usize,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        self.check_point(chunk, index)?;
        let row = self.plan.point_without_values(chunk, index);
        Ok(row.map_err(|error| errors::study(&error))?.into_pyarray(py))
    }

    /// Holds a folder together with others that work on it, so that nobody takes it alone meanwhile; begins the sweep in it.
    fn hold(&self, py: Python<'_>, folder: PathBuf) -> PyResult<HeldSweep> {
        let store = self.done(py, None, |watch| Ok(joined(&folder, watch)?.sweep(self.plan.layout())?))?;
        Ok(HeldSweep { store: Mutex::new(Some(store)), pool: self.pool.clone() })
    }

    /// The content of the file of a chunk, from the values and the failures of its points.
    fn encoded<'py>(
        &self,
        py: Python<'py>,
        chunk: usize,
        values: Vec<f64>,
        failures: Vec<(usize, String)>,
    ) -> PyResult<Bound<'py, PyBytes>> {
        let failures: Vec<PointFailure> =
            failures.into_iter().map(|(index, reason)| PointFailure { index, reason }).collect();
        let content = py.detach(|| self.plan.layout().encode(chunk, &values, &failures));
        Ok(PyBytes::new(py, &content.map_err(|error| errors::store(&error))?))
    }

    /// How many points a chunk has.
    fn count(&self, chunk: usize) -> PyResult<usize> {
        let points = self.plan.layout().points(chunk);
        points.map(|points| points.count()).map_err(|error| errors::store(&error))
    }

    /// Computes the missing chunks of a part into a folder, with the threads of this process.
    #[pyo3(signature = (folder, *, shard, threads, progress))]
    fn run(
        &self,
        py: Python<'_>,
        folder: PathBuf,
        shard: Option<&str>,
        threads: Option<usize>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Vec<String>> {
        let shard = shard.map_or(Ok(Shard::WHOLE), str::parse);
        let shard = shard.map_err(|reason| errors::input("shard", reason))?;
        let manner = Manner::on_threads_of_its_own(progress, threads)?;
        self.ran(py, &manner, &folder, SweepWork::Part(shard)).map(|(notes, _)| notes)
    }

    /// Completes summary and report of a folder in which all chunks are; says whether they are.
    fn merge(&self, py: Python<'_>, folder: PathBuf) -> PyResult<(Vec<String>, bool)> {
        let manner = Manner::on_threads_of_its_own(None, None)?;
        self.ran(py, &manner, &folder, SweepWork::Merge)
    }

    fn __repr__(&self) -> String {
        format!("Sweep({:?}: {} points in {} chunks)", self.name(), self.points(), self.chunks())
    }
}

/// A sweep in a study folder that is held.
#[pyclass(frozen, name = "HeldSweep", module = "judder._judder")]
pub(crate) struct HeldSweep {
    store: Mutex<Option<SweepStore>>,
    pool: Option<Arc<ThreadPool>>,
}

#[pymethods]
impl HeldSweep {
    /// Writes chunks that were computed elsewhere; those that are there stay.
    fn write(&self, py: Python<'_>, chunks: Vec<(usize, PyBackedBytes)>) -> PyResult<()> {
        let store = self.store.lock().unwrap_or_else(PoisonError::into_inner).clone();
        let store = store.ok_or_else(|| {
            errors::input("folder", "it is let go, and nothing is written into it any more")
        })?;
        let manner = Manner { pool: self.pool.clone(), ..Manner::default() };
        let write =
            || chunks.par_iter().try_for_each(|(chunk, content)| store.write_encoded(*chunk, content));
        // on the disk in any order: each says itself which it is
        watched(py, &manner, |_| write())?.settled(|error| errors::store(&error))
    }

    /// Lets the folder go.
    fn release(&self) {
        self.store.lock().unwrap_or_else(PoisonError::into_inner).take();
    }
}

/// The sweeps of a case; none where it has none.
fn plans_of(file: &CaseFile) -> Result<Vec<SweepPlan>, StudyError> {
    let names: Vec<String> = file.sweeps.iter().map(|sweep| sweep.name.clone()).collect();
    // no name would be all of them, which a case without sweeps has none of either
    if names.is_empty() { Ok(Vec::new()) } else { plans(file, &names) }
}
