"""How results show themselves: numbers as they are, arrays by their kind and shape."""

from __future__ import annotations

import html
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import fields
from typing import Any, ClassVar

from judder._numpy import np

_MOST = 8
"""Parts of a thing that are shown."""


class Shown:
    """A dataclass that shows its fields, but those that are not for reading, in a line, and in a notebook in a table."""

    __dataclass_fields__: ClassVar[dict[str, Any]]

    def _told(self) -> Iterator[tuple[str, str]]:
        """The names of the fields, and what is shown of each."""
        for field in fields(self):
            if field.repr:
                yield field.name, told(getattr(self, field.name))

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{name}={own}' for name, own in self._told())})"

    def _repr_html_(self) -> str:
        return page(type(self).__name__, self._told())


def page(heading: str, rows: Iterable[tuple[str, str]]) -> str:
    """A heading and a table of two columns, for a notebook."""
    cells = "".join(f"<tr><th>{html.escape(name)}</th><td>{html.escape(own)}</td></tr>" for name, own in rows)
    return f"<h4>{html.escape(heading)}</h4><table>{cells}</table>"


def told(value: Any) -> str:
    """A value in a few words."""
    if hasattr(value, "data_vars"):
        return _named([(str(name), _of_variable(own)) for name, own in value.data_vars.items()])
    if hasattr(value, "dtype") and getattr(value, "shape", None):
        return f"{value.dtype}{[*value.shape]}{_span(value)}"
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, Mapping):
        return "{" + _named([(str(name), f": {told(own)}") for name, own in value.items()]) + "}"
    if isinstance(value, bytes):
        return f"{len(value)} bytes"
    if isinstance(value, str | int) or value is None:
        return str(value)
    if isinstance(value, tuple | list):
        return f"[{', '.join(map(told, value))}]" if len(value) <= 2 else _of_many(value)
    return repr(value)


def verdict(numbers: Mapping[str, Any]) -> str:
    """What the numbers of an analysis say of stability, in a few words; nothing where they say nothing."""
    if isinstance(own := numbers.get("verdict"), str):
        return own
    if isinstance(count := numbers.get("unstable"), int):
        # of those that were sought: another may grow
        return f"{count or 'none'} unstable of the modes found"
    if isinstance(share := numbers.get("unstable_fraction"), float):
        return f"unstable at {100 * share:.3g} % of the points"
    rates = numbers.get("growth_rate")
    if isinstance(rates, float):
        rates = [rates]
    if not isinstance(rates, list) or not all(isinstance(rate, int | float) for rate in rates) or not rates:
        return ""
    return f"growth_rate > 0 at {sum(rate > 0.0 for rate in rates)} of {len(rates)}"


def _named(parts: Sequence[tuple[str, str]]) -> str:
    """Names with what is told of each, the first of them where there are many."""
    more = f", and {len(parts) - _MOST} more" if len(parts) > _MOST else ""
    return ", ".join(f"{name}{own}" for name, own in parts[:_MOST]) + more


def _of_variable(variable: Any) -> str:
    """The dimensions of a variable of a dataset, its range and its unit."""
    sizes = ", ".join(f"{dim}: {size}" for dim, size in variable.sizes.items())
    units = variable.attrs.get("units", "1")
    # what is not in memory is not read for this
    span = _span(variable.values) if isinstance(getattr(variable.variable, "_data", None), np.ndarray) else ""
    return f"({sizes}){span}{'' if not span or units == '1' else f' {units}'}"


def _of_many(values: Sequence[Any]) -> str:
    """How many there are, of numbers between which."""
    are_numbers = all(isinstance(own, int | float) and not isinstance(own, bool) for own in values)
    if are_numbers and (span := _span(np.array(values, dtype=float))):
        return f"{span.strip()} ({len(values)} values)"
    return f"{len(values)} of {type(values[0]).__name__}"


def _span(values: Any) -> str:
    """Between which numbers those of an array lie; of what is no real number nothing."""
    array = np.asarray(values)
    finite = array[np.isfinite(array)] if array.dtype.kind in "fiu" else array[:0]
    if not finite.size:
        return ""
    low, high = f"{finite.min():.6g}", f"{finite.max():.6g}"
    return f" {low}" if low == high else f" {low} … {high}"
