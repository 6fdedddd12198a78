"""Dask and ``concurrent.futures`` behind one door: submit, wait."""

from __future__ import annotations

import asyncio
import itertools
import os
import queue
import secrets
import time
import warnings
from collections.abc import Callable
from concurrent import futures
from typing import TYPE_CHECKING, Any, Protocol, TypeAlias, cast

from judder._cluster.package import Package
from judder._cluster.work import Done, Job, work
from judder.errors import InputError, StudyError

if TYPE_CHECKING:
    import distributed

_SMALL = 1 << 16
"""Bytes of a package that may travel with every task."""
_LOOK = 1.0
"""Seconds after which a wait looks up, so that Ctrl-C is heard everywhere."""
_GONE = ("cancelled", "error", "lost")
"""States of a future of Dask that is never done any more."""
_COUNTED = 5.0
"""Seconds for which the number of threads of a cluster is taken as known."""


class Lost(Exception):
    """A task whose process has ended under it, so often."""

    def __init__(self, deaths: int) -> None:
        super().__init__(f"{deaths} processes have ended under it")
        self.deaths = deaths


class Cancelled(Exception):
    """A task that somebody took back: its process is not to blame."""


Outcome: TypeAlias = "Done | BaseException"


class Executor(Protocol):
    """Where jobs are done."""

    def slots(self) -> int:
        """How many jobs are done at a time."""
        ...

    def submit(self, job: Job) -> None:
        """Hands a job out."""
        ...

    def wait(self) -> list[tuple[Job, Outcome]]:
        """Waits a while until jobs have ended; what came of each: :class:`Lost` where its process has ended under it, :class:`Cancelled` where
        somebody took it back."""
        ...

    def close(self) -> None:
        """Wants no more of what is handed out."""
        ...


class DaskExecutor:
    """The workers of a client of Dask."""

    def __init__(self, client: distributed.Client, package: Package, sweep: str) -> None:
        self._client = client
        self._content = package
        self._name = _prefix(sweep)
        self._token = secrets.token_hex(4)
        self._numbers = itertools.count()
        self._counted = (-_COUNTED, 1)
        self._package = self._sent(f"judder-package-{package.digest}")
        self._jobs: dict[distributed.Future, Job] = {}
        # no results: they stay on the workers until they are taken in, so that the client holds few
        self._ended: queue.SimpleQueue[distributed.Future] = queue.SimpleQueue()

    def slots(self) -> int:
        when, count = self._counted
        if time.monotonic() - when > _COUNTED:
            count = max(1, sum(self._client.nthreads().values()))
            self._counted = (time.monotonic(), count)
        return count

    def _sent(self, key: str) -> distributed.Future:
        with warnings.catch_warnings():
            # it is one, and goes once to the scheduler and once to each worker
            warnings.filterwarnings("ignore", message="Sending large graph")
            # a task, not scattered data: where all workers that hold it are lost, it is made again
            return self._client.submit(_same, self._content, key=key, pure=True)

    def submit(self, job: Job) -> None:
        if self._package.status in _GONE:
            # a key of its own: the scheduler may not have forgotten the other yet
            self._package = self._sent(f"judder-package-{self._content.digest}-{secrets.token_hex(4)}")
        key = f"{self._name}-{self._token}-{next(self._numbers)}"
        future = self._client.submit(work, self._package, job, key=key, pure=False)
        self._jobs[future] = job
        future.add_done_callback(lambda ended: self._ended.put(ended))

    def wait(self) -> list[tuple[Job, Outcome]]:
        try:
            future = self._ended.get(timeout=_LOOK)
        except queue.Empty:
            if self._client.status != "running":
                raise self._gone() from None
            return []
        return [(self._jobs.pop(future), self._outcome(future))]

    def _outcome(self, future: distributed.Future) -> Outcome:
        import distributed

        try:
            return future.result()  # type: ignore[no-any-return]
        except distributed.KilledWorker as error:
            return Lost(error.allowed_failures + 1) if error.task == future.key else Cancelled()
        except (futures.CancelledError, asyncio.CancelledError) as error:
            outcome: BaseException = error
        except Exception as error:
            outcome = error
        if self._client.status != "running":
            return self._gone()
        return Cancelled() if future.status in ("cancelled", "lost") else outcome

    @staticmethod
    def _gone() -> StudyError:
        return StudyError("the scheduler of Dask is gone; what is done is kept, and the same call goes on from there", "NoScheduler", {})

    def close(self) -> None:
        if self._client.status == "running":
            self._client.cancel([*self._jobs])
        self._jobs.clear()


def _same(package: Package) -> Package:
    return package


def _prefix(sweep: str) -> str:
    """How the tasks of a sweep are called, so that the dashboard shows them under one name: it stops at a part with other characters."""
    from dask.utils import key_split

    name = f"judder-{sweep}"
    return name if key_split(f"{name}-0") == name else name.replace("-", "_")


FuturesLike: TypeAlias = "futures.Executor | Callable[[], futures.Executor]"


class FuturesExecutor:
    """An executor of ``concurrent.futures`` or of its kind, or a function that makes one, anew where its processes are lost."""

    def __init__(self, executor: FuturesLike, package: Package, slots: int | None) -> None:
        # a class has the `submit` of what it makes
        is_maker = callable(executor) and (isinstance(executor, type) or not hasattr(executor, "submit"))
        self._make = cast("Callable[[], futures.Executor]", executor) if is_maker else None
        self._executor: Any = self._made() if self._make is not None else executor
        self._package = package
        self._slots = slots
        self._ended: queue.SimpleQueue[futures.Future[Done]] = queue.SimpleQueue()
        self._jobs: dict[futures.Future[Done], tuple[Job, Any]] = {}
        self._is_broken = False

    def slots(self) -> int:
        own = getattr(self._executor, "_max_workers", None)
        return max(1, self._slots or own or os.cpu_count() or 1)

    def submit(self, job: Job) -> None:
        self._hand_out(job, self._package if self._package.size <= _SMALL else self._package.digest)

    def _hand_out(self, job: Job, package: Package | str) -> None:
        if self._is_broken:
            self._renew()
        try:
            future = self._executor.submit(work, package, job)
        except RuntimeError:
            # it is broken, and nobody has told of it yet; or somebody has shut it down
            self._renew()
            future = self._executor.submit(work, package, job)
        self._jobs[future] = job, self._executor
        future.add_done_callback(lambda ended: self._ended.put(ended))

    def _made(self) -> Any:
        made = self._make() if self._make is not None else None
        if not hasattr(made, "submit"):
            raise InputError(f"executor: {self._make!r} made {made!r}, which has no `submit`", "Input", {"argument": "executor"})
        return made

    def _renew(self) -> None:
        if self._make is None:
            message = (
                "a process of the executor has ended, and with it the executor, or it was shut down; what is done is kept. "
                "Give a function that makes the executor, and it is made anew: `lambda: ProcessPoolExecutor(8)`"
            )
            raise StudyError(message, "ExecutorLost", {})
        self._executor.shutdown(wait=False)
        self._executor = self._made()
        self._is_broken = False

    def wait(self) -> list[tuple[Job, Outcome]]:
        try:
            future = self._ended.get(timeout=_LOOK)
        except queue.Empty:
            return []
        job, executor = self._jobs.pop(future)
        outcome = self._outcome(future)
        # others of one that was lost tell of it when it is replaced already
        self._is_broken |= isinstance(outcome, Lost) and executor is self._executor
        if isinstance(outcome, Done) and outcome.needs_package:
            self._hand_out(job, self._package)
            return []
        return [(job, outcome)]

    def _outcome(self, future: futures.Future[Done]) -> Outcome:
        if future.cancelled():
            return Cancelled()
        error = future.exception()
        if isinstance(error, futures.BrokenExecutor):
            return Lost(1)
        return future.result() if error is None else error

    def close(self) -> None:
        for future in self._jobs:
            future.cancel()
        self._jobs.clear()
        if self._make is not None:
            self._executor.shutdown(wait=False)
