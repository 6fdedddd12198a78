"""The beam of judder-cycles' benchmark in tmdsimpy; prints seconds, solutions and the peak as JSON.

    python tmdsimpy_response.py FOLDER

FOLDER is that of tmdsimpy, which needs NumPy, SciPy, Numba, JAX and Matplotlib. A steel cantilever of 60 elements, the displacements of 50 nodes over stops, reduced to these and eight fixed-interface modes; nine harmonics, 512 instants.
"""

import json
import sys
import time

import numpy as np
import scipy.linalg as linalg

ELEMENTS, FIRST, MODES = 60, 11, 8
HARMONICS, INSTANTS = 9, 512
STIFFNESS, GAP, FORCE = 200.0, 1e-3, 0.1


def beam() -> tuple[np.ndarray, np.ndarray, np.ndarray, float]:
    """Mass, damping and stiffness of the reduced beam, and its first angular frequency."""
    length, bending, inertia = 0.6 / ELEMENTS, 210e9 * 0.04 * 0.005**3 / 12, 7800.0 * 0.04 * 0.005
    k = bending / length**3 * np.array([[12, 6 * length, -12, 6 * length], [6 * length, 4 * length**2, -6 * length, 2 * length**2], [-12, -6 * length, 12, -6 * length], [6 * length, 2 * length**2, -6 * length, 4 * length**2]])
    m = inertia * length / 420 * np.array([[156, 22 * length, 54, -13 * length], [22 * length, 4 * length**2, 13 * length, -3 * length**2], [54, 13 * length, 156, -22 * length], [-13 * length, -3 * length**2, -22 * length, 4 * length**2]])
    size = 2 * (ELEMENTS + 1)
    mass, stiffness = np.zeros((size, size)), np.zeros((size, size))
    for element in range(ELEMENTS):
        own = slice(2 * element, 2 * element + 4)
        mass[own, own] += m
        stiffness[own, own] += k
    mass, stiffness = mass[2:, 2:], stiffness[2:, 2:]
    omega = np.sqrt(linalg.eigh(stiffness, mass, eigvals_only=True)[:2])
    beta = 0.02 / omega.sum()
    kept = 2 * (np.arange(FIRST, ELEMENTS + 1) - 1)
    inner = np.setdiff1d(np.arange(size - 2), kept)
    shapes = linalg.eigh(stiffness[np.ix_(inner, inner)], mass[np.ix_(inner, inner)])[1][:, :MODES]
    basis = np.zeros((size - 2, len(kept) + MODES))
    basis[kept, np.arange(len(kept))] = 1.0
    basis[inner, : len(kept)] = -np.linalg.solve(stiffness[np.ix_(inner, inner)], stiffness[np.ix_(inner, kept)])
    basis[np.ix_(inner, len(kept) + np.arange(MODES))] = shapes
    mass, stiffness = basis.T @ mass @ basis, basis.T @ stiffness @ basis
    return mass, beta * omega.prod() * mass + beta * stiffness, stiffness, float(omega[0])


def main() -> None:
    sys.path.insert(0, sys.argv[1])
    from tmdsimpy.continuation import Continuation
    from tmdsimpy.nlforces.unilateral_spring import UnilateralSpring
    from tmdsimpy.solvers import NonlinearSolver
    from tmdsimpy.utils import harmonic
    from tmdsimpy.vibration_system import VibrationSystem

    mass, damping, stiffness, first = beam()
    # displacements in gaps, time in the first mode's
    mass, damping, stiffness = mass * first**2 * GAP, damping * first * GAP, stiffness * GAP
    size, points = len(mass), len(mass) - MODES
    rows = np.eye(points, size)
    system = VibrationSystem(mass, stiffness, C=damping)
    system.add_nl_force(UnilateralSpring(rows, rows.T, np.full(points, STIFFNESS * GAP), Npreload=0.0, delta=np.ones(points)))
    orders = np.arange(HARMONICS + 1)
    coefficients = harmonic.Nhc(orders)
    tip = points - 1
    load = np.zeros(coefficients * size)
    load[size + tip] = FORCE
    begin, end = 0.85, 1.3
    linear = np.linalg.solve(stiffness - begin**2 * mass + 1j * begin * damping, load[size : 2 * size])
    guess = np.zeros(coefficients * size)
    guess[size : 2 * size], guess[2 * size : 3 * size] = linear.real, -linear.imag
    solver = NonlinearSolver()

    def residual(unknown, calc_grad=True):
        return system.hbm_res(unknown, load, orders, Nt=INSTANTS, calc_grad=calc_grad)

    start = time.perf_counter()
    solution, _, slopes, _ = solver.nsolve(lambda u, calc_grad=True: residual(np.append(u, begin))[:2], guess, verbose=False, xtol=1e-7)
    unknown = np.append(solution, begin)
    config = {"DynamicCtoP": False, "TargetNfev": 8, "MaxSteps": 140, "dsmin": 1e-4, "dsmax": 0.45, "FracLam": 0.5, "verbose": -1, "xtol": 1e-6, "corrector": "Ortho", "MaxIncrease": 1.5}
    path = Continuation(solver, ds0=0.05, CtoP=np.ones_like(unknown), RPtoC=1 / np.max(np.abs(np.diag(slopes))), config=config)
    found = path.continuation(residual, unknown, begin, end)
    seconds = time.perf_counter() - start
    own = found[:, tip:-1:size]
    sizes = GAP * np.sqrt(own[:, 0] ** 2 + 0.5 * np.sum(own[:, 1:] ** 2, axis=1))
    at = int(np.argmax(sizes))
    print(json.dumps({"seconds": seconds, "points": len(found), "peak": float(sizes[at]), "frequency": float(found[at, -1] * first)}))


if __name__ == "__main__":
    main()
