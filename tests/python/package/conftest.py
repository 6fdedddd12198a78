"""A quick case, and the command that the wheel carries."""

import signal
import subprocess
import sys

import pytest

# jobs in the background of a script ignore Ctrl-C, and so would the programs that tests interrupt
signal.signal(signal.SIGINT, signal.default_int_handler)

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
