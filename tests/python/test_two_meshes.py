"""The tutorial "From two meshes to a squeal": its script makes the meshes of its case. Where gmsh is there, which it need not be."""

import json
import pathlib
import shutil
import subprocess
import sys

import pytest

FOLDER = pathlib.Path(__file__).resolve().parents[2] / "docs" / "src" / "tutorials" / "two-meshes"


@pytest.fixture
def made(tmp_path):
    """A folder with the case and the meshes of the script."""
    pytest.importorskip("gmsh")
    subprocess.run([sys.executable, FOLDER / "two-meshes.py", tmp_path], check=True)
    shutil.copy(FOLDER / "two-meshes.toml", tmp_path)
    return tmp_path


def test_the_meshes_are_those_of_the_case(judder, made):
    command = [judder, "check", made / "two-meshes.toml", "--json"]
    told = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    assert told["contacts"] == [{"name": "lining", "points": 60}]
    assert [round(body["size_m"], 5) for body in told["bodies"]] == [0.24, 0.09636]
    assert not any("another unit" in warning for warning in told["warnings"])


def test_a_forgotten_unit_is_told(judder, made):
    case = (made / "two-meshes.toml").read_text("utf-8").replace('unit = "mm"\n', "")
    (made / "metres.toml").write_text(case, "utf-8")
    command = [judder, "check", made / "metres.toml", "--json"]
    told = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    assert any("`disc` is 240 m long" in warning for warning in told["warnings"])


def test_the_pad_carries_its_load(judder, made):
    command = [judder, "run", made / "two-meshes.toml", "--only", "steady", "--output", made / "out"]
    subprocess.run(command, check=True, capture_output=True)
    steady = json.loads((made / "out" / "summary.json").read_text("utf-8"))["results"]["steady"]
    lining = steady["contacts"]["lining"]
    assert (round(lining["normal_force"]), lining["closed"], lining["points"]) == (3145, 58, 60)
