"""A process that computes what it is ordered, and may die of it: reads an order, says that it is ready, then what it has computed."""

from __future__ import annotations

import os
import pickle
import sys
from collections.abc import Callable

from judder._cluster.alone import READY, Order


def _serve(order: Order, say: Callable[[object], None]) -> None:
    """Says the contents of chunks, or the points of one."""
    package, name, expected, threads, chunks, points = order
    sweep = package.sweep(name, expected, threads)
    sweep.prepare()
    say(READY)
    if points is None:
        for chunk in chunks:
            say(sweep.compute([chunk])[0])
        return
    for index in range(*points):
        row, reason = sweep.point(chunks[0], index)
        say((row.tolist(), reason))


def _main() -> None:
    # what a library prints must not get between the messages
    out = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)

    def say(message: object) -> None:
        pickle.dump(message, out)
        out.flush()

    try:
        order = pickle.load(sys.stdin.buffer)
        _serve(order, say)
    except BaseException as error:
        say(error)


if __name__ == "__main__":
    _main()
