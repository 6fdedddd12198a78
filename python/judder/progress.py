"""How long calls tell how far they are."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeAlias

from judder import _arguments
from judder._packages import needed

__all__ = ["Progress", "tqdm_progress"]

Progress: TypeAlias = Callable[[str, int, int], object]
"""``progress(name, done, total)``: called from the thread that made the call, some twenty times a second. An exception that it raises
ends the call."""


def tqdm_progress(**options: Any) -> Progress:
    """A progress callback that draws a bar of `tqdm <https://tqdm.github.io>`_ for each stretch of work (``pip install 'judder[progress]'``).

    ``options`` go to ``tqdm``.

    Raises:
        PackageError: tqdm is not installed.

    >>> study = judder.run("case.toml", progress=judder.tqdm_progress())  # doctest: +SKIP
    map: 100%|██████████| 202/202 [00:01<00:00, 180.12it/s]
    """
    tqdm = needed("tqdm.auto", "progress", "tqdm_progress").tqdm
    bars: dict[str, Any] = {}

    def progress(name: str, done: int, total: int) -> None:
        if name not in bars:
            for bar in bars.values():
                bar.close()
            bars.clear()
            bars[name] = tqdm(desc=name, total=total, **options)
        bar = bars[name]
        bar.total = total
        bar.update(done - bar.n)
        if done >= total:
            bar.refresh()

    return progress


_arguments.checked(globals())
