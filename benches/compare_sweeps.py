"""Sweeps against their bars, in one run: two processes beside one, the store beside the points, opening a finished study.

    python benches/compare_sweeps.py

Needs the package judder and xarray. The bars are meant for a machine with two cores that do nothing else.

- A sweep of 10 000 chunks, 7 ms each, by one process with one thread, then by two such processes that race on one folder, then by two that
  have half of the chunks each: the time of one, divided by twice the time of two.
- A chunk of the size that the program chooses: computed and stored, beside computed alone; the median of several.
- A study of a million points, finished: from `judder.load_study` to the xarray.Dataset of its sweep, in a process of its own that has loaded the
  packages before.
"""

import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import judder

EFFICIENCY = 0.90
OVERHEAD = 0.03
OPENING = 0.3

CHUNKS = 10_000
CASE = """
model = "oscillator"
[[sweep]]
name = "map"
over = [
  {{ key = "operation.velocity", from = 1e-6, to = 1, points = {velocities}, scale = "log" }},
  {{ key = "contact.shear_strength", from = 1e-3, to = 0.2, points = {strengths} }},
]
quantities = ["growth_rate", "frequency", "verdict"]
{more}
"""
OPEN = """
import sys, time, xarray, zarr, judder
try:
    import dask.array
except ImportError:
    pass
began = time.perf_counter()
data = judder.load_study(sys.argv[1])["map"]
print(time.perf_counter() - began)
assert data.growth_rate.size == 1_000_000
"""


def processes(case: Path, folder: Path, shards: list[str]) -> float:
    """Seconds until all of these parts are done, a process each."""
    words = [sys.executable, "-m", "judder", "run", str(case), "-o", str(folder), "--threads", "1", "-q"]
    began = time.perf_counter()
    running = [subprocess.Popen([*words, "--shard", shard]) for shard in shards]
    if any(process.wait() for process in running):
        sys.exit("a process has failed")
    return time.perf_counter() - began


def points_for(seconds: float) -> int:
    """How many points take so long, on one thread."""
    probe = judder.sweep.plan(CASE.format(velocities=100, strengths=100, more="chunk = 10000"))
    probe.values(0)
    began = time.perf_counter()
    probe.values(0)
    return max(1, round(seconds / (time.perf_counter() - began) * 10_000))


def efficiency(scratch: Path) -> list[tuple[str, float]]:
    """The time of one process over that of two, for each."""
    strengths = points_for(0.007)
    case = scratch / "case.toml"
    case.write_text(CASE.format(velocities=CHUNKS, strengths=strengths, more=f"chunk = {strengths}"))
    chunks = judder.sweep.plan(case).chunks
    one = processes(case, scratch / "one", ["1/1"])
    print(f"{chunks} chunks of {strengths} points")
    print(f"  one process                    {one:8.1f} s")
    found = []
    for name, shards in (("two that race on one folder", ["1/1", "1/1"]), ("two with half of them each", ["1/2", "2/2"])):
        two = processes(case, scratch / name.replace(" ", "-"), shards)
        print(f"  {name:30s} {two:8.1f} s")
        found.append((f"{name}, efficiency", one / (2 * two)))
    return found


def overhead(scratch: Path) -> float:
    """What the store adds to the time of a chunk of the size that the program chooses."""
    sweep = judder.sweep.plan(CASE.format(velocities=2000, strengths=1500, more=""))
    compiled = sweep._compiled
    sweep.values(0)
    alone, stored = [], []
    for chunk in range(min(9, sweep.chunks)):
        began = time.perf_counter()
        sweep.values(chunk)
        alone.append(time.perf_counter() - began)
        began = time.perf_counter()
        compiled.compute_into(str(scratch / "overhead"), [chunk])
        stored.append(time.perf_counter() - began)
    points = sweep.points / sweep.chunks
    print(f"a chunk of {points:.0f} points: {statistics.median(alone):.3f} s computed, {statistics.median(stored):.3f} s computed and stored")
    return statistics.median(own / other for own, other in zip(stored, alone, strict=True)) - 1.0


def opening(scratch: Path) -> float:
    """Seconds until the dataset of a finished study of a million points is there."""
    case, folder = scratch / "million.toml", scratch / "million"
    case.write_text(CASE.format(velocities=1000, strengths=1000, more=""))
    judder.run(case, output=folder)
    words = [sys.executable, "-c", OPEN, str(folder)]
    return min(float(subprocess.run(words, check=True, stdout=subprocess.PIPE, text=True).stdout) for _ in range(3))


def main() -> int:
    with tempfile.TemporaryDirectory() as scratch:
        bars = [(name, value, value >= EFFICIENCY, f"at least {EFFICIENCY:.0%}") for name, value in efficiency(Path(scratch))]
        added = overhead(Path(scratch))
        bars.append(("what the store adds", added, added <= OVERHEAD, f"at most {OVERHEAD:.0%}"))
        seconds = opening(Path(scratch))
    for name, value, is_met, bar in bars:
        print(f"  {'met   ' if is_met else 'MISSED'} {name}: {value:.1%} ({bar})")
    print(f"  {'met   ' if seconds < OPENING else 'MISSED'} opening a study of a million points: {seconds:.3f} s (below {OPENING:g} s)")
    return 0 if seconds < OPENING and all(is_met for _, _, is_met, _ in bars) else 1


if __name__ == "__main__":
    sys.exit(main())
