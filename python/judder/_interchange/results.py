"""Results of a study as other programs take them: real variables, block by block, and what there is to say of them."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from judder import _swept
from judder.errors import InputError, RewrittenError, StoreError

if TYPE_CHECKING:
    from pathlib import Path

    import xarray

    from judder._places import RemotePath
    from judder.progress import Progress
    from judder.study import Study

Block: TypeAlias = "tuple[slice, ...]"

ROWS = 1 << 18
"""About how many points are in memory at a time."""
_FAILURES = 1 << 14
"""About how many failures are in memory at a time: their reasons are long."""


@dataclass(frozen=True)
class Variable:
    """A real variable, or one part of a complex one, as it lies in a study."""

    name: str
    stored: xarray.Variable
    part: str
    """``real`` or ``imag`` of a complex variable, else empty."""
    sweep: tuple[Path | RemotePath, str] | None = None
    """The study folder and the name of the sweep whose chunks it is read from."""

    @property
    def dimensions(self) -> tuple[str, ...]:
        """The names of its dimensions."""
        return tuple(str(dimension) for dimension in self.stored.dims)

    @property
    def is_text(self) -> bool:
        """Whether it holds words."""
        return self.stored.dtype.kind in "OSUT"

    @property
    def dtype(self) -> np.dtype[Any]:
        """The kind of its numbers."""
        kind = self.stored.dtype
        return np.dtype(f"f{kind.itemsize // 2}") if self.part else np.dtype(object) if self.is_text else kind

    @property
    def attributes(self) -> dict[str, Any]:
        """Unit, long name, and the codes of classes, as CF has them."""
        found = dict(self.stored.attrs)
        if self.part:
            found["long_name"] = f"{found.get('long_name', self.name)}, {'real' if self.part == 'real' else 'imaginary'} part"
        if "flag_values" in found:
            found["flag_values"] = np.asarray(found["flag_values"], dtype=self.dtype)
        return found

    def read(self, block: Block = ()) -> NDArray[Any]:
        """Its values in a block.

        Raises:
            RewrittenError: another run has replaced them.
            StoreError: they cannot be read.
        """
        try:
            values = np.asarray(self.stored[block].values)
        except RewrittenError:
            raise
        # stores and codecs have exceptions of their own, of any class
        except Exception as error:
            if self.sweep is not None and (damaged := _swept.damaged(*self.sweep, block)):
                raise damaged from error
            message = f"`{self.name}` cannot be read ({type(error).__name__}: {error})"
            raise StoreError(message, "Unreadable", {"variable": self.name}) from error
        return getattr(values, self.part) if self.part else values.astype(object) if self.is_text else values


class Result:
    """An analysis or a sweep of a study, which is read once, block by block."""

    study: Study
    """The study."""
    name: str
    """Its name."""
    dataset: xarray.Dataset
    """Its data, read when they are used; nothing of it is an array of dask."""

    def __init__(self, study: Study, name: str, dataset: xarray.Dataset, progress: Progress | None = None) -> None:
        self.study, self.name, self.dataset = study, name, dataset
        self._progress, self._done = progress, 0

    @cached_property
    def variables(self) -> list[Variable]:
        """What it holds besides the coordinates of its dimensions.

        Raises:
            StoreError: the parts of a complex variable would have the name of another.
        """
        own = [*self._coordinates, *self.dataset.data_vars]
        found = [one for name in own for one in real(str(name), self.dataset[name].variable, self.sweep)]
        names = [*map(str, self.dataset.sizes), *(variable.name for variable in found)]
        for name in {*names}:
            if names.count(name) > 1:
                raise StoreError(f"`{self.name}`: two variables would be called `{name}`", "Duplicate", {"variable": name})
        return found

    @property
    def _coordinates(self) -> list[str]:
        return [str(name) for name in self.dataset.coords if name not in self.dataset.sizes]

    @property
    def auxiliary(self) -> list[str]:
        """The names of coordinates that are not those of dimensions: the swept keys of samples."""
        return [one.name for name in self._coordinates for one in real(name, self.dataset[name].variable)]

    @property
    def indices(self) -> dict[str, Variable]:
        """The coordinates of dimensions that have any."""
        names = [name for name in self.dataset.sizes if name in self.dataset.coords]
        return {str(name): Variable(str(name), self.dataset[name].variable, "") for name in names}

    @property
    def attributes(self) -> dict[str, Any]:
        """What the study says of it, and its numbers in ``results``."""
        return {**self.dataset.attrs, "results": self.numbers}

    @property
    def numbers(self) -> dict[str, Any]:
        """Its scalars and short tables, as in ``summary.json``."""
        return self.study.results.get(self.name, {})

    @property
    def is_sweep(self) -> bool:
        """Whether it is a sweep, whose points may have failed."""
        return self.name in self.study.sweeps

    @property
    def sweep(self) -> tuple[Path | RemotePath, str] | None:
        """The study folder and the name, where it is a sweep."""
        return (self.study._stored, self.name) if self.is_sweep else None

    @property
    def keys(self) -> list[str]:
        """The swept keys of a sweep."""
        return list(self.dataset.attrs["keys"])

    def failures(self) -> Iterator[_swept.Failures]:
        """The points of a sweep without an answer, many at a time; looks at every chunk.

        Raises:
            StoreError: a chunk is not there, damaged, or of another sweep.
        """
        some: list[_swept.Failures] = []
        count = 0
        for found in _swept.failures(self.study._stored, self.name, self.study.hashes.get(self.name)):
            some.append(found)
            count += len(found.reasons)
            if count >= _FAILURES:
                yield _swept.joined(some, self.keys)
                some, count = [], 0
        if some:
            yield _swept.joined(some, self.keys)

    def blocks(self, variables: list[Variable]) -> Iterator[Block]:
        """Blocks of variables of the same dimensions, in the order of their rows; tells the values of those that are done."""
        first = variables[0].stored
        encoding = first.encoding
        preferred = encoding.get("preferred_chunks", {})
        chunk = encoding.get("shards") or encoding.get("chunks") or [preferred.get(name, size) for name, size in first.sizes.items()]
        for block in blocks(first.shape, tuple(chunk)[: first.ndim], ROWS):
            yield block
            self.tell(len(variables) * math.prod(steps.stop - steps.start for steps in block))

    def tell(self, more: int) -> None:
        """Tells the progress callback that so many more values are read."""
        self._done += more
        if self._progress is not None:
            total = sum(variable.stored.size for variable in self.variables)
            self._progress(self.name, min(self._done, total), total)


def chosen(study: Study, only: Iterable[str], progress: Progress | None) -> list[Result]:
    """The results of a study, or some of them.

    Raises:
        InputError: one of them is not there.
    """
    wanted = [only] if isinstance(only, str) else list(only)
    for name in wanted:
        if name not in [*study]:
            why = f"`{name}` has no result: {study.failures[name]}" if name in study.failures else f"there is no result `{name}`"
            has = ", ".join(f"`{own}`" for own in study) or "none"
            raise InputError(f"only: {why}; the study has {has}", "Input", {"argument": "only"})
    return [_result(study, name, progress) for name in study if not wanted or name in wanted]


def _result(study: Study, name: str, progress: Progress | None) -> Result:
    return Result(study, name, study._dataset(name, whole=False, dask=False), progress)


def real(name: str, variable: xarray.Variable, sweep: tuple[Path | RemotePath, str] | None = None) -> list[Variable]:
    """A variable, or the two parts of a complex one."""
    if variable.dtype.kind == "c":
        return [Variable(f"{name}_{part}", variable, part, sweep) for part in ("real", "imag")]
    return [Variable(name, variable, "", sweep)]


def blocks(shape: tuple[int, ...], chunk: tuple[int, ...], rows: int) -> Iterator[Block]:
    """Blocks of about so many points that follow on each other row-major, and cut no chunk where that can be."""
    if not shape:
        yield ()
        return
    inner = max(1, math.prod(shape[1:]))
    here = max(rows, math.prod(chunk)) // inner
    if here:
        step = here - here % chunk[0] if here >= chunk[0] else here
        for begin in range(0, shape[0], step):
            yield (slice(begin, min(begin + step, shape[0])), *(slice(0, length) for length in shape[1:]))
        return
    for index in range(shape[0]):
        for rest in blocks(shape[1:], chunk[1:], rows):
            yield (slice(index, index + 1), *rest)


def provenance(study: Study) -> dict[str, str]:
    """Where the numbers come from."""
    summary = study.summary
    return {
        "title": study._name,
        "source": f"judder {summary['version']}",
        "case_hash": str(summary["case_hash"]),
        "case": str(summary.get("study", {}).get("source") or json.dumps(summary["case"])),
    }


def flat(value: Any, path: str = "") -> Iterator[tuple[str, Any]]:
    """The numbers and words in nested tables, by dotted paths; members of lists by their numbers, from 0."""
    if isinstance(value, Mapping):
        inner: Iterable[tuple[Any, Any]] = value.items()
    elif isinstance(value, list):
        inner = enumerate(value)
    else:
        yield path, value
        return
    for key, item in inner:
        yield from flat(item, f"{path}.{key}" if path else str(key))


def words(value: Any) -> str:
    """An attribute as text: words as they are, numbers between spaces, anything else as JSON."""
    value = value.tolist() if isinstance(value, np.ndarray | np.generic) else value
    if isinstance(value, list) and value and all(isinstance(item, int | float) for item in value):
        return " ".join(f"{item:.17g}" for item in value)
    return value if isinstance(value, str) else json.dumps(value, ensure_ascii=False)
