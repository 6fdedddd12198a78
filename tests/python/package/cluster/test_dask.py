"""Sweeps on a real cluster of Dask, in processes of their own: the bytes are those of the serial run, whatever happens on the way."""

import os
import signal
import subprocess
import sys
import threading
import time

import dask
import distributed
import pytest
from serial_run import files

import judder
from judder._cluster.executors import DaskExecutor
from judder._cluster.work import Job, work


def test_the_bytes_are_those_of_the_serial_run(quick, maps, cluster, tmp_path):
    client = cluster(2, 2)
    told = []
    study = judder.distributed.run(quick[0], client, output=tmp_path / "quick", progress=lambda *own: told.append(own))
    assert files(study.folder / "results.zarr" / "quick_map") == quick[1]
    assert study.complete and study["quick_map"].growth_rate.shape == (61, 32)
    assert told[0] == ("quick_map", 0, 61) and ("quick_map", 61, 61) in told and told[-1] == ("quick_map, summary", 61, 61)
    # the cluster shows the tasks of a sweep under one name, and that the case went to each worker once
    prefixes = client.run_on_scheduler(lambda dask_scheduler: {name: prefix.state_counts["memory"] for name, prefix in dask_scheduler.task_prefixes.items()})
    assert prefixes["judder_quick_map"] >= 2 and prefixes["judder-package"] == 1
    study = judder.distributed.run(maps[0], client, output=tmp_path / "maps", name="maps")
    assert files(study.folder / "results.zarr" / "maps") == maps[1]
    assert list(study.folder.rglob("mark-*")) == []


@pytest.mark.expensive
def test_no_more_tasks_are_handed_out_than_keep_all_threads_busy(quick, cluster, tmp_path, monkeypatch):
    client = cluster(2, 2)
    handed, known = [], []
    submit = DaskExecutor.submit

    def counted(self, job):
        submit(self, job)
        handed.append(len(self._jobs))

    def tasks(dask_scheduler):
        return sum(name.startswith("judder_quick_map") for name in map(str, dask_scheduler.tasks))

    monkeypatch.setattr(DaskExecutor, "submit", counted)
    progress = lambda *_: known.append(client.run_on_scheduler(tasks))  # noqa: E731
    judder.distributed.run(quick[0], client, output=tmp_path / "study", chunks_per_task=1, progress=progress)
    # two for each of four threads, of 61; those that are taken in go from the scheduler, too
    assert len(handed) == 61 and max(handed) == 8 and 4 <= max(known) < 30


# what all points share takes a second or more, a point next to nothing
SHARED = """
model = "oscillator"
[contact]
law = "bem"
[[sweep]]
name = "own_law"
over = [{ key = "operation.velocity", from = 1e-4, to = 1e-2, points = 64, scale = "log" }]
quantities = ["growth_rate"]
chunk = 2
"""


def timed_preparations():
    """From now on this process writes down how long each call takes that asks for what all points share."""
    from judder._cluster import package

    package.preparations = []
    own = package.Package.sweep

    class Timed:
        def __init__(self, sweep):
            self._sweep = sweep

        def __getattr__(self, name):
            return getattr(self._sweep, name)

        def prepare(self, **options):
            began = time.perf_counter()
            self._sweep.prepare(**options)
            package.preparations.append(time.perf_counter() - began)

    package.Package.sweep = lambda self, *named: Timed(own(self, *named))


def preparations():
    from judder._cluster import package

    return package.preparations


@pytest.mark.expensive
def test_what_all_points_share_is_made_once_in_each_worker(cluster, tmp_path):
    client = cluster(2, 1)
    client.run(timed_preparations)
    judder.distributed.run(SHARED, client, output=tmp_path / "study", chunks_per_task=2)
    told = [taken for taken in client.run(preparations).values() if taken]
    # sixteen tasks, of which one worker may have had the most
    assert sum(map(len, told)) == 16 and max(map(len, told)) >= 8
    for first, *others in told:
        assert first > 0.1 and sum(others) < first / 4


def test_workers_that_do_not_share_the_folder_send_their_chunks(quick, maps, cluster, tmp_path):
    client = cluster()
    for (case, expected), sweep in ((quick, "quick_map"), (maps, "maps")):
        before = client.run(lambda: os.getpid())
        study = judder.distributed.run(case, client, output=tmp_path / sweep, name=sweep, workers_share_folder=False)
        assert files(study.folder / "results.zarr" / sweep) == expected
        assert client.run(lambda: os.getpid()) == before


def test_a_worker_that_sees_no_mark_sends_its_chunks(quick, tmp_path):
    sweep = judder.sweep.plan(quick[0])._compiled
    package = judder._cluster.package.Package.of(sweep.package)

    def job(mark):
        return Job("quick_map", sweep.hash, (0, 5), str(tmp_path / "study"), mark, 1)

    done = work(package, job(str(tmp_path / "not-here")))
    assert [chunk for chunk, _ in done.contents] == [0, 5] and not (tmp_path / "study").exists()
    (tmp_path / "here").touch()
    assert work(package, job(str(tmp_path / "here"))).done == (0, 5)
    written = files(tmp_path / "study" / "results.zarr" / "quick_map" / "values")
    assert [written["c.0.0.0"], written["c.5.0.0"]] == [content for _, content in done.contents]


def test_a_worker_killed_in_the_middle_loses_nothing(maps, cluster, tmp_path):
    client = cluster()
    victims = list(client.run(os.getpid).values())
    killed = []

    def kill(name, done, total):
        if not killed and 3 <= done < total:
            os.kill(victims[0], signal.SIGKILL)
            killed.append(done)

    study = judder.distributed.run(maps[0], client, output=tmp_path / "study", name="maps", chunks_per_task=1, progress=kill)
    assert killed and study.results["maps"]["failed"] == 0
    assert files(study.folder / "results.zarr" / "maps") == maps[1]


@pytest.mark.expensive
def test_all_workers_killed_one_after_the_other_lose_nothing(maps, cluster, tmp_path):
    client = cluster()
    victims = list(client.run(os.getpid).values())
    killed = []

    def kill(name, done, total):
        if len(killed) < len(victims) and done >= 3 * (1 + len(killed)) and done < total:
            victim = victims[len(killed)]
            os.kill(victim, signal.SIGKILL)
            killed.append(victim)

    study = judder.distributed.run(
        maps[0], client, output=tmp_path / "study", name="maps", chunks_per_task=1, workers_share_folder=False, progress=kill
    )
    assert len(killed) == 2
    assert files(study.folder / "results.zarr" / "maps") == maps[1]


def restart_another(client):
    with distributed.Client(client.scheduler.address) as another:
        another.restart()


def cancel_all(client):
    client.cancel([distributed.Future(key, client) for key in [*client.futures]])


@pytest.mark.parametrize("way", [pytest.param(distributed.Client.restart, marks=pytest.mark.expensive), pytest.param(restart_another, marks=pytest.mark.expensive), cancel_all])
def test_cancelled_tasks_are_done_again_and_blame_no_point(maps, cluster, tmp_path, way):
    client = cluster()
    did = []

    def disturb(name, done, total):
        if len(did) < 2 and done >= 3 * (1 + 4 * len(did)) and done < total:
            did.append(done)
            way(client)

    study = judder.distributed.run(maps[0], client, output=tmp_path / "study", name="maps", chunks_per_task=1, retries=0, progress=disturb)
    assert len(did) == 2 and study.results["maps"]["failed"] == 0
    assert files(study.folder / "results.zarr" / "maps") == maps[1]


@pytest.mark.parametrize("shares", [True, pytest.param(False, marks=pytest.mark.expensive)])
def test_a_poisoned_point_is_recorded_and_the_study_goes_on(quick, poison, cluster, tmp_path, shares):
    poison("quick_map", 7, 11)
    with dask.config.set({"distributed.scheduler.allowed-failures": 0}):
        client = cluster()
    with pytest.warns(judder.JudderWarning, match="point 11 of chunk 7 ended its process 2 times: killed by signal 9"):
        study = judder.distributed.run(
            quick[0], client, output=tmp_path / "study", retries=1, chunks_per_task=4, workers_share_folder=shares
        )
    # no chunk but this one is touched by it
    own = files(study.folder / "results.zarr" / "quick_map")
    assert {name for name in own if own[name] != quick[1][name]} == {"values/c.7.0.0"}
    failed = study.failed_points("quick_map")
    assert failed["reason"].tolist() == ["it ended the process that computed it, every time"]
    data = study["quick_map"]
    reference = judder.load_study(quick[0].parent / "serial")["quick_map"]
    there = data.growth_rate.notnull()
    assert int((~there).sum()) == 1 and not bool(there[7, 11])
    assert bool((data.growth_rate == reference.growth_rate).where(there, True).all())
    assert failed["operation.velocity"][0] == data["velocity"][7]
    assert failed["contact.shear_strength"][0] == data["shear_strength"][11]
    assert not study.complete


@pytest.mark.expensive
def test_files_of_a_case_travel_with_it(cluster, tmp_path):
    law = judder.contact.Law.from_function(
        lambda v, d: (d**1.5 * (1 + v / (v + 1e-3)), d, 0.1 + 0 * d), velocity=(1e-7, 2.0), indentation=(1e-6, 1.0), tolerance=1e-3
    )
    (tmp_path / "laws").mkdir()
    law.save(tmp_path / "laws" / "own.json")
    (tmp_path / "cases").mkdir()
    case = tmp_path / "cases" / "case.toml"
    case.write_text(
        'model = "oscillator"\n[contact]\nlaw = { file = "../laws/own.json" }\n'
        '[[sweep]]\nname = "speeds"\nover = [{ key = "operation.velocity", from = 1e-5, to = 1e-2, points = 40, scale = "log" }]\n'
        'quantities = ["growth_rate"]\nchunk = 8\n'
    )
    here = judder.run(case, output=tmp_path / "here")
    client = cluster()
    # workers begin in another folder, so that no path leads them to the files by chance
    there = judder.distributed.run(case, client, output=tmp_path / "there", workers_share_folder=False)
    assert files(there.folder / "results.zarr") == files(here.folder / "results.zarr")


SCRIPT = """
import sys, logging, distributed, judder
if __name__ == "__main__":
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None, silence_logs=logging.CRITICAL) as cluster:
        with distributed.Client(cluster) as client:
            try:
                tell = lambda name, done, total: print(name, done, total, flush=True)
                judder.distributed.run(sys.argv[1], client, output=sys.argv[2], name="maps", chunks_per_task=1, progress=tell)
            except judder.Interrupted as error:
                print("ended", error, flush=True)
"""


def test_an_interrupted_study_goes_on_where_it_was(maps, cluster, tmp_path):
    script = tmp_path / "script.py"
    script.write_text(SCRIPT)
    words = [sys.executable, str(script), str(maps[0]), str(tmp_path / "study")]
    with subprocess.Popen(words, stdout=subprocess.PIPE, text=True, start_new_session=True) as run:
        for line in run.stdout:
            if int(line.split()[1]) >= 4:
                break
        run.send_signal(signal.SIGINT)
        rest = run.stdout.read()
        assert run.wait(60) == 0 and "ended interrupted; what was done is kept" in rest
    sweep = judder.sweep.plan(maps[0])
    missing = sweep.missing(tmp_path / "study")
    assert 0 < len(missing) <= sweep.chunks - 4
    told = []
    study = judder.distributed.run(
        maps[0], cluster(), output=tmp_path / "study", name="maps", progress=lambda *own: told.append(own)
    )
    assert told[0] == ("maps", 0, len(missing))
    assert files(study.folder / "results.zarr" / "maps") == maps[1]


@pytest.mark.expensive
def test_two_clients_share_a_folder(maps, cluster, tmp_path):
    clients = [cluster(1), cluster(1)]
    failed = []

    def run(client):
        try:
            judder.distributed.run(maps[0], client, output=tmp_path / "study", name="maps", chunks_per_task=1)
        except BaseException as error:
            failed.append(error)

    both = [threading.Thread(target=run, args=(client,)) for client in clients]
    for own in both:
        own.start()
    for own in both:
        own.join()
    assert failed == []
    assert files(tmp_path / "study" / "results.zarr" / "maps") == maps[1]


@pytest.mark.expensive
def test_a_client_waits_for_others_who_hold_the_study(quick, cluster, tmp_path):
    sweep = judder.sweep.plan(quick[0])
    sweep.run(tmp_path / "study")
    held = sweep._compiled.hold(str(tmp_path / "study"))
    ended = []
    run = threading.Thread(target=lambda: ended.append(judder.distributed.run(quick[0], cluster(1), output=tmp_path / "study")))
    run.start()
    # longer than a command waits
    run.join(12)
    assert run.is_alive()
    held.release()
    run.join(30)
    assert ended[0].complete and files(tmp_path / "study" / "results.zarr" / "quick_map") == quick[1]


SCHEDULER = """
import asyncio, distributed, sys
async def serve():
    async with distributed.Scheduler(port=0, dashboard_address=None) as scheduler:
        async with distributed.Worker(scheduler.address, nthreads=1, dashboard_address=None):
            print(scheduler.address, flush=True)
            await scheduler.finished()
asyncio.run(serve())
"""


@pytest.mark.expensive
def test_a_lost_scheduler_is_named_and_what_is_done_is_kept(maps, cluster, tmp_path):
    with subprocess.Popen([sys.executable, "-c", SCHEDULER], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as scheduler:
        with dask.config.set({"distributed.comm.timeouts.connect": "2s"}):
            client = distributed.Client(scheduler.stdout.readline().strip())
            kill = lambda name, done, total: done >= 3 and scheduler.kill()  # noqa: E731
            with pytest.raises(judder.StudyError, match="scheduler of Dask is gone") as gone:
                judder.distributed.run(maps[0], client, output=tmp_path / "study", name="maps", chunks_per_task=1, progress=kill)
            client.close()
    assert gone.value.cause == "NoScheduler"
    assert len(judder.sweep.plan(maps[0]).missing(tmp_path / "study")) <= 27
    judder.distributed.run(maps[0], cluster(), output=tmp_path / "study", name="maps")
    assert files(tmp_path / "study" / "results.zarr" / "maps") == maps[1]


def test_a_wrong_case_and_a_foreign_folder_are_refused_at_once(quick, cluster, tmp_path):
    client = cluster(1)
    with pytest.raises(judder.InputError, match="there is no sweep `other`"):
        judder.distributed.run(quick[0], client, output=tmp_path / "study", name="other")
    judder.distributed.run(quick[0], client, output=tmp_path / "study")
    with pytest.raises(judder.StoreError) as refused:
        judder.distributed.run(quick[0], client, output=tmp_path / "study", set={"operation.normal_load": 2e-4})
    assert refused.value.cause == "ForeignSweep"


LONG = """
model = "oscillator"
[[sweep]]
name = "long"
over = [
  { key = "operation.velocity", from = 1e-6, to = 1, points = 4000, scale = "log" },
  { key = "contact.shear_strength", from = 1e-3, to = 0.2, points = 4000 },
]
quantities = ["growth_rate"]
chunk = 8000000
"""


@pytest.mark.expensive
def test_workers_stop_where_nobody_wants_their_chunk_any_more(cluster, tmp_path):
    client = cluster(1)
    began = []

    def run():
        with pytest.raises(judder.Interrupted):
            judder.distributed.run(LONG, client, output=tmp_path / "study", progress=interrupt)

    def interrupt(name, done, total):
        # both chunks are handed out after this first word
        began.append(done)

    def busy():
        return sum(len(keys) for keys in client.processing().values())

    signal.signal(signal.SIGALRM, lambda *_: (_ for _ in ()).throw(KeyboardInterrupt()))
    try:
        signal.setitimer(signal.ITIMER_REAL, 3.0)
        run()
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, signal.SIG_DFL)
    # a chunk takes minutes; its thread is free again at once
    assert client.submit(lambda: 7, pure=False).result(timeout=10) == 7 and busy() == 0
    assert began == [0] and len(judder.sweep.plan(LONG).missing(tmp_path / "study")) == 2
