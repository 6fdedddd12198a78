"""Results in MATLAB's files of version 5."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from judder._interchange.results import Result, Variable, chosen, provenance, real
from judder._interchange.whole import files
from judder._packages import needed
from judder._swept import joined
from judder.errors import StoreError

if TYPE_CHECKING:
    from judder.progress import Progress
    from judder.study import Study

LARGEST = 1 << 31
"""Bytes of a variable that every program reads."""
_HEADER = b"MATLAB 5.0 MAT-file, written by judder"
_KEYWORDS = frozenset(
    "break case catch classdef continue else elseif end for function global if otherwise "
    "parfor persistent return spmd switch try while".split()
)
_SAID = ("units", "long_name", "flag_values", "flag_meanings", "dimensions", "attributes", "results", "failures", "names")


def to_matlab(study: Study, path: Path, only: Iterable[str], progress: Progress | None) -> Path:
    """One file, a structure a result."""
    io = needed("scipy.io", "matlab", "to_matlab")
    with files(path.parent) as written:
        partial = written.new(path.name)
        results = chosen(study, only, progress)
        for result in results:
            _check_size(result)
        names = identifiers([result.name for result in results], taken=["judder"])
        content = {"judder": provenance(study)} | {names[result.name]: _structure(result) for result in results}
        with partial.open("wb+") as file:
            io.savemat(file, content, long_field_names=True, do_compression=True, oned_as="column")
            # in place of the time: the same study, the same bytes
            file.seek(0)
            file.write(_HEADER.ljust(116))
    return path


def _check_size(result: Result) -> None:
    """Refuses what does not fit into such a file."""
    size = sum(variable.nbytes for variable in result.dataset.variables.values())
    if size >= LARGEST:
        message = (
            f"`{result.name}` has {size} bytes, and MATLAB's files of version 5 hold less than {LARGEST} a variable: "
            "leave it out with `only`, or take `to_netcdf`, whose files MATLAB reads with `ncread`"
        )
        raise StoreError(message, "TooLarge", {"name": result.name, "bytes": size})


def _structure(result: Result) -> dict[str, Any]:
    """The variables by names that MATLAB takes, and what there is to say of them."""
    dataset = result.dataset
    variables = [Variable(str(name), dataset[name].variable, "", result.sweep) for name in [*dataset.coords, *dataset.data_vars]]
    names = identifiers([variable.name for variable in variables], taken=_SAID)
    content: dict[str, Any] = {}
    for variable in variables:
        content[names[variable.name]] = variable.read()
        result.tell(variable.stored.size * len(real(variable.name, variable.stored)))
    for what in ("units", "long_name", "flag_values", "flag_meanings"):
        said = {names[variable.name]: variable.attributes[what] for variable in variables if what in variable.attributes}
        content[what] = _native(said)
    content["dimensions"] = {names[variable.name]: " ".join(variable.dimensions) for variable in variables}
    content["names"] = {own: name for name, own in names.items()}
    content["attributes"] = _native(dataset.attrs)
    content["results"] = _native(result.numbers)
    if result.is_sweep:
        content["failures"] = _failures(result)
    return content


def _failures(result: Result) -> dict[str, Any]:
    """Where a sweep has no answer, or a doubtful one: `index` as MATLAB counts the elements of a variable."""
    found = joined(result.failures(), result.keys)
    shape = tuple(result.dataset.sizes.values())
    index = np.ravel_multi_index(np.unravel_index(found.points, shape), shape, order="F") + 1
    keys = {own: found.values[key] for key, own in identifiers(result.keys, taken=("index", "reason")).items()}
    return {"index": index, **keys, "reason": np.array(found.reasons, dtype=object)}


def _native(value: Any) -> Any:
    """Tables as structures, lists of numbers as columns or matrices, other lists as cells, nothing as an empty array."""
    if isinstance(value, Mapping):
        names = identifiers(map(str, value))
        return {names[str(key)]: _native(item) for key, item in value.items()}
    if value is None:
        return np.empty((0, 0))
    if not isinstance(value, list):
        return value
    rows = value if value and all(isinstance(item, list) for item in value) else [value]
    if len({len(row) for row in rows}) == 1 and all(isinstance(item, int | float) for row in rows for item in row):
        return np.array(value, dtype=np.float64)
    cells = np.empty(len(value), dtype=object)
    for place, item in enumerate(value):
        cells[place] = _native(item)
    return cells


def identifiers(names: Iterable[str], taken: Iterable[str] = ()) -> dict[str, str]:
    """Names as MATLAB takes them, each its own: letters, digits and ``_``, a letter first, no keyword, 63 at most."""
    used = {*taken}
    found: dict[str, str] = {}
    for name in names:
        plain = re.sub(r"[^A-Za-z0-9_]", "_", name)
        if not plain[:1].isalpha() or plain in _KEYWORDS:
            plain = f"x{plain}"
        plain, number = plain[:63], 1
        own = plain
        while own in used:
            number += 1
            own = f"{plain[: 62 - len(str(number))]}_{number}"
        used.add(own)
        found[name] = own
    return found
