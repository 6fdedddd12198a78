"""judder's lowest modes of a solid beside a SciPy peer, in one run; and solids of 80 000 and 200 000 freedoms alone.

    python benches/compare_modes.py [--large]

Needs the packages of benches/requirements.txt and cargo. A box of bricks, held at one side, 20 modes. Beside the small box runs SciPy's
shift-invert Lanczos on the same matrices, with one factorisation and no count; a peer whose frequencies differ by more than 1e-8 is
disqualified. The solids of 80 000 freedoms, the cubes among them, are timed against a bar of 20 s, with `--large` one of 200 000 against 90 s
and 8 GiB; the bars are meant for two cores that do nothing else. What is above its bar is exit code 1.
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
AGREEMENT = 1e-8
SMALL = ("hex8", 18, 18, 18)
SOLIDS = [("hex8", 29, 29, 29), ("hex20", 18, 18, 18), ("hex8", 120, 20, 10), ("hex20", 70, 13, 6)]
LARGE = [("hex8", 40, 40, 39)]
BAR, LARGE_BAR, LARGE_MEMORY = 20.0, 90.0, 8 * 2**30


def build() -> str:
    """Compiles judder's side; returns the path of the program."""
    command = ["cargo", "bench", "-p", "judder-structure", "--bench", "modes", "--no-run", "--message-format=json"]
    output = subprocess.run(command, cwd=HERE.parent, check=True, stdout=subprocess.PIPE, text=True).stdout
    messages = (json.loads(line) for line in output.splitlines() if line.startswith("{"))
    return next(m["executable"] for m in messages if m.get("executable") and m["target"]["name"] == "modes")


def run(command: list[str]) -> dict:
    return json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout)


def beside_the_peer(program: str) -> bool:
    with tempfile.TemporaryDirectory() as folder:
        ours = run([program, *map(str, SMALL), "20", folder])
        peer = run([sys.executable, str(HERE / "peer" / "scipy_modes.py"), folder, "20"])
    apart = max(abs(a / b - 1) for a, b in zip(ours["frequencies"], peer["frequencies"], strict=True))
    print(f"{SMALL[0]} {SMALL[1:]}, {ours['freedoms']} freedoms, 20 modes")
    for name, side in [("judder", ours), ("SciPy", peer)]:
        print(f"  {name:7} {side['seconds']:8.2f} s   peak {side['peak_bytes'] / 2**20:8.0f} MiB")
    print(f"  ratio {peer['seconds'] / ours['seconds']:.1f}; frequencies {apart:.1e} apart")
    if apart > AGREEMENT:
        print("  disqualified: the frequencies differ")
    return apart <= AGREEMENT


def alone(program: str, solid: tuple, bar: float, memory: float) -> bool:
    ours = run([program, *map(str, solid), "20"])
    within = ours["seconds"] <= bar and ours["peak_bytes"] <= memory
    print(f"{solid[0]} {solid[1:]}, {ours['freedoms']} freedoms, 20 modes, largest residual {ours['residual']:.1e}")
    print(
        f"  {'met   ' if within else 'MISSED'} {ours['seconds']:6.1f} s ({ours['processor_seconds']:.1f} s of the processors; bar {bar:g} s)"
        f"   peak {ours['peak_bytes'] / 2**30:.2f} GiB   factors {ours['factor_entries'] / 1e6:.0f} M, {ours['operations'] / 1e9:.0f} G operations"
    )
    print(
        f"         ordering {ours['ordering_seconds']:.1f} s, factorisation {ours['factorisation_seconds']:.1f} s, solve {ours['solve_seconds']:.2f} s"
    )
    return within


def main() -> int:
    program = build()
    fine = beside_the_peer(program)
    for solid in SOLIDS:
        fine &= alone(program, solid, BAR, float("inf"))
    for solid in LARGE if "--large" in sys.argv else []:
        fine &= alone(program, solid, LARGE_BAR, LARGE_MEMORY)
    return 0 if fine else 1


if __name__ == "__main__":
    sys.exit(main())
