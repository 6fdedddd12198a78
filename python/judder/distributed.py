"""Sweeps of whole cases on many machines: Dask, ``concurrent.futures``, joblib."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from concurrent import futures
from contextlib import ExitStack
from typing import TYPE_CHECKING, Any

from judder import _arguments, _judder, _places
from judder._cluster.dispatch import Dispatch
from judder._cluster.executors import DaskExecutor, Executor, FuturesExecutor
from judder._cluster.package import Package
from judder.contact import Law
from judder.errors import InputError
from judder.progress import Progress
from judder.study import CaseLike, Study
from judder.study import run as run_here
from judder.sweep import chosen, plans

if TYPE_CHECKING:
    import distributed

__all__ = ["run", "run_with"]

_MOST_THREADS = 4096


def run(
    case: CaseLike,
    client: distributed.Client,
    *,
    output: str | os.PathLike[str],
    name: str | None = None,
    set: Mapping[str, Any] | None = None,
    law: Law | None = None,
    retries: int = 2,
    workers_share_folder: bool | None = None,
    chunks_per_task: int | None = None,
    progress: Progress | None = None,
) -> Study:
    """Computes the sweeps of a case on the workers of Dask, then completes the study here.

    The study is the same, to the last bit, as that of ``judder run`` on one machine. Chunks that are in the folder already are not computed
    again, so that the same call goes on after Ctrl-C, a lost client or a lost cluster. The case and the files that it names travel once
    to each worker.

    Args:
        case: a path, the text of a case, or its tables as a mapping.
        client: a client of ``dask.distributed``. A worker with several threads does several tasks at once.
        output: the study folder, on this machine.
        name: only this sweep. Without a name all sweeps, then, here, the analyses of the case, as ``judder run`` does.
        set: changed keys, such as ``{"operation.velocity": "30 mm/s"}``.
        law: a contact law of your own in place of that of an oscillator case; it travels with the case, and is kept in the folder as ``law.json``.
        retries: how often a chunk, and at last a point of it, may lose its process again before the point is recorded as failed and the study goes
            on. Dask itself tries again first, as often as ``distributed.scheduler.allowed-failures`` says.
        workers_share_folder: whether the workers write into ``output`` themselves. Where not said each looks whether it sees the folder,
            and sends its chunks to the client where it does not.
        chunks_per_task: how many chunks a task has; where not said as many as take about a second.
        progress: ``progress(name, done, total)``, in chunks.

    Returns:
        The study.

    Raises:
        CaseError: the case is wrong.
        InputError: the case has no such sweep; an argument cannot be.
        StoreError: the folder cannot be written, or holds another case.
        StudyError: the workers have another version of judder; the scheduler is gone.
        Interrupted: Ctrl-C; what is done is kept.

    >>> from distributed import Client  # doctest: +SKIP
    >>> study = judder.distributed.run("case.toml", Client("tcp://scheduler:8786"), output="out/case")  # doctest: +SKIP
    """

    if not all(hasattr(client, what) for what in ("submit", "scheduler", "nthreads")):
        raise _wrong("client", f"a client of dask.distributed is needed, not {client!r}")

    def executor(package: Package, sweep: str) -> Executor:
        return DaskExecutor(client, package, sweep)

    return _run((case, set, law), executor, output, name, (retries, workers_share_folder, chunks_per_task, None), progress)


def run_with(
    case: CaseLike,
    executor: futures.Executor | Callable[[], futures.Executor],
    *,
    output: str | os.PathLike[str],
    name: str | None = None,
    set: Mapping[str, Any] | None = None,
    law: Law | None = None,
    workers: int | None = None,
    threads_per_worker: int = 1,
    retries: int = 2,
    workers_share_folder: bool | None = None,
    chunks_per_task: int | None = None,
    progress: Progress | None = None,
) -> Study:
    """The same with any executor that has ``submit`` as those of ``concurrent.futures``: ``ProcessPoolExecutor``, the loky executor of joblib,
    ``MPIPoolExecutor`` of mpi4py.

    Args:
        executor: an executor, which stays open; or a function or class that makes one, which is made anew where a process of it is lost, and closed at the
            end.
        workers: how many tasks it does at a time; where not said, what it says itself.
        threads_per_worker: threads that each of its processes may use.

    The other arguments, the return value and the errors are those of :func:`run`; besides:

    Raises:
        StudyError: a process is lost, and ``executor`` is no function that makes another.

    >>> from concurrent.futures import ProcessPoolExecutor
    >>> study = judder.distributed.run_with("case.toml", lambda: ProcessPoolExecutor(8), output="out/case")  # doctest: +SKIP
    >>> from joblib.externals.loky import get_reusable_executor  # doctest: +SKIP
    >>> study = judder.distributed.run_with("case.toml", lambda: get_reusable_executor(8), output="out/case")  # doctest: +SKIP
    """
    _check("threads_per_worker", threads_per_worker, 1, _MOST_THREADS)
    _check("workers", workers, 1)
    if not callable(executor) and not hasattr(executor, "submit"):
        raise _wrong("executor", f"an executor with `submit` is needed, or a function that makes one, not {executor!r}")

    def of_futures(package: Package, sweep: str) -> Executor:
        return FuturesExecutor(executor, package, workers)

    manner = (retries, workers_share_folder, chunks_per_task, threads_per_worker)
    return _run((case, set, law), of_futures, output, name, manner, progress)


def _run(
    asked: tuple[CaseLike, Mapping[str, Any] | None, Law | None],
    executor: Callable[[Package, str], Executor],
    output: str | os.PathLike[str],
    name: str | None,
    manner: tuple[int, bool | None, int | None, int | None],
    progress: Progress | None,
) -> Study:
    retries, shares, chunks_per_task, threads = manner
    output = _places.writable(output)
    _check("retries", retries, 0)
    _check("chunks_per_task", chunks_per_task, 1)
    if progress is not None and not callable(progress):
        raise _wrong("progress", f"a function is needed, not {progress!r}")
    case, set, law = asked
    sweeps = plans(case, set, law)
    # until all chunks are there nobody takes the folder alone and forgets what is in it
    with ExitStack() as holding:
        for sweep in sweeps if name is None else [chosen(sweeps, name)]:
            compiled: _judder.Sweep = sweep._compiled
            package = Package.of(compiled.package)
            dispatch = Dispatch(
                compiled,
                lambda package=package, name=sweep.name: executor(package, name),  # type: ignore[misc]
                output,
                retries=retries,
                shares=shares,
                chunks_per_task=chunks_per_task,
                threads=threads,
                progress=progress,
            )
            held = compiled.hold(os.fspath(output))
            holding.callback(held.release)
            dispatch.run(held)
    return run_here(case, output=output, only=() if name is None else (name,), set=set, law=law, progress=progress)


def _check(argument: str, number: int | None, least: int, most: int | None = None) -> None:
    """Refuses what is no whole number from `least` to `most`."""
    if number is None:
        return
    if isinstance(number, bool) or not hasattr(number, "__index__"):
        raise _wrong(argument, f"a whole number is needed, not {number!r}")
    if number < least or most is not None and number > most:
        raise _wrong(argument, f"at least {least} is needed" + (f", and at most {most}" if most is not None else ""))


def _wrong(argument: str, why: str) -> InputError:
    return InputError(f"{argument}: {why}", "Input", {"argument": argument})


_arguments.checked(globals())
