"""What the classes of :mod:`judder.models` have in common: a case that is composed, and analyses of it that are computed on their own."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from judder import _judder, _memory, _toml, _warned
from judder._objects import CaseSource
from judder._shown import Shown, page
from judder.errors import StudyError
from judder.progress import Progress
from judder.study import CaseLike, Study, check

if TYPE_CHECKING:
    import xarray


_MOST_SHOWN = 200
"""Letters of a case in the words for it."""


def _short(text: str) -> str:
    return text if len(text) <= _MOST_SHOWN else text[:_MOST_SHOWN] + "…"


@dataclass(frozen=True, eq=False, repr=False)
class Result(Shown):
    """What an analysis leaves."""

    data: xarray.Dataset
    """Every array, with coordinates, units and long names: the dataset that a study has of the analysis, in memory."""
    numbers: Mapping[str, Any]
    """What ``summary.json`` shows of it: thresholds, fractions, errors."""
    checks: tuple[Mapping[str, Any], ...]
    """The comparisons that were made: ``name``, ``compared``, the largest disagreement ``figure`` and its ``limit``."""
    warnings: tuple[str, ...]
    """What has to be known before the numbers are trusted."""
    files: Mapping[str, bytes]
    """Tables, sound, laws, fields, as a study folder has them."""


class Model:
    """A case of a model: what all classes of :mod:`judder.models` have in common.

    The keys of a case file are keyword arguments: tables are mappings, lists are sequences, quantities are texts with their units, and where a key names a
    file, an object may stand: a sparse matrix, an array, a mesh of meshio, columns of numbers, a law. A key that is ``None``, in a table too, counts as
    not given; in a case that is a mapping and in ``set`` it is refused. What is given
    is put over ``case``, key by key. An analysis is a method; what the case has of analyses stays as it is, and is computed where it is taken up.
    """

    _name: ClassVar[str]

    def __init__(self, case: CaseLike | None, set: Mapping[str, Any] | None, keys: Mapping[str, Any]) -> None:
        self._source = CaseSource({"model": self._name} if case is None else case)
        arguments, changed = dict(_flat(self._source.whole(keys, self._name, without_none=True))), self._source.whole(set or {}, self._name)
        changes = {**arguments, **changed}
        self._source.arguments = arguments.keys() - changed.keys()
        self._case = self._source.given, self._name, _toml.overrides(changes)

    def __repr__(self) -> str:
        case, _, changes = self._case
        begun = [case] if isinstance(case, str) else []
        text = self._source.plain(", ".join([*begun, *changes]))
        return f"{type(self).__name__}({_short(text)})"

    def _repr_html_(self) -> str:
        case, _, changes = self._case
        begun = [("case", case)] if isinstance(case, str) else []
        rows = [*begun, *((key, own) for key, _, own in (change.partition("=") for change in changes))]
        return page(type(self).__name__, ((key, _short(self._source.plain(own))) for key, own in rows))

    @property
    def text(self) -> str:
        """The case as the text of a case file, which :func:`judder.run` takes; the files that it names stand in it by their whole paths, those of objects
        in memory as long as this process goes on.

        Raises:
            CaseError: the case is wrong, or of another model.
        """
        self._source.hold()
        return self._text()

    def _text(self) -> str:
        with self._source.told():
            return _judder.text_of_case(self._case)

    def check(self) -> dict[str, Any]:
        """What the case means, as of :func:`judder.check`.

        Raises:
            CaseError: the case is wrong, or of another model.
        """
        return check(self._text())

    def _computed(self, kind: str, keys: Mapping[str, Any], threads: int | None, progress: Progress | None) -> Result:
        """Computes an analysis of this kind; keys that are ``None`` are left out, those of its tables too.

        Raises:
            CaseError: case or analysis are wrong, also where only the run could see it.
            KeyboardInterrupt: Ctrl-C.
            JudderError: there is no result.
        """
        with self._source.told():
            given = _toml.document(self._source.whole(keys, self._name, ("analysis", kind), without_none=True))
            name, held = _judder.held_analysis(self._case, kind, given, threads=threads, progress=progress)
            if held is not None:
                compiled, messages, refused = held
                for _, error in refused:
                    raise error
                study = Study._held(compiled)
            else:
                owner = _memory.TemporaryFolder()
                name, messages = _judder.computed_analysis(
                    self._case, kind, given, folder=str(owner.folder), threads=threads, progress=progress
                )
                study = Study._owned(owner)
            if name in study.failures:
                raise StudyError(study.failures[name], "NoResult", {"name": name})
        for message in messages:
            _warned.warn(self._source.said(message))
        return Result(
            data=study[name].load(),
            numbers=study.results[name],
            checks=tuple(study.summary["study"]["checks"].get(name, ())),
            warnings=tuple(map(self._source.said, study.warnings[name])),
            files=study.files,
        )


def _flat(keys: Mapping[str, Any]) -> Iterator[tuple[str, Any]]:
    """The keys, those of a table one by one."""
    for key, own in keys.items():
        if isinstance(own, Mapping):
            yield from ((f"{key}.{inner}", value) for inner, value in own.items())
        else:
            yield key, own
