"""Whole cases: run, check, and what a run leaves."""

from __future__ import annotations

import html
import json
import os
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final, Literal, TypeAlias

from judder import _arguments, _judder, _memory, _places, _shown, _si, _summaries, _swept, _warned
from judder._exported import Exported
from judder._objects import CaseSource
from judder._placed import Placed
from judder._places import RemotePath
from judder.contact import Law
from judder.errors import InputError, JudderError, RewrittenError, StoreError, StudyError, UnknownResultError, rewritten
from judder.progress import Progress

if TYPE_CHECKING:
    import pandas
    import xarray

__all__ = ["CaseLike", "RemotePath", "Study", "check", "limit_memory", "load_study", "run"]

CaseLike: TypeAlias = str | os.PathLike[str] | Mapping[str, Any]
"""A case: the path of its file, its text (a ``str`` with a line break), or its tables as a mapping.

Where a case file names another file, a mapping may have an object: a sparse matrix, an array, a mesh of meshio, columns of numbers, a law.
"""


HELD_BYTES: Final = 4 << 30
"""Bytes that the results of a run without a folder may take, where nobody says otherwise."""
_LONGEST_WORDS: Final = 80
"""Letters of a text among the numbers of an analysis that a notebook shows."""
_NOT_KEPT = "with a folder as `output` what the others leave is kept"
"""What is told of the other analyses where one of a run without a folder is refused."""


def limit_memory(amount: str | int | None) -> None:
    """Says how much memory this process takes at most, as ``--memory`` of the command does.

    One budget holds for all that judder does in a process, whichever function is called: :func:`check` and :func:`run` refuse what would need more
    before they compute it. Where nothing is said it is three quarters of what is free. Processes of :mod:`judder.distributed` have their own.

    Args:
        amount: such as ``"4 GiB"`` or ``"500 MB"``, or a number of bytes, 1 MiB or more; ``None`` takes back what was said.

    Raises:
        InputError: no amount, or less than 1 MiB.

    >>> judder.limit_memory("8 GiB")
    >>> judder.limit_memory(None)
    """
    count = _judder.bytes_of_memory(amount) if isinstance(amount, str) else amount
    if amount is not None and (not isinstance(count, int) or count < 1 << 20):
        message = f'amount: {amount!r} is no amount of 1 MiB or more, such as "4 GiB" or "500 MB", or a number of bytes'
        raise InputError(message, "Input", {"argument": "amount"})
    _judder.limit_memory(count)


def check(case: CaseLike, *, set: Mapping[str, Any] | None = None) -> dict[str, Any]:
    """What a case means, before anything runs: the document of ``judder check --json``.

    Args:
        case: a path, the text of a case, or its tables as a mapping; files that it names are sought beside it.
        set: changed keys, such as ``{"operation.velocity": "30 mm/s"}``; as ``--set`` of the command.

    Returns:
        A dictionary with the resolved case, its stability limits, and the time and memory that a run would take.

    Raises:
        CaseError: the case is wrong; ``error.line``, ``error.key``, ``error.help``.

    >>> judder.check({"model": "oscillator"})["groups"]["v_d τ/R"]
    0.0001
    """
    source = CaseSource(case, set)
    with source.told():
        document: dict[str, Any] = json.loads(_judder.checked_case(source.given, source.overrides))
    return {**document, "warnings": [*map(source.said, document["warnings"])]} if "warnings" in document else document


def run(
    case: CaseLike,
    *,
    output: str | os.PathLike[str] | Literal[True] | None = None,
    only: Iterable[str] = (),
    set: Mapping[str, Any] | None = None,
    fresh: bool = False,
    law: Law | None = None,
    memory: int = HELD_BYTES,
    threads: int | None = None,
    progress: Progress | None = None,
) -> Study:
    """Runs the analyses and sweeps of a case: in memory, or into a study folder, as ``judder run`` does.

    In memory nothing is drawn and nothing is written, each call computes anew, and :meth:`Study.save` writes a folder afterwards. Sweeps and
    analyses that read what others have stored take a temporary folder meanwhile, which goes with the study. Signals of a motion that may be too long for
    memory want an ``output``: there they grow on the disk.

    In a folder only what is not done yet is run: Ctrl-C ends the run and keeps what is done, and the same call goes on from there.

    Args:
        case: a path, the text of a case, or its tables as a mapping; files that it names are sought beside it.
        output: the study folder; none where none is given. ``True`` is the folder that the command would choose: ``out/<name>`` for a case file as it
            is; for any other case, a text, tables, a file with changes or a law, ``out/<title>-<hash>``: the same case has the same folder, another
            case another, so that a loop over cases keeps all its results.
        only: these analyses and sweeps and no others.
        set: changed keys, such as ``{"operation.velocity": 1e-3}``.
        fresh: forget earlier results in the folder first.
        law: a contact law of your own in place of that of an oscillator case; a folder keeps it as ``law.json``.
        memory: bytes that the results of a run without a folder may take; more is refused, by the name of the analysis.
        threads: threads to compute with; one a core where none is given. Results do not depend on it.
        progress: ``progress(name, done, total)``, see :func:`judder.tqdm_progress`.

    Returns:
        The study. Where a result is missing, ``study.complete`` is false and ``study.failures`` says why; all that has to be known
        besides is a :class:`JudderWarning`.

    Raises:
        CaseError: the case is wrong, also where only the run could see it.
        StoreError: the folder cannot be written.
        StudyError: ``out/<name>`` holds the study of another case file of this name; ``error.owner``. Without a folder, results that take more than
            ``memory``; ``error.bytes``.
        Interrupted: Ctrl-C.
        JudderError: an analysis was refused for another wrong input; the others have run, and their results are kept in a folder alone.
    """
    source, names = CaseSource(case, set), list(only)
    memory = _arguments.whole_bytes("memory", memory)
    if output is None:
        with source.told():
            held = _judder.held_case(
                source.given, only=names, overrides=source.overrides, law=law, memory=memory, threads=threads, progress=progress
            )
        if held is not None:
            compiled, messages, refused = held
            study = Study._held(compiled, source)
            _log(study.summary, "memory")
            _tell(source, messages, refused, _NOT_KEPT)
            return study
    owner, place = None, None
    if output is None:
        owner = _memory.TemporaryFolder()
        place = str(owner.folder)
    elif output is not True:
        place = _places.writable(output)
    with source.told():
        told = _judder.run_case(
            source.given,
            output=place,
            only=names,
            overrides=source.overrides,
            fresh=fresh,
            law=law,
            threads=threads,
            progress=progress,
            report=owner is None,
        )
    source.keep(told["folder"])
    kept = _NOT_KEPT if owner else f"what the others left is in {told['folder']}"
    study = Study(told["folder"]) if owner is None else Study._owned(owner)
    _log(study.summary, told["folder"])
    _tell(source, [*told["messages"], *told["notes"]], told["refused"], kept)
    return study


def _log(summary: Mapping[str, Any], place: str) -> None:
    """Tells the logger ``judder`` what ran, and where it lies."""
    import logging

    logger = logging.getLogger("judder")
    for name, record in summary["analyses"].items():
        logger.info("`%s` took %.3g s in %s: %s", name, record.get("wall_time_s", 0.0), place, record.get("reason") or record["status"])


def _tell(source: CaseSource, messages: Iterable[str], refused: Iterable[tuple[str, JudderError]], kept: str) -> None:
    """Warns the caller of a run of what has to be known, and raises why the first analysis was refused.

    Raises:
        JudderError: one was; a note says which, and what became of the others.
    """
    for message in messages:
        _warned.warn(source.said(message))
    for name, found in refused:
        error = source.said_error(found)
        error.add_note(f"analysis `{name}`; {kept}")
        raise error


def load_study(folder: str | os.PathLike[str], *, storage_options: Mapping[str, Any] | None = None) -> Study:
    """Opens a study that ``judder run`` or :func:`judder.run` has written.

    Args:
        folder: its folder; or the address of a copy in an object store or archive that fsspec knows, such as ``"s3://bucket/study"`` or
            ``"zip::s3://bucket/study.zip"`` (``pip install 'judder[remote]'``, and s3fs for ``s3://``). Such a study is read and never
            written, and nothing is fetched before it is used.
        storage_options: what fsspec is to know of the store, such as ``{"anon": True}``.

    Raises:
        StudyError: there is no study here, or its summary cannot be read.
        InputError: no store has such an address.
        PackageError: the package for this store is not installed.
    """
    return Study(folder, storage_options)


class Study(Placed, Exported, Mapping[str, "xarray.Dataset"]):
    """What a run has left: a mapping from the names of its analyses and sweeps to their data.

    The data of a sweep has a variable for each quantity, and the swept keys as coordinates; its values are read, and with dask computed
    on, chunk by chunk. A dataset is read when it is used; a chunk that is gone is a :class:`StoreError` before that, and where another run has replaced
    the results in the folder meanwhile, reading them is a :class:`RewrittenError`. Its variables carry units and long names, so that they label their own plots::

        study["map"].growth_rate.plot()

    A key is called by its last name, ``data.velocity``, and by all of it where two end alike; its attribute ``key`` is the dotted path. The attribute
    ``judder_case`` is the case with law and fixed keys, JSON, ``judder_warnings`` what has to be known of the result. All write to Zarr and NetCDF after
    any operation, to NetCDF by ``engine="h5netcdf"``; ``netCDF4`` takes complex numbers with ``auto_complex=True``.

    Oscillators and belts are computed in groups. Where their case is written in SI, every array that has a unit there stands beside as ``<name>_si``,
    of a motion ``data.x_si`` in m over ``data.time_si`` in s; :meth:`in_si` has those alone::

        study.in_si("motion").x.plot()

    In a notebook a study shows its results and figures. A study that was run without ``output`` has no folder, and so neither report nor figures nor
    tables as files; :meth:`save` writes them.
    """

    summary: dict[str, Any]
    """The content of ``summary.json``."""
    @property
    def analyses(self) -> tuple[str, ...]:
        """The names of the analyses that have run, then of the sweeps, in the order of the case, with or without a result."""
        ran = self.summary["analyses"]
        order = [analysis["name"] for analysis in self.summary["case"].get("analysis", [])]
        return tuple(name for name in [*order, *self.sweeps] if name in ran)

    @property
    def sweeps(self) -> tuple[str, ...]:
        """The names of the sweeps of the case, in its order."""
        return tuple(sweep["name"] for sweep in self.summary["case"].get("sweep", []))

    @property
    def failures(self) -> dict[str, str]:
        """Why analyses have no result, by their names."""
        records = ((name, self.summary["analyses"][name]) for name in self.analyses)
        return {name: self._said(record.get("reason", "")) for name, record in records if record["status"] != "done"}

    @property
    def complete(self) -> bool:
        """Whether every analysis and sweep of the case has run and no result is missing."""
        missing = self.summary.get("study", {}).get("missing", {})
        asked = len(self.summary["case"].get("analysis", [])) + len(self.sweeps)
        return len(self.analyses) == asked and not self.failures and not any(missing.values())

    @property
    def results(self) -> dict[str, dict[str, Any]]:
        """The numbers of each analysis, by names: thresholds, fractions, errors."""
        found: dict[str, dict[str, Any]] = self.summary["results"]
        return {name: found[name] for name in self.analyses if name in found}

    @property
    def warnings(self) -> dict[str, list[str]]:
        """What has to be known of each analysis before it is trusted."""
        return {name: [*map(self._said, self.summary["analyses"][name].get("warnings", []))] for name in self.analyses}

    @property
    def hashes(self) -> dict[str, str]:
        """The hash of all that each result depends on, by the names of analyses and sweeps."""
        ran = self.summary["analyses"]
        return {name: ran[name]["hash"] for name in self.analyses if "hash" in ran[name]}

    @property
    def report(self) -> Path | RemotePath:
        """The report page.

        Raises:
            StudyError: the study has no folder.
        """
        self._check()
        return self.folder / "report.html"

    @property
    def figures(self) -> dict[str, Path | RemotePath]:
        """The figures (SVG) by their names.

        Raises:
            StudyError: the study has no folder.
        """
        self._check()
        return _places.listed(self.folder, "figures", ".svg")

    @property
    def tables(self) -> dict[str, Path | RemotePath]:
        """The tables (CSV) by their names.

        Raises:
            StudyError: the study has no folder; :attr:`files` has their contents.
        """
        self._check()
        return _places.listed(self.folder, "", ".csv")

    def _check(self) -> None:
        """Refuses to hand out files of a folder in which another run has replaced results of this study.

        Raises:
            RewrittenError: one has.
        """
        there = _summaries.read(self.folder)["analyses"]
        for name, expected in self.hashes.items():
            found = there.get(name, {}).get("hash")
            if found != expected:
                raise rewritten(str(self.folder), name, expected, found)

    def __getitem__(self, name: str) -> xarray.Dataset:
        if name not in self.analyses or name in self.failures:
            raise self._unknown(name, "result", list(self))
        from judder import _conventions

        return _conventions.presented(self._dataset(name), name, self.summary, self.warnings[name])

    def in_si(self, name: str) -> xarray.Dataset:
        """The data of an analysis with what has a unit in SI in that alone, under the names that the groups have.

        Of a motion of a case in SI ``study.in_si("motion").x.plot()`` draws metres over seconds. What has no unit in SI stays as it is.

        Raises:
            UnknownResultError: there is no such result.
        """
        return _si.alone(self[name])

    def _dataset(self, name: str, *, whole: bool = True, dask: bool | None = None) -> xarray.Dataset:
        """The data of a result; of a sweep with a look whether all chunks are there, and as arrays of dask or not."""
        if self._compiled is not None:
            return _si.beside(_memory.dataset(self._compiled, name, self.hashes[name]), in_memory=True)
        place = self._stored, name, self.hashes.get(name)
        with _places.reading(self._stored, name):
            if name not in self.sweeps:
                return _si.beside(_places.group(*place), in_memory=False)
            if whole:
                _swept.whole(self._stored, name)
            return _swept.dataset(*place, dask=dask)

    def _unknown(self, name: object, what: str, known: list[str]) -> UnknownResultError:
        """The error of a name that is no result, or none of this sort."""
        if isinstance(name, str) and name in self.failures:
            message = f"`{name}` has no result: {self.failures[name]}"
        else:
            message = f"the study has no {what} `{name}`; there are {', '.join(f'`{own}`' for own in known) or 'none'}"
        return UnknownResultError(message, "UnknownResult", {"name": name, "known": known})

    def _ipython_key_completions_(self) -> list[str]:
        """What completes ``study["``."""
        return list(self)

    def failed_points(self, name: str) -> pandas.DataFrame:
        """The points of a sweep that have no answer, or a doubtful one.

        Returns:
            A table with a row a point: the values of the swept keys, one column each in the unit of the sweep, and ``reason``. The reason of
            a point that has values, which a check doubts, begins with ``doubtful``.

        Raises:
            UnknownResultError: there is no such sweep.
            RewrittenError: another run has replaced the sweep.
            StoreError: a chunk is not there, damaged, or of another sweep.
        """
        if name not in self.sweeps or name not in self:
            raise self._unknown(name, "sweep", [own for own in self.sweeps if own in self])
        with _places.reading(self._stored, name):
            _swept.whole(self._stored, name)
            numbers = self.results[name]
            any_failed = bool(numbers["failed"] or numbers["doubtful"])
            return _swept.failed_points(self._stored, name, self.hashes.get(name), any_failed=any_failed)

    def __iter__(self) -> Iterator[str]:
        failures = self.failures
        return (name for name in self.analyses if name not in failures)

    def __len__(self) -> int:
        return sum(1 for _ in self)

    def __repr__(self) -> str:
        where = "in memory" if self._has_no_folder else repr(str(self._place))
        verdicts = {name: _shown.verdict(self.results.get(name, {})) for name in self}
        names = ", ".join(f"{name} ({own})" if own else name for name, own in verdicts.items())
        return f"Study({where}: {names or 'no results'})"

    @property
    def _name(self) -> str:
        """What the study is called: its title, else its folder, else its model."""
        own = self.summary["case"].get("title") or ("" if self._has_no_folder else self.folder.name)
        return str(own or self.summary["case"].get("model", "study"))

    def _pictures(self) -> dict[str, str]:
        """The figures (SVG) by their names, drawn now where there are no files of them."""
        if self._compiled is not None:
            return dict(self._compiled.figures())
        return {} if self._has_no_folder else {name: path.read_text(encoding="utf-8") for name, path in self.figures.items()}

    def _repr_html_(self) -> str:
        rows = "".join(
            f"<tr><th>{html.escape(name)}</th><td>{html.escape(key)}</td><td>{html.escape(own)}</td></tr>"
            for name, numbers in self.results.items()
            for key, own in _shown_numbers(numbers)
        )
        failed = "".join(f"<p><b>{html.escape(name)}</b>: {html.escape(why)}</p>" for name, why in self.failures.items())
        try:
            pictures = self._pictures().items()
            figures = "".join(f"<details><summary>{html.escape(name)}</summary>{picture}</details>" for name, picture in pictures)
        except RewrittenError as error:
            figures = f"<p>{html.escape(str(error))}</p>"
        return f"<h4>{html.escape(self._name)}</h4>{failed}<table>{rows}</table>{figures}"


def _shown_numbers(numbers: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    """What a notebook shows of the numbers of an analysis: its verdict, numbers, words, and between which those of a list lie."""
    if verdict := _shown.verdict(numbers):
        yield "verdict", verdict
    for key, own in numbers.items():
        is_list = isinstance(own, list) and own and all(isinstance(item, int | float) and not isinstance(item, bool) for item in own)
        if is_list or isinstance(own, int | float) or isinstance(own, str) and key != "verdict" and len(own) <= _LONGEST_WORDS:
            yield key, _shown.told(own)


_arguments.checked(globals())
