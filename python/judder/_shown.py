"""How results show themselves: numbers as they are, arrays by their kind and shape."""

from __future__ import annotations

import html
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import fields
from typing import Any, ClassVar


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
        return ", ".join(f"{name}({', '.join(f'{dim}: {size}' for dim, size in own.sizes.items())})" for name, own in value.data_vars.items())
    if hasattr(value, "dtype") and getattr(value, "shape", None):
        return f"{value.dtype}{[*value.shape]}"
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{name}: {told(own)}" for name, own in value.items()) + "}"
    if isinstance(value, bytes):
        return f"{len(value)} bytes"
    if isinstance(value, str | int) or value is None:
        return str(value)
    if isinstance(value, tuple | list):
        return f"[{', '.join(map(told, value))}]" if len(value) <= 2 else f"{len(value)} of {type(value[0]).__name__}"
    return repr(value)
