"""What `judder check` tells of memory beside what `judder run` takes at its peak: thirteen cases, each a process of its own.

    python benches/measure_memory.py [--program judder] [--most 17] [--threads 2]

Cases for which more than `--most` GB are told are left out. What the smallest contact in time takes stands in the place of what is told of it, most
of which is the program: builds differ by some 40 MB. What is told to be near, and is not within a quarter, is exit code 1. Linux.
"""

import argparse
import json
import os
import subprocess
import tempfile
from pathlib import Path

WITHIN = 0.25
MOTION = 'model = "oscillator"\n[[analysis]]\nkind = "motion"\npoints = {}\n'
SPECTRUM = """model = "oscillator"
[operation]
normal_load = 1e-4
[[analysis]]
kind = "spectrum"
sweep = {{ key = "operation.velocity", from = 1e-6, to = 1.0, points = {}, scale = "log" }}
"""
SPHERE = """model = "contact"
[substrate]
rubbery_modulus = "1 MPa"
glassy_modulus = "10 MPa"
retardation_time = "10 ms"
poisson_ratio = 0.5
[indenter]
radius = "10 mm"
[[analysis]]
"""
CONTACT = SPHERE + 'kind = "contact"\nvelocity = 1e-1\nindentation = 1e-2\ncells = {}\n'
TRANSIENT = SPHERE + 'kind = "transient"\nmotion = "start"\nvelocity = 0.1\nindentation = 1e-2\nduration = "80 ms"\ncells = {}\n'
BODY = """model = "structure"
[structure]
block = {{ element = "{}", size = {}, cells = {} }}
material = {{ youngs_modulus = "210 GPa", poisson_ratio = 0.3, density = "7850 kg/m^3" }}
supports = [{{ set = "x-min", fixed = {} }}]
"""
PLATE = 'section = "plane-stress"\nwidth = "10 mm"\n'
MODES = '[[analysis]]\nkind = "modes"\ncount = {}\n'


DAMPED = '[damping]\nrayleigh = { alpha = "40 1/s", beta = "4e-8 s" }\n[[analysis]]\n'
COMPLEX = DAMPED + 'kind = "eigen"\nregion = { re = [-1e5, 1e3], im = [1, 3e5] }\n'
TIP = '{ set = "end-upper", direction = "y" }'
CANTILEVER = f"""model = "structure"
[structure]
beam = {{ length = "100 mm", thickness = "50 mm", elements = [200, 100], start = "clamped" }}
section = "plane-stress"
width = "20 mm"
material = {{ youngs_modulus = "2.38 GPa", poisson_ratio = 0.4, density = "1200 kg/m^3" }}
{DAMPED}kind = "receptance"
excited = {TIP}
observed = {TIP}
band = ["0 Hz", "1 kHz"]
points = 6
"""


def solid(element: str, size: str, cells: list[int], count: int) -> str:
    return BODY.format(element, size, cells, '["x", "y", "z"]') + MODES.format(count)


def plate(element: str, cells: list[int], analysis: str) -> str:
    return BODY.format(element, '["200 mm", "100 mm"]', cells, '["x", "y"]') + PLATE + analysis


BAR, CUBE = '["200 mm", "20 mm", "10 mm"]', '["100 mm", "100 mm", "100 mm"]'
CASES = {
    "transient, 128 cells": TRANSIENT.format(128),
    "spectrum, 20 000 points": SPECTRUM.format(20_000),
    "contact, 1024 cells": CONTACT.format(1024),
    "motion, 1 000 000 points": MOTION.format(1_000_000),
    "modes of a plate, 40 000 freedoms": plate("quad4", [200, 100], MODES.format(12)),
    "modes of a bar, 30 000": solid("hexahedron20", BAR, [60, 8, 4], 12),
    "modes of a cube, 23 000": solid("hexahedron20", CUBE, [12, 12, 12], 12),
    "modes of a cube, 45 000": solid("hexahedron8", CUBE, [24, 24, 24], 12),
    "modes of a plate, 271 000": plate("quad8", [300, 150], MODES.format(4)),
    "complex modes of a plate, 40 000": plate("quad4", [200, 100], COMPLEX),
    "receptances of a plate, 61 000": CANTILEVER,
    "modes of a plate, 1 082 000": plate("quad8", [600, 300], MODES.format(2)),
    "modes of a plate, 1 737 000": plate("quad8", [760, 380], MODES.format(2)),
}


def peak_of(program: str, case: Path, threads: int) -> int:
    """Bytes that a run takes at its peak."""
    with tempfile.TemporaryDirectory() as folder:
        command = [program, "-q", "run", str(case), "--fresh", "--threads", str(threads), "-o", folder + "/study"]
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL)
        _, status, used = os.wait4(process.pid, 0)
    if status:
        raise SystemExit(f"{case.name}: exit code {os.waitstatus_to_exitcode(status)}")
    return 1024 * used.ru_maxrss


def told_of(program: str, case: Path) -> tuple[int, str]:
    """Bytes that are told, and whether it is about so many, at most or at least."""
    output = subprocess.run([program, "-q", "--json", "check", str(case)], check=True, stdout=subprocess.PIPE).stdout
    own = json.loads(output)["estimate"][0]
    return own["bytes"], own["bytes_are"]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default="judder")
    parser.add_argument("--most", type=float, default=17.0, metavar="GB")
    parser.add_argument("--threads", type=int, default=2)
    given = parser.parse_args()
    fine = True
    with tempfile.TemporaryDirectory() as folder:
        case = Path(folder, "case.toml")
        case.write_text(TRANSIENT.format(16))
        program = peak_of(given.program, case, given.threads) - told_of(given.program, case)[0]
        print("| case | told (MB) | taken (MB) | told/taken |\n|---|---|---|---|")
        for name, text in CASES.items():
            case.write_text(text)
            told, bound = told_of(given.program, case)
            if told > 1e9 * given.most:
                continue
            told += program
            taken = peak_of(given.program, case, given.threads)
            fine &= bound != "about" or abs(told / taken - 1) <= WITHIN
            print(f"| {name} | {bound} {told / 1e6:.0f} | {taken / 1e6:.0f} | {told / taken:.2f} |", flush=True)
    return 0 if fine else 1


if __name__ == "__main__":
    raise SystemExit(main())
