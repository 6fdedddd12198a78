"""The same case by every way there is: the whole store has the same bytes."""

import multiprocessing
from concurrent.futures import ProcessPoolExecutor

import pytest
from joblib.externals.loky import get_reusable_executor
from serial_run import files

import judder
from common import ROOT

CASE = ROOT / "cases" / "sweeps" / "friction.toml"
# two beams, meshed and reduced; fewer points than the case has
FEWER = """
over = [
  { key = "contact.friction_coefficient", from = 0.0, to = 0.5, points = 4 },
  { key = "structure.oblique.beam.angle", values = ["-35 deg", "-30 deg"] },
]
quantities = ["locus.unstable.count", "locus.unstable.max_growth_rate.max"]
chunk = 1
"""
QUICK = {"analysis.locus.count": 4, "analysis.locus.positions.points": 5}


def written(words):
    return [word for key, value in words.items() for word in ("--set", f"{key}={value}")]


@pytest.fixture(scope="module")
def case(tmp_path_factory):
    """The case, and the store that one thread of the command leaves: of two analyses' worth of groups, with the metadata of all."""
    folder = tmp_path_factory.mktemp("ways")
    text = CASE.read_text(encoding="utf-8")
    text = text[: text.index("over = [")] + FEWER.lstrip()
    (folder / "case.toml").write_text(text, encoding="utf-8")
    return folder / "case.toml"


@pytest.fixture(scope="module")
def expected(case, command):
    said = command("run", case, "-o", case.parent / "serial", "--threads", 1, "-q", *written(QUICK))
    assert said.returncode == 0, said.stderr
    return files(case.parent / "serial" / "results.zarr")


def by_threads(case, folder, command, cluster):
    said = command("run", case, "-o", folder, "--threads", 2, "-q", *written(QUICK))
    assert said.returncode == 0, said.stderr


def by_shards(case, folder, command, cluster):
    words = [case, "-o", folder, "-q", *written(QUICK)]
    parts = [command("run", *words, "--shard", part).returncode for part in ("2/3", "3/3", "1/3")]
    assert parts == [0, 0, 0]
    assert command("merge", *words).returncode == 0
    # the analyses are none of the parts' business
    assert command("run", *words).returncode == 0


def by_python(case, folder, command, cluster):
    judder.run(case, output=folder, set=QUICK)


def by_hand(case, folder, command, cluster):
    sweep = judder.sweep.plan(case, set=QUICK)
    for chunk in sweep.missing(folder):
        sweep.write(folder, chunk, sweep.compute(chunk))
    judder.run(case, output=folder, set=QUICK)


def by_processes(case, folder, command, cluster):
    spawn = multiprocessing.get_context("spawn")
    judder.distributed.run_with(case, lambda: ProcessPoolExecutor(2, mp_context=spawn), output=folder, set=QUICK)


def by_joblib(case, folder, command, cluster):
    judder.distributed.run_with(case, lambda: get_reusable_executor(2), output=folder, set=QUICK, workers_share_folder=False)


def by_dask(case, folder, command, cluster):
    judder.distributed.run(case, cluster(2, 1), output=folder, set=QUICK)


WAYS = [by_threads, by_shards, by_python, by_hand, by_processes, by_joblib, by_dask]


@pytest.mark.parametrize("way", WAYS, ids=lambda way: way.__name__)
def test_the_same_bytes_by_every_way(case, expected, command, cluster, tmp_path, way):
    assert {"friction/zarr.json", "locus/zarr.json", "zarr.json"} <= set(expected) and len(expected) > 20
    way(case, tmp_path / "study", command, cluster)
    assert files(tmp_path / "study" / "results.zarr") == expected
