"""Where studies are: folders of this machine, and folders of object stores, which fsspec reads."""

from __future__ import annotations

import io
import os
import re
import shutil
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import IO, TYPE_CHECKING, Any, NoReturn
from urllib.parse import unquote

from judder._memory import TemporaryFolder
from judder._packages import needed
from judder.errors import InputError, JudderError, PackageError, StoreError, StudyError

if TYPE_CHECKING:
    import xarray

_ABSENT = (FileNotFoundError, NotADirectoryError, IsADirectoryError)
_ADDRESS = re.compile(r"[a-z][a-z0-9+.-]+(://|::)", re.IGNORECASE)
_LOCAL = re.compile(r"(file|local)://", re.IGNORECASE)
_NOT_BESIDE = ("results.zarr", "summary.json", "manifest.json", "report.html", "figures", "inputs")
_copies: list[tempfile.TemporaryDirectory[str]] = []


class RemotePath(os.PathLike[str]):
    """A file or folder of an object store, as far as a ``pathlib.Path`` can be one: it is read and never written.

    Functions that want the path of a file of this machine, as ``open`` and ``pandas.read_csv`` do, get that of a copy, which is fetched
    then and lasts as long as the process.
    """

    def __init__(self, files: Any, root: str, address: str, inner: str = "") -> None:
        self._files, self._root, self._address, self._inner = files, root, address, inner
        self._copy: str | None = None

    def __truediv__(self, inner: str) -> RemotePath:
        return RemotePath(self._files, self._root, self._address, f"{self._inner}/{inner}".strip("/"))

    @property
    def path(self) -> str:
        """The path as the file system of fsspec has it."""
        return "/".join(part for part in (self._root.rstrip("/"), self._inner) if part)

    @property
    def name(self) -> str:
        """The last part."""
        return self.path.rpartition("/")[2]

    @property
    def stem(self) -> str:
        """The last part without what follows its last dot."""
        return Path(self.name).stem

    @property
    def suffix(self) -> str:
        """The last dot of the last part and what follows it."""
        return Path(self.name).suffix

    def read_bytes(self) -> bytes:
        """The content of a file.

        Raises:
            FileNotFoundError: there is none.
            StoreError: the store cannot be read.
        """
        with self._reading():
            content: bytes = self._files.cat_file(self.path)
        return content

    def read_text(self, encoding: str = "utf-8") -> str:
        """The content of a file as text."""
        return self.read_bytes().decode(encoding)

    def open(self, mode: str = "r", *, encoding: str = "utf-8") -> IO[Any]:
        """A file to read from, whole in memory; ``mode`` is ``"r"`` or ``"rb"``.

        Raises:
            StoreError: another mode.
        """
        if mode not in ("r", "rt", "rb"):
            self._refuse()
        content = io.BytesIO(self.read_bytes())
        return content if mode == "rb" else io.TextIOWrapper(content, encoding=encoding)

    def size(self) -> int:
        """The bytes of a file; none counted where the store does not tell.

        Raises:
            FileNotFoundError: there is none.
            StoreError: the store cannot be read.
        """
        with self._reading():
            return int(self._files.size(self.path) or 0)

    def exists(self) -> bool:
        """Whether there is such a file or folder."""
        with self._reading():
            return bool(self._files.exists(self.path))

    def is_file(self) -> bool:
        """Whether it is a file."""
        with self._reading():
            return bool(self._files.isfile(self.path))

    def is_dir(self) -> bool:
        """Whether it is a folder."""
        with self._reading():
            return bool(self._files.isdir(self.path))

    def iterdir(self) -> Iterator[RemotePath]:
        """What is in the folder, in the order of the names.

        Raises:
            FileNotFoundError: there is no such folder; or the store, such as a web server, lists none.
            StoreError: the store cannot be read.
        """
        with self._reading():
            paths = [str(path).rstrip("/") for path in self._files.ls(self.path, detail=False)]
        return (self / path.rpartition("/")[2] for path in sorted(paths))

    def tails(self, names: Sequence[str], length: int) -> list[bytes | None]:
        """The last bytes of files of this folder, all at once; ``None`` for one that is not there."""
        paths = [f"{self.path}/{name}" for name in names]
        with self._reading():
            found = self._files.cat_ranges(paths, [-length] * len(paths), [None] * len(paths), on_error="return")
            for end in found:
                if isinstance(end, Exception) and not isinstance(end, _ABSENT):
                    raise end
        return [None if isinstance(end, Exception) else bytes(end[-length:]) for end in found]

    def mapper(self) -> Any:
        """The folder as the mapping of fsspec."""
        return self._files.get_mapper(self.path)

    def _refuse(self) -> NoReturn:
        raise _read_only(str(self))

    def write_bytes(self, *arguments: object, **named: object) -> NoReturn:
        """Refused."""
        self._refuse()

    def write_text(self, *arguments: object, **named: object) -> NoReturn:
        """Refused."""
        self._refuse()

    def touch(self, *arguments: object, **named: object) -> NoReturn:
        """Refused."""
        self._refuse()

    def mkdir(self, *arguments: object, **named: object) -> NoReturn:
        """Refused."""
        self._refuse()

    def unlink(self, *arguments: object, **named: object) -> NoReturn:
        """Refused."""
        self._refuse()

    def rename(self, *arguments: object, **named: object) -> NoReturn:
        """Refused."""
        self._refuse()

    @contextmanager
    def _reading(self) -> Iterator[None]:
        try:
            yield
        except _ABSENT as error:
            raise FileNotFoundError(f"{self}: not there") from error
        # stores have exceptions of their own, of any class
        except Exception as error:
            raise StoreError(f"{self}: cannot be read ({type(error).__name__}: {error})", "Unreadable", {"path": str(self)}) from error

    def __fspath__(self) -> str:
        if self._copy is None:
            if self.is_dir():
                raise StoreError(f"{self}: a folder of an object store has no path on this machine", "Remote", {"path": str(self)})
            content = self.read_bytes()
            _copies.append(tempfile.TemporaryDirectory(prefix="judder-"))
            copy = Path(_copies[-1].name) / self.name
            copy.write_bytes(content)
            self._copy = str(copy)
        return self._copy

    def __str__(self) -> str:
        first, chain, rest = self._address.partition("::")
        scheme, _, inside = first.partition("://")
        return f"{scheme}://{'/'.join(part for part in (inside.rstrip('/'), self._inner) if part)}{chain}{rest}"

    def __repr__(self) -> str:
        return f"RemotePath({str(self)!r})"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, RemotePath) and (str(self), self._files) == (str(other), other._files)

    def __hash__(self) -> int:
        return hash(str(self))


def place(folder: str | os.PathLike[str], storage_options: Mapping[str, Any] | None = None) -> Path | RemotePath:
    """A folder to read from, given by its path (``~`` is the home folder), its address, or a path of universal-pathlib."""
    if isinstance(folder, RemotePath):
        return folder
    if hasattr(folder, "fs") and hasattr(folder, "path") and not isinstance(folder, Path):
        return RemotePath(folder.fs, folder.path, str(folder))
    text = os.fspath(folder)
    if _is_remote(text):
        return _opened(text, storage_options or {})
    if storage_options:
        message = f"storage_options: {text} is a folder of this machine, which takes none"
        raise InputError(message, "Input", {"argument": "storage_options"})
    return _local(text)


def writable(folder: str | os.PathLike[str]) -> str:
    """The path of a file or folder of this machine, to write to.

    Raises:
        StoreError: it is in an object store, or no path at all.
    """
    if isinstance(folder, RemotePath) or (hasattr(folder, "fs") and not isinstance(folder, Path)):
        raise _read_only(str(folder))
    text = os.fspath(folder)
    if _is_remote(text):
        raise _read_only(text)
    if "\0" in text:
        raise StoreError(f"{text!r}: no path has a NUL in it", "Write", {"path": text})
    return str(_local(text))


@contextmanager
def reading(folder: Path | RemotePath, name: str) -> Iterator[None]:
    """Names the result that cannot be read: stores and codecs have exceptions of their own, of any class.

    Raises:
        StoreError: it cannot.
    """
    try:
        yield
    except JudderError:
        raise
    except Exception as error:
        message = f"{folder}: `{name}` cannot be read ({type(error).__name__}: {error})"
        raise StoreError(message, "Unreadable", {"path": str(folder)}) from error


def group(folder: Path | RemotePath, name: str, expected: str | None = None) -> xarray.Dataset:
    """The dataset of an analysis or a sweep as it is stored, read when it is used.

    Raises:
        RewrittenError: it has another hash than the expected one; also later, when its values are read.
    """
    import xarray

    from judder import _summaries
    from judder._guarded import GuardedStore

    store: Any = folder / "results.zarr"
    if isinstance(store, RemotePath):
        from zarr.storage import FsspecStore

        store = FsspecStore.from_mapper(store.mapper(), read_only=True)
    else:
        from zarr.storage import LocalStore

        store = LocalStore(store, read_only=True)
    guarded = GuardedStore(store, str(folder), name, expected, TemporaryFolder.of(folder), _summaries.files(folder))
    return xarray.open_dataset(guarded, engine="zarr", group=name, chunks=None, zarr_format=3)  # type: ignore[arg-type]


def tails(folder: Path | RemotePath, names: Sequence[str], length: int) -> list[bytes | None]:
    """The last bytes of files of a folder; ``None`` for one that is not there."""
    if isinstance(folder, RemotePath):
        return folder.tails(names, length)
    return [_tail(folder / name, length) for name in names]


def listed(folder: Path | RemotePath, inner: str, suffix: str) -> dict[str, Path | RemotePath]:
    """The files in a folder of a study that end so, by their stems; none where there is no such folder.

    Raises:
        StoreError: an object store that cannot be listed.
    """
    try:
        paths: list[Path | RemotePath] = list((folder / inner if inner else folder).iterdir())
    except (FileNotFoundError, NotADirectoryError):
        if isinstance(folder, RemotePath) and not _lists(folder):
            message = f"{folder}: this store lists no files; name one, such as `study.folder / 'figures/map.svg'`"
            raise StoreError(message, "Unlisted", {"path": str(folder)}) from None
        return {}
    return {path.stem: path for path in sorted(paths, key=str) if path.suffix == suffix}


def beside(folder: Path | RemotePath, inner: str = "") -> Iterator[tuple[str, Path | RemotePath]]:
    """The files of a study beside its arrays, its summary and its report, by their paths in it."""
    paths: list[Path | RemotePath] = list((folder / inner if inner else folder).iterdir())
    for path in sorted(paths, key=str):
        name = f"{inner}/{path.name}" if inner else path.name
        if name in _NOT_BESIDE or path.name.startswith("."):
            continue
        if path.is_dir():
            yield from beside(folder, name)
        else:
            yield name, path


def copy(folder: Path | RemotePath, target: Path) -> None:
    """Copies a study folder to where there is nothing yet.

    Raises:
        StoreError: there is something, it cannot be written, or the study is in an object store.
    """
    if isinstance(folder, RemotePath):
        raise StoreError(f"{folder}: a study in an object store is copied by the tools of the store", "Remote", {"path": str(folder)})
    if target.exists() and not (target.is_dir() and not any(target.iterdir())):
        raise StoreError(f"{target}: is there already; a study is copied into a new folder", "Write", {"path": str(target)})
    try:
        shutil.copytree(folder, target, ignore=shutil.ignore_patterns(".*"), dirs_exist_ok=True)
    except OSError as error:
        raise StoreError(f"{target}: cannot be written ({error})", "Write", {"path": str(target)}) from error


def _lists(folder: RemotePath) -> bool:
    try:
        return any(True for _ in folder.iterdir())
    except FileNotFoundError:
        return False


def _tail(path: Path, length: int) -> bytes | None:
    try:
        with path.open("rb") as file:
            file.seek(max(0, file.seek(0, os.SEEK_END) - length))
            return file.read()
    except FileNotFoundError:
        return None


def _is_remote(text: str) -> bool:
    return _ADDRESS.match(text) is not None and _LOCAL.match(text) is None


def _local(text: str) -> Path:
    match = _LOCAL.match(text)
    if match is None:
        return Path(os.path.expanduser(text))
    host, slash, path = text[match.end() :].partition("/")
    if host not in ("", "localhost"):
        message = f"{text}: files of another machine have no such address; file:///{host}/… is one here"
        raise InputError(message, "Input", {"argument": "folder"})
    return Path(unquote(slash + path))


def _opened(address: str, storage_options: Mapping[str, Any]) -> RemotePath:
    if not isinstance(storage_options, Mapping):
        raise InputError(f"storage_options: a mapping is needed, not {storage_options!r}", "Input", {"argument": "storage_options"})
    core = needed("fsspec.core", "remote", f"{address}: an address")
    try:
        files, root = core.url_to_fs(address, **storage_options)
    except ImportError as error:
        raise PackageError(f"{address}: {error}", "MissingPackage", {"package": error.name or "", "extra": ""}) from error
    except FileNotFoundError as error:
        raise StudyError(f"{address}: no study here; {error} is not there", "NoStudy", {"folder": address}) from error
    except Exception as error:
        raise InputError(f"{address}: cannot be opened ({error})", "Input", {"argument": "folder"}) from error
    # what was listed before may have changed since
    files.invalidate_cache()
    return RemotePath(files, root, address)


def _read_only(address: str) -> StoreError:
    message = (
        f"{address}: studies in an object store are read and never written; "
        "name a folder of this machine, and copy it there when it is done"
    )
    return StoreError(message, "ReadOnly", {"path": address})
