"""The elastic contact of rough periodic surfaces: judder beside Tamaas and ASPHER, in one run, one thread each, A B C A B C.

    python benches/compare_rough.py [--rounds N] [--cells 512 1024] [--load 0.05]

Needs the packages of benches/peer/requirements.txt and cargo. Every pressure is judged by one function here: complementarity, penetration and
load, recomputed. Each peer runs with the loosest of its own tolerances whose pressure passes; a peer that passes with none is
disqualified, not timed. judder's time includes the start of its program, the reading of the surface and the writing of the pressure
(in its CPU seconds). Exit code 1 where judder fails its own test.
"""

import argparse
import json
import os
import resource
import subprocess
import sys
import tempfile
from pathlib import Path
from statistics import median

import numpy as np

HERE = Path(__file__).resolve().parent
PEERS = ("tamaas", "aspher", "aspher-mixed")
OWN_TOLERANCES = (1e-5, 3e-6, 1e-6, 3e-7, 1e-7, 3e-8, 1e-8, 1e-9)
ONE_THREAD = os.environ | {f"{library}_NUM_THREADS": "1" for library in ("OMP", "OPENBLAS", "MKL")}


def rough_surface(cells: int, seed: int = 1) -> np.ndarray:
    """Self-affine, Hurst 0.8 between 4 and cells/8 waves a side, root mean square of the slope 1, the lowest point 0."""
    wave = np.fft.fftfreq(cells, 1 / cells)
    waves = np.hypot(wave[:, None], wave[None, :])
    filtered = np.where((waves > 0) & (waves <= cells / 8), np.maximum(waves, 4.0) ** -1.8, 0.0)
    spectrum = filtered * np.fft.fft2(np.random.default_rng(seed).standard_normal((cells, cells)))
    slope = np.sqrt(np.sum((2 * np.pi * waves * np.abs(spectrum)) ** 2)) / cells**2
    heights = np.fft.ifft2(spectrum).real / slope
    return heights - heights.min()


def worst_error(heights: np.ndarray, pressure: np.ndarray, load: float) -> float:
    """The largest of: min(p/p_max, |g|/δ) and −g/δ over all cells, −p/p_max, and the error of the load."""
    wave = 2 * np.pi * np.fft.fftfreq(len(heights), 1 / len(heights))
    waves = np.hypot(wave[:, None], wave[None, :])
    waves[0, 0] = np.inf
    gap = np.fft.ifft2(2 / waves * np.fft.fft2(pressure)).real + heights
    depth = gap[pressure > 0].mean()
    gap = (gap - depth) / depth
    over_largest = pressure / pressure.max()
    complementarity = np.minimum(np.abs(over_largest), np.abs(gap)).max()
    return max(complementarity, -gap.min(), -over_largest.min(), abs(pressure.mean() / load - 1))


def build() -> str:
    """Compiles judder's side; returns the path of the program."""
    command = ["cargo", "bench", "-p", "judder-contact", "--bench", "rough", "--no-run", "--message-format=json"]
    output = subprocess.run(command, cwd=HERE.parent, check=True, stdout=subprocess.PIPE, text=True).stdout
    messages = (json.loads(line) for line in output.splitlines() if line.startswith("{"))
    return next(m["executable"] for m in messages if m.get("executable") and m["target"]["name"] == "rough")


class Case:
    """One surface under one load, and how each program solves it."""

    def __init__(self, program: str, folder: str, cells: int, load: float, tolerance: float):
        self.program, self.load, self.tolerance = program, load, tolerance
        self.heights = rough_surface(cells)
        self.file, self.output = str(Path(folder) / "heights.npy"), str(Path(folder) / "pressure.f64")
        np.save(self.file, self.heights)

    def run(self, name: str, own_tolerance: float) -> tuple[dict | None, float]:
        """What the program prints, and its error; nothing where it does not run."""
        arguments = [self.file, repr(self.load), repr(own_tolerance), self.output]
        if name == "judder":
            command = [self.program, *arguments]
        else:
            command = [sys.executable, str(HERE / "peer" / "rough_contact.py"), name, *arguments]
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        run = subprocess.run(command, env=ONE_THREAD, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        if run.returncode != 0:
            print(f"  {name} does not run: {(run.stderr.strip().splitlines() or ['no message'])[-1]}")
            return None, np.inf
        result = json.loads(run.stdout.splitlines()[-1])
        result.setdefault("cpu_seconds", after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
        pressure = np.fromfile(self.output).reshape(self.heights.shape)
        return result, worst_error(self.heights, pressure, self.load)

    def fitting_tolerance(self, name: str) -> float | None:
        """The loosest own tolerance of a peer with which its pressure passes."""
        for own in OWN_TOLERANCES:
            result, error = self.run(name, own)
            if result is None:
                return None
            if error <= self.tolerance:
                return own
        print(f"  {name} is disqualified: no tolerance of its own gives a pressure within {self.tolerance:g}")
        return None


def measure(case: Case, rounds: int) -> dict[str, tuple[float, float]]:
    """Median wall and CPU seconds of every program that passes."""
    own = {"judder": case.tolerance} | {peer: case.fitting_tolerance(peer) for peer in PEERS}
    own = {name: tolerance for name, tolerance in own.items() if tolerance is not None}
    samples: dict[str, list[tuple[float, float]]] = {name: [] for name in own}
    for _ in range(rounds):
        for name, tolerance in own.items():
            result, error = case.run(name, tolerance)
            if error > case.tolerance:
                sys.exit(f"{name} misses the tolerance that it met before: {error:.2e}")
            samples[name].append((result["seconds"], result["cpu_seconds"]))
    times = {name: tuple(median(column) for column in zip(*values)) for name, values in samples.items()}
    for name, (wall, cpu) in times.items():
        ours = times["judder"]
        ratios = f"{wall / ours[0]:7.2f}x {cpu / ours[1]:7.2f}x"
        print(f"{name:>14} {own[name]:9.0e} | {wall:9.3f} {cpu:9.3f} | {ratios}", flush=True)
    return times


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=3, help="how often each program runs (default 3)")
    parser.add_argument("--cells", type=int, nargs="+", default=[512, 1024], help="cells a side (default 512 1024)")
    parser.add_argument("--load", type=float, default=0.05, help="mean pressure over E* (default 0.05)")
    parser.add_argument("--tolerance", type=float, default=1e-6, help="largest error allowed (default 1e-6)")
    options = parser.parse_args()
    if options.rounds < 1:
        parser.error("--rounds must be at least 1")
    program, missed = build(), False
    for cells in options.cells:
        print(f"\n{cells} x {cells} cells, mean pressure {options.load:g} E*, every error below {options.tolerance:g}")
        print(f"{'':>14} {'own':>9} | {'wall s':>9} {'CPU s':>9} | {'over judder (wall, CPU)':^17}", flush=True)
        with tempfile.TemporaryDirectory() as folder:
            times = measure(Case(program, folder, cells, options.load, options.tolerance), options.rounds)
        for peer, factor, bar in (("tamaas", 1.0, "faster than Tamaas"), ("aspher", 0.5, "within 2x of ASPHER")):
            found = [times[name] for name in times if name.startswith(peer)]
            if found:
                ratio = min(cpu for _, cpu in found) / times["judder"][1]
                missed |= ratio < factor
                print(f"  {'met   ' if ratio >= factor else 'MISSED'} {bar}: {ratio:.2f}x (CPU seconds, its fastest form)")
    sys.exit(missed)


if __name__ == "__main__":
    main()
