"""Chunks that end their process, computed in one of their own, at last point by point."""

from __future__ import annotations

import os
import pickle
import queue
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from typing import IO, TYPE_CHECKING, Any, TypeAlias

from judder.errors import Interrupted, StudyError

if TYPE_CHECKING:
    from judder import _judder
    from judder._cluster.package import Package

KILLED = "it ended the process that computed it, every time"
"""The reason of a point that has no answer because of that: the same words wherever it happens."""
READY = "ready"
"""What a child says before its first point."""
_LOOK = 0.1
"""Seconds between two looks whether the chunks are still wanted."""

_Stop: TypeAlias = Callable[[], bool]
Row: TypeAlias = "tuple[list[float], str | None]"
"""The columns of a point, and why something of it is missing."""
Order: TypeAlias = "tuple[Package, str, str, int | None, tuple[int, ...], tuple[int, int] | None]"
"""Package, sweep, hash, threads, chunks; from where to where the points of the only chunk are wanted one by one."""


def computed(
    package: Package, sweep: _judder.Sweep, chunks: tuple[int, ...], deaths: int, stop: _Stop | None
) -> tuple[tuple[tuple[int, bytes], ...], tuple[str, ...]]:
    """The contents of chunks, and what is to be said of points that ended their process."""
    contents: list[tuple[int, bytes]] = []
    killed: list[str] = []
    while len(contents) < len(chunks):
        left = chunks[len(contents) :]
        with _Child((package, sweep.name, sweep.hash, 1, left, None), stop) as child:
            contents.extend(zip(left, child.messages(), strict=False))
        if len(contents) < len(chunks):
            chunk = chunks[len(contents)]
            content, told = _by_points(package, sweep, chunk, deaths, stop)
            contents.append((chunk, content))
            killed.extend(told)
    return tuple(contents), tuple(killed)


def _by_points(package: Package, sweep: _judder.Sweep, chunk: int, deaths: int, stop: _Stop | None) -> tuple[bytes, list[str]]:
    """The content of a chunk from its points one by one."""
    rows, killed = points(package, sweep, chunk, (0, sweep.count(chunk)), deaths, stop)
    return assembled(sweep, chunk, rows), killed


def points(
    package: Package, sweep: _judder.Sweep, chunk: int, span: tuple[int, int], deaths: int, stop: _Stop | None
) -> tuple[list[Row], list[str]]:
    """The columns of these points of a chunk; a point that ends its process so often has failed."""
    rows: list[Row] = []
    killed: list[str] = []
    died = 0
    while len(rows) < span[1] - span[0]:
        before, first = len(rows), span[0] + len(rows)
        with _Child((package, sweep.name, sweep.hash, 1, (chunk,), (first, span[1])), stop) as child:
            rows.extend(child.messages())
        died = died + 1 if len(rows) == before else 1
        index = span[0] + len(rows)
        if index < span[1] and died >= deaths:
            killed.append(f"{sweep.name}: point {index} of chunk {chunk} ended its process {died} times: {child.end}")
            rows.append(without_values(sweep, chunk, index))
            died = 0
    return rows, killed


def without_values(sweep: _judder.Sweep, chunk: int, index: int) -> Row:
    """The columns of a point that ends its process."""
    return sweep.point_without_values(chunk, index).tolist(), KILLED


def assembled(sweep: _judder.Sweep, chunk: int, rows: list[Row]) -> bytes:
    """The content of a chunk from the columns of all its points."""
    values = [value for row, _ in rows for value in row]
    return sweep.encoded(chunk, values, [(index, reason) for index, (_, reason) in enumerate(rows) if reason is not None])


class _Child:
    """A process that computes what it is ordered, and may die of it."""

    def __init__(self, order: Order, stop: _Stop | None) -> None:
        # it finds what this process finds
        paths = [os.environ.get("PYTHONPATH", ""), *sys.path]
        surroundings = {**os.environ, "PYTHONPATH": os.pathsep.join(path for path in paths if path)}
        words = [sys.executable, "-m", "judder._cluster.child"]
        self._process = subprocess.Popen(words, stdin=subprocess.PIPE, stdout=subprocess.PIPE, env=surroundings)
        self._stop, self._name = stop, order[1]
        self._said: queue.SimpleQueue[Any] = queue.SimpleQueue()
        try:
            pickle.dump(order, self._pipe(self._process.stdin))
            self._pipe(self._process.stdin).close()
        except BrokenPipeError:
            # it has died already: what it said tells
            pass
        self._listener = threading.Thread(target=self._listen, daemon=True)
        self._listener.start()

    @staticmethod
    def _pipe(pipe: IO[bytes] | None) -> IO[bytes]:
        assert pipe is not None
        return pipe

    def _listen(self) -> None:
        """Takes over what the child says, until it ends."""
        try:
            while True:
                self._said.put(pickle.load(self._pipe(self._process.stdout)))
        except (EOFError, pickle.UnpicklingError):
            # it has ended, perhaps amid a word
            self._said.put(None)
        except Exception as error:
            self._said.put(error)

    def _next(self) -> Any:
        while True:
            try:
                return self._said.get(timeout=_LOOK)
            except queue.Empty:
                if self._stop is not None and self._stop():
                    raise Interrupted("no longer wanted") from None

    def messages(self) -> Iterator[Any]:
        """What it has computed, one after the other, until its end or its death.

        Raises:
            JudderError: what ended it in order.
            StudyError: it has died before its first point, so that no point is to blame.
        """
        said = self._next()
        if said is None:
            self._process.wait()
            message = f"{self._name}: a process has ended before its first point: {self.end}; too little memory for the case?"
            raise StudyError(message, "WorkerLost", {})
        while said is not None:
            if isinstance(said, BaseException):
                raise said
            if said != READY:
                yield said
            said = self._next()
        self._process.wait()

    @property
    def end(self) -> str:
        """How it ended."""
        code = self._process.returncode
        if code is not None and code < 0:
            return f"killed by signal {-code}"
        return f"exit code {code}"

    def __enter__(self) -> _Child:
        return self

    def __exit__(self, *_: object) -> None:
        self._process.kill()
        self._process.wait()
        self._listener.join()
        self._pipe(self._process.stdout).close()
