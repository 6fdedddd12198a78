"""The notebooks of the book: each runs from top to bottom, and what it claims it asserts."""

import re

import nbformat
import pytest
from nbclient import NotebookClient

import notebooks
from common import ROOT

CELL_SECONDS = 300
"""A cell that takes longer hangs: whole notebooks take less than a minute."""
LONGEST = {"code": 100, "markdown": 170}
"""Letters of a line that are read without scrolling, or in a difference of two versions."""


def files():
    """Every file beside the notebooks, for what a run must not leave."""
    return sorted(path.relative_to(notebooks.FOLDER) for path in notebooks.FOLDER.rglob("*"))


@pytest.fixture(scope="module")
def kernel_folders(tmp_path_factory):
    """Folders of its own for a kernel: neither the settings nor the history of whoever runs the tests."""
    with pytest.MonkeyPatch.context() as patch:
        for name in ("IPYTHONDIR", "JUPYTER_RUNTIME_DIR", "JUPYTER_CONFIG_DIR", "MPLCONFIGDIR"):
            patch.setenv(name, str(tmp_path_factory.mktemp(name.lower())))
        patch.delenv("MPLBACKEND", raising=False)
        yield


@pytest.mark.parametrize("path", notebooks.paths(), ids=lambda path: path.stem)
def test_a_notebook_is_stored_without_what_a_run_leaves(path):
    assert not notebooks.differs(path), f"{path.name}: `python {notebooks.__file__}` stores it without outputs and metadata"


@pytest.mark.parametrize("path", notebooks.paths(), ids=lambda path: path.stem)
def test_lines_of_a_notebook_are_short(path):
    for number, cell in enumerate(nbformat.read(path, as_version=4).cells, start=1):
        long = [line for line in cell.source.splitlines() if len(line) > LONGEST[cell.cell_type]]
        assert not long, f"{path.name}, cell {number}: {long}"


def runs():
    """Every notebook: that of the paper before each change, the others with what is expensive."""
    for path in notebooks.paths():
        yield pytest.param(path, id=path.stem, marks=() if path.stem == "from-a-papers-figure-to-your-own" else pytest.mark.expensive)


@pytest.mark.parametrize("path", [*runs()])
def test_a_notebook_runs_and_draws(path, kernel_folders):
    before = files()
    notebook = nbformat.read(path, as_version=4)
    NotebookClient(notebook, timeout=CELL_SECONDS, kernel_name="python3", resources={"metadata": {"path": str(path.parent)}}).execute()
    code = [cell for cell in notebook.cells if cell.cell_type == "code"]
    pictures = [output for cell in code for output in cell.outputs if "image/png" in output.get("data", {})]
    assert len(pictures) >= 4 and any("assert " in cell.source for cell in code)
    told = [output.metadata.get("image/png", {}).get("alt", "") for output in pictures]
    assert all(len(words.split()) >= 10 for words in told) and len({*told}) == len(told)
    assert files() == before


def test_the_book_and_the_notebooks_name_each_other():
    page = (ROOT / "docs" / "src" / "notebooks.md").read_text("utf-8")
    assert sorted(set(re.findall(r"[\w-]+\.ipynb", page))) == [path.name for path in notebooks.paths()]
    for path in notebooks.paths():
        cells = nbformat.read(path, as_version=4).cells
        for link in re.findall(r"\]\((\.\./[^)#]+)", "\n".join(cell.source for cell in cells if cell.cell_type == "markdown")):
            assert (path.parent / link).is_file(), f"{path.name}: {link}"
