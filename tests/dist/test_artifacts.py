"""What is released, installed and run where nothing else of judder is: a fresh environment, an empty root."""

import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import tarfile
import zipfile

import pytest

# the oldest C library that is promised
OLDEST_C_LIBRARY = (2, 17)
LARGEST_WHEEL = 12e6
CASE = """
title = "A map"
model = "oscillator"

[[analysis]]
name = "map"
kind = "stability-map"
x = { key = "operation.velocity", from = 1e-8, to = 1e2, points = 40, scale = "log" }
y = { key = "contact.shear_strength", from = 1e-4, to = 1.0, points = 40, scale = "log" }
"""


def run(*command, **options):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, **options)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_every_artifact_has_its_checksum(dist):
    noted = dict(reversed(line.split("  ", 1)) for line in (dist / "SHA256SUMS").read_text().splitlines())
    there = {path.relative_to(dist).as_posix(): path for path in dist.rglob("*") if path.is_file() and path.name != "SHA256SUMS"}
    assert noted == {name: hashlib.sha256(path.read_bytes()).hexdigest() for name, path in there.items()}


@pytest.mark.parametrize("pattern", ["judder-*-abi3-*.whl", "judder-*-cp314t-*.whl"])
def test_a_wheel_works_with_old_c_libraries(the, pattern):
    wheel = the(pattern)
    told = run(sys.executable, "-m", "auditwheel", "show", wheel)
    consistent = re.search(r'"manylinux_(\d+)_(\d+)_x86_64"', told)
    assert consistent and (int(consistent[1]), int(consistent[2])) <= OLDEST_C_LIBRARY, told
    assert wheel.stat().st_size <= LARGEST_WHEEL


def test_the_wheel_names_its_parts(the):
    wheel = zipfile.ZipFile(the("judder-*-abi3-*.whl"))
    (parts,) = [name for name in wheel.namelist() if "/sboms/" in name]
    components = {part["name"] for part in json.loads(wheel.read(parts))["components"]}
    assert {"pyo3", "faer", "judder-models"} <= components
    listed = json.loads(the("judder-*.cyclonedx.json").read_text("utf-8"))
    assert listed["bomFormat"] == "CycloneDX"


def test_the_wheel_alone_gives_a_first_result(the, tmp_path):
    run(sys.executable, "-m", "venv", tmp_path / "venv")
    clean = {"PATH": "/usr/bin:/bin", "HOME": str(tmp_path)}
    run(tmp_path / "venv/bin/python", "-m", "pip", "install", "--quiet", the("judder-*-abi3-*.whl"))
    (tmp_path / "case.toml").write_text(CASE)
    script = "import judder; print(judder.__build__, float(judder.run('case.toml')['map'].stability.size))"
    build, size = run(tmp_path / "venv/bin/python", "-c", script, cwd=tmp_path, env=clean).split()
    assert size == "1600.0"
    assert re.search(r"\+[0-9a-f]{12}$", build), build
    assert build in run(tmp_path / "venv/bin/judder", "--version", env=clean)


def test_the_description_reads_on_an_index_page(dist, the):
    run(sys.executable, "-m", "twine", "check", "--strict", *dist.glob("*.whl"), the("judder-*[0-9].tar.gz"))


def test_the_source_distribution_knows_its_commit(the):
    with tarfile.open(the("judder-*[0-9].tar.gz")) as archive:
        (commit,) = [member for member in archive if member.name.endswith("crates/judder-cli/commit.txt")]
        assert re.fullmatch(rb"[0-9a-f]{40}\n", archive.extractfile(commit).read())


@pytest.fixture(scope="module")
def unpacked(the, tmp_path_factory):
    folder = tmp_path_factory.mktemp("unpacked")
    with tarfile.open(the("judder-*-linux-gnu.tar.gz")) as archive:
        archive.extractall(folder, filter="data")
    (root,) = folder.iterdir()
    return root


def test_the_command_runs_in_an_empty_root(unpacked, tmp_path):
    """A root that holds the C library and the command, nothing else."""
    root = tmp_path / "root"
    (root / "tmp").mkdir(parents=True)
    for library in re.findall(r"(/\S+) \(0x", run("ldd", unpacked / "judder")):
        (root / library[1:]).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(library, root / library[1:])
    shutil.copy(unpacked / "judder", root / "judder")
    (root / "case.toml").write_text(CASE)
    enter = ["unshare", "--map-root-user", "--root", root]
    if subprocess.run([*enter, "/judder", "--version"], capture_output=True).returncode:
        pytest.skip("SKIPPED: this machine lets nobody change the root")
    run(*enter, "/judder", "run", "/case.toml", "-o", "/out", env={})
    assert (root / "out/report.html").stat().st_size > 1e5
    assert json.loads((root / "out/summary.json").read_text())["results"]["map"]["points"] > 0


def test_the_command_asks_for_nothing_but_the_c_library(unpacked):
    needed = set(re.findall(r"NEEDED.*\[(.+?)\]", run("readelf", "-d", unpacked / "judder")))
    assert needed <= {"libc.so.6", "libm.so.6", "libpthread.so.0", "libdl.so.2", "librt.so.1", "ld-linux-x86-64.so.2"}
    versions = re.findall(r"GLIBC_(\d+)\.(\d+)", run("readelf", "--version-info", "--wide", unpacked / "judder"))
    assert max((int(major), int(minor)) for major, minor in versions) <= OLDEST_C_LIBRARY


def test_manual_and_completions_are_read(unpacked):
    pages = sorted(path.name for path in (unpacked / "man/man1").iterdir())
    assert {"judder.1", "judder-run.1", "judder-explore.1"} <= set(pages)
    if shutil.which("man"):
        for page in pages:
            quiet = {**os.environ, "MANROFFSEQ": "", "MANWIDTH": "100", "LC_ALL": "C.UTF-8"}
            told = subprocess.run(["man", "--warnings", "-l", unpacked / "man/man1" / page], capture_output=True, text=True, env=quiet)
            assert told.returncode == 0 and told.stderr == "", page
    run("bash", "-n", unpacked / "completions/judder.bash")
    assert "#compdef judder" in (unpacked / "completions/_judder").read_text()
    assert "complete -c judder" in (unpacked / "completions/judder.fish").read_text()


def test_licences_have_their_texts(unpacked, the):
    text = the("judder-*-licences.txt").read_text("utf-8")
    assert text == (unpacked / "LICENCES-OF-PARTS.txt").read_text("utf-8")
    assert "- faer " in text and "Permission is hereby granted" in text


def test_there_is_a_crate_for_every_member(dist):
    metadata = json.loads(run("cargo", "metadata", "--no-deps", "--format-version", "1"))
    expected = {f"{package['name']}-{package['version']}.crate" for package in metadata["packages"]}
    assert {path.name for path in (dist / "crates").iterdir()} == expected
