"""The results of a sweep as they are stored: one array of all quantities, chunk by chunk, each chunk with a record of its failed points."""

from __future__ import annotations

import importlib.util
import json
import math
import os
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import islice, product
from pathlib import Path
from typing import TYPE_CHECKING, Any

from judder import _judder, _places
from judder._numpy import np
from judder.errors import StoreError

if TYPE_CHECKING:
    import pandas
    import xarray
    from numpy.typing import NDArray

    from judder._places import RemotePath

_DASK_POINTS = 1 << 20
"""About how many points a chunk of dask has: many small ones would cost more than what is computed on them."""
_AT_ONCE = 256
"""Chunks whose records are fetched together."""
_TAIL = 4096
"""Bytes that hold the record of a chunk with few failures."""
_TRAILER = 48
_MAGIC = b"judderC1"


def dataset(folder: Path | RemotePath, name: str, expected: str | None = None, *, dask: bool | None = None) -> xarray.Dataset:
    """The quantities of a sweep as variables, read when they are used, with the swept keys as coordinates.

    Arrays of dask where that is installed; `dask` says otherwise.

    Raises:
        RewrittenError: it has another hash than the expected one; also later, when its values are read.
    """
    import xarray

    stored = _places.group(folder, name, expected)
    names = stored["quantity"].values.tolist()
    keys = stored.attrs["keys"]
    variables = {quantity: stored["values"].variable[..., index] for index, quantity in enumerate(names)}
    for index, variable in enumerate(variables.values()):
        variable.attrs = _attributes(stored, index)
        # that of the array of all quantities has a dimension more
        variable.encoding = {"preferred_chunks": dict(zip(variable.dims, stored["values"].encoding["chunks"], strict=False))}
    if importlib.util.find_spec("dask") is not None if dask is None else dask:
        variables = {quantity: variable.chunk(_dask_chunks(stored)) for quantity, variable in variables.items()}
    coordinates = {key: stored[key].variable for key in keys if key in stored.variables}
    coordinates |= {key: variables.pop(key) for key in keys if key in variables}
    return xarray.Dataset(variables, coordinates, stored.attrs)


def _attributes(stored: xarray.Dataset, index: int) -> dict[str, Any]:
    """Unit, long name and classes of a quantity, as CF has them."""

    def told(what: str) -> str:
        return str(stored[what].values[index]) if what in stored.coords else ""

    found: dict[str, Any] = {"units": told("quantity_units"), "long_name": told("quantity_long_name")}
    if codes := told("quantity_flag_values"):
        found["flag_values"] = [int(code) for code in codes.split()]
        found["flag_meanings"] = told("quantity_flag_meanings")
    return {key: value for key, value in found.items() if value}


def _dask_chunks(stored: xarray.Dataset) -> dict[Any, int]:
    """Whole stored chunks, as many along the first dimensions as make some work."""
    values = stored["values"]
    own = dict(zip(values.dims, values.encoding["chunks"], strict=True))
    own.pop("quantity")
    points = math.prod(own.values())
    for name in reversed(own):
        times = max(1, min(_DASK_POINTS // points, -(-values.sizes[name] // own[name])))
        points *= times
        own[name] *= times
    return own


def failed_points(folder: Path | RemotePath, name: str, expected: str | None, *, any_failed: bool) -> pandas.DataFrame:
    """The failures of all chunks, with the values of the swept keys there."""
    import pandas

    keys = _places.group(folder, name, expected).attrs["keys"]
    found = joined(failures(folder, name, expected) if any_failed else (), keys)
    return pandas.DataFrame({**found.values, "reason": found.reasons})


@dataclass(frozen=True)
class Failures:
    """Points of some chunks without an answer, or with a doubtful one."""

    points: NDArray[np.int64]
    """Their numbers in the sweep, from 0, the last dimension fastest."""
    values: dict[str, NDArray[np.float64]]
    """The swept keys there."""
    reasons: list[str]
    """Why."""


def joined(some: Iterable[Failures], keys: list[str]) -> Failures:
    """Those of several chunks."""
    every = list(some)
    return Failures(
        np.concatenate([np.empty(0, dtype=np.int64), *(one.points for one in every)]),
        {key: np.concatenate([np.empty(0), *(one.values[key] for one in every)]) for key in keys},
        [reason for one in every for reason in one.reasons],
    )


def failures(folder: Path | RemotePath, name: str, expected: str | None) -> Iterator[Failures]:
    """The failures, chunk after chunk that has any; looks at every chunk.

    Raises:
        RewrittenError: the sweep has another hash than the expected one.
        StoreError: a chunk is not there, damaged, or of another sweep.
    """
    found = dataset(folder, name, expected, dask=False)
    shape, chunk = _grid(folder, name)
    for first, record in _records(folder / "results.zarr" / name / "values", found.attrs["judder_hash"], shape, chunk):
        if not record["failures"]:
            continue
        inner = [min(own, length - begin) for own, length, begin in zip(chunk, shape, first, strict=True)]
        within = np.unravel_index([failure["index"] for failure in record["failures"]], inner)
        here = found.isel({dimension: slice(begin, begin + own) for dimension, begin, own in zip(found.sizes, first, inner, strict=True)})
        along = dict(zip(found.sizes, within, strict=True))
        yield Failures(
            np.asarray(np.ravel_multi_index([begin + steps for begin, steps in zip(first, within, strict=True)], shape), dtype=np.int64),
            {key: np.asarray(here[key].values)[along[here[key].dims[0]]] for key in found.attrs["keys"]},
            [failure["reason"] for failure in record["failures"]],
        )


def whole(folder: Path | RemotePath, name: str) -> None:
    """Looks whether all chunks of a sweep are there, by one list of their names; opens none, and tells nothing of a store that lists nothing.

    Raises:
        StoreError: one is not there.
    """
    values = folder / "results.zarr" / name / "values"
    try:
        there = {*os.listdir(values)} if isinstance(values, Path) else {path.name for path in values.iterdir()}
    except (FileNotFoundError, NotADirectoryError):
        there = set()
    if not there and not isinstance(values, Path):
        return
    shape, chunk = _grid(folder, name)
    for place in product(*(range(-(-length // own)) for length, own in zip(shape, chunk, strict=True))):
        own_name = _named(place)
        # a list may end early
        if own_name not in there and not (values / own_name).exists():
            raise _judder.unusable_chunk(str(values / own_name))


def damaged(folder: Path | RemotePath, name: str, block: tuple[slice, ...]) -> StoreError | None:
    """Names the first chunk in a block that does not have the values it was written with, where that is why they cannot be read."""
    shape, chunk = _grid(folder, name)
    stored = _places.group(folder, name)
    steps = block if len(block) == len(shape) else tuple(slice(0, length) for length in shape)
    for place in product(*(range(step.start // own, -(-step.stop // own)) for step, own in zip(steps, chunk, strict=True))):
        own_name = _named(place)
        values = folder / "results.zarr" / name / "values"
        within = tuple(slice(index * own, (index + 1) * own) for index, own in zip(place, chunk, strict=True))
        try:
            _record(values, own_name, _places.tails(values, [own_name], _TAIL)[0], stored.attrs["judder_hash"])
            np.asarray(stored["values"].variable[within].values)
        except StoreError as error:
            return error
        # what codecs raise for a checksum, a length, a stream that is none
        except (ValueError, RuntimeError):
            return _judder.unusable_chunk(str(values / own_name), "values")
    return None


def _grid(folder: Path | RemotePath, name: str) -> tuple[list[int], list[int]]:
    """Points, and points of a chunk, along each dimension."""
    metadata = json.loads((folder / "results.zarr" / name / "values" / "zarr.json").read_text(encoding="utf-8"))
    return metadata["shape"][:-1], metadata["chunk_grid"]["configuration"]["chunk_shape"][:-1]


def _records(folder: Path | RemotePath, expected: str, shape: list[int], chunk: list[int]) -> Iterator[tuple[list[int], dict[str, Any]]]:
    """The first point of each chunk along each dimension, and the record of the chunk."""
    places = np.ndindex(*(-(-length // own) for length, own in zip(shape, chunk, strict=True)))
    while some := list(islice(places, _AT_ONCE)):
        names = [_named(place) for place in some]
        for place, name, tail in zip(some, names, _places.tails(folder, names, _TAIL), strict=True):
            yield [index * own for index, own in zip(place, chunk, strict=True)], _record(folder, name, tail, expected)


def _record(folder: Path | RemotePath, name: str, tail: bytes | None, expected: str) -> dict[str, Any]:
    """The record of a chunk of the sweep of this hash: JSON before the last 48 bytes, which hold its checksum, its length and a mark."""
    path = str(folder / name)
    if tail is None:
        raise _judder.unusable_chunk(path)
    if not tail.endswith(_MAGIC) or len(tail) < _TRAILER:
        raise _judder.unusable_chunk(path, "end")
    length = int.from_bytes(tail[-16:-8], "little")
    if length + _TRAILER > len(tail):
        (longer,) = _places.tails(folder, [name], length + _TRAILER)
        tail = longer or b""
    try:
        record: dict[str, Any] = json.loads(tail[-length - _TRAILER : -_TRAILER])
    except ValueError:
        raise _judder.unusable_chunk(path, "record") from None
    if record.get("hash") != expected:
        raise _judder.foreign_chunk(path, expected, str(record.get("hash")))
    return record


def _named(place: tuple[int, ...]) -> str:
    """The file of a chunk."""
    return ".".join(["c", *map(str, place), "0"])
