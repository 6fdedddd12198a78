"""Files that are there whole or not at all."""

from __future__ import annotations

import os
import secrets
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from judder.errors import StoreError


class Files:
    """Files of one folder under temporary names, until all are written."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self._mark = secrets.token_hex(4)
        self._named: dict[Path, Path] = {}

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

    def drop(self) -> None:
        """Removes what has been written."""
        for partial in self._named.values():
            with suppress(OSError):
                partial.unlink()


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
