"""How long calls tell how far they are."""

from __future__ import annotations

import importlib
from collections.abc import Callable
from typing import Any, TypeAlias

__all__ = ["Progress", "tqdm_progress"]

Progress: TypeAlias = Callable[[str, int, int], object]
"""``progress(name, done, total)``: called from the thread that made the call, some twenty times a second. An exception that it raises
ends the call."""


def tqdm_progress(**options: Any) -> Progress:
    """A progress callback that draws a bar of `tqdm <https://tqdm.github.io>`_, which must be installed, for each stretch of work.

    ``options`` go to ``tqdm``.

    >>> study = judder.run("case.toml", progress=judder.tqdm_progress())  # doctest: +SKIP
    map: 100%|██████████| 202/202 [00:01<00:00, 180.12it/s]
    """
    # by its name: it brings no types of its own
    tqdm: Any = importlib.import_module("tqdm.auto").tqdm
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
