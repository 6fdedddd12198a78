"""Columns of numbers as cases take them: quantities with their units, rows of a list of tables, files of tables."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from judder._numpy import np
from judder.errors import InputError

if TYPE_CHECKING:
    from numpy.typing import NDArray

_DIRECTIONS = ("x", "y", "z")
_COMPLEX_MODULI = ("e", "modulus", "complex modulus")
"""Names of columns that are complex where they are moduli."""


def wrong(key: str, why: str) -> InputError:
    """What is wrong with the object at a key."""
    return InputError(f"`{key}` {why}", "Input", {"argument": key, "key": key})


def numbers(key: str, value: Any, *, dimensions: int) -> NDArray[np.float64]:
    """Finite real numbers as an array of so many dimensions, which is not empty."""
    array = np.asarray(value)
    if array.dtype.kind not in "fiub":
        kind = {"c": "complex numbers", "O": "objects of Python", "U": "texts", "S": "texts", "M": "times", "m": "durations"}
        raise wrong(key, f"holds {kind.get(array.dtype.kind, f'what NumPy calls {array.dtype}')}, and real numbers are needed")
    if array.ndim != dimensions or array.size == 0:
        raise wrong(key, f"has the shape {array.shape}, and an array of {dimensions} dimension{'s' * (dimensions > 1)} that is not empty is needed")
    found = np.ascontiguousarray(array, dtype=np.float64)
    if not np.isfinite(found).all():
        place = ", ".join(str(step) for step in np.argwhere(~np.isfinite(found))[0])
        raise wrong(key, f"has {found[~np.isfinite(found)][0]} at ({place}), counted from 0, and finite numbers are needed")
    return found


def quantities(key: str, value: Any, unit: str) -> Any:
    """A number, or numbers, as quantities with this unit."""
    if isinstance(value, str | Mapping) or value is None:
        raise wrong(key, f"has its unit in the name of the key, `[{unit}]`, and needs a number or an array of numbers")
    array = np.asarray(value)
    if array.ndim == 0 and array.dtype.kind in "fiu":
        return _quantity(float(array), unit)
    return [_quantity(number, unit) for number in numbers(key, value, dimensions=1).tolist()]


def _quantity(number: float, unit: str) -> str:
    return f"{number!r} {unit}" if math.isfinite(number) else str(number)


def is_column(value: Any) -> bool:
    """Whether a value is an array or a list that a column of a table may be."""
    return not isinstance(value, str | Mapping) and (hasattr(value, "__array__") or isinstance(value, list | tuple))


def of(key: str, value: Any) -> dict[str, Any] | None:
    """The columns of a mapping, a frame of pandas or a structured array; nothing where it is none of these."""
    if names := getattr(getattr(value, "dtype", None), "names", None):
        return {name: value[name] for name in names}
    if hasattr(value, "columns") and hasattr(value, "iloc"):
        return {str(name): value[name].to_numpy() for name in value.columns}
    if isinstance(value, Mapping):
        return {str(name): getattr(column, "values", column) for name, column in value.items()}
    return None


def rows(key: str, columns: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Columns as a list of tables, those with a unit in their name as quantities."""
    count = same_length(key, columns)
    lists = {name: np.asarray(column).tolist() for name, column in columns.items()}
    return [{name: column[index] for name, column in lists.items()} for index in range(count)]


def same_length(key: str, columns: Mapping[str, Any]) -> int:
    """How many rows columns have."""
    if not columns:
        raise wrong(key, "has no columns")
    shapes = {name: np.shape(column) for name, column in columns.items()}
    first = next(iter(shapes.values()))
    if len(first) != 1 or first[0] == 0 or any(shape != first for shape in shapes.values()):
        told = ", ".join(f"`{name}` {shape}" for name, shape in shapes.items())
        raise wrong(key, f"has columns of the shapes {told}, and arrays of one dimension and of the same length are needed")
    return int(first[0])


def text(key: str, value: Any, *, halved: bool = False) -> str:
    """A table as a file holds it: a line of names with units, then numbers; where complex columns may be `halved`, each is two, a real and an imaginary part."""
    columns = of(key, value)
    if columns is None:
        raise wrong(key, f"is {described(value)}, and columns of numbers are needed: a mapping such as {{\"time [s]\": times, …}}, or a frame of pandas")
    same_length(key, columns)
    parts: dict[str, tuple[str, NDArray[np.float64]]] = {}
    for name, column in columns.items():
        if any(letter in name for letter in ',;\t"\n'):
            raise wrong(f"{key}.{name}", "is the name of a column, and has a comma, a semicolon, a tab or a quote in it")
        array = np.asarray(column)
        if array.dtype.kind == "c" and halved:
            parts |= {half: (name, own) for half, own in zip(_halved(name), (array.real, array.imag), strict=True)}
        else:
            parts[name] = name, array
    checked = [numbers(f"{key}.{whole}", column, dimensions=1).tolist() for whole, column in parts.values()]
    lines = (",".join(map(repr, row)) for row in zip(*checked, strict=True))
    return "\n".join([",".join(parts), *lines, ""])


def moduli(key: str, value: Any) -> str:
    """A table of measured moduli as a file holds it: frequencies, and moduli that are complex or in two columns."""
    columns = of(key, value) or {}
    if columns:
        same_length(key, columns)
    for name, column in columns.items():
        stem, is_complex = _stem(name).lower(), np.asarray(column).dtype.kind == "c"
        if stem in _COMPLEX_MODULI and not is_complex:
            raise wrong(f"{key}.{name}", "holds real numbers; complex moduli E' + iE'' are needed, or two columns such as `E' [Pa]` and `E'' [Pa]`")
        if is_complex and stem != "e":
            raise wrong(f"{key}.{name}", "is a complex column; complex moduli are called `E`, with their unit, as in `E [Pa]`")
    return text(key, value, halved=True)


def halves(columns: Mapping[str, Any]) -> dict[str, str]:
    """The columns that the real and the imaginary part of complex ones are, and the names of these."""
    return {half: name for name, column in columns.items() if np.asarray(column).dtype.kind == "c" for half in _halved(name)}


def _halved(name: str) -> tuple[str, str]:
    """`E [Pa]` as the names of its parts, `E' [Pa]` and `E'' [Pa]`."""
    _, bracket, unit = name.partition("[")
    return f"{_stem(name)}' {bracket}{unit}".strip(), f"{_stem(name)}'' {bracket}{unit}".strip()


def _stem(name: str) -> str:
    """The name of a complex column without its star and its unit."""
    return name.partition("[")[0].strip().rstrip("*").strip()


def are_names(freedoms: Any) -> bool:
    """Whether freedoms are a list of nodes, by names, with directions, which the case itself says."""
    if not isinstance(freedoms, list | tuple):
        return False
    return any(isinstance(own, list | tuple) and own and isinstance(own[0], str) for own in freedoms)


def freedoms(key: str, value: Any) -> str:
    """The table of freedoms: node, direction and place of every row of the matrices."""
    columns = of(key, value)
    if columns is None:
        pairs = list(value) if isinstance(value, list | tuple) else []
        if not pairs or not all(isinstance(own, list | tuple) and len(own) == 2 for own in pairs):
            raise wrong(key, f"is {described(value)}, and pairs such as (1, \"x\"), or columns `node`, `direction`, `x`, `y`, `z` are needed")
        columns = {"node": [node for node, _ in pairs], "direction": [direction for _, direction in pairs]}
    if missing := {"node", "direction"} - {*columns}:
        raise wrong(key, f"lacks the column `{min(missing)}`; `node` and `direction` are needed, and `x`, `y`, `z` in m where there are places")
    count = same_length(key, columns)
    nodes = np.asarray(columns["node"])
    if nodes.dtype.kind not in "iu" or nodes.min() < 0:
        raise wrong(f"{key}.node", "holds what is no whole number; the nodes of matrices in memory are numbers, such as 1, 2, 3")
    directions = [str(own) for own in columns["direction"]]
    if strangers := {*directions} - {*_DIRECTIONS, "1", "2", "3"}:
        raise wrong(f"{key}.direction", f"has the direction {min(strangers)!r}, and \"x\", \"y\" or \"z\" is needed")
    given = [numbers(f"{key}.{axis}", columns[axis], dimensions=1) if axis in columns else np.zeros(count) for axis in _DIRECTIONS]
    table = zip(nodes.tolist(), directions, *(axis.tolist() for axis in given), strict=True)
    return "\n".join(["node,direction,x,y,z", *(f"{node},{way},{x!r},{y!r},{z!r}" for node, way, x, y, z in table), ""])


def described(value: Any) -> str:
    """What an object is, in a message."""
    if value is None:
        return "None"
    kind = type(value)
    name = kind.__qualname__ if kind.__module__ == "builtins" else f"{kind.__module__}.{kind.__qualname__}"
    return f"{'an' if name[0].lower() in 'aeiou' else 'a'} {name}"
