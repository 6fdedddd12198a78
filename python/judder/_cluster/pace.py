"""How many chunks make a task."""

from __future__ import annotations

_SECONDS = 1.0
"""What a task should take at least."""
_SECONDS_A_SLOT = 0.01
"""What it should take for every thread of the cluster: a scheduler needs a millisecond or two for a task, and has them all."""
_BYTES = 1 << 25
"""What a task may send back."""
_ALL_BYTES = 1 << 30
"""What all tasks that are handed out may send back."""
_GROWTH = 8
"""How many times more chunks a task may have than those that were timed."""


class Pace:
    """Learns from tasks that have ended how many chunks the next ones should have."""

    def __init__(self, fixed: int | None) -> None:
        self._fixed = fixed
        self._seconds: float | None = None
        self._bytes = 0.0
        self._largest = 1

    def learn(self, chunks: int, seconds: float, sent: int) -> None:
        """Takes in a task of so many chunks that took so long and sent so many bytes back."""
        each = seconds / chunks
        # the newest counts a quarter: chunks of one sweep may differ
        self._seconds = each if self._seconds is None else 0.75 * self._seconds + 0.25 * each
        self._bytes = max(self._bytes, sent / chunks)
        self._largest = max(self._largest, chunks)

    def chunks(self, left: int, slots: int) -> int:
        """How many chunks the next task should have, where so many are left for so many threads."""
        if self._fixed is not None:
            return self._fixed
        if self._seconds is None:
            return 1
        wanted = max(_SECONDS, _SECONDS_A_SLOT * slots) / max(self._seconds, 1e-9)
        if self._bytes > 0.0:
            wanted = min(wanted, min(_BYTES, _ALL_BYTES / (2 * slots)) / self._bytes)
        # towards the end small ones, so that all threads end together
        return int(max(1, min(wanted, _GROWTH * self._largest, left / (2 * slots))))
