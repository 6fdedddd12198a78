"""Assemblies against a second implementation of all of it, in NumPy: elements, contact, steady sliding, eigenvalues."""

import csv
import json
import pathlib
import subprocess

import numpy as np
import pytest
from scipy.linalg import eigvals

CASES = pathlib.Path(__file__).resolve().parents[2] / "cases" / "assembly"
GAUSS = 1.0 / np.sqrt(3.0)
CORNERS = np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])


def gradients(x, y):
    """Slopes of the four bilinear shape functions by the element's own coordinates."""
    a, b = CORNERS.T
    return np.array([0.25 * a * (1.0 + b * y), 0.25 * b * (1.0 + a * x)])


def element(corners, stiffness, density, width):
    """A quadrilateral with the incompatible modes of Wilson and Taylor, and its consistent mass."""
    k, m = np.zeros((12, 12)), np.zeros((8, 8))
    middle = gradients(0.0, 0.0) @ corners
    for x in (-GAUSS, GAUSS):
        for y in (-GAUSS, GAUSS):
            jacobian = gradients(x, y) @ corners
            area = np.linalg.det(jacobian)
            inner = np.linalg.det(middle) / area * np.linalg.inv(middle) @ np.diag([-2.0 * x, -2.0 * y])
            slopes = np.hstack([np.linalg.inv(jacobian) @ gradients(x, y), inner])
            strains = np.zeros((3, 12))
            strains[0, 0::2], strains[1, 1::2] = slopes
            strains[2, 0::2], strains[2, 1::2] = slopes[1], slopes[0]
            k += width * area * strains.T @ stiffness @ strains
            shape = np.zeros((2, 8))
            shape[0, 0::2] = shape[1, 1::2] = 0.25 * (1.0 + CORNERS[:, 0] * x) * (1.0 + CORNERS[:, 1] * y)
            m += density * width * area * shape.T @ shape
    return k[:8, :8] - k[:8, 8:] @ np.linalg.solve(k[8:, 8:], k[8:, :8]), m


class Block:
    """A rectangle of equal quadrilaterals: M, C, K on its free displacements."""

    def __init__(self, size, cells, origin, modulus, ratio, density, width, is_strain, alpha, beta, fixed):
        self.columns, self.rows, self.width = cells[0] + 1, cells[1] + 1, width
        xs, ys = (o + np.linspace(0.0, s, c + 1) for o, s, c in zip(origin, size, cells))
        self.places = np.array([[x, y] for y in ys for x in xs])
        if is_strain:
            entries = [[1 - ratio, ratio, 0], [ratio, 1 - ratio, 0], [0, 0, 0.5 - ratio]]
            stiffness = modulus / ((1 + ratio) * (1 - 2 * ratio)) * np.array(entries)
        else:
            entries = [[1, ratio, 0], [ratio, 1, 0], [0, 0, 0.5 - 0.5 * ratio]]
            stiffness = modulus / (1 - ratio**2) * np.array(entries)
        count = 2 * len(self.places)
        k, m = np.zeros((count, count)), np.zeros((count, count))
        for row in range(cells[1]):
            for column in range(cells[0]):
                first = row * self.columns + column
                nodes = [first, first + 1, first + 1 + self.columns, first + self.columns]
                own = np.array([[2 * node, 2 * node + 1] for node in nodes]).ravel()
                of_element = element(self.places[nodes], stiffness, density, width)
                for whole, part in zip((k, m), of_element):
                    whole[np.ix_(own, own)] += part
        held = [2 * node + axis for side, axis in fixed for node in self.side(side)]
        self.free = np.setdiff1d(np.arange(count), held)
        self.whole = k
        self.k, self.m = (matrix[np.ix_(self.free, self.free)] for matrix in (k, m))
        self.c = alpha * self.m + beta * self.k

    def side(self, name):
        nodes = np.arange(self.columns * self.rows).reshape(self.rows, self.columns)
        return {"y-min": nodes[0], "y-max": nodes[-1], "x-min": nodes[:, 0], "x-max": nodes[:, -1]}[name]

    def form(self, node, axis):
        """A displacement as a row on the free ones."""
        return (self.free == 2 * node + axis).astype(float)


def steady(k, load, normal, slip, law):
    """Openings, normal forces, friction forces: of rigid points by active sets, of compliant ones by Newton's method."""
    friction, stiffness = law
    if stiffness is None:
        closed = np.ones(len(normal), bool)
        while True:
            push = normal[closed] + friction * slip[closed]
            count = closed.sum()
            system = np.block([[k, -push.T], [normal[closed], np.zeros((count, count))]])
            solution = np.linalg.solve(system, np.r_[load, np.zeros(count)])
            q, force = solution[: len(load)], np.zeros(len(normal))
            force[closed] = solution[len(load) :]
            wrong = np.where(closed, force < 0.0, normal @ q < 0.0)
            if not wrong.any():
                return closed, force
            closed ^= wrong
    q = np.zeros(len(load))
    for _ in range(50):
        closed = normal @ q < 0.0
        if not q.any():
            closed[:] = True
        own = stiffness * closed
        matrix = k + (normal + friction * slip).T @ (own[:, None] * normal)
        moved = np.linalg.solve(matrix, load)
        if np.abs(moved - q).max() <= 1e-14 * np.abs(moved).max():
            break
        q = moved
    return closed, -own * (normal @ q)


def spectrum(m, c, k, normal, slip, closed, force, law, slope):
    """Eigenvalues of small motions over the closed points."""
    friction, stiffness = law
    normal, slip, force = normal[closed], slip[closed], force[closed]
    c = c + slip.T @ ((slope * force)[:, None] * slip)
    if stiffness is None:
        dependent = [np.argmax(np.abs(row)) for row in normal]
        kept = np.setdiff1d(np.arange(len(k)), dependent)
        trial, test = np.eye(len(k))[:, kept], np.eye(len(k))[:, kept]
        trial[dependent] = -np.linalg.solve(normal[:, dependent], normal[:, kept])
        push = normal + friction * slip
        test[dependent] = -np.linalg.solve(push[:, dependent], push[:, kept])
        m, c, k = (test.T @ matrix @ trial for matrix in (m, c, k))
    else:
        k = k + (normal + friction * slip).T @ (stiffness[closed][:, None] * normal)
    state = np.block([[np.zeros_like(m), np.eye(len(m))], [-np.linalg.solve(m, k), -np.linalg.solve(m, c)]])
    return eigvals(state)


def results(judder, tmp_path, case, *options):
    sets = [part for option in options for part in ("--set", option)]
    subprocess.run([judder, "run", CASES / case, "-o", tmp_path, *sets], check=True, capture_output=True)
    with open(tmp_path / "steady.csv", newline="") as table:
        forces = np.array([float(row["normal_force_n"]) for row in csv.DictReader(table)])
    return forces, json.loads((tmp_path / "summary.json").read_text())["results"]["modes"]


def check(modes, expected, tolerance=1e-8):
    """Every eigenvalue is one of the expected ones, and as many of these lie in the band."""
    found = np.array([own["re"] + 1j * own["im"] for own in modes["eigenvalues"]])
    assert modes["complete"] and len(found) > 0
    for value in found:
        assert np.abs(expected - value).min() < tolerance * np.abs(value)
    return found


@pytest.mark.parametrize(
    ("friction", "law"), [(0.2, "rigid"), (0.5, "rigid"), (0.9, "rigid"), (0.5, 2e13), (0.5, "falling")]
)
def test_a_block_on_a_plane(judder, tmp_path, friction, law):
    block = Block(
        (0.04, 0.02), (20, 10), (0.0, 0.0), 2e9, 0.35, 1200.0, 0.01, True, 100.0, 5e-8, [("y-max", 0), ("y-max", 1)]
    )
    pressed = np.zeros(len(block.whole))
    pressed[2 * block.side("y-max") + 1] = -20e-6
    load = -(block.whole @ pressed)[block.free]
    sole = block.side("y-min")
    normal, slip = (np.array([block.form(node, axis) for node in sole]) for axis in (1, 0))
    options, stiffness, slope, coefficient = [], None, 0.0, friction
    if law == "falling":
        options = ["contact.sole.friction_coefficient={ at_rest = 0.6, at_speed = 0.4, decay_speed = \"0.7 m/s\" }"]
        falls = 0.2 * np.exp(-1.0 / 0.7)
        coefficient, slope = 0.4 + falls, -falls / 0.7
    else:
        options = [f"contact.sole.friction_coefficient={friction}"]
    if isinstance(law, float):
        options.append(f'contact.sole.normal={{ stiffness = "{law} N/m^3" }}')
        areas = np.full(len(sole), 0.04 / 20 * 0.01)
        areas[[0, -1]] *= 0.5
        stiffness = law * areas
    forces, modes = results(judder, tmp_path, "block-on-plane.toml", *options)
    closed, expected = steady(block.k, load, normal, slip, (coefficient, stiffness))
    assert np.abs(forces - expected).max() < 1e-7 * expected.max()
    values = spectrum(block.m, block.c, block.k, normal, slip, closed, expected, (coefficient, stiffness), slope)
    found = check(modes, values)
    last = found.imag.max() * (1 + 1e-9)
    assert len(found) == 12 == ((values.imag > 0) & (values.imag <= last) & (np.abs(values.real) < 0.5 * last)).sum()


def test_a_pad_on_a_strip_whose_mesh_does_not_match(judder, tmp_path):
    strip = Block(
        (0.12, 0.008), (60, 3), (0.0, 0.0), 110e9, 0.28, 7200.0, 0.04, False, 10.0, 1e-8,
        [("x-min", 0), ("x-min", 1), ("x-max", 0), ("x-max", 1)],
    )
    pad = Block((0.05, 0.012), (21, 5), (0.035, 0.008), 8e9, 0.3, 2500.0, 0.04, False, 20.0, 2e-8, [("x-max", 0)])
    top, upper = strip.side("y-max"), pad.side("y-max")
    load = np.zeros(len(pad.whole))
    lengths = np.full(len(upper), 0.05 / 21)
    lengths[[0, -1]] *= 0.5
    load[2 * upper + 1] = -1e6 * 0.04 * lengths
    load = np.r_[np.zeros(len(strip.free)), load[pad.free]]
    normal, slip = [], []
    for node in pad.side("y-min"):
        place = pad.places[node, 0] / 0.002
        left = int(np.floor(place + 1e-9))
        share = place - left
        for rows, axis in ((normal, 1), (slip, 0)):
            under = (1 - share) * strip.form(top[left], axis) + share * strip.form(top[min(left + 1, 60)], axis)
            rows.append(np.r_[-under, pad.form(node, axis)])
    normal, slip = np.array(normal), np.array(slip)
    m, c, k = (
        np.block([[a, np.zeros((len(a), len(b)))], [np.zeros((len(b), len(a))), b]])
        for a, b in ((strip.m, pad.m), (strip.c, pad.c), (strip.k, pad.k))
    )
    falls = 0.1 * np.exp(-2.0)
    law = (0.35 + falls, 2e12 * 0.04 * lengths)
    forces, modes = results(judder, tmp_path, "pad-on-disc-strip.toml")
    closed, expected = steady(k, load, normal, slip, law)
    assert np.abs(forces - expected).max() < 1e-7 * expected.max()
    check(modes, spectrum(m, c, k, normal, slip, closed, expected, law, -falls))
