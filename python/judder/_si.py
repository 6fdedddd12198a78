"""Arrays in SI beside those in groups, made of what each says of itself: ``si_factor``, ``si_unit``, ``si_long_name``.

They are stored once, in the groups that a model computes in.
"""

from __future__ import annotations

from collections.abc import Hashable
from typing import TYPE_CHECKING, Any, Final

if TYPE_CHECKING:
    import xarray

ENDING: Final = "_si"
"""How the name of an array in SI ends that stands beside one in groups."""
_CHUNKS = ("chunks", "preferred_chunks", "shards")
# the label is that of the groups
_OF_GROUPS = ("label", "si_factor", "si_unit", "si_long_name")


def beside(dataset: xarray.Dataset, *, in_memory: bool) -> xarray.Dataset:
    """A dataset with every array that has a unit in SI in that too, under its name and ``_si``; values that are stored are read when they are used."""
    told = {name: own for name, own in dataset.variables.items() if "si_factor" in own.attrs}
    made = {f"{name}{ENDING}": _in_si(own, in_memory=in_memory) for name, own in told.items()}
    coordinates = {f"{name}{ENDING}" for name in told if name in dataset.coords}
    return dataset.assign(made).set_coords(coordinates) if made else dataset


def alone(dataset: xarray.Dataset) -> xarray.Dataset:
    """A dataset with the arrays in SI in the place of those in groups, under their names."""
    import xarray

    taken = {str(name).removesuffix(ENDING): name for name in dataset.variables if str(name).endswith(ENDING)}
    pairs = {name: own for name, own in taken.items() if name in dataset.variables}
    kept = [name for name in dataset.variables if name not in pairs.values()]
    variables: dict[Hashable, Any] = {name: dataset.variables[pairs.get(str(name), name)].to_base_variable() for name in kept}
    coordinates = {name: variables.pop(name) for name in kept if name in dataset.coords}
    return xarray.Dataset(variables, coordinates, dataset.attrs)


def _in_si(own: xarray.Variable, *, in_memory: bool) -> xarray.Variable:
    import xarray

    from judder._scaled import scaled

    factor = float(own.attrs["si_factor"])
    attributes = {name: value for name, value in own.attrs.items() if name not in _OF_GROUPS}
    attributes |= {"units": own.attrs["si_unit"], "long_name": own.attrs["si_long_name"]}
    values = factor * own.values if in_memory else scaled(own, factor)
    encoding = {name: own.encoding[name] for name in _CHUNKS if name in own.encoding}
    return xarray.Variable(own.dims, values, attributes, encoding, fastpath=not in_memory)
