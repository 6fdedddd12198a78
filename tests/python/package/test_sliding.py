"""Pairs from arrays and from cases: closed forms, and the analyses of a case."""

import warnings

import numpy as np
import pytest

import judder
from common import ROOT
from judder.sliding import Observed, Pair, Slider, Track, load_pair, locus, march

MASS, TRACK_MASS, STIFFNESS, LOAD = 0.02, 0.05, 4e4, 3.0
SHORT = {
    "structure.0.beam.elements": [15, 2],
    "structure.1.beam.elements": [20, 2],
    "structure.0.reduction.count": 6,
    "structure.1.reduction.count": 6,
}


def block(**changes):
    """A block that is free to rise, on a bar that yields as one: m and M on a spring k where they touch."""
    row, nodes = 1 / np.sqrt(TRACK_MASS), np.array([[0.0, 0.0], [0.05, 0.0], [0.1, 0.0]])
    rows = np.zeros((3, 2, 1))
    rows[:, 1, 0] = row
    slider = {
        "eigenvalues": [0.0],
        "contact": [0.0, 0.0],
        "contact_rows": [[0.0], [1 / np.sqrt(MASS)]],
        "load": [-1 / np.sqrt(MASS)],
        "inertia": [0.0],
    }
    track = {"eigenvalues": [STIFFNESS / TRACK_MASS], "nodes": nodes, "node_rows": rows, "alpha": 400.0}
    slider.update({name: value for name, value in changes.items() if name in slider})
    track.update({name: value for name, value in changes.items() if name in track and name != "eigenvalues"})
    return Pair(Slider(**slider), Track(**track), friction=changes.get("friction", 0.3), observed=[Observed("track", [row])])


def test_a_block_on_a_spring_swings_as_its_closed_form():
    pair = block()
    assert pair.modes == 2 and pair.observed == 1 and pair.node_positions.tolist() == [0.0, 0.05, 0.1]
    found = locus(pair, [0.01, 0.03, 0.09], count=1, velocity=0.1, load=LOAD, damped=False)
    expected = np.sqrt(STIFFNESS / (MASS + TRACK_MASS))
    np.testing.assert_allclose(found.eigenvalues[:, 0].imag, expected, rtol=1e-9)
    np.testing.assert_allclose(found.normal_force, LOAD, rtol=1e-12)
    assert found.zones == ()
    assert found.to_dataset().frequency.attrs["units"] == "Hz"


def test_a_march_settles_at_the_load():
    told = []
    ended = march(
        block(), velocity=0.5, load=LOAD, start=0.01, end=0.09, load_ramp=0.02, velocity_ramp=0.01, every=10,
        progress=lambda *step: told.append(step),
    )
    late = ended.time > 0.12
    np.testing.assert_allclose(ended.normal_force[late], LOAD, rtol=1e-3)
    np.testing.assert_allclose(ended.tangential_force[late], -0.3 * LOAD, rtol=1e-3)
    assert not ended.ran_off and set(ended.state) <= {1, 2} and told[-1][1] == told[-1][2]
    np.testing.assert_allclose(np.diff(ended.time), 10 * ended.step, rtol=1e-6)
    assert ended.accelerations.shape == (ended.time.size, 1)
    assert ended.to_dataset().state.attrs["flag_meanings"] == "stick slip slip_ahead lift-off"
    assert ended.to_dataset().normal_force.attrs == {"long_name": "normal force", "units": "N"}


def test_a_predictor_decides_a_march_that_has_one():
    pair = load_pair(ROOT / "crates" / "judder-models" / "tests" / "small" / "sliding.toml")
    usual, named, printed = (march(pair, end=0.0905, method="film", predictor=word).normal_force for word in (None, "with-force", "printed"))
    np.testing.assert_array_equal(usual, named)
    assert not np.array_equal(usual, printed)


def test_a_pair_of_a_case_has_the_locus_of_its_analysis(tmp_path):
    case = ROOT / "cases" / "sliding" / "falling-friction.toml"
    positions = {"points": 5}
    analysis = {"name": "locus", "kind": "locus", "configuration": "deformed", "count": 4, "positions": positions}
    changes = {**SHORT, "analysis": [analysis]}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", judder.JudderWarning)
        study = judder.run(case, output=tmp_path / "study", set=changes)["locus"]
    pair = load_pair(case, set=SHORT)
    found = locus(pair, np.linspace(0.045, 0.055, 5), count=4, configuration="deformed")
    np.testing.assert_array_equal(found.eigenvalues, study.eigenvalue.values)
    np.testing.assert_array_equal([zone.start for zone in found.zones], study.zone_from.values)


@pytest.mark.parametrize(
    "changes",
    [
        {"eigenvalues": []},
        {"eigenvalues": [np.nan]},
        {"contact": [0.0]},
        {"contact_rows": [[0.0, 1.0]]},
        {"load": [1.0, 2.0]},
        {"nodes": [[0.0, 0.0]]},
        {"nodes": [[0.0, 0.0], [0.1, 0.0], [0.05, 0.0]]},
        {"node_rows": np.zeros((2, 2, 1))},
        {"friction": -0.1},
        {"friction": ([0.0], [0.1, 0.2])},
        {"eigenvalues": [-1.0]},
    ],
)
def test_pairs_that_cannot_be(changes):
    with pytest.raises((judder.InputError, judder.SlidingError)):
        block(**changes)


def test_marches_and_loci_that_cannot_be():
    pair = block()
    motion = {"velocity": 0.5, "load": LOAD}
    for change in (
        {"step": 1.0},
        {"step": -1.0},
        {"end": 0.2},
        {"velocity": 0.0},
        {"velocity": np.nan},
        {"load": np.inf},
        {"method": "magic"},
        {"predictor": "magic"},
        {"method": "subs", "predictor": "printed"},
        {"cut_off": 10.0},
        {"method": "residual-flexibility"},
        {"every": 0},
        {"load_ramp": -1.0},
    ):
        with pytest.raises((judder.InputError, judder.SlidingError)):
            march(pair, **{**motion, **change})
    with pytest.raises(judder.SlidingError) as caught:
        march(pair, step=1.0, **motion)
    assert caught.value.cause == "StepOverLimit" and caught.value.limit < 1.0
    with pytest.raises(judder.InputError, match="velocity"):
        march(pair, load=LOAD)
    for change in ({"count": 0}, {"count": 99}, {"load": np.nan}, {"velocity": None}, {"configuration": "bent"}):
        with pytest.raises((judder.InputError, judder.SlidingError)):
            locus(pair, [0.01, 0.02], **{**motion, "count": 1, **change})
    for positions in ([], [0.02, 0.01], [1.0], [np.nan]):
        with pytest.raises((judder.InputError, judder.SlidingError)):
            locus(pair, positions, count=1, **motion)
    with pytest.raises(judder.JudderError, match="model `oscillator`"):
        load_pair({"model": "oscillator"})
