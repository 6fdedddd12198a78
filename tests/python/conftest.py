"""What several tests need."""

import os
import pathlib
import subprocess

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]


@pytest.fixture(scope="session")
def judder():
    """The program that JUDDER names; without it, one that is built here."""
    given = os.environ.get("JUDDER")
    if given:
        return given
    subprocess.run(["cargo", "build", "--quiet", "-p", "judder-cli"], cwd=ROOT, check=True)
    return ROOT / os.environ.get("CARGO_TARGET_DIR", "target") / "debug" / "judder"


@pytest.fixture(scope="session")
def exchange(judder):
    """The example of judder-exchange that stands beside the program; without it, one that is built here."""
    given = pathlib.Path(judder).parent / "examples" / "exchange"
    if not given.exists():
        subprocess.run(["cargo", "build", "--quiet", "-p", "judder-exchange", "--example", "exchange"], cwd=ROOT, check=True)
    return given
