"""Datasets as they are handed out: names, units, what they depend on; and objects that travel, show themselves and fail as Python would."""

import copy
import json
import pickle

import numpy as np
import pytest
import xarray

import judder
from common import ROOT
from judder import _shown

CASE = {
    "title": "Both",
    "model": "oscillator",
    "oscillator": {"damping_x": 0.02},
    "analysis": [
        {
            "name": "map",
            "kind": "stability-map",
            "method": "every-point",
            "x": {"key": "operation.velocity", "from": "1 um/s", "to": "1 m/s", "points": 9, "scale": "log"},
            "y": {"key": "contact.shear_strength", "from": 0.01, "to": 0.2, "points": 7},
        },
        {"name": "line", "kind": "spectrum", "sweep": {"key": "operation.velocity", "from": 1e-6, "to": 1.0, "points": 5, "scale": "log"}},
    ],
    "sweep": [
        {
            "name": "grid",
            "over": [
                {"key": "operation.velocity", "from": 1e-5, "to": 1e-2, "points": 4, "scale": "log"},
                {"key": "contact.shear_strength", "from": 0.01, "to": 0.2, "points": 3},
            ],
            "quantities": ["growth_rate", "verdict"],
            "chunk": 4,
        }
    ],
}


@pytest.fixture(scope="module")
def studies(tmp_path_factory):
    """A study in memory, where that is possible, and the same one in a folder."""
    without = {key: own for key, own in CASE.items() if key != "sweep"}
    return judder.run(without), judder.run(CASE, output=tmp_path_factory.mktemp("conventions") / "study")


def test_a_key_has_one_name_in_maps_and_sweeps(studies):
    _, stored = studies
    for name in stored:
        data = stored[name]
        assert data.velocity.dims == ("velocity",) and all(str(own).isidentifier() for own in data.variables)
    assert stored["grid"].velocity.attrs["key"] == "operation.velocity"
    assert stored["grid"].growth_rate.dims == ("velocity", "shear_strength")
    found = judder.oscillator.stability_map(("velocity", [1.0, 2.0], "mm/s"), ("shear_strength", [0.1, 0.2]))
    assert found.to_dataset().velocity.attrs["key"] == found.x.key == "operation.velocity"


def test_an_axis_tells_its_unit_once(studies):
    label = pytest.importorskip("xarray.plot.utils").label_from_attrs
    for study in studies:
        for name in study:
            for own in study[name].variables.values():
                words = own.attrs.get("long_name", "")
                assert not words.endswith((f"({own.attrs.get('units')})", "(−)")), words
    assert label(studies[0]["map"].velocity) == "Substrate velocity vd [m/s]"


def test_every_dataset_has_its_case_and_its_warnings(studies):
    for study in studies:
        for name in study:
            case = json.loads(study[name].attrs["judder_case"])
            assert case["oscillator"]["damping_x"] == 0.02 and case["contact"]["law"] == "oscillator-paper"
            assert [own["name"] for kind in ("analysis", "sweep") for own in case.get(kind, [])] == [name]
            assert study[name].attrs["judder_warnings"] == "\n".join(study.warnings[name])
    found = judder.oscillator.stability_map(("velocity", [1e-4, 1e-3]), ("shear_strength", [0.1, 0.2]), law="hertz")
    assert json.loads(found.to_dataset().attrs["judder_case"])["contact"]["law"] == "hertz"
    contact = judder.contact.solve(0.1, indentation=1e-2, accuracy=5e-2).to_dataset()
    assert contact.attrs["asked_velocity"] == 0.1 and contact.attrs["asked_shape"] == "paraboloid"


OPERATIONS = {
    "as it is": lambda data: data,
    "a part": lambda data: data.isel({next(iter(data.sizes)): slice(0, 3)}),
    "a point": lambda data: data.isel({next(iter(data.sizes)): 1}),
    "a mean": lambda data: data.mean(next(iter(data.sizes)), keep_attrs=True),
    "joined": lambda data: xarray.concat([data, data], "run"),
    "a sum": lambda data: data + data,
    "turned": lambda data: data.transpose(..., next(iter(data.sizes))),
}


@pytest.mark.filterwarnings("ignore::UserWarning")
@pytest.mark.parametrize("what", OPERATIONS)
def test_datasets_are_written_after_any_operation(studies, what, tmp_path):
    point = judder.oscillator.points(velocity=np.logspace(-5, -3, 5), damping_x=0.02)
    kept = {f"{place} {name}": study[name] for place, study in zip(("held", "stored"), studies) for name in study}
    for name, data in {**kept, "points": point}.items():
        done = OPERATIONS[what](data)
        done.to_zarr(tmp_path / name)
        done.to_netcdf(tmp_path / f"{name}.nc", engine="h5netcdf")
        for again in (xarray.open_zarr(tmp_path / name), xarray.open_dataset(tmp_path / f"{name}.nc", engine="h5netcdf")):
            xarray.testing.assert_equal(again.load(), done.load())
            assert again.attrs.get("judder_case") == done.attrs.get("judder_case")


PAIR = ROOT / "cases" / "beams-paper" / "paper.toml"


def given_pair():
    nodes = np.array([[0.0, 0.0], [0.05, 0.0], [0.1, 0.0]])
    rows = np.zeros((3, 2, 1))
    rows[:, 1, 0] = 5.0
    slider = judder.sliding.Slider(eigenvalues=[0.0], contact=nodes[0], contact_rows=[[0.0], [7.0]], load=[-7.0], inertia=[0.0])
    track = judder.sliding.Track(eigenvalues=[8e5], nodes=nodes, node_rows=rows, alpha=400.0)
    return judder.sliding.Pair(slider, track, friction=([0.0, 1.0], [0.3, 0.2]), side="left")


@pytest.mark.parametrize("make", [given_pair, lambda: judder.sliding.load_pair(PAIR)], ids=["given", "case"])
def test_pairs_travel(make):
    pair = make()
    assert copy.copy(pair) is pair and copy.deepcopy(pair) is pair
    again = pickle.loads(pickle.dumps(pair))
    assert (again.eigenvalues == pair.eigenvalues).all() and again.observed == pair.observed and again.warnings == pair.warnings
    keys = {"start": 0.05, "end": 0.0505, "velocity": 0.3, "load": 3.0} if again.package is None else {"start": 0.09, "end": 0.0901}
    assert (judder.sliding.march(again, **keys).normal_force == judder.sliding.march(pair, **keys).normal_force).all()


def test_a_pair_of_objects_travels_when_they_are_gone():
    block = {"element": "quad4", "size": ["75 mm", "2 mm"], "cells": [15, 1]}
    law = {"velocity [m/s]": np.array([0.0, 1.0]), "coefficient": np.array([0.3, 0.2])}
    pair = judder.sliding.load_pair(PAIR, set={"contact.friction_coefficient": law})
    assert (pickle.loads(pickle.dumps(pair)).eigenvalues == pair.eigenvalues).all() and block


def test_objects_show_themselves_briefly(studies):
    law = judder.contact.Law("hertz")
    shown = [judder.oscillator.point(), law, given_pair(), judder.sliding.Track([0.0], [[0.0, 0.0]], [[[0.0], [1.0]]]), judder.oscillator.stability_map(("velocity", [1e-4]), ("shear_strength", [0.1, 0.2]))]
    for own in shown:
        html = own._repr_html_()
        assert html.startswith("<h4>") and len(html) < 2000 and "object at 0x" not in html
    page = judder.sweep.plan({key: own for key, own in CASE.items() if key != "analysis"})._repr_html_()
    assert "grid" in page and "12" in page and len(page) < 2000


def test_what_the_system_refuses_is_an_error_of_judder(tmp_path):
    with pytest.raises(judder.MissingFileError) as caught:
        judder.contact.Law.load(tmp_path / "none.json")
    error = caught.value
    assert isinstance(error, judder.StoreError) and isinstance(error, FileNotFoundError) and error.errno == 2
    assert str(error).startswith(str(tmp_path)) and str(pickle.loads(pickle.dumps(error))) == str(error)
    with pytest.raises(judder.FileError):
        judder.contact.Law.from_function(lambda v, y: (y, y, 0 * v), velocity=(0.1, 1.0), indentation=(0.1, 1.0)).save(tmp_path / "no" / "law.json")


def test_a_run_in_memory_holds_no_more_than_it_may():
    case = {key: own for key, own in CASE.items() if key != "sweep"}
    with pytest.raises(judder.StudyError, match=r"analysis `line`: with it the results take .* a folder as `output` holds any number") as caught:
        judder.run(case, memory=100, only=["line"])
    assert caught.value.limit == 100 < caught.value.bytes and caught.value.cause == "HeldTooMuch"
    assert judder.run(case, memory=1 << 20).complete


def test_a_process_takes_no_more_memory_than_was_said():
    case = {"model": "oscillator", "analysis": [{"kind": "motion", "points": 1_000_000}]}
    try:
        for amount in ("100 MB", 100_000_000):
            judder.limit_memory(amount)
            for call in (judder.check, judder.run):
                with pytest.raises(judder.CaseError, match=r"points: 396.0 MB of memory are needed, and 100.0 MB are to be had, as was said"):
                    call(case)
        judder.limit_memory("1 GB")
        assert judder.check(case)["estimate"][0]["bytes"] == 396_000_000
    finally:
        judder.limit_memory(None)
    for wrong in ("lots", "1 kB", 100, 0, -1, True, 1.5):
        with pytest.raises(judder.InputError, match="amount: .* is no amount of 1 MiB or more"):
            judder.limit_memory(wrong)


def test_runs_are_logged(caplog, tmp_path):
    case = {key: own for key, own in CASE.items() if key != "sweep"}
    with caplog.at_level("INFO", logger="judder"):
        judder.run(case, only=["line"])
        judder.run(case, output=tmp_path / "study", only=["line"])
    told = [record.getMessage() for record in caplog.records if record.name == "judder"]
    assert any("`line` took" in own for own in told) and any(str(tmp_path / "study") in own for own in told), told


BELT = {
    "model": "belt",
    "oscillator": {"mass": "1 kg", "stiffness": "100 N/m", "damping": "1 N s/m"},
    "friction": {"at_rest": 1.0, "at_speed": 0.5, "decay_speed": "5 mm/s"},
    "operation": {"velocity": "15 mm/s", "normal_force": "0.1 N"},
    "analysis": [{"name": "cycle", "kind": "limit-cycle", "start": {"x": "1 mm", "velocity_x": "15 mm/s"}}],
}


def test_what_is_in_si_stands_beside_the_groups(tmp_path):
    """A unit of time is √(m/k) = 0.1 s, one of displacement 1 m."""
    label = pytest.importorskip("xarray.plot.utils").label_from_attrs
    for study in judder.run(BELT), judder.run(BELT, output=tmp_path / "study"):
        data, numbers = study["cycle"], study.results["cycle"]
        assert np.array_equal(data.x_si, data.x.values) and np.allclose(data.time_si, 0.1 * data.time.values, rtol=1e-15)
        assert np.allclose(data.velocity_x_si, 10 * data.velocity_x.values, rtol=1e-15) and "time_si" in data.coords
        assert data.time_si[-1] - data.time_si[0] == pytest.approx(numbers["period_s"], rel=1e-12)
        assert "contact_state_si" not in data and "floquet_multipliers_si" not in data
        assert pickle.loads(pickle.dumps(data)).velocity_x_si.identical(data.velocity_x_si)
        whole = study.in_si("cycle")
        axes = [" ".join(label(own).split()) for own in (whole.x, whole.time, whole.relative_velocity)]
        assert axes == ["displacement x along sliding [m]", "time t [s]", "velocity less that of the track [m/s]"]
        assert set(whole.variables) == {name for name in data.variables if not name.endswith("_si")}
        assert whole.x.sel(time=slice(0.1, 0.2)).size == ((data.time_si >= 0.1) & (data.time_si <= 0.2)).sum()
        whole.to_zarr(tmp_path / f"{id(study)}.zarr", zarr_format=3, consolidated=False)
    study.to_csv(tmp_path / "tables")
    assert "x_si [m]" in (tmp_path / "tables" / "cycle.csv").read_text(encoding="utf-8").splitlines()[0]
    opened = xarray.open_dataset(tmp_path / "study" / "results.zarr", group="cycle", engine="zarr", consolidated=False)
    assert opened.velocity_x.attrs["si_unit"] == "m/s" and opened.velocity_x.attrs["si_factor"] == 10.0


def test_a_case_in_groups_has_no_si(studies):
    case = {"model": "belt", "analysis": [{"name": "motion", "kind": "motion", "duration": 50, "points": 64}]}
    study = judder.run(case)
    data = study["motion"]
    assert not [name for name in data.variables if str(name).endswith("_si")] and study.in_si("motion").identical(data)
    assert studies[0].in_si("line").eigenvalues.attrs["units"] == "1"


@pytest.mark.parametrize(("count", "words"), [(0, "none unstable of the modes found"), (2, "2 unstable of the modes found")])
def test_modes_that_were_not_sought_are_not_called_stable(count, words):
    assert _shown.verdict({"unstable": count}) == words
