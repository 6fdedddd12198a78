"""From two meshes of a brake to the friction from which on it squeals."""

import numpy as np

from judder.models import Assembly


def plate(size, cells, origin):
    """The mesh of a rectangle in m; any mesh of meshio takes its place."""
    x, y = (np.linspace(start, start + length, count + 1) for start, length, count in zip(origin, size, cells))
    node = np.arange(x.size * y.size).reshape(y.size, x.size)
    corners = [node[:-1, :-1], node[:-1, 1:], node[1:, 1:], node[1:, :-1]]
    sides = {"left": node[:, 0], "right": node[:, -1], "bottom": node[0], "top": node[-1]}
    points = np.column_stack([np.tile(x, y.size), np.repeat(y, x.size)])
    return {"points": points, "cells": {"quad": np.stack(corners, axis=-1).reshape(-1, 4)}, "point_sets": sides}


def body(name, mesh, modulus, density, beta, held):
    material = {"youngs_modulus": modulus, "poisson_ratio": 0.3, "density": density}
    damping = {"rayleigh": {"alpha": "10 1/s", "beta": beta}}
    return {"name": name, "mesh": mesh, "section": "plane-stress", "width": "40 mm", "material": material, "damping": damping, "supports": held}


ends = [{"set": side, "fixed": ["x", "y"]} for side in ("left", "right")]
lining = {
    "name": "lining", "slider": {"structure": "pad", "set": "bottom"}, "track": {"structure": "strip", "set": "top"},
    "sliding": {"velocity": "2 m/s", "direction": [1, 0]}, "normal": {"stiffness": "2e11 N/m^3"},
    "friction_coefficient": {"at_rest": 0.55, "at_speed": 0.35, "decay_speed": "1 m/s"},
}  # fmt: skip
strip = body("strip", plate((0.12, 0.008), (48, 3), (0.0, 0.0)), "110 GPa", "7200 kg/m^3", "1e-8 s", ends)
pad = body("pad", plate((0.05, 0.012), (11, 4), (0.035, 0.008)), "8 GPa", "2500 kg/m^3", "2e-8 s", [{"set": "right", "fixed": ["x"]}])
brake = Assembly(structure=[strip, pad], contact=[lining], load=[{"structure": "pad", "set": "top", "pressure": "1 MPa"}])
band = ["500 Hz", "12 kHz"]
for mode in brake.eigen(band=band).numbers["eigenvalues"]:
    print(f"{mode['frequency_hz']:.0f} Hz: {mode['verdict']}, {mode['re']:+.0f} 1/s")
along = {"key": "contact.lining.friction_coefficient.at_rest", "from": 0.36, "to": 0.55, "points": 3}
for onset in brake.eigen_sweep(band=band, sweep=along).numbers["onsets"]:
    print(f"{onset['frequency_hz']:.0f} Hz squeals from a friction coefficient at rest of {onset['value']:.3f} on")
