"""The methods by which a study writes its results in the files of other programs."""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, cast

from judder import _places
from judder.errors import StoreError

if TYPE_CHECKING:
    from judder._places import RemotePath
    from judder.progress import Progress
    from judder.study import Study


class Exported:
    """A study, as far as it writes its results in the files of other programs."""

    _place: Path | RemotePath | None

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
        from judder import _interchange

        return _interchange.to_parquet(self._study, self._outside(folder, is_folder=True), only, progress)

    def to_csv(self, folder: str | os.PathLike[str], *, only: Iterable[str] = (), progress: Progress | None = None) -> list[Path]:
        """Writes the same tables as comma-separated values: units in the heads, empty cells for NaN, numbers to the last bit.

        ``<result>.columns.csv`` says what the columns are: unit, long name, codes of classes. No package is needed. Arguments, return
        value and errors are those of :meth:`to_parquet`.
        """
        from judder import _interchange

        return _interchange.to_csv(self._study, self._outside(folder, is_folder=True), only, progress)

    def to_netcdf(self, path: str | os.PathLike[str], *, only: Iterable[str] = (), progress: Progress | None = None) -> Path:
        """Writes results into one NetCDF-4 file, a group each, for xarray, MATLAB, Julia (``pip install 'judder[netcdf]'``).

        A complex variable becomes two, ``<name>_real`` and ``<name>_imag``; the points of a sweep without an answer are in a group
        ``failures`` of its group. ``xarray.open_dataset(path, group="map")`` reads one back. Sweeps are written block by block.

        Arguments and errors are those of :meth:`to_parquet`.

        Returns:
            The file.
        """
        from judder import _interchange

        return _interchange.to_netcdf(self._study, self._outside(path, is_folder=False), only, progress)

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
        from judder import _interchange

        return _interchange.to_matlab(self._study, self._outside(path, is_folder=False), only, progress)

    def _outside(self, path: str | os.PathLike[str], *, is_folder: bool) -> Path:
        """The path of a folder or file to write that lies in no study folder, where it could replace what belongs to the study."""
        found = Path(_places.writable(path))
        goes_into = Path(os.path.realpath(found if is_folder else found.parent))
        own = Path(os.path.realpath(self._place)) if isinstance(self._place, Path) else None
        for folder in (goes_into, *goes_into.parents):
            if folder == own or os.path.exists(folder / "results.zarr" / "zarr.json"):
                message = f"{found}: {folder} is a study folder, and nothing is exported into one; name a place beside it"
                raise StoreError(message, "StudyFolder", {"path": str(found), "folder": str(folder)})
        return found

    @property
    def _study(self) -> Study:
        """This as the study that it is."""
        return cast("Study", self)
