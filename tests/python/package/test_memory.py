"""Runs without a folder: nothing is written, and what is left is what a run into a folder leaves."""

import copy
import gc
import json
import os
import pickle
import signal
import subprocess
import sys
import time
import tomllib

import numpy as np
import pytest

import judder
from common import ROOT, files

SMALL = ROOT / "crates" / "judder-models" / "tests" / "small"
SWEEP = {"key": "operation.velocity", "from": 1e-6, "to": 1e-2, "points": 5, "scale": "log"}
CASE = {"model": "oscillator", "title": "Five points", "analysis": [{"name": "at", "kind": "spectrum", "sweep": SWEEP}]}
SWEPT = {"model": "oscillator", "sweep": [{"name": "grid", "over": [SWEEP], "quantities": ["growth_rate"], "chunk": 2}]}
LAW = judder.contact.Law.from_function(lambda v, y: (4 / 3 * y**1.5, np.pi * y, 0 * v), velocity=(1e-6, 1e2), indentation=(1e-6, 1e-1))


@pytest.fixture
def watched(tmp_path, monkeypatch):
    """A folder to work in and one for temporary files, both empty."""
    for place in ("here", "temporary"):
        (tmp_path / place).mkdir()
    monkeypatch.chdir(tmp_path / "here")
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path / "temporary"))
    monkeypatch.setenv("TMPDIR", str(tmp_path / "temporary"))
    return tmp_path


def quick(path):
    """What is changed of a small case: nothing that needs a folder, and no search for motions beside the branch of a threshold, which takes a minute."""
    analyses = [own for own in tomllib.loads(path.read_text("utf-8")).get("analysis", []) if own["kind"] != "spectrogram"]
    return {"analysis": [{**own, "global_margin": False} if own["kind"].startswith("critical-") else own for own in analyses], "sweep": []}


def without_times(value):
    """Numbers without those that are times."""
    return {key: without_times(own) for key, own in value.items() if key != "seconds"} if isinstance(value, dict) else value


def told(study):
    """What a study tells, but for times and for the way to its case file."""
    summary = {key: own for key, own in study.summary.items() if key not in ("wall_time_s", "results", "study", "analyses")}
    records = {name: {**own, "wall_time_s": 0} for name, own in study.summary["analyses"].items()}
    return summary, records, without_times(study.results), {**study.summary["study"], "file": None}


@pytest.mark.filterwarnings("ignore::judder.JudderWarning")
@pytest.mark.parametrize("path", sorted(SMALL.glob("*.toml")), ids=lambda path: path.stem)
def test_a_study_in_memory_is_that_of_a_folder(path, tmp_path):
    import xarray

    held = judder.run(path, set=quick(path))
    assert held._compiled is not None
    stored = judder.run(path, set=quick(path), output=tmp_path / "study")
    assert told(held) == told(stored) and list(held) == list(stored) and held.files == stored.files
    for name in stored:
        found, expected = held[name], stored[name].load()
        xarray.testing.assert_identical(found, expected)
        assert [*found.variables] == [*expected.variables] and [*found.attrs] == [*expected.attrs]
        assert {key: own.dtype for key, own in found.variables.items()} == {key: own.dtype for key, own in expected.variables.items()}


def test_nothing_is_written_and_nothing_is_known_from_before(watched):
    study = judder.run(CASE)
    found = judder.models.Oscillator().spectrum(sweep=SWEEP)
    assert not [*watched.rglob("*.*")]
    assert study["at"].eigenvalues.identical(found.data.eigenvalues) and study.complete
    # a dataset is made anew: what is done to one changes no other
    study["at"].eigenvalues.values[:] = 0
    assert study["at"].eigenvalues.values.all()
    with pytest.raises(KeyError, match="no result `none`; there are `at`"):
        study["none"]
    assert repr(study).startswith("Study(in memory: at (growth_rate > 0 at ")
    page = study._repr_html_()
    assert "<svg" in page and "Five points" in page


@pytest.mark.parametrize("case", [CASE, SWEPT], ids=["memory", "temporary"])
def test_a_study_without_a_folder_says_how_to_get_one(case):
    study = judder.run(case)
    for way in (lambda: study.folder, lambda: study.report, lambda: study.figures, lambda: study.tables):
        with pytest.raises(judder.StudyError, match=r"`study\.save\(folder\)` writes one") as caught:
            way()
        assert caught.value.cause == "NoFolder"


@pytest.mark.parametrize("law", [None, LAW], ids=["own", "law"])
@pytest.mark.filterwarnings("ignore::judder.JudderWarning")
def test_a_saved_study_is_that_of_a_run(law, watched):
    stored = judder.run(CASE, output="run", law=law)
    saved = judder.run(CASE, law=law).save("saved")
    skipped = ("summary.json", "manifest.json", "report.html")
    first, second = ({name: own for name, own in files(watched / "here" / place).items() if name not in skipped} for place in ("run", "saved"))
    assert first == second and ("law.json" in first) == (law is not None)
    assert told(saved) == told(stored) and saved.report.is_file() and saved.figures.keys() == stored.figures.keys()
    again = judder.run(CASE, output="saved", law=law)
    assert again.summary["analyses"] == saved.summary["analyses"]
    (watched / "here" / "file").write_text("no folder")
    with pytest.raises(judder.StoreError, match="file"):
        judder.run(CASE).save("file")


@pytest.mark.filterwarnings("ignore::judder.JudderWarning")
def test_objects_of_a_case_are_saved_with_it(watched):
    matrices = {name: np.diag(own) for name, own in (("mass", [1.0, 2.0]), ("stiffness", [4.0, 5.0]))}
    study = judder.run({"model": "structure", "matrices": matrices, "analysis": [{"name": "modes", "kind": "modes", "count": 2}]})
    saved = study.save("saved")
    assert [*(watched / "here" / "saved" / "inputs").iterdir()] and saved["modes"].identical(study["modes"])


@pytest.mark.filterwarnings("ignore::judder.JudderWarning")
def test_a_temporary_folder_goes_with_the_study_and_its_data(watched):
    study = judder.run(SWEPT)
    grid, expected = study["grid"], judder.run(SWEPT, output="stored")["grid"]
    assert study.sweeps == ("grid",) and not study.failed_points("grid").size and [*study.files] == ["grid.csv"]
    saved = study.save("saved")
    assert saved.report.is_file() and saved["grid"].equals(expected)
    with pytest.raises(judder.StoreError, match="is there already"):
        study.save("saved")
    del study
    gc.collect()
    assert grid.equals(expected)
    del grid
    gc.collect()
    assert not [*(watched / "temporary").iterdir()]


@pytest.mark.filterwarnings("ignore::judder.JudderWarning")
@pytest.mark.parametrize("case", [CASE, SWEPT], ids=["memory", "temporary"])
def test_studies_without_a_folder_travel(case, watched):
    study = judder.run(case)
    for other in (pickle.loads(pickle.dumps(study)), copy.copy(study), copy.deepcopy(study)):
        assert other.summary == study.summary and other.files == study.files and repr(other) == repr(study)
        assert all(other[name].equals(study[name]) for name in study)
        other.to_csv("tables")
        own = files(watched / "here" / "tables")
        study.to_csv("tables")
        assert own == files(watched / "here" / "tables")
    assert pickle.loads(pickle.dumps(study.save("saved"))).folder == judder.load_study("saved").folder


@pytest.mark.filterwarnings("ignore::judder.JudderWarning")
def test_what_is_missing_or_refused_is_told():
    lost = {**CASE, "oscillator": {"coupling_angle": "-45 deg"}, "contact": {"shear_strength": 50.0}}
    with pytest.warns(judder.JudderWarning, match="at"):
        assert not judder.run(lost).complete
    analysis = {"kind": "contact", "velocity": 0.1, "indentation": 1e-2, "cells": 64}
    case = {
        "model": "contact",
        "substrate": {"rubbery_modulus": "1 MPa", "glassy_modulus": "10 MPa", "retardation_time": "10 ms"},
        "indenter": {"radius": "10 mm"},
        "analysis": [{"name": "small", "domain": "10 um", **analysis}, {"name": "right", **analysis}],
    }
    with pytest.raises(judder.CaseError) as caught:
        judder.run(case)
    assert caught.value.cause == "Contact" and caught.value.__notes__[-1].startswith("analysis `small`; with a folder as `output`")
    with pytest.raises(judder.StudyError, match="`nope`"):
        judder.run(CASE, only=["nope"])


SCRIPT = """
import judder
side = dict(key="operation.velocity", points=3000, scale="log")
side["from"], side["to"] = 1e-6, 1.0
case = {"model": "oscillator", "analysis": [dict(kind="stability-map", method="every-point", boundaries=False, x=side, y={**side, "key": "contact.shear_strength"})]}
try:
    judder.run(case, progress=lambda *told: print(*told, flush=True))
except judder.Interrupted as error:
    print("ended:", error, flush=True)
"""


@pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX")
def test_ctrl_c_ends_a_run_in_memory(watched):
    with subprocess.Popen([sys.executable, "-W", "ignore", "-c", SCRIPT], stdout=subprocess.PIPE, text=True) as run:
        for line in run.stdout:
            if int(line.split()[1]) > 2:
                break
        run.send_signal(signal.SIGINT)
        rest = run.stdout.read()
        assert run.wait(20) == 0
    assert "ended: interrupted; nothing is kept of a run in memory" in rest and not [*watched.rglob("*.*")]


TIMED = f"""
import json, sys, time
import judder
case = json.loads({json.dumps(json.dumps(CASE))})
times = []
for _ in range(100):
    began = time.perf_counter()
    judder.run(case)
    times.append(time.perf_counter() - began)
print(json.dumps([min(times), [name for name in ("xarray", "zarr", "pandas", "asyncio", "judder.models", "judder._interchange") if name in sys.modules]]))
"""


def test_a_run_in_memory_takes_milliseconds_and_imports_nothing_heavy():
    done = subprocess.run([sys.executable, "-c", TIMED], capture_output=True, text=True, env={**os.environ, "RAYON_NUM_THREADS": "2"})
    least, imported = json.loads(done.stdout.splitlines()[-1])
    assert least < 3e-3 and imported == [], done.stdout
    began = time.perf_counter()
    assert judder.run(CASE).complete and time.perf_counter() - began < 1.0
