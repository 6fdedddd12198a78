"""Whole cases: the same bytes as the command, results that label themselves."""

import json
import warnings

import numpy as np
import pytest

import judder
from common import files


def test_a_run_leaves_the_bytes_of_the_command(map_case, command, tmp_path):
    case = tmp_path / "case.toml"
    case.write_text(map_case)
    done = command("run", case, "-o", tmp_path / "command", "-q")
    assert done.returncode == 0, done.stderr
    seen = []
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", judder.JudderWarning)
        study = judder.run(case, output=tmp_path / "python", threads=2, progress=lambda *told: seen.append(told))
    assert files(tmp_path / "command" / "results.zarr") == files(study.folder / "results.zarr")
    own, theirs = study.summary, json.loads((tmp_path / "command" / "summary.json").read_text())
    assert (own["case"], own["case_hash"], own["analyses"].keys()) == (theirs["case"], theirs["case_hash"], theirs["analyses"].keys())
    assert {name for name, _, _ in seen} == {"map", "spectrum"} and seen[-1][1] == seen[-1][2]


def test_texts_paths_and_tables_are_one_case(map_case, tmp_path):
    case = tmp_path / "case.toml"
    case.write_text(map_case)
    tables = {
        "model": "oscillator",
        "operation": {"velocity": np.float64(2e-4), "normal_load": "0.1 N"},
        "analysis": [{"name": 'a"b', "kind": "spectrum", "sweep": {"key": "contact.shear_strength", "from": 0, "to": 0.1, "points": 3}}],
    }
    assert judder.check(map_case) == judder.check(case) == judder.check(str(case))
    resolved = judder.check({**tables, "analysis": []})["case"]
    changed = {"operation.velocity": 2e-4, "operation.normal_load": "0.1 N"}
    assert resolved == judder.check({"model": "oscillator"}, set=changed)["case"]
    with pytest.raises(judder.CaseError):
        judder.check(tables)  # the name of an analysis
    with pytest.raises(judder.InputError):
        judder.check({"model": object()})


def test_a_study_is_a_mapping_of_labelled_datasets(map_case, tmp_path):
    study = judder.run(map_case, output=tmp_path / "study")
    assert list(study) == ["map", "spectrum"] and study.complete and not study.failures
    growth = study["map"].growth_rate
    assert growth.dims == ("shear_strength", "velocity") and growth.attrs["units"] == "1"
    assert growth.attrs["long_name"] and growth.velocity.attrs["long_name"]
    assert study.results["map"]["points"] == 480 and study.report.is_file()
    assert {"map", "spectrum"} <= set(study.figures) and study.warnings["map"]
    page = study._repr_html_()
    assert "<svg" in page and "unstable_fraction" in page
    again = judder.load_study(tmp_path / "study")
    assert list(again) == list(study)
    assert study._ipython_key_completions_() == list(study) and "none" not in study and study.get("none") is None
    with pytest.raises(KeyError, match="^the study has no result `none`; there are `map`, `spectrum`$") as caught:
        study["none"]
    assert isinstance(caught.value, judder.UnknownResultError) and caught.value.known == ["map", "spectrum"]
    assert judder.run(map_case, output=tmp_path / "study").summary["analyses"] == study.summary["analyses"]


def test_a_plot_labels_itself(map_case, tmp_path, monkeypatch):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    study = judder.run(map_case, output=tmp_path / "study")
    for growth in (study["map"].growth_rate, judder.oscillator.stability_map(("velocity", [1e-3, 2e-3], "m/s"), ("coupling", [0.5, 1.0])).to_dataset().growth_rate):
        mesh = growth.plot()
        assert "speed" in mesh.axes.get_xlabel().lower() or "velocity" in mesh.axes.get_xlabel().lower()
        assert "growth rate" in mesh.colorbar.ax.get_ylabel()
        mesh.figure.clear()


def test_what_is_missing_is_told(tmp_path):
    sweep = {"key": "operation.velocity", "from": 1e-6, "to": 1, "points": 5, "scale": "log"}
    case = {
        "model": "oscillator",
        "oscillator": {"coupling_angle": "-45 deg"},
        "contact": {"shear_strength": 50.0},
        "analysis": [{"name": "lost", "kind": "spectrum", "sweep": sweep}],
    }
    with pytest.warns(judder.JudderWarning, match="lost"):
        study = judder.run(case, output=tmp_path / "study")
    assert not study.complete


def test_a_refused_analysis_is_an_exception_and_the_others_run(tmp_path):
    analysis = {"kind": "contact", "velocity": 0.1, "indentation": 1e-2, "cells": 64}
    case = {
        "model": "contact",
        "substrate": {"rubbery_modulus": "1 MPa", "glassy_modulus": "10 MPa", "retardation_time": "10 ms"},
        "indenter": {"radius": "10 mm"},
        "analysis": [{"name": "small", "domain": "10 um", **analysis}, {"name": "right", **analysis}],
    }
    with pytest.raises(judder.CaseError) as caught:
        judder.run(case, output=tmp_path / "study")
    assert caught.value.cause == "Contact" and "small" in caught.value.__notes__[-1]
    study = judder.load_study(tmp_path / "study")
    assert list(study) == ["right"] and list(study.failures) == ["small"]


def test_the_command_is_that_of_the_wheel(command):
    assert command("--version").stdout.split()[:2] == ["judder", judder.__build__]
    assert judder.__build__.partition("+")[0] == judder.__version__
    assert command("rnu").returncode == 2 and "did you mean `run`" in command("rnu").stderr
    done = command("point", "none.toml", "--json")
    assert done.returncode == 2 and "none.toml" in json.loads(done.stdout)["error"]["message"]


NO_SUMMARY = ["[]", "null", "3", "{}", '{"case": 3}', '{"case": {}, "analyses": [], "results": {}}', '{"case": {}, "analyses": {"a": 3}, "results": {}}']
NO_SUMMARY += ['{"case": {"analysis": [3]}, "analyses": {}, "results": {}}', '{"case": {"sweep": {}}, "analyses": {}, "results": {}}']


@pytest.mark.parametrize("text", NO_SUMMARY)
def test_a_summary_of_something_else_is_no_study(text, tmp_path):
    (tmp_path / "summary.json").write_text(text)
    with pytest.raises(judder.StudyError, match=r"summary\.json is none of judder's") as caught:
        judder.load_study(tmp_path)
    assert caught.value.cause == "NoStudy"


@pytest.mark.parametrize("kind", ["analysis", "sweep"])
def test_a_result_whose_arrays_are_gone_is_named(kind, tmp_path):
    case = {kind: [{"name": "a"}]}
    (tmp_path / "summary.json").write_text(json.dumps({"case": case, "analyses": {"a": {"status": "done"}}, "results": {"a": {}}}))
    with pytest.raises(judder.StoreError, match="`a` cannot be read") as caught:
        judder.load_study(tmp_path)["a"]
    assert caught.value.cause == "Unreadable"
