"""The slider of judder-nonsmooth's benchmark in Siconos; prints microseconds a step and the largest difference in force as JSON.

    python siconos_march.py FOLDER

Needs Siconos 4.4. The same modes, rows, load, step, friction and tolerance. `kernel` is its time stepping (MoreauJeanOSI with θ = ½); the plane is a freedom of its own there, so
heavy that nothing moves it. `numerics` is its solver of the contact alone, of problems that a march in NumPy makes of the same matrices: nothing else is timed.
"""

import json
import sys
import time
from pathlib import Path

import numpy as np
import siconos.kernel as sk
import siconos.numerics as sn

HEAVY = 1e12
ITERATIONS = 20000
# of the time stepping, which takes long: no more steps than fit in so many seconds
MOST_SECONDS = 20.0


class Problem:
    def __init__(self, folder: Path) -> None:
        def read(name: str) -> np.ndarray:
            return np.fromfile(folder / f"{name}.f64", dtype="<f8")

        self.damping, self.stiffness, self.load = read("damping"), read("stiffness"), read("load")
        self.step, self.friction, self.speed, self.gap, self.scale, self.tolerance, dimension = read("numbers")
        self.dimension = int(dimension)
        self.modes = len(self.load)
        self.rows = read("rows").reshape(-1, self.modes)
        self.points = len(self.rows) // self.dimension
        self.forces = read("forces").reshape(-1, len(self.rows))

    def options(self) -> sn.SolverOptions:
        made = sn.SolverOptions(sn.SICONOS_FRICTION_2D_NSGS if self.dimension == 2 else sn.SICONOS_FRICTION_3D_NSGS)
        made.iparam[sn.SICONOS_IPARAM_MAX_ITER] = ITERATIONS
        made.dparam[sn.SICONOS_DPARAM_TOL] = self.tolerance
        return made


def kernel(problem: Problem) -> dict:
    size, dimension = problem.modes + 1, problem.dimension
    body = sk.LagrangianLinearTIDS(
        np.zeros(size),
        np.append(np.zeros(problem.modes), problem.speed),
        np.diag(np.append(np.ones(problem.modes), HEAVY)),
        np.diag(np.append(problem.stiffness, 0.0)),
        np.diag(np.append(problem.damping, 0.0)),
    )
    body.setFExtPtr(np.append(problem.load, 0.0))
    model = sk.NonSmoothDynamicalSystem(0.0, 1e9)
    model.insertDynamicalSystem(body)
    law = sk.NewtonImpactFrictionNSL(0.0, 0.0, problem.friction, dimension)
    interactions = []
    for point in range(problem.points):
        rows = np.zeros((dimension, size))
        rows[:, :-1] = problem.rows[point * dimension : (point + 1) * dimension]
        rows[1, -1] = -1.0
        offset = np.zeros(dimension)
        offset[0] = problem.gap
        interaction = sk.Interaction(law, sk.LagrangianLinearTIR(rows, offset))
        model.link(interaction, body)
        interactions.append(interaction)
    contact = sk.FrictionContact(dimension, sn.SICONOS_FRICTION_2D_NSGS if dimension == 2 else sn.SICONOS_FRICTION_3D_NSGS)
    contact.numericsSolverOptions().iparam[sn.SICONOS_IPARAM_MAX_ITER] = ITERATIONS
    contact.numericsSolverOptions().dparam[sn.SICONOS_DPARAM_TOL] = problem.tolerance
    contact.setMaxSize(dimension * problem.points)
    contact.setKeepLambdaAndYState(True)
    march = sk.TimeStepping(model, sk.TimeDiscretisation(0.0, problem.step), sk.MoreauJeanOSI(0.5), contact)
    off, seconds = 0.0, 0.0
    for step in range(len(problem.forces)):
        start = time.perf_counter()
        march.computeOneStep()
        seconds += time.perf_counter() - start
        forces = np.concatenate([own.lambda_(1) for own in interactions]) / problem.step
        off = max(off, np.abs(forces - problem.forces[step]).max() / problem.scale)
        march.nextStep()
        if seconds > MOST_SECONDS:
            break
    return {"microseconds": 1e6 * seconds / (step + 1), "off": off, "steps": step + 1}


def numerics(problem: Problem) -> dict:
    """A march in NumPy whose contact Siconos solves, from the impulses of the step before."""
    h, dimension = problem.step, problem.dimension
    inverse = 1.0 / (1.0 + 0.5 * h * problem.damping + 0.25 * h * h * problem.stiffness)
    pushes = problem.rows * inverse
    compliance = np.ascontiguousarray(pushes @ problem.rows.T)
    z, v = np.zeros(problem.modes), np.zeros(problem.modes)
    impulse, velocity = np.zeros(len(problem.rows)), np.zeros(len(problem.rows))
    options, solve = problem.options(), sn.fc2d_driver if dimension == 2 else sn.fc3d_driver
    friction = np.full(problem.points, problem.friction)
    off, seconds, sweeps = 0.0, 0.0, 0
    for forces in problem.forces:
        gap, opening = problem.gap + problem.rows[::dimension] @ z, problem.rows[::dimension] @ v
        touches = np.repeat(gap + 0.5 * h * np.minimum(opening, 0.0) <= 0.0, dimension)
        free = v - h * inverse * (problem.damping * v + problem.stiffness * (z + 0.5 * h * v) - problem.load)
        at_points = problem.rows @ free
        at_points[1::dimension] -= problem.speed
        own = sn.FrictionContactProblem(dimension, compliance[np.ix_(touches, touches)].copy(), at_points[touches], friction[: touches.sum() // dimension])
        p, u = impulse[touches], velocity[touches]
        start = time.perf_counter()
        solve(own, p, u, options)
        seconds += time.perf_counter() - start
        sweeps += int(options.iparam[sn.SICONOS_IPARAM_ITER_DONE])
        impulse[:], velocity[:] = 0.0, 0.0
        impulse[touches], velocity[touches] = p, u
        after = free + pushes.T @ impulse
        z, v = z + 0.5 * h * (v + after), after
        off = max(off, np.abs(impulse / h - forces).max() / problem.scale)
    return {"microseconds": 1e6 * seconds / len(problem.forces), "off": off, "sweeps": sweeps / len(problem.forces)}


def main() -> None:
    problem = Problem(Path(sys.argv[1]))
    print(json.dumps({"kernel": kernel(problem), "numerics": numerics(problem)}))


if __name__ == "__main__":
    main()
