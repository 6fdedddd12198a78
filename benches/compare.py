"""judder's stability maps against a NumPy peer, in one run: A B A B, one core each, panel by panel.

    python benches/compare.py [--rounds N]

Needs the packages of benches/requirements.txt and cargo. The peer first makes each map and is disqualified (exit code 1) where it
differs from judder's. Prints the wall times, their ratios, the bars, and the physical floor.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile
from collections import defaultdict
from pathlib import Path
from statistics import median

HERE = Path(__file__).resolve().parent
PANELS = [(f, load) for load in ("normal-load", "contact-force") for f in ("fig-9a", "fig-9b", "fig-10a", "fig-10b")]
FORMS = ("eigenvalues", "hurwitz", "swept-hurwitz")
ONE_THREAD = os.environ | {f"{library}_NUM_THREADS": "1" for library in ("OMP", "OPENBLAS", "MKL")}

# Vector additions, multiplications, divisions, roots and selections in the compiled loops of src/block.rs, so operations a
# point: the logarithm of the speed, one Newton step, the classification. A division counts as one, so the floor is a
# true lower bound: a decision cannot be faster on a core that starts this many unfused operations a second.
OPERATIONS = 28 + 249 + 307


def build_clock() -> str:
    """Compiles judder's side; returns the path of the program."""
    command = ["cargo", "bench", "-p", "judder-oscillator", "--bench", "clock", "--no-run", "--message-format=json"]
    output = subprocess.run(command, cwd=HERE.parent, check=True, stdout=subprocess.PIPE, text=True).stdout
    messages = (json.loads(line) for line in output.splitlines() if line.startswith("{"))
    return next(m["executable"] for m in messages if m.get("executable") and m["target"]["name"] == "clock")


def call(*command: str) -> dict:
    """The JSON that a program prints; ends this one where it fails."""
    run = subprocess.run(command, env=ONE_THREAD, stdout=subprocess.PIPE, text=True)
    if run.returncode != 0:
        sys.exit(run.returncode)
    return json.loads(run.stdout)


def measure(clock: str, rounds: int) -> tuple[dict[tuple[str, str], dict[str, float]], float]:
    """Median nanoseconds a point of every panel and form, and the peak rate of the core in operations a second."""
    table, peak = {}, []
    with tempfile.TemporaryDirectory() as folder:
        for figure, load in PANELS:
            file = str(Path(folder) / f"{figure}-{load}")
            samples = defaultdict(list)
            for _ in range(rounds):
                ours = call(clock, figure, load, file)
                peer = call(sys.executable, str(HERE / "peer" / "numpy_map.py"), figure, load, file)
                if not ours["maps_agree"]:
                    sys.exit(f"{figure}, {load}: the adaptive map is not the brute-force map")
                per_point = 1e9 / ours["points"]
                samples["every-point"].append(ours["every_point_seconds"] * per_point)
                samples["adaptive"].append(ours["adaptive_seconds"] * per_point)
                for form in FORMS:
                    samples[form].append(peer[form]["seconds"] * per_point)
                    samples["differing"].append(peer[form]["differing"])
                peak.append(ours["peak_operations_per_second"])
            row = {name: median(values) for name, values in samples.items()}
            row["differing"] = max(samples["differing"])
            row["unstable"] = ours["unstable_fraction"]
            table[figure, load] = row
            print_row(figure, load, row)
    return table, max(peak)


HEADER = (
    f"{'panel':>8} {'friction load':>14} {'unstable':>9} {'differ':>7} | {'judder':>8} {'eigen':>8} {'hurwitz':>8} {'swept':>8} |"
    f" {'eigen':>7} {'hurwitz':>8} {'swept':>7} | {'adaptive':>9} {'':>7}\n"
    f"{'':>41} | {'ns a point, every point decided':^35} | {'times slower':^24} | {'ms a map':>9} {'faster':>7}"
)


def print_row(figure: str, load: str, row: dict[str, float]) -> None:
    ours = row["every-point"]
    times = " ".join(f"{row[form]:8.1f}" for form in FORMS)
    slower = f"{row['eigenvalues'] / ours:6.1f}x {row['hurwitz'] / ours:7.1f}x {row['swept-hurwitz'] / ours:6.1f}x"
    adaptive = f"{row['adaptive']:9.3f} {ours / row['adaptive']:6.1f}x"
    left = f"{figure:>8} {load:>14} {row['unstable']:9.6f} {row['differing']:7d}"
    print(f"{left} | {ours:8.1f} {times} | {slower} | {adaptive}", flush=True)


def print_bars(table: dict[tuple[str, str], dict[str, float]], peak: float) -> None:
    """The worst panel of each bar, and the floor."""

    def worst(over: str, under: str) -> float:
        return min(row[over] / row[under] for row in table.values())

    slowest = max(row["every-point"] for row in table.values())
    bars = [
        ("a decision, every point, one core", slowest <= 100.0, f"{slowest:.1f} ns (at most 100)"),
    ]
    for name, over, under, bar in [
        ("over the peer's eigenvalue form", "eigenvalues", "every-point", 30.0),
        ("over the peer's Hurwitz form", "hurwitz", "every-point", 6.0),
        ("adaptive over every point", "every-point", "adaptive", 20.0),
    ]:
        ratio = worst(over, under)
        bars.append((name, ratio >= bar, f"{ratio:.1f}x (at least {bar:g}x)"))
    print("\nworst panel of each bar:")
    for name, met, text in bars:
        print(f"  {'met   ' if met else 'MISSED'} {name}: {text}")
    print(f"  no bar  over the peer with judder's own starting values: {worst('swept-hurwitz', 'every-point'):.1f}x")
    floor = 1e9 * OPERATIONS / peak
    print(
        f"floor: {OPERATIONS} operations a decision, {peak / 1e9:.1f}e9 unfused multiplications and additions a second "
        f"measured on this core: {floor:.1f} ns; the slowest panel is {slowest / floor:.1f} times that"
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=2, help="how often each side runs (A B A B … ; default 2)")
    rounds = parser.parse_args().rounds
    if rounds < 1:
        parser.error("--rounds must be at least 1")
    clock = build_clock()
    print(HEADER, flush=True)
    print_bars(*measure(clock, rounds))


if __name__ == "__main__":
    main()
