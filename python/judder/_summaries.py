"""The summaries of studies: ``summary.json``."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

from judder.errors import StoreError, StudyError

if TYPE_CHECKING:
    from judder._places import RemotePath


def read(folder: Path | RemotePath) -> dict[str, Any]:
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
