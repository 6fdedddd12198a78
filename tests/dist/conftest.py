"""The artifacts of `make dist`, in the folder that JUDDER_DIST names."""

import os
import pathlib

import pytest


@pytest.fixture(scope="session")
def dist():
    return pathlib.Path(os.environ["JUDDER_DIST"])


@pytest.fixture(scope="session")
def the(dist):
    """The only artifact of a name."""

    def only(pattern):
        found = sorted(dist.glob(pattern))
        assert len(found) == 1, f"{pattern}: {found}"
        return found[0]

    return only
