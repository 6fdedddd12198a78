"""What calling judder from Python costs beside the work itself, both timed in one run.

    python benches/compare_python.py

Needs the package, built for release: `pip install .`. A point: many calls of `oscillator.point`, beside the same points in one call without
the way back and forth. A spectrum of five points, run in memory as a whole case. A map of 10^6 points: the whole call of `stability_map` with its arrays, beside what the decisions took. The best of some repetitions
counts, on a machine that does nothing else. A bar that is missed exits with 1.
"""

import sys
import time

import numpy as np

import judder
from judder._judder import repeated_points

CALLS = 20_000
REPEATS = 9
SIDE = 1000
POINT_BAR_US = 5.0
MAP_BAR = 0.05
RUN_BAR_MS = 3.0
RUN = {
    "model": "oscillator",
    "analysis": [{"name": "at", "kind": "spectrum", "sweep": {"key": "contact.shear_strength", "from": 0.0, "to": 0.2, "points": 5}}],
}


def best(work) -> float:
    """The shortest of some repetitions, s."""
    seconds = []
    for _ in range(REPEATS):
        begin = time.perf_counter()
        work()
        seconds.append(time.perf_counter() - begin)
    return min(seconds)


def points() -> tuple[float, float]:
    """Seconds a call of `point`, and a point without the call."""

    def call() -> None:
        for _ in range(CALLS):
            judder.oscillator.point(velocity=1e-4, normal_load=1e-6, shear_strength=0.01)

    return best(call) / CALLS, best(lambda: repeated_points(CALLS)) / CALLS


def maps(growth_rate: bool) -> tuple[float, float]:
    """Seconds of the best call of `stability_map`, and of the work in it."""
    sides = ("velocity", np.logspace(-6, 0, SIDE)), ("shear_strength", np.linspace(0.0, 0.2, SIDE))
    found = []
    for _ in range(REPEATS):
        begin = time.perf_counter()
        work = judder.oscillator.stability_map(*sides, growth_rate=growth_rate).seconds
        found.append((time.perf_counter() - begin, work))
    return min(found)


def main() -> int:
    called, worked = (1e6 * seconds for seconds in points())
    is_met = [called - worked <= POINT_BAR_US]
    print(f"oscillator.point: {called:.2f} us a call, {worked:.2f} us the work")
    print(f"  {'met   ' if is_met[0] else 'MISSED'} {called - worked:.2f} us beyond the work (at most {POINT_BAR_US:g})")
    run = 1e3 * best(lambda: judder.run(RUN))
    is_met.append(run <= RUN_BAR_MS)
    print(f"judder.run, a spectrum of five points in memory: {run:.2f} ms")
    print(f"  {'met   ' if is_met[-1] else 'MISSED'} {run:.2f} ms (at most {RUN_BAR_MS:g} ms)")
    for growth_rate, words in ((False, "verdicts"), (True, "verdicts and growth rates")):
        whole, work = maps(growth_rate)
        is_met.append(whole / work - 1.0 <= MAP_BAR)
        print(f"stability_map, {SIDE}^2 points, {words}: {1e3 * whole:.1f} ms, {1e3 * work:.1f} ms the work")
        print(f"  {'met   ' if is_met[-1] else 'MISSED'} {100 * (whole / work - 1.0):.1f} % beyond the work (at most {100 * MAP_BAR:g} %)")
    return 0 if all(is_met) else 1


if __name__ == "__main__":
    sys.exit(main())
