"""Sweeps through executors of `concurrent.futures` and of joblib."""

import multiprocessing
import os
import signal
import time
from concurrent.futures import BrokenExecutor, Future, ProcessPoolExecutor, ThreadPoolExecutor

import pytest
from joblib.externals import loky
from serial_run import files

import judder
from judder._cluster.dispatch import Dispatch
from judder._cluster.executors import Lost
from judder._cluster.package import Package
from judder._cluster.work import work


def spawned(workers=2):
    return ProcessPoolExecutor(workers, mp_context=multiprocessing.get_context("spawn"))


def test_processes_give_the_bytes_of_the_serial_run(quick, maps, tmp_path):
    with spawned() as executor:
        study = judder.distributed.run_with(quick[0], executor, output=tmp_path / "quick")
        assert files(study.folder / "results.zarr" / "quick_map") == quick[1]
        study = judder.distributed.run_with(maps[0], executor, output=tmp_path / "maps", name="maps", workers_share_folder=False)
        assert files(study.folder / "results.zarr" / "maps") == maps[1]


def test_threads_give_them_too(quick, tmp_path):
    with ThreadPoolExecutor(2) as executor:
        study = judder.distributed.run_with(quick[0], executor, output=tmp_path / "study", chunks_per_task=5)
    assert files(study.folder / "results.zarr" / "quick_map") == quick[1]


def test_joblib_gives_them_too(quick, tmp_path):
    study = judder.distributed.run_with(quick[0], lambda: loky.get_reusable_executor(max_workers=2), output=tmp_path / "study")
    assert files(study.folder / "results.zarr" / "quick_map") == quick[1]


def kill(pool):
    os.kill(next(iter(pool._processes)), signal.SIGKILL)


def test_a_lost_process_is_made_anew_where_it_can_be(maps, tmp_path):
    pools, killed = [], []

    def make():
        pools.append(spawned())
        return pools[-1]

    def once(name, done, total):
        if not killed and done >= 3:
            killed.append(done)
            kill(pools[0])

    study = judder.distributed.run_with(maps[0], make, output=tmp_path / "study", name="maps", chunks_per_task=1, progress=once)
    assert len(pools) == 2
    assert files(study.folder / "results.zarr" / "maps") == maps[1]


def test_a_pool_that_broke_unseen_is_made_anew(quick, tmp_path):
    """As a pool does of which a process ends while nothing is handed out."""
    pools = []

    class Breaking(ThreadPoolExecutor):
        left = 5

        def submit(self, *work):
            self.left -= 1
            if len(pools) == 1 and self.left < 0:
                raise BrokenExecutor("a process has ended")
            return super().submit(*work)

    def make():
        pools.append(Breaking(2))
        return pools[-1]

    study = judder.distributed.run_with(quick[0], make, output=tmp_path / "study", chunks_per_task=2)
    assert len(pools) == 2 and files(study.folder / "results.zarr" / "quick_map") == quick[1]


def test_processes_that_never_do_anything_are_to_blame_not_the_points(quick, tmp_path):
    stillborn = lambda: ProcessPoolExecutor(2, initializer=os._exit, initargs=(1,))  # noqa: E731
    with pytest.raises(judder.StudyError, match="none has done one") as lost:
        judder.distributed.run_with(quick[0], stillborn, output=tmp_path / "study", retries=0)
    assert lost.value.cause == "NoWorkers"
    assert len(judder.sweep.plan(quick[0]).missing(tmp_path / "study")) == 61


class Cancelling(ThreadPoolExecutor):
    """Threads that do so many jobs, and cancel all after those."""

    def __init__(self, jobs):
        super().__init__(1)
        self.jobs, self.cancelled = jobs, 0

    def submit(self, *job):
        if self.jobs:
            self.jobs -= 1
            return super().submit(*job)
        taken_back = Future()
        taken_back.cancel()
        taken_back.set_running_or_notify_cancel()
        self.cancelled += 1
        return taken_back


def test_a_run_whose_tasks_are_cancelled_for_ever_says_so(quick, tmp_path, monkeypatch):
    monkeypatch.setattr("judder._cluster.dispatch._PAUSE", 0.01)
    with Cancelling(5) as executor, pytest.raises(judder.StudyError, match="10 times in a row, and nothing was done between") as cancelled:
        judder.distributed.run_with(quick[0], executor, output=tmp_path / "study", chunks_per_task=1, retries=0)
    assert cancelled.value.cause == "Cancelled" and executor.cancelled >= 10
    assert len(judder.sweep.plan(quick[0]).missing(tmp_path / "study")) == 56
    # nothing is blamed for it
    with ThreadPoolExecutor(2) as executor:
        study = judder.distributed.run_with(quick[0], executor, output=tmp_path / "study")
    assert files(study.folder / "results.zarr" / "quick_map") == quick[1]


def test_a_pool_that_somebody_shut_down_is_made_anew_where_it_can_be(quick, tmp_path):
    pools = []

    def made():
        pools.append(ThreadPoolExecutor(1))
        return pools[-1]

    def shut(name, done, total):
        if len(pools) == 1 and done:
            pools[0].shutdown(cancel_futures=True)

    study = judder.distributed.run_with(quick[0], made, output=tmp_path / "study", chunks_per_task=1, retries=0, progress=shut)
    assert len(pools) == 2 and files(study.folder / "results.zarr" / "quick_map") == quick[1]
    with ThreadPoolExecutor(1) as own:
        own.shutdown()
        with pytest.raises(judder.StudyError, match="shut down"):
            judder.distributed.run_with(quick[0], own, output=tmp_path / "other")


def test_a_lost_process_ends_the_run_where_it_cannot_be_made_anew(maps, tmp_path):
    with spawned() as executor:
        killed = []

        def once(name, done, total):
            if not killed and done >= 3:
                killed.append(done)
                kill(executor)

        with pytest.raises(judder.StudyError, match="function that makes the executor") as lost:
            judder.distributed.run_with(maps[0], executor, output=tmp_path / "study", name="maps", chunks_per_task=1, progress=once)
    assert lost.value.cause == "ExecutorLost"
    # what is done is kept
    assert len(judder.sweep.plan(maps[0]).missing(tmp_path / "study")) <= 27


def test_a_poisoned_point_is_recorded_and_the_study_goes_on(quick, poison, tmp_path):
    poison("quick_map", 40, 0)
    with pytest.warns(judder.JudderWarning, match="point 0 of chunk 40 ended its process"):
        study = judder.distributed.run_with(quick[0], spawned, output=tmp_path / "study", retries=0, chunks_per_task=2)
    own = files(study.folder / "results.zarr" / "quick_map")
    assert {name for name in own if own[name] != quick[1][name]} == {"values/c.40.0.0"}
    assert len(study.failed_points("quick_map")) == 1


class Stumbling:
    """An executor whose jobs with a chunk end with an error of the file system, so often."""

    def __init__(self, package, chunk, failures):
        self.package, self.chunk, self.failures = package, chunk, failures
        self.jobs, self.tried = [], []

    def slots(self):
        return 1

    def submit(self, job):
        self.jobs.append(job)

    def wait(self):
        job = self.jobs.pop(0)
        if self.chunk in job.chunks:
            self.tried.append(time.monotonic())
            if len(self.tried) <= self.failures:
                return [(job, judder.StoreError("stale file handle", "FileSystem", {}))]
        return [(job, work(self.package, job))]

    def close(self):
        pass


@pytest.mark.parametrize("failures", [2, 3])
def test_a_file_system_that_fails_is_tried_again_a_while_later(quick, tmp_path, failures, monkeypatch):
    monkeypatch.setattr("judder._cluster.dispatch._PAUSE", 0.05)
    sweep = judder.sweep.plan(quick[0])._compiled
    stumbling = Stumbling(Package.of(sweep.package), 6, failures)
    held = sweep.hold(str(tmp_path / "study"))
    run = Dispatch(sweep, lambda: stumbling, tmp_path / "study", retries=2, shares=True, chunks_per_task=4, threads=1, progress=None).run
    if failures > 2:
        with pytest.raises(judder.StoreError, match="stale file handle"):
            run(held)
    else:
        run(held)
        assert len(sweep.missing(str(tmp_path / "study"))) == 0
    held.release()
    first, second, third = stumbling.tried
    assert second - first > 0.1 and third - second > 0.2


class Fatal:
    """An executor that is lost with every job that has one point, in whatever process it is computed: as a container whose memory runs out."""

    def __init__(self, package, chunk, index):
        self.package, self.chunk, self.index = package, chunk, index
        self.jobs, self.lost = [], []

    def slots(self):
        return 1

    def submit(self, job):
        self.jobs.append(job)

    def wait(self):
        job = self.jobs.pop()
        first, end = job.points or (0, 32)
        if self.chunk in job.chunks and first <= self.index < end:
            self.lost.append(job.points)
            return [(job, Lost(1))]
        return [(job, work(self.package, job))]

    def close(self):
        pass


def test_a_point_that_ends_whole_workers_is_found_by_halves(quick, tmp_path):
    sweep = judder.sweep.plan(quick[0])._compiled
    fatal = Fatal(Package.of(sweep.package), 3, 21)
    manner = {"retries": 1, "shares": True, "chunks_per_task": 8, "threads": 1, "progress": None}
    with pytest.warns(judder.JudderWarning, match="point 21 of chunk 3 ended its worker 2 times"):
        held = sweep.hold(str(tmp_path / "study"))
        Dispatch(sweep, lambda: fatal, tmp_path / "study", **manner).run(held)
        held.release()
    # twice with others or as a whole, twice in a process of its own, then 32, 16, 8, 4, 2 points, and the one point twice
    assert fatal.lost == [None] * 4 + [(0, 32), (16, 32), (16, 24), (20, 24), (20, 22), (21, 22), (21, 22)]
    study = judder.sweep.plan(quick[0]).merge(tmp_path / "study")
    own = files(study.folder / "results.zarr" / "quick_map")
    assert {name for name in own if own[name] != quick[1][name]} == {"values/c.3.0.0"}
    assert study.failed_points("quick_map")["contact.shear_strength"].tolist() == [float(study["quick_map"]["shear_strength"][21])]


def test_nobody_forgets_a_folder_while_it_is_worked_on(maps, tmp_path):
    refused = []

    def forget(name, done, total):
        if done < total and not refused:
            with pytest.raises(judder.StoreError) as locked:
                judder.run(maps[0], output=tmp_path / "study", fresh=True)
            refused.append(locked.value.cause)

    with spawned() as executor:
        judder.distributed.run_with(maps[0], executor, output=tmp_path / "study", name="maps", workers_share_folder=False, progress=forget)
    assert refused == ["Locked"]


TWO = """
model = "oscillator"
[[sweep]]
name = "one"
over = [{ key = "operation.velocity", from = 1e-5, to = 1e-2, points = 20 }]
quantities = ["growth_rate"]
chunk = 10
[[sweep]]
name = "other"
over = [{ key = "operation.velocity", from = 1e-5, to = 1e-2, points = 30 }]
quantities = ["growth_rate"]
chunk = 10
"""


def test_nobody_forgets_one_sweep_while_another_is_worked_on(tmp_path):
    refused = []

    def forget(name, done, total):
        if (name, done) == ("other", 0):
            with pytest.raises(judder.StoreError) as locked:
                judder.run(TWO, output=tmp_path / "study", fresh=True)
            refused.append(locked.value.cause)

    with ThreadPoolExecutor(2) as executor:
        study = judder.distributed.run_with(TWO, executor, output=tmp_path / "study", progress=forget)
    assert refused == ["Locked"] and study.complete


def test_large_packages_go_once_to_each_process(quick, tmp_path, monkeypatch):
    monkeypatch.setattr("judder._cluster.executors._SMALL", 0)
    with spawned() as executor:
        sent = []
        submit = executor.submit

        def counted(function, package, job):
            sent.append(isinstance(package, str))
            return submit(function, package, job)

        monkeypatch.setattr(executor, "submit", counted)
        study = judder.distributed.run_with(quick[0], executor, output=tmp_path / "study", chunks_per_task=2)
    assert files(study.folder / "results.zarr" / "quick_map") == quick[1]
    # those that were on their way to a process before it had the case: more of them where one of the processes is slow to start
    assert 1 <= sent.count(False) <= 15 and sent.count(True) >= 31


def test_a_class_makes_an_executor(quick, tmp_path):
    study = judder.distributed.run_with(quick[0], ThreadPoolExecutor, output=tmp_path / "study")
    assert files(study.folder / "results.zarr" / "quick_map") == quick[1]


WRONG = {
    "retries": (-1, "2", True),
    "chunks_per_task": (0, 2.5, "3"),
    "threads_per_worker": (0, 1.5, 10**9),
    "workers": (0, -1, "2"),
    "progress": (3,),
    "executor": (None, 3),
}


@pytest.mark.parametrize("argument", WRONG)
def test_arguments_are_checked_before_anything_is_made(quick, tmp_path, argument):
    for wrong in WRONG[argument]:
        given = {"executor": lambda: ThreadPoolExecutor(1), argument: wrong}
        with pytest.raises(judder.InputError, match=f"^{argument}: .* needed") as caught:
            judder.distributed.run_with(quick[0], output=tmp_path / "study", **given)
        assert caught.value.argument == argument
    assert list(tmp_path.iterdir()) == []


def test_what_is_no_executor_and_no_client_is_named(quick, tmp_path):
    with pytest.raises(judder.InputError, match="executor: .* made 3, which has no `submit`"):
        judder.distributed.run_with(quick[0], lambda: 3, output=tmp_path / "study")
    with pytest.raises(judder.InputError, match="client: a client of dask.distributed is needed, not None"):
        judder.distributed.run(quick[0], None, output=tmp_path / "other")
    assert not (tmp_path / "other").exists()
