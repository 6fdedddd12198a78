"""Words of the command line in messages, as Python has them: the libraries that both are made of speak to a terminal."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

_WORDS = (
    (r"`judder new` prints a case file to start from", "`judder.new()` gives the text of a case to start from"),
    (r"write the dotted key, `=`, the value: --set .*", 'write the dotted key, as in {"operation.velocity": "30 mm/s"}'),
    (r"`--set ([^`]*)` is not of the form key=value", r"`\1` has no dotted key"),
    (r"`judder run CASE\.toml -o ([^`]*)`", r"`judder.run(case, output=\1)`"),
    (r"`judder (\w+) --fresh`", r"`judder.\1(…, fresh=True)`"),
    (r"`judder run --dry-run`", "`judder.sweep.plan`"),
    (r"`judder point( [^`]*)?`", "`judder.oscillator.point`"),
    (r"`judder (\w+)( [^`]*)?`", r"`judder.\1`"),
    (r'with --memory ("[^"]*")', r"with `judder.limit_memory(\1)`"),
    (r"--memory gives", "`judder.limit_memory` gives"),
    (r"with --fresh\b", "with `fresh=True`"),
    (r"`--(\w+)`", r"`\1`"),
    (r"(?<!\S)-o(?= names\b|,|;|$)", "`output`"),
)
"""What a terminal is told, and what a program is; the first that fit come first."""
_MAY_BE = re.compile(r"`judder |--|(?<!\S)-o\b")
_SENTENCES = ("help", "reason", "damage", "others")
"""Fields of errors that are parts of messages."""


def in_python(text: str) -> str:
    """A message in words of Python."""
    if _MAY_BE.search(text):
        for of_command, of_python in _WORDS:
            text = re.sub(of_command, of_python, text)
    return text


def fields_in_python(fields: Mapping[str, Any]) -> dict[str, Any]:
    """The fields of an error with their sentences in words of Python."""
    return {name: _sentences(own) if name in _SENTENCES else own for name, own in fields.items()}


def _sentences(own: Any) -> Any:
    if isinstance(own, list):
        return [*map(_sentences, own)]
    return in_python(own) if isinstance(own, str) else own
