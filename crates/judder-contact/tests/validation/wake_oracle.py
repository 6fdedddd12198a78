"""Displacements in the wakes of a loaded square cell and of a loaded strip, from their definition in 40 digits.

Writes wake_oracle.csv and line_oracle.csv beside itself: x, y (in cells), wake length (in cells), displacement
g(x, y) = (1/l) int_x^inf exp(-(s - x)/l) L(s, y) ds, with Love's closed form L for the cell and, for the strip,
L = -(2/pi) int ln(|x - s|/1000) ds. Needs mpmath.
"""

from pathlib import Path

from mpmath import asinh, exp, log, mp, mpf, pi, quad

mp.dps = 40

PLACES = [
    (0, 0), (-0.25, 0), (-0.5, 0), (0.5, 0), (1, 0), (-1, 0), (-1.4375, 0), (0, 1), (-0.375, 1), (3, 2), (-3, 2),
    (7, 0), (-7.25, 0), (23, 0), (-24, 1), (-29.5, 0), (31, 0), (25, 25), (-26, 24), (-20, 28), (-60, 0), (-100.25, 3),
    (120, 0), (0, 127), (-127, 127), (127, 64), (-127.5, 0), (127, 0),
]
LENGTHS = ["1e-8", "1e-4", "1e-2", "0.1", "0.3", "1", "3", "10", "1e2", "1e4", "1e8"]


def along(x, y):
    return x * asinh(y / abs(x)) if x != 0 else mpf(0)


def love(x, y):
    half = mpf(1) / 2
    total = mpf(0)
    for a, sign_a in ((x + half, 1), (x - half, -1)):
        for b, sign_b in ((y + half, 1), (y - half, -1)):
            total += sign_a * sign_b * (along(a, b) + along(b, a))
    return total / pi


def strip(x, _y):
    half = mpf(1) / 2
    side = lambda distance: distance * log(abs(distance)) if distance != 0 else mpf(0)
    return -2 / pi * (side(x + half) - side(x - half) - 1 - log(1000))


def wake(displacement, x, y, length):
    x, y = mpf(x), mpf(y)
    edges = {mpf(0)}
    edges |= {edge - x for edge in (mpf(-1) / 2, mpf(1) / 2) if edge > x}
    edges |= {z * length for z in (0.5, 2, 5, 12, 25, 50, 95)}
    reach = mpf(1) / 4
    while reach < 95 * length + 1000:
        edges |= {reach - x, -reach - x}
        reach *= 2
    panels = sorted(edge for edge in edges if 0 <= edge <= 95 * length)
    smooth = abs(y) >= 1 or x > 1
    total = mpf(0)
    for a, b in zip(panels, panels[1:]):
        total += quad(lambda t: exp(-t / length) * displacement(x + t, y), [a, b],
                      method="gauss-legendre" if smooth else "tanh-sinh")
    return total / length


def write(name, displacement, places):
    with (Path(__file__).parent / name).open("w") as out:
        for length in LENGTHS:
            for x, y in places:
                out.write(f"{x},{y},{length},{mp.nstr(wake(displacement, x, y, mpf(length)), 18)}\n")


if __name__ == "__main__":
    write("wake_oracle.csv", love, PLACES)
    write("line_oracle.csv", strip, [(x, y) for x, y in PLACES if y == 0])
