"""Points and maps of the oscillator, against the command and against each other."""

import json
import pickle

import numpy as np
import pytest

import judder

OPERATION = ("velocity", "normal_load")


def options(keys):
    section = {"velocity": "operation", "normal_load": "operation", "shear_strength": "contact", "radius": "indenter"}
    return [f"--set={section.get(key, 'oscillator')}.{key}={value}" for key, value in keys.items()]


@pytest.mark.parametrize(
    "keys",
    [
        {},
        {"velocity": 3e-3, "shear_strength": 0.05, "damping_x": 0.02},
        {"velocity": "30 mm/s", "normal_load": "0.2 N", "radius": "12 mm"},
        {"frequency_ratio": 1.3, "coupling": 0.4, "coupling_angle": "-30 deg"},
    ],
)
def test_a_point_is_that_of_the_command_to_the_last_digit(keys, command, tmp_path):
    case = tmp_path / "case.toml"
    case.write_text('model = "oscillator"\n')
    told = json.loads(command("point", case, "--json", *options(keys)).stdout)
    point = judder.oscillator.point(**keys)
    assert json.loads(point.to_json()) == told
    assert [[value.real, value.imag] for value in point.eigenvalues] == told["eigenvalues"]
    assert point.damping.tolist() == told["damping"] and point.stiffness.tolist() == told["stiffness"]
    assert (point.growth_rate, point.verdict, point.mechanism) == tuple(told[key] for key in ("growth_rate", "verdict", "mechanism"))
    errors = ("equivalent_damping_error", "growth_rate_error", "marginal_within_law")
    assert [getattr(point, key) for key in errors] == [told[key] for key in errors] == [0.0, 0.0, False]
    assert (point.x, point.y, point.indentation) == tuple(told["equilibrium"][key] for key in ("x", "y", "indentation"))
    assert (point.force, point.area, point.viscoelastic_friction) == tuple(told["contact"].values())
    assert point.critical_load.tolist() == told["critical_load"]
    assert point.critical_shear_strength.tolist() == told["critical_shear_strength"]
    assert point.warnings == told["warnings"]


def test_points_compare_and_pickle():
    law = judder.contact.Law("oscillator-paper-corrected")
    for keys in ({}, {"relaxation_time": "2 ms", "radius": "3 mm"}, {"law": law, "friction_load": "contact-force"}):
        point = judder.oscillator.point(**keys)
        again = pickle.loads(pickle.dumps(point))
        assert again == point and again.to_json() == point.to_json()
    assert judder.oscillator.point() != judder.oscillator.point(velocity=2e-4)
    with pytest.raises(AttributeError):
        point.growth_rate = 0.0


def test_a_map_is_its_points():
    velocities, strengths = np.logspace(-6, -1, 13), np.linspace(0.0, 0.2, 7)
    found = judder.oscillator.stability_map(("operation.velocity", velocities), ("shear_strength", strengths), coupling=0.7)
    assert found.classes.shape == (7, 13) and found.classes.dtype == np.uint8
    for row, strength in enumerate(strengths):
        for column, velocity in enumerate(velocities):
            point = judder.oscillator.point(velocity=velocity, shear_strength=strength, coupling=0.7)
            assert found.growth_rate[row, column] == point.growth_rate
            assert found.verdict[row, column] == point.verdict and found.mechanism[row, column] == point.mechanism
    np.testing.assert_array_equal(found.unstable, found.growth_rate > 0)
    assert found.unstable_fraction == np.mean(found.growth_rate > 0) and found.unresolved == 0
    adaptive = judder.oscillator.stability_map(
        ("velocity", velocities), ("shear_strength", strengths), coupling=0.7, method="adaptive"
    )
    np.testing.assert_array_equal(adaptive.classes, found.classes)
    assert adaptive.growth_rate is None
    without = judder.oscillator.stability_map(
        ("velocity", velocities), ("shear_strength", strengths), coupling=0.7, normal_load=None
    )
    np.testing.assert_array_equal(without.classes, found.classes)


def test_a_map_is_that_of_a_study(map_case, tmp_path):
    study = judder.run(map_case, output=tmp_path / "study", only=["map"])["map"]
    own = judder.oscillator.stability_map(("velocity", study.velocity), ("shear_strength", study.shear_strength)).to_dataset()
    for name in ("stability", "growth_rate"):
        np.testing.assert_array_equal(own[name], study[name])
        assert own[name].dims == study[name].dims and own[name].attrs["long_name"] == study[name].attrs["long_name"]
    assert own.stability.attrs["flag_meanings"].split()[1] == study.stability.attrs["flag_meanings"].split()[1]


def test_a_tall_map_in_stretches_is_the_map_in_one():
    columns = np.logspace(-6, 0, 4096)
    strengths = np.linspace(0.0, 0.2, 2048)
    both = [
        judder.oscillator.stability_map(("velocity", columns), ("shear_strength", strengths[part]), growth_rate=False).classes
        for part in (slice(None), slice(0, 1024))
    ]
    np.testing.assert_array_equal(both[0][:1024], both[1])


@pytest.mark.parametrize("threads", [1, 3])
def test_threads_change_nothing(threads):
    sides = ("velocity", np.logspace(-6, 0, 300)), ("normal_load", np.logspace(-8, -4, 60))
    assert judder.oscillator.stability_map(*sides, threads=threads).classes.tobytes() == judder.oscillator.stability_map(*sides).classes.tobytes()


def test_units_of_a_side():
    sides = ("velocity", [10, 20], "mm/s"), ("radius", [5.0, 10.0], "mm")
    found = judder.oscillator.stability_map(*sides)
    assert found.x.values.tolist() == [0.01, 0.02] and (found.x.units, found.y.units) == ("m/s", "m")
    assert found.growth_rate[1, 0] == judder.oscillator.point(velocity="10 mm/s", radius="10 mm").growth_rate


@pytest.mark.parametrize(
    "values",
    [
        np.logspace(-6, 0, 40)[::2],
        np.logspace(-6, 0, 20).astype(np.float32),
        np.logspace(-6, 0, 20).tolist(),
        np.asfortranarray(np.logspace(-6, 0, 60).reshape(20, 3))[:, 1],
        np.arange(1, 21),
    ],
    ids=["strided", "float32", "list", "column", "integers"],
)
def test_arrays_of_any_kind(values):
    readonly = np.array(values)
    readonly.flags.writeable = False
    plain = np.array(values, dtype=np.float64)
    y = ("shear_strength", [0.01, 0.1])
    expected = judder.oscillator.stability_map(("velocity", plain), y).growth_rate
    for given in (values, readonly):
        np.testing.assert_array_equal(judder.oscillator.stability_map(("velocity", given), y).growth_rate, expected)


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ([], "empty"),
        ([1e-3, np.nan], "value 1 is NaN"),
        ([1e-3, np.inf], "value 1 is inf"),
        ([1e-3, -1.0], "value 1"),
        ([[1e-3]], "one dimension"),
        (np.array(1e-3), "one dimension"),
        ([1 + 2j], "complex"),
        (["fast"], "real numbers"),
        ([True], "bool"),
        (object(), "object"),
        ([[1.0], [1.0, 2.0]], "not an array"),
    ],
)
def test_arrays_that_are_none(values, words):
    with pytest.raises(judder.InputError, match=words) as caught:
        judder.oscillator.stability_map(("velocity", values), ("shear_strength", [0.01]))
    assert caught.value.argument == "x"


def test_sides_that_are_none():
    good = ("shear_strength", [0.01])
    for side in (("speed", [1.0]), ("velocity", [1.0], "N"), ("velocity", [1.0], "furlong"), ("shear_strength", [0.1]), ("damping_x", [0.1], "1")):
        with pytest.raises(judder.InputError):
            judder.oscillator.stability_map(side, good)
    with pytest.raises(judder.CaseError, match="unit"):
        judder.oscillator.stability_map(("radius", [0.01]), good)
    with pytest.raises(judder.InputError, match="glassy"):
        judder.oscillator.stability_map(("glassy_modulus", [1e5, 1e7], "Pa"), good)
    for side, what in (
        (None, "is None"),
        ("velocity", "is a str"),
        (("velocity",), "has 1 items"),
        ((1.0, [1.0]), "has 1.0 as its key"),
        (("", [1.0]), "has '' as its key"),
        (("velocity", [1.0], 5), "has 5 as its unit"),
        (("velocity", [1.0], "mm/s", 1), "has 4 items"),
    ):
        with pytest.raises(judder.InputError, match=f"`y` {what}, and a key, its values"):
            judder.oscillator.stability_map(good, side)
    # a key that is None is not given, as of a point
    without, of_none = (judder.oscillator.stability_map(("velocity", [1.0]), good, **keys) for keys in ({}, {"damping_x": None}))
    assert (without.growth_rate == of_none.growth_rate).all()
    for threads in (0, 10**6):
        with pytest.raises(judder.InputError, match="threads"):
            judder.oscillator.stability_map(("velocity", [1.0]), good, threads=threads)


def test_maps_and_points_of_a_law_with_errors_say_what_it_does_not_decide():
    law, rng = judder.contact.Law("oscillator-paper"), np.random.default_rng(1)
    speeds, depths = np.logspace(-9, 3, 61), np.logspace(-9, -1, 33)
    exact = law.evaluate(speeds[None, :], depths[:, None])
    off = [values * (1 + 0.02 * rng.uniform(-1, 1, values.shape)) for values in (exact.force, exact.area, exact.friction)]
    loose = judder.contact.Law.from_table(speeds, depths, *off)
    sides = ("velocity", np.logspace(-7, -1, 60)), ("shear_strength", np.logspace(-4, 0, 50))
    found = judder.oscillator.stability_map(*sides, law=loose, growth_rate=False)
    assert found.within_law.shape == found.classes.shape and set(np.unique(found.within_law)) == {0, 1}
    data = found.to_dataset()["within_law"]
    assert data.attrs["flag_meanings"].split()[1] == "marginal_within_the_law"
    for row, column in ((0, 0), (20, 10), (49, 59), *np.argwhere(found.within_law == 1)[:3]):
        keys = {"velocity": sides[0][1][column], "shear_strength": sides[1][1][row]}
        point = judder.oscillator.point(**keys, law=loose)
        assert point.marginal_within_law == bool(found.within_law[row, column])
        assert point.equivalent_damping_error > 0 and ("marginal within the law" in repr(point)) == point.marginal_within_law
    exact = judder.oscillator.stability_map(*sides, law=law, growth_rate=False)
    assert exact.within_law is None and "within_law" not in exact.to_dataset()
