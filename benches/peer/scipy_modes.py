"""The lowest modes of a solid with SciPy: shift-invert Lanczos (ARPACK) on SuperLU's factors of a symmetric matrix.

    scipy_modes.py FOLDER COUNT

The matrices lie in FOLDER as benches/modes.rs writes them; the stiffness is held, so the shift is zero. The factorisation is told that the matrix is symmetric and needs no pivots, and
takes the minimum degree of A + A'. Prints one line of JSON: seconds, frequencies in Hz, and the peak of memory in bytes. No mode is counted.
"""

import json
import resource
import sys
import time
from pathlib import Path

import numpy as np
from scipy.sparse import csc_array
from scipy.sparse.linalg import LinearOperator, eigsh, splu


def matrix(folder: Path, name: str) -> csc_array:
    starts = np.fromfile(folder / f"{name}-starts.i64", dtype="<i8").astype(np.int32)
    rows = np.fromfile(folder / f"{name}-rows.i64", dtype="<i8").astype(np.int32)
    values = np.fromfile(folder / f"{name}-values.f64", dtype="<f8")
    return csc_array((values, rows, starts), shape=(len(starts) - 1, len(starts) - 1))


def main() -> None:
    folder, count = Path(sys.argv[1]), int(sys.argv[2])
    stiffness, mass = matrix(folder, "stiffness"), matrix(folder, "mass")
    begin = time.perf_counter()
    factor = splu(
        stiffness,
        permc_spec="MMD_AT_PLUS_A",
        diag_pivot_thresh=0.0,
        options={"SymmetricMode": True},
    )
    inverse = LinearOperator(stiffness.shape, matvec=factor.solve, dtype=float)
    values, _ = eigsh(stiffness, count, M=mass, sigma=0.0, OPinv=inverse)
    seconds = time.perf_counter() - begin
    peak = 1024 * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    frequencies = (np.sqrt(np.sort(values)) / (2 * np.pi)).tolist()
    print(json.dumps({"seconds": seconds, "peak_bytes": peak, "frequencies": frequencies}))


if __name__ == "__main__":
    main()
