"""The eigenvalues of the disc brake in a region by SciPy's sparse shift-invert; prints seconds and eigenvalues as JSON.

    python scipy_eigen.py FOLDER SPEED

(λ²M + λC + K) x = 0, −50 < Re λ < 1000, 0 < Im λ < 20000 in 1/s, made linear in (x, λ x/ρ), which turns a solution with λ²M + λC + K at a shift
into one with the pencil. Each of the discs that cover the region is searched by ARPACK for right and, from the same factors, for left
vectors, with more and more eigenvalues until the farthest lies outside of the disc; then each pair is refined by one step of residual
inverse iteration and one of Newton.
"""

import json
import sys
import time
from pathlib import Path

import numpy as np
import scipy.io
import scipy.sparse as sparse
from scipy.sparse.linalg import LinearOperator, eigs, splu

RE, IM = (-50.0, 1000.0), (0.0, 20000.0)
PARTS = 2
REPEATS = 2


def read(folder: Path, name: str) -> sparse.csc_matrix:
    variables = scipy.io.loadmat(folder / f"{name}.mat")
    return sparse.csc_matrix(next(v for k, v in variables.items() if not k.startswith("__")), dtype=float)


def assemble(folder: Path, speed: float) -> tuple[sparse.csc_matrix, ...]:
    mass = read(folder, "BMLL00")
    damping = (
        read(folder, "BDLL00")
        + speed * read(folder, "BYLL00")
        + (1.0 / speed - 1.0) * read(folder, "BDIWLL00")
        + read(folder, "BHLL00") / (2.0 * np.pi * 1600.0)
    )
    stiffness = read(folder, "BKLL00") + read(folder, "BKQLL00") + (speed**2 - 1.0) * read(folder, "BWLL00")
    return mass, damping, stiffness


def search(solve, mass, slope, radius: float, size: int) -> tuple[np.ndarray, np.ndarray]:
    """All eigenvalues θ = ρ/(λ − σ) with |θ| ≥ 1, and the upper halves of their vectors."""

    def through(vector: np.ndarray) -> np.ndarray:
        x, u = vector[:size], vector[size:]
        return np.concatenate([-radius * solve(slope @ x + radius * (mass @ u)), x])

    operator = LinearOperator((2 * size, 2 * size), matvec=through, dtype=complex)
    count = 16
    while True:
        start = np.random.default_rng(1).standard_normal(2 * size) + 0j
        values, vectors = eigs(operator, k=count, ncv=3 * count, v0=through(start), tol=1e-11)
        if np.min(np.abs(values)) < 1.0:
            return values, vectors[:size]
        count *= 2


def eigenvalues(mass, damping, stiffness, re=RE, im=IM, ordering="COLAMD") -> list[complex]:
    """The eigenvalues of the region, by rising imaginary part."""
    size = mass.shape[0]
    found: list[complex] = []
    height = (im[1] - im[0]) / PARTS
    for part in range(PARTS):
        shift = complex(0.5 * (re[0] + re[1]), im[0] + (part + 0.5) * height)
        radius = float(np.hypot(0.5 * (re[1] - re[0]), 0.5 * height)) * 1.2
        factor = splu((shift**2 * mass + shift * damping + stiffness).tocsc(), permc_spec=ordering)
        slope = 2.0 * shift * mass + damping
        right, x = search(factor.solve, mass, slope, radius, size)
        left, z = search(lambda b: factor.solve(b, trans="T"), mass.T, slope.T, radius, size)
        for theta, vector in zip(right, x.T):
            value = shift + radius / theta
            other = z[:, np.argmin(np.abs(left - theta))]
            image = (value**2 * mass + value * damping + stiffness) @ vector
            vector = vector - factor.solve(image)
            image = (value**2 * mass + value * damping + stiffness) @ vector
            value -= (other @ image) / (other @ ((2.0 * value * mass + damping) @ vector))
            inside = re[0] < value.real < re[1] and im[0] + part * height < value.imag <= im[0] + (part + 1) * height
            if inside:
                found.append(value)
    return sorted(found, key=lambda value: value.imag)


def main() -> int:
    matrices = assemble(Path(sys.argv[1]), float(sys.argv[2]))
    seconds = float("inf")
    for _ in range(REPEATS):
        begin = time.perf_counter()
        found = eigenvalues(*matrices)
        seconds = min(seconds, time.perf_counter() - begin)
    print(json.dumps({"seconds": seconds, "eigenvalues": [[value.real, value.imag] for value in found]}))
    return 0


if __name__ == "__main__":
    sys.exit(main())
