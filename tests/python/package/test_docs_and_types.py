"""Docs run, types hold: every public name has its words, every example its answer, every checker its peace."""

import doctest
import importlib.util
import inspect
import pathlib
import re
import subprocess
import sys
import warnings

import pytest

import judder
from common import ROOT

MODULES = [
    judder,
    judder.contact,
    judder.distributed,
    judder.errors,
    judder.oscillator,
    judder.plot,
    judder.progress,
    judder.sliding,
    judder.study,
    judder.sweep,
]
HERE = pathlib.Path(__file__).parent


def public():
    """Every public name of the modules, with its object."""
    for module in MODULES:
        for name in module.__all__:
            yield f"{module.__name__}.{name}", getattr(module, name)


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


@pytest.mark.parametrize(("chapter", "least", "left"), [("python.md", 8, "law.json"), ("interchange.md", 4, "study.nc")])
def test_the_chapter_of_the_book_runs(chapter, least, left, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    text = (ROOT / "docs" / "src" / chapter).read_text("utf-8")
    blocks = re.findall(r"^```python\n(.*?)^```", text, flags=re.DOTALL | re.MULTILINE)
    names = {}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", judder.JudderWarning)
        for block in blocks:
            exec(compile(block, chapter, "exec"), names)  # noqa: S102
    assert len(blocks) >= least and (tmp_path / left).is_file()


def check(*words):
    done = subprocess.run([sys.executable, "-m", *words], capture_output=True, text=True, cwd=HERE)
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.skipif(not importlib.util.find_spec("mypy"), reason="mypy is not installed")
def test_mypy_is_content_with_the_package_its_stubs_and_a_script(tmp_path):
    cache = f"--cache-dir={tmp_path}"
    check("mypy", "--strict", cache, "-p", "judder", "-m", "sample_script")
    check("mypy.stubtest", "--ignore-disjoint-bases", "judder._judder")


@pytest.mark.skipif(not importlib.util.find_spec("pyright"), reason="pyright is not installed")
def test_pyright_is_content_with_the_package_and_a_script():
    check("pyright", "--verifytypes", "judder", "--ignoreexternal")
    check("pyright", "sample_script.py")
