"""judder's limit cycle beside a SciPy peer, in one run, one thread each; and the diagram of Fig. 11.

    python benches/compare_motion.py

Needs the packages of benches/requirements.txt and cargo. Both follow one period of the cycle of the oscillator paper's section 5 (shear
strength 0.03, friction by the normal load) from the same state, to the same local tolerance of 1e-8. A peer whose period differs by more
than 1e-4 is disqualified, a ratio below the bar is missed; both exit with 1. The diagram, 60 points up and down, is timed as a whole
process on all cores; it has no peer, and its bar of 5 s is meant for two cores that do nothing else.
"""

import json
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
BAR = 30.0
DIAGRAM_BAR = 5.0
AGREEMENT = 1e-4


def build() -> str:
    """Compiles judder's side; returns the path of the program."""
    command = ["cargo", "bench", "-p", "judder-oscillator", "--bench", "cycle", "--no-run", "--message-format=json"]
    output = subprocess.run(command, cwd=HERE.parent, check=True, stdout=subprocess.PIPE, text=True).stdout
    messages = (json.loads(line) for line in output.splitlines() if line.startswith("{"))
    return next(m["executable"] for m in messages if m.get("executable") and m["target"]["name"] == "cycle")


def diagram() -> float:
    """Seconds that `judder run` takes for the diagram of Fig. 11."""
    subprocess.run(["cargo", "build", "--profile", "dist", "-p", "judder-cli"], cwd=HERE.parent, check=True)
    target = os.environ.get("CARGO_TARGET_DIR", str(HERE.parent / "target"))
    case = HERE.parent / "cases" / "oscillator-paper" / "fig-11.toml"
    with tempfile.TemporaryDirectory() as folder:
        begin = time.perf_counter()
        subprocess.run([f"{target}/dist/judder", "-q", "run", str(case), "-o", folder], check=True)
        return time.perf_counter() - begin


def main() -> int:
    ours = json.loads(subprocess.run([build()], check=True, stdout=subprocess.PIPE, text=True).stdout)
    start = [repr(number) for number in ours["start"]]
    command = [sys.executable, str(HERE / "peer" / "scipy_cycle.py"), repr(ours["shear_strength"]), *start]
    peer = json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout)
    ratio = peer["seconds"] / ours["seconds"]
    print("one period of the cycle, local tolerance 1e-8")
    print(f"  judder  {1e3 * ours['seconds']:9.3f} ms   period {ours['period']:.6f}   {ours['steps']} steps, {ours['changes']} changes of contact")
    print(f"  SciPy   {1e3 * peer['seconds']:9.3f} ms   period {peer['period']:.6f}   {peer['changes']} changes of contact")
    print(f"  floor   {1e3 * ours['floor_seconds']:9.3f} ms   the same number of evaluations of the field, nothing else")
    print(f"  {'met   ' if ratio >= BAR else 'MISSED'} ratio {ratio:.0f} (at least {BAR:g})")
    seconds = diagram()
    print(f"60 points up and down: {seconds:.1f} s as a whole process ({'within' if seconds < DIAGRAM_BAR else 'above'} {DIAGRAM_BAR:g} s)")
    if abs(peer["period"] - ours["period"]) > AGREEMENT:
        print("  disqualified: the periods differ")
        return 1
    return 0 if ratio >= BAR else 1


if __name__ == "__main__":
    sys.exit(main())
