"""Hands chunks out, takes results in, does lost ones again."""

from __future__ import annotations

import os
import secrets
import time
import warnings
from collections import Counter, deque
from pathlib import Path
from typing import TYPE_CHECKING

from judder._cluster.executors import Executor, Lost, Outcome
from judder._cluster.pace import Pace
from judder._cluster.work import Done, Job
from judder.errors import Interrupted, JudderError, JudderWarning

if TYPE_CHECKING:
    from collections.abc import Callable

    from judder import _judder
    from judder.progress import Progress

_QUEUED = 2
"""Tasks that are handed out for each thread: one that runs, one that is ready."""
_PAUSE = 0.5
"""Seconds before a chunk that another process computes is looked at again."""


class Dispatch:
    """One sweep on its way through an executor.

    A task whose process ends under it is done again, chunk by chunk. A chunk that has lost ``retries`` processes more than one goes to a process
    of its own on a worker, where it is done point by point if it ends that, too: so no chunk is blamed for what its neighbour did.
    """

    def __init__(
        self,
        sweep: _judder.Sweep,
        executor: Callable[[], Executor],
        folder: str | os.PathLike[str],
        *,
        retries: int,
        shares: bool | None,
        chunks_per_task: int | None,
        threads: int | None,
        progress: Progress | None,
    ) -> None:
        self._sweep = sweep
        self._make = executor
        self._folder = os.path.abspath(folder)
        self._retries = retries
        self._shares = shares
        self._threads = threads
        self._tell = progress
        self._pace = Pace(chunks_per_task)
        self._left: deque[int] = deque()
        self._again: deque[int] = deque()
        self._alone: deque[int] = deque()
        self._later: deque[tuple[float, int]] = deque()
        self._deaths: Counter[int] = Counter()
        self._failures: Counter[int] = Counter()
        self._flying = 0
        self._total = 0

    def run(self) -> None:
        """Computes the chunks that the folder lacks.

        Raises:
            JudderError: what no repetition changes.
            Interrupted: Ctrl-C; what is done is kept.
        """
        self._left.extend(self._sweep.missing(self._folder).tolist())
        self._total = len(self._left)
        if not self._left:
            return
        # begins the sweep in the folder, so that it is refused here where it cannot be
        self._sweep.write(self._folder, [])
        mark = Path(self._folder, f".sweep-{self._sweep.name}", f"mark-{secrets.token_hex(8)}")
        mark.parent.mkdir(exist_ok=True)
        mark.touch()
        executor = self._make()
        try:
            self._drive(executor, str(mark))
        except KeyboardInterrupt:
            raise Interrupted("interrupted; what was done is kept, and the same call goes on from there") from None
        finally:
            executor.close()
            mark.unlink(missing_ok=True)

    def _drive(self, executor: Executor, mark: str) -> None:
        done = 0
        self._progress(done)
        while done < self._total:
            while self._flying < _QUEUED * executor.slots() and (job := self._next(executor.slots(), mark)):
                executor.submit(job)
                self._flying += 1
            if self._flying == 0:
                time.sleep(_PAUSE)
                continue
            for job, outcome in executor.wait():
                self._flying -= 1
                done += self._take(job, outcome)
            self._progress(done)

    def _progress(self, done: int) -> None:
        if self._tell is not None:
            self._tell(self._sweep.name, done, self._total)

    def _next(self, slots: int, mark: str) -> Job | None:
        """The next job, where there is one now."""
        while self._later and self._later[0][0] <= time.monotonic():
            self._again.append(self._later.popleft()[1])
        if self._left:
            count = self._pace.chunks(len(self._left), slots)
            return self._job([self._left.popleft() for _ in range(min(count, len(self._left)))], mark)
        if self._again:
            return self._job([self._again.popleft()], mark)
        if self._alone:
            return self._job([self._alone.popleft()], mark, self._retries + 1)
        return None

    def _job(self, chunks: list[int], mark: str, deaths: int | None = None) -> Job:
        folder = None if self._shares is False else self._folder
        sweep = self._sweep
        return Job(sweep.name, sweep.hash, tuple(chunks), folder, None if self._shares else mark, self._threads, deaths)

    def _take(self, job: Job, outcome: Outcome) -> int:
        """Takes in what came of a job; how many chunks are done by it."""
        match outcome:
            case Done():
                return self._take_done(job, outcome)
            case Lost():
                for chunk in job.chunks:
                    self._deaths[chunk] += outcome.deaths
                    is_suspect = self._deaths[chunk] > self._retries
                    (self._alone if is_suspect else self._again).append(chunk)
                return 0
            case JudderError() | KeyboardInterrupt():
                raise outcome
        # a file system or a network that may be better next time
        for chunk in job.chunks:
            self._failures[chunk] += 1
            if self._failures[chunk] > self._retries:
                raise outcome
            self._again.append(chunk)
        return 0

    def _take_done(self, job: Job, done: Done) -> int:
        if done.is_stopped:
            self._again.extend(job.chunks)
            return 0
        if done.contents:
            self._sweep.write(self._folder, list(done.contents))
        sent = sum(len(content) for _, content in done.contents)
        if job.deaths is None and not done.busy:
            self._pace.learn(len(job.chunks), done.seconds, sent)
        again = time.monotonic() + _PAUSE
        self._later.extend((again, chunk) for chunk in done.busy)
        for told in done.killed:
            warnings.warn(told, JudderWarning, stacklevel=2)
        return len(done.done) + len(done.contents)
