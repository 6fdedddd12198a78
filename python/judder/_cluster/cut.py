"""A chunk that ends even the workers beside which it is computed, cut until the point is found that does."""

from __future__ import annotations

from collections import Counter, deque
from typing import TYPE_CHECKING

from judder._cluster import alone

if TYPE_CHECKING:
    from judder import _judder
    from judder._cluster.alone import Row

Span = tuple[int, int]


class Cut:
    """The points of such a chunk, in spans that become smaller where they are lost.

    A process of its own does not help where the system ends all processes of a worker together, as it does with a container that takes too much
    memory.
    """

    def __init__(self, sweep: _judder.Sweep, chunk: int, retries: int) -> None:
        self.chunk = chunk
        self._sweep = sweep
        self._retries = retries
        self._rows: list[Row | None] = [None] * sweep.count(chunk)
        self._losses: Counter[Span] = Counter()
        self._left: deque[Span] = deque([(0, len(self._rows))])

    def next(self) -> Span | None:
        """A span that is to be computed, where there is one now."""
        return self._left.popleft() if self._left else None

    def take(self, span: Span, rows: tuple[Row, ...]) -> None:
        """Takes in the columns of a span."""
        self._rows[slice(*span)] = rows

    def lost(self, span: Span) -> str | None:
        """A span that was lost with its worker: halved, or tried again; at last its only point has failed, and what is to be said of it comes back."""
        first, end = span
        if end - first > 1:
            middle = (first + end) // 2
            self._left.extend([(first, middle), (middle, end)])
            return None
        self._losses[span] += 1
        if self._losses[span] <= self._retries:
            self._left.append(span)
            return None
        self._rows[first] = alone.without_values(self._sweep, self.chunk, first)
        return f"{self._sweep.name}: point {first} of chunk {self.chunk} ended its worker {self._losses[span]} times"

    def again(self, span: Span) -> None:
        """A span that nobody has computed."""
        self._left.append(span)

    def content(self) -> bytes | None:
        """The content of the chunk once it has all points."""
        rows = [row for row in self._rows if row is not None]
        return alone.assembled(self._sweep, self.chunk, rows) if len(rows) == len(self._rows) else None
