//! What the command does besides running cases: templates, the schema, examples, reports, papers, the page.

use crate::cases::CaseSource;
use crate::choice::meant;
use crate::errors;
use crate::watched::{Manner, is_ctrl_c, watched};
use judder_examples::{Example, example, examples};
use judder_explorer::{Explorer, ViewedCase};
use judder_keys::memory::Memory;
use judder_memory::MemoryBudget;
use judder_models::template::template;
use judder_papers::{Paper, rebuild};
use judder_store::{ChunkDamage, StoreError, StudyFolder, verify, vouch_for, vouch_for_file};
use judder_study::{Progress, StudyError, version};
use pyo3::exceptions::PyBaseException;
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{self, JoinHandle};

/// Sets how many bytes of memory this process takes at most; with none three quarters of what is free.
#[pyfunction]
pub(crate) fn limit_memory(bytes: Option<u64>) {
    MemoryBudget::tell(bytes.unwrap_or(0));
}

/// The bytes of an amount of memory such as `4 GiB`; none where it is none, or less than the least.
#[pyfunction]
pub(crate) fn bytes_of_memory(amount: &str) -> Option<u64> {
    Memory::parse(amount).map(|memory| memory.bytes)
}

/// The commented case file of this name.
#[pyfunction]
pub(crate) fn template_text(name: &str) -> PyResult<String> {
    template(name).map_err(|error| errors::case(&error))
}

/// The JSON Schema of case files.
#[pyfunction]
pub(crate) fn schema_text() -> String {
    judder_models::schema().to_string()
}

/// Rebuilds figures and report of a study folder; returns the path of the page, and the figures that it lacks.
#[pyfunction]
pub(crate) fn rebuilt_report(py: Python<'_>, folder: PathBuf) -> PyResult<(PathBuf, Vec<String>)> {
    let done = watched(py, &Manner::default(), |_| rebuild(&folder, None))?;
    let page = done.settled(|error| errors::study(&error))?;
    let lacking = page.lacking();
    Ok((page.path, lacking))
}

/// Whether a study folder is as it was written, as JSON.
#[pyfunction]
pub(crate) fn verified_study(py: Python<'_>, folder: PathBuf) -> PyResult<String> {
    let done = watched(py, &Manner::default(), |watch| {
        let found = verify(&folder, |_, _| !watch.interrupted())?;
        if watch.interrupted() { Err(StudyError::Interrupted) } else { Ok(found.told().to_string()) }
    })?;
    done.settled(|error| errors::study(&error))
}

/// Refuses the summary of a study where its manifest says that it was another.
#[pyfunction]
pub(crate) fn vouch_for_summary(folder: PathBuf, manifest: &[u8], summary: &[u8]) -> PyResult<()> {
    vouch_for(&folder, manifest, summary).map_err(|error| errors::study(&error.into()))
}

/// Lists the files below a folder of a study; where others are at work on it, whoever completes it may do so.
#[pyfunction]
pub(crate) fn listed_files(folder: PathBuf, below: &str) -> PyResult<()> {
    let listed = StudyFolder::open(folder).and_then(|study| {
        study.list_files(below)?;
        study.seal_as_before(version())
    });
    match listed {
        Err(StoreError::Locked { .. } | StoreError::NoStudy { .. }) => Ok(()),
        listed => listed.map_err(|error| errors::store(&error)),
    }
}

/// Refuses the content of a file of a study that is not of this size with this hash.
#[pyfunction]
pub(crate) fn vouch_for_content(path: PathBuf, bytes: u64, hash: &str, content: &[u8]) -> PyResult<()> {
    vouch_for_file(&path, bytes, hash, content).map_err(|error| errors::store(&error))
}

/// The error of a chunk that is not there; with `part` of one of which that part is damaged, its end, its `record` or its `values`.
#[pyfunction]
#[pyo3(signature = (path, part=None))]
pub(crate) fn unusable_chunk(py: Python<'_>, path: PathBuf, part: Option<&str>) -> Py<PyBaseException> {
    let error = match part {
        None => StoreError::MissingChunk { path },
        Some("record") => StoreError::DamagedChunk { path, damage: ChunkDamage::Record },
        Some("values") => StoreError::DamagedChunk { path, damage: ChunkDamage::Values },
        Some(_) => StoreError::DamagedChunk { path, damage: ChunkDamage::NoRecord },
    };
    errors::store(&error).into_value(py)
}

/// The error of a chunk of another case.
#[pyfunction]
pub(crate) fn foreign_chunk(
    py: Python<'_>,
    path: PathBuf,
    expected: String,
    found: String,
) -> Py<PyBaseException> {
    errors::store(&StoreError::ForeignChunk { path, expected, found }).into_value(py)
}

/// Recomputes a paper; its scoreboard as JSON.
#[pyfunction]
#[pyo3(signature = (paper, *, quick, output, threads, progress))]
pub(crate) fn reproduced_paper(
    py: Python<'_>,
    paper: &str,
    quick: bool,
    output: Option<PathBuf>,
    threads: Option<usize>,
    progress: Option<Py<PyAny>>,
) -> PyResult<String> {
    let found = Paper::ALL.into_iter().find(|own| own.name() == paper).ok_or_else(|| {
        let known = meant(paper, Paper::ALL.into_iter().map(Paper::name));
        errors::input("paper", format!("there is no `{paper}`; {known}"))
    })?;
    let manner = Manner::on_threads_of_its_own(progress, threads)?;
    let folder = output.unwrap_or_else(|| found.usual_folder());
    let done = watched(py, &manner, |watch| found.reproduce(&folder, quick, watch))?;
    if matches!(done.result, Err(StudyError::Interrupted))
        && done.stopped.as_ref().is_none_or(|stop| is_ctrl_c(py, stop))
    {
        return Err(errors::interrupted(&StudyError::Interrupted.to_string()));
    }
    Ok(done.settled(|error| errors::study(&error))?.json().to_string())
}

/// An example as Python takes it: name, kind, title, file, text, the files that it names.
type ToldExample<'py> = (String, &'static str, String, String, String, Vec<(String, Bound<'py, PyBytes>)>);

/// All examples, or that of a name, of which its last part is enough.
#[pyfunction]
#[pyo3(signature = (name=None))]
pub(crate) fn embedded_examples<'py>(py: Python<'py>, name: Option<&str>) -> PyResult<Vec<ToldExample<'py>>> {
    let found = match name {
        Some(name) => vec![example(name).map_err(|error| errors::example(&error))?],
        None => examples(),
    };
    let told = |own: Example| {
        let files = own.files.iter().map(|(name, content)| (name.clone(), PyBytes::new(py, content)));
        (own.name, own.kind.name(), own.title, own.file, own.text, files.collect())
    };
    Ok(found.into_iter().map(told).collect())
}

/// Writes an example and the files that it names into a folder; returns its path.
#[pyfunction]
pub(crate) fn written_example(name: &str, folder: PathBuf) -> PyResult<PathBuf> {
    let own = example(name).map_err(|error| errors::example(&error))?;
    own.write(&folder).map_err(|error| errors::example(&error))
}

/// The local page while it is served, by a thread of its own.
#[pyclass(frozen, module = "judder._judder")]
pub(crate) struct ServedPage {
    address: String,
    stop: Arc<AtomicBool>,
    server: Mutex<Option<JoinHandle<Result<(), String>>>>,
}

#[pymethods]
impl ServedPage {
    /// Serves a case, a study folder, or the oscillator paper's oscillator.
    #[new]
    #[pyo3(signature = (case, overrides, *, study, port))]
    fn new(
        py: Python<'_>,
        case: Option<CaseSource>,
        overrides: Vec<String>,
        study: Option<PathBuf>,
        port: Option<u16>,
    ) -> PyResult<Self> {
        let case = case.map(|case| case.read(&overrides)).transpose()?;
        let open = || Explorer::new(ViewedCase::of(case, study.as_deref())?, port);
        let explorer = py.detach(open).map_err(|error| errors::explorer(&error))?;
        let (address, stop) = (explorer.address(), Arc::new(AtomicBool::new(false)));
        let asked = Arc::clone(&stop);
        let serve =
            move || explorer.serve(&|| asked.load(Ordering::Relaxed)).map_err(|error| error.to_string());
        let server = thread::Builder::new().name("judder-page".to_owned()).spawn(serve);
        let server = Mutex::new(Some(server.map_err(errors::system)?));
        Ok(Self { address, stop, server })
    }

    /// The address, with the token that lets a browser in.
    #[getter]
    fn address(&self) -> &str {
        &self.address
    }

    /// Whether it is served.
    #[getter]
    fn is_open(&self) -> bool {
        let server = self.server.lock().unwrap_or_else(PoisonError::into_inner);
        server.as_ref().is_some_and(|server| !server.is_finished())
    }

    /// Ends it; what works is cancelled.
    fn close(&self, py: Python<'_>) -> PyResult<()> {
        self.stop.store(true, Ordering::Relaxed);
        let server = self.server.lock().unwrap_or_else(PoisonError::into_inner).take();
        match py.detach(|| server.map(JoinHandle::join)) {
            None | Some(Ok(Ok(()))) => Ok(()),
            Some(Ok(Err(error))) => Err(errors::system(error)),
            Some(Err(_)) => Err(errors::fault()),
        }
    }
}

impl Drop for ServedPage {
    fn drop(&mut self) {
        self.stop.store(true, Ordering::Relaxed);
    }
}
