"""judder: a workbench for friction-induced vibration.

A first result: :func:`demo`, :func:`examples`. Whole cases: :func:`run`, :func:`check`, :func:`limit_memory`, :func:`load_study`, :func:`new`, :func:`schema`, :func:`report`, :func:`explore`; papers:
:func:`reproduce`. Every analysis as a method, every key as an argument: :mod:`judder.models`. Building blocks on NumPy arrays: :mod:`judder.oscillator`,
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
    FaultError,
    FileError,
    InputError,
    Interrupted,
    JudderError,
    JudderWarning,
    LawError,
    MissingFileError,
    NumberError,
    OscillatorError,
    PackageError,
    RewrittenError,
    SlidingError,
    StoreError,
    StructureError,
    StudyError,
    SystemRefusal,
    UnknownResultError,
)
from judder.progress import Progress, tqdm_progress
from judder.study import CaseLike, RemotePath, Study, check, limit_memory, load_study, run

if TYPE_CHECKING:
    from judder import distributed, models
    from judder.programs import Claim, Example, Page, Reproduction, demo, examples, explore, new, report, reproduce, schema, verify

__all__ = [
    "ArgumentError",
    "CaseError",
    "CaseLike",
    "Claim",
    "ContactError",
    "Example",
    "FaultError",
    "FileError",
    "InputError",
    "Interrupted",
    "JudderError",
    "JudderWarning",
    "LawError",
    "MissingFileError",
    "NumberError",
    "OscillatorError",
    "PackageError",
    "Page",
    "Progress",
    "RemotePath",
    "Reproduction",
    "RewrittenError",
    "SlidingError",
    "StoreError",
    "StructureError",
    "Study",
    "StudyError",
    "SystemRefusal",
    "UnknownResultError",
    "__build__",
    "__version__",
    "check",
    "contact",
    "demo",
    "distributed",
    "errors",
    "examples",
    "explore",
    "limit_memory",
    "load_study",
    "models",
    "new",
    "oscillator",
    "plot",
    "report",
    "reproduce",
    "run",
    "schema",
    "sliding",
    "sweep",
    "tqdm_progress",
    "verify",
]


def __getattr__(name: str) -> Any:
    """What is imported when it is used, since it takes as long as all else that is ours."""
    if name in ("distributed", "models", "programs"):
        return importlib.import_module(f"judder.{name}")
    if name in __all__:
        return getattr(importlib.import_module("judder.programs"), name)
    raise AttributeError(f"module 'judder' has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
