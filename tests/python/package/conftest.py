"""What the tests of the installed package share."""

import pathlib
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[3]

MAP = """
model = "oscillator"
[[analysis]]
name = "map"
kind = "stability-map"
method = "every-point"
x = { key = "operation.velocity", from = 1e-6, to = 1, points = 24, scale = "log" }
y = { key = "contact.shear_strength", from = 0, to = 0.2, points = 20 }
[[analysis]]
name = "spectrum"
kind = "spectrum"
sweep = { key = "operation.velocity", from = 1e-6, to = 1, points = 12, scale = "log" }
"""


@pytest.fixture
def map_case():
    """A case of two quick analyses."""
    return MAP


@pytest.fixture(scope="session")
def command():
    """The command that the wheel carries: called with words, returns what it did."""

    def call(*words):
        return subprocess.run([sys.executable, "-m", "judder", *map(str, words)], capture_output=True, text=True)

    return call


def files(folder):
    """Every file below a folder with its bytes, by its relative path."""
    paths = (path for path in sorted(folder.rglob("*")) if path.is_file())
    return {str(path.relative_to(folder)): path.read_bytes() for path in paths}
