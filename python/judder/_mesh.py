"""Meshes in memory, of meshio or arrays, as the input deck that judder reads."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from judder._columns import described, numbers, wrong
from judder._numpy import np

if TYPE_CHECKING:
    from numpy.typing import NDArray

# names of meshio: the type of the deck, nodes, dimension
_TYPES = {
    "quad": ("CPS4I", 4, 2),
    "quad8": ("CPS8", 8, 2),
    "triangle6": ("CPS6", 6, 2),
    "hexahedron": ("C3D8I", 8, 3),
    "hexahedron20": ("C3D20", 20, 3),
    "tetra10": ("C3D10", 10, 3),
}
_LOWER = {"vertex": 0, "line": 1, "line3": 1, "triangle": 2}
_A_LINE = 16
_NEEDS = 'a mesh of meshio, or {"points": array, "cells": {"quad": array}, "point_sets": {name: places}} is needed'


@dataclass(frozen=True)
class _Parts:
    """A mesh, whatever it came from."""

    points: NDArray[np.float64]
    cells: Sequence[tuple[str, NDArray[np.int64]]]
    point_sets: Mapping[str, Any]
    cell_sets: Mapping[str, Sequence[Any]]


def deck(key: str, mesh: Any, materials: Any) -> str:
    """The deck of a mesh; elements of a set of cells that `materials` name are a block of this name."""
    parts = _parts(key, mesh)
    dimension = max(_dimension(key, kind) for kind, _ in parts.cells)
    if dimension < 2:
        raise wrong(key, f"has no elements; known are {', '.join(_TYPES)}")
    named = [*materials] if isinstance(materials, Mapping) else []
    lines = ["*NODE", *(f"{label},{x!r},{y!r},{z!r}" for label, (x, y, z) in enumerate(parts.points.tolist(), 1))]
    numbers_of: dict[int, NDArray[np.int64]] = {}
    count = 0
    for index, (kind, nodes) in enumerate(parts.cells):
        if _dimension(key, kind) != dimension:
            continue
        if kind not in _TYPES:
            raise wrong(key, f"has cells `{kind}`, which judder does not have; known are {', '.join(_TYPES)}")
        numbers_of[index] = np.arange(count + 1, count + 1 + len(nodes))
        count += len(nodes)
        lines += _elements(_TYPES[kind][0], numbers_of[index], nodes + 1, _blocks(parts, index, len(nodes), named))
    lines += _sets(key, parts, numbers_of)
    return "\n".join([*lines, ""])


def _elements(name: str, labels: NDArray[np.int64], nodes: NDArray[np.int64], blocks: Sequence[str]) -> Iterator[str]:
    """Elements of a type, those of a block behind a keyword of its own."""
    own = np.array(blocks)
    for block in dict.fromkeys(blocks):
        yield f"*ELEMENT, TYPE={name}" + (f', ELSET="{block}"' if block else "")
        of_block = own == block
        for row in np.column_stack([labels[of_block], nodes[of_block]]).tolist():
            yield from _lines(row)


def _blocks(parts: _Parts, index: int, count: int, named: Iterable[str]) -> list[str]:
    """The block of each cell: the first of the named sets that it is in."""
    blocks = [""] * count
    for name in named:
        for cell in _members(parts.cell_sets.get(name), index):
            blocks[cell] = blocks[cell] or name
    return blocks


def _members(of_blocks: Sequence[Any] | None, index: int) -> list[int]:
    """The cells of a block of cells that are in a set."""
    own = None if of_blocks is None or index >= len(of_blocks) else of_blocks[index]
    return [] if own is None else [int(cell) for cell in own]


def _sets(key: str, parts: _Parts, labels: Mapping[int, NDArray[np.int64]]) -> Iterator[str]:
    """Sets of nodes, those of cells of a lower dimension among them, and sets of elements."""
    nodes = {name: _places(f"{key}.point_sets.{name}", places, len(parts.points)) for name, places in parts.point_sets.items()}
    elements: dict[str, list[int]] = {}
    for name, of_blocks in parts.cell_sets.items():
        for index, (kind, own) in enumerate(parts.cells):
            cells = _members(of_blocks, index)
            if cells and max(cells) >= len(own) or cells and min(cells) < 0:
                raise wrong(f"{key}.cell_sets.{name}", f"names a cell that the {len(own)} cells `{kind}` do not have")
            if index in labels:
                elements.setdefault(name, []).extend(labels[index][cells].tolist())
            elif cells:
                nodes[name] = np.union1d(nodes.get(name, np.zeros(0, dtype=np.int64)), own[cells])
    seen: set[str] = set()
    of_nodes = [("NSET", name, [int(place) + 1 for place in own]) for name, own in nodes.items()]
    of_elements = [("ELSET", name, own) for name, own in elements.items() if own]
    for keyword, name, places in [*of_nodes, *of_elements]:
        if not name or any(letter in name for letter in ',"=\n'):
            raise wrong(key, f"has a set named {name!r}; a name has no comma, quote or =")
        if f"{keyword} {name.upper()}" in seen:
            raise wrong(key, f"has two sets named {name!r}: capitals and small letters are the same")
        seen.add(f"{keyword} {name.upper()}")
        yield f'*{keyword}, {keyword}="{name}"'
        yield from _lines(places, ends=True)


def _places(key: str, given: Any, count: int) -> NDArray[np.int64]:
    """Places of points from 0, or a mask of all."""
    places = np.asarray(given)
    if places.dtype == bool and places.shape == (count,):
        places = np.flatnonzero(places)
    if places.ndim != 1 or places.dtype.kind not in "iu" and places.size:
        raise wrong(key, "must hold the places of points, whole numbers from 0")
    if places.size and not 0 <= places.min() <= places.max() < count:
        raise wrong(key, f"names a point that the {count} points do not have; they are counted from 0")
    return places.astype(np.int64)


def _lines(row: Sequence[int], *, ends: bool = False) -> Iterator[str]:
    """Numbers on lines of a deck; one that goes on ends with a comma, unless every line stands for itself."""
    for first in range(0, len(row), _A_LINE):
        goes_on = not ends and first + _A_LINE < len(row)
        yield ",".join(map(str, row[first : first + _A_LINE])) + ("," if goes_on else "")


def _dimension(key: str, kind: str) -> int:
    if kind in _TYPES:
        return _TYPES[kind][2]
    return _LOWER.get(kind, 3)


def _parts(key: str, mesh: Any) -> _Parts:
    """What a mesh has, checked."""
    told = mesh if isinstance(mesh, Mapping) else {name: getattr(mesh, name, None) for name in ("points", "cells", "point_sets", "cell_sets")}
    if told.get("points") is None or told.get("cells") is None:
        raise wrong(key, f"is {described(mesh)} without points or cells, and {_NEEDS}")
    points = numbers(f"{key}.points", told["points"], dimensions=2)
    if points.shape[1] not in (2, 3):
        raise wrong(f"{key}.points", f"has {points.shape[1]} numbers a point, and two or three are needed")
    cells = [_cells(key, kind, nodes, len(points)) for kind, nodes in _pairs(key, told["cells"])]
    if not cells:
        raise wrong(f"{key}.cells", f"is empty; known are {', '.join(_TYPES)}")
    padded = np.hstack([points, np.zeros((len(points), 3 - points.shape[1]))])
    cell_sets = {str(name): own for name, own in (told.get("cell_sets") or {}).items()}
    groups = {} if isinstance(mesh, Mapping) else _physical_groups(mesh)
    return _Parts(padded, cells, {str(name): own for name, own in (told.get("point_sets") or {}).items()}, {**groups, **cell_sets})


def _pairs(key: str, cells: Any) -> Iterator[tuple[str, Any]]:
    """The kinds of cells with their nodes: of blocks of meshio, of pairs, of a mapping."""
    if isinstance(cells, Mapping):
        yield from ((str(kind), nodes) for kind, nodes in cells.items())
        return
    for block in cells:
        if hasattr(block, "type") and hasattr(block, "data"):
            yield block.type, block.data
        elif isinstance(block, tuple | list) and len(block) == 2:
            yield str(block[0]), block[1]
        else:
            raise wrong(f"{key}.cells", f"has {described(block)}, and pairs of a kind and an array are needed, such as (\"quad\", nodes)")


def _cells(key: str, kind: str, nodes: Any, count: int) -> tuple[str, NDArray[np.int64]]:
    """Cells of a kind, whose nodes are there."""
    array, place = np.asarray(nodes), f"{key}.cells.{kind}"
    wanted = _TYPES[kind][1] if kind in _TYPES else None
    if array.ndim != 2 or array.dtype.kind not in "iu" or array.size == 0:
        raise wrong(place, "must hold the places of points, whole numbers from 0, a row a cell")
    if wanted is not None and array.shape[1] != wanted:
        raise wrong(place, f"has {array.shape[1]} nodes a cell, and {wanted} are needed")
    if array.min() < 0 or array.max() >= count:
        raise wrong(place, f"names a point that the {count} points do not have; they are counted from 0")
    return kind, array.astype(np.int64)


def _physical_groups(mesh: Any) -> dict[str, list[Any]]:
    """The physical groups of Gmsh, which meshio keeps as numbers of cells beside names of the numbers."""
    tags = (getattr(mesh, "cell_data", None) or {}).get("gmsh:physical")
    names = getattr(mesh, "field_data", None) or {}
    if tags is None:
        return {}
    dimensions = [_LOWER.get(block.type, _TYPES.get(block.type, ("", 0, 3))[2]) for block in mesh.cells]
    return {
        str(name): [np.flatnonzero(np.asarray(own) == tag) if of == dimension else [] for own, of in zip(tags, dimensions, strict=True)]
        for name, (tag, dimension) in names.items()
    }
