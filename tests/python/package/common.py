"""What the tests of the installed package share."""

import pathlib

ROOT = pathlib.Path(__file__).resolve().parents[3]


def files(folder):
    """Every file below a folder with its bytes, by its relative path."""
    paths = (path for path in sorted(folder.rglob("*")) if path.is_file())
    return {str(path.relative_to(folder)): path.read_bytes() for path in paths}
