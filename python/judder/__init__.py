"""judder: a workbench for friction-induced vibration.

Whole cases: :func:`run`, :func:`check`, :func:`load_study`. Every analysis as a method, every key as an argument: :mod:`judder.models`. Building blocks on NumPy arrays: :mod:`judder.oscillator`,
:mod:`judder.contact`, :mod:`judder.sliding`. Sweeps of cases: :mod:`judder.sweep`, :mod:`judder.distributed`. Pictures: :mod:`judder.plot`.
Errors: :class:`JudderError` and its subclasses.
"""

from judder import contact, distributed, errors, models, oscillator, plot, sliding, sweep
from judder._judder import VERSION as __version__
from judder.errors import (
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

__all__ = [
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
