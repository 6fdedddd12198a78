"""A case with the files that it names, as it travels to a worker."""

from __future__ import annotations

import hashlib
import os
import posixpath
import tempfile
import threading
from dataclasses import dataclass
from pathlib import Path
from typing import TypeVar

from judder import _judder
from judder._objects import INPUTS
from judder.errors import StudyError

_KEPT = 4
"""Cases that a worker keeps ready."""

_Key = TypeVar("_Key")
_Value = TypeVar("_Value")
# by the process, too: one that forks has those of its parent, whose threads do not follow it
_known: dict[tuple[int, str], Package] = {}
_ready: dict[tuple[int, str, int | None], dict[str, _judder.Sweep]] = {}
_folders: list[tempfile.TemporaryDirectory[str]] = []
_door = threading.Lock()


@dataclass(frozen=True)
class Package:
    """All that a worker needs to compute the sweeps of a case."""

    name: str
    text: str
    overrides: tuple[str, ...]
    files: tuple[tuple[str, bytes], ...]
    """As the case calls them, and what they hold."""
    digest: str
    """Names all of this."""

    @classmethod
    def of(cls, told: tuple[str, str, list[str], list[tuple[str, str]]]) -> Package:
        """The package of a case: its name, its text, what is changed in it, and the files that it names, as it calls them and where they are."""
        name, text, overrides, named = told
        files = tuple((given, Path(path).read_bytes()) for given, path in named)
        digest = hashlib.blake2b(repr((name, text, overrides)).encode(), digest_size=16)
        for given, content in files:
            digest.update(f"{len(given)} {given} {len(content)} ".encode())
            digest.update(content)
        return cls(name, text, tuple(overrides), files, digest.hexdigest())

    @property
    def size(self) -> int:
        """About how many bytes travel."""
        return len(self.text) + sum(len(content) for _, content in self.files)

    def sweep(self, name: str, expected: str, threads: int | None) -> _judder.Sweep:
        """The sweep of this name, made once in a process; what its points share is kept with it.

        Raises:
            StudyError: this machine would compute something else: another version of judder, a file that is not there.
        """
        sweep = _sweeps(self, threads)[name]
        if sweep.hash != expected:
            message = (
                f"{name}: a worker would compute another sweep than the one that is asked for: it has judder {_judder.VERSION}; "
                "workers and client need the same version"
            )
            raise StudyError(message, "OtherSweep", {"name": name, "version": _judder.VERSION})
        return sweep

    def keep_inputs(self, folder: str) -> None:
        """Writes what the case had in memory into a study folder."""
        for given, content in self.files:
            if given.startswith(f"{INPUTS}/"):
                place = Path(folder, given)
                place.parent.mkdir(exist_ok=True)
                place.write_bytes(content)

    def unpacked(self) -> str:
        """The path that the case has here: in a folder beside which its files lie as it names them."""
        relative = [(posixpath.normpath(given), content) for given, content in self.files if not os.path.isabs(given)]
        if not relative:
            return self.name
        folder = tempfile.TemporaryDirectory(prefix="judder-")
        _folders.append(folder)
        steps = max(given.split("/").count("..") for given, _ in relative)
        home = Path(folder.name).joinpath(*["up"] * steps)
        home.mkdir(parents=True, exist_ok=True)
        for given, content in relative:
            place = Path(os.path.normpath(home / given))
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_bytes(content)
        return str(home / self.name)


def kept(package: Package | str) -> Package | None:
    """The package of a name where this process has it; one that is given is kept."""
    own = os.getpid()
    with _door:
        if isinstance(package, str):
            return _known.get((own, package))
        _put(_known, (own, package.digest), package)
        return package


def _sweeps(package: Package, threads: int | None) -> dict[str, _judder.Sweep]:
    key = (os.getpid(), package.digest, threads)
    with _door:
        if key not in _ready:
            source = (package.unpacked(), package.text)
            made = _judder.Sweep.all(source, list(package.overrides), threads=threads)
            _put(_ready, key, {sweep.name: sweep for sweep in made})
        return _ready[key]


def _put(kept: dict[_Key, _Value], key: _Key, value: _Value) -> None:
    """Keeps the newest ones."""
    kept[key] = value
    while len(kept) > _KEPT:
        del kept[next(iter(kept))]
