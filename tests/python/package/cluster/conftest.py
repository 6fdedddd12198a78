"""What the tests of sweeps in many processes share."""

import logging
import os
import pathlib

import distributed
import pytest
from serial_run import serial

QUICK = """
model = "oscillator"
[operation]
velocity = 1e-3
normal_load = 1e-4
[[sweep]]
name = "quick_map"
over = [
  { key = "operation.velocity", from = 1e-6, to = 1, points = 61, scale = "log" },
  { key = "contact.shear_strength", from = 1e-3, to = 0.2, points = 32 },
]
quantities = ["growth_rate", "verdict"]
chunk = 32
"""

# a point of these takes milliseconds
MAPS = """
model = "oscillator"
[operation]
velocity = 1e-3
normal_load = 1e-4
[[analysis]]
name = "map"
kind = "stability-map"
method = "every-point"
boundaries = false
x = { key = "operation.velocity", from = 1e-6, to = 1, points = 40, scale = "log" }
y = { key = "contact.shear_strength", from = 0, to = 0.2, points = 40 }
[[sweep]]
name = "maps"
method = "latin-hypercube"
points = 89
seed = 3
over = [
  { key = "oscillator.damping_x", from = 0.005, to = 0.02 },
  { key = "oscillator.damping_y", from = 0.004, to = 0.008 },
]
quantities = ["map.unstable_fraction", "growth_rate"]
chunk = 3
"""


def _reference(tmp_path_factory, text, sweep):
    folder = tmp_path_factory.mktemp(sweep)
    case = folder / "case.toml"
    case.write_text(text)
    return case, serial(case, folder / "serial", sweep)


@pytest.fixture(scope="session")
def quick(tmp_path_factory):
    """A case whose points take microseconds, and the files that a serial run leaves of its sweep."""
    return _reference(tmp_path_factory, QUICK, "quick_map")


@pytest.fixture(scope="session")
def maps(tmp_path_factory):
    """A case whose chunks take a noticeable while, and the files that a serial run leaves of its sweep."""
    return _reference(tmp_path_factory, MAPS, "maps")


@pytest.fixture
def cluster():
    """Starts clusters of this machine: ``cluster(workers, threads)``; gives a client."""
    made = []

    def start(workers=2, threads=1):
        local = distributed.LocalCluster(
            n_workers=workers, threads_per_worker=threads, processes=True, dashboard_address=None, silence_logs=logging.CRITICAL
        )
        made.append(local)
        client = distributed.Client(local)
        made.append(client)
        return client

    yield start
    for own in reversed(made):
        own.close()


@pytest.fixture
def poison(monkeypatch):
    """Points that end their process: ``poison(sweep, chunk, index)`` holds in every process that begins from now on."""

    def put(sweep, chunk, index):
        here = str(pathlib.Path(__file__).parent / "poisoned")
        monkeypatch.setenv("PYTHONPATH", os.pathsep.join(filter(None, [here, os.environ.get("PYTHONPATH")])))
        monkeypatch.setenv("JUDDER_TEST_POISON", f"{sweep} {chunk} {index}")

    return put
