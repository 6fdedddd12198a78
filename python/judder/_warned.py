"""Warnings, told of the line that has called judder."""

from __future__ import annotations

import sys
import warnings
from types import FrameType

from judder._said_in_python import in_python
from judder.errors import JudderWarning


def warn(message: str) -> None:
    """Warns of what has to be known before a result is trusted, where judder was called from."""
    frame: FrameType | None = sys._getframe()
    level = 0
    while frame is not None and is_own(frame):
        level, frame = level + 1, frame.f_back
    warnings.warn(in_python(message), JudderWarning, stacklevel=level + 1)


def is_own(frame: FrameType) -> bool:
    """Whether code of this package runs in a frame."""
    return str(frame.f_globals.get("__name__", "")).partition(".")[0] == __name__.partition(".")[0]
