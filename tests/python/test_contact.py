"""The study of a contact case opens with xarray and meshio, and its fields are those of the contact."""

import json
import subprocess
import warnings

import meshio
import numpy as np
import pytest
import xarray as xr

CASE = """
model = "contact"
[indenter]
shape = "sphere"

[[analysis]]
name = "one"
kind = "contact"
velocity = 0.1
indentation = 1e-2
accuracy = 2e-2

[[analysis]]
name = "law"
kind = "contact-law"
velocity = { from = 1e-2, to = 1e1, points = 5 }
indentation = { from = 1e-2, to = 1e-1, points = 3 }
accuracy = 0.1

[[analysis]]
name = "modulus"
kind = "modulus"
"""


@pytest.fixture(scope="module")
def study(judder, tmp_path_factory):
    folder = tmp_path_factory.mktemp("contact")
    (folder / "case.toml").write_text(CASE)
    run = subprocess.run([judder, "run", "case.toml"], cwd=folder, capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    return folder / "out" / "case"


@pytest.fixture(autouse=True)
def warnings_are_errors():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        yield


def opened(study, name):
    return xr.open_zarr(study / "results.zarr", group=name).load()


def test_the_pressure_adds_up_to_the_force(study):
    results = json.loads((study / "summary.json").read_text())["results"]["one"]
    one = opened(study, "one")
    assert one.pressure.dims == ("y", "x") and one.gap.dims == ("y", "x_surface")
    cell = float(one.x[1] - one.x[0])
    assert float(one.pressure.sum()) * cell**2 == pytest.approx(results["force"], rel=2e-2)
    assert float(one.pressure.min()) >= 0.0 and float(one.gap.min()) > -1e-6
    assert np.abs(np.minimum(one.pressure.values, one.gap.values)).max() < 1e-6


def test_the_fields_for_paraview_are_those_of_the_arrays(study):
    one = opened(study, "one")
    mesh = meshio.read(study / "fields" / "one.vtu")
    assert len(mesh.cells) == 1 and mesh.cells[0].type == "quad"
    corners = mesh.points[mesh.cells[0].data]
    np.testing.assert_allclose(corners.mean(axis=1)[:, 0].reshape(one.pressure.shape)[0], one.x, atol=1e-12)
    np.testing.assert_array_equal(mesh.cell_data["pressure"][0].reshape(one.pressure.shape), one.pressure)
    np.testing.assert_array_equal(mesh.cell_data["gap"][0].reshape(one.gap.shape), one.gap)


def test_a_law_has_its_plane_and_its_file(study):
    law = opened(study, "law")
    assert dict(law.force.sizes) == {"indentation": 3, "velocity": 5}
    hertz = 4 / 3 * law.indentation**1.5
    assert bool((law.force > 0.9 * hertz).all()) and bool((law.force < 11 * hertz).all())
    assert json.loads((study / "law.json").read_text())["format"] == "judder-contact-law"


def test_moduli_are_over_frequency(study):
    modulus = opened(study, "modulus")
    assert modulus.storage_modulus.attrs["units"] == "Pa"
    assert bool((modulus.storage_modulus.diff("frequency") >= 0).all())
    np.testing.assert_allclose(modulus.loss_tangent, modulus.loss_modulus / modulus.storage_modulus, rtol=1e-10)
