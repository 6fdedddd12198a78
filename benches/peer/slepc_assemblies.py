"""The eigenvalues of the pad on its strip in a region by SLEPc; prints seconds and eigenvalues as JSON.

    python slepc_assemblies.py FOLDER RE_FROM RE_TO IM_FROM IM_TO

Needs slepc4py of complex numbers. The quadratic problem itself by TOAR, shifted and inverted by MUMPS's factors, around as many shifts as judder takes, with more
and more eigenvalues until the farthest lies outside of the disc that covers a part. Right vectors alone, and no refinement: less than what the others do.
"""

import json
import sys
import time
from pathlib import Path

import numpy as np
import slepc4py

slepc4py.init(sys.argv[:1])
from petsc4py import PETSc  # noqa: E402
from slepc4py import SLEPc  # noqa: E402

PARTS = 2
TOLERANCE = 1e-10


def matrix(folder: Path, name: str) -> PETSc.Mat:
    starts, rows = (np.fromfile(folder / f"{name}-{part}.i64", dtype="<i8").astype(np.int32) for part in ("starts", "rows"))
    values = np.fromfile(folder / f"{name}-values.f64", dtype="<f8").astype(complex)
    # columns read as rows are the transpose, which has the same eigenvalues
    made = PETSc.Mat().createAIJ([len(starts) - 1] * 2, csr=(starts, rows, values))
    made.assemble()
    return made


def of_disc(matrices: list[PETSc.Mat], shift: complex, radius: float) -> list[complex]:
    mass, damping, stiffness = matrices
    problem = SLEPc.PEP().create()
    problem.setOperators([stiffness, damping, mass])
    problem.setProblemType(SLEPc.PEP.ProblemType.GENERAL)
    problem.setType(SLEPc.PEP.Type.TOAR)
    problem.setTarget(shift)
    problem.setWhichEigenpairs(SLEPc.PEP.Which.TARGET_MAGNITUDE)
    problem.setTolerances(TOLERANCE, 200)
    transform = problem.getST()
    transform.setType(SLEPc.ST.Type.SINVERT)
    solver = transform.getKSP()
    solver.setType(PETSc.KSP.Type.PREONLY)
    solver.getPC().setType(PETSc.PC.Type.LU)
    solver.getPC().setFactorSolverType("mumps")
    count = 16
    while True:
        problem.setDimensions(count, 3 * count)
        problem.solve()
        values = [problem.getEigenpair(k) for k in range(problem.getConverged())]
        if values and max(abs(value - shift) for value in values) > radius:
            return values
        count *= 2


def eigenvalues(matrices: list[PETSc.Mat], re: tuple[float, float], im: tuple[float, float]) -> list[complex]:
    found: list[complex] = []
    height = (im[1] - im[0]) / PARTS
    for part in range(PARTS):
        shift = complex(0.5 * (re[0] + re[1]), im[0] + (part + 0.5) * height)
        radius = float(np.hypot(0.5 * (re[1] - re[0]), 0.5 * height))
        low, high = im[0] + part * height, im[0] + (part + 1) * height
        found += [v for v in of_disc(matrices, shift, radius) if re[0] < v.real < re[1] and low < v.imag <= high]
    return sorted(found, key=lambda value: value.imag)


def main() -> int:
    folder, bounds = Path(sys.argv[1]), [float(argument) for argument in sys.argv[2:6]]
    matrices = [matrix(folder, name) for name in ("mass", "damping", "stiffness")]
    begin = time.perf_counter()
    found = eigenvalues(matrices, (bounds[0], bounds[1]), (bounds[2], bounds[3]))
    seconds = time.perf_counter() - begin
    print(json.dumps({"seconds": seconds, "eigenvalues": [[value.real, value.imag] for value in found]}))
    return 0


if __name__ == "__main__":
    sys.exit(main())
