"""The wheel, as it was installed into an environment without Rust, and the source distribution. JUDDER_WHEEL names the folder in which they lie,
JUDDER_SOURCES the list that the compiler has made of the files from which it has compiled the wheel."""

import os
import pathlib
import posixpath
import re
import shutil
import subprocess
import sys
import tarfile
import zipfile

import pytest

import judder
from common import ROOT

pytestmark = pytest.mark.skipif("JUDDER_WHEEL" not in os.environ, reason="JUDDER_WHEEL names no wheel")


def test_the_package_is_the_installed_one_and_needs_no_rust():
    assert pathlib.Path(judder.__file__).is_relative_to(sys.prefix)
    assert shutil.which("cargo") is None and shutil.which("rustc") is None


def test_the_command_is_installed():
    script = pathlib.Path(sys.executable).parent / "judder"
    assert subprocess.run([script, "--version"], capture_output=True, text=True).stdout.split()[:2] == ["judder", judder.__build__]


def test_one_wheel_serves_every_cpython_and_brings_types_and_licences():
    (wheel,) = pathlib.Path(os.environ["JUDDER_WHEEL"]).glob("judder-*.whl")
    assert "-cp311-abi3-" in wheel.name
    names = zipfile.ZipFile(wheel).namelist()
    for wanted in ("judder/py.typed", "judder/_judder.pyi", "LICENSE-MIT", "LICENSE-APACHE", "NOTICE"):
        assert any(name.endswith(wanted) for name in names), wanted


def compiled():
    """The files of the repository from which the wheel was compiled, those taken in by macros among them, by their paths in it."""
    rule = pathlib.Path(os.environ["JUDDER_SOURCES"]).read_text("utf-8").partition(": ")[2]
    paths = (re.sub(r"\\(.)", r"\1", path) for path in re.findall(r"(?:\\.|\S)+", rule))
    # every crate lies in `crates`; a file outside of it is named by the way from the file that takes it in
    own = (posixpath.normpath("crates/" + path.split("/crates/", 1)[1]) for path in paths if "/crates/judder-" in path)
    # the commit that a program names is asked of the repository, which a source distribution leaves behind
    for name in sorted(name for name in set(own) if not name.startswith(".git/")):
        below = (ROOT / name).rglob("*") if (ROOT / name).is_dir() else [ROOT / name]
        yield from (path.relative_to(ROOT).as_posix() for path in below if path.is_file() or not path.exists())


@pytest.mark.skipif("JUDDER_SOURCES" not in os.environ, reason="JUDDER_SOURCES names no list of the compiled files")
def test_the_source_distribution_has_all_that_is_compiled():
    (path,) = pathlib.Path(os.environ["JUDDER_WHEEL"]).glob("judder-*.tar.gz")
    with tarfile.open(path) as archive:
        there = {member.name.partition("/")[2]: archive.extractfile(member).read() for member in archive if member.isfile()}
    needed = {*compiled()}
    # of every way in which files are taken in: a crate's own, beside the crates, a folder that is embedded
    assert {"crates/judder-wheel/src/lib.rs", "crates/judder-python/src/lib.rs", "crates/judder-papers/cases/fig-9a.toml", "crates/judder-explorer/page/index.html"} <= needed
    needed |= {"LICENSE-MIT", "LICENSE-APACHE", "NOTICE", "README.md", "Cargo.lock"}
    needed |= {path.relative_to(ROOT).as_posix() for path in (ROOT / "python" / "judder").rglob("*.py*") if "__pycache__" not in path.parts}
    assert sorted(needed - there.keys()) == []
    assert [name for name in sorted(needed) if there[name] != (ROOT / name).read_bytes()] == []
