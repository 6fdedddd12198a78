"""Studies that were damaged after they were written: told, and never taken for results."""

import json
import pathlib
import shutil

import pytest

import judder

CASE = """
model = "oscillator"
[[analysis]]
name = "spectrum"
kind = "spectrum"
sweep = { key = "operation.velocity", from = 1e-4, to = 1e-2, points = 5, scale = "log" }
[[analysis]]
name = "damping"
kind = "equivalent-damping"
sweep = { key = "operation.velocity", from = 1e-4, to = 1e-2, points = 5, scale = "log" }
"""


@pytest.fixture(scope="module")
def origin(tmp_path_factory):
    folder = tmp_path_factory.mktemp("damaged") / "study"
    judder.run(CASE, output=folder)
    return folder


@pytest.fixture
def folder(origin, tmp_path):
    return pathlib.Path(shutil.copytree(origin, tmp_path / "study"))


def test_a_study_is_sound_until_it_is_touched(folder):
    found = judder.verify(folder)
    assert found["sound"] and found["complete"] and found["findings"] == []
    assert found["files"] == len([path for path in folder.rglob("*") if path.is_file() and path.name not in (".judder.lock", "manifest.json")])
    (folder / "damping.csv").unlink()
    (folder / "own.txt").write_text("mine")
    found = judder.verify(folder)
    told = {finding["path"]: (finding["kind"], finding["of"], finding["reason"]) for finding in found["findings"]}
    assert told == {"damping.csv": ("damaged", "damping", "of damping: it is missing"), "own.txt": ("extra", None, "it is not in the manifest")}
    assert not found["sound"]
    with pytest.warns(judder.JudderWarning, match="damping: is damaged and does not count"):
        judder.run(CASE, output=folder)
    assert judder.verify(folder)["sound"]


def test_an_edited_number_is_no_result(folder):
    place = folder / "summary.json"
    summary = json.loads(place.read_text())
    summary["results"]["spectrum"]["growth_rate"][0] += 1.0
    place.write_text(json.dumps(summary))
    with pytest.raises(judder.errors.StoreError, match="its content is not what was written") as caught:
        judder.load_study(folder)
    assert caught.value.cause == "Damaged"
    with pytest.raises(judder.errors.StoreError):
        judder.report(folder)


def test_arrays_of_another_are_not_read(folder):
    parts = sorted(path for path in (folder / "results.zarr" / "spectrum").rglob("*") if path.is_file() and path.name != "zarr.json")
    one = parts[0]
    other = next(path for path in parts if path.read_bytes() != one.read_bytes())
    # a whole part of another array, with a checksum of its own that fits
    one.write_bytes(other.read_bytes())
    study = judder.load_study(folder)
    assert study["damping"].load().sizes
    with pytest.raises(judder.errors.StoreError, match="its content is not what was written") as caught:
        study["spectrum"].load()
    assert caught.value.cause == "Damaged"


def test_without_a_manifest_nothing_says_what_a_study_was(folder):
    (folder / "manifest.json").unlink()
    with pytest.raises(judder.errors.StoreError, match="without `manifest.json`"):
        judder.verify(folder)
