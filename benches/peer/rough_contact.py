"""The elastic contact of a rough periodic surface by Tamaas or ASPHER: the peers that judder is timed against.

    rough_contact.py PEER HEIGHTS.npy MEAN_PRESSURE TOLERANCE PRESSURE.f64

PEER is `tamaas`, `aspher` or `aspher-mixed` (single precision first, then double). TOLERANCE is the peer's own. The surface is a
square of side 1, lowest where it touches; E* = 1. Writes the pressure, prints one line of JSON with wall and CPU seconds of the
solve alone: the import and the model are not timed.
"""

import json
import os
import sys
import time

for library in ("OMP", "OPENBLAS", "MKL"):
    os.environ[f"{library}_NUM_THREADS"] = "1"

import numpy as np


def tamaas(heights, mean_pressure, tolerance):
    import tamaas as tm

    tm.set_log_level(tm.LogLevel.error)
    model = tm.ModelFactory.createModel(tm.model_type.basic_2d, [1.0, 1.0], list(heights.shape))
    model.E, model.nu = 1.0, 0.0
    solver = tm.PolonskyKeerRey(model, np.ascontiguousarray(-heights), tolerance)
    solver.max_iter = 10_000

    def solve():
        solver.solve(mean_pressure)
        return np.asarray(model.traction)

    return solve


def aspher(heights, mean_pressure, tolerance, precision="double"):
    import aspher as solver

    def solve():
        result = solver.solve_nested(
            grid_size=len(heights),
            gap=heights.ravel(),
            p_nominal=mean_pressure,
            backend="periodic",
            tol=tolerance,
            precision=precision,
        )
        return np.asarray(result.pressure).reshape(heights.shape)

    return solve


def main():
    peer, heights, mean_pressure, tolerance, output = sys.argv[1:]
    heights = np.load(heights)
    arguments = heights, float(mean_pressure), float(tolerance)
    if peer == "tamaas":
        solve = tamaas(*arguments)
    else:
        solve = aspher(*arguments, precision="float_then_double" if peer == "aspher-mixed" else "double")
    wall, cpu = time.perf_counter(), time.process_time()
    pressure = solve()
    wall, cpu = time.perf_counter() - wall, time.process_time() - cpu
    np.ascontiguousarray(pressure, dtype="<f8").tofile(output)
    print(json.dumps({"seconds": wall, "cpu_seconds": cpu}))


if __name__ == "__main__":
    main()
