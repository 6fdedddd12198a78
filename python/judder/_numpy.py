"""NumPy, imported when it is used: it takes longer than all that is judder's, and a process that asks for a version or a report has no arrays."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

__all__ = ["np"]

if TYPE_CHECKING:
    import numpy as np
else:

    class _NumpyWhenUsed:
        def __getattr__(self, name: str) -> Any:
            import numpy

            vars(self)[name] = found = getattr(numpy, name)
            return found

    np = _NumpyWhenUsed()
