"""The peer of judder's sliding contact: the same problem in NumPy and SciPy, as one would write it from the papers.

    python benches/peer/scipy_sliding.py CELLS CONTRAST Z [REPEATS]

A paraboloid on a viscoelastic half-space with one retardation time; lengths in the elastic contact radius. Love's cell and its wake by
recurrence, padded transforms, a primal-dual active set with SciPy's GMRES and the symbol's inverse as preconditioner, nested
grids. Displacements and heights are compared a loss angle upstream of the cells' centres, as judder does. Prints one line of JSON.
"""

import json
import sys
import time

import numpy as np
from scipy import fft
from scipy.sparse.linalg import LinearOperator, gmres

NODES, WEIGHTS = np.polynomial.legendre.leggauss(8)
NODES, WEIGHTS = (NODES + 1) / 2, WEIGHTS / 2


def love(x, y, h):
    """Displacement under a unit pressure on a square cell of side h, in units of pressure over E0*."""

    def corner(x, y):
        return x * np.arcsinh(y / np.abs(x)) + y * np.arcsinh(x / np.abs(y))

    a = h / 2
    # No lattice point lies on the edge of a cell, but the nodes of the quadrature may come near.
    return (corner(x + a, y + a) - corner(x - a, y + a) - corner(x + a, y - a) + corner(x - a, y - a)) / np.pi


def kernel(n, h, contrast, length, shift):
    """The kernel at all differences of two cells, rows y = 0 … n−1, columns x = −(n−1) … n−1, less the shift."""
    x = np.arange(1 - n, n) * h - shift + 1e-9 * h
    y = np.arange(n)[:, None] * h
    values = love(x, y, h) / contrast
    wake = np.zeros((n, 2 * n - 1))
    reach, width = 0.0, min(x[-1], length) / 2
    while reach < 40 * length:
        for node, weight in zip(NODES, WEIGHTS):
            s = reach + node * width
            wake[:, -1] += weight * width / length * np.exp(-s / length) * love(x[-1] + s, y[:, 0], h)
        reach += width
        width = min(0.7 * (x[-1] + reach), 2 * length)
    cell = np.zeros((n, 2 * n - 2))
    for node, weight in zip(NODES, WEIGHTS):
        cell += weight * h / length * np.exp(-node * h / length) * love(x[:-1] + node * h, y, h)
    decay = np.exp(-h / length)
    for column in range(2 * n - 3, -1, -1):
        wake[:, column] = decay * wake[:, column + 1] + cell[:, column]
    return values + (1 - 1 / contrast) * wake


class Contact:
    """Products and approximate inverses on one grid."""

    def __init__(self, n, centre, half_width, contrast, length):
        self.n, self.h = n, 2 * half_width / n
        compliance = lambda q: 1 / contrast + (1 - 1 / contrast) / (1 - 1j * q * length)
        self.shift = self.h * np.angle(compliance(np.pi / self.h)) / np.pi
        values = kernel(n, self.h, contrast, length, self.shift)
        size = 2 * n
        padded = np.zeros((size, size))
        columns = np.arange(1 - n, n) % size
        padded[:n, columns] = values
        padded[-(n - 1) :, columns] = values[:0:-1]
        self.spectrum = fft.rfft2(padded)
        q_x = 2 * np.pi * fft.rfftfreq(n, self.h)
        q_y = 2 * np.pi * fft.fftfreq(n, self.h)[:, None]
        q = np.maximum(np.hypot(q_x, q_y), np.pi / (n * self.h))
        self.inverse = q / (2 * compliance(q_x)) * np.exp(1j * q_x * self.shift)
        axis = (np.arange(n) + 0.5) * self.h - half_width
        self.x = axis + centre
        self.heights = ((self.x - self.shift) ** 2 + axis[:, None] ** 2) / 2

    def displacement(self, pressure):
        size = 2 * self.n
        return fft.irfft2(fft.rfft2(pressure, (size, size)) * self.spectrum, (size, size))[: self.n, : self.n]

    def solve(self, pressure, tolerance=1e-5):
        """The active set from a starting pressure, to a largest residual of `tolerance` of the depth."""
        inside = pressure > 0 if pressure.any() else self.heights < 1
        residual, products, finest = (5e-4 if pressure.any() else 1e-2), 0, 0.05 * tolerance
        for _ in range(200):
            full = np.zeros_like(pressure)

            def scatter(values):
                full[:] = 0
                full[inside] = values
                return full

            def product(values):
                nonlocal products
                products += 1
                return self.displacement(scatter(values))[inside]

            def precondition(values):
                return fft.irfft2(fft.rfft2(scatter(values)) * self.inverse, full.shape)[inside]

            count = int(inside.sum())
            right = 1 - self.heights[inside]
            start = pressure[inside]
            start_residual = right - product(start)
            # SciPy preconditions from the left only: the right form solves for the preconditioned unknown.
            operator = LinearOperator((count, count), matvec=lambda z: product(precondition(z)))
            if np.linalg.norm(start_residual) > residual * np.linalg.norm(right):
                z, _ = gmres(operator, start_residual, rtol=0, atol=residual * np.linalg.norm(right), restart=60)
                start = start + precondition(z)
            pressure = np.zeros_like(pressure)
            pressure[inside] = start
            gap = self.displacement(pressure) + self.heights - 1
            products += 1
            changed = np.where(inside, pressure < 0, gap < -0.5 * tolerance)
            if not changed.any():
                worst = max(np.minimum(pressure / pressure.max(), np.abs(gap)).max(), -gap.min())
                if residual <= finest:
                    if worst <= tolerance:
                        return pressure, products, worst
                    finest *= 0.05
                residual = max(0.05 * residual, finest)
                continue
            if changed.sum() < 0.03 * count:
                residual = max(0.05 * residual, finest)
            inside = inside ^ changed
            pressure = np.where(inside & ~changed, pressure, 0)
        sys.exit("the active set did not come to rest")


def domain(contrast, length):
    """Centre and half width of the square that the contact fills, from a coarse grid."""
    centre, half_width = 0.0, 1.02 * np.sqrt(2)
    for _ in range(4):
        contact = Contact(32, centre, half_width, contrast, length)
        pressure, _, _ = contact.solve(np.zeros((32, 32)))
        rows, columns = np.nonzero(pressure)
        half = max(np.ptp(rows) + 1, np.ptp(columns) + 1) * contact.h / 2
        if half > 0.72 * half_width:
            break
        centre = contact.x[[columns.min(), columns.max()]].mean()
        half_width = (half + contact.h) / 0.82
    return centre, half_width


def solve(cells, contrast, length):
    centre, half_width = domain(contrast, length)
    n, pressure, total = 32, np.zeros((32, 32)), 0
    while True:
        contact = Contact(n, centre, half_width, contrast, length)
        pressure, products, worst = contact.solve(pressure)
        total += products
        if n == cells:
            break
        n, pressure = 2 * n, np.repeat(np.repeat(pressure, 2, 0), 2, 1)
    force = pressure.sum() * contact.h**2
    friction = (pressure * contact.x).sum() * contact.h**2 / force
    return {"force": force, "friction": friction, "residual": worst, "products": total}


def main():
    cells, contrast, length = int(sys.argv[1]), float(sys.argv[2]), float(sys.argv[3])
    repeats = int(sys.argv[4]) if len(sys.argv) > 4 else 3
    answer, seconds = solve(cells, contrast, length), []
    for _ in range(repeats):
        start = time.perf_counter()
        answer = solve(cells, contrast, length)
        seconds.append(time.perf_counter() - start)
    print(json.dumps(answer | {"seconds": min(seconds)}))


if __name__ == "__main__":
    main()
