"""What a worker does with chunks."""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from dataclasses import dataclass

from judder._cluster import alone
from judder._cluster.package import Package, kept
from judder.errors import Interrupted


@dataclass(frozen=True)
class Job:
    """Chunks of a sweep, and what is to become of them."""

    sweep: str
    hash: str
    chunks: tuple[int, ...]
    folder: str | None
    """Where they go; ``None`` where they are to come back."""
    mark: str | None
    """A file that whoever shares the folder sees in it; who does not see it sends the chunks back."""
    threads: int | None
    """Threads of the worker."""
    deaths: int | None = None
    """``None`` for the process of the worker, else a process of their own, in which a point may die so often before it counts as failed."""
    points: tuple[int, int] | None = None
    """Only these points of the only chunk, from the first to before the second; their columns come back."""


@dataclass(frozen=True)
class Done:
    """What became of chunks."""

    done: tuple[int, ...] = ()
    """Those that are in the folder."""
    busy: tuple[int, ...] = ()
    """Those that another process is computing."""
    contents: tuple[tuple[int, bytes], ...] = ()
    """Those that come back."""
    rows: tuple[tuple[list[float], str | None], ...] = ()
    """The columns of points, and why something of them is missing."""
    seconds: float = 0.0
    """How long they took, without what all points share."""
    killed: tuple[str, ...] = ()
    """Which points ended their process, and how."""
    is_stopped: bool = False
    """Whether the client wanted no more."""
    needs_package: bool = False
    """Whether the worker does not know the case yet."""


def work(package: Package | str, job: Job) -> Done:
    """Does a job; runs in the process of a worker.

    Raises:
        JudderError: what no repetition changes: a wrong case, a full disk.
    """
    known = kept(package)
    if known is None:
        return Done(needs_package=True)
    threads = job.threads or _threads()
    sweep = known.sweep(job.sweep, job.hash, threads)
    stop = _stop()
    folder = job.folder if job.folder and (job.mark is None or os.path.exists(job.mark)) else None
    try:
        if job.deaths is not None and job.points is not None:
            rows, ended = alone.points(known, sweep, job.chunks[0], job.points, job.deaths, stop)
            return Done(rows=tuple(rows), killed=tuple(ended))
        if job.deaths is not None:
            contents, killed = alone.computed(known, sweep, job.chunks, job.deaths, stop)
            if folder is None:
                return Done(contents=contents, killed=killed)
            held = sweep.hold(folder)
            held.write(contents)
            held.release()
            return Done(done=job.chunks, killed=killed)
        sweep.prepare(stop=stop)
        began = time.perf_counter()
        if folder is None:
            made = sweep.compute(list(job.chunks), stop=stop)
            return Done(contents=tuple(zip(job.chunks, made, strict=True)), seconds=time.perf_counter() - began)
        done, busy = sweep.compute_into(folder, list(job.chunks), stop=stop)
        return Done(done=tuple(done), busy=tuple(busy), seconds=time.perf_counter() - began)
    except Interrupted:
        # an executor would take it for its own end
        return Done(is_stopped=True)


def _threads() -> int:
    """How many threads this worker may have."""
    worker = _dask_worker()
    return 1 if worker is None else int(worker.state.nthreads)


def _stop() -> Callable[[], bool] | None:
    """Asks whether this task is still wanted, where that can be known."""
    worker = _dask_worker()
    if worker is None:
        return None
    key = worker.get_current_task()

    def stop() -> bool:
        task = worker.state.tasks.get(key)
        return task is None or task.state == "cancelled"

    return stop


def _dask_worker():  # type: ignore[no-untyped-def]
    """The worker of Dask in which this runs, if it is one."""
    import sys

    if "distributed.worker" not in sys.modules:
        return None
    try:
        return sys.modules["distributed.worker"].get_worker()
    except ValueError:
        return None
