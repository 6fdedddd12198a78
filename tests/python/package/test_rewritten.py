"""Runs of a program do not overwrite each other, and a study whose folder was rewritten shows no other run's numbers."""

import json
import pickle
import shutil

import numpy as np
import pytest

import judder

SPEEDS = (1e-5, 1e-4, 1e-3)
SHEAR = {"key": "contact.shear_strength", "from": 0, "to": 0.2, "points": 4}
CASE = {"model": "oscillator", "analysis": [{"name": "at", "kind": "spectrum", "sweep": SHEAR}]}
SWEPT = {**CASE, "analysis": [], "sweep": [{"name": "grid", "over": [SHEAR], "quantities": ["growth_rate"], "chunk": 2}]}
TEXT = """
title = "At {speed}"
model = "oscillator"
operation.velocity = {speed}
[[analysis]]
name = "at"
kind = "spectrum"
sweep = {{ key = "contact.shear_strength", from = 0, to = 0.2, points = 4 }}
"""


def at(speed):
    """The case at a speed."""
    return {**CASE, "operation": {"velocity": speed}}


def growth(data):
    """Growth rates of a spectrum."""
    return data.eigenvalues.real.max("mode")


def expected(speed, **more):
    """Growth rates of the case at a speed, without any run."""
    strengths = np.linspace(0, 0.2, 4)
    return [judder.oscillator.point(velocity=speed, shear_strength=strength, **more).growth_rate for strength in strengths]


LAW = judder.contact.Law.from_function(lambda v, y: (4 / 3 * y**1.5, np.pi * y, 0 * v), velocity=(1e-6, 1e2), indentation=(1e-6, 1e-1))
LOOPS = {
    "tables": (lambda speed: judder.run(at(speed), output=True), {}),
    "texts": (lambda speed: judder.run(TEXT.format(speed=speed), output=True), {}),
    "a changed key": (lambda speed: judder.run("case.toml", output=True, set={"operation.velocity": speed}), {}),
    "a law": (lambda speed: judder.run(at(speed), output=True, law=LAW), {"law": LAW}),
}


@pytest.mark.filterwarnings("ignore::judder.JudderWarning")
@pytest.mark.parametrize("way", LOOPS)
def test_a_loop_keeps_what_it_has_computed(way, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "case.toml").write_text(TEXT.format(speed=1))
    run, more = LOOPS[way]
    studies = {speed: run(speed) for speed in SPEEDS}
    for speed, study in studies.items():
        np.testing.assert_allclose(growth(study["at"]), expected(speed, **more), rtol=1e-9, atol=1e-12)
    assert len({study.folder for study in studies.values()}) == len(SPEEDS)
    for speed, study in studies.items():
        again = run(speed)
        assert again.folder == study.folder and again.summary["analyses"] == study.summary["analyses"]


def test_the_folder_of_a_case_is_named_by_its_content(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "case.toml").write_text(TEXT.format(speed=1e-4))
    folders = {
        name: judder.run(case, output=True, **options).folder.as_posix()
        for name, case, options in [
            ("file", "case.toml", {}),
            ("changed", "case.toml", {"set": {"operation.velocity": 1e-3}}),
            ("text", TEXT.format(speed=1e-4), {}),
            ("tables", at(1e-4), {}),
            ("set", CASE, {"set": {"operation.velocity": 1e-4}}),
            ("some", at(1e-4), {"only": ["at"], "threads": 1}),
        ]
    }
    assert folders["file"] == "out/case"
    for name, begin in [("changed", "out/case-"), ("text", "out/at-0-0001-"), ("tables", "out/oscillator-")]:
        found = judder.load_study(folders[name])
        assert folders[name] == begin + found.summary["case_hash"][:12]
    # the same case, however it is said
    assert folders["tables"] == folders["set"] == folders["some"]
    estimates = [judder.sweep.plan(case).estimate()["chunks_done"] for case in (SWEPT,) if judder.run(case, output=True)]
    assert estimates == [2]


def test_two_files_of_one_name_do_not_take_each_others_folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for place, speed in (("a", 1e-4), ("b", 1e-3)):
        (tmp_path / place).mkdir()
        (tmp_path / place / "case.toml").write_text(TEXT.format(speed=speed))
    first = judder.run("a/case.toml", output=True)
    with pytest.raises(judder.StudyError, match=r"out/case: holds the study of a/case\.toml, another case file of this name") as caught:
        judder.run("b/case.toml", output=True)
    assert (caught.value.cause, str(caught.value.owner)) == ("OtherCase", "a/case.toml")
    np.testing.assert_allclose(growth(first["at"]), expected(1e-4), rtol=1e-9)
    np.testing.assert_allclose(growth(judder.run("b/case.toml", output="other")["at"]), expected(1e-3), rtol=1e-9)


@pytest.fixture
def held(tmp_path):
    """A study, its opened dataset, and the study of another case that has taken its folder since."""
    study = judder.run(at(1e-4), output=tmp_path / "study")
    data = study["at"]
    return study, data, judder.run(at(1e-3), output=tmp_path / "study")


def assert_rewritten(call, study, name, found):
    """The typed error, with both hashes."""
    with pytest.raises(judder.RewrittenError, match=f"`{name}` is .*rewritten after this study was opened") as caught:
        call()
    error = pickle.loads(pickle.dumps(caught.value))
    assert isinstance(error, judder.StoreError) and error.cause == "Rewritten"
    assert (error.name, error.expected, error.found) == (name, study.hashes[name], found)
    assert study.hashes[name] in str(error) and (found is None or found in str(error))


def test_a_study_says_that_its_folder_was_rewritten(held, tmp_path):
    study, data, other = held
    found = other.hashes["at"]
    assert found != study.hashes["at"]
    ways = [
        lambda: study["at"],
        lambda: data.eigenvalues.values,
        lambda: data.load(),
        lambda: data.chunk().eigenvalues.compute(),
        lambda: pickle.loads(pickle.dumps(data)).eigenvalues.values,
        lambda: study.figures,
        lambda: study.tables,
        lambda: study.report,
        lambda: study.to_csv(tmp_path / "tables"),
    ]
    for way in ways:
        assert_rewritten(way, study, "at", found)
    assert not [*tmp_path.glob("tables/*")]
    # what it has told already is its own, and a notebook shows it with a word on the figures
    assert study.summary["case"]["operation"]["velocity"] != other.summary["case"]["operation"]["velocity"]
    assert "was rewritten" in study._repr_html_() and "<svg" not in study._repr_html_()
    np.testing.assert_allclose(growth(judder.load_study(study.folder)["at"]), expected(1e-3), rtol=1e-9)


def test_what_was_read_before_stays(tmp_path):
    study = judder.run(at(1e-4), output=tmp_path / "study")
    data = study["at"].load()
    judder.run(at(1e-3), output=tmp_path / "study")
    np.testing.assert_allclose(growth(data), expected(1e-4), rtol=1e-9)


def test_the_same_case_again_rewrites_nothing(tmp_path):
    study = judder.run(at(1e-4), output=tmp_path / "study")
    data = study["at"]
    more = {**at(1e-4), "analysis": [*CASE["analysis"], {"name": "more", "kind": "equivalent-damping", "sweep": SHEAR}]}
    judder.run(more, output=tmp_path / "study")
    judder.run(at(1e-4), output=tmp_path / "study", fresh=True)
    np.testing.assert_allclose(growth(data), expected(1e-4), rtol=1e-9)
    assert study.figures.keys() == {"at"} | study.figures.keys() and study.report.is_file()


@pytest.mark.parametrize("dask", [True, False])
def test_a_sweep_says_that_it_was_rewritten(dask, tmp_path):
    def swept(speed):
        return {**SWEPT, "operation": {"velocity": speed}}

    study = judder.run(swept(1e-4), output=tmp_path / "study")
    data = study["grid"] if dask else judder._swept.dataset(study.folder, "grid", study.hashes["grid"], dask=False)
    other = judder.run(swept(1e-3), output=tmp_path / "study", fresh=True)
    for way in (lambda: data.growth_rate.values, lambda: data.compute(), lambda: study["grid"], lambda: study.failed_points("grid"), lambda: study.to_csv(tmp_path)):
        assert_rewritten(way, study, "grid", other.hashes["grid"])


def test_arrays_that_are_gone_are_not_nan(tmp_path):
    study = judder.run(at(1e-4), output=tmp_path / "study")
    data, whole = study["at"], tmp_path / "study" / "results.zarr"
    shutil.move(whole / "at" / "eigenvalues" / "c", tmp_path / "c")
    with pytest.raises(judder.StoreError, match="this part of `at` is not there") as caught:
        data.eigenvalues.values  # noqa: B018
    assert caught.value.cause == "MissingChunk"
    shutil.rmtree(whole)
    assert_rewritten(lambda: data.eigenvalues.values, study, "at", None)


def test_a_summary_that_another_run_has_not_reached_shows_no_new_arrays(tmp_path):
    folder = judder.run(at(1e-4), output=tmp_path / "study").folder
    before = (folder / "summary.json").read_bytes()
    found = judder.run(at(1e-3), output=folder).hashes["at"]
    # as a run leaves it that is killed between arrays and summary: what was about to change is on no list
    (folder / "summary.json").write_bytes(before)
    (folder / "manifest.json").unlink()
    study = judder.load_study(folder)
    assert json.loads(before)["analyses"]["at"]["hash"] == study.hashes["at"]
    assert_rewritten(lambda: study["at"], study, "at", found)
