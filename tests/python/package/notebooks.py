"""The notebooks of the book as they are stored: without outputs, with no metadata but the language.

usage: python tests/python/package/notebooks.py     stores those that differ anew, such as after work in Jupyter
"""

import pathlib

import nbformat

from common import ROOT

FOLDER = ROOT / "docs" / "notebooks"
METADATA = {
    "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
    "language_info": {"name": "python"},
}


def paths():
    """Every notebook, by name."""
    return sorted(FOLDER.glob("*.ipynb"))


def cleaned(text):
    """The text of a notebook as it is stored."""
    notebook = nbformat.reads(text, as_version=4)
    cells = []
    for number, cell in enumerate(notebook.cells, start=1):
        own = {"cell_type": cell.cell_type, "id": f"cell-{number:02}", "metadata": {}, "source": cell.source.strip("\n")}
        cells.append(own | ({"execution_count": None, "outputs": []} if cell.cell_type == "code" else {}))
    kept = nbformat.from_dict({"cells": cells, "metadata": METADATA, "nbformat": 4, "nbformat_minor": 5})
    nbformat.validate(kept)
    return nbformat.writes(kept) + "\n"


def differs(path: pathlib.Path):
    """Whether a notebook is stored otherwise."""
    text = path.read_text("utf-8")
    return text != cleaned(text)


if __name__ == "__main__":
    for notebook in filter(differs, paths()):
        notebook.write_text(cleaned(notebook.read_text("utf-8")), "utf-8")
        print(notebook.relative_to(ROOT))
