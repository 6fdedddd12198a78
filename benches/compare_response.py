"""judder's responses by harmonic balance beside NLvib and tmdsimpy, in one run.

    python benches/compare_response.py [--nlvib FOLDER] [--tmdsimpy FOLDER]

Needs cargo. The peers are public programs that no package index has: NLvib (github.com/maltekrack/NLvib, which runs in Octave) and tmdsimpy (github.com/tmd-lab/tmdsimpy); each runs where its folder is
named. All compute the same problem with the same harmonics, and as many instants of a period; a peer whose peak differs is disqualified. Times are those of a solution along the branch. A bar that is missed is exit code 1.
"""

import argparse
import json
import os
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
# seconds of 100 cycles with 50 contact points and nine harmonics
BRANCH = 60.0
# case: which peer, how many times as fast, how far peaks may lie apart
BARS = {"stop": ("nlvib", 50.0, 2e-3), "damper": ("nlvib", 50.0, 1e-2), "beam": ("tmdsimpy", 10.0, 2e-3)}
TWO_THREADS = {**os.environ, "OMP_NUM_THREADS": "2", "OPENBLAS_NUM_THREADS": "2", "RAYON_NUM_THREADS": "2"}


def build() -> str:
    """Compiles judder's side; returns the path of the program."""
    command = ["cargo", "bench", "-p", "judder-cycles", "--bench", "response", "--no-run", "--message-format=json"]
    output = subprocess.run(command, cwd=HERE.parent, check=True, stdout=subprocess.PIPE, text=True).stdout
    messages = (json.loads(line) for line in output.splitlines() if line.startswith("{"))
    return next(m["executable"] for m in messages if m.get("executable") and m["target"]["name"] == "response")


def run(command: list[str]) -> dict:
    """The line of JSON that a program ends with."""
    output = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True, env=TWO_THREADS).stdout
    return json.loads([line for line in output.splitlines() if line.startswith("{")][-1])


def peer(name: str, case: str, folder: str) -> dict:
    if name == "nlvib":
        return run(["octave", "--no-gui", "--quiet", str(HERE / "peer" / "nlvib_response.m"), folder, case])
    return run([sys.executable, str(HERE / "peer" / "tmdsimpy_response.py"), folder])


def told(is_met: bool, value: float, bar: str) -> bool:
    print(f"  {'met   ' if is_met else 'MISSED'} {value:.1f} ({bar})")
    return is_met


def line(name: str, found: dict) -> float:
    """Prints an answer; returns its milliseconds a solution."""
    each = 1e3 * found["seconds"] / found["points"]
    print(f"  {name:9} {each:9.2f} ms a solution, {found['points']} of them; peak {found['peak']:.6e} at {found['frequency']:.6f} rad/s")
    return each


def compare(program: str, case: str, folders: dict[str, str | None]) -> bool:
    name, bar, apart = BARS[case]
    print(case)
    ours = run([program, case])
    each = line("judder", ours)
    folder = folders[name]
    if folder is None:
        print(f"  SKIPPED {name}: its folder is not named")
        return True
    theirs = peer(name, case, folder)
    other = line(name, theirs)
    if abs(theirs["peak"] / ours["peak"] - 1.0) > apart:
        print(f"  disqualified: the peak of {name} differs")
        return False
    return told(other / each >= bar, other / each, f"times as fast a solution as {name}, at least {bar:g}")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--nlvib")
    parser.add_argument("--tmdsimpy")
    folders = vars(parser.parse_args())
    program = build()
    met = [compare(program, case, folders) for case in BARS]
    branch = run([program, "branch"])
    print(f"branch of {branch['points']} cycles, {branch['contact_points']} contact points, {branch['harmonics']} harmonics")
    met.append(told(branch["seconds"] <= BRANCH and branch["points"] == 100, branch["seconds"], f"s, at most {BRANCH:g}"))
    return 0 if all(met) else 1


if __name__ == "__main__":
    sys.exit(main())
