"""Operating points over arrays: each is that of `point`, to the bit, at any number of threads."""

import json

import numpy as np
import pytest
import xarray

import judder

SAME = {
    "growth_rate": "growth_rate",
    "equivalent_damping": "equivalent_damping",
    "equilibrium_x": "x",
    "equilibrium_y": "y",
    "indentation": "indentation",
    "contact_force": "force",
    "contact_area": "area",
    "viscoelastic_friction": "viscoelastic_friction",
}


def bits(dataset):
    return {name: own.values.tobytes() for name, own in dataset.variables.items()}


@pytest.mark.filterwarnings("ignore::judder.JudderWarning")
def test_points_are_those_one_by_one():
    velocity, strength = np.logspace(-6, -2, 7), np.array([[0.01], [0.05], [0.2]])
    found = judder.oscillator.points(velocity=velocity, shear_strength=strength, damping_x=0.02)
    assert found.growth_rate.dims == ("shear_strength", "velocity") and found.velocity.attrs["key"] == "operation.velocity"
    for row, own in enumerate(strength.ravel()):
        for column, speed in enumerate(velocity):
            point = judder.oscillator.point(velocity=speed, shear_strength=own, damping_x=0.02)
            here = found.isel(shear_strength=row, velocity=column)
            assert all(here[name].item() == getattr(point, attribute) for name, attribute in SAME.items())
            assert (here.eigenvalues.values == point.eigenvalues).all()
            assert here.verdict.attrs["flag_meanings"].split()[int(here.verdict)] == point.verdict
            assert here.mechanism.attrs["flag_meanings"].split()[int(here.mechanism)] == point.mechanism
    case = json.loads(found.attrs["judder_case"])
    assert case["oscillator"]["damping_x"] == 0.02 and case["contact"]["law"] == "oscillator-paper"


@pytest.mark.filterwarnings("ignore::judder.JudderWarning")
def test_the_bits_are_the_same_at_any_number_of_threads():
    keys = {"velocity": np.logspace(-6, 0, 3000), "normal_load": np.logspace(-8, -4, 3000)}
    first = judder.oscillator.points(**keys, threads=1)
    assert first.growth_rate.dims == ("point",) and first.velocity.dims == first.normal_load.dims == ("point",)
    assert bits(first) == bits(judder.oscillator.points(**keys, threads=3)) == bits(judder.oscillator.points(**keys))
    told = []
    judder.oscillator.points(**keys, progress=lambda *own: told.append(own))
    assert told[-1] == ("operating points", 3, 3)


def test_units_stand_beside_values_or_in_their_attributes():
    millimetres = np.array([0.1, 1.0, 10.0])
    speeds = xarray.DataArray(millimetres, dims="run", coords={"day": ("run", ["a", "b", "c"])}, attrs={"units": "mm/s"})
    ways = ({"velocity": (millimetres, "mm/s")}, {"velocity [mm/s]": millimetres}, {"velocity": speeds}, {"operation.velocity": (list(millimetres), "mm/s")})
    found = [judder.oscillator.points(**own, radius=(12, "mm")) for own in ways]
    for own in found:
        assert own.velocity.attrs["units"] == "m/s" and np.allclose(own.velocity, millimetres / 1e3)
        assert (own.growth_rate.values == found[0].growth_rate.values).all()
    assert found[2].growth_rate.dims == ("run",) and list(found[2].day.values) == ["a", "b", "c"]
    for index, own in enumerate(millimetres):
        assert found[0].growth_rate[index] == judder.oscillator.point(velocity=f"{own} mm/s", radius="12 mm").growth_rate
    grid = judder.oscillator.points(velocity=speeds, normal_load=xarray.DataArray([1e-6, 1e-5], dims="load"))
    assert grid.growth_rate.sizes == {"run": 3, "load": 2} and grid.normal_load.dims == ("load",)


def test_thresholds_are_sought_where_they_are_asked_for():
    found = judder.oscillator.points(velocity=[1e-4, 1e-3], quantities=["critical_shear_strength", "growth_rate"])
    one = judder.oscillator.points(velocity=[1e-4, 1e-3], quantities="growth_rate")
    assert [*one.data_vars] == ["growth_rate", "eigenvalues"] and (one.growth_rate == found.growth_rate).all()
    for several in (np.array(["growth_rate"]), {"growth_rate": 1}.keys()):
        assert [*judder.oscillator.points(velocity=[1e-4], quantities=several).data_vars] == ["growth_rate", "eigenvalues"]
    for wrong in (5, b"growth_rate", [1]):
        with pytest.raises(judder.InputError, match="`quantities` is .*, and a name or a list of names"):
            judder.oscillator.points(velocity=[1e-4], quantities=wrong)
    assert [*found.data_vars] == ["critical_shear_strength", "growth_rate", "eigenvalues"]
    for index, speed in enumerate((1e-4, 1e-3)):
        assert float(found.critical_shear_strength[index]) == judder.oscillator.point(velocity=speed).critical_shear_strength[0]


def test_a_point_alone_has_no_dimensions_and_shapes_are_kept():
    alone = judder.oscillator.points(velocity=1e-3)
    assert alone.growth_rate.shape == () and alone.growth_rate.item() == judder.oscillator.point(velocity=1e-3).growth_rate
    assert judder.oscillator.points(velocity=[1e-3]).growth_rate.dims == ("velocity",)
    cube = judder.oscillator.points(velocity=np.full((2, 3, 4), 1e-3), damping_x=np.linspace(0.01, 0.02, 4))
    assert cube.growth_rate.shape == (2, 3, 4) and cube.growth_rate.dims == ("point_0", "point_1", "point_2")


def test_what_has_to_be_known_is_told():
    with pytest.warns(judder.JudderWarning, match=r"1 of 2 points have no answer; the first, \(1\):"):
        lost = judder.oscillator.points(shear_strength=[0.01, 50.0], coupling_angle="-45 deg", velocity=1e-5)
    assert np.isnan(lost.growth_rate[1]) and not np.isnan(lost.growth_rate[0]) and "have no answer" in lost.attrs["judder_warnings"]


@pytest.mark.parametrize(
    ("keys", "error", "words"),
    [
        ({"speed": [1.0]}, judder.InputError, "no key of an oscillator"),
        ({"velocity": [1.0, -1.0]}, judder.InputError, "value 1 of operation.velocity is -1"),
        ({"velocity": [1.0, float("nan")]}, judder.InputError, "must be finite"),
        ({"velocity": []}, judder.InputError, "empty"),
        ({"velocity": ["1 mm/s"]}, judder.InputError, "real numbers"),
        ({"velocity": ([1.0], "N")}, judder.InputError, "no unit of operation.velocity"),
        ({"velocity": ("1 mm/s", "mm/s")}, judder.InputError, "its own unit"),
        ({"radius": [1.0]}, judder.CaseError, "unit"),
        ({"velocity": [1.0, 2.0], "normal_load": [1.0, 2.0, 3.0]}, judder.InputError, r"cannot be broadcast: the shapes are `velocity` \(2,\)"),
        ({"velocity": [1.0], "operation.velocity": [1.0]}, judder.InputError, "given twice"),
        ({"velocity": xarray.DataArray([1.0], dims="x"), "normal_load": [1.0]}, judder.InputError, "make both DataArrays"),
        ({"retardation_time": ([1.0], "s"), "relaxation_time": ([1.0], "s")}, judder.InputError, "not both"),
        ({"glassy_modulus": ([0.1], "MPa")}, judder.InputError, "glassy"),
        ({"glassy_modulus": ([20.0], "MPa"), "law": "bem"}, judder.InputError, "one law a point"),
        ({"velocity": [1.0], "quantities": ["loudness"]}, judder.InputError, "there is no `loudness`; known are growth_rate"),
    ],
)
def test_wrong_arrays_are_refused_by_name(keys, error, words):
    with pytest.raises(error, match=words):
        judder.oscillator.points(**keys)


def test_a_point_says_where_arrays_go():
    with pytest.raises(judder.ArgumentError, match=r"arrays go to judder\.oscillator\.points") as caught:
        judder.oscillator.point(velocity=np.array([1.0, 2.0]))
    assert isinstance(caught.value, TypeError)


def test_a_law_is_evaluated_on_all_threads_to_the_same_bits():
    def own(velocity, indentation):
        return 4 / 3 * indentation**1.5 * (1 + velocity), np.pi * indentation, 0.3 * velocity / (1 + velocity**2)

    for law in (judder.contact.Law("oscillator-paper"), judder.contact.Law.from_function(own, velocity=(1e-4, 10.0), indentation=(1e-6, 1e-1))):
        velocity, indentation = np.logspace(-4, 1, 301), np.logspace(-6, -1, 97)[:, None]
        found = [law.evaluate(velocity, indentation, threads=threads) for threads in (1, 2, 5, None)]
        parts = [law.evaluate(velocity, own) for own in indentation]
        for name in ("force", "area_by_velocity", "friction_by_indentation"):
            bytes_of = {getattr(own, name).tobytes() for own in found}
            assert bytes_of == {np.concatenate([getattr(own, name)[None] for own in parts]).tobytes()}
    with pytest.raises(judder.InputError, match="threads"):
        law.evaluate(velocity, indentation, threads=0)
