"""Results in NetCDF-4, block by block: xarray would have a variable whole in memory before it writes it."""

from __future__ import annotations

import io
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from judder._interchange.results import Result, Variable, chosen, provenance, words
from judder._interchange.tables import REASON
from judder._interchange.whole import files
from judder._packages import needed
from judder.errors import StoreError

if TYPE_CHECKING:
    from judder.progress import Progress
    from judder.study import Study

_CHUNK = 1 << 16
"""About how many values of a variable are compressed together."""


def to_netcdf(study: Study, path: Path, only: Iterable[str], progress: Progress | None) -> Path:
    """One file, a group a result, in it a group of the failures of a sweep."""
    h5netcdf = needed("h5netcdf", "netcdf", "to_netcdf")
    with files(path.parent) as written, _Sink(written.new(path.name)) as sink:
        with h5netcdf.File(sink, "w") as file:
            _say(file, {"Conventions": "CF-1.11", **provenance(study)})
            for result in chosen(study, only, progress):
                _write(file.create_group(result.name), result, sink)
        sink.check()
    return path


class _Sink(io.FileIO):
    """A file for HDF5, which does not survive that a write fails: the first error is kept, and nothing is written after it."""

    def __init__(self, path: Path) -> None:
        super().__init__(path, "w+")
        self._error: OSError | None = None

    def write(self, content: Any) -> int:
        left = memoryview(content).cast("B")
        size = len(left)
        try:
            while self._error is None and left:
                left = left[super().write(left) :]
        except OSError as error:
            self._error = error
        return size

    def truncate(self, size: int | None = None) -> int:
        try:
            return super().truncate(size) if self._error is None else size or 0
        except OSError as error:
            self._error = error
            return size or 0

    def check(self) -> None:
        """Raises the error there was."""
        if self._error is not None:
            raise self._error


def _write(group: Any, result: Result, sink: _Sink) -> None:
    _say(group, result.attributes)
    if result.is_sweep:
        _write_failures(group.create_group("failures"), result)
    for dimension, length in result.dataset.sizes.items():
        group.dimensions[str(dimension)] = length
    for index in result.indices.values():
        _created(group, index)[...] = index.read()
    sets: dict[tuple[str, ...], list[Variable]] = {}
    for variable in result.variables:
        sets.setdefault(variable.dimensions, []).append(variable)
    for variables in sets.values():
        targets = [_created(group, variable) for variable in variables]
        for variable, target in zip(variables, targets, strict=True):
            if variable.name not in result.auxiliary and (beside := _beside(result, variable)):
                target.attrs["coordinates"] = beside
        for block in result.blocks(variables):
            for variable, target in zip(variables, targets, strict=True):
                target[block] = variable.read(block)
            sink.check()


def _beside(result: Result, variable: Variable) -> str:
    """The coordinates of a variable that are not those of its dimensions, as CF names them."""
    own = {one.name: one.dimensions for one in result.variables}
    return " ".join(name for name in result.auxiliary if set(own[name]) <= set(variable.dimensions))


def _created(group: Any, variable: Variable) -> Any:
    """An empty variable of a group with all that there is to say of it."""
    if "/" in variable.name:
        raise StoreError(f"`{variable.name}`: NetCDF has no names with a slash", "InvalidName", {"variable": variable.name})
    shape = variable.stored.shape
    storage: dict[str, Any] = {}
    if 0 not in shape and shape:
        storage = {"chunks": _chunks(shape), "compression": "gzip", "compression_opts": 1, "shuffle": True}
    if variable.dtype.kind == "f":
        storage["fillvalue"] = variable.dtype.type(np.nan)
    kind = _text() if variable.is_text else variable.dtype
    created = group.create_variable(variable.name, variable.dimensions, kind, **storage)
    _say(created, variable.attributes)
    return created


def _text() -> Any:
    """The kind of a variable of words."""
    return needed("h5py", "netcdf", "to_netcdf").string_dtype()


def _chunks(shape: tuple[int, ...]) -> tuple[int, ...]:
    """Rows of about so many values."""
    found: list[int] = []
    left = _CHUNK
    for length in reversed(shape):
        found.insert(0, max(1, min(length, left)))
        left //= found[0]
    return tuple(found)


def _write_failures(group: Any, result: Result) -> None:
    """Where a sweep has no answer, or a doubtful one, and why."""
    group.dimensions["failure"] = None
    point = group.create_variable("point", ("failure",), np.int64, chunks=(1024,))
    point.attrs["long_name"] = "number of the point, from 0, the last dimension fastest"
    values = {key: group.create_variable(key, ("failure",), np.float64, chunks=(1024,)) for key in result.keys}
    for key, variable in values.items():
        _say(variable, result.dataset[key].attrs)
    reason = group.create_variable("reason", ("failure",), _text(), chunks=(1024,))
    reason.attrs["long_name"] = REASON
    begin = 0
    for some in result.failures():
        end = begin + len(some.points)
        group.resize_dimension("failure", end)
        point[begin:end] = some.points
        for key, variable in values.items():
            variable[begin:end] = some.values[key]
        reason[begin:end] = np.array(some.reasons, dtype=object)
        begin = end


def _say(target: Any, attributes: Mapping[str, Any]) -> None:
    """Attributes as NetCDF has them: words and numbers; anything else as JSON."""
    for name, value in attributes.items():
        plain = isinstance(value, str | np.ndarray) or (isinstance(value, int | float) and not isinstance(value, bool))
        target.attrs[name] = value if plain else words(value)
