"""The wheel, as it was installed into an environment without Rust. JUDDER_WHEEL names the folder in which it lies."""

import os
import pathlib
import shutil
import subprocess
import sys
import zipfile

import pytest

import judder

pytestmark = pytest.mark.skipif("JUDDER_WHEEL" not in os.environ, reason="JUDDER_WHEEL names no wheel")


def test_the_package_is_the_installed_one_and_needs_no_rust():
    assert pathlib.Path(judder.__file__).is_relative_to(sys.prefix)
    assert shutil.which("cargo") is None and shutil.which("rustc") is None


def test_the_command_is_installed():
    script = pathlib.Path(sys.executable).parent / "judder"
    assert subprocess.run([script, "--version"], capture_output=True, text=True).stdout.split() == ["judder", judder.__version__]


def test_one_wheel_serves_every_cpython_and_brings_types_and_licences():
    (wheel,) = pathlib.Path(os.environ["JUDDER_WHEEL"]).glob("judder-*.whl")
    assert "-cp311-abi3-" in wheel.name
    names = zipfile.ZipFile(wheel).namelist()
    for wanted in ("judder/py.typed", "judder/_judder.pyi", "LICENSE-MIT", "LICENSE-APACHE", "NOTICE"):
        assert any(name.endswith(wanted) for name in names), wanted
