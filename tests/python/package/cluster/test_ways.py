"""The same case by every way there is: the whole store has the same bytes."""

import multiprocessing
from concurrent.futures import ProcessPoolExecutor

import numpy as np
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


LAWFUL = """
model = "oscillator"
[operation]
velocity = 1e-3
normal_load = 1e-4
[[analysis]]
name = "cycle"
kind = "limit-cycle"
[[sweep]]
name = "points"
over = [{ key = "contact.shear_strength", from = 0.01, to = 0.06, points = 6 }]
quantities = ["growth_rate"]
chunk = 2
[[sweep]]
name = "cycles"
method = "list"
over = [{ key = "contact.shear_strength", values = [0.05, 0.055] }]
quantities = ["growth_rate", "cycle.rms"]
chunk = 1
"""


def stiffer(velocity, indentation):
    """Hertz with three times the modulus, and a friction that falls with speed."""
    depth = np.sqrt(indentation)
    return 4.0 * indentation * depth, np.pi * indentation, 0.3 / (1.0 + 1e3 * velocity)


@pytest.mark.expensive
def test_a_law_of_ones_own_by_every_way(tmp_path):
    law = judder.contact.Law.from_function(stiffer, velocity=(1e-7, 1e1), indentation=(1e-8, 1e-1), tolerance=1e-4)
    law.save(tmp_path / "law.json")
    (tmp_path / "case.toml").write_text(LAWFUL + '[contact]\nlaw = { file = "law.json" }\n', encoding="utf-8")
    study = judder.run(tmp_path / "case.toml", output=tmp_path / "file")
    expected = files(study.folder / "results.zarr")
    growth = study["points"].growth_rate.values
    here = [judder.oscillator.point(velocity=1e-3, normal_load=1e-4, shear_strength=s, law=law).growth_rate for s in np.linspace(0.01, 0.06, 6)]
    np.testing.assert_allclose(growth, here, rtol=1e-12)
    np.testing.assert_allclose(study["cycles"].growth_rate.values, growth[[4]].tolist() + study["cycles"].growth_rate.values[1:].tolist())
    hertz = judder.run(LAWFUL, output=tmp_path / "paper")
    assert np.abs(growth / hertz["points"].growth_rate.values - 1).min() > 1e-3, "the law of the case is another one"

    judder.run(LAWFUL, output=tmp_path / "run", law=law)
    assert files(tmp_path / "run" / "results.zarr") == expected
    for sweep in (judder.sweep.plan(LAWFUL, name, law=law) for name in ("points", "cycles")):
        for chunk in range(sweep.chunks):
            sweep.write(tmp_path / "hand", chunk, sweep.compute(chunk))
    judder.run(LAWFUL, output=tmp_path / "hand", law=law)
    assert files(tmp_path / "hand" / "results.zarr") == expected
    spawn = multiprocessing.get_context("spawn")
    judder.distributed.run_with(
        LAWFUL, lambda: ProcessPoolExecutor(2, mp_context=spawn), output=tmp_path / "processes", law=law, workers_share_folder=False
    )
    assert files(tmp_path / "processes" / "results.zarr") == expected

    # a law that is refused changes nothing, nor does a name that the case does not have
    kept = (tmp_path / "run" / "law.json").read_bytes()
    other = judder.contact.Law.from_function(stiffer, velocity=(1e-7, 1e1), indentation=(1e-8, 1e-1), tolerance=1e-2)
    with pytest.raises(judder.StoreError) as refused:
        judder.run(LAWFUL, output=tmp_path / "run", law=other)
    assert refused.value.cause == "ForeignSweep" and (tmp_path / "run" / "law.json").read_bytes() == kept
    with pytest.raises(judder.StudyError):
        judder.run(LAWFUL, output=tmp_path / "none", law=law, only=["nope"])
    assert not (tmp_path / "none").exists()
    with pytest.raises(judder.InputError, match="threads"):
        judder.distributed.run_with(LAWFUL, lambda: ProcessPoolExecutor(1), output=tmp_path / "none", threads_per_worker=10**9)
