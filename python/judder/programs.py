"""What the command ``judder`` does besides running cases: first results, examples, templates, reports, papers, the local page."""

from __future__ import annotations

import html
import json
import os
import webbrowser
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Any, overload

from judder import _arguments, _judder, _places, _warned
from judder._objects import CaseSource
from judder._shown import Shown
from judder.errors import InputError
from judder.progress import Progress
from judder.study import CaseLike, Study, check, run

if TYPE_CHECKING:
    from typing import Self

__all__ = ["Claim", "Example", "Page", "Reproduction", "demo", "examples", "explore", "new", "report", "reproduce", "schema", "verify"]

_DEMO = "oscillator-paper"
"""The paper that a demo recomputes."""


@dataclass(frozen=True, eq=False, repr=False)
class Example(Shown):
    """A case, or a script of Python, that is inside the package."""

    name: str
    """What it is called, such as ``"assembly/mode-coupling"``."""
    kind: str
    """``"case"`` or ``"script"``."""
    title: str
    """What it is, in a line."""
    file: str
    """The name of its file."""
    text: str
    """Its text; a case without ``files`` is one for :func:`judder.run`."""
    files: Mapping[str, bytes]
    """The files that it names, which lie beside it."""

    def write(self, folder: str | os.PathLike[str]) -> Path:
        """Writes it, and the files that it names, into a folder, which is made where there is none; gives back its path.

        Raises:
            StoreError: another file of its name is there; the folder cannot be written.
        """
        return Path(_judder.written_example(self.name, _places.writable(folder)))

    def _told(self) -> Iterator[tuple[str, str]]:
        return ((name, own) for name, own in super()._told() if name != "text")


class _Examples(dict[str, Example]):
    """The examples by their names, which show themselves as a list."""

    def __missing__(self, name: str) -> Example:
        (told,) = _judder.embedded_examples(name)
        return _example(*told)

    def __repr__(self) -> str:
        width = max(map(len, self), default=0)
        return "\n".join(f"{name:{width}}  {own.title}" for name, own in self.items())

    def _repr_html_(self) -> str:
        rows = "".join(f"<tr><td>{html.escape(name)}</td><td>{html.escape(own.title)}</td></tr>" for name, own in self.items())
        return f"<table>{rows}</table>"


def examples() -> Mapping[str, Example]:
    """The cases and scripts that are inside the package, by their names; the last part of a name is enough where one alone has it.

    Raises:
        InputError: a name that there is not is asked for.

    >>> judder.examples()["mode-coupling"].title
    'Mode coupling of a mass on two springs'
    """
    return _Examples((told[0], _example(*told)) for told in _judder.embedded_examples())


def _example(name: str, kind: str, title: str, file: str, text: str, files: list[tuple[str, bytes]]) -> Example:
    return Example(name, kind, title, file, text, dict(files))


@overload
def demo(
    name: None = None, *, output: str | os.PathLike[str] | None = None, threads: int | None = None, progress: Progress | None = None
) -> Reproduction: ...
@overload
def demo(name: str, *, output: str | os.PathLike[str] | None = None, threads: int | None = None, progress: Progress | None = None) -> Study: ...
def demo(
    name: str | None = None, *, output: str | os.PathLike[str] | None = None, threads: int | None = None, progress: Progress | None = None
) -> Reproduction | Study:
    """A first result: the oscillator paper, figure by figure, in less than a minute; or a case of :func:`examples`.

    What the analyses of a case are expected to take is told to the logger ``judder`` before they run, as :func:`judder.check` estimates it.

    Args:
        name: a case; the paper where none is given.
        output: the study folder. Where none is given, a case runs in memory, and the paper goes into ``out/demo/oscillator-paper``.
        threads: threads to compute with; one a core where none is given.
        progress: ``progress(name, done, total)``.

    Raises:
        InputError: there is no such example, or it is a script.

    >>> judder.demo("minimal-mode-coupling").analyses
    ('spectrum', 'critical')
    """
    if name is None:
        return reproduce(_DEMO, quick=True, output=f"out/demo/{_DEMO}" if output is None else output, threads=threads, progress=progress)
    own = examples()[name]
    if own.kind != "case":
        why = f"name: {own.name} is a script of Python; judder.examples()[{own.name!r}].write(folder) writes it"
        raise InputError(why, "Input", {"argument": "name"})
    from judder import _memory

    beside = _memory.TemporaryFolder()
    case = own.write(beside.folder)
    _log_expected(case)
    return run(case, output=output, threads=threads, progress=progress)


def _log_expected(case: Path) -> None:
    """Tells the logger ``judder`` what the analyses of a case are expected to take, where anybody listens."""
    import logging

    logger = logging.getLogger("judder")
    if logger.isEnabledFor(logging.INFO):
        known = check(case)
        for own in known["estimate"]:
            if "seconds" in own or "asked" in own:
                logger.info("`%s`: %s", own["name"], f"takes about {own['seconds']:.1f} s on one core" if "seconds" in own else own["asked"])
        for own in known.get("sweeps", []):
            logger.info("`%s`: %d points", own["name"], own["points"])


@dataclass(frozen=True)
class Claim:
    """What a paper says, and what is found."""

    place: str
    """Where it stands in the paper."""
    says: str
    """What the paper says."""
    ours: Mapping[str, str]
    """What is found, by the reading of the paper."""
    verdict: str
    """``"agrees"``, ``"misprint"`` or ``"open"``."""
    why: str
    """Why, in a sentence."""


@dataclass(frozen=True, eq=False, repr=False)
class Reproduction(Shown):
    """A paper that was recomputed."""

    folder: Path
    """The study folder."""
    report: Path
    """Its page."""
    complete: bool
    """Whether no result is missing."""
    scoreboard: tuple[Claim, ...]
    """What the paper claims, and what is found."""

    def _repr_html_(self) -> str:
        rows = "".join(
            "<tr>" + "".join(f"<td>{html.escape(cell)}</td>" for cell in (own.verdict, own.place, own.says, ", ".join(dict.fromkeys(own.ours.values())))) + "</tr>"
            for own in self.scoreboard
        )
        head = "<tr><th>verdict</th><th>where</th><th>the paper says</th><th>found</th></tr>"
        return f"<h4>{html.escape(str(self.report))}</h4><table>{head}{rows}</table>"


def reproduce(
    paper: str = _DEMO,
    *,
    quick: bool = False,
    output: str | os.PathLike[str] | None = None,
    threads: int | None = None,
    progress: Progress | None = None,
) -> Reproduction:
    """Recomputes every figure and quoted number of a paper, as ``judder reproduce`` does.

    Args:
        paper: ``"oscillator-paper"`` or ``"beams-paper"``.
        quick: in seconds instead of minutes, with fewer points.
        output: the study folder; ``out/reproduce/<paper>`` where none is given. What is there already is not computed again.
        threads: threads to compute with; one a core where none is given.
        progress: ``progress(name, done, total)``.

    Raises:
        InputError: a paper that judder does not know.
        StoreError: the folder cannot be written.
        Interrupted: Ctrl-C; the same call goes on from there.
    """
    place = None if output is None else _places.writable(output)
    told = json.loads(_judder.reproduced_paper(paper, quick=quick, output=place, threads=threads, progress=progress))
    claims = tuple(Claim(**own) for own in told["scoreboard"])
    return Reproduction(Path(told["folder"]), Path(told["report"]), told["complete"], claims)


def new(model: str = "oscillator") -> str:
    """A commented case file to start from, as ``judder new`` prints it.

    Raises:
        CaseError: there is no such template; ``error.help`` names them.

    >>> "normal_load" in judder.new("oscillator")
    True
    """
    return _judder.template_text(model)


def schema() -> dict[str, Any]:
    """The JSON Schema of case files, for editors: the document of ``judder schema``.

    >>> sorted(judder.schema())[:2]
    ['$defs', '$schema']
    """
    document: dict[str, Any] = json.loads(_judder.schema_text())
    return document


def report(study: Study | str | os.PathLike[str]) -> Path:
    """Rebuilds figures and page of a study folder from its stored results, as ``judder report`` does; gives back the path of the page.

    Args:
        study: a study with a folder, or the folder.

    Raises:
        StudyError: there is no study, or it has no folder; :meth:`Study.save` writes one with its report.
        StoreError: it cannot be read or written.
    """
    folder = study.folder if isinstance(study, Study) else study
    page, lacking = _judder.rebuilt_report(_places.writable(folder))
    for line in lacking:
        _warned.warn(line)
    return Path(page)


def verify(folder: str | os.PathLike[str]) -> dict[str, Any]:
    """Whether a study folder is whole and as it was written: the document of ``judder verify --json``. It reads all files and changes nothing.

    Args:
        folder: the study folder, of this machine.

    Returns:
        ``sound``; ``complete``, false while a run is at work or where one was interrupted; ``files`` and ``bytes`` that are as they were written;
        ``findings``, each with ``path``, ``kind`` (``"damaged"``, ``"unreadable"``, ``"unfinished"`` or ``"extra"``), ``of``, the analysis, and ``reason``.

    Raises:
        StudyError: there is no study here.
        StoreError: it has no manifest, or a damaged one, so that nothing says what it was.
        Interrupted: Ctrl-C.
    """
    document: dict[str, Any] = json.loads(_judder.verified_study(_places.writable(folder)))
    return document


class Page:
    """The local page while it is served: what :func:`explore` returns. In ``with`` it ends with the block; in a notebook it shows its address."""

    def __init__(self, served: _judder.ServedPage, source: CaseSource | None) -> None:
        self._served, self._source = served, source

    @property
    def address(self) -> str:
        """The address, with the token that lets a browser of this machine in."""
        return self._served.address

    @property
    def is_open(self) -> bool:
        """Whether it is served."""
        return self._served.is_open

    def wait(self) -> None:
        """Serves it until Ctrl-C, then ends it: for scripts, which end otherwise."""
        import time

        try:
            while self.is_open:
                time.sleep(0.1)
        except KeyboardInterrupt:
            pass
        finally:
            self.close()

    def close(self) -> None:
        """Ends it; what works is cancelled."""
        self._served.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self.close()

    def __repr__(self) -> str:
        return f"Page({self.address})" if self.is_open else "Page(closed)"

    def _repr_html_(self) -> str:
        address = html.escape(self.address)
        return f'<a href="{address}">{address}</a>' if self.is_open else "closed"


def explore(
    case: CaseLike | Study | None = None,
    *,
    study: Study | str | os.PathLike[str] | None = None,
    set: Mapping[str, Any] | None = None,
    port: int | None = None,
    browser: bool = True,
) -> Page:
    """Serves the local page to this machine alone, beside whatever else goes on: move through the map, open a point, hear it.

    Args:
        case: a path, the text of a case, its tables as a mapping, or a study with a folder; the oscillator paper's where none is given.
        study: a study of the case, or its folder, whose results are shown besides.
        set: changed keys.
        port: the port; any that is free where none is given.
        browser: whether to open the page.

    Raises:
        CaseError: the case is wrong.
        StudyError: there is no study in the folder.
        InputError: the port is taken.
    """
    if isinstance(case, Study):
        case, study = None, case
    folder = study.folder if isinstance(study, Study) else study
    place = None if folder is None else _places.writable(folder)
    if case is None:
        page = Page(_judder.ServedPage(None, [], study=place, port=port), None)
    else:
        source = CaseSource(case, set)
        with source.told():
            page = Page(_judder.ServedPage(source.given, source.overrides, study=place, port=port), source)
    if browser:
        webbrowser.open(page.address)
    return page


_arguments.checked(globals())
