"""The summaries of studies: ``summary.json``."""

from __future__ import annotations

import json
import stat
from pathlib import Path
from typing import TYPE_CHECKING, Any

from judder import _judder
from judder.errors import StoreError, StudyError

if TYPE_CHECKING:
    from judder._places import RemotePath


def read(folder: Path | RemotePath) -> dict[str, Any]:
    """The content of the summary in a study folder.

    Raises:
        StudyError: there is none, or it cannot be read.
        StoreError: it is not what was written, as the manifest of the study says.
    """
    try:
        content = _document(folder / "summary.json")
        found: dict[str, Any] = json.loads(content)
    except (FileNotFoundError, NotADirectoryError):
        raise _no_study(folder, "no study here; `judder.run` makes one") from None
    except (ValueError, OSError, StoreError) as error:
        raise _no_study(folder, f"the summary cannot be read ({error})") from error
    if not _is_summary(found):
        raise _no_study(folder, "summary.json is none of judder's")
    manifest = _manifest(folder)
    if manifest is not None:
        _judder.vouch_for_summary(str(folder), manifest, content)
    return found


def files(folder: Path | RemotePath) -> dict[str, tuple[int, str]] | None:
    """Size and hash of every file of a study, by the paths in it; ``None`` of one without a manifest.

    Raises:
        StoreError: the store cannot be read.
    """
    manifest = _manifest(folder)
    if manifest is None:
        return None
    return {path: (record["bytes"], record["hash"]) for path, record in json.loads(manifest)["files"].items()}


def _manifest(folder: Path | RemotePath) -> bytes | None:
    """The list of what a study holds; ``None`` where there is none."""
    try:
        return _document(folder / "manifest.json")
    except (FileNotFoundError, NotADirectoryError):
        return None


def _document(path: Path | RemotePath) -> bytes:
    """The bytes of a document of a study.

    Raises:
        StoreError: it is no regular file, or larger than any such document.
    """
    if isinstance(path, Path) and not stat.S_ISREG(path.stat().st_mode):
        raise StoreError(f"{path}: is no regular file", "Unreadable", {"path": str(path)})
    size, largest = path.stat().st_size if isinstance(path, Path) else path.size(), _judder.LARGEST_DOCUMENT
    if size > largest:
        message = f"{path}: it has {size} bytes, where such a file has at most {largest}"
        raise StoreError(message, "Oversized", {"path": str(path), "size": size, "largest": largest})
    return path.read_bytes()


def _is_summary(found: Any) -> bool:
    """Whether a document has what every summary has."""
    if not isinstance(found, dict) or not all(isinstance(found.get(key), dict) for key in ("case", "analyses", "results")):
        return False
    asked = [found["case"].get(kind, []) for kind in ("analysis", "sweep")]
    named = all(isinstance(some, list) and all(isinstance(one, dict) and isinstance(one.get("name"), str) for one in some) for some in asked)
    return named and all(isinstance(record, dict) and "status" in record for record in found["analyses"].values())


def _no_study(folder: Path | RemotePath, reason: str) -> StudyError:
    return StudyError(f"{folder}: {reason}", "NoStudy", {"folder": str(folder)})
