"""judder's march of an assembly beside Siconos, in one run.

    python benches/compare_march.py

Needs cargo; Siconos runs where Debian's python3-siconos is installed. Both march the same modes with the same scheme, step, friction and tolerance, on one thread. A peer whose forces
differ in the first steps is disqualified. Both solve the contact until what is left of it by judder's measure is below the same tolerance; that forces differ by more than that is what the contact makes of it, and the flutter, so a
hundredth of the tolerance makes it a hundredth. A bar that is missed is exit code 1.
"""

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
# of the mean force of a point, with the tolerance of judder's marches, 1e-11, and with a finer one
AGREEMENT, FINER, FINER_AGREEMENT = 1e-6, 1e-13, 1e-9
# microseconds a step of 200 modes with 50 points; times as fast as time stepping in the plane and in space
STEP, RATIOS = 60.0, {2: 10.0, 3: 5.0}
SIZES = [(9, 2), (50, 2), (100, 2), (100, 3)]
ONE_THREAD = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "RAYON_NUM_THREADS": "1"}


def build() -> str:
    """Compiles judder's side; returns the path of the program."""
    command = ["cargo", "bench", "-p", "judder-nonsmooth", "--bench", "march", "--no-run", "--message-format=json"]
    output = subprocess.run(command, cwd=HERE.parent, check=True, stdout=subprocess.PIPE, text=True).stdout
    messages = (json.loads(line) for line in output.splitlines() if line.startswith("{"))
    return next(m["executable"] for m in messages if m.get("executable") and m["target"]["name"] == "march")


def run(command: list[str]) -> dict:
    return json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True, env=ONE_THREAD).stdout.splitlines()[-1])


def siconos(folder: str, finer: str) -> dict | None:
    """Siconos' answer; none where it is not installed."""
    if subprocess.run(["/usr/bin/python3", "-c", "import siconos.kernel"], stderr=subprocess.DEVNULL).returncode != 0:
        return None
    return run(["/usr/bin/python3", str(HERE / "peer" / "siconos_march.py"), folder, finer])


def told(is_met: bool, value: float, bar: str) -> bool:
    print(f"  {'met   ' if is_met else 'MISSED'} {value:.1f} ({bar})")
    return is_met


def compare(program: str, points: int, dimension: int) -> bool:
    size = [str(points), str(dimension)]
    with tempfile.TemporaryDirectory() as folder, tempfile.TemporaryDirectory() as finer:
        ours = run([program, "problem", *size, folder])
        subprocess.run([program, "forces", *size, finer, str(FINER)], check=True, env=ONE_THREAD)
        peer = siconos(folder, finer)
    shares = ", ".join(f"{name} {100.0 * ours[f'{name}_share']:.0f} %" for name in ("stick", "slip", "open"))
    print(f"{ours['modes']} modes, {points} points in {'the plane' if dimension == 2 else 'space'}: {shares}")
    print(f"  judder    {ours['microseconds']:9.1f} us a step   {ours['sweeps']:.1f} sweeps, residual at most {ours['residual']:.1e}, {ours['unsolved']} steps unsolved")
    print(f"  judder    {ours['first_microseconds']:9.1f} us a step   of the first 1000, which Siconos takes too")
    print(f"  floor     {ours['floor_microseconds']:9.1f} us a step")
    fine = ours["unsolved"] == 0
    if (points, dimension) == (50, 2):
        fine &= told(ours["microseconds"] <= STEP, ours["microseconds"], f"us a step, at most {STEP:g}")
    if peer is None:
        print("  SKIPPED Siconos: python3-siconos is not installed")
        return fine
    kernel, numerics, finer = peer["kernel"], peer["numerics"], peer["finer"]
    print(f"  Siconos   {kernel['microseconds']:9.1f} us a step   its time stepping, {kernel['steps']} steps; forces of {kernel['compared']} of them differ by {kernel['off']:.1e}")
    print(f"  its solver{numerics['microseconds']:9.1f} us a step   of the contact alone, {numerics['sweeps']:.1f} sweeps, residual at most {numerics['residual']:.1e}; forces differ by {numerics['off']:.1e}")
    print(f"  both with a tolerance of {FINER:g}: its residual at most {finer['residual']:.1e}; forces differ by {finer['off']:.1e}")
    if max(kernel["off"], numerics["off"]) > AGREEMENT or finer["off"] > FINER_AGREEMENT:
        print("  disqualified: the forces of Siconos differ")
        return False
    ratio = kernel["microseconds"] / ours["first_microseconds"]
    return fine & told(ratio >= RATIOS[dimension], ratio, f"times as fast a step as its time stepping, at least {RATIOS[dimension]:g}")


def main() -> int:
    program = build()
    met = [compare(program, points, dimension) for points, dimension in SIZES]
    return 0 if all(met) else 1


if __name__ == "__main__":
    sys.exit(main())
