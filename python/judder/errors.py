"""Exceptions and warnings of judder: one class a cause, with the fields that let a caller act."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from judder._said_in_python import fields_in_python, in_python

__all__ = [
    "ArgumentError",
    "CaseError",
    "ContactError",
    "FaultError",
    "FileError",
    "InputError",
    "Interrupted",
    "JudderError",
    "JudderWarning",
    "LawError",
    "MissingFileError",
    "NumberError",
    "OscillatorError",
    "PackageError",
    "RewrittenError",
    "SlidingError",
    "StoreError",
    "StructureError",
    "StudyError",
    "SystemRefusal",
    "UnknownResultError",
]

OF_TABLES = "tables"
"""What errors call a case whose tables come from Python."""
OF_CHANGES = "set"
"""What errors call changed keys."""
OF_ARGUMENTS = "argument"
"""What errors call keys that are given as arguments."""
_OPTION = "--set"
"""What the command calls changed keys."""


class JudderError(Exception):
    """Why there is no result.

    The text of the exception says what is wrong and what would be right. The numbers in it are attributes besides, by the names
    that ``fields`` lists: ``error.indentation``, ``error.limit``.

    >>> import judder
    >>> try:
    ...     judder.oscillator.point(velocity=-1.0)
    ... except judder.JudderError as error:
    ...     error.cause, error.key
    ('OutOfRange', 'operation.velocity')
    """

    cause: str
    """The kind of error within its class, such as ``"NoEquilibrium"``."""
    fields: Mapping[str, Any]
    """What a caller can act on, by name."""

    def __init__(self, message: str, cause: str = "", fields: Mapping[str, Any] | None = None) -> None:
        super().__init__(in_python(message))
        self.cause = cause
        self.fields = fields_in_python(fields or {})

    def __getattr__(self, name: str) -> Any:
        fields = self.__dict__.get("fields", {})
        if name in fields:
            return fields[name]
        raise AttributeError(f"{type(self).__name__} has no attribute {name!r}")

    def __reduce__(self) -> tuple[type[JudderError], tuple[str, str, dict[str, Any]]]:
        return type(self), (str(self), self.cause, dict(self.fields))


class InputError(JudderError, ValueError):
    """An argument that cannot be: its shape, its kind of numbers, its range."""

    argument: str
    """The name of the argument."""


class ArgumentError(InputError, TypeError):
    """An argument that a function does not know, one that it lacks, or a value of a wrong type; a ``TypeError`` too, as of any function."""


class NumberError(InputError, OverflowError):
    """A number that does not fit where it is needed, such as a negative count; an ``OverflowError`` too."""


class CaseError(JudderError, ValueError):
    """A case, or a key given as an argument, that is wrong; the traceback shows place and help besides."""

    file: str
    """The file, ``set`` for a changed key, ``argument`` for a key that was given as one, or ``tables`` for those that a program gives as a case."""
    line: int | None
    """The line, from 1; ``None`` where the error has no place in a file."""
    column: int | None
    """The column, from 1."""
    text: str
    """The words of the case that are to blame."""
    key: str | None
    """The dotted path of the key that is to blame, items of lists by their names or positions; ``None`` where there is none."""
    help: str | None
    """What would be right."""
    others: list[str]
    """What else is wrong with the same case, in the order of its text."""

    def __init__(self, message: str, cause: str = "", fields: Mapping[str, Any] | None = None) -> None:
        own = dict(fields or {})
        if own.get("file") == _OPTION:
            own["file"] = OF_CHANGES
        is_no_file = own.get("file") in (OF_TABLES, OF_CHANGES, OF_ARGUMENTS)
        if is_no_file:
            own.update(line=None, column=None)
        super().__init__(message, cause, own)
        if is_no_file:
            words = [word for word in (self.key, self.text) if word and not word.startswith("[")]
            if words:
                self.add_note(f"at {': '.join(dict.fromkeys(words))}")
        elif self.fields.get("line") is not None:
            self.add_note(f"in {self.file}, line {self.line}, column {self.column}: {self.text}")
        if self.fields.get("help"):
            self.add_note(f"help: {self.help}")
        for other in self.fields.get("others") or ():
            self.add_note(f"besides: {other}")


class OscillatorError(JudderError):
    """An oscillator without an answer: a group out of range, no steady sliding, several."""


class ContactError(JudderError):
    """A contact without an answer: too deep, a domain too small, a material that is none."""


class LawError(ContactError):
    """A contact law that cannot be made or read."""


class StructureError(JudderError):
    """A structure without an answer."""


class SlidingError(JudderError):
    """Two structures that cannot slide on each other, or whose march cannot go on."""


class StoreError(JudderError):
    """A study folder that cannot be written or read."""


class FileError(StoreError, OSError):
    """A file that the system does not read or write: an ``OSError`` too, as of ``open``."""

    path: str
    """The file."""
    number: int | None
    """What the system calls the error, ``errno``; ``None`` where it has no number."""
    errno: int | None
    """The same, as Python calls it."""
    filename: Any
    """The file, as Python calls it."""

    def __init__(self, message: str, cause: str = "File", fields: Mapping[str, Any] | None = None) -> None:
        super().__init__(message, cause, fields)
        self.errno, self.filename = self.fields.get("number"), self.fields.get("path")

    def __str__(self) -> str:
        return str(self.args[0])


class MissingFileError(FileError, FileNotFoundError):
    """A file that is not there: a ``FileNotFoundError`` too."""


class SystemRefusal(JudderError, OSError):
    """The system does not give what a call needs, such as threads; an ``OSError`` too."""


class FaultError(JudderError, RuntimeError):
    """A fault of judder itself; a ``RuntimeError`` too."""


class RewrittenError(StoreError):
    """A study that was opened before another run replaced it in its folder: what is there now is not what the study has told."""

    path: str
    """The study folder."""
    name: str
    """The analysis or sweep."""
    expected: str
    """The hash of all that its results depend on, as the study has it."""
    found: str | None
    """The hash of what is there now; ``None`` where nothing is."""

    def __init__(self, message: str, cause: str = "Rewritten", fields: Mapping[str, Any] | None = None) -> None:
        super().__init__(message, cause, fields)


def rewritten(folder: str, name: str, expected: str, found: str | None) -> RewrittenError:
    """The error of a study whose result another run has replaced."""
    now = "is gone" if found is None else f"is that of another run (its hash is {found}"
    own = f"; that of this study was {expected}" if found is None else f", that of this study {expected})"
    message = (
        f"{folder}: `{name}` {now}{own}: the folder was rewritten after this study was opened; "
        "judder.load_study opens what is there now, and a run with an output of its own leaves it alone"
    )
    return RewrittenError(message, fields={"path": folder, "name": name, "expected": expected, "found": found})


class StudyError(JudderError):
    """A study without a result."""


class UnknownResultError(StudyError, KeyError):
    """A name under which a study has no result: a ``KeyError`` too, as of any mapping."""

    name: str
    """The name."""
    known: list[str]
    """The names of the results that there are."""

    def __str__(self) -> str:
        return str(self.args[0])


class PackageError(JudderError, ImportError):
    """A Python package that this needs and that is not here; the message says what to install."""

    package: str
    """Its name."""
    extra: str
    """The extra of judder that brings it, ``judder[extra]``; empty where none does."""


class Interrupted(KeyboardInterrupt):
    """Ctrl-C; what was done is kept, and the same call goes on from there."""


class JudderWarning(UserWarning):
    """What has to be known before a result is trusted."""
