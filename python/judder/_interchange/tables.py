"""Results as tables: a row a point, a column for each coordinate and variable."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from judder._interchange.results import Result, Variable, flat

REASON = "why the point has no answer; of one that is only in doubt it begins with `doubtful`"
"""What the reasons of failures are."""


@dataclass(frozen=True)
class Column:
    """A column of a table."""

    name: str
    dtype: np.dtype[Any]
    """``object`` for words."""
    attributes: dict[str, Any]
    """Unit, long name, and the codes of classes."""


@dataclass(frozen=True)
class Table:
    """A table that is read block by block."""

    name: str
    columns: list[Column]
    attributes: dict[str, Any]
    """What there is to say of all of it."""
    blocks: Callable[[], Iterator[list[NDArray[Any]]]]
    """Some rows after the others, an array a column."""


def tables(result: Result) -> list[Table]:
    """The tables of a result: one for each set of dimensions, the first under its name; of a sweep its failures; its numbers."""
    sets: dict[tuple[str, ...], list[Variable]] = {}
    for variable in result.variables:
        sets.setdefault(variable.dimensions, []).append(variable)
    for name, index in result.indices.items():
        if not any(name in dimensions for dimensions in sets):
            sets[index.dimensions] = []
    found = [_of_dimensions(result, *one, is_first=not place) for place, one in enumerate(sets.items())]
    return [*found, *([_failures(result)] if result.is_sweep else []), _numbers(result)]


def _of_dimensions(result: Result, dimensions: tuple[str, ...], variables: list[Variable], *, is_first: bool) -> Table:
    """The variables of one set of dimensions."""
    indices = result.indices
    columns = [_coordinate(dimension, indices.get(dimension)) for dimension in dimensions]
    columns += [Column(variable.name, variable.dtype, variable.attributes) for variable in variables]

    def blocks() -> Iterator[list[NDArray[Any]]]:
        whole = {name: index.read() for name, index in indices.items() if name in dimensions}
        for block in result.blocks(variables or [indices[dimensions[0]]]):
            along = dict(zip(dimensions, block, strict=True))
            here = [whole[name][steps] if name in whole else np.arange(steps.start, steps.stop) for name, steps in along.items()]
            yield [*_spread(here), *(np.ravel(variable.read(block)) for variable in variables)]

    name = result.name if is_first else ".".join([result.name, *(dimensions or ("scalars",))])
    return Table(name, columns, result.attributes, blocks)


def _coordinate(dimension: str, index: Variable | None) -> Column:
    """The column of a dimension: its coordinate, or else the number of the point along it."""
    if index is None:
        return Column(dimension, np.dtype(np.int64), {"long_name": f"number along `{dimension}`, from 0"})
    return Column(dimension, index.dtype, index.attributes)


def _spread(along: list[NDArray[Any]]) -> list[NDArray[Any]]:
    """Coordinates of every point of a block, row-major."""
    grids = np.meshgrid(*along, indexing="ij", copy=False) if along else []
    return [np.ravel(grid) for grid in grids]


def _failures(result: Result) -> Table:
    """Where a sweep has no answer, or a doubtful one, and why."""
    point = Column("point", np.dtype(np.int64), {"long_name": "row of the table of the sweep, from 0"})
    keys = [Column(key, np.dtype(np.float64), dict(result.dataset[key].attrs)) for key in result.keys]
    reason = Column("reason", np.dtype(object), {"long_name": REASON})

    def blocks() -> Iterator[list[NDArray[Any]]]:
        for some in result.failures():
            yield [some.points, *some.values.values(), np.array(some.reasons, dtype=object)]

    return Table(f"{result.name}.failures", [point, *keys, reason], result.attributes, blocks)


def _numbers(result: Result) -> Table:
    """What ``summary.json`` holds of a result, a row a number."""
    text, number = np.dtype(object), np.dtype(np.float64)
    columns = [
        Column("key", text, {"long_name": "path in the results of summary.json"}),
        Column("value", number, {"long_name": "a number; 1 where something holds, 0 where not"}),
        Column("text", text, {"long_name": "a word"}),
    ]

    def blocks() -> Iterator[list[NDArray[Any]]]:
        found = list(flat(result.numbers))
        numbers = [float(value) if isinstance(value, int | float) else np.nan for _, value in found]
        words = [value if isinstance(value, str) else None for _, value in found]
        yield [np.array([key for key, _ in found], dtype=object), np.array(numbers, dtype=np.float64), np.array(words, dtype=object)]

    return Table(f"{result.name}.results", columns, result.attributes, blocks)

