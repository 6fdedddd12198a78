"""Study folders open with the real xarray: no flags, no warnings, the values that were written.

JUDDER_SAMPLE_STUDY names a folder that the example `sample_study` of judder-store has written; without it, the
example is built and run here.
"""

import csv
import json
import os
import pathlib
import subprocess
import warnings

import numpy as np
import pytest
import xarray as xr
import zarr

ROOT = pathlib.Path(__file__).resolve().parents[2]
POINTS = 1000


@pytest.fixture(scope="session")
def study(tmp_path_factory):
    given = os.environ.get("JUDDER_SAMPLE_STUDY")
    if given:
        return pathlib.Path(given)
    folder = tmp_path_factory.mktemp("sample") / "study"
    example = ["cargo", "run", "--quiet", "-p", "judder-store", "--example", "sample_study", "--", str(folder)]
    subprocess.run(example, cwd=ROOT, check=True)
    return folder


@pytest.fixture(autouse=True)
def warnings_are_errors():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        yield


@pytest.fixture(params=["consolidated by default", "not consolidated", "group as a store"])
def open_group(request, study):
    store = study / "results.zarr"
    return {
        "consolidated by default": lambda name: xr.open_zarr(store, group=name),
        "not consolidated": lambda name: xr.open_zarr(store, group=name, consolidated=False),
        "group as a store": lambda name: xr.open_zarr(store / name),
    }[request.param]


def test_a_map_has_its_dimensions_coordinates_and_attributes(open_group):
    dataset = open_group("map").load()
    assert dict(dataset.sizes) == {"shear_strength": POINTS, "velocity": POINTS}
    assert set(dataset.coords) == {"shear_strength", "velocity", "retardation_time"}
    assert set(dataset.data_vars) == {"verdict", "growth_rate"}
    assert dataset.growth_rate.dims == ("shear_strength", "velocity")
    assert dataset.attrs["title"] == "A sample map"
    assert "coordinates" not in dataset.attrs
    assert dataset.velocity.attrs == {"long_name": "speed v_d τ/R", "units": "1"}
    assert dataset.growth_rate.attrs == {"long_name": "Re(λ)/ω_nx", "units": "1"}
    assert dataset.retardation_time.item() == 0.01


def test_a_map_has_its_values(open_group):
    dataset = open_group("map").load()
    index = np.arange(POINTS**2)
    expected = np.where(index % 7 == 0, np.nan, np.sin(index)).reshape(POINTS, POINTS)
    np.testing.assert_allclose(dataset.growth_rate.values, expected, rtol=1e-15, atol=1e-15)
    np.testing.assert_allclose(dataset.velocity.values, np.logspace(-8, 2, POINTS), rtol=1e-12)
    row, column = np.divmod(index, POINTS)
    assert dataset.verdict.dtype == np.uint8
    np.testing.assert_array_equal(dataset.verdict.values.ravel(), (row + column) // 500)
    assert float(dataset.growth_rate.sel(velocity=1e-3, shear_strength=0.1, method="nearest")) is not None


def test_a_class_map_explains_its_codes(open_group):
    attributes = open_group("map").verdict.attrs
    assert list(attributes["flag_values"]) == [0, 1, 2, 255]
    assert attributes["flag_meanings"].split() == ["stable", "flutter", "negative_damping", "unresolved"]


def test_complex_values_labels_and_whole_numbers(open_group):
    dataset = open_group("spectrum").load()
    assert dataset.eigenvalues.dtype == np.complex128
    assert dataset.eigenvalues.dims == ("velocity", "mode")
    index = np.arange(12).reshape(3, 4)
    np.testing.assert_array_equal(dataset.eigenvalues.values.real, -0.1 * index)
    np.testing.assert_array_equal(dataset.eigenvalues.values.imag, index)
    assert dataset.eigenvalues.real.max() == 0
    assert dataset.entry.values.tolist() == ["c11", "ξ of the rubber", ""]
    assert dataset.iterations.values.tolist() == [3, -1, 2**63 - 1]
    assert "regime" in dataset.coords
    assert dataset.regime.values.tolist() == ["slow", "", "fast"]
    assert dataset.velocity.attrs["units"] == "30 mm/s"


def test_an_empty_answer_is_an_answer(open_group):
    dataset = open_group("thresholds").load()
    assert dataset.critical_load.shape == (2, 0)
    assert dataset.critical_load.dims == ("velocity", "root")


def test_a_sweep_is_one_array_with_its_gaps(open_group):
    dataset = open_group("robustness").load()
    values = dataset["values"]
    assert values.dims == ("operation.velocity", "contact.shear_strength", "quantity")
    assert values.shape == (23, 10, 2)
    assert dataset["operation.velocity"].attrs["units"] == "mm/s"
    assert dataset.attrs["method"] == "grid"
    along = {"quantity", "quantity_units", "quantity_long_name", "quantity_flag_values", "quantity_flag_meanings"}
    assert set(dataset.coords) == {"operation.velocity"} | along
    growth = values.sel(quantity="growth_rate")
    assert growth.quantity_units.item() == "1/s"
    velocity, shear_strength = np.indices((23, 10))
    expected = velocity * 10.0 + shear_strength
    expected[10:15, 4:8] = np.nan  # the chunk that is missing
    expected[0, 0] = np.nan  # the point that failed
    np.testing.assert_array_equal(growth.values, expected)
    verdict = values.sel(quantity="verdict")
    assert verdict.quantity_flag_values.item() == "0 1"
    assert verdict.quantity_flag_meanings.item() == "stable flutter"
    # 5 × 2 points at the end of the second dimension, 3 × 4 at that of the first
    np.testing.assert_array_equal(verdict.values[5:10, 8:], np.arange(10).reshape(5, 2) % 2)
    np.testing.assert_array_equal(verdict.values[20:, :4], np.arange(12).reshape(3, 4) % 2)


def test_a_chunk_of_a_sweep_is_one_checked_file(study):
    folder = study / "results.zarr" / "robustness" / "values"
    files = sorted(path.name for path in folder.iterdir())
    chunks = [f"c.{i}.{j}.0" for i in range(5) for j in range(3) if (i, j) != (2, 1)]
    assert files == sorted([*chunks, "zarr.json"])
    array = zarr.open_array(folder, mode="r")
    assert (array.shards, array.chunks) == ((5, 4, 2), (5, 4, 1))
    assert array.nchunks_initialized == 2 * len(chunks)
    content = (folder / "c.0.0.0").read_bytes()
    assert content.endswith(b"judderC1")
    length = int.from_bytes(content[-16:-8], "little")
    record = json.loads(content[-48 - length : -48])
    assert record["failures"] == [{"index": 0, "reason": "no equilibrium"}]


def test_a_truncated_chunk_of_a_sweep_is_noticed(study, tmp_path):
    source = study / "results.zarr" / "robustness" / "values"
    (tmp_path / "zarr.json").write_bytes((source / "zarr.json").read_bytes())
    whole = (source / "c.0.1.0").read_bytes()
    last = int.from_bytes(whole[16:24], "little") + int.from_bytes(whole[24:32], "little")
    expected = zarr.open_array(source, mode="r")[:5, 4:8]
    # the record lies behind what Zarr reads
    (tmp_path / "c.0.1.0").write_bytes(whole[:last])
    np.testing.assert_array_equal(zarr.open_array(tmp_path, mode="r")[:5, 4:8], expected)
    # an empty file is a gap to zarr-python; to judder it is a damaged chunk
    for length in range(1, last):
        (tmp_path / "c.0.1.0").write_bytes(whole[:length])
        with pytest.raises(ValueError, match="checksum"):
            zarr.open_array(tmp_path, mode="r")[:5, 4:8]
    damaged = bytearray(whole)
    damaged[last - 5] ^= 1
    (tmp_path / "c.0.1.0").write_bytes(damaged)
    with pytest.raises(ValueError, match="checksum"):
        zarr.open_array(tmp_path, mode="r")[:5, 4:8]


@pytest.mark.parametrize("consolidated", [None, True, False])
def test_the_whole_store_opens_as_a_tree(study, consolidated):
    with xr.open_datatree(study / "results.zarr", engine="zarr", consolidated=consolidated) as tree:
        assert set(tree.children) == {"map", "spectrum", "thresholds", "robustness"}
        assert tree["map"]["growth_rate"].shape == (POINTS, POINTS)
        assert tree["spectrum"].load()["eigenvalues"].values[2, 3] == complex(-0.1 * 11, 11)


def test_chunks_are_compressed_and_checked(study):
    array = zarr.open_array(study / "results.zarr" / "map" / "growth_rate", mode="r")
    assert [codec.to_dict()["name"] for codec in array.metadata.codecs] == ["bytes", "zstd", "crc32c"]
    assert array.chunks == (POINTS, POINTS)


def test_a_damaged_chunk_is_noticed(study, tmp_path):
    source = study / "results.zarr" / "map" / "velocity"
    copy = tmp_path / "velocity"
    for file in (path for path in source.rglob("*") if path.is_file()):
        content = bytearray(file.read_bytes())
        if file.name != "zarr.json":
            content[len(content) // 2] ^= 1
        target = copy / file.relative_to(source)
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(content)
    with pytest.raises(ValueError, match="checksum"):
        zarr.open_array(copy, mode="r")[:]


def test_the_summary_is_plain_json(study):
    summary = json.loads((study / "summary.json").read_text(), parse_constant=pytest.fail)
    assert len(summary["case_hash"]) == 64
    assert summary["wall_time_s"] == 0.75
    assert summary["results"]["map"] == {"unstable_fraction": 0.4, "largest_load": None}
    assert summary["analyses"]["map"]["status"] == "done"


def test_a_table_reads_back_exactly(study):
    with open(study / "thresholds.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.reader(file))
    assert rows[0] == ["load [N]"]
    assert [row[0] for row in rows[1:]] == ["0.1", "1e-7", ""]
