"""An array for xarray that is another one times a factor."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from xarray.backends import BackendArray
from xarray.core import indexing

if TYPE_CHECKING:
    import xarray


def scaled(variable: xarray.Variable, factor: float) -> Any:
    """The values of a variable times a factor, read when they are used and kept then, as those are that xarray opens."""
    arrays: Any = indexing
    return arrays.MemoryCachedArray(arrays.CopyOnWriteArray(arrays.LazilyIndexedArray(ScaledArray(variable, factor))))


class ScaledArray(BackendArray):
    """The values of a variable times a factor, block by block as they are asked for."""

    def __init__(self, variable: xarray.Variable, factor: float) -> None:
        self.shape, self.dtype = variable.shape, variable.dtype
        self._variable, self._factor = variable, factor

    def __getitem__(self, key: indexing.ExplicitIndexer) -> Any:
        return indexing.explicit_indexing_adapter(key, self.shape, indexing.IndexingSupport.BASIC, self._values)

    def _values(self, key: tuple[Any, ...]) -> Any:
        return self._factor * self._variable[key].values
