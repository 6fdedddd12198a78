"""Where the results of a study lie: in memory, in its folder, or in a temporary one."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from judder import _judder, _memory, _places, _summaries
from judder._said_in_python import in_python
from judder.errors import StudyError

if TYPE_CHECKING:
    from typing import Self

    from judder._objects import CaseSource
    from judder._places import RemotePath
    from judder.study import Study


class Placed:
    """A study, as far as it has a place."""

    summary: dict[str, Any]
    """The content of ``summary.json``."""
    _place: Path | RemotePath | None
    """Where its results lie; none of a study in memory."""
    _compiled: _judder.HeldStudy | None = None
    _source: CaseSource | None = None
    """The case of a study in memory, whose objects go with it into a folder."""
    _owner: _memory.TemporaryFolder | None = None
    """What its folder lasts as long as, where nobody has named one."""

    def __init__(self, folder: str | os.PathLike[str], storage_options: Mapping[str, Any] | None = None) -> None:
        self._place = _places.place(folder, storage_options)
        self.summary = _summaries.read(self._place)

    @classmethod
    def _held(cls, held: _judder.HeldStudy, source: CaseSource | None = None) -> Self:
        """A study in memory, with its case where that may be saved with it."""
        study = cls.__new__(cls)
        study._place, study._compiled, study._source, study.summary = None, held, source, json.loads(held.summary)
        return study

    @classmethod
    def _owned(cls, owner: _memory.TemporaryFolder) -> Self:
        """A study in a temporary folder."""
        study = cls(owner.folder)
        study._owner = owner
        return study

    def _said(self, text: str) -> str:
        """What the summary says of the case in words of Python, of a study in memory of the objects that the case has."""
        return in_python(text if self._source is None else self._source.said(text))

    @property
    def folder(self) -> Path | RemotePath:
        """The study folder.

        Raises:
            StudyError: the study has none, since it was run without ``output``.
        """
        if self._place is None or self._owner is not None:
            raise StudyError("this study was run without `output` and has no folder; `study.save(folder)` writes one", "NoFolder")
        return self._place

    def __fspath__(self) -> str:
        """The path of its folder, so that a case can begin where this study ended: ``start = {"study": study, ...}``; of a study without one that of a
        temporary folder, which lasts as long as the study."""
        return str(self._temporary().folder) if self._has_no_folder else _places.writable(self.folder)

    @property
    def files(self) -> dict[str, bytes]:
        """What the study has beside arrays, summary and report, by the paths in its folder: tables, sounds, laws, fields."""
        if self._compiled is not None:
            return dict(self._compiled.files())
        return {name: path.read_bytes() for name, path in _places.beside(self._stored)}

    def save(self, folder: str | os.PathLike[str]) -> Self:
        """Writes the study into a folder as a run leaves it there, with figures and report; a later run into it takes its results up.

        Args:
            folder: where it goes; it is made where there is none.

        Returns:
            The study in that folder.

        Raises:
            StoreError: the folder cannot be written, holds something else, or the study is in an object store.
        """
        target = Path(_places.writable(folder))
        if self._compiled is not None:
            self._write(self._compiled, target, report=True)
        else:
            _places.copy(self._stored, target)
            _judder.copied_study(str(target))
        return type(self)(target)

    def _write(self, held: _judder.HeldStudy, folder: Path, *, report: bool) -> None:
        """Writes what is in memory."""
        held.save(str(folder), report)
        if self._source is not None:
            self._source.keep(folder)

    def _temporary(self) -> _memory.TemporaryFolder:
        """The temporary folder of a study without one of its own, which lasts as long as the study."""
        if self._owner is None:
            owner = _memory.TemporaryFolder()
            if self._compiled is not None:
                self._write(self._compiled, owner.folder, report=False)
            self._owner = owner
        return self._owner

    @property
    def _stored(self) -> Path | RemotePath:
        """Where its results lie, of a study that is not in memory."""
        return self.folder if self._place is None else self._place

    def __reduce__(self) -> tuple[Any, ...]:
        if not self._has_no_folder:
            return _copied, (type(self), self._place, self.summary)
        return _restored, (type(self), _memory.packed(self._temporary().folder), self.summary)

    @property
    def _has_no_folder(self) -> bool:
        """Whether it was run without `output`."""
        return self._place is None or self._owner is not None


def _copied(kind: type[Study], place: Path | RemotePath, summary: dict[str, Any]) -> Study:
    """A study of which a copy was made, with what it knew of its folder."""
    study = kind.__new__(kind)
    study._place, study.summary = place, summary
    return study


def _restored(kind: type[Study], content: bytes, summary: dict[str, Any]) -> Study:
    """A study without a folder of which a copy was made."""
    owner = _memory.unpacked(content)
    study = _copied(kind, owner.folder, summary)
    study._owner = owner
    return study
