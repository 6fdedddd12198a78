"""A sweep chunk by chunk, and what it leaves as a dataset."""

import threading
import time

import dask.array
import numpy as np
import pytest
import xarray
from serial_run import files

import judder


def test_a_plan_says_what_the_sweep_is(quick, maps):
    sweep = judder.sweep.plan(quick[0])
    assert (sweep.name, sweep.points, sweep.chunks, sweep.shape) == ("quick_map", 61 * 32, 61, (61, 32))
    assert sweep.keys == ("operation.velocity", "contact.shear_strength") and sweep.quantities == ("growth_rate", "verdict")
    assert repr(sweep) == "Sweep('quick_map': 1952 points in 61 chunks)"
    assert judder.sweep.plan(maps[0], "maps").shape == (89,)
    finer = judder.sweep.plan(quick[0], set={"sweep.quick_map.chunk": 64})
    assert finer.chunks == 31


def test_an_estimate_is_that_of_the_command(quick, tmp_path):
    estimate = judder.sweep.plan(quick[0]).estimate(tmp_path)
    assert (estimate["points"], estimate["chunks"], estimate["chunks_done"]) == (1952, 61, 0)
    assert estimate["stored_bytes"] == 1952 * 2 * 8 and 0 < estimate["seconds_per_point"] < 0.1
    assert judder.sweep.plan(quick[0]).estimate(quick[0].parent / "serial")["chunks_done"] == 61


def test_chunks_by_hand_give_the_bytes_of_the_serial_run(quick, tmp_path):
    sweep = judder.sweep.plan(quick[0])
    study = tmp_path / "study"
    missing = sweep.missing(study)
    assert missing.dtype == np.int64 and missing.tolist() == list(range(61)) and not study.exists()
    for chunk in reversed(missing[::2].tolist()):
        sweep.write(study, chunk, sweep.compute(chunk))
    assert sweep.missing(study).tolist() == list(range(1, 61, 2))
    with pytest.raises(judder.StudyError, match="30 of 61 chunks are missing") as early:
        sweep.merge(study)
    assert early.value.missing == 30
    sweep.run(study, shard="2/2")
    sweep.run(study, shard="1/2", threads=1)
    merged = sweep.merge(study)
    assert merged.complete and files(study / "results.zarr" / "quick_map") == quick[1]


def test_threads_of_one_process_share_a_folder(maps, tmp_path):
    failed = []

    def run():
        try:
            judder.sweep.plan(maps[0]).run(tmp_path)
        except BaseException as error:
            failed.append(error)

    together = [threading.Thread(target=run) for _ in range(4)]
    for own in together:
        own.start()
    for own in together:
        own.join()
    assert failed == []
    judder.sweep.plan(maps[0]).merge(tmp_path)
    assert files(tmp_path / "results.zarr" / "maps") == maps[1]


def test_a_damaged_chunk_is_missing_and_wrong_bytes_are_refused(quick, tmp_path):
    sweep = judder.sweep.plan(quick[0])
    sweep.run(tmp_path)
    place = tmp_path / "results.zarr" / "quick_map" / "values" / "c.9.0.0"
    whole = place.read_bytes()
    place.write_bytes(whole[:-1])
    assert sweep.missing(tmp_path).tolist() == [9]
    for content, cause in ((whole[:-1], "DamagedChunk"), (sweep.compute(8), "DamagedChunk"), (b"", "DamagedChunk")):
        with pytest.raises(judder.StoreError) as refused:
            sweep.write(tmp_path, 9, content)
        assert refused.value.cause == cause
    other = judder.sweep.plan(quick[0], set={"operation.normal_load": 2e-4})
    with pytest.raises(judder.StoreError) as refused:
        sweep.write(tmp_path, 9, other.compute(9))
    assert refused.value.cause == "ForeignChunk"
    sweep.write(tmp_path, 9, whole)
    assert sweep.missing(tmp_path).tolist() == []


def test_wrong_arguments(quick, maps, tmp_path):
    sweep = judder.sweep.plan(quick[0])
    with pytest.raises(judder.StoreError) as none:
        sweep.compute(61)
    assert none.value.cause == "NoSuchChunk" and none.value.count == 61
    with pytest.raises(judder.InputError, match="parts count from 1"):
        sweep.run(tmp_path, shard="3/2")
    with pytest.raises(judder.InputError, match="there is no sweep `map`; the case has `quick_map`"):
        judder.sweep.plan(quick[0], "map")
    with pytest.raises(judder.InputError, match="which of the sweeps"):
        judder.sweep.plan({"model": "oscillator"})
    with pytest.raises(OverflowError):
        sweep.compute(-1)


def test_a_sweep_is_a_dataset(quick, maps, tmp_path):
    study = judder.load_study(quick[0].parent / "serial")
    data = study["quick_map"]
    assert isinstance(data, xarray.Dataset) and set(data.data_vars) == {"growth_rate", "verdict"}
    assert dict(data.sizes) == {"velocity": 61, "shear_strength": 32}
    assert np.allclose(data["velocity"], np.logspace(-6, 0, 61))
    assert data.growth_rate.attrs["long_name"] and "units" in data.growth_rate.attrs
    codes, meanings = data.verdict.attrs["flag_values"], data.verdict.attrs["flag_meanings"].split()
    assert len(codes) == len(meanings) and "unstable" in meanings
    # the same numbers as the package gives directly
    point = judder.oscillator.point(velocity=float(data["velocity"][30]), normal_load=1e-4, shear_strength=float(data["shear_strength"][20]))
    assert float(data.growth_rate[30, 20]) == point.growth_rate
    assert meanings[codes.index(int(data.verdict[30, 20]))] == point.verdict
    assert len(study.failed_points("quick_map")) == 0

    values = judder.sweep.plan(quick[0]).values(30)
    assert values.shape == (32, 2) and np.array_equal(values[:, 0], data.growth_rate[30])

    samples = judder.load_study(maps[0].parent / "serial")["maps"]
    assert dict(samples.sizes) == {"sample": 89} and set(samples.coords) == {"damping_x", "damping_y"}
    assert set(samples.data_vars) == {"map_unstable_fraction", "growth_rate"}
    with pytest.raises(KeyError, match="no sweep `maps`"):
        study.failed_points("maps")


def test_values_are_read_when_they_are_used_and_dask_takes_whole_chunks(quick):
    data = judder.load_study(quick[0].parent / "serial")["quick_map"]
    assert isinstance(data.growth_rate.data, dask.array.Array)
    # small chunks are taken together
    assert data.growth_rate.data.npartitions == 1
    assert float(data.growth_rate.mean().compute()) == pytest.approx(float(data.growth_rate.values.mean()))


# between 0.6 and 0.8 an entry of the stiffness is the root of a negative number
FAILING = """
model = "two-degrees"
[parameters]
mu = 0.5
other = 2.0
[matrices]
stiffness = [["other", "1 - 4*mu/3"], [1, "2 + sqrt((mu - 0.7)^2 - 0.01)"]]
[[sweep]]
name = "hole"
method = "list"
over = [
  { key = "parameters.mu", values = [0.1, 0.2, 0.7, 0.9] },
  { key = "parameters.other", values = [2, 2, 3, 2] },
]
quantities = ["growth_rate"]
chunk = 3
"""


def test_a_sweep_goes_on_to_zarr_whatever_is_made_of_it(quick, tmp_path):
    data = judder.load_study(quick[0].parent / "serial")["quick_map"]
    part = {data.growth_rate.dims[0]: slice(3, 9)}
    for index, own in enumerate((data, data.load(), data.isel(part), data.mean(keep_attrs=True))):
        own.to_zarr(tmp_path / f"{index}.zarr", consolidated=False)
        assert xarray.open_zarr(tmp_path / f"{index}.zarr", consolidated=False).load().equals(own.load())


def test_failed_points_are_a_table(tmp_path):
    case = tmp_path / "case.toml"
    case.write_text(FAILING)
    with pytest.warns(judder.JudderWarning, match="1 of 4 points failed"):
        study = judder.run(case, output=tmp_path / "study")
    table = study.failed_points("hole")
    assert table["parameters.mu"].tolist() == [0.7] and table["parameters.other"].tolist() == [3.0]
    assert "stiffness[1][1] is NaN" in table["reason"][0] and not study.complete
    assert np.isnan(study["hole"].growth_rate).values.tolist() == [False, False, True, False]


def test_a_finished_sweep_of_many_chunks_opens_at_once(tmp_path):
    case = {
        "model": "oscillator",
        "sweep": [
            {
                "name": "map",
                "over": [
                    {"key": "operation.velocity", "from": 1e-6, "to": 1, "points": 400, "scale": "log"},
                    {"key": "contact.shear_strength", "from": 1e-3, "to": 0.2, "points": 250},
                ],
                "quantities": ["growth_rate"],
                "chunk": 250,
            }
        ],
    }
    folder = tmp_path / "study"
    judder.run(case, output=folder)
    judder.load_study(folder)["map"]
    began = time.perf_counter()
    judder.load_study(folder)["map"]
    # what opening takes must not grow with the 400 chunks; generous for a busy machine
    assert time.perf_counter() - began < 1.0
