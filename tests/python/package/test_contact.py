"""Contacts, and laws of a user's own wherever a law goes."""

import json
import pickle
import warnings

import numpy as np
import pytest

import judder
from common import ROOT, files

VELOCITY, INDENTATION = (1e-7, 1e3), (1e-7, 1e-1)


def bell(velocity, indentation):
    """Hertz, stiffening from E0 to E∞, with a bell of friction: a law that no formula of judder's is."""
    stiffening = 1.0 + 9.0 * velocity**2 / (1.0 + velocity**2)
    return 4 / 3 * stiffening * indentation**1.5, np.pi * indentation, 0.6 * velocity / (1.0 + velocity**2) * np.sqrt(indentation)


@pytest.fixture(scope="module")
def law():
    return judder.contact.Law.from_function(bell, velocity=VELOCITY, indentation=INDENTATION, tolerance=1e-5)


def test_a_function_becomes_a_law_as_exact_as_it_says(law):
    assert max(law.errors.values()) <= 1e-5
    velocity, indentation = np.logspace(-6, 2, 23)[:, None], np.logspace(-6, -2, 19)
    response, exact = law.evaluate(velocity, indentation), bell(velocity, indentation)
    assert response.force.shape == (23, 19)
    np.testing.assert_allclose(response.force, exact[0], rtol=2e-5)
    np.testing.assert_allclose(response.area, np.broadcast_to(exact[1], (23, 19)), rtol=2e-5)
    np.testing.assert_allclose(response.friction, exact[2], atol=2e-5 * exact[2].max())
    # the derivatives are those of the law, by differences
    velocity, step = np.logspace(-3, 2, 23)[:, None], 1e-6
    response = law.evaluate(velocity, indentation)
    up, down = law.evaluate(velocity * (1 + step), indentation), law.evaluate(velocity * (1 - step), indentation)
    np.testing.assert_allclose(response.force_by_velocity, (up.force - down.force) / (2 * step * velocity), rtol=1e-3)
    up, down = law.evaluate(velocity, indentation * (1 + step)), law.evaluate(velocity, indentation * (1 - step))
    np.testing.assert_allclose(response.force_by_indentation, (up.force - down.force) / (2 * step * indentation), rtol=1e-6)


def test_a_law_of_the_paper_sampled_is_that_law_wherever_a_law_goes(tmp_path, map_case):
    paper = judder.contact.Law("oscillator-paper")

    def values(velocity, indentation):
        response = paper.evaluate(velocity, indentation)
        return response.force, response.area, response.friction

    own = judder.contact.Law.from_function(values, velocity=(1e-9, 1e3), indentation=(1e-9, 1e-1), tolerance=1e-6)
    exact, found = judder.oscillator.point(law="oscillator-paper"), judder.oscillator.point(law=own)
    np.testing.assert_allclose(found.eigenvalues, exact.eigenvalues, rtol=1e-4)
    np.testing.assert_allclose(found.critical_load, exact.critical_load, rtol=1e-3)
    sides = ("velocity", np.logspace(-6, 0, 24)), ("shear_strength", np.linspace(0, 0.2, 20))
    own_map = judder.oscillator.stability_map(*sides, law=own)
    np.testing.assert_allclose(own_map.growth_rate, judder.oscillator.stability_map(*sides).growth_rate, atol=1e-4)
    study = judder.run(map_case, output=tmp_path / "python", law=own)
    np.testing.assert_allclose(study["map"].growth_rate, own_map.growth_rate, rtol=1e-12, atol=1e-14)
    # in a case file, through the command's own reader: the same bytes
    own.save(tmp_path / "law.json")
    case = tmp_path / "case.toml"
    case.write_text(map_case + '\n[contact]\nlaw = { file = "law.json" }\n')
    by_file = judder.run(case, output=tmp_path / "file")
    assert files(study.folder / "results.zarr") == files(by_file.folder / "results.zarr")
    assert by_file.summary["case"] == study.summary["case"]


def test_a_table_is_a_law(law):
    velocity, indentation = np.array([1e-4, 1e-3, 2e-2, 0.1, 1.0]), np.array([1e-4, 5e-4, 1e-2])
    table = bell(velocity, indentation[:, None])
    area = np.broadcast_to(table[1], (3, 5))
    own = judder.contact.Law.from_table(velocity, indentation, table[0], area, table[2], source="my rig")
    at = own.evaluate(velocity, indentation[:, None])
    np.testing.assert_allclose(at.force, table[0], rtol=1e-13)
    np.testing.assert_allclose(at.friction, table[2], rtol=1e-12)
    assert own.name == "my rig" and own != law and own.concern(1e-3, 1e-3) is None
    assert "beyond" in own.concern(10.0, 1e-3) and "beyond" in own.concern(1e-3, 1e-6)
    for other in (pickle.loads(pickle.dumps(own)), judder.contact.Law.from_json(own.to_json())):
        assert other == own and other.name == "my rig"
    assert json.loads(own.to_json())["format"] == "judder-sampled-law"


def test_tables_and_functions_that_are_none():
    law, ones = judder.contact.Law, np.ones((2, 2))
    for velocity, table, kind in (
        ([1.0, 0.5], ones, judder.LawError),
        ([0.0, 0.5], ones, judder.LawError),
        ([0.5], np.ones((2, 1)), judder.LawError),
        ([0.5, 1.0], -ones, judder.LawError),
        ([0.5, 1.0], np.ones((2, 3)), judder.InputError),
        ([0.5, 1.0], np.full((2, 2), np.nan), judder.InputError),
        ([], ones, judder.InputError),
    ):
        with pytest.raises(kind):
            law.from_table(velocity, [1e-3, 1e-2], table, table, table)
    ranges = {"velocity": (1e-3, 1.0), "indentation": (1e-3, 1e-1)}
    for function in (lambda v, y: v, lambda v, y: (v, y), lambda v, y: (v, y, v[:3]), lambda v, y: (v, y, v * np.nan), lambda v, y: (-v, y, v)):
        with pytest.raises(judder.JudderError):
            law.from_function(function, **ranges)
    with pytest.raises(ZeroDivisionError):
        law.from_function(lambda v, y: 1 / 0, **ranges)
    for change in ({"velocity": (1.0, 1e-3)}, {"velocity": (0.0, 1.0)}, {"indentation": (1e-3, np.nan)}, {"tolerance": 0.0}):
        with pytest.raises(judder.LawError):
            law.from_function(bell, **{**ranges, **change})
    with pytest.warns(judder.JudderWarning, match="too steep"):
        stepped = law.from_function(lambda v, y: (y**1.5, y, (v > 0.1) * 1.0), tolerance=1e-3, **ranges)
    assert stepped.errors["friction"] > 1e-3
    with pytest.raises(judder.InputError, match="model `contact`"):
        judder.run(ROOT / "cases" / "contact" / "sliding-sphere.toml", law=stepped)
    with pytest.raises(judder.InputError, match="contact.law"):
        judder.run({"model": "oscillator"}, law=law("hertz"))
    with pytest.raises(judder.InputError):
        law("hertz").evaluate(-1.0, 1e-2)
    with pytest.raises(judder.InputError):
        law("hertz").evaluate([1.0, 2.0], [1.0, 2.0, 3.0])


def test_points_outside_the_range_of_a_law_are_told(law):
    with pytest.warns(judder.JudderWarning, match=r"outside the law's range at 2 of 3 points, for one: speed v τ/R") as told:
        law.evaluate([1.0, 1e4, 1e5], 1e-3)
    assert told[0].filename == __file__
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        law.evaluate(np.geomspace(*VELOCITY, 5)[:, None], np.geomspace(*INDENTATION, 5))


def test_a_slow_contact_is_that_of_hertz():
    # Hertz, Journal für die reine und angewandte Mathematik 92 (1881): F = 4/3 E* √R δ^{3/2}, A = π R δ
    contact = judder.contact.solve(1e-8, indentation=1e-2, accuracy=1e-3)
    assert contact.converged and contact.levels[-1].cells >= 64
    assert abs(contact.force / (4 / 3 * 1e-3) - 1) < 2e-3 and abs(contact.area / (np.pi * 1e-2) - 1) < 1e-2
    cell = contact.x[1] - contact.x[0]
    assert contact.pressure.shape == contact.gap.shape == (contact.y.size, contact.x.size)
    assert abs(contact.pressure.sum() * cell**2 / contact.levels[-1].force - 1) < 1e-9
    by_load = judder.contact.solve(1e-8, load=contact.force, accuracy=1e-3)
    assert abs(by_load.indentation / 1e-2 - 1) < 2e-3
    assert contact.to_dataset().pressure.attrs["units"] == "1"


def test_heights_press_as_the_shape_they_are():
    spacing, side = 2e-3, np.linspace(-0.25, 0.25, 251)
    heights = 0.5 * (side**2 + side[:, None] ** 2)
    by_heights = judder.contact.solve(0.1, indentation=1e-2, shape=(heights, spacing), accuracy=1e-2)
    by_name = judder.contact.solve(0.1, indentation=1e-2, accuracy=1e-2)
    assert abs(by_heights.force / by_name.force - 1) < 1e-2


def test_a_cylinder_on_a_layer_is_that_of_a_case():
    layer = judder.contact.Substrate(thickness=0.4, poisson_ratio=0.49)
    found = judder.contact.solve(0.2, indentation=0.02, shape="cylinder", substrate=layer, accuracy=1e-2)
    rubber = {"rubbery_modulus": "1 MPa", "glassy_modulus": "10 MPa", "retardation_time": "10 ms", "poisson_ratio": 0.49, "thickness": "2 mm"}
    case = judder.models.Contact(substrate=rubber, indenter={"radius": "5 mm", "shape": "cylinder"})
    theirs = case.contact(velocity="100 mm/s", indentation="0.1 mm", accuracy=1e-2).numbers
    modulus = 1e6 / (1 - 0.49**2)
    assert found.force == pytest.approx(theirs["force_newton_per_metre"] / (modulus * 5e-3), rel=1e-9)
    assert found.peak_pressure == pytest.approx(theirs["peak_pressure_pascal"] / modulus, rel=1e-9)
    assert found.to_dataset().attrs["asked_thickness"] == 0.4


def test_a_thin_layer_yields_where_it_is_pressed():
    """Johnson, Contact Mechanics (1985), (5.69): P = 2/3 (1 - ν)²/(1 - 2ν) E/(1 - ν²) a³/(R h), a² = 2 R δ, of a contact far wider than the layer."""
    depth, thickness, nu = 2e-4, 5e-4, 0.3
    layer = judder.contact.Substrate(thickness=thickness, poisson_ratio=nu)
    found = judder.contact.solve(1e-12, indentation=depth, shape="cylinder", substrate=layer, accuracy=1e-2)
    exact = 2 / 3 * (1 - nu) ** 2 / (1 - 2 * nu) * (2 * depth) ** 1.5 / thickness
    assert found.force == pytest.approx(exact, rel=1e-3)


def test_a_layer_that_cannot_be_is_refused():
    for layer, given, words in (
        ({"thickness": 0.4}, {"indentation": 0.02}, "under a cylinder alone"),
        ({"thickness": -0.4}, {"indentation": 0.02, "shape": "cylinder"}, "thickness of the layer is -0.4"),
        ({"thickness": 0.4, "poisson_ratio": 0.6}, {"indentation": 0.02, "shape": "cylinder"}, "Poisson's ratio of the layer is 0.6"),
        ({"thickness": 0.01}, {"indentation": 0.02, "shape": "cylinder"}, "no less than the thickness"),
    ):
        with pytest.raises(judder.InputError, match=words):
            judder.contact.solve(0.1, substrate=judder.contact.Substrate(**layer), accuracy=0.1, **given)
    with pytest.raises(judder.ContactError, match="give the substrate's thickness"):
        judder.contact.solve(0.1, indentation=0.02, shape="cylinder")
