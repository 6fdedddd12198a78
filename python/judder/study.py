"""Whole cases: run, check, and what a run leaves."""

from __future__ import annotations

import html
import json
import os
import warnings
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

from judder import _interchange, _judder, _places, _swept
from judder._objects import CaseSource
from judder._places import RemotePath
from judder.contact import Law
from judder.errors import JudderWarning, RewrittenError, StoreError, StudyError, UnknownResultError, rewritten
from judder.progress import Progress

if TYPE_CHECKING:
    import pandas
    import xarray

__all__ = ["CaseLike", "RemotePath", "Study", "check", "load_study", "run"]

CaseLike: TypeAlias = str | os.PathLike[str] | Mapping[str, Any]
"""A case: the path of its file, its text (a ``str`` with a line break), or its tables as a mapping.

Where a case file names another file, a mapping may have an object: a sparse matrix, an array, a mesh of meshio, columns of numbers, a law.
"""


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
    return document


def run(
    case: CaseLike,
    *,
    output: str | os.PathLike[str] | None = None,
    only: Iterable[str] = (),
    set: Mapping[str, Any] | None = None,
    fresh: bool = False,
    law: Law | None = None,
    threads: int | None = None,
    progress: Progress | None = None,
) -> Study:
    """Runs the analyses and sweeps of a case that are not done yet, as ``judder run`` does.

    Ctrl-C ends the run and keeps what is done: the same call goes on from there.

    Args:
        case: a path, the text of a case, or its tables as a mapping; files that it names are sought beside it.
        output: the study folder. Where none is given, ``out/<name>`` for a case file as it is, as of the command; for any other case, a text, tables, a file with
            changes or a law, ``out/<title>-<hash>``: the same case has the same folder, another case another, so that a loop over cases keeps all its results.
        only: these analyses and sweeps and no others.
        set: changed keys, such as ``{"operation.velocity": 1e-3}``.
        fresh: forget earlier results first.
        law: a contact law of your own in place of that of an oscillator case; it is kept in the folder as ``law.json``.
        threads: threads to compute with; one a core where none is given. Results do not depend on it.
        progress: ``progress(name, done, total)``, see :func:`judder.tqdm_progress`.

    Returns:
        The study. Where a result is missing, ``study.complete`` is false and ``study.failures`` says why; all that has to be known
        besides is a :class:`JudderWarning`.

    Raises:
        CaseError: the case is wrong, also where only the run could see it.
        StoreError: the folder cannot be written.
        StudyError: ``out/<name>`` holds the study of another case file of this name; ``error.owner``.
        Interrupted: Ctrl-C.
        JudderError: an analysis was refused for another wrong input; the others have run.
    """
    source = CaseSource(case, set)
    with source.told():
        told = _judder.run_case(
            source.given,
            output=None if output is None else _places.writable(output),
            only=list(only),
            overrides=source.overrides,
            fresh=fresh,
            law=law,
            threads=threads,
            progress=progress,
        )
    source.keep(told["folder"])
    for message in [*told["messages"], *told["notes"]]:
        warnings.warn(source.plain(message), JudderWarning, stacklevel=2)
    for name, refused in told["refused"]:
        error = source.plain_error(refused)
        error.add_note(f"analysis `{name}`; what the others left is in {told['folder']}")
        raise error
    return Study(told["folder"])


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


class Study(Mapping[str, "xarray.Dataset"]):
    """What a run has left: a mapping from the names of its analyses and sweeps to their data.

    The data of a sweep has a variable for each quantity, and the swept keys as coordinates; its values are read, and with dask computed
    on, chunk by chunk. A dataset is read when it is used; a chunk that is gone is a :class:`StoreError` before that, and where another run has replaced
    the results in the folder meanwhile, reading them is a :class:`RewrittenError`. Its variables carry units and long names, so that they label their own plots::

        study["map"].growth_rate.plot()

    In a notebook a study shows its results and figures.
    """

    folder: Path | RemotePath
    """The study folder."""
    summary: dict[str, Any]
    """The content of ``summary.json``."""

    def __init__(self, folder: str | os.PathLike[str], storage_options: Mapping[str, Any] | None = None) -> None:
        self.folder = _places.place(folder, storage_options)
        self.summary = _summary(self.folder)

    def __fspath__(self) -> str:
        """The path of its folder, so that a case can begin where this study ended: ``start = {"study": study, ...}``."""
        return _places.writable(self.folder)

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
        return {name: record.get("reason", "") for name, record in records if record["status"] != "done"}

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
        return {name: list(self.summary["analyses"][name].get("warnings", [])) for name in self.analyses}

    @property
    def hashes(self) -> dict[str, str]:
        """The hash of all that each result depends on, by the names of analyses and sweeps."""
        ran = self.summary["analyses"]
        return {name: ran[name]["hash"] for name in self.analyses if "hash" in ran[name]}

    @property
    def report(self) -> Path | RemotePath:
        """The report page."""
        self._check()
        return self.folder / "report.html"

    @property
    def figures(self) -> dict[str, Path | RemotePath]:
        """The figures (SVG) by their names."""
        self._check()
        return _places.listed(self.folder, "figures", ".svg")

    @property
    def tables(self) -> dict[str, Path | RemotePath]:
        """The tables (CSV) by their names."""
        self._check()
        return _places.listed(self.folder, "", ".csv")

    def _check(self) -> None:
        """Refuses to hand out files of a folder in which another run has replaced results of this study.

        Raises:
            RewrittenError: one has.
        """
        there = _summary(self.folder)["analyses"]
        for name, expected in self.hashes.items():
            found = there.get(name, {}).get("hash")
            if found != expected:
                raise rewritten(str(self.folder), name, expected, found)

    def __getitem__(self, name: str) -> xarray.Dataset:
        if name not in self.analyses or name in self.failures:
            raise self._unknown(name, "result", list(self))
        place = self.folder, name, self.hashes.get(name)
        with _places.reading(self.folder, name):
            if name not in self.sweeps:
                return _places.group(*place)
            _swept.whole(self.folder, name)
            return _swept.dataset(*place)

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
        with _places.reading(self.folder, name):
            _swept.whole(self.folder, name)
            numbers = self.results[name]
            any_failed = bool(numbers["failed"] or numbers["doubtful"])
            return _swept.failed_points(self.folder, name, self.hashes.get(name), any_failed=any_failed)

    def to_parquet(self, folder: str | os.PathLike[str], *, only: Iterable[str] = (), progress: Progress | None = None) -> list[Path]:
        """Writes results as tables of Apache Parquet, for pandas, Polars, DuckDB, R, Spark (``pip install 'judder[parquet]'``).

        A row is a point; a column is a coordinate or a variable, a complex variable two, ``<name>_real`` and ``<name>_imag``. Variables of
        other dimensions have tables of their own, ``<result>.<dimensions>.parquet``. ``<result>.results.parquet`` has the numbers of
        ``summary.json``; of a sweep ``<result>.failures.parquet`` has the points without an answer. Units, long names and the codes of
        classes are in the metadata of the columns. NaN becomes null. No more than some 10⁵ rows are in memory at a time.

        The files are there whole, or not at all; those of the same names are replaced.

        Args:
            folder: where they go; it is made where there is none.
            only: these analyses and sweeps and no others.
            progress: ``progress(name, done, total)``, in values.

        Returns:
            The files.

        Raises:
            PackageError: pyarrow is not installed.
            StoreError: they cannot be written, or would go into a study folder; a chunk of a sweep is missing or damaged.
            InputError: there is no such result.
        """
        return _interchange.to_parquet(self, self._outside(folder, is_folder=True), only, progress)

    def to_csv(self, folder: str | os.PathLike[str], *, only: Iterable[str] = (), progress: Progress | None = None) -> list[Path]:
        """Writes the same tables as comma-separated values: units in the heads, empty cells for NaN, numbers to the last bit.

        ``<result>.columns.csv`` says what the columns are: unit, long name, codes of classes. No package is needed. Arguments, return
        value and errors are those of :meth:`to_parquet`.
        """
        return _interchange.to_csv(self, self._outside(folder, is_folder=True), only, progress)

    def to_netcdf(self, path: str | os.PathLike[str], *, only: Iterable[str] = (), progress: Progress | None = None) -> Path:
        """Writes results into one NetCDF-4 file, a group each, for xarray, MATLAB, Julia (``pip install 'judder[netcdf]'``).

        A complex variable becomes two, ``<name>_real`` and ``<name>_imag``; the points of a sweep without an answer are in a group
        ``failures`` of its group. ``xarray.open_dataset(path, group="map")`` reads one back. Sweeps are written block by block.

        Arguments and errors are those of :meth:`to_parquet`.

        Returns:
            The file.
        """
        return _interchange.to_netcdf(self, self._outside(path, is_folder=False), only, progress)

    def to_matlab(self, path: str | os.PathLike[str], *, only: Iterable[str] = (), progress: Progress | None = None) -> Path:
        """Writes results into one ``.mat`` file, a structure each, for MATLAB, Octave, SciPy (``pip install 'judder[matlab]'``).

        What MATLAB takes for no name is changed: ``operation.velocity`` becomes ``operation_velocity``. The fields ``units``,
        ``long_name``, ``flag_values``, ``flag_meanings``, ``dimensions`` and ``names`` of a structure say what its variables are;
        ``results`` has its numbers, ``failures`` the points of a sweep without an answer, with their ``index`` in its variables.

        Arguments and errors are those of :meth:`to_parquet`; besides:

        Raises:
            StoreError: a result has more than such a file holds, 2 GiB.

        Returns:
            The file.
        """
        return _interchange.to_matlab(self, self._outside(path, is_folder=False), only, progress)

    def _outside(self, path: str | os.PathLike[str], *, is_folder: bool) -> Path:
        """The path of a folder or file to write that lies in no study folder, where it could replace what belongs to the study."""
        found = Path(_places.writable(path))
        goes_into = Path(os.path.realpath(found if is_folder else found.parent))
        own = Path(os.path.realpath(self.folder)) if isinstance(self.folder, Path) else None
        for folder in (goes_into, *goes_into.parents):
            if folder == own or os.path.exists(folder / "results.zarr" / "zarr.json"):
                message = f"{found}: {folder} is a study folder, and nothing is exported into one; name a place beside it"
                raise StoreError(message, "StudyFolder", {"path": str(found), "folder": str(folder)})
        return found

    def __iter__(self) -> Iterator[str]:
        failures = self.failures
        return (name for name in self.analyses if name not in failures)

    def __len__(self) -> int:
        return sum(1 for _ in self)

    def __repr__(self) -> str:
        return f"Study({str(self.folder)!r}: {', '.join(self) or 'no results'})"

    def _repr_html_(self) -> str:
        title = self.summary["case"].get("title") or self.folder.name
        rows = "".join(
            f"<tr><th>{html.escape(name)}</th><td>{html.escape(key)}</td><td>{html.escape(f'{number:.6g}')}</td></tr>"
            for name, numbers in self.results.items()
            for key, number in numbers.items()
            if isinstance(number, int | float) and not isinstance(number, bool)
        )
        failed = "".join(f"<p><b>{html.escape(name)}</b>: {html.escape(why)}</p>" for name, why in self.failures.items())
        try:
            figures = "".join(
                f"<details><summary>{html.escape(name)}</summary>{path.read_text(encoding='utf-8')}</details>"
                for name, path in self.figures.items()
            )
        except RewrittenError as error:
            figures = f"<p>{html.escape(str(error))}</p>"
        return f"<h4>{html.escape(str(title))}</h4>{failed}<table>{rows}</table>{figures}"


def _summary(folder: Path | RemotePath) -> dict[str, Any]:
    """The content of the summary in a study folder.

    Raises:
        StudyError: there is none, or it cannot be read.
    """
    try:
        found: dict[str, Any] = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    except (FileNotFoundError, NotADirectoryError):
        raise _no_study(folder, "no study here; `judder.run` makes one") from None
    except (ValueError, OSError, StoreError) as error:
        raise _no_study(folder, f"the summary cannot be read ({error})") from error
    if not _is_summary(found):
        raise _no_study(folder, "summary.json is none of judder's")
    return found


def _is_summary(found: Any) -> bool:
    """Whether a document has what every summary has."""
    if not isinstance(found, dict) or not all(isinstance(found.get(key), dict) for key in ("case", "analyses", "results")):
        return False
    asked = [found["case"].get(kind, []) for kind in ("analysis", "sweep")]
    named = all(isinstance(some, list) and all(isinstance(one, dict) and isinstance(one.get("name"), str) for one in some) for some in asked)
    return named and all(isinstance(record, dict) and "status" in record for record in found["analyses"].values())


def _no_study(folder: Path | RemotePath, reason: str) -> StudyError:
    return StudyError(f"{folder}: {reason}", "NoStudy", {"folder": str(folder)})
