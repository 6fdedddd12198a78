"""Operating points over arrays: which dimensions they have, and their dataset."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from judder import _warned
from judder._columns import wrong

if TYPE_CHECKING:
    import xarray

_WITH_UNIT = re.compile(r"(?P<key>[^\[\]]*[^\[\]\s])\s*\[(?P<unit>[^\[\]]+)\]")


class Varied:
    """Keys with arrays of values, broadcast against each other."""

    fixed: dict[str, Any]
    """The keys with one value."""
    dimensions: tuple[str, ...]
    """The dimensions of the points: the key that alone varies along each, else ``point``."""
    shape: tuple[int, ...]
    """How many points there are along each."""

    def __init__(self, keys: Mapping[str, Any]) -> None:
        self.fixed = {}
        arrays: dict[str, Any] = {}
        named: dict[str, Any] = {}
        self._units: dict[str, str | None] = {}
        for given, value in keys.items():
            key, values, unit = _split(given, value)
            if key in self._units or key in self.fixed:
                raise wrong(key, "is given twice")
            if isinstance(values, str) or np.ndim(values) == 0:
                self.fixed[key] = _single(key, values, unit)
                continue
            self._units[key] = unit
            (named if hasattr(values, "dims") else arrays)[key] = values
        if named and arrays:
            raise wrong(next(iter(arrays)), f"is an array without names of its dimensions, and `{next(iter(named))}` has some; make both DataArrays")
        self._arrays: dict[str, NDArray[Any]] = {}
        self._places: dict[str, Any] = {}
        if named:
            self._of_xarray(named)
        else:
            self._of_numpy(arrays)

    def _of_xarray(self, named: Mapping[str, Any]) -> None:
        import xarray

        try:
            spread = xarray.broadcast(*xarray.align(*named.values(), join="exact", copy=False))
        except ValueError as error:
            raise wrong(next(iter(named)), f"does not lie on the coordinates of the others ({error})") from None
        self.dimensions, self.shape = tuple(map(str, spread[0].dims)), spread[0].shape
        self._arrays = {key: own.values for key, own in zip(named, spread, strict=True)}
        own = {key: tuple(map(str, value.dims)) for key, value in named.items()}
        self._own_dimensions = own
        for value in named.values():
            for name, coordinate in value.coords.items():
                if set(coordinate.dims) <= set(self.dimensions):
                    self._places[str(name)] = coordinate.variable

    def _of_numpy(self, arrays: Mapping[str, Any]) -> None:
        values = {key: np.asarray(value) for key, value in arrays.items()}
        try:
            self.shape = np.broadcast_shapes(*(own.shape for own in values.values()))
        except ValueError:
            told = ", ".join(f"`{key}` {own.shape}" for key, own in values.items())
            raise wrong(next(iter(values)), f"cannot be broadcast: the shapes are {told}") from None
        self._arrays = {key: np.broadcast_to(own, self.shape) for key, own in values.items()}
        axes = {key: _own_axes(own.shape, self.shape) for key, own in values.items()}
        alone = [[key for key, own in axes.items() if axis in own] for axis in range(len(self.shape))]
        names = [owners[0] if len(owners) == 1 and axes[owners[0]] == [axis] else None for axis, owners in enumerate(alone)]
        several = names.count(None) > 1
        self.dimensions = tuple(
            _last(name) if name is not None else f"point_{axis}" if several else "point" for axis, name in enumerate(names)
        )
        self._own_dimensions = {key: tuple(self.dimensions[axis] for axis in own) for key, own in axes.items()}

    def sides(self) -> list[tuple[str, NDArray[Any], str | None]]:
        """Each key with a value a point, and their unit where they have one."""
        return [(key, own.ravel(), self._units[key]) for key, own in self._arrays.items()]

    def coordinates(self, told: list[tuple[str, str, str, str, NDArray[np.float64]]]) -> dict[str, Any]:
        """The varied keys along the dimensions that they have of their own, in the units that were used."""
        found = dict(self._places)
        for key, (path, name, words, units, values) in zip(self._arrays, told, strict=True):
            own = self._own_dimensions[key]
            index = tuple(slice(None) if dimension in own else 0 for dimension in self.dimensions)
            found[name] = (own, values.reshape(self.shape)[index], {"long_name": words, "units": units, "key": path})
        return found


def _split(given: str, value: Any) -> tuple[str, Any, str | None]:
    """Key, values and unit, which stands in the name of the key, beside the values, or in the attributes of a DataArray."""
    if split := _WITH_UNIT.fullmatch(given):
        return split["key"], value, split["unit"]
    if isinstance(value, tuple) and len(value) == 2 and isinstance(value[1], str):
        return given, *value
    unit = getattr(value, "attrs", {}).get("units") if hasattr(value, "dims") else None
    return given, value, None if unit in (None, "", "1") else str(unit)


def _single(key: str, value: Any, unit: str | None) -> Any:
    """One value as a point takes it."""
    if isinstance(value, str):
        if unit is not None:
            raise wrong(key, f"is the text {value!r}, which has its own unit, and a unit {unit!r} besides")
        return value
    number = np.asarray(value)
    if number.dtype.kind not in "fiu":
        return value
    return float(number) if unit is None else f"{float(number)!r} {unit}"


def _own_axes(own: tuple[int, ...], shape: tuple[int, ...]) -> list[int]:
    """The axes of a shape along which an array has values of its own."""
    first = len(shape) - len(own)
    return [first + axis for axis, size in enumerate(own) if size > 1 or shape[first + axis] == 1]


def _last(key: str) -> str:
    return key.rpartition(".")[2]


def dataset(varied: Varied, told: Mapping[str, Any]) -> xarray.Dataset:
    """The quantities and eigenvalues of points, with the varied keys as coordinates; the case, and what has to be known, as attributes."""
    import xarray

    dimensions, shape = varied.dimensions, varied.shape
    variables: dict[str, Any] = {}
    for name, units, words, flags, values in told["quantities"]:
        about: dict[str, Any] = {"long_name": words, "units": units} if units else {"long_name": words}
        if flags:
            about |= {"flag_values": np.arange(len(flags), dtype=np.uint8), "flag_meanings": " ".join(flags)}
        variables[name] = (dimensions, values.reshape(shape), about)
    modes = {"long_name": "eigenvalues λ/ω_nx of the full system, eq. (21)", "units": "1"}
    variables["eigenvalues"] = ((*dimensions, "mode"), told["eigenvalues"].reshape((*shape, 4)), modes)
    doubts = [*told["warnings"], *_doubts(told, varied)]
    for doubt in doubts:
        _warned.warn(doubt)
    about = {"judder_case": told["case"], "judder_warnings": "\n".join(doubts)}
    return xarray.Dataset(variables, varied.coordinates(told["keys"]), about)


def _doubts(told: Mapping[str, Any], varied: Varied) -> list[str]:
    """What has to be known of some of the points."""
    total = int(np.prod(varied.shape, dtype=np.int64))
    found = []
    for (count, first), what in ((told["failed"], "have no answer"), (told["beyond"], "lie outside the range of the law")):
        if first is not None:
            index, why = first
            at = ", ".join(map(str, np.unravel_index(index, varied.shape))) if varied.shape else ""
            found.append(f"{count} of {total} points {what}; the first, ({at}): {why}")
    return found
