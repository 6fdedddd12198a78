"""Hands chunks out, takes results in, does lost ones again."""

from __future__ import annotations

import heapq
import os
import secrets
import time
from collections import Counter, deque
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from judder import _warned
from judder._cluster.cut import Cut
from judder._cluster.executors import Cancelled, Executor, Lost, Outcome
from judder._cluster.pace import Pace
from judder._cluster.work import Done, Job
from judder.errors import Interrupted, JudderError, StudyError

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from judder import _judder
    from judder.progress import Progress

_QUEUED = 2
"""Tasks that are handed out for each thread: one that runs, one that is ready."""
_PAUSE = 0.5
"""Seconds before a chunk that another process computes, or that failed for a reason that may pass, is looked at again; twice as many each time it fails."""
_PASSING = ("FileSystem", "Locked", "WorkerLost")
"""Causes of errors that may be gone next time, or on another worker."""
_CANCELS = 10
"""How often in a row a chunk may be cancelled while nothing at all is done."""
_HOPE = 8
"""Tasks that may be lost, beside those that one bad point takes with it, before the workers are to blame where none has done anything."""


class Dispatch:
    """One sweep on its way through an executor.

    A task whose process ends under it is done again, chunk by chunk. A chunk that has lost ``retries`` processes more than one goes to a process
    of its own on a worker, where it is done point by point if it ends that, too: so no chunk is blamed for what its neighbour did. Where
    that takes the worker with it, the chunk is cut until the point is found. A task that somebody cancels, as a restart of the workers does,
    is done again and blames nobody.
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
        self._later: list[tuple[float, int]] = []
        self._alone: set[int] = set()
        self._cuts: dict[int, Cut] = {}
        self._deaths: Counter[int] = Counter()
        self._failures: Counter[int] = Counter()
        self._cancels: Counter[int] = Counter()
        self._flying = 0
        self._total = 0
        self._slots = 1
        self._losses = 0
        self._has_lived = False
        self._is_cutting = False
        self._mark = ""

    def run(self, held: _judder.HeldSweep) -> None:
        """Computes the chunks that the folder lacks, which is held meanwhile.

        Raises:
            JudderError: what no repetition changes.
            Interrupted: Ctrl-C; what is done is kept.
        """
        self._left.extend(self._sweep.missing(self._folder).tolist())
        self._total = len(self._left)
        if not self._left:
            return
        try:
            with self._marked():
                executor = self._make()
                try:
                    self._drive(executor, held)
                finally:
                    executor.close()
        except KeyboardInterrupt:
            raise Interrupted("interrupted; what was done is kept, and the same call goes on from there") from None

    @contextmanager
    def _marked(self) -> Iterator[None]:
        """Puts a file into the folder by which workers know whether they share it."""
        mark = Path(self._folder, f".sweep-{self._sweep.name}", f"mark-{secrets.token_hex(8)}")
        mark.touch()
        self._mark = str(mark)
        try:
            yield
        finally:
            mark.unlink(missing_ok=True)

    def _drive(self, executor: Executor, held: _judder.HeldSweep) -> None:
        done = 0
        self._progress(done)
        while done < self._total:
            self._slots = executor.slots()
            while self._flying < _QUEUED * self._slots and (job := self._next()):
                executor.submit(job)
                self._flying += 1
                self._is_cutting = job.points is not None
            if self._flying == 0:
                time.sleep(_PAUSE)
                continue
            before = done
            for job, outcome in executor.wait():
                self._flying -= 1
                done += self._take(job, outcome, held)
            if done > before:
                self._progress(done)

    def _progress(self, done: int) -> None:
        if self._tell is not None:
            self._tell(self._sweep.name, done, self._total)

    def _next(self) -> Job | None:
        """The next job, where there is one now."""
        # a span that is cut flies alone: it may take others with it, which would be blamed for that
        if self._is_cutting and self._flying:
            return None
        while self._later and self._later[0][0] <= time.monotonic():
            self._again.append(heapq.heappop(self._later)[1])
        if self._left:
            count = self._pace.chunks(len(self._left), self._slots)
            return self._job([self._left.popleft() for _ in range(min(count, len(self._left)))])
        if self._again:
            chunk = self._again.popleft()
            return self._job([chunk], self._retries + 1 if chunk in self._alone else None)
        if self._flying == 0:
            for cut in self._cuts.values():
                if span := cut.next():
                    return self._job([cut.chunk], self._retries + 1, span)
        return None

    def _job(self, chunks: list[int], deaths: int | None = None, points: tuple[int, int] | None = None) -> Job:
        folder = None if self._shares is False else self._folder
        mark = None if self._shares else self._mark
        return Job(self._sweep.name, self._sweep.hash, tuple(chunks), folder, mark, self._threads, deaths, points)

    def _take(self, job: Job, outcome: Outcome, held: _judder.HeldSweep) -> int:
        """Takes in what came of a job; how many chunks are done by it."""
        if isinstance(outcome, Lost):
            self._lost(job, outcome.deaths)
            return self._cut_done(job.chunks[0], held)
        if isinstance(outcome, Cancelled):
            self._cancelled(job)
            return 0
        if isinstance(outcome, Done):
            self._has_lived = True
            if not outcome.is_stopped:
                self._cancels.clear()
            return self._taken(job, outcome, held)
        # what is wrong stays wrong; a file system or a network may be better next time
        stays = isinstance(outcome, JudderError) and outcome.cause not in _PASSING
        self._failures.update(job.chunks)
        if stays or not isinstance(outcome, Exception) or any(self._failures[chunk] > self._retries for chunk in job.chunks):
            raise outcome
        self._put_off(job)
        return 0

    def _put_off(self, job: Job) -> None:
        """Does a job again, a while later."""
        if job.points is not None:
            self._cuts[job.chunks[0]].again(job.points)
            return
        for chunk in job.chunks:
            self._postpone(chunk, _PAUSE * 2 ** self._failures[chunk])

    def _cancelled(self, job: Job) -> None:
        """Does a job again that somebody took back, a while later.

        Raises:
            StudyError: it is taken back again and again, and nothing is done meanwhile.
        """
        self._cancels.update(job.chunks)
        if max(self._cancels[chunk] for chunk in job.chunks) >= _CANCELS:
            message = (
                f"{self._sweep.name}: somebody cancels its tasks or restarts the workers: {_CANCELS} times in a row, and nothing was done between; "
                "what is done is kept, and the same call goes on from there"
            )
            raise StudyError(message, "Cancelled", {"name": self._sweep.name})
        if job.points is not None:
            # it flies alone, so that nothing else waits for this
            time.sleep(_PAUSE)
            self._cuts[job.chunks[0]].again(job.points)
        for chunk in job.chunks if job.points is None else ():
            self._postpone(chunk, _PAUSE)

    def _postpone(self, chunk: int, seconds: float) -> None:
        heapq.heappush(self._later, (time.monotonic() + seconds, chunk))

    def _lost(self, job: Job, deaths: int) -> None:
        """Does the chunks of a job again whose process has ended under it, or looks for the point that ends it."""
        self._losses += 1
        if not self._has_lived and self._losses > 4 * (self._retries + 1 + self._slots) + _HOPE:
            raise self._no_workers()
        if job.points is not None:
            self._blame(self._cuts[job.chunks[0]].lost(job.points))
            return
        for chunk in job.chunks:
            self._deaths[chunk] += deaths
            if self._deaths[chunk] > self._retries and chunk in self._alone:
                self._cuts[chunk] = Cut(self._sweep, chunk, self._retries)
                continue
            if self._deaths[chunk] > self._retries:
                # to be lost as often again, for its own fault or for that of another
                self._alone.add(chunk)
                self._deaths[chunk] = 0
            self._again.append(chunk)

    def _blame(self, told: str | None) -> None:
        """Says which point ends workers, if one does.

        Raises:
            StudyError: no worker has ended a task yet, so that no point is to blame.
        """
        if told is None:
            return
        if not self._has_lived:
            raise self._no_workers()
        _warned.warn(told)

    def _no_workers(self) -> StudyError:
        message = (
            f"{self._sweep.name}: every process that was given a task has ended under it, and none has done one: do workers start, is judder there, "
            "do they have the memory? A script that starts processes needs `if __name__ == \"__main__\":`"
        )
        return StudyError(message, "NoWorkers", {"name": self._sweep.name})

    def _taken(self, job: Job, done: Done, held: _judder.HeldSweep) -> int:
        for told in done.killed:
            _warned.warn(told)
        if done.is_stopped:
            self._put_off(job)
            return 0
        if job.points is not None:
            self._cuts[job.chunks[0]].take(job.points, done.rows)
            return self._cut_done(job.chunks[0], held)
        if done.contents:
            held.write(done.contents)
        sent = sum(len(content) for _, content in done.contents)
        if job.deaths is None and not done.busy:
            self._pace.learn(len(job.chunks), done.seconds, sent)
        for chunk in done.busy:
            self._postpone(chunk, _PAUSE)
        return len(done.done) + len(done.contents)

    def _cut_done(self, chunk: int, held: _judder.HeldSweep) -> int:
        """Writes a chunk that was cut, once it has all points."""
        content = self._cuts[chunk].content() if chunk in self._cuts else None
        if content is None:
            return 0
        held.write([(chunk, content)])
        del self._cuts[chunk]
        return 1
