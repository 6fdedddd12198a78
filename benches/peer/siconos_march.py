"""The slider of judder-nonsmooth's benchmark in Siconos; prints microseconds a step and the largest difference in force as JSON.

    python siconos_march.py FOLDER FINER

FINER has the same march with the contact solved to a finer tolerance; of it `finer` is the solver alone. Needs Siconos 4.4. The same modes, rows, load, step, friction and tolerance. `kernel` is its time stepping (MoreauJeanOSI with θ = ½); the plane is a freedom of its own there, so
heavy that nothing moves it. `numerics` is its solver of the contact alone, of problems that a march in NumPy makes of the same matrices: nothing else is timed.

Siconos ends where |z - P(z - w)| / |q| is below its tolerance, with impulses z in N s beside velocities w and q in m/s, as if a kilogram were one; judder where no impulse changes by more than its tolerance, of the largest of steady
sliding, when it is projected with the point's own mass. Siconos' tolerance is set so that what it leaves is the same by judder's measure, which `residual` tells of every step of `numerics`.

Siconos' time stepping leaves a point open that touches but would have risen by the middle of the step; judder's, and the march in NumPy, let it push if it turns round within the step. From the first such step on, `compared`, both march
differently, and forces of `kernel` are no longer compared.
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
        return made

    def tolerance_of(self, compliance: np.ndarray, free: np.ndarray) -> float:
        """Siconos' tolerance that leaves as much as judder's."""
        return self.tolerance * self.step * self.scale * compliance.diagonal().min() / np.linalg.norm(free)

    def residual(self, compliance: np.ndarray, impulse: np.ndarray, velocity: np.ndarray) -> float:
        """By judder's measure: how much impulses change when they are projected."""
        each = self.dimension
        mobility = compliance.diagonal().reshape(-1, each)
        p, u = impulse.reshape(-1, each), velocity.reshape(-1, each)
        off = np.empty_like(p)
        off[:, 0] = p[:, 0] - np.maximum(0.0, p[:, 0] - u[:, 0] / mobility[:, 0])
        tried = p[:, 1:] - u[:, 1:] / mobility[:, 1:].max(axis=1, keepdims=True)
        bound, size = self.friction * np.maximum(p[:, 0], 0.0), np.linalg.norm(tried, axis=1)
        off[:, 1:] = p[:, 1:] - tried * (np.minimum(bound, size) / np.maximum(size, np.finfo(float).tiny))[:, None]
        return float(np.linalg.norm(off, axis=1).max(initial=0.0) / (self.step * self.scale))


def kernel(problem: Problem, tolerance: float, alike: int) -> dict:
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
    contact.numericsSolverOptions().dparam[sn.SICONOS_DPARAM_TOL] = tolerance
    contact.setMaxSize(dimension * problem.points)
    contact.setKeepLambdaAndYState(True)
    march = sk.TimeStepping(model, sk.TimeDiscretisation(0.0, problem.step), sk.MoreauJeanOSI(0.5), contact)
    off, seconds = 0.0, 0.0
    for step in range(len(problem.forces)):
        start = time.perf_counter()
        march.computeOneStep()
        seconds += time.perf_counter() - start
        forces = np.concatenate([own.lambda_(1) for own in interactions]) / problem.step
        if step < alike:
            off = max(off, np.abs(forces - problem.forces[step]).max() / problem.scale)
        march.nextStep()
        if seconds > MOST_SECONDS:
            break
    return {"microseconds": 1e6 * seconds / (step + 1), "off": off, "steps": step + 1, "compared": min(step + 1, alike)}


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
    off, seconds, sweeps, residual, least = 0.0, 0.0, 0, 0.0, problem.tolerance
    alike = len(problem.forces)
    for step, forces in enumerate(problem.forces):
        gap, opening = problem.gap + problem.rows[::dimension] @ z, problem.rows[::dimension] @ v
        touches = np.repeat(gap + 0.5 * h * np.minimum(opening, 0.0) <= 0.0, dimension)
        if (touches[::dimension] & (gap + 0.5 * h * opening > 0.0)).any():
            alike = min(alike, step)
        free = v - h * inverse * (problem.damping * v + problem.stiffness * (z + 0.5 * h * v) - problem.load)
        at_points = problem.rows @ free
        at_points[1::dimension] -= problem.speed
        closed = compliance[np.ix_(touches, touches)].copy()
        own = sn.FrictionContactProblem(dimension, closed, at_points[touches], friction[: touches.sum() // dimension])
        tolerance = problem.tolerance_of(closed, at_points[touches])
        least = min(least, tolerance)
        options.dparam[sn.SICONOS_DPARAM_TOL] = tolerance
        p, u = impulse[touches], velocity[touches]
        start = time.perf_counter()
        solve(own, p, u, options)
        seconds += time.perf_counter() - start
        sweeps += int(options.iparam[sn.SICONOS_IPARAM_ITER_DONE])
        residual = max(residual, problem.residual(closed, p, closed @ p + at_points[touches]))
        impulse[:], velocity[:] = 0.0, 0.0
        impulse[touches], velocity[touches] = p, u
        after = free + pushes.T @ impulse
        z, v = z + 0.5 * h * (v + after), after
        off = max(off, np.abs(impulse / h - forces).max() / problem.scale)
    return {"microseconds": 1e6 * seconds / len(problem.forces), "off": off, "sweeps": sweeps / len(problem.forces), "residual": residual, "tolerance": least, "alike": alike}


def main() -> None:
    problem = Problem(Path(sys.argv[1]))
    own = numerics(problem)
    print(json.dumps({"kernel": kernel(problem, own["tolerance"], own["alike"]), "numerics": own, "finer": numerics(Problem(Path(sys.argv[2])))}))


if __name__ == "__main__":
    main()
