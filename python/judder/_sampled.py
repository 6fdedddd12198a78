"""Friction coefficients that are functions of the speed, as tables that are read with straight lines between their points."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from judder._columns import described, wrong
from judder._numpy import np

if TYPE_CHECKING:
    from numpy.typing import NDArray

_FIRST = 9
FASTEST = 1e2
"""Beyond what slides, m/s."""
SPEED_TOLERANCE = 1e-5
_MOST = 10_000
"""Points of a table; the curves of friction need some hundreds at a tolerance of 1e-6."""


def speeds_of_sliding() -> NDArray[np.float64]:
    """Speeds between which a law is looked at first where nobody says how fast: from rest to beyond what slides, m/s."""
    return np.concatenate([[0.0], np.geomspace(1e-6, FASTEST, 33)])


def _reals(argument: str, given: Any) -> NDArray[np.float64]:
    """What a function gives, as real numbers; whether they are finite is not looked at."""
    array = np.asarray(given)
    if array.dtype.kind in "fiuO":
        try:
            return array.astype(np.float64)
        except (TypeError, ValueError):
            pass
    raise wrong(argument, f"gives {described(given)} of {array.dtype}, and real numbers are needed")


def sampled(
    argument: str, function: Callable[[NDArray[np.float64]], Any], span: tuple[float, float], tolerance: float, *, first: NDArray[np.float64] | None = None
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Speeds and friction coefficients such that straight lines are off by no more than a tolerance of the largest value, looked at within all intervals,
    those between the `first` points to begin with.

    Raises:
        InputError: values that are negative, or not real and finite, or not as many as points; a function that would need too many points.
        Exception: what the function itself raises, as it is, with a note that says where it was given.
    """
    begin, end = map(float, span)
    if not (0.0 <= begin < end < np.inf and 0.0 < tolerance < 1.0):
        needed = "a range that rises from 0 or more, and a tolerance between 0 and 1 are needed"
        raise wrong(argument, f"goes from {begin:g} to {end:g} with a tolerance of {tolerance:g}; {needed}")

    def values(at: NDArray[np.float64]) -> NDArray[np.float64]:
        try:
            given = function(at)
        except Exception as error:
            error.add_note(f"raised by the function that was given as `{argument}`")
            raise
        found = _reals(argument, given)
        found = np.full(at.shape, float(found)) if found.ndim == 0 else found
        if found.shape != at.shape:
            raise wrong(argument, f"gives an array of the shape {found.shape} for one of the shape {at.shape}")
        if not np.isfinite(found).all():
            raise wrong(argument, f"is not finite at {at[~np.isfinite(found)][0]:g}")
        if (found < 0.0).any():
            first = int(np.argmax(found < 0.0))
            raise wrong(argument, f"is {found[first]:g} at a speed of {at[first]:g}; a friction coefficient is zero or more at every speed")
        return found

    points = np.linspace(begin, end, _FIRST) if first is None else first
    known = values(points)
    while True:
        within = points[:-1, None] + np.diff(points)[:, None] * np.array([0.25, 0.5, 0.75])
        there = values(within.ravel()).reshape(within.shape)
        off = np.abs(there - np.interp(within, points, known)).max(axis=1) > tolerance * np.abs(known).max()
        if not off.any():
            return points, known
        if points.size + off.sum() > _MOST or np.diff(points)[off].min() < 1e-9 * (end - begin):
            raise wrong(argument, f"would need more than {_MOST} points, the closest near {within[off][0, 1]:g}; has it a jump there?")
        order = np.argsort(np.concatenate([points, within[off, 1]]), kind="stable")
        points, known = np.concatenate([points, within[off, 1]])[order], np.concatenate([known, there[off, 1]])[order]
