"""The stability maps of Figs. 9 and 10 in batched NumPy: the peer that judder's maps are timed against.

The same work: the law (34)-(39) as printed with its derivatives, the equilibrium (15) by Newton in ln y, C and K (20), then
the decision. Three forms of it:

    eigenvalues     every batch from an estimate in closed form; eigenvalues of the 4x4 state matrices (22)
    hurwitz         the same with the Hurwitz determinants
    swept-hurwitz   starting values extrapolated from the rows before, which is judder's own trick

Rows are taken from several bands at once, so that a batch is long enough for NumPy and short enough for the cache.

    numpy_map.py FIGURE LOAD FILE

FILE holds judder's class codes, one byte a point, row by row. A map that differs from it in more than TOLERATED
points is disqualified: nothing is timed, exit code 1. Otherwise one line of JSON with the seconds of each form.
"""

import json
import math
import os
import sys
import time
from dataclasses import dataclass
from pathlib import Path

os.environ.setdefault("OMP_NUM_THREADS", "1")

import numpy as np
from numpy.typing import NDArray
from scipy.special import erf

Array = NDArray[np.float64]

POINTS = 1000
# points of 10^6 that may differ: on the boundary itself the sign of a number at rounding level decides
TOLERATED = 10
# 8000 points a batch: the fastest of 1, 2, 4, 8, 20
BANDS = 8

LOG10_E = math.log10(math.e)
STIFFNESS, RETARDATION_TIME = 0.00375, 0.4
DAMPING_X = DAMPING_Y = 0.02
K11, K12, K22 = 1.5, 0.5, 1.5
# what the structure carries of the load, per depth
SPRING = (K22 - K12 * K12 / K11) * STIFFNESS

FIGURES = {
    "fig-9a": ("normal_load", 1e-6, "shear_strength", 1e-4, 1.0),
    "fig-9b": ("normal_load", 1e-3, "shear_strength", 1e-4, 1.0),
    "fig-10a": ("shear_strength", 1e-2, "normal_load", 1e-8, 1e-1),
    "fig-10b": ("shear_strength", 1e-1, "normal_load", 1e-8, 1e-1),
}

STABLE, FLUTTER, NEGATIVE_DAMPING, BOTH, NORMAL_FORCE_COUPLING = range(5)
DESTABILISED_BY_DAMPING = 7


@dataclass
class Operation:
    """Operating points: one speed a column, load and shear strength a row (scalars or columns of a batch)."""

    velocity: Array
    log10_velocity: Array
    normal_load: Array | float
    shear_strength: Array | float
    carried_by_contact: bool


@dataclass
class Contact:
    """The contact forces over E0* R^2 with their derivatives by ln y; what the derivatives by ln v need besides."""

    force: Array
    force_by_ln_y: Array
    friction: Array
    friction_by_ln_y: Array
    force_slope: Array
    area: Array
    area_fall: Array
    coefficient: Array
    coefficient_fall: Array


def contact(at: Operation, ln_y: Array) -> Contact:
    """(34), (36), (38) and the friction force (5)."""
    y = np.exp(ln_y)
    root = np.sqrt(y)
    log10_y = LOG10_E * ln_y

    w = 0.873 * at.log10_velocity + (0.412 - 0.449 * log10_y)
    scale = (0.5 * 11.890) * y * root
    force = scale * (1.199 + erf(w))
    force_slope = scale * ((2.0 / math.sqrt(math.pi) * LOG10_E) * np.exp(-w * w))
    force_by_ln_y = 1.5 * force - 0.449 * force_slope

    distance = at.log10_velocity - (0.493 * log10_y - 1.328)
    bell = np.exp((-0.5 / 0.826**2) * (distance * distance))
    area = 1.440 * y * (2.118 - bell)
    area_fall = (1.440 * LOG10_E / 0.826**2) * y * bell * distance
    area_by_ln_y = area - 0.493 * area_fall

    distance = at.log10_velocity - (0.489 * log10_y - 1.682)
    coefficient = 0.450 * root * np.exp((-0.5 / 0.766**2) * (distance * distance))
    coefficient_fall = (LOG10_E / 0.766**2) * coefficient * distance
    coefficient_by_ln_y = 0.5 * coefficient + 0.489 * coefficient_fall

    if at.carried_by_contact:
        carried = force * coefficient
        carried_by_ln_y = force * coefficient_by_ln_y + force_by_ln_y * coefficient
    else:
        carried = at.normal_load * coefficient
        carried_by_ln_y = at.normal_load * coefficient_by_ln_y
    return Contact(
        force=force,
        force_by_ln_y=force_by_ln_y,
        friction=carried + at.shear_strength * area,
        friction_by_ln_y=carried_by_ln_y + at.shear_strength * area_by_ln_y,
        force_slope=force_slope,
        area=area,
        area_fall=area_fall,
        coefficient=coefficient,
        coefficient_fall=coefficient_fall,
    )


def solve_equilibrium(at: Operation, ln_y: Array) -> Array:
    """ln y_e: Newton on (15) with x eliminated, on the logarithm of the forces, which is almost linear in ln y."""
    for _ in range(50):
        c = contact(at, ln_y)
        elastic = SPRING * np.exp(ln_y)
        carried = elastic + (K12 / K11) * c.friction + c.force
        slope = elastic + (K12 / K11) * c.friction_by_ln_y + c.force_by_ln_y
        step = np.clip(np.log(at.normal_load / carried) * carried / slope, -1.0, 1.0)
        ln_y = ln_y + step
        if np.abs(step).max() < 3e-8:
            return ln_y
    raise ArithmeticError("the equilibrium did not settle")


def linearise(at: Operation, ln_y: Array) -> tuple[Array, Array, Array, Array]:
    """c11, c21, k12 + k12c and k22 of (20)."""
    c = contact(at, ln_y)
    if at.carried_by_contact:
        carried_by_ln_v = c.force_slope * 0.873 * c.coefficient - c.force * c.coefficient_fall
    else:
        carried_by_ln_v = -at.normal_load * c.coefficient_fall
    per_velocity = (RETARDATION_TIME / STIFFNESS) / at.velocity
    per_depth = (1.0 / STIFFNESS) * np.exp(-ln_y)
    c11 = DAMPING_X + per_velocity * (carried_by_ln_v + at.shear_strength * c.area_fall)
    c21 = -per_velocity * (0.873 * c.force_slope)
    k12 = K12 - per_depth * c.friction_by_ln_y
    k22 = K22 + per_depth * c.force_by_ln_y
    return c11, c21, k12, k22


def unstable_by_hurwitz(c11: Array, c21: Array, k12: Array, k22: Array) -> NDArray[np.bool_]:
    """Routh and Hurwitz on the coefficients of (21)."""
    p0 = K11 * k22 - K12 * k12
    p1 = c11 * k22 + DAMPING_Y * K11 - c21 * k12
    p2 = K11 + k22 + c11 * DAMPING_Y
    p3 = c11 + DAMPING_Y
    stable = (p0 > 0) & (p1 > 0) & (p3 > 0) & (p1 * p2 * p3 > p1 * p1 + p3 * p3 * p0)
    return ~stable


def unstable_by_eigenvalues(c11: Array, c21: Array, k12: Array, k22: Array) -> NDArray[np.bool_]:
    """The largest real part of the eigenvalues of the state matrices (22)."""
    a = np.zeros((*c11.shape, 4, 4))
    a[..., 0, 2] = a[..., 1, 3] = 1.0
    a[..., 2, 0] = -K11
    a[..., 2, 1] = -k12
    a[..., 2, 2] = -c11
    a[..., 3, 0] = -K12
    a[..., 3, 1] = -k22
    a[..., 3, 2] = -c21
    a[..., 3, 3] = -DAMPING_Y
    return np.linalg.eigvals(a).real.max(axis=-1) > 0


def classify(at: Operation, ln_y: Array, unstable_by) -> NDArray[np.uint8]:
    """Class codes: stable, or unstable by which mechanism."""
    c11, c21, k12, k22 = linearise(at, ln_y)
    flutter = 4.0 * K12 * k12 + (K11 - k22) ** 2 < 0
    mechanism = flutter * FLUTTER + (c11 < 0) * NEGATIVE_DAMPING
    without = unstable_by(c11, np.zeros_like(c21), k12, k22)
    mechanism[(mechanism == 0) & without] = DESTABILISED_BY_DAMPING
    mechanism[mechanism == 0] = NORMAL_FORCE_COUPLING
    return np.where(unstable_by(c11, c21, k12, k22), mechanism, STABLE).astype(np.uint8)


def estimate(at: Operation) -> Array:
    """ln y: the lower of what contact forces linear in y (springs, adhesive friction) and what (34) alone would carry."""
    linear = np.log(at.normal_load / (SPRING + (K12 / K11) * 3.05 * at.shear_strength))
    per_power = 0.5 * 11.890 * (1.199 + erf(0.873 * at.log10_velocity + 0.412 - 0.449 * LOG10_E * linear))
    return np.minimum(linear, np.log(at.normal_load / per_power) / 1.5)


def stability_map(figure: str, load: str, form: str) -> NDArray[np.uint8]:
    """The class codes of a panel, row by row."""
    unstable_by = unstable_by_eigenvalues if form == "eigenvalues" else unstable_by_hurwitz
    fixed, value, swept, lower, upper = FIGURES[figure]
    velocity = np.exp(np.linspace(math.log(1e-8), math.log(1e2), POINTS))
    log10_velocity = np.log10(velocity)
    rows = np.exp(np.linspace(math.log(lower), math.log(upper), POINTS)).reshape(BANDS, -1, 1)
    classes = np.empty((BANDS, rows.shape[1], POINTS), np.uint8)
    history: list[Array] = []
    for row in range(rows.shape[1]):
        at = Operation(
            velocity=velocity,
            log10_velocity=log10_velocity,
            carried_by_contact=load == "contact-force",
            **{fixed: value, swept: rows[:, row]},
        )
        if form == "swept-hurwitz" and len(history) == 4:
            a, b, c, d = history
            start = 4.0 * (a + c) - 6.0 * b - d
        else:
            start = np.broadcast_to(estimate(at), (BANDS, POINTS))
        ln_y = solve_equilibrium(at, start)
        history = [ln_y, *history[:3]]
        classes[:, row] = classify(at, ln_y, unstable_by)
    return classes.reshape(-1)


def median_seconds(work, repeats: int) -> float:
    """The median wall time of a call."""
    seconds = []
    for _ in range(repeats):
        start = time.perf_counter()
        work()
        seconds.append(time.perf_counter() - start)
    return sorted(seconds)[repeats // 2]


def main() -> int:
    figure, load, file = sys.argv[1:]
    reference = np.frombuffer(Path(file).read_bytes(), np.uint8)
    result: dict[str, object] = {"figure": figure, "friction_load": load}
    repeats = {"hurwitz": 3, "swept-hurwitz": 3, "eigenvalues": 1}
    for form in repeats:
        classes = stability_map(figure, load, form)
        differing = int(np.count_nonzero(classes != reference))
        if differing > TOLERATED:
            print(f"{figure}, {load}: {form} disqualified, {differing} points differ", file=sys.stderr)
            return 1
        result[form] = {
            "differing": differing,
            "class_counts": np.bincount(classes, minlength=8).tolist(),
            "seconds": median_seconds(lambda: stability_map(figure, load, form), repeats[form]),
        }
    print(json.dumps(result))
    return 0


if __name__ == "__main__":
    sys.exit(main())
