"""Studies without a folder of their own: in memory, or in a temporary folder that lasts as long as they do."""

from __future__ import annotations

import io
import json
import shutil
import tempfile
import weakref
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar
from weakref import WeakValueDictionary

from judder._numpy import np

if TYPE_CHECKING:
    import xarray

    from judder import _judder


def dataset(held: _judder.HeldStudy, name: str, judder_hash: str) -> xarray.Dataset:
    """The dataset that a stored study has of an analysis, made of a copy of its arrays."""
    import xarray

    head, arrays = held.arrays(name)
    told: dict[str, Any] = json.loads(head)
    variables: dict[str, Any] = {}
    coordinates: dict[str, Any] = {}
    for own, values in zip(told["variables"], arrays, strict=True):
        kind = coordinates if own["is_coordinate"] else variables
        kind[own["name"]] = xarray.Variable(own["dimensions"], _array(values), own["attributes"])
    return xarray.Dataset(variables, coordinates, {**told["attributes"], "judder_hash": judder_hash})


def _array(values: Any) -> Any:
    """Words as Zarr gives them back; numbers as they are."""
    if not isinstance(values, list):
        return values
    return np.array(values, dtype=np.dtypes.StringDType() if hasattr(np.dtypes, "StringDType") else object)


class TemporaryFolder:
    """A folder for a study that lasts as long as this: as long as the study, or data of it that are read when they are used."""

    folder: Path
    """The folder."""
    _known: ClassVar[WeakValueDictionary[Path, TemporaryFolder]] = WeakValueDictionary()

    def __init__(self) -> None:
        made = tempfile.mkdtemp(prefix="judder-")
        self.folder = Path(made) / "study"
        self._known[self.folder] = self
        weakref.finalize(self, shutil.rmtree, made, ignore_errors=True)

    def __reduce__(self) -> tuple[Any, ...]:
        # what is sent elsewhere finds the folder, and does not own it
        return _same, (None,)

    @classmethod
    def of(cls, folder: object) -> TemporaryFolder | None:
        """The temporary folder that this is, where it is one."""
        return cls._known.get(folder) if isinstance(folder, Path) else None


def _same(value: None) -> None:
    return value


def packed(folder: Path) -> bytes:
    """All files of a folder."""
    import tarfile

    content = io.BytesIO()
    with tarfile.open(fileobj=content, mode="w") as archive:
        archive.add(folder, arcname=".")
    return content.getvalue()


def unpacked(content: bytes) -> TemporaryFolder:
    """A folder with these files."""
    import tarfile

    own = TemporaryFolder()
    with tarfile.open(fileobj=io.BytesIO(content)) as archive:
        archive.extractall(own.folder, filter="data")
    return own
