"""What is said of files that hold objects of Python, said of the objects: by their keys, in columns, rows and entries as Python counts them."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

_ROW_AND_COLUMN = re.compile(r"row (\d+), column (\d+) \(from 1\)")
_ROW = re.compile(r"row (\d+) \(from 1\)")
_LINE = re.compile(r"\bline (\d+)\b")
_HEADER = re.compile(r"the header, line \d+, has the columns")
_TWICE = re.compile(r"the header, line \d+, has")
_FIELDS = re.compile(r"\bline 1 has (\d+) fields")
_NUMBER_AS_NAME = re.compile(r"\bline 1 begins with the number (\S+), but must be a header such as")
_OF_HEADER = re.compile(r" of the header, line \d+,")
_PLACE_IN_FILE = re.compile(r"(?<=: )(?:line|byte) \d+: ")
_MEND = re.compile(r"mend the file, or name another(; it is read as its ending says)?")
_KEY_ALONE = re.compile(r"`([^`]*)`")
_FIRST_ROW = 2
"""The line of a table in which its first row stands, behind the names of the columns."""


@dataclass
class HeldObject:
    """An object that a file holds."""

    key: str
    """The dotted key at which it was given."""
    columns: Mapping[str, str] = field(default_factory=dict)
    """Columns of the file that are parts of one of the object's, and the name of that."""


def said(text: str, objects: Mapping[str, HeldObject], folder: str) -> str:
    """A text in which objects go by their keys, not by the files, relative to a folder, that hold them."""
    there = [name for name in objects if name in text]
    # the longest first: a name may begin as another does
    for name in sorted(there, key=len, reverse=True):
        own = objects[name]
        path = rf"(?:{re.escape(folder)}[\\/])?{re.escape(name)}"
        text = re.sub(rf"[`\"']?{path}[`\"']?", lambda _, key=own.key: f"`{key}`", text)  # type: ignore[misc]
        text = _of_table(text) if name.endswith(".csv") else _PLACE_IN_FILE.sub("", text)
        for part, whole in own.columns.items():
            text = text.replace(f"`{part}`", f"`{whole}`").replace(f"`{whole}`, `{whole}`", f"`{whole}`")
    text = _MEND.sub("mend the object", text)
    text = _ROW_AND_COLUMN.sub(lambda found: f"[{int(found[1]) - 1}, {int(found[2]) - 1}]", text)
    return _ROW.sub(lambda found: f"row {int(found[1]) - 1} (from 0)", text)


def _of_table(text: str) -> str:
    """The same of columns and rows, where it is of the header and lines of a file."""
    text = _TWICE.sub("it has", _HEADER.sub("it has the columns", text))
    text = _FIELDS.sub(r"it has \1 columns", text)
    text = _NUMBER_AS_NAME.sub(r"its first column is called `\1`, and names of columns are needed, such as", text)
    text = _OF_HEADER.sub("", text).replace("sort the lines by", "sort the rows by")
    return _LINE.sub(lambda found: f"row {int(found[1]) - _FIRST_ROW} (from 0)", text)


def said_fields(fields: Mapping[str, Any], say: Callable[[str], str]) -> dict[str, Any]:
    """The fields of an error, said likewise."""
    return {name: _said_field(own, say) for name, own in fields.items()}


def _said_field(own: Any, say: Callable[[str], str]) -> Any:
    if isinstance(own, list):
        return [_said_field(item, say) for item in own]
    if not isinstance(own, str | Path):
        return own
    words = say(str(own))
    if words == str(own):
        return own
    # a field that is the path of a file is the key alone
    return key[1] if (key := _KEY_ALONE.fullmatch(words)) else words
