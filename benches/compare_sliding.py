"""judder's contact of steady sliding beside a NumPy and SciPy peer, in one run, one thread each; and the time of whole laws.

    python benches/compare_sliding.py [--laws]

Needs the packages of benches/requirements.txt and cargo. A peer whose force or friction differs from judder's by more than 1e-3 is
disqualified, and every contact must be solved (exit code 1); so is the exit code where a bar is missed. Prints wall times, ratios, products with the kernel on grids of 64² to 1024² cells, the bars, and the floor:
the bare products of the finest grid. Times are the least of several runs.
"""

import argparse
import json
import os
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ONE_THREAD = os.environ | {f"{library}_NUM_THREADS": "1" for library in ("OMP", "OPENBLAS", "MKL", "RAYON")}
SPEEDS = ("0.01", "0.1", "1", "10", "100", "1000")
BARS = {256: 0.25, 512: 1.2}
COLLAPSE_BAR, SPHERE_BAR = 10.0, 60.0
# How far a peer's force and friction may be from judder's.
AGREEMENT = 1e-3


def build() -> str:
    """Compiles judder's side; returns the path of the program."""
    command = ["cargo", "bench", "-p", "judder-contact", "--bench", "sliding", "--no-run", "--message-format=json"]
    output = subprocess.run(command, cwd=HERE.parent, check=True, stdout=subprocess.PIPE, text=True).stdout
    messages = (json.loads(line) for line in output.splitlines() if line.startswith("{"))
    return next(m["executable"] for m in messages if m.get("executable") and m["target"]["name"] == "sliding")


def call(*command: str, env: dict[str, str] = ONE_THREAD) -> dict:
    """The JSON that a program prints; ends this one where it fails."""
    run = subprocess.run(command, env=env, stdout=subprocess.PIPE, text=True)
    if run.returncode != 0:
        sys.exit(run.returncode)
    return json.loads(run.stdout)


def verdict(what: str, seconds: float, bar: float) -> bool:
    """One line: whether a time is within its bar."""
    met = seconds <= bar
    print(f"  {'met   ' if met else 'MISSED'} {what}: {seconds:.3f} s (at most {bar:g})", flush=True)
    return met


def solved(program: str, cells: int, contrast: str, speed: str) -> dict:
    """judder's contact; ends this program where it has not converged."""
    ours = call(program, "contact", str(cells), contrast, speed)
    if not ours["converged"]:
        sys.exit(f"{cells} cells, E∞/E0 = {contrast}, v τ/a = {speed}: judder did not converge")
    return ours


def beside_the_peer(program: str) -> bool:
    """Each speed and grid once on either side; whether the worst time of each grid is within its bar."""
    met = True
    print("a paraboloid, E∞/E0 = 10, all grids and kernels counted, seconds; floor: the finest grid's products alone")
    print(f"{'cells':>6} {'v τ/a':>6} {'judder':>8} {'floor':>6} {'SciPy':>6} {'ratio':>6} {'products':>9} {'of SciPy':>9} {'residual':>9}")
    for cells, bar in BARS.items():
        slowest = 0.0
        for speed in SPEEDS:
            ours = solved(program, cells, "10", speed)
            peer = call(sys.executable, str(HERE / "peer" / "scipy_sliding.py"), str(cells), "10", speed, "2")
            for name in ("force", "friction"):
                if abs(ours[name] / peer[name] - 1) > AGREEMENT:
                    sys.exit(f"{cells} cells, v τ/a = {speed}: the peer's {name} is {peer[name]}, judder's {ours[name]}")
            slowest = max(slowest, ours["seconds"])
            print(
                f"{cells:6} {speed:>6} {ours['seconds']:8.3f} {ours['floor_seconds']:6.3f} {peer['seconds']:6.2f}"
                f" {peer['seconds'] / ours['seconds']:5.1f}x {ours['products']:9} {peer['products']:9} {ours['residual']:9.1e}",
                flush=True,
            )
        met &= verdict(f"{cells}² at any of these speeds", slowest, bar)
    return met


def growth(program: str) -> None:
    """Products on the finest grid, and the whole time, from 64² to 1024² cells."""
    sides = (64, 128, 256, 512, 1024)
    print("\nproducts on the finest grid (seconds in all)")
    print(f"{'E∞/E0':>6} {'v τ/a':>6}" + "".join(f"{f'{cells}²':>14}" for cells in sides))
    for contrast, speeds in (("10", SPEEDS), ("1000", ("0.1", "1", "10"))):
        for speed in speeds:
            row = [solved(program, cells, contrast, speed) for cells in sides]
            cells = "".join(f"{ours['products_finest']:6} ({ours['seconds']:.2f})".rjust(14) for ours in row)
            print(f"{contrast:>6} {speed:>6}{cells}", flush=True)


def laws(program: str) -> bool:
    """The law of Fig. 3 by the collapse and on its grid for a sphere, on all cores; whether both are within their bars."""
    print(f"\nlaws for E∞/E0 = 10, 1 %, on all cores: {os.cpu_count()} here; the bars are for 2")
    collapse = call(program, "collapse", "0.01", env=dict(os.environ))
    met = verdict(f"by the collapse, {collapse['points']} contacts", collapse["seconds"], COLLAPSE_BAR)
    sphere = call(program, "sphere", "0.01", "40", env=dict(os.environ))
    return verdict(f"of a sphere, 40 × 40, {sphere['points']} contacts", sphere["seconds"], SPHERE_BAR) and met


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--laws", action="store_true", help="only the whole laws")
    only_laws = parser.parse_args().laws
    program, met = build(), True
    if not only_laws:
        met = beside_the_peer(program)
        growth(program)
    met &= laws(program)
    sys.exit(not met)


if __name__ == "__main__":
    main()
