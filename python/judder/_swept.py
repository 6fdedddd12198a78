"""The results of a sweep as they are stored: one array of all quantities, chunk by chunk, each chunk with a record of its failed points."""

from __future__ import annotations

import importlib.util
import json
import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from judder.errors import StoreError

if TYPE_CHECKING:
    import pandas
    import xarray

_DASK_POINTS = 1 << 20
"""About how many points a chunk of dask has: many small ones would cost more than what is computed on them."""
_TRAILER = 48
_MAGIC = b"judderC1"


def dataset(folder: Path, name: str) -> xarray.Dataset:
    """The quantities of a sweep as variables, read when they are used, with the swept keys as coordinates."""
    import xarray

    stored = xarray.open_dataset(folder / "results.zarr", engine="zarr", group=name, chunks=None)
    names = stored["quantity"].values.tolist()
    keys = stored.attrs["keys"]
    variables = {quantity: stored["values"].variable[..., index] for index, quantity in enumerate(names)}
    for index, variable in enumerate(variables.values()):
        variable.attrs = _attributes(stored, index)
    if importlib.util.find_spec("dask") is not None:
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


def failed_points(folder: Path, name: str, *, any_failed: bool) -> pandas.DataFrame:
    """The failures of all chunks, with the values of the swept keys there."""
    import pandas

    found = dataset(folder, name)
    keys = found.attrs["keys"]
    shape, chunk = _grid(folder, name)
    rows = _failures(folder / "results.zarr" / name / "values", found.attrs["judder_hash"], shape, chunk) if any_failed else []
    positions = np.array([position for position, _ in rows], dtype=np.int64).reshape(len(rows), len(shape))
    columns: dict[str, Any] = {}
    for key in keys:
        along = list(found.sizes).index(found[key].dims[0])
        columns[key] = np.asarray(found[key].values)[positions[:, along]]
    columns["reason"] = [reason for _, reason in rows]
    return pandas.DataFrame(columns)


def _grid(folder: Path, name: str) -> tuple[list[int], list[int]]:
    """Points, and points of a chunk, along each dimension."""
    metadata = json.loads((folder / "results.zarr" / name / "values" / "zarr.json").read_text(encoding="utf-8"))
    return metadata["shape"][:-1], metadata["chunk_grid"]["configuration"]["chunk_shape"][:-1]


def _failures(chunks: Path, expected: str, shape: list[int], chunk: list[int]) -> list[tuple[list[int], str]]:
    """Positions and reasons, chunk after chunk."""
    found = []
    for place in np.ndindex(*(-(-length // own) for length, own in zip(shape, chunk, strict=True))):
        record = _record(chunks / ".".join(["c", *map(str, place), "0"]), expected)
        first = [index * own for index, own in zip(place, chunk, strict=True)]
        inner = [min(own, length - begin) for own, length, begin in zip(chunk, shape, first, strict=True)]
        for failure in record["failures"]:
            within = np.unravel_index(failure["index"], inner)
            found.append(([begin + int(step) for begin, step in zip(first, within, strict=True)], failure["reason"]))
    return found


def _record(path: Path, expected: str) -> dict[str, Any]:
    """The record of a chunk of the sweep of this hash: JSON before the last 48 bytes, which hold its checksum, its length and a mark."""
    try:
        with path.open("rb") as file:
            end = file.seek(0, 2)
            file.seek(max(0, end - _TRAILER))
            trailer = file.read()
            length = int.from_bytes(trailer[32:40], "little")
            file.seek(max(0, end - _TRAILER - length))
            record: dict[str, Any] = json.loads(file.read(length)) if trailer.endswith(_MAGIC) else {}
    except FileNotFoundError:
        raise _unreadable(path, "MissingChunk", "is not there") from None
    except (ValueError, OSError):
        raise _unreadable(path, "DamagedChunk", "is damaged") from None
    if record.get("hash") != expected:
        raise _unreadable(path, "ForeignChunk", "is of another sweep") if record else _unreadable(path, "DamagedChunk", "is damaged")
    return record


def _unreadable(path: Path, cause: str, what: str) -> StoreError:
    return StoreError(f"{path}: this chunk {what}; `judder run` computes it again", cause, {"path": str(path)})
