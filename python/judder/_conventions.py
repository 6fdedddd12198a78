"""How datasets are handed out: names that Python takes for attributes, a unit once, what they depend on and what has to be known of them.

What is stored stays as it is; this is a view of it, whose encodings and attributes Zarr and NetCDF write after any operation.
"""

from __future__ import annotations

import json
import re
from collections.abc import Collection, Hashable, Iterable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    import xarray

_UNIT = re.compile(r"\s*\(([^()]*)\)$")
_NO_UNIT = ("−", "–", "-")
_KINDS = ("analysis", "sweep")


def presented(dataset: xarray.Dataset, name: str, summary: Mapping[str, Any], warnings: Iterable[str]) -> xarray.Dataset:
    """The data of an analysis or a sweep of a study as users have them."""
    keys = {*dataset.coords, *dataset.attrs.get("keys", ())}
    known = names(dataset.variables, keys)
    renamed = dataset.rename({own: new for own, new in known.items() if own != new})
    for own, new in known.items():
        variable = renamed.variables[new]
        variable.attrs = attributes(variable.attrs) | ({"key": own} if own in keys and "." in str(own) else {})
        # what was the chunks of the whole is none of a part
        kept = variable.encoding.get("preferred_chunks")
        variable.encoding = {} if kept is None else {"preferred_chunks": {known.get(key, key): size for key, size in kept.items()}}
    renamed.encoding = {}
    about = {"judder_case": case_of(summary["case"], name), "judder_warnings": "\n".join(warnings)}
    renamed.attrs = {**attributes(dataset.attrs), **about}
    return renamed


def case_of(case: Mapping[str, Any], name: str) -> str:
    """A case with this one of its analyses and sweeps, JSON."""
    return json.dumps({**case, **{kind: [own for own in case[kind] if own.get("name") == name] for kind in _KINDS if kind in case}})


def names(given: Iterable[Hashable], keys: Collection[Hashable]) -> dict[Hashable, str]:
    """Names of variables without dots: of keys the last part where no other has it, of all else every part."""
    own = [*given]
    last = {name: str(name).rpartition(".")[2] for name in own}
    taken = [*last.values()]
    short = {name: last[name] if name in keys and last[name].isidentifier() and taken.count(last[name]) == 1 else str(name) for name in own}
    return {name: re.sub(r"\W", "_", plain) if "." in plain else plain for name, plain in short.items()}


def attributes(given: Mapping[Any, Any]) -> dict[str, Any]:
    """Attributes that every store takes, the unit once."""
    found = {str(name): _plain(value) for name, value in given.items() if value is not None}
    words, unit = found.get("long_name"), found.get("units")
    if isinstance(words, str) and (said := _UNIT.search(words)) and said[1] in ((unit, *_NO_UNIT) if unit == "1" else (unit,)):
        found["long_name"] = words[: said.start()]
    return found


def _plain(value: Any) -> Any:
    if isinstance(value, bool | np.bool_):
        return int(value)
    if isinstance(value, Mapping) or isinstance(value, list | tuple) and not all(isinstance(own, str | int | float | np.number) for own in value):
        return json.dumps(value)
    return value
