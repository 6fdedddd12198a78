"""Files that are there whole or not at all."""

from __future__ import annotations

import os
import re
import secrets
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from judder.errors import StoreError

try:
    import fcntl
except ImportError:  # a system without such locks: nobody tells what is left from what is being written
    fcntl = None  # type: ignore[assignment]

_PARTIAL = re.compile(r"\.partial-([0-9a-f]{8})(-|\.lock$)")


class Files:
    """Files of one folder under temporary names, until all are written."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self._mark = secrets.token_hex(4)
        self._named: dict[Path, Path] = {}
        self._sign: _Sign | None = None

    def new(self, name: str) -> Path:
        """The path to write a file to that will have this name.

        Raises:
            StoreError: two files of one name.
        """
        path = self.folder / name
        if path in self._named:
            message = f"{path}: two results would have this file; name one of them with `only`, and give the other another folder"
            raise StoreError(message, "Duplicate", {"path": str(path)})
        if path.is_dir():
            raise StoreError(f"{path}: a folder has this name; name a file", "Write", {"path": str(path)})
        if self._sign is None:
            _remove_leftovers(self.folder)
            self._sign = _Sign(_sign_place(self.folder, self._mark))
        self._named[path] = self.folder / f".partial-{self._mark}-{name}"
        return self._named[path]

    @property
    def paths(self) -> list[Path]:
        """The paths of all files."""
        return list(self._named)

    @property
    def target(self) -> Path:
        """The file, where there is one, or the folder."""
        return self.paths[0] if len(self.paths) == 1 else self.folder

    def keep(self) -> None:
        """Forces the files to the disk and gives them their names."""
        for partial in self._named.values():
            with partial.open("rb+") as file:
                os.fsync(file.fileno())
        for path, partial in self._named.items():
            partial.replace(path)
        self._unsign()

    def drop(self) -> None:
        """Removes what has been written."""
        for partial in self._named.values():
            with suppress(OSError):
                partial.unlink()
        self._unsign()

    def _unsign(self) -> None:
        """Says that nothing is being written any more."""
        if self._sign is not None:
            self._sign.end()
            self._sign = None


class _Sign:
    """A file that is locked as long as its maker writes files of the same mark, however that ends."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._file = path.open("xb")
        with suppress(OSError):
            _lock(self._file.fileno())

    def end(self) -> None:
        with suppress(OSError):
            self._path.unlink()
        self._file.close()


def _sign_place(folder: Path, mark: str) -> Path:
    return folder / f".partial-{mark}.lock"


def _lock(file: int) -> None:
    """Locks a file.

    Raises:
        OSError: another holds it, or there are no locks.
    """
    if fcntl is None:
        raise OSError("no locks")
    fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)


def _remove_leftovers(folder: Path) -> None:
    """Removes what was being written into a folder by processes that were killed: what has a sign that nobody holds."""
    with suppress(OSError):
        partials: dict[str, list[str]] = {}
        for name in os.listdir(folder):
            if found := _PARTIAL.match(name):
                partials.setdefault(found[1], []).append(name)
        for mark, names in partials.items():
            sign = _sign_place(folder, mark)
            with suppress(OSError), sign.open("rb+") as file:
                _lock(file.fileno())
                for name in names:
                    if name != sign.name:
                        (folder / name).unlink()
                sign.unlink()


@contextmanager
def files(folder: Path) -> Iterator[Files]:
    """Files that have their names once the block ends, and are not there where it ends with an exception.

    The folder is made where there is none.

    Raises:
        StoreError: they cannot be written.
    """
    made = [path for path in (folder, *folder.parents) if not os.path.exists(path)]
    written = Files(folder)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        yield written
        written.keep()
    except BaseException as error:
        written.drop()
        for path in made:
            with suppress(OSError):
                path.rmdir()
        if isinstance(error, OSError):
            message = f"{written.target}: cannot be written ({error.strerror or error}); nothing of it is left"
            raise StoreError(message, "Write", {"path": str(written.target)}) from error
        raise
