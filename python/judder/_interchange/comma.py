"""Tables as comma-separated values, for spreadsheets."""

from __future__ import annotations

import csv
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from judder._interchange.results import chosen, words
from judder._interchange.tables import Column, Table, tables
from judder._interchange.whole import Files, files

if TYPE_CHECKING:
    from judder.progress import Progress
    from judder.study import Study

_FORMULAS = ("=", "+", "-", "@", "\t", "\r")
"""How a text begins that a spreadsheet takes for a formula."""
_SAID = ("units", "long_name", "flag_values", "flag_meanings")


def to_csv(study: Study, folder: Path, only: Iterable[str], progress: Progress | None) -> list[Path]:
    """A file a table, and for each result one that says what the columns are."""
    with files(folder) as written:
        for result in chosen(study, only, progress):
            own = tables(result)
            for table in own:
                _write(table, written)
            _write_columns(f"{result.name}.columns", own, written)
    return written.paths


def _write(table: Table, written: Files) -> None:
    with written.new(f"{table.name}.csv").open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(_head(column) for column in table.columns)
        for block in table.blocks():
            writer.writerows(zip(*map(_cells, block), strict=True))


def _head(column: Column) -> str:
    """The name, with the unit where there is one, as in the tables of a study folder."""
    units = column.attributes.get("units", "")
    return _guarded(column.name if units in ("", "1") else f"{column.name} [{units}]")


def _guarded(text: str) -> str:
    """After an apostrophe, by which a spreadsheet takes it for a text, where it would take it for a formula; numbers are numbers."""
    if not text.startswith(_FORMULAS):
        return text
    try:
        float(text)
    except ValueError:
        return f"'{text}"
    return text


def _cells(values: NDArray[Any]) -> list[Any]:
    """Numbers that are written with the fewest digits that read back as the same; an empty cell for NaN and for no word."""
    cells: list[Any] = [_guarded(cell) if isinstance(cell, str) else cell for cell in values.tolist()]
    if values.dtype.kind == "f":
        for place in np.flatnonzero(np.isnan(values)).tolist():
            cells[place] = None
    return cells


def _write_columns(name: str, own: list[Table], written: Files) -> None:
    def rows() -> Iterator[list[str]]:
        for table in own:
            for column in table.columns:
                told = [table.name, column.name, *(words(column.attributes.get(what, "")) for what in _SAID)]
                yield [*map(_guarded, told)]

    with written.new(f"{name}.csv").open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["table", "column", *_SAID])
        writer.writerows(rows())
