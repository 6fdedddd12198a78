"""Sweeps of whole studies from outside: the same bytes however they are computed."""

import json
import subprocess

import numpy as np
import pytest
import xarray as xr

from sweep_cases import GRID, SAMPLES, assert_same, case, chunks, run, tree


def test_every_design(run, case, tmp_path):
    case(SAMPLES)
    said = run("run", "case.toml", "-o", "study")
    results = json.loads((tmp_path / "study" / "summary.json").read_text("utf-8"))["results"]
    points = {name: results[name]["points"] for name in ("list", "hypercube", "sequence", "sensitivity", "amplitude")}
    assert points == {"list": 3, "hypercube": 20, "sequence": 32, "sensitivity": 64 * 5, "amplitude": 2}
    assert all(results[name]["failed"] == 0 for name in points)

    tree = xr.open_datatree(tmp_path / "study" / "results.zarr", engine="zarr")
    listed = tree["list"]["values"].sel(quantity="contact.shear_strength")
    assert listed.values.tolist() == [0.1, 0.2, 0.3]
    assert tree["list"].attrs["method"] == "list"

    # a twentieth of the range holds one point each
    drawn = tree["hypercube"]["values"].sel(quantity="operation.velocity").values
    parts = np.floor((np.log10(drawn) + 5) / 4 * 20).astype(int)
    assert sorted(parts) == list(range(20))

    # A and B of a row differ in every key, AB_k from A in the k-th
    rows = tree["sensitivity"]["values"].values.reshape(64, 5, 5)[:, :, :3]
    for k in range(3):
        changed = rows[:, 1 + k] != rows[:, 0]
        assert changed[:, k].all() and changed.sum() == 64
    indices = results["sensitivity"]["sensitivity"]["growth_rate"]
    assert indices["rows"] == 64 and indices["confidence"] == 0.9
    for order in ("first", "total"):
        for index in indices[order].values():
            assert index["from"] <= index["value"] <= index["to"]
    assert "first order" in said.stderr and "oscillator.damping_x" in said.stderr

    # Saltelli et al. 2010, Table 2 (b) and (f), from the stored values
    growth = tree["sensitivity"]["values"].sel(quantity="growth_rate").values.reshape(64, 5)
    a, b = growth[:, 0], growth[:, -1]
    mean, variance = np.mean([a, b]), np.var([a, b])
    for k, key in enumerate(indices["first"]):
        changed = growth[:, 1 + k]
        first, total = np.mean((b - mean) * (changed - a)) / variance, np.mean((a - changed) ** 2) / 2 / variance
        assert indices["first"][key]["value"] == pytest.approx(first, abs=0.02)
        assert indices["total"][key]["value"] == pytest.approx(total, rel=0.02)

    for figure in ("list", "hypercube", "sequence", "sensitivity", "sensitivity-sensitivity", "amplitude"):
        assert (tmp_path / "study" / "figures" / f"{figure}.png").stat().st_size > 5000, figure
    page = (tmp_path / "study" / "report.html").read_text("utf-8")
    assert "Sensitivity of growth_rate" in page and "Quantities over all points" in page


def test_a_point_of_a_sweep_is_that_of_the_case(run, case, tmp_path):
    case(GRID.replace("points = 40", "points = 3").replace("points = 30", "points = 2"))
    run("run", "case.toml", "-o", "study")
    swept = xr.open_zarr(tmp_path / "study" / "results.zarr", group="map")["values"]
    assert swept.dims == ("operation.velocity", "contact.shear_strength", "quantity")
    for velocity in swept["operation.velocity"].values:
        for strength in swept["contact.shear_strength"].values:
            keys = [f"operation.velocity={float(velocity)!r}", f"contact.shear_strength={float(strength)!r}"]
            said = run("point", "case.toml", "--json", *(word for key in keys for word in ("--set", key)))
            growth = swept.sel({"operation.velocity": velocity, "contact.shear_strength": strength, "quantity": "growth_rate"})
            assert float(growth) == json.loads(said.stdout)["growth_rate"]
    # an analysis of the same point
    case(SAMPLES)
    run("run", "case.toml", "-o", "other", "--only", "amplitude")
    run("run", "case.toml", "-o", "one", "--only", "cycle", "--set", "operation.velocity=3e-4")
    swept = xr.open_zarr(tmp_path / "other" / "results.zarr", group="amplitude")["values"]
    alone = json.loads((tmp_path / "one" / "summary.json").read_text("utf-8"))["results"]["cycle"]["rms"]
    assert float(swept.sel(quantity="cycle.rms")[1]) == alone


def test_the_same_bytes_by_whom_they_come(run, case, judder, tmp_path):
    case(GRID)
    run("run", "case.toml", "-o", "whole", "--threads", 1)
    run("run", "case.toml", "-o", "threads", "--threads", 2)
    assert_same(tmp_path / "whole", tmp_path / "threads")

    for part in ("3/3", "1/3", "2/3"):
        said = run("run", "case.toml", "-o", "parts", "--shard", part)
        assert f"part {part} is done" in said.stderr
        if part == "1/3":
            said = run("merge", "case.toml", "-o", "parts", code=1)
            assert "chunks are missing" in said.stderr
    run("merge", "case.toml", "-o", "parts")
    assert_same(tmp_path / "whole", tmp_path / "parts")

    command = [judder, "run", "case.toml", "-o", "race", "--threads", "1"]
    racing = [subprocess.Popen(command, cwd=tmp_path, stderr=subprocess.PIPE, text=True) for _ in range(3)]
    said = [process.communicate(timeout=120)[1] for process in racing]
    assert [process.returncode for process in racing] == [0, 0, 0], said
    assert any("report: " in own for own in said)
    assert_same(tmp_path / "whole", tmp_path / "race")


def test_a_point_that_fails_says_why_and_stops_nothing(run, case, tmp_path):
    # between 0.6 and 0.8 an entry of the stiffness is the root of a negative number
    case("""
model = "two-degrees"

[parameters]
mu = 0.5

[matrices]
stiffness = [[2, "1 - 4*mu/3"], [1, "2 + sqrt((mu - 0.7)^2 - 0.01)"]]

[[sweep]]
name = "hole"
method = "latin-hypercube"
points = 40
over = [{ key = "parameters.mu", from = 0, to = 1 }]
quantities = ["growth_rate", "verdict"]
chunk = 8
""")
    said = run("run", "case.toml", "-o", "study", code=1)
    results = json.loads((tmp_path / "study" / "summary.json").read_text("utf-8"))["results"]["hole"]
    swept = xr.open_zarr(tmp_path / "study" / "results.zarr", group="hole")["values"].load()
    assert swept["quantity"].values.tolist() == ["parameters.mu", "growth_rate", "verdict"]
    parameter, growth, verdict = swept.values.T
    wrong = abs(parameter - 0.7) < 0.1
    assert wrong.sum() == pytest.approx(8, abs=1)
    assert np.isnan(growth[wrong]).all() and np.isnan(verdict[wrong]).all()
    assert np.isfinite(growth[~wrong]).all() and set(verdict[~wrong]) <= {0.0, 1.0, 2.0}
    assert results["failed"] == wrong.sum() == len(results["failures"])
    assert all(abs(failure["at"]["parameters.mu"] - 0.7) < 0.1 for failure in results["failures"])
    assert all("stiffness[1][1] is NaN" in failure["reason"] for failure in results["failures"])
    assert f"{wrong.sum()} of 40 points failed" in said.stderr
    page = (tmp_path / "study" / "report.html").read_text("utf-8")
    assert "Points without an answer" in page
    # what failed is an answer too: it is not computed again, and stays a missing result
    said = run("run", "case.toml", "-o", "study", code=1)
    assert "done before: hole" in said.stderr
