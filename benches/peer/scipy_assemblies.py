"""The eigenvalues of the pad on its strip in a region by SciPy's sparse shift-invert; prints seconds and eigenvalues as JSON.

    python scipy_assemblies.py FOLDER RE_FROM RE_TO IM_FROM IM_TO

The matrices lie in FOLDER as crates/judder-models/benches/assemblies.rs writes them. As of the disc brake (scipy_eigen.py), with as many discs as judder takes;
SuperLU is told to order by the minimum degree of A + A', which of finite elements takes less than its default.
"""

import json
import sys
import time
from pathlib import Path

from scipy_eigen import eigenvalues
from scipy_modes import matrix


def main() -> int:
    folder, bounds = Path(sys.argv[1]), [float(argument) for argument in sys.argv[2:6]]
    matrices = [matrix(folder, name) for name in ("mass", "damping", "stiffness")]
    re, im = (bounds[0], bounds[1]), (bounds[2], bounds[3])
    begin = time.perf_counter()
    found = eigenvalues(*matrices, re, im, "MMD_AT_PLUS_A")
    seconds = time.perf_counter() - begin
    print(json.dumps({"seconds": seconds, "eigenvalues": [[value.real, value.imag] for value in found]}))
    return 0


if __name__ == "__main__":
    sys.exit(main())
