"""Sweeps of whole cases, chunk by chunk: for whoever hands the chunks out himself.

``judder.run`` does the sweeps of a case on one machine, :mod:`judder.distributed` on many. Both do no more than what is here: a sweep is cut
into chunks, by the case alone; what a chunk holds depends on the case alone; and a chunk in a study folder is there whole or not at all.
"""

from __future__ import annotations

import json
import os
import tempfile
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from judder import _arguments, _judder, _places, _shown, _warned
from judder._cluster.package import Package
from judder._objects import CaseSource
from judder.contact import Law
from judder.errors import InputError, StudyError
from judder.progress import Progress
from judder.study import CaseLike, Study

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = ["Sweep", "plan"]

_folders: list[tempfile.TemporaryDirectory[str]] = []
"""Where laws are that came from Python: points may read them until the end."""


def plan(case: CaseLike, name: str | None = None, *, set: Mapping[str, Any] | None = None, law: Law | None = None) -> Sweep:
    """The plan of a sweep of a case; nothing is computed and nothing written.

    Args:
        case: a path, the text of a case, or its tables as a mapping.
        name: which sweep; where there is one only, that.
        set: changed keys, such as ``{"operation.velocity": "30 mm/s"}``.
        law: a contact law of your own in place of that of an oscillator case.

    Raises:
        CaseError: the case is wrong.
        InputError: the case has no such sweep, or takes no law.

    >>> sweep = judder.sweep.plan({
    ...     "model": "oscillator",
    ...     "sweep": [{
    ...         "name": "speeds",
    ...         "over": [{"key": "operation.velocity", "from": 1e-5, "to": 1e-2, "points": 600, "scale": "log"}],
    ...         "quantities": ["growth_rate"],
    ...         "chunk": 100,
    ...     }],
    ... })
    >>> sweep
    Sweep('speeds': 600 points in 6 chunks)
    >>> sweep.keys, sweep.shape
    (('operation.velocity',), (600,))
    """
    return chosen(plans(case, set, law), name)


def plans(case: CaseLike, set: Mapping[str, Any] | None = None, law: Law | None = None) -> list[Sweep]:
    """The plans of all sweeps of a case, in their order."""
    kept = None if law is None else (law, _folder())
    source = CaseSource(case, set)
    with source.told():
        return [Sweep(compiled, source.keep) for compiled in _judder.Sweep.all(source.given, source.overrides, law=kept)]


def _folder() -> str:
    """A folder that is there as long as this process."""
    _folders.append(tempfile.TemporaryDirectory(prefix="judder-"))
    return _folders[-1].name


def chosen(sweeps: list[Sweep], name: str | None) -> Sweep:
    """The sweep of this name, or the only one."""
    found = [sweep for sweep in sweeps if name in (None, sweep.name)]
    if len(found) == 1:
        return found[0]
    names = ", ".join(f"`{sweep.name}`" for sweep in sweeps) or "none"
    wrong = "which of the sweeps?" if name is None else f"there is no sweep `{name}`;"
    raise InputError(f"name: {wrong} the case has {names}", "Input", {"argument": "name"})


class Sweep:
    """A sweep of a case: its points, cut into chunks.

    What a chunk holds is the same whoever computes it, to the last bit, so that any number of processes may do different chunks, or the
    same ones twice. It can be pickled, with its case and the files that it names.
    """

    def __init__(self, compiled: _judder.Sweep, keep: Callable[[str], None]) -> None:
        self._compiled = compiled
        # copies the objects of the case into a study folder, and holds their files, which points read
        self._keep = keep

    @property
    def name(self) -> str:
        """Its name."""
        return self._compiled.name

    @property
    def points(self) -> int:
        """How many points it has."""
        return self._compiled.points

    @property
    def chunks(self) -> int:
        """How many chunks they are cut into; chunks are numbered from 0."""
        return self._compiled.chunks

    @property
    def shape(self) -> tuple[int, ...]:
        """Points along each dimension: one dimension a key for a grid, else one of all samples."""
        return tuple(self._compiled.shape)

    @property
    def keys(self) -> tuple[str, ...]:
        """The dotted keys that are swept."""
        return tuple(self._compiled.keys)

    @property
    def quantities(self) -> tuple[str, ...]:
        """What is asked at every point."""
        return tuple(self._compiled.quantities)

    def estimate(self, folder: str | os.PathLike[str] | None = None) -> dict[str, Any]:
        """What is left of it would take, from a few of its points: the document of ``judder run --dry-run --json``.

        Args:
            folder: a study folder whose chunks count as done; where none is given, that of :func:`judder.run` with ``output=True``.

        Returns:
            ``points``, ``chunks``, ``chunks_done``, ``seconds_per_point`` (on one thread), ``threads``, ``seconds``, ``memory_bytes``,
            ``stored_bytes``.
        """
        document: dict[str, Any] = json.loads(self._compiled.estimate(None if folder is None else _places.writable(folder)))
        return document

    def missing(self, folder: str | os.PathLike[str]) -> NDArray[np.int64]:
        """The numbers of the chunks that a study folder lacks, ascending; those that cannot be read count.

        All that is there is read and compared with its checksums.

        Raises:
            StoreError: the folder holds this sweep of another case.
        """
        return self._compiled.missing(_places.writable(folder))

    def compute(self, chunk: int) -> bytes:
        """Computes the points of a chunk, on one thread, and returns the content of its file.

        Points that fail are in it with their reasons.

        Raises:
            StoreError: there is no such chunk.
            Interrupted: Ctrl-C.
        """
        return self._compiled.compute([chunk])[0]

    def values(self, chunk: int) -> NDArray[np.float64]:
        """Computes the points of a chunk, on one thread, as numbers: a row a point, row-major over the chunk, NaN where there is no answer.

        The columns are the quantities; unless the sweep is a grid the swept keys stand before them.
        """
        return self._compiled.values(chunk)

    def write(self, folder: str | os.PathLike[str], chunk: int, content: bytes) -> None:
        """Writes what :meth:`compute` returned, here or elsewhere, into a study folder, which is made where there is none.

        A chunk that is there stays. On the disk when this returns.

        Raises:
            StoreError: these bytes are not that chunk of this sweep; the folder cannot be written.
        """
        self._compiled.hold(_places.writable(folder)).write([(chunk, content)])

    def run(
        self,
        folder: str | os.PathLike[str],
        *,
        shard: str | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> None:
        """Computes the chunks that a study folder lacks, on this machine, together with other processes that work on the same folder.

        Args:
            folder: the study folder, which is made where there is none.
            shard: only a part of them: ``"3/16"`` is the third of sixteen.
            threads: threads to compute with; one a core where none is given.
            progress: ``progress(name, done, total)``, in chunks.

        Raises:
            StoreError: the folder cannot be written, or holds this sweep of another case.
            Interrupted: Ctrl-C; the same call goes on from there.
        """
        self._compiled.run(_places.writable(folder), shard=shard, threads=threads, progress=progress)
        self._keep(_places.writable(folder))

    def merge(self, folder: str | os.PathLike[str]) -> Study:
        """Completes a study folder in which all chunks are: summary, report, metadata.

        Raises:
            StudyError: chunks are missing; ``error.missing`` of them.
        """
        path = _places.writable(folder)
        notes, complete = self._compiled.merge(path)
        if not complete:
            message = "; ".join(notes) or f"{path}: other processes are at work on this study"
            raise StudyError(message, "MissingChunks", {"folder": path, "missing": len(self.missing(path))})
        for note in notes:
            _warned.warn(note)
        self._keep(path)
        return Study(path)

    def __reduce__(self) -> tuple[Callable[[Package, str, str], Sweep], tuple[Package, str, str]]:
        return _unpacked, (Package.of(self._compiled.package), self.name, self._compiled.hash)

    def __copy__(self) -> Sweep:
        return self

    def __deepcopy__(self, memo: object) -> Sweep:
        return self

    def __repr__(self) -> str:
        return f"Sweep({self.name!r}: {self.points} points in {self.chunks} chunks)"

    def _repr_html_(self) -> str:
        shown = {"points": self.points, "chunks": self.chunks, "keys": ", ".join(self.keys), "quantities": ", ".join(self.quantities)}
        return _shown.page(f"Sweep {self.name}", {name: str(own) for name, own in shown.items()}.items())


def _unpacked(package: Package, name: str, expected: str) -> Sweep:
    """A sweep that came from another process with all that its case needs."""
    return Sweep(package.sweep(name, expected, None), package.keep_inputs)


_arguments.checked(globals())
