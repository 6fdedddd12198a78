"""What the command does besides running cases, from Python: first results, examples, templates, reports, papers, the page."""

import json
import pathlib
import re
import runpy
import subprocess
import sys
import urllib.error
import urllib.request
from types import SimpleNamespace

import numpy as np
import pytest
import xarray

import fresh
import judder
from common import ROOT

SCRIPTS = sorted((ROOT / "cases" / "python").glob("*.py"))
MOST_LINES = 40


def test_examples_are_the_cases_of_the_project(tmp_path):
    found = judder.examples()
    assert {*found} == {str(path.relative_to(ROOT / "cases").with_suffix("")) for path in (ROOT / "cases").rglob("*") if path.suffix in (".toml", ".py")} - {
        "benchmarks/disc-brake",
        "sweeps/brake",
    }
    for name, own in found.items():
        path = ROOT / "cases" / name
        assert own.text == path.with_suffix(".toml" if own.kind == "case" else ".py").read_text("utf-8") and own.title
    own = found["own-rubber"]
    assert own.name == "tutorials/own-rubber" and own.files == {"rubber-dma.csv": (ROOT / "cases" / "tutorials" / "rubber-dma.csv").read_bytes()}
    written = own.write(tmp_path / "rubber")
    assert written.read_text("utf-8") == own.text and (tmp_path / "rubber" / "rubber-dma.csv").is_file()
    assert judder.check(written)["case"]["title"] == own.title
    written.write_text("mine")
    with pytest.raises(judder.StoreError, match="is there already, with another content"):
        own.write(tmp_path / "rubber")
    with pytest.raises(judder.InputError, match="is assembly/mode-coupling or benchmarks/minimal-mode-coupling meant"):
        found["coupling"]
    assert "assembly/mode-coupling" in repr(found) and "<table>" in found._repr_html_() and "text" not in repr(own)


def test_a_demo_is_a_case_in_memory(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    study = judder.demo("mode-coupling")
    assert study.complete and "in memory" in repr(study) and not [*tmp_path.iterdir()]
    onset = study.results["friction"]["onsets"][0]["value"]
    assert abs(onset - 0.75) < 1e-6
    with pytest.raises(judder.InputError, match="is a script of Python"):
        judder.demo("own-rubber-to-map")
    with pytest.raises(judder.InputError, match="there is no example `nope`"):
        judder.demo("nope")


def test_the_command_has_examples_and_demos(command, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    listed = command("examples")
    assert [line.split()[0] for line in listed.stdout.splitlines()] == [*judder.examples()]
    assert json.loads(command("examples", "--json").stdout)[0].keys() == {"name", "title"}
    assert command("examples", "first-map").stdout == judder.examples()["first-map"].text
    told = command("examples", "own-rubber")
    assert "it names rubber-dma.csv: `judder examples tutorials/own-rubber -o own-rubber` writes both" in told.stderr
    done = command("demo", "mode-coupling")
    assert done.returncode == 0 and (tmp_path / "out" / "mode-coupling" / "report.html").is_file()
    expected = [own["name"] for own in judder.check(tmp_path / "out" / "demo" / "mode-coupling.toml")["estimate"]]
    assert expected and all(re.search(rf"^{name}: (takes about [\d.]+ s on one core|\S+)", done.stderr, re.MULTILINE) for name in expected), done.stderr
    (tmp_path / "out" / "demo" / "mode-coupling.toml").write_text("mine")
    refused = command("demo", "mode-coupling")
    assert refused.returncode == 2 and "`judder run out/demo/mode-coupling.toml` runs it as it is" in refused.stderr
    for words in (("demo", "own-rubber-to-map"), ("examples", "coupling"), ("examples", "-o", "here")):
        refused = command(*words)
        assert refused.returncode == 2 and "help" in refused.stderr, refused.stderr


def test_templates_and_the_schema_are_those_of_the_command(command):
    assert judder.new() == command("new").stdout and judder.new("belt") == command("new", "belt").stdout
    assert judder.schema() == json.loads(command("schema").stdout)
    with pytest.raises(judder.CaseError, match="no template `bridge`") as caught:
        judder.new("bridge")
    assert "oscillator" in caught.value.help


def test_a_report_is_rebuilt(tmp_path, map_case):
    study = judder.run(map_case, output=tmp_path / "study")
    content = study.report.read_bytes()
    study.report.unlink()
    assert judder.report(study) == study.report and study.report.read_bytes() == content
    study.report.unlink()
    assert judder.report(tmp_path / "study").read_bytes() == content
    with pytest.raises(judder.StudyError, match="no folder"):
        judder.report(judder.run(map_case))
    with pytest.raises(judder.JudderError):
        judder.report(tmp_path / "none")


def test_the_page_is_served_beside_the_interpreter(tmp_path, map_case):
    study = judder.run(map_case, output=tmp_path / "study")
    for given in ({}, {"case": map_case, "set": {"operation.velocity": 1e-3}}, {"case": study}, {"case": map_case, "study": tmp_path / "study"}):
        with judder.explore(**given, browser=False) as page:
            assert page.is_open and page.address in page._repr_html_()
            with urllib.request.urlopen(page.address, timeout=10) as answer:
                assert answer.status == 200 and b"<html" in answer.read().lower()
            with pytest.raises(judder.InputError, match="cannot listen"):
                judder.explore(port=int(re.search(r":(\d+)", page.address)[1]), browser=False)
        assert not page.is_open and repr(page) == "Page(closed)"
        with pytest.raises(urllib.error.URLError):
            urllib.request.urlopen(page.address, timeout=10)
        page.close()
    with pytest.raises(judder.CaseError):
        judder.explore("model = 1\n", browser=False)
    with pytest.raises(judder.JudderError):
        judder.explore(study=tmp_path / "none", browser=False)


def test_wrong_papers_are_named():
    with pytest.raises(judder.InputError, match="there is no `my-paper`; known are oscillator-paper, beams-paper"):
        judder.reproduce("my-paper")


@pytest.mark.expensive
def test_a_demo_without_a_name_is_the_paper(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    found = judder.demo()
    assert found.complete and found.report == pathlib.Path("out/demo/oscillator-paper/report.html") and found.report.is_file()
    assert {own.verdict for own in found.scoreboard} <= {"agrees", "misprint", "open"} and len(found.scoreboard) > 20
    assert found.scoreboard[0].place in found._repr_html_()


@pytest.mark.parametrize("path", SCRIPTS, ids=lambda path: path.stem)
def test_a_first_hour_needs_nothing_but_the_wheel(path, tmp_path):
    text = judder.examples()[f"python/{path.stem}"].text
    assert text == path.read_text("utf-8") and len(text.splitlines()) <= MOST_LINES
    script, home = tmp_path / path.name, tmp_path / "here"
    script.write_text(text, "utf-8")
    home.mkdir()
    done = fresh.python(fresh.environment(tmp_path / "packages", set()), script, home)
    assert done.returncode == 0, done.stderr
    assert done.stdout.strip() and not [*home.iterdir()]


def test_a_demo_tells_the_logger_what_it_is_expected_to_take(caplog):
    with caplog.at_level("INFO", logger="judder"):
        judder.demo("minimal-mode-coupling")
    told = [record.getMessage() for record in caplog.records]
    assert [own.partition(":")[0] for own in told[:2]] == ["`spectrum`", "`critical`"] and all("takes about" in own for own in told[:2]), told


def test_the_map_of_the_first_hour_sings_where_it_is_unstable_alone(capsys, monkeypatch):
    verdicts = judder.oscillator.CLASSES
    codes = np.array([[verdicts.index(own) for own in row] for row in (("stable", "marginal"), ("unresolved", "stable"), ("flutter", "stable"))])
    about = {"flag_meanings": " ".join(verdicts)}
    sides = {"shear_strength": [1e3, 2e3, 3e3], "velocity": [1.0, 2.0]}
    data = xarray.Dataset({"stability": ((*sides,), codes, about)}, sides)
    monkeypatch.setattr(judder.models.Oscillator, "stability_map", lambda *_, **__: SimpleNamespace(data=data, numbers={"unstable_fraction": 1 / 6}))
    monkeypatch.setattr(judder.models.Contact, "modulus", lambda *_: SimpleNamespace(numbers={"terms": 1, "storage_deviation": 0.0}))
    runpy.run_path(str(ROOT / "cases" / "python" / "own-rubber-to-map.py"))
    assert "17 % of the map sings; below a shear strength of 3.0 kPa none of it" in capsys.readouterr().out


def test_the_wiper_of_the_first_hour_is_one(capsys):
    own = runpy.run_path(str(ROOT / "cases" / "python" / "wiper.py"))
    # the layer is thick beside the contact: Hertz's width, Johnson, Contact Mechanics (1985), (4.43), with E/(1 - 0.5²)
    assert own["width"] == pytest.approx(4 * np.sqrt(15.0 * 0.2e-3 / (np.pi * 4e6)), rel=0.02)
    # friction falls as steeply as the damping is strong: (μ_0 - μ_1) N/v_0 exp(-v/v_0) = c
    falls = (own["dry"] - own["wet"]) * own["width"] / 15.0
    onset = float(re.search(r"wipes from ([\d.]+) m/s", capsys.readouterr().out)[1])
    assert onset == pytest.approx(0.5 * np.log(falls * 9.0 / 0.5 / 0.6), rel=0.02)
    assert 0.1 < own["stuck"] < 0.6 and 50 < own["stutter"]["frequency_hz"] < 80


def test_importing_takes_neither_programs_nor_numpy():
    late = ("judder.programs", "judder.models", "tomllib", "webbrowser", "numpy", "xarray", "zarr")
    told = f"import judder, sys; print([name for name in {late} if name in sys.modules])"
    assert subprocess.run([sys.executable, "-c", told], capture_output=True, text=True).stdout.strip() == "[]"
