"""judder: a workbench for friction-induced vibration.

Whole cases: :func:`run`, :func:`check`, :func:`load_study`. Every analysis as a method, every key as an argument: :mod:`judder.models`. Building blocks on NumPy arrays: :mod:`judder.oscillator`,
:mod:`judder.contact`, :mod:`judder.sliding`. Sweeps of cases: :mod:`judder.sweep`, :mod:`judder.distributed`. Pictures: :mod:`judder.plot`.
Errors: :class:`JudderError` and its subclasses.
"""

import importlib
from typing import TYPE_CHECKING, Any

from judder import contact, errors, oscillator, plot, sliding, sweep
from judder._judder import BUILD as __build__, VERSION as __version__
from judder.errors import (
    ArgumentError,
    CaseError,
    ContactError,
    InputError,
    Interrupted,
    JudderError,
    JudderWarning,
    LawError,
    OscillatorError,
    PackageError,
    RewrittenError,
    SlidingError,
    StoreError,
    StructureError,
    StudyError,
    UnknownResultError,
)
from judder.progress import Progress, tqdm_progress
from judder.study import CaseLike, RemotePath, Study, check, load_study, run

if TYPE_CHECKING:
    from judder import distributed, models

__all__ = [
    "ArgumentError",
    "CaseError",
    "CaseLike",
    "ContactError",
    "InputError",
    "Interrupted",
    "JudderError",
    "JudderWarning",
    "LawError",
    "OscillatorError",
    "PackageError",
    "Progress",
    "RemotePath",
    "RewrittenError",
    "SlidingError",
    "StoreError",
    "StructureError",
    "Study",
    "StudyError",
    "UnknownResultError",
    "__build__",
    "__version__",
    "check",
    "contact",
    "distributed",
    "errors",
    "load_study",
    "models",
    "oscillator",
    "plot",
    "run",
    "sliding",
    "sweep",
    "tqdm_progress",
]


def __getattr__(name: str) -> Any:
    """What is imported when it is used, since it takes as long as all else that is ours."""
    if name in ("distributed", "models"):
        return importlib.import_module(f"judder.{name}")
    raise AttributeError(f"module 'judder' has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
