"""judder's modes of a pad that slides on a strip beside SciPy and SLEPc, in one run; steady sliding of 2000 points; a hundred friction coefficients.

    python benches/compare_assemblies.py

Needs the packages of benches/requirements.txt and cargo; SLEPc runs where Debian's python3-slepc4py-complex is installed. All find the eigenvalues of a band of the
same matrices. A peer whose eigenvalues differ by more than 1e-6 of their size is disqualified. A bar that is missed is exit code 1.
"""

import glob
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
AGREEMENT = 1e-6
# over SciPy; seconds beyond the factorisation; one analysis of modes
RATIO, BEYOND, SWEEP = 5.0, 1.0, 12.0
# where Debian puts it: the alternatives of complex numbers have folders of their own
SLEPC = ["/usr/lib/slepcdir/slepc*/*-complex/lib/python3/dist-packages", "/usr/lib/petscdir/petsc*/*-complex/lib/python3/dist-packages"]


def build(name: str) -> str:
    """Compiles one of judder's sides; returns the path of the program."""
    command = ["cargo", "bench", "-p", "judder-assembly", "-p", "judder-models", "--bench", name, "--no-run", "--message-format=json"]
    output = subprocess.run(command, cwd=HERE.parent, check=True, stdout=subprocess.PIPE, text=True).stdout
    messages = (json.loads(line) for line in output.splitlines() if line.startswith("{"))
    return next(m["executable"] for m in messages if m.get("executable") and m["target"]["name"] == name)


def run(command: list[str], environment: dict[str, str] | None = None) -> dict:
    return json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True, env=environment).stdout)


def slepc(arguments: list[str]) -> dict | None:
    """SLEPc's answer; none where it is not installed."""
    folders = [folder for pattern in SLEPC for folder in glob.glob(pattern)]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(folders)}
    if subprocess.run(["/usr/bin/python3", "-c", "import slepc4py"], env=environment, stderr=subprocess.DEVNULL).returncode != 0:
        return None
    return run(["/usr/bin/python3", str(HERE / "peer" / "slepc_assemblies.py"), *arguments], environment)


def agrees(ours: dict, peer: dict) -> bool:
    if len(ours["eigenvalues"]) != len(peer["eigenvalues"]):
        return False
    rest = [complex(*value) for value in peer["eigenvalues"]]
    for value in (complex(*value) for value in ours["eigenvalues"]):
        nearest = min(rest, key=lambda other: abs(other - value))
        if abs(nearest - value) > AGREEMENT * abs(value):
            return False
        rest.remove(nearest)
    return True


def told(is_met: bool, ratio: float, bar: str) -> str:
    return f"  {'met   ' if is_met else 'MISSED'} {ratio:.2f} ({bar})"


def modes(program: str) -> bool:
    with tempfile.TemporaryDirectory() as folder:
        ours = run([program, "modes", folder])
        arguments = [folder, *(repr(bound) for bound in ours["re"] + ours["im"])]
        peers = {"SciPy": run([sys.executable, str(HERE / "peer" / "scipy_assemblies.py"), *arguments]), "SLEPc": slepc(arguments)}
    print(f"{ours['freedoms']} freedoms, {ours['closed']} of {ours['points']} contact points closed: {len(ours['eigenvalues'])} eigenvalues, complete: {ours['complete']}")
    print(f"  judder  {ours['seconds']:7.2f} s   {len(ours['shifts'])} shifts")
    print(f"  floor   {ours['floor_seconds']:7.2f} s   as many factorisations as judder has shifts, nothing else but the order of elimination")
    fine = ours["complete"]
    for name, peer in peers.items():
        if peer is None:
            print(f"  SKIPPED {name}: python3-slepc4py-complex is not installed")
            continue
        print(f"  {name:7} {peer['seconds']:7.2f} s   {len(peer['eigenvalues'])} eigenvalues")
        ratio = peer["seconds"] / ours["seconds"]
        if not agrees(ours, peer):
            print(f"  disqualified: the eigenvalues of {name} differ")
            fine = False
        elif name == "SciPy":
            print(told(ratio >= RATIO, ratio, f"times as fast, at least {RATIO:g}"))
            fine &= ratio >= RATIO
        else:
            print(f"         {ratio:.2f} times as fast")
    return fine


def steady(program: str) -> bool:
    ours = run([program, "steady"])
    beyond = ours["seconds"] - ours["floor_seconds"]
    print(f"steady sliding of {ours['points']} contact points, {ours['closed']} closed, {ours['freedoms']} freedoms, {ours['iterations']} systems, out of balance by {ours['residual']:.1e}")
    print(f"  judder  {ours['seconds']:7.2f} s")
    print(f"  floor   {ours['floor_seconds']:7.2f} s   one factorisation, its order of elimination among it")
    print(told(beyond <= BEYOND, beyond, f"s beyond it, at most {BEYOND:g}, for two cores that do nothing else"))
    return beyond <= BEYOND


def sweep(program: str) -> bool:
    ours = run([program, "sweep"])
    ratio = ours["sweep_seconds"] / ours["one_seconds"]
    print(f"a hundred friction coefficients beside one analysis of modes, both from the case on; {ours['sweep_missing']} missing")
    print(f"  one     {ours['one_seconds']:7.2f} s")
    print(f"  hundred {ours['sweep_seconds']:7.2f} s")
    print(told(ratio <= SWEEP, ratio, f"times one, at most {SWEEP:g}"))
    return ratio <= SWEEP


def main() -> int:
    sliding_pad = build("sliding_pad")
    fine = modes(sliding_pad)
    fine &= steady(sliding_pad)
    fine &= sweep(build("assemblies"))
    return 0 if fine else 1


if __name__ == "__main__":
    sys.exit(main())
