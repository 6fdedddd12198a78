"""judder's complex modes of the disc brake beside a SciPy peer, in one run; and a hundred speeds.

    python benches/compare_eigen.py FOLDER

Needs the packages of benches/requirements.txt, cargo, and a folder with the matrices of the disc brake (cases/benchmarks/disc-brake.toml tells
where they come from). Both find all eigenvalues of a region with right and left vectors and refine them. A peer whose eigenvalues differ by more than
1e-6 of their size is disqualified, a ratio below the bar is missed, an eigenvalue of the sweep outside of its shown error is wrong: all exit with 1.
"""

import json
import math
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
BAR, SECONDS, SWEEP_SECONDS, AGREEMENT = 10.0, 3.0, 10.0, 1e-6


def build() -> str:
    """Compiles judder's side; returns the path of the program."""
    command = ["cargo", "bench", "-p", "judder-exchange", "--bench", "eigen", "--no-run", "--message-format=json"]
    output = subprocess.run(command, cwd=HERE.parent, check=True, stdout=subprocess.PIPE, text=True).stdout
    messages = (json.loads(line) for line in output.splitlines() if line.startswith("{"))
    return next(m["executable"] for m in messages if m.get("executable") and m["target"]["name"] == "eigen")


def within(seconds: float, bar: float) -> str:
    return f"{'within' if seconds <= bar else 'above'} {bar:g} s, the bar for two cores that do nothing else"


def main() -> int:
    if len(sys.argv) != 2:
        print("SKIPPED: name the folder with the matrices of the disc brake")
        return 0
    folder = sys.argv[1]
    ours = json.loads(subprocess.run([build(), folder], check=True, stdout=subprocess.PIPE, text=True).stdout)
    command = [sys.executable, str(HERE / "peer" / "scipy_eigen.py"), folder, repr(math.tau)]
    peer = json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout)
    ratio = peer["seconds"] / ours["seconds"]
    print(f"the disc brake at one speed: {len(ours['eigenvalues'])} eigenvalues, complete: {ours['complete']}")
    print(f"  judder  {ours['seconds']:7.2f} s   {within(ours['seconds'], SECONDS)}")
    print(f"  SciPy   {peer['seconds']:7.2f} s   {len(peer['eigenvalues'])} eigenvalues")
    print(f"  floor   {ours['floor_seconds']:7.2f} s   the factorisations at judder's shifts, nothing else")
    print(f"  {'met   ' if ratio >= BAR else 'MISSED'} ratio {ratio:.1f} (at least {BAR:g})")
    print(f"{ours['points']} speeds in a basis of {ours['basis']} vectors from {ours['samples']} samples, {ours['on_their_own']} points on their own")
    print(f"  judder  {ours['sweep_seconds']:7.2f} s   {within(ours['sweep_seconds'], SWEEP_SECONDS)}")
    share = ours["largest_share_of_shown_error"]
    print(f"  {ours['compared']} eigenvalues beside the full answer: at most {share:.2g} of the shown error away")
    pairs = list(zip(ours["eigenvalues"], peer["eigenvalues"]))
    apart = [abs(complex(*a) - complex(*b)) / abs(complex(*b)) for a, b in pairs]
    if len(ours["eigenvalues"]) != len(peer["eigenvalues"]) or max(apart) > AGREEMENT:
        print("  disqualified: the eigenvalues differ")
        return 1
    return 0 if ratio >= BAR and share <= 1.0 and ours["complete"] else 1


if __name__ == "__main__":
    sys.exit(main())
