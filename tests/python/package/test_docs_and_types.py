"""Docs run, types hold: every public name has its words, every example its answer, every checker its peace."""

import doctest
import importlib.util
import inspect
import pathlib
import re
import subprocess
import sys

import pytest

import fresh
import judder
import reference
from common import ROOT
from names import public

HERE = pathlib.Path(__file__).parent


def test_every_public_name_has_words():
    for name, item in public():
        if inspect.isclass(item) or inspect.isroutine(item):
            assert inspect.getdoc(item), name
        if inspect.isclass(item) and item.__module__.startswith("judder"):
            own = {key: value for key, value in vars(item).items() if not key.startswith("_")}
            members = [key for key, value in own.items() if inspect.isroutine(value) or isinstance(value, property) or inspect.isdatadescriptor(value)]
            assert all(inspect.getdoc(getattr(item, key)) for key in members), name


def test_every_example_has_its_answer(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    seen, parser, runner = set(), doctest.DocTestParser(), doctest.DocTestRunner()
    for name, item in public():
        own = vars(item).items() if inspect.isclass(item) else ()
        for key, one in [(name, item), *((f"{name}.{key}", getattr(item, key)) for key, _ in own)]:
            text = inspect.getdoc(one) or ""
            if ">>>" in text and text not in seen and not isinstance(one, str):
                seen.add(text)
                runner.run(parser.get_doctest(text, {"judder": judder}, key, None, None))
    assert len(seen) >= 6 and runner.summarize(verbose=False).failed == 0


def test_the_reference_in_the_book_is_that_of_the_docstrings():
    assert reference.PAGE.read_text("utf-8") == reference.text(), f"`python {reference.__file__}` writes it anew"


def blocks(text, language):
    """The blocks of a page in a language."""
    return re.findall(rf"^```{language}\n(.*?)^```", text, flags=re.DOTALL | re.MULTILINE)


PAGES = [
    ("README.md", 1, "map.png"),
    ("docs/src/python.md", 10, "law.json"),
    pytest.param("docs/src/interchange.md", 4, "study.nc", marks=pytest.mark.expensive),
]


@pytest.mark.parametrize(("page", "least", "left"), PAGES)
def test_a_page_runs_as_typed_after_its_own_install_lines(page, least, left, tmp_path):
    text = (ROOT / page).read_text("utf-8")
    code = blocks(text, "python")
    for case in blocks(text, "toml"):
        (tmp_path / "case.toml").write_text(case, "utf-8")
    script = tmp_path / "page.py"
    script.write_text("\n".join(code), "utf-8")
    done = fresh.python(fresh.environment(tmp_path / "packages", fresh.extras(text)), script, tmp_path)
    assert done.returncode == 0, done.stderr
    assert len(code) >= least and (tmp_path / left).is_file()


def test_an_install_line_leaves_what_it_names_and_nothing_else(tmp_path):
    packages = fresh.environment(tmp_path / "packages", {"plot"})
    script = tmp_path / "script.py"
    script.write_text("import judder, matplotlib\nprint(judder.__file__)\njudder.tqdm_progress()\n")
    done = fresh.python(packages, script, tmp_path)
    assert done.stdout.startswith(str(packages)), done.stderr
    assert "PackageError: tqdm_progress needs the package tqdm" in done.stderr and "pip install 'judder[progress]'" in done.stderr


def test_the_commands_of_the_readme_run(command, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    text = (ROOT / "README.md").read_text("utf-8")
    (case,) = blocks(text, "toml")
    (tmp_path / "case.toml").write_text(case, "utf-8")
    lines = [line.partition("#")[0].split() for block in blocks(text, "sh") for line in block.splitlines()]
    calls = [words[1:] for words in lines if words[:1] == ["judder"]]
    assert {"check", "point", "run"} <= {words[0] for words in calls}
    # a page in a browser, which waits
    for words in (words for words in calls if words[0] != "explore"):
        done = command(*words)
        assert done.returncode == 0, done.stderr
    assert (tmp_path / "out" / "case" / "report.html").is_file()


def check(*words):
    done = subprocess.run([sys.executable, "-m", *words], capture_output=True, text=True, cwd=HERE)
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.expensive
@pytest.mark.skipif(not importlib.util.find_spec("mypy"), reason="mypy is not installed")
def test_mypy_is_content_with_the_package_its_stubs_and_a_script(tmp_path):
    cache = f"--cache-dir={tmp_path}"
    check("mypy", "--strict", cache, "-p", "judder", "-m", "sample_script")
    check("mypy.stubtest", "--ignore-disjoint-bases", "judder._judder", "judder.models")


@pytest.mark.skipif(not importlib.util.find_spec("pyright"), reason="pyright is not installed")
def test_pyright_is_content_with_the_package_and_a_script():
    check("pyright", "--verifytypes", "judder", "--ignoreexternal")
    check("pyright", "sample_script.py")
